// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_BOUNDARY_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_element_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

/*
The boundary of a kernel, seen from a point in its interior, the origin: in each direction that element is on it whose
height is the greatest one. Heights are convex functions of the direction.

Cones are halved until at most two elements may be on the boundary within: one, or one at the first ray and the other
one at the second ray, whose heights change their order once. Elements are left out where the tangents at the ends of
the cone, which are below the boundary of the dual hull, are above the chord of their heights. More than two may meet in
an end of an arc that is known exactly, and there two arcs change their order as often as three times nearby: at a
reflex corner between arcs that turn left, the tangent of each one is on the boundary on the side of the other one.
Slopes there tell which one is on the boundary before and after it.
*/
class Kernel_boundary_2
{
  static constexpr int most_halvings = 80;
  using Summit = Kernel_element_2::Summit;
  using Place = Kernel_element_2::Place;

public:
  // A ray between two successive parts of the boundary is in this cone; which element is on the boundary before and
  // after it.
  struct Corner
  {
    std::array<std::size_t, 2> elements;
    std::array<std::array<Summit, 2>, 2> summits;   // of both elements, each at both rays of the cone
    Vector_bounds<2> point;                         // relative to the origin
    bool is_decided;
  };

private:
  // A direction, and the elements that may be the highest ones around it, with their summits there.
  struct Ray
  {
    Exact_pair direction;
    std::vector<std::optional<Summit>> summits;   // of all elements
    std::optional<std::size_t> highest;
  };

