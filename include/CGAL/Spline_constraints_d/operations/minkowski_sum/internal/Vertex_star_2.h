// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_VERTEX_STAR_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_VERTEX_STAR_2_H

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// A curve that leaves a vertex: its direction, and its curvature as seen in this.
struct Star_ray_2
{
  Interval_pair direction;
  Interval curvature;
};

/*
The boundaries of a region that meet in a vertex, as rays. Those that end there and those that begin take turns around
it. Which one of these goes on as which, so that the region between them is on the left of both.
*/
class Vertex_star_2
{
  std::vector<Star_ray_2> m_ends, m_begins;

public:
  Vertex_star_2(std::vector<Star_ray_2> ends, std::vector<Star_ray_2> begins)
    : m_ends(std::move(ends)), m_begins(std::move(begins))
  {}

  // For each end the begin that it goes on as; nothing if the order is not certain.
  std::optional<std::vector<std::size_t>> successors() const
  {
    std::vector<std::size_t> result;
    std::vector<bool> is_used(m_begins.size(), false);
    for (const Star_ray_2& end : m_ends) {
      const std::optional<std::size_t> next = first_clockwise(end);
      if (!next || is_used[*next])
        return std::nullopt;
      is_used[*next] = true;
      result.push_back(*next);
    }
    return result;
  }

private:
  // The first begin that is met when an end is turned clockwise.
  std::optional<std::size_t> first_clockwise(const Star_ray_2& end) const
  {
    for (std::size_t i = 0; i < m_begins.size(); ++i) {
      bool is_first = true;
      for (std::size_t k = 0; k < m_begins.size(); ++k)
        is_first = is_first && (k == i || is_certainly_before(end, m_begins[i], m_begins[k]));
      if (is_first)
        return i;
    }
    return std::nullopt;
  }

  // On which side of a ray another one is: 1 on the left, -1 on the right; 0 if it is not certain, as for opposite
  // ones. Of rays with the same direction, the one with the larger curvature is on the left.
  static int side(const Star_ray_2& of, const Star_ray_2& ray)
  {
    if (const int sign = certain_sign(cross(of.direction, ray.direction)); sign != 0)
      return sign;
    return certain_sign(dot(of.direction, ray.direction)) > 0 ? certain_sign(ray.curvature - of.curvature) : 0;
  }

  static bool is_certainly_before(const Star_ray_2& from, const Star_ray_2& a, const Star_ray_2& b)
  {
    const int a_side = side(from, a), b_side = side(from, b);
    if (a_side * b_side < 0)
      return a_side < 0;
    if ((a_side == 0 && !is_behind(from, a)) || (b_side == 0 && !is_behind(from, b)))
      return false;
    return a_side * b_side > 0 || certain_sign(dot(a.direction, b.direction)) > 0 ? side(a, b) < 0 : a_side < b_side;
  }

  static bool is_behind(const Star_ray_2& from, const Star_ray_2& ray)
  {
    return certain_sign(dot(from.direction, ray.direction)) < 0;
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_VERTEX_STAR_2_H
