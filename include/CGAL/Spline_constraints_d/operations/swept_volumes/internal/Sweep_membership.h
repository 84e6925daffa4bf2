// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Tells, with proof, when a point lies in a moving solid: its path, seen from the solid, enters and leaves through the
// boundary, where T(u, v, t) is the point.
class Sweep_membership
{
  using Point = std::array<Exact_rational, 3>;
  using Point_3 = Rational_motion_3::Kernel::Point_3;
  using Vector = Rational_motion_3::Kernel::Vector_3;
  using Times = std::vector<std::pair<Exact_rational, Exact_rational>>;

  const Common::Spline_patch<3>& m_boundary;
  const Rational_motion_3& m_motion;
  Common::Operation_budget& m_budget;

public:
  Sweep_membership(const Common::Spline_patch<3>& boundary, const Rational_motion_3& motion,
                   Common::Operation_budget& budget)
    : m_boundary(boundary), m_motion(motion), m_budget(budget)
  {}

  bool must_stop() { return m_budget.must_stop(); }

  // Whether T_u x T_v points out of the moved solid; nothing, where that was not decided. A short segment along the
  // normal goes through the boundary once, and begins inside or outside. `has_positive_maps`: the maps keep
  // orientations.
  std::optional<bool> has_outer_normals(bool has_positive_maps)
  {
    constexpr int tries = 6;
    Exact_rational length = size() / 64;
    for (int i = 0; i < tries; ++i, length /= 16) {
      const auto [point, normal] = point_and_normal(Exact_rational(Exact_rational(2 * i + 3) / 17));
      const double size = std::sqrt(to_nearest_double(normal * normal));
      if (!(size > 0))
        continue;
      const Vector step = normal * Exact_rational(length / Exact_rational(size));
      const std::optional<Times> hits = hits_on_ray(point + step, step * Exact_rational(-2), 1);
      if (!hits || hits->size() != 1)
        continue;
      if (const std::optional<bool> is_inside = is_inside_solid(point + step))
        return *is_inside != has_positive_maps;
    }
    return std::nullopt;
  }

  // Whether it does so at any time; nothing, where that was not decided.
  std::optional<bool> operator()(const Point& point)
  {
    const std::optional<Times> times = times_on_boundary(point);
    if (!times)
      return std::nullopt;
    return times->empty() ? is_inside_at(m_motion.domain().first, point) : true;
  }

  // The intervals of time at which it does, by enclosures of their ends; nothing, where they were not decided.
  std::optional<Times> intervals(const Point& point)
  {
    const std::optional<Times> times = times_on_boundary(point);
    if (!times)
      return std::nullopt;
    const auto [begin, end] = m_motion.domain();
    const std::optional<bool> is_inside = is_inside_at(begin, point);
    if (!is_inside)
      return std::nullopt;
    Times result;
    std::vector<Exact_rational> ends;
    if (*is_inside)
      ends.push_back(begin);
    for (const auto& time : *times)
      ends.push_back(Exact_rational((time.first + time.second) / 2));
    if (ends.size() % 2 == 1)
      ends.push_back(end);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      result.emplace_back(ends[i], ends[i + 1]);
    return result;
  }

private:
  // When the boundary passes the point, one time after the other; nothing, unless it surely goes through each time.
  std::optional<Times> times_on_boundary(const Point& point)
  {
    Exact_ranges box{m_boundary.domain(0), m_boundary.domain(1), m_motion.domain()};
    Constraint_system_d system(box);
    const std::vector<Unknown> x = unknowns_in(box);
    const Vector_expression<3> moved = image(x);
    for (std::size_t i = 0; i < 3; ++i)
      system.add(moved[i] == point[i]);
    return certified_ranges(system, 2);
  }

  std::optional<bool> is_inside_at(const Exact_rational& time, const Point& point)
  {
    return is_inside_solid(m_motion.inverse(time).transform(Point_3(point[0], point[1], point[2])));
  }

  // By a ray; seen from the solid.
  std::optional<bool> is_inside_solid(const Point_3& point)
  {
    for (const Vector& direction : {Vector(3, 5, 7), Vector(-5, 7, 3), Vector(7, -3, 5)})
      if (const std::optional<Times> hits = hits_on_ray(point, direction, size()))
        return hits->size() % 2 == 1;
    return std::nullopt;
  }

  // Where a ray goes through the boundary, up to a parameter.
  std::optional<Times> hits_on_ray(const Point_3& from, const Vector& direction, const Exact_rational& last)
  {
    Exact_ranges box{m_boundary.domain(0), m_boundary.domain(1), {Exact_rational(0), last}};
    Constraint_system_d system(box);
    const std::vector<Unknown> x = unknowns_in(box);
    const Vector_expression<3> surface = Common::Parametric_vector<3>(m_boundary)(std::span(x).first(2));
    for (int i = 0; i < 3; ++i)
      system.add(surface[static_cast<std::size_t>(i)] - x[2] * direction[i] == from[i]);
    return certified_ranges(system, 2);
  }

  // More than the sum of the sides of a box around the solid.
  Exact_rational size() const
  {
    Exact_rational result = 1;
    for (const Common::Rational_interval& range : m_boundary.values())
      result += Exact_rational(range.upper - range.lower);
    return result;
  }

  // At the same part of both ranges of parameters.
  std::pair<Point_3, Vector> point_and_normal(const Exact_rational& part) const
  {
    std::array<Exact_rational, 2> place;
    for (int axis : {0, 1}) {
      const auto& [lower, upper] = m_boundary.domain(axis);
      place[static_cast<std::size_t>(axis)] = lower + part * (upper - lower);
    }
    const std::span<const Exact_rational> parameters(place);
    const auto w = m_boundary.weight().value_and_gradient(parameters);
    std::array<Exact_rational, 3> x;
    std::array<std::array<Exact_rational, 3>, 2> tangent;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto f = m_boundary.numerators()[i].value_and_gradient(parameters);
      x[i] = f.value / w.value;
      for (std::size_t j : {0u, 1u})
        tangent[j][i] = (f.gradient[j] - x[i] * w.gradient[j]) / w.value;
    }
    const auto vector = [](const std::array<Exact_rational, 3>& v) { return Vector(v[0], v[1], v[2]); };
    return {Point_3(x[0], x[1], x[2]), CGAL::cross_product(vector(tangent[0]), vector(tangent[1]))};
  }

  // The ranges of one unknown in all solutions, in order; nothing, unless all are regular and told apart.
  std::optional<Times> certified_ranges(const Constraint_system_d& system, int unknown)
  {
    if (m_budget.must_stop())
      return std::nullopt;
    const auto solutions = Subdivision_solver_d<>(m_budget.remaining())(system);
    m_budget.add(solutions.summary());
    if (!solutions.is_complete())
      return std::nullopt;
    Times result;
    for (const auto& solution : solutions) {
      if (solution.kind() != Solution_kind::CERTIFIED)
        return std::nullopt;
      result.emplace_back(solution[unknown].first, solution[unknown].second);
    }
    std::sort(result.begin(), result.end());
    for (std::size_t i = 1; i < result.size(); ++i)
      if (result[i].first <= result[i - 1].second)
        return std::nullopt;
    return result;
  }

  Vector_expression<3> image(const std::vector<Unknown>& x) const
  {
    const Vector_expression<3> point = Common::Parametric_vector<3>(m_boundary)(std::span(x).first(2));
    const auto column = [&](std::size_t k) { return Spline_map<1, 3>(m_motion.columns()[k], m_motion.weight())(x[2]); };
    return column(0) * point[0] + column(1) * point[1] + column(2) * point[2] + column(3);
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H
