// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_LOOPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_LOOPS_H

#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Arc_store.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Arc_loop = std::vector<Surface_patch::Side>;

// The loops that the arcs are; none if an end does not belong to two of them. Any number may end in an apex, in which
// loops end.
inline std::optional<std::vector<Arc_loop>> loops_of_arcs(const Arc_store& store, Arc_indices arcs,
                                                          std::optional<std::size_t> apex = std::nullopt)
{
  std::map<std::size_t, std::vector<std::size_t>> arcs_at;
  for (const std::size_t a : arcs)
    for (const std::size_t end : store.arcs()[a].ends)
      arcs_at[end].push_back(a);
  for (const auto& [vertex, own] : arcs_at)
    if (vertex != apex && (own.size() != 2 || own[0] == own[1]))
      return std::nullopt;
  if (apex)
    std::stable_partition(arcs.begin(), arcs.end(), [&](std::size_t a) {
      const std::array<std::size_t, 2>& ends = store.arcs()[a].ends;
      return ends[0] == apex || ends[1] == apex;
    });
  std::vector<Arc_loop> result;
  std::set<std::size_t> done;
  for (const std::size_t first : arcs) {
    if (done.count(first) > 0)
      continue;
    Arc_loop& loop = result.emplace_back();
    const std::array<std::size_t, 2>& both_ends = store.arcs()[first].ends;
    std::size_t arc = first, vertex = both_ends[both_ends[1] == apex ? 1 : 0];
    do {
      const std::array<std::size_t, 2>& ends = store.arcs()[arc].ends;
      const bool is_reversed = ends[0] != vertex;
      loop.push_back({arc, is_reversed});
      done.insert(arc);
      vertex = ends[is_reversed ? 0 : 1];
      const std::vector<std::size_t>& both = arcs_at[vertex];
      arc = both[0] == arc ? both[1] : both[0];
    } while (arc != first && vertex != apex);
  }
  return result;
}

// The loop that the arcs are, if it is just one.
inline std::optional<Arc_loop> single_loop(const Arc_store& store, const Arc_indices& arcs)
{
  std::optional<std::vector<Arc_loop>> loops = loops_of_arcs(store, arcs);
  return loops && loops->size() == 1 ? std::optional(std::move(loops->front())) : std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_LOOPS_H
