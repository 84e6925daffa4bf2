// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_SOLID_MEMBERSHIP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_SOLID_MEMBERSHIP_H

#include <CGAL/Spline_constraints_d/function/weight_sign.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
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
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Whether the maps of a motion keep orientations. \throws Invalid_input when it is not proved that they are invertible.
inline bool has_positive_maps(const Rational_motion_3& motion, const std::string& name)
{
  const auto& c = motion.columns();
  const auto minor = [&](std::size_t i, std::size_t k) { return c[1][i] * c[2][k] - c[1][k] * c[2][i]; };
  const auto determinant = c[0][0] * minor(1, 2) + c[0][1] * minor(2, 0) + c[0][2] * minor(0, 1);
  try {
    return certified_weight_sign(determinant, {}) > 0;
  } catch (const Invalid_input&) {
    throw Invalid_input(name + ": it is not proved that the maps of the motion are invertible at all times");
  }
}

// Tells, with proof, whether a point lies in a solid, by a ray that goes through the boundary.
class Solid_membership
{
public:
  using Point_3 = Rational_motion_3::Kernel::Point_3;
  using Vector = Rational_motion_3::Kernel::Vector_3;
  using Range = std::pair<Exact_rational, Exact_rational>;

  // A solution of three equations in the parameters of a patch and a third unknown, which is regular.
  struct Passage
  {
    Range range;             // of the third unknown
    bool is_inside_of_patch; // and not on a side
  };

private:
  const Solid_boundary& m_boundary;
  Common::Operation_budget& m_budget;

public:
  Solid_membership(const Solid_boundary& boundary, Common::Operation_budget& budget)
    : m_boundary(boundary), m_budget(budget)
  {}

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

  // By a ray; seen from the solid.
  std::optional<bool> is_inside(const Point_3& point)
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

private:
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
      if (const std::optional<bool> begins_inside = is_inside(point + step))
        return *begins_inside != has_positive_maps;
    }
    return std::nullopt;
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SOLID_SOLID_MEMBERSHIP_H
