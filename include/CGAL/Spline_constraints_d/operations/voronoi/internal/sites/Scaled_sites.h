// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SCALED_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SCALED_SITES_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Sites whose distances are divided by a number greater than 1, of which the square is given: a disk that touches one
// does so when scaled by that number about its center.
template <Enclosing_number Interval = Common::Interval>
struct Scaled_sites
{
  Exact_rational squared_factor;
  std::vector<bool> arcs, vertices;   // which are
  Interval excess;                    // squared_factor - 1

  Scaled_sites(const Exact_rational& square, std::vector<bool> is_arc_scaled, std::vector<bool> is_vertex_scaled)
    : squared_factor(square), arcs(std::move(is_arc_scaled)), vertices(std::move(is_vertex_scaled)),
      excess(interval_of<Interval>(Exact_rational(square - 1)))
  {}

  // The vertices that are not on scaled arcs.
  std::vector<bool> points(const Site_graph_2<Interval>& graph) const
  {
    std::vector<bool> result(vertices);
    for (std::size_t i = 0; i < result.size(); ++i)
      for (const Arc_end& end : graph.vertices()[i].ends)
        result[i] = result[i] && !arcs[end.arc];
    return result;
  }

  // How an arc goes on smoothly in an exact vertex, whatever others are between on which the factor is another one: if
  // there is no choice.
  std::optional<Arc_end> continuation(const Site_graph_2<Interval>& graph, const Arc_end& end) const
  {
    std::vector<Arc_end> before, after;
    for (const Arc_end& other : graph.vertices()[graph.vertex_of(end)].ends)
      if (const Exact_pair& p = graph.direction(end), &q = graph.direction(other);
          arcs[other.arc] == arcs[end.arc] && sign_of(exact_cross(p, q)) == 0)
        (sign_of(exact_dot(p, q)) > 0 ? before : after).push_back(other);
    return before.size() == 1 && after.size() == 1 ? std::optional(after[0]) : std::nullopt;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SCALED_SITES_H
