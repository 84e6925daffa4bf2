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
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>
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
// boundary, where a moved patch T(u, v, t) is the point.
class Sweep_membership
{
  using Point = std::array<Exact_rational, 3>;
  using Point_3 = Rational_motion_3::Kernel::Point_3;
  using Vector = Rational_motion_3::Kernel::Vector_3;
  using Range = std::pair<Exact_rational, Exact_rational>;
  using Times = std::vector<Range>;

  const Solid_boundary& m_boundary;
  const Rational_motion_3& m_motion;
  Common::Operation_budget& m_budget;

public:
  Sweep_membership(const Solid_boundary& boundary, const Rational_motion_3& motion, Common::Operation_budget& budget)
    : m_boundary(boundary), m_motion(motion), m_budget(budget)
  {}

  bool must_stop() { return m_budget.must_stop(); }

  // Whether T_u x T_v points out of the moved solid, of each patch; nothing, where that was not decided. It is the same
  // on connected parts. `has_positive_maps`: the maps keep orientations.
  std::optional<std::vector<bool>> has_outer_normals(bool has_positive_maps)
  {
    std::vector<bool> result(m_boundary.size());
    for (std::size_t patch = 0; patch < result.size(); ++patch) {
      if (m_boundary.component(patch) != patch)
        continue;
      const std::optional<bool> is_outer = has_outer_normals(patch, has_positive_maps);
      if (!is_outer)
        return std::nullopt;
      result[patch] = *is_outer;
    }
    for (std::size_t patch = 0; patch < result.size(); ++patch)
      result[patch] = result[m_boundary.component(patch)];
    return result;
  }

