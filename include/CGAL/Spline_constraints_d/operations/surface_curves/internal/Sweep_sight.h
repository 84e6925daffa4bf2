// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SWEEP_SIGHT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SWEEP_SIGHT_H

#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/function/internal/Jet.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Sight_equations.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Silhouette_germ.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/silhouettes_of_sweep.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// The two equations F = G = 0 of the silhouettes of a sweep, as formulas of those of u, v, t whose ranges are more than
// one number, of the time of the eye and perhaps of one more unknown.
struct Sweep_equations
{
  std::vector<Unknown> unknowns;
  std::size_t place; // the number of those of u, v, t
  Expression envelope, sight;

  // F_i G_j - F_j G_i
  Expression minor(std::size_t i, std::size_t j) const
  {
    return derivative(envelope, unknowns[i]) * derivative(sight, unknowns[j]) -
        derivative(envelope, unknowns[j]) * derivative(sight, unknowns[i]);
  }
};

// For parts of a surface, a motion and a path of the eye on which all are polynomial or rational, and boxes of (u, v,
// t, time of the eye).
class Sweep_sight
{
  const Spline_patch<3>& m_surface;
  const Smooth_motion& m_motion;
  const Space_map& m_eye;

public:
  Sweep_sight(const Spline_patch<3>& surface, const Smooth_motion& motion, const Space_map& eye)
    : m_surface(surface), m_motion(motion), m_eye(eye)
  {}

  Sweep_equations equations(const Plane_cell& cell, const Parameter_range& times, const Parameter_box& box,
                            bool has_factor) const
  {
    Parameter_box free;
    for (std::size_t j = 0; j < 3; ++j)
      if (box[j].first < box[j].second)
        free.push_back(box[j]);
    Sweep_equations result{{}, free.size(), Expression(0), Expression(0)};
    free.push_back(box[3]);
    if (has_factor)
      free.emplace_back(-1, 1);
    result.unknowns = unknowns_in(free);
    const bool has_time = box[2].first < box[2].second;
    const std::span<const Unknown> u = std::span(result.unknowns).first(result.place - (has_time ? 1 : 0));
    const Plane_functions planes = on_face(cell.planes, box);
    const Vector_expression<3> x = Parametric_vector<3>(m_surface.part({box[0], box[1]}))(u),
                               n = Parametric_vector<3>(Vector_of_functions<3>{planes[0], planes[1], planes[2]})(u);
    const Smooth_motion part = m_motion.restricted(times.first, times.second);
    std::vector<Vector_expression<3>> at, velocity;
    for (const Space_map& map : part.maps) {
      const Space_map slope = derivative(map);
      const auto value = [&](const Space_map& f) {
        if (has_time)
          return f(result.unknowns[result.place - 1]);
        const std::array<Exact_rational, 3> constant = f(std::array{box[2].first});
        return vector_of<3>([&](std::size_t i) { return Expression(constant[i]); });
      };
      at.push_back(value(map));
      velocity.push_back(value(slope));
    }
    const auto moved = [&](const std::vector<Vector_expression<3>>& a) {
      return a[0] + a[1] * x[0] + a[2] * x[1] + a[3] * x[2];
    };
    const bool is_translation = at.size() == 1;
    const Vector_expression<3> normal =
        is_translation ? n : cross(at[2], at[3]) * n[0] + cross(at[3], at[1]) * n[1] + cross(at[1], at[2]) * n[2];
    result.envelope = dot(is_translation ? velocity[0] : moved(velocity), normal);
    result.sight = dot((is_translation ? at[0] + x : moved(at)) - m_eye(result.unknowns[result.place]), normal);
    return result;
  }
};

// Derivatives of F and G by u, v, t and the time of the eye at a solution, in intervals.
class Sweep_germs
{
  using Interval = Mpfr_interval;
  using Direction = std::array<int, 4>;

  Mpfr_precision_scope m_scope{256};
  std::vector<Exact_rational> m_place;
  std::vector<Interval> m_point;
  const Sweep_equations& m_equations; // of all four unknowns

public:
  Sweep_germs(const Sweep_equations& equations, const Parameter_box& box) : m_equations(equations)
  {
    for (const Parameter_range& range : box) {
      m_place.push_back(range.first);
      m_point.emplace_back(range.first, range.second);
    }
  }

