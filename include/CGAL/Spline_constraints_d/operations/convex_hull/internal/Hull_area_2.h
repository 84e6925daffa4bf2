// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_AREA_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_AREA_2_H

#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/convex_hull_2.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

// The area of a convex hull of which all edges are decided.
class Hull_area_2
{
  const Hull_of_curves_2& m_hull;

public:
  explicit Hull_area_2(const Hull_of_curves_2& hull) : m_hull(hull) {}

  // Bounds; ranges of parameters aside, they differ by twice the error at most.
  std::pair<Exact_rational, Exact_rational> operator()(double error) const
  {
    std::vector<Boundary_piece> arcs;
    Exact_rational twice_polygon(0), twice_rest(0);
    for (std::size_t i = 0; i < m_hull.edges.size(); ++i)
      if (m_hull.edges[i].kind == Hull_edge_kind::ARC)
        for (const Hull_piece_2& piece :
             m_hull.parts.between(m_hull.edges[i].source.curve, certain_end(i, 0), certain_end(i, 1)))
          arcs.push_back(piece.curve());
      else {
        const auto [begin, end] = certain_segment(i);
        twice_polygon += exact_cross(begin, end);
        twice_rest += twice_area_beside_segment(i);
      }
    const Rational_interval below_arcs = arcs.empty()
        ? Rational_interval(Exact_rational(0))
        : Boundary_loop_2(arcs).signed_area(to_rational(error) / 2);
    return {Exact_rational(below_arcs.lower + twice_polygon / 2),
            Exact_rational(below_arcs.upper + (twice_polygon + twice_rest) / 2)};
  }

private:
  // The parameter of the begin or end of an arc such that all before it, or after it, is on the boundary.
  const Exact_rational& certain_end(std::size_t i, int end) const
  {
    const Hull_edge_2& edge = m_hull.edges[i];
    const auto& [lower, upper] = (end == 0 ? edge.source : edge.target).parameters;
    return edge.is_reversed() == (end == 0) ? lower : upper;
  }

  std::size_t before(std::size_t i) const { return (i + m_hull.edges.size() - 1) % m_hull.edges.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % m_hull.edges.size(); }

  // Where the arcs next to a segment certainly belong to the boundary; points that are known exactly where there are no
  // arcs.
  std::array<Exact_pair, 2> certain_segment(std::size_t i) const
  {
    const auto end = [&](const Boundary_vertex_2& vertex, std::size_t neighbour, int side) {
      return m_hull.edges[neighbour].kind == Hull_edge_kind::ARC
          ? m_hull.point(m_hull.edges[neighbour].source.curve, certain_end(neighbour, side))
          : m_hull.point(vertex.curve, vertex.parameter());
    };
    return {end(m_hull.edges[i].source, before(i), 1), end(m_hull.edges[i].target, after(i), 0)};
  }

  // A bound for what is between that segment and the boundary: the hull of its ends and the parts of the arcs where
  // these may end.
  Exact_rational twice_area_beside_segment(std::size_t i) const
  {
    using Exact_point = Exact_kernel::Point_2;
    std::vector<Exact_point> points, hull;
    for (const Exact_pair& p : certain_segment(i))
      points.emplace_back(p[0], p[1]);
    for (const Boundary_vertex_2& vertex : {m_hull.edges[i].source, m_hull.edges[i].target})
      if (vertex.parameters.first < vertex.parameters.second)
        for (const Hull_piece_2& piece :
             m_hull.parts.between(vertex.curve, vertex.parameters.first, vertex.parameters.second))
          for (const Exact_pair& p : piece.points())
            points.emplace_back(p[0], p[1]);
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    Exact_rational result(0);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Exact_point &p = hull[k], &q = hull[(k + 1) % hull.size()];
      result += p.x() * q.y() - q.x() * p.y();
    }
    return result;
  }
};

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_AREA_2_H
