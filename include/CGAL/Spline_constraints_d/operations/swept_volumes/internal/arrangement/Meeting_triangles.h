// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_MEETING_TRIANGLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_MEETING_TRIANGLES_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_complex.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// How two triangles meet, beyond vertices and edges that they share.
enum class Meeting
{
  NONE,
  CROSSING,
  COPLANAR
};

// Finds the triangles of a soup that meet, by exact predicates of numbers in double precision.
class Meeting_triangles
{
  using Point = Double_kernel::Point_3;
  using Triangle = Double_kernel::Triangle_3;
  using Segment = Double_kernel::Segment_3;

  const Triangle_soup& m_soup;

public:
  struct Pair
  {
    std::size_t first, second;
    bool is_coplanar; // they have an area in common
  };

  explicit Meeting_triangles(const Triangle_soup& soup) : m_soup(soup) {}

  // All pairs; `is_stopped` is asked once in a while.
  std::vector<Pair> operator()(const std::function<bool()>& is_stopped) const
  {
    struct Box : CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>
    {
      std::size_t triangle;
      Box(const CGAL::Bbox_3& bounds, std::size_t index)
        : CGAL::Box_intersection_d::Box_d<double, 3, CGAL::Box_intersection_d::ID_EXPLICIT>(bounds), triangle(index)
      {}
    };
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < m_soup.triangles.size(); ++i)
      boxes.emplace_back(triangle(i).bbox(), i);
    std::vector<Pair> result;
    std::size_t looked_at = 0;
    bool stops = false;
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
      stops = stops || ((++looked_at & 0xfff) == 0 && is_stopped());
      if (stops)
        return;
      const Meeting meeting = meeting_of(a.triangle, b.triangle);
      if (meeting != Meeting::NONE)
        result.push_back(
            {(std::min)(a.triangle, b.triangle), (std::max)(a.triangle, b.triangle), meeting == Meeting::COPLANAR});
    });
    std::sort(result.begin(), result.end(), [](const Pair& a, const Pair& b) {
      return std::array{a.first, a.second} < std::array{b.first, b.second};
    });
    return result;
  }

private:
  const Point& corner(std::size_t triangle, int k) const { return m_soup.points[m_soup.triangles[triangle][k]]; }
  Triangle triangle(std::size_t i) const { return {corner(i, 0), corner(i, 1), corner(i, 2)}; }

  Meeting meeting_of(std::size_t a, std::size_t b) const
  {
    // the corners of each, those that they share first
    std::array<int, 3> of_a{0, 1, 2}, of_b{0, 1, 2};
    int shared = 0;
    for (int i = 0; i < 3; ++i)
      for (int k = shared; k < 3; ++k)
        if (m_soup.triangles[a][of_a[i]] == m_soup.triangles[b][of_b[k]]) {
          std::swap(of_a[shared], of_a[i]);
          std::swap(of_b[shared++], of_b[k]);
          break;
        }
    if (shared == 3)
      return Meeting::COPLANAR;
    const bool is_flat = is_in_plane(a, b);
    if (is_flat)
      return have_common_area(a, b) ? Meeting::COPLANAR : meet_in_a_line(a, of_a, b, of_b, shared);
    if (shared == 2)
      return Meeting::NONE;
    return meet_in_a_line(a, of_a, b, of_b, shared);
  }

  Meeting meet_in_a_line(std::size_t a, const std::array<int, 3>& of_a, std::size_t b, const std::array<int, 3>& of_b,
                         int shared) const
  {
    bool meets = false;
    if (shared == 0)
      meets = CGAL::do_intersect(triangle(a), triangle(b));
    else if (shared == 1) // what begins at the common corner ends at the opposite edge of one of them
      meets = CGAL::do_intersect(Segment(corner(a, of_a[1]), corner(a, of_a[2])), triangle(b)) ||
          CGAL::do_intersect(Segment(corner(b, of_b[1]), corner(b, of_b[2])), triangle(a));
    return meets ? Meeting::CROSSING : Meeting::NONE;
  }

  bool is_in_plane(std::size_t a, std::size_t b) const
  {
    for (int k = 0; k < 3; ++k)
      if (CGAL::orientation(corner(a, 0), corner(a, 1), corner(a, 2), corner(b, k)) != CGAL::COPLANAR)
        return false;
    return true;
  }

  // Of triangles in one plane: no line along an edge of one has the other one on its outer side.
  bool have_common_area(std::size_t a, std::size_t b) const
  {
    return !is_separated_by_an_edge(a, b) && !is_separated_by_an_edge(b, a);
  }

  bool is_separated_by_an_edge(std::size_t a, std::size_t b) const
  {
    for (int k = 0; k < 3; ++k) {
      const Point &p = corner(a, k), &q = corner(a, (k + 1) % 3), &inner = corner(a, (k + 2) % 3);
      bool is_outside = true;
      for (int l = 0; l < 3 && is_outside; ++l)
        is_outside = CGAL::coplanar_orientation(p, q, inner, corner(b, l)) != CGAL::POSITIVE;
      if (is_outside)
        return true;
    }
    return false;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_MEETING_TRIANGLES_H