  // The sign of the derivative of G by the time of the eye.
  int velocity() const { return sign(along(m_equations.sight, {0, 0, 0, 1}).first); }

  // The second derivatives of G on the surface F = 0: those of G - f F on its tangent planes.
  Silhouette_germ inside() const
  {
    const std::array<Interval, 3> g = gradient(m_equations.envelope);
    const std::optional<Interval> factor = factor_of({0, 1, 2});
    if (!factor)
      return Silhouette_germ::unknown();
    std::array<std::array<Interval, 3>, 3> h;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        h[i][j] = second(i, j, *factor);
    const auto cofactor = [&](std::size_t i, std::size_t j) {
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
      return h[a][c] * h[b][d] - h[a][d] * h[b][c];
    };
    Interval determinant(0);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        determinant += g[i] * g[j] * cofactor(i, j);
    const int kind = sign(determinant);
    Silhouette_germ result{kind < 0 ? 4 : 0, 0, kind != 0, false, false};
    for (std::size_t i = 0; i < 3 && result.around == 0; ++i) { // along the gradient times an axis
      const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
      result.around = sign(g[b] * g[b] * h[a][a] - Interval(2) * g[a] * g[b] * h[a][b] + g[a] * g[a] * h[b][b]);
    }
    result.is_known = result.is_known && (result.branches > 0 || result.around != 0);
    return result;
  }

  // On a face of the box of u, v, t: the sign of the second derivative of G along F = 0 in the face.
  int bend(std::size_t axis) const
  {
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    const std::optional<Interval> factor = factor_of({a, b});
    if (!factor)
      return 0;
    const std::array<Interval, 3> g = gradient(m_equations.envelope);
    return sign(g[b] * g[b] * second(a, a, *factor) - Interval(2) * g[a] * g[b] * second(a, b, *factor) +
                g[a] * g[a] * second(b, b, *factor));
  }

  // The sign of the derivative of G along F = 0 in the direction of an axis, while others move along.
  int slope(std::size_t axis, const std::vector<std::size_t>& others) const
  {
    const std::optional<Interval> factor = factor_of(others);
    return factor ? sign(gradient(m_equations.sight)[axis] - *factor * gradient(m_equations.envelope)[axis]) : 0;
  }

private:
  static int sign(const Interval& x) { return x.lower() > 0 ? 1 : x.upper() < 0 ? -1 : 0; }

  Jet<Interval> along(const Expression& formula, const Direction& direction) const
  {
    std::vector<Jet<Interval>> line;
    for (std::size_t j = 0; j < 4; ++j)
      line.emplace_back(m_point[j], Interval(direction[j]), Interval(0));
    return expression_value(formula, std::span<const Exact_rational>(m_place), std::span<const Jet<Interval>>(line));
  }

  std::array<Interval, 3> gradient(const Expression& formula) const
  {
    return {along(formula, {1, 0, 0, 0}).first, along(formula, {0, 1, 0, 0}).first, along(formula, {0, 0, 1, 0}).first};
  }

  // f with grad G = f grad F in these coordinates; nothing where the gradient of F may be zero.
  std::optional<Interval> factor_of(const std::vector<std::size_t>& coordinates) const
  {
    const std::array<Interval, 3> f = gradient(m_equations.envelope), g = gradient(m_equations.sight);
    Interval product(0), square(0);
    for (const std::size_t i : coordinates) {
      product += f[i] * g[i];
      square += f[i] * f[i];
    }
    return square.lower() > 0 ? std::optional(product / square) : std::nullopt;
  }

  // A second derivative of G - f F.
  Interval second(std::size_t i, std::size_t j, const Interval& factor) const
  {
    const auto form = [&](const Direction& direction) {
      return along(m_equations.sight, direction).second - factor * along(m_equations.envelope, direction).second;
    };
    Direction a{}, b{}, both{};
    a[i] = b[j] = 1;
    ++both[i];
    ++both[j];
    return (form(both) - form(a) - form(b)) / Interval(2);
  }
};

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SWEEP_SIGHT_H
