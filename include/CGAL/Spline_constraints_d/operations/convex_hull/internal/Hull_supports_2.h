// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_SUPPORTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_SUPPORTS_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

/*
Supported vertices of polygons in a convex hull: those with a line through them that has all pieces on its left.
*/
class Hull_supports_2
{
public:
  // Of lines through one point, the second one not before the first one counterclockwise.
  using Normals = std::array<Exact_pair, 2>;

private:
  std::map<Exact_pair, Normals> m_normals;   // of lines through vertices with all on the other side

public:
  bool hold(const Exact_pair& vertex) const { return m_normals.count(vertex) > 0; }
  const Normals& normals(const Exact_pair& vertex) const { return m_normals.at(vertex); }

  // Adds those of a polygon, outside of which these pieces are. All normals between two that are found are as good; the
  // first and the last one are kept.
  // \throws Run_stopped
  void add(const Hull_polygon_2& polygon, const std::vector<Hull_piece_2>& pieces, Run_of_steps& run)
  {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      run.check();
      for (const Exact_pair& normal : possible_normals(polygon, pieces, i))
        if (is_support(polygon, pieces, i, normal)) {
          auto& [first, last] = m_normals.try_emplace(polygon.vertex(i), Normals{normal, normal}).first->second;
          if (exact_cross(normal, first) > 0)
            first = normal;
          if (exact_cross(last, normal) > 0)
            last = normal;
        }
    }
  }

private:
  // Normals of the tangents of pieces at a vertex, and two between those of its edges: one is good at flat vertices,
  // and the other one at acute ones.
  static std::vector<Exact_pair> possible_normals(const Hull_polygon_2& polygon,
                                                  const std::vector<Hull_piece_2>& pieces, std::size_t i)
  {
    const Exact_pair &point = polygon.vertex(i), before = exact_difference(point, polygon.vertex_before(i)),
                     after = exact_difference(polygon.vertex(i + 1), point);
    std::vector<Exact_pair> result;
    for (std::size_t k : polygon.pieces_beside(i)) {
      const std::vector<Exact_pair>& points = pieces[k].points();
      for (const auto& [end, next] :
           {std::pair(points.front(), points[1]), std::pair(points.back(), points[points.size() - 2])})
        if (end == point) {
          result.push_back(normal_on_the_right(exact_difference(next, point)));
          result.push_back(normal_on_the_right(exact_difference(point, next)));
        }
    }
    const Exact_pair along = sum(scaled(before), scaled(after)),
                     outward = exact_difference(scaled(before), scaled(after));
    result.push_back(normal_on_the_right(along));
    result.push_back(outward);
    return result;
  }

  static bool is_support(const Hull_polygon_2& polygon, const std::vector<Hull_piece_2>& pieces, std::size_t i,
                         const Exact_pair& normal)
  {
    const std::vector<std::size_t> beside = polygon.pieces_beside(i);
    if (normal == Exact_pair{0, 0})
      return beside.empty();
    const auto is_not_above = [&](const Exact_pair& point) {
      return exact_dot(exact_difference(point, polygon.vertex(i)), normal) <= 0;
    };
    return is_not_above(polygon.vertex(i + 1)) && is_not_above(polygon.vertex_before(i)) &&
        std::all_of(beside.begin(), beside.end(), [&](std::size_t k) {
             return std::all_of(pieces[k].points().begin(), pieces[k].points().end(), is_not_above);
           });
  }
};

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_SUPPORTS_2_H