  // Whether it does so at any time; nothing, where that was not decided. One proved passage of the boundary is enough.
  std::optional<bool> operator()(const Point& point)
  {
    bool is_decided = true;
    for (const Solid_boundary::Patch& patch : m_boundary.patches()) {
      const std::optional<std::vector<Passage>> passages = passages_through(passage_system(patch, point));
      if (passages && !passages->empty())
        return true;
      is_decided = is_decided && passages;
    }
    return is_decided ? is_inside_at(m_motion.domain().first, point) : std::nullopt;
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
  // A solution of three equations in the parameters of a patch and a third unknown, which is regular.
  struct Passage
  {
    Range range;             // of the third unknown
    bool is_inside_of_patch; // and not on a side
  };

  // A short segment along the normal goes through the boundary once, and begins inside or outside.
  std::optional<bool> has_outer_normals(std::size_t patch, bool has_positive_maps)
  {
    constexpr int tries = 6;
    Exact_rational length = size() / 64;
    for (int i = 0; i < tries; ++i, length /= 16) {
      const auto [point, normal] = point_and_normal(m_boundary[patch], Exact_rational(Exact_rational(2 * i + 3) / 17));
      const double size = std::sqrt(to_nearest_double(normal * normal));
      if (!(size > 0))
        continue;
      const Vector step = normal * Exact_rational(length / Exact_rational(size));
      if (hits_on_ray(point + step, step * Exact_rational(-2), 1) != 1)
        continue;
      if (const std::optional<bool> is_inside = is_inside_solid(point + step))
        return *is_inside != has_positive_maps;
    }
    return std::nullopt;
  }

  // When the boundary passes the point, one time after the other; nothing, unless it surely goes through each time: in
  // one patch alone, or in an edge, where two passages at one time are one, and the solid is on one side of it.
  std::optional<Times> times_on_boundary(const Point& point)
  {
    std::vector<Passage> passages;
    for (const Solid_boundary::Patch& patch : m_boundary.patches()) {
      const auto own = passages_through(passage_system(patch, point));
      if (!own)
        return std::nullopt;
      passages.insert(passages.end(), own->begin(), own->end());
    }
    std::sort(passages.begin(), passages.end(), [](const auto& a, const auto& b) { return a.range < b.range; });
    const auto [begin, end] = m_motion.domain();
    Times result;
    for (std::size_t i = 0; i < passages.size();) {
      std::size_t next = i + 1;
      Range range = passages[i].range;
      for (; next < passages.size() && passages[next].range.first <= range.second; ++next)
        range.second = (std::max)(range.second, passages[next].range.second);
      if (next > i + 2 || (next == i + 1 && !passages[i].is_inside_of_patch) || range.first <= begin ||
          range.second >= end)
        return std::nullopt;
      if (next == i + 2) {
        const std::optional<bool> before = is_inside_between(result.empty() ? nullptr : &result.back(), &range, point);
        const std::optional<bool> after =
            is_inside_between(&range, next < passages.size() ? &passages[next].range : nullptr, point);
        if (!before || !after || *before == *after)
          return std::nullopt;
      }
      result.push_back(range);
      i = next;
    }
    return result;
  }

  // Between two passages, or an end of all times; nothing too if there is no time between them.
  std::optional<bool> is_inside_between(const Range* before, const Range* after, const Point& point)
  {
    const auto [begin, end] = m_motion.domain();
    const Exact_rational first = before ? before->second : begin, last = after ? after->first : end;
    if (!(first < last))
      return std::nullopt;
    return is_inside_at(Exact_rational((first + last) / 2), point);
  }

  Constraint_system_d passage_system(const Solid_boundary::Patch& patch, const Point& point) const
  {
    const Exact_ranges box{patch.domain(0), patch.domain(1), m_motion.domain()};
    Constraint_system_d system(box);
    const std::vector<Unknown> x = unknowns_in(box);
    const Vector_expression<3> moved = image(patch, x);
    for (std::size_t i = 0; i < 3; ++i)
      system.add(moved[i] == point[i]);
    return system;
  }

  std::optional<bool> is_inside_at(const Exact_rational& time, const Point& point)
  {
    return is_inside_solid(m_motion.inverse(time).transform(Point_3(point[0], point[1], point[2])));
  }

  // By a ray; seen from the solid.
  std::optional<bool> is_inside_solid(const Point_3& point)
  {
    for (const Vector& direction : {Vector(3, 5, 7), Vector(-5, 7, 3), Vector(7, -3, 5), Vector(-17, -29, 41),
                                    Vector(31, 43, -19), Vector(-37, 23, 53)})
      if (const std::optional<std::size_t> hits = hits_on_ray(point, direction, size()))
        return *hits % 2 == 1;
    return std::nullopt;
  }

  // How many times a ray goes through the boundary, up to a parameter; nothing, unless it surely does each time, which
  // it need not in an edge, and its ends are not on it.
  std::optional<std::size_t> hits_on_ray(const Point_3& from, const Vector& direction, const Exact_rational& last)
  {
    std::size_t result = 0;
    for (const Solid_boundary::Patch& patch : m_boundary.patches()) {
      const Exact_ranges box{patch.domain(0), patch.domain(1), {Exact_rational(0), last}};
      Constraint_system_d system(box);
      const std::vector<Unknown> x = unknowns_in(box);
      const Vector_expression<3> surface = Common::Parametric_vector<3>(patch)(std::span(x).first(2));
      for (int i = 0; i < 3; ++i)
        system.add(surface[static_cast<std::size_t>(i)] - x[2] * direction[i] == from[i]);
      const auto passages = passages_through(system);
      if (!passages || std::any_of(passages->begin(), passages->end(), [&](const Passage& own) {
            return !own.is_inside_of_patch || own.range.first <= 0 || own.range.second >= last;
          }))
        return std::nullopt;
      result += passages->size();
    }
    return result;
  }

  // More than the sum of the sides of a box around the solid.
  Exact_rational size() const
  {
    Common::Vector_bounds<3> bounds = m_boundary[0].values();
    for (std::size_t patch = 1; patch < m_boundary.size(); ++patch) {
      const Common::Vector_bounds<3> own = m_boundary[patch].values();
      for (std::size_t i = 0; i < 3; ++i)
        bounds[i] = hull(bounds[i], own[i]);
    }
    Exact_rational result = 1;
    for (const Common::Rational_interval& range : bounds)
      result += Exact_rational(range.upper - range.lower);
    return result;
  }

  // At the same part of both ranges of parameters.
  static std::pair<Point_3, Vector> point_and_normal(const Solid_boundary::Patch& patch, const Exact_rational& part)
  {
    std::array<Exact_rational, 2> place;
    for (int axis : {0, 1}) {
      const auto& [lower, upper] = patch.domain(axis);
      place[static_cast<std::size_t>(axis)] = lower + part * (upper - lower);
    }
    const std::span<const Exact_rational> parameters(place);
    const auto w = patch.weight().value_and_gradient(parameters);
    std::array<Exact_rational, 3> x;
    std::array<std::array<Exact_rational, 3>, 2> tangent;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto f = patch.numerators()[i].value_and_gradient(parameters);
      x[i] = f.value / w.value;
      for (std::size_t j : {0u, 1u})
        tangent[j][i] = (f.gradient[j] - x[i] * w.gradient[j]) / w.value;
    }
    const auto vector = [](const std::array<Exact_rational, 3>& v) { return Vector(v[0], v[1], v[2]); };
    return {Point_3(x[0], x[1], x[2]), CGAL::cross_product(vector(tangent[0]), vector(tangent[1]))};
  }

  // All solutions; nothing, unless all are regular.
  std::optional<std::vector<Passage>> passages_through(const Constraint_system_d& system)
  {
    if (m_budget.must_stop())
      return std::nullopt;
    const auto solutions = Subdivision_solver_d<>(m_budget.remaining())(system);
    m_budget.add(solutions.summary());
    if (!solutions.is_complete())
      return std::nullopt;
    std::vector<Passage> result;
    for (const auto& solution : solutions) {
      if (solution.kind() != Solution_kind::CERTIFIED)
        return std::nullopt;
      const auto is_inside = [&](int axis) {
        return system.domain(axis).first < solution[axis].first && solution[axis].second < system.domain(axis).second;
      };
      result.push_back({{solution[2].first, solution[2].second}, is_inside(0) && is_inside(1)});
    }
    return result;
  }

  Vector_expression<3> image(const Solid_boundary::Patch& patch, const std::vector<Unknown>& x) const
  {
    const Vector_expression<3> point = Common::Parametric_vector<3>(patch)(std::span(x).first(2));
    const auto column = [&](std::size_t k) { return Spline_map<1, 3>(m_motion.columns()[k], m_motion.weight())(x[2]); };
    return column(0) * point[0] + column(1) * point[1] + column(2) * point[2] + column(3);
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H