  Run_of_steps& m_run;
  std::vector<Kernel_element_2> m_elements;
  std::vector<Corner> m_corners;

public:
  // Of elements that are the same in a direction, the first one is taken to be the highest.
  // \throws Run_stopped
  Kernel_boundary_2(std::vector<Kernel_element_2> elements, Run_of_steps& run)
    : m_run(run), m_elements(std::move(elements))
  {
    std::vector<std::size_t> all(m_elements.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::vector<Ray> rays;
    for (const auto& [x, y] : {std::pair(97, 2), std::pair(67, 71)})   // no axes, where curves have ends
      for (Exact_pair d{x, y}; rays.size() < 4 || (x == 67 && rays.size() < 8); d = {Exact_rational(-d[1]), d[0]})
        rays.push_back(ray(d, all));
    for (int i = 0; i < 8; ++i) {
      visit(rays[i % 2 * 4 + i / 2], rays[(i + 1) % 2 * 4 + (i + 1) / 2 % 4], all, 0);
      m_run.add_progress(1.0 / 8);
    }
  }

  const std::vector<Kernel_element_2>& elements() const { return m_elements; }

  // Counterclockwise; none if one element is the whole boundary.
  const std::vector<Corner>& corners() const { return m_corners; }

private:
  Ray ray(const Exact_pair& direction, const std::vector<std::size_t>& candidates) const
  {
    Ray result{direction, std::vector<std::optional<Summit>>(m_elements.size()), std::nullopt};
    std::size_t best = candidates.front();
    for (const std::size_t i : candidates) {
      m_run.check();
      result.summits[i] = m_elements[i].summit(direction);
      if (result.summits[i]->height.lower > result.summits[best]->height.lower)
        best = i;
    }
    if (std::all_of(candidates.begin(), candidates.end(), [&](std::size_t i) {
          return i == best || result.summits[i]->height.upper <= result.summits[best]->height.lower;
        }))
      result.highest = best;
    return result;
  }

  // A ray within a cone on which one element is certainly the highest one, if one of three is such a ray.
  Ray ray_between(const Ray& first, const Ray& second, const std::vector<std::size_t>& candidates) const
  {
    Ray result{};
    for (const int part : {8, 7, 11}) {
      const Exact_rational share(Exact_rational(part) / 16), rest(1 - share);
      Exact_pair direction;
      for (std::size_t k = 0; k < 2; ++k)
        direction[k] = rest * first.direction[k] + share * second.direction[k];
      result = ray(direction, candidates);
      if (result.highest)
        return result;
    }
    return result;
  }

  void visit(const Ray& first, const Ray& second, std::vector<std::size_t> candidates, int halvings)
  {
    if (first.highest && second.highest) {
      candidates = possible(first, second, candidates);
      if (candidates.size() == 1)
        return;
      if (*first.highest != *second.highest) {
        const auto joint = joint_of(first, second, candidates);
        if (joint ? change_at(*joint, first, second, candidates) : candidates.size() == 2 && change_once(first, second))
          return add_corner(first, second, joint);
      }
    }
    if (halvings == most_halvings)
      return add_undecided(first, second, candidates);
    const Ray between = ray_between(first, second, candidates);
    visit(first, between, candidates, halvings + 1);
    visit(between, second, candidates, halvings + 1);
  }

  // The height in the direction of another ray of that dual point of the highest element that is its summit: less than
  // the height of the hull, or that.
  Exact_rational height_below(const Ray& ray, const Exact_pair& direction) const
  {
    return height_below(ray, *ray.highest, direction);
  }
  Exact_rational height_below(const Ray& ray, std::size_t element, const Exact_pair& direction) const
  {
    return m_elements[element].height(ray.summits[element]->range, direction).lower;
  }

  // The elements that are above those of both rays somewhere in the cone, with these.
  std::vector<std::size_t> possible(const Ray& first, const Ray& second,
                                    const std::vector<std::size_t>& candidates) const
  {
    const std::array<Exact_rational, 2> a{first.summits[*first.highest]->height.lower,
                                          height_below(first, second.direction)};
    const std::array<Exact_rational, 2> b{height_below(second, first.direction),
                                          second.summits[*second.highest]->height.lower};
    std::vector<std::size_t> result;
    for (const std::size_t i : candidates)
      if (i == *first.highest || i == *second.highest ||
          !is_below(first.summits[i]->height.upper, second.summits[i]->height.upper, a, b))
        result.push_back(i);
    return result;
  }

  // Whether a linear function on [0,1] is nowhere above the greater one of two others: at 0, at 1, and where these are
  // the same.
  static bool is_below(const Exact_rational& at_0, const Exact_rational& at_1, const std::array<Exact_rational, 2>& a,
                       const std::array<Exact_rational, 2>& b)
  {
    if (at_0 > (std::max)(a[0], b[0]) || at_1 > (std::max)(a[1], b[1]))
      return false;
    const Exact_rational d0(a[0] - b[0]), d1(a[1] - b[1]);
    if (!(d0 > 0 && d1 < 0))
      return true;
    const Exact_rational t(d0 / (d0 - d1));
    return at_0 + t * (at_1 - at_0) <= a[0] + t * (a[1] - a[0]);
  }

  // Whether the slope of the height of the second element along the cone, which increases, begins with more than that
  // of the first one ends with: for two tangents both are constant.
  bool change_once(const Ray& first, const Ray& second) const
  {
    const std::size_t i = *first.highest, j = *second.highest;
    const Exact_pair along = exact_difference(second.direction, first.direction);
    if (m_elements[i].is_line() || m_elements[j].is_line())   // convex, and linear
      return true;
    return m_elements[j].height(first.summits[j]->range, along).lower >=
        m_elements[i].height(second.summits[i]->range, along).upper;
  }

  // An end of one of these arcs in the cone, if all elements have its height: arcs with this end, and tangents through
  // it.
  std::optional<Exact_pair> joint_of(const Ray& first, const Ray& second,
                                     const std::vector<std::size_t>& candidates) const
  {
    const auto passes_through = [&](std::size_t i, const Exact_pair& point) {
      const Rational_interval height = m_elements[i].summit(point).height;
      return height.lower == 1 && height.upper == 1;
    };
    for (const std::size_t i : candidates)
      for (const int end : {0, 1})
        if (const auto point = m_elements[i].point_of_end(end); point && !m_elements[i].is_line() &&
            exact_cross(first.direction, *point) >= 0 && exact_cross(*point, second.direction) >= 0)
          if (std::all_of(candidates.begin(), candidates.end(),
                          [&](std::size_t k) { return passes_through(k, *point); }))
            return point;
    return std::nullopt;
  }

  // Whether none of these elements is above the first one before the joint, or above the second one after it. Their
  // heights are the same there, and their slopes increase along the cone.
  bool change_at(const Exact_pair& joint, const Ray& first, const Ray& second,
                 const std::vector<std::size_t>& candidates) const
  {
    const std::size_t i = *first.highest, j = *second.highest;
    const Exact_pair along = exact_difference(second.direction, first.direction);
    const auto slope = [&](std::size_t element, const Summit& summit) {
      return m_elements[element].height(summit.range, along);
    };
    const Exact_rational before = slope(i, summit_beside(i, joint, 1)).upper,
                         after = slope(j, summit_beside(j, joint, 0)).lower;
    return std::all_of(candidates.begin(), candidates.end(), [&](std::size_t k) {
      return (k == i || slope(k, *first.summits[k]).lower >= before) &&
          (k == j || slope(k, *second.summits[k]).upper <= after);
    });
  }

  // The summit of an element just before a joint (1), or just after it (0): an arc that ends there, or begins, is
  // passed through.
  Summit summit_beside(std::size_t element, const Exact_pair& joint, int end) const
  {
    if (m_elements[element].point_of_end(end) != joint)
      return m_elements[element].summit(joint);
    return {Rational_interval(Exact_rational(1)), Place::INSIDE, m_elements[element].range_of_end(end)};
  }

  void add_corner(Ray first, Ray second, const std::optional<Exact_pair>& joint)
  {
    const std::size_t i = *first.highest, j = *second.highest;
    Corner corner{{i, j}, summits(first, second, i, j), {}, true};
    if (joint) {
      const Summit before = summit_beside(i, *joint, 1), after = summit_beside(j, *joint, 0);
      corner.summits = {{{before, before}, {after, after}}};
      corner.point = {Rational_interval((*joint)[0]), Rational_interval((*joint)[1])};
    } else if (m_elements[i].is_line() && m_elements[j].is_line()) {
      const Exact_pair a = *m_elements[i].dual_of_end(0), b = *m_elements[j].dual_of_end(0);
      const Exact_rational determinant = exact_cross(a, b);
      corner.point = {Rational_interval(Exact_rational((b[1] - a[1]) / determinant)),
                      Rational_interval(Exact_rational((a[0] - b[0]) / determinant))};
    } else {
      for (int halvings = 0; halvings < most_halvings; ++halvings) {
        Ray between = ray_between(first, second, {i, j});
        if (!between.highest)
          break;
        (*between.highest == i ? first : second) = std::move(between);
      }
      corner.summits = summits(first, second, i, j);
      corner.point = point_between(first, second, {i, j});
    }
    m_corners.push_back(std::move(corner));
  }

  void add_undecided(const Ray& first, const Ray& second, const std::vector<std::size_t>& candidates)
  {
    const std::size_t i = first.highest.value_or(candidates.front()), j = second.highest.value_or(candidates.back());
    m_corners.push_back({{i, j}, summits(first, second, i, j), point_between(first, second, candidates), false});
  }

  static std::array<std::array<Summit, 2>, 2> summits(const Ray& first, const Ray& second, std::size_t i, std::size_t j)
  {
    return {{{*first.summits[i], *second.summits[i]}, {*first.summits[j], *second.summits[j]}}};
  }

  // Bounds of the boundary between two rays: directions divided by heights, which are not above the chord.
  Vector_bounds<2> point_between(const Ray& first, const Ray& second, const std::vector<std::size_t>& candidates) const
  {
    Rational_interval heights;
    for (const Ray* ray : {&first, &second}) {
      for (const std::size_t i : candidates)
        heights.upper = (std::max)(heights.upper, ray->summits[i]->height.upper);
      const std::size_t i = ray->highest.value_or(candidates[0]);
      heights.lower = (std::max)(
          heights.lower, (std::min)(height_below(*ray, i, first.direction), height_below(*ray, i, second.direction)));
    }
    Vector_bounds<2> result;
    for (std::size_t k = 0; k < 2; ++k)
      result[k] = hull(Rational_interval(first.direction[k]), Rational_interval(second.direction[k])) / heights;
    return result;
  }
};

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_BOUNDARY_2_H
