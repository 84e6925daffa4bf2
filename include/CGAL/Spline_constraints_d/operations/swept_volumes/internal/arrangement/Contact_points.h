// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_CONTACT_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_CONTACT_POINTS_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_complex.h>

#include <CGAL/enum.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The points of a complex of triangles: those of a soup, which differ, and those that are made where its triangles
// meet. Points are the same when their coordinates are.
class Contact_points
{
  using Point = Exact_kernel::Point_3;

  const Triangle_soup& m_soup;
  std::vector<Point> m_points;
  std::map<Point, std::size_t, Exact_kernel::Less_xyz_3> m_indices;
  std::map<std::array<std::size_t, 3>, std::size_t> m_on_edges; // of an edge's ends and a triangle

public:
  explicit Contact_points(const Triangle_soup& soup) : m_soup(soup)
  {
    for (const auto& point : soup.points)
      index_of(Point(point.x(), point.y(), point.z()));
  }

  const std::vector<Point>& points() const { return m_points; }
  const Point& operator[](std::size_t index) const { return m_points[index]; }

  std::size_t index_of(const Point& point)
  {
    const auto [place, is_new] = m_indices.emplace(point, m_points.size());
    if (is_new)
      m_points.push_back(point);
    return place->second;
  }

  // What two triangles have in common that have no area in common: nothing, a point, or the ends of a segment.
  std::vector<std::size_t> contact_of(std::size_t a, std::size_t b)
  {
    std::vector<std::size_t> result;
    append_points_of_edges(a, b, result);
    append_points_of_edges(b, a, result);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    if (result.size() > 2) { // the outer ones of points on a line
      std::sort(result.begin(), result.end(), [&](std::size_t i, std::size_t k) {
        return CGAL::compare_xyz(m_points[i], m_points[k]) == CGAL::SMALLER;
      });
      result = {result.front(), result.back()};
    }
    return result;
  }

private:
  // Where the boundary of a triangle meets another one.
  void append_points_of_edges(std::size_t triangle, std::size_t other, std::vector<std::size_t>& result)
  {
    const Corners &own = m_soup.triangles[triangle], &corners = m_soup.triangles[other];
    std::array<CGAL::Sign, 3> side;
    for (int k = 0; k < 3; ++k) {
      side[k] =
          CGAL::orientation(in_doubles(corners[0]), in_doubles(corners[1]), in_doubles(corners[2]), in_doubles(own[k]));
      if (side[k] == CGAL::ZERO && has_in_plane(corners, own[k]))
        result.push_back(own[k]);
    }
    for (int k = 0; k < 3; ++k) {
      const int next = (k + 1) % 3;
      if (side[k] * side[next] < 0 && is_crossed(corners, own[k], own[next]))
        result.push_back(point_on_edge(own[k], own[next], other));
    }
  }

  const Double_kernel::Point_3& in_doubles(std::size_t index) const { return m_soup.points[index]; }

  // Whether a point in the plane of a triangle lies in it.
  bool has_in_plane(const Corners& corners, std::size_t point) const
  {
    for (int k = 0; k < 3; ++k)
      if (CGAL::coplanar_orientation(in_doubles(corners[k]), in_doubles(corners[(k + 1) % 3]),
                                     in_doubles(corners[(k + 2) % 3]), in_doubles(point)) == CGAL::NEGATIVE)
        return false;
    return true;
  }

  // Whether the line through two points on different sides of a triangle's plane meets it.
  bool is_crossed(const Corners& corners, std::size_t from, std::size_t to) const
  {
    bool has_positive = false, has_negative = false;
    for (int k = 0; k < 3; ++k) {
      const CGAL::Sign sign =
          CGAL::orientation(in_doubles(from), in_doubles(to), in_doubles(corners[k]), in_doubles(corners[(k + 1) % 3]));
      has_positive = has_positive || sign == CGAL::POSITIVE;
      has_negative = has_negative || sign == CGAL::NEGATIVE;
    }
    return !(has_positive && has_negative);
  }

  std::size_t point_on_edge(std::size_t from, std::size_t to, std::size_t triangle)
  {
    if (from > to)
      std::swap(from, to);
    const auto [place, is_new] = m_on_edges.try_emplace({from, to, triangle}, 0);
    if (is_new) {
      const Corners& corners = m_soup.triangles[triangle];
      const Point &p = m_points[from], &q = m_points[to];
      const auto height = [&](const Point& point) {
        return CGAL::volume(m_points[corners[0]], m_points[corners[1]], m_points[corners[2]], point);
      };
      const Exact_kernel::FT at_p = height(p), at_q = height(q);
      place->second = index_of(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return place->second;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_CONTACT_POINTS_H
