// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_POLYGON_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_POLYGON_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

/*
The convex hull of points, as a polygon, and the pieces of curves that are not in it: those beyond each of its edges.
*/
class Hull_polygon_2
{
  std::vector<Exact_pair> m_vertices;               // counterclockwise, strictly convex; also a segment, or a point
  std::vector<Interval_pair> m_boxes;               // of its vertices
  std::vector<std::vector<std::size_t>> m_beyond;   // the pieces on the right of the edge from each vertex

public:
  Hull_polygon_2() = default;

  explicit Hull_polygon_2(const std::vector<Exact_kernel::Point_2>& points)
  {
    std::vector<Exact_kernel::Point_2> hull;
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    for (const Exact_kernel::Point_2& p : hull) {
      m_vertices.push_back({p.x(), p.y()});
      m_boxes.push_back(enclosed(m_vertices.back()));
    }
  }

  const std::vector<Exact_pair>& vertices() const { return m_vertices; }
  std::size_t size() const { return m_vertices.size(); }

  // Indices go around.
  const Exact_pair& vertex(std::size_t i) const { return m_vertices[i % m_vertices.size()]; }
  const Exact_pair& vertex_before(std::size_t i) const { return vertex(i + m_vertices.size() - 1); }

  // The pieces that are not in the polygon, by which those beyond its edges are named from then on.
  // \throws Run_stopped
  std::vector<Hull_piece_2> pieces_outside(std::vector<Hull_piece_2> pieces, Run_of_steps& run)
  {
    std::vector<Hull_piece_2> result;
    m_beyond.assign(m_vertices.size(), {});
    for (Hull_piece_2& piece : pieces) {
      run.check();
      bool is_inside = true;
      for (std::size_t edge = 0; edge < m_vertices.size(); ++edge)
        if (is_beyond(edge, piece)) {
          m_beyond[edge].push_back(result.size());
          is_inside = false;
        }
      if (!is_inside)
        result.push_back(std::move(piece));
    }
    return result;
  }

  // The pieces beyond an edge.
  const std::vector<std::size_t>& beyond(std::size_t edge) const { return m_beyond[edge % m_vertices.size()]; }

  // The pieces beyond the two edges of a vertex: no others are above it in a direction in which it is the highest one
  // of the polygon.
  std::vector<std::size_t> pieces_beside(std::size_t i) const
  {
    std::vector<std::size_t> result = beyond(i);
    const std::vector<std::size_t>& before = beyond(i + m_vertices.size() - 1);
    result.insert(result.end(), before.begin(), before.end());
    return result;
  }

  // Whether a piece is beyond none but the edges from the first one on and before the last one.
  bool is_beyond_only(std::size_t piece, std::size_t first_edge, std::size_t last_edge) const
  {
    for (std::size_t edge = last_edge; edge < first_edge + m_vertices.size(); ++edge)
      if (const auto& pieces = beyond(edge); std::find(pieces.begin(), pieces.end(), piece) != pieces.end())
        return false;
    return true;
  }

private:
  // Whether a piece has control points on the right of an edge of the polygon; intervals decide that nearly always.
  bool is_beyond(std::size_t edge, const Hull_piece_2& piece) const
  {
    const Interval_pair &p = m_boxes[edge], &q = m_boxes[(edge + 1) % m_boxes.size()];
    for (std::size_t i = 0; i < piece.points().size(); ++i) {
      const Interval turn = (q[0] - p[0]) * (piece.boxes()[i][1] - p[1]) - (q[1] - p[1]) * (piece.boxes()[i][0] - p[0]);
      if (turn.sup() < 0 || (turn.inf() <= 0 && is_beyond(edge, piece.points()[i])))
        return true;
    }
    return false;
  }

  // Whether a point is on the right of an edge; or next to it on the same line, where the polygon is a segment or a
  // point.
  bool is_beyond(std::size_t edge, const Exact_pair& point) const
  {
    const Exact_pair side = exact_difference(vertex(edge + 1), vertex(edge)),
                     arm = exact_difference(point, vertex(edge));
    const int turn = sign_of(exact_cross(side, arm));
    if (turn != 0 || m_vertices.size() > 2)
      return turn < 0;
    const Exact_rational along = exact_dot(side, arm);
    return m_vertices.size() == 1 ? point != vertex(0) : along < 0 || along > exact_dot(side, side);
  }
};

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_POLYGON_2_H
