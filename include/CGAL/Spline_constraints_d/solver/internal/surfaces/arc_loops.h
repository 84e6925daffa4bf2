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
#include <iterator>
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

// The only vertex where other than two of the arcs end.
inline std::optional<std::size_t> branching_vertex(const Arc_store& store, const Arc_indices& arcs)
{
  std::map<std::size_t, std::size_t> count;
  for (const std::size_t a : arcs)
    for (const std::size_t end : store.arcs()[a].ends)
      ++count[end];
  const auto is_branching = [](const auto& own) { return own.second != 2; };
  const auto found = std::find_if(count.begin(), count.end(), is_branching);
  return found != count.end() && std::none_of(std::next(found), count.end(), is_branching) ? std::optional(found->first)
                                                                                           : std::nullopt;
}

/*
The loops that bound disks which the solutions in a box are, a graph over two unknowns: one loop; or several that have
one common vertex, so that no plane comes between them, and each an arc where one of the two unknowns is at an end of
its range. In their plane the box is a rectangle, and these arcs lie on its sides. What a loop is around lies inside of
the rectangle, so that no other loop lies there. Other loops come apart when boxes are split.
*/
inline std::optional<std::vector<Arc_loop>> loops_around_disks(const Arc_store& store, const Arc_indices& arcs,
                                                               const std::array<int, 2>& parameters)
{
  std::optional<std::vector<Arc_loop>> loops = loops_of_arcs(store, arcs);
  if (loops)
    return loops->size() == 1 ? loops : std::nullopt;
  const std::optional<std::size_t> common = branching_vertex(store, arcs);
  if (common)
    loops = loops_of_arcs(store, arcs, common);
  const auto is_around_disk = [&](const Arc_loop& loop) {
    const std::array<std::size_t, 2>& ends = store.arcs()[loop.front().arc].ends;
    return (ends[0] == common || ends[1] == common) &&
        std::any_of(loop.begin(), loop.end(), [&](const Surface_patch::Side& side) {
             const int plane = store.arcs()[side.arc].plane;
             return plane == parameters[0] || plane == parameters[1];
           });
  };
  return loops && std::all_of(loops->begin(), loops->end(), is_around_disk) ? loops : std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_ARC_LOOPS_H
