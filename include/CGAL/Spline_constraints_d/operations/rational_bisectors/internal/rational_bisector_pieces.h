// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_RATIONAL_BISECTOR_PIECES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_RATIONAL_BISECTOR_PIECES_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/unit_normal_of_piece.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/double_ranges.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

using Polynomial_vector = std::array<Power_polynomial, 3>;

// A point, or a polynomial piece of a curve or surface, in parameters that run from 0 to 1.
struct Polynomial_piece
{
  std::vector<Bisector_range> domain;
  Homogeneous_polynomials coordinates;

  Polynomial_vector numerators() const { return {coordinates[0], coordinates[1], coordinates[2]}; }
  const Power_polynomial& weight() const { return coordinates[3]; }
};

// All of them, in parameters numbered from `first` on.
inline std::vector<Polynomial_piece> pieces_in_powers(const Exact_map<3>& map, int first = 0)
{
  std::vector<std::vector<Bisector_range>> boxes(1);
  for (int axis = 0; axis < map.numerators[0].dimension(); ++axis) {
    std::vector<Exact_rational> breaks = map.is_rational ? map.weight.breaks(axis) : map.numerators[0].breaks(axis);
    for (const auto& f : map.numerators)
      breaks = united(breaks, f.breaks(axis));
    std::vector<std::vector<Bisector_range>> finer;
    for (const auto& box : boxes)
      for (std::size_t b = 1; b < breaks.size(); ++b) {
        finer.push_back(box);
        finer.back().emplace_back(breaks[b - 1], breaks[b]);
      }
    boxes = std::move(finer);
  }
  std::vector<Polynomial_piece> result;
  for (const auto& box : boxes) {
    const auto within_box = [&](Bspline_function<Exact_rational> f) {
      for (std::size_t axis = 0; axis < box.size(); ++axis)
        f = f.restricted(static_cast<int>(axis), box[axis].first, box[axis].second);
      return polynomial_of(f.bezier_pieces().front(), first);
    };
    Polynomial_piece& piece = result.emplace_back(Polynomial_piece{box, {}});
    for (const auto& f : map.numerators)
      piece.coordinates.push_back(within_box(f));
    piece.coordinates.push_back(map.is_rational ? within_box(map.weight) : Power_polynomial(1));
  }
  return result;
}

inline Power_polynomial dot(const Polynomial_vector& a, const Polynomial_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Polynomial_vector cross(const Polynomial_vector& a, const Polynomial_vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Polynomial_vector operator*(const Power_polynomial& f, const Polynomial_vector& a)
{
  return {f * a[0], f * a[1], f * a[2]};
}

inline Polynomial_vector operator+(const Polynomial_vector& a, const Polynomial_vector& b)
{
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

inline Polynomial_vector operator-(const Polynomial_vector& a, const Polynomial_vector& b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

inline bool is_zero(const Polynomial_vector& a) { return a[0].is_zero() && a[1].is_zero() && a[2].is_zero(); }

// In the lowest degree.
inline Homogeneous_polynomials reduced(const Polynomial_vector& numerators, const Power_polynomial& weight)
{
  return without_common_factors({numerators[0], numerators[1], numerators[2], weight});
}

// The derivative of a curve X / w by its own parameter, times w^2.
inline Polynomial_vector scaled_tangent(const Polynomial_piece& curve, int parameter)
{
  const auto& [begin, end] = curve.domain[0];
  const Power_polynomial slope(Exact_rational(1 / Exact_rational(end - begin)));
  const Power_polynomial &w = curve.weight(), dw = slope * w.derivative(parameter);
  Polynomial_vector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = slope * w * curve.coordinates[i].derivative(parameter) - dw * curve.coordinates[i];
  return result;
}

inline std::string ranges_in_words(const std::vector<Bisector_range>& domain)
{
  std::string result;
  for (const auto& [begin, end] : domain)
    result += (result.empty() ? "[" : " x [") + shortest_text(to_nearest_double(begin)) + ", " +
        shortest_text(to_nearest_double(end)) + "]";
  return result;
}

/*
A point Q and a surface X / w with a normal n: with e = X - w Q,

  P = Q + (2 <e,n> e - |e|^2 n) / (2 w <e,n>).
*/
inline Homogeneous_polynomials bisector_of_point_and_surface(const Polynomial_vector& q, const Polynomial_vector& x,
                                                             const Power_polynomial& w, const Polynomial_vector& n,
                                                             const std::string& who)
{
  const Polynomial_vector e = x - w * q;
  const Power_polynomial height = Power_polynomial(2) * dot(e, n), weight = w * height;
  if (height.is_zero())
    throw Invalid_input(who + " pass through the point");
  return reduced(weight * q + height * e - dot(e, e) * n, weight);
}

// With the normal in the lowest degree.
inline Homogeneous_polynomials bisector_of_point_and_surface(const Polynomial_piece& point,
                                                             const Polynomial_piece& surface)
{
  const Homogeneous_polynomials normal = normal_of(surface.coordinates);
  if (is_zero({normal[0], normal[1], normal[2]}))
    throw Invalid_input("point_surface_bisector: the piece " + ranges_in_words(surface.domain) +
                        " is a curve or a point");
  const Homogeneous_polynomials direction = without_common_factors(normal);
  return bisector_of_point_and_surface(
      point.numerators(), surface.numerators(), surface.weight(), {direction[0], direction[1], direction[2]},
      "point_surface_bisector: all tangent planes of the piece " + ranges_in_words(surface.domain));
}

// A sheet of the bisector of a sphere and a surface, and its foot on the sphere.
struct Sphere_bisector_piece
{
  Homogeneous_polynomials bisector, foot;
};

/*
The sphere around Q of radius r, and a surface with the unit normal n / l: the bisector of Q and the offset X / w of the
surface at the distance -r. With e = X - w Q, the foot on the sphere, at the distance r from Q towards P, is

  Q + r (|e|^2 n - 2 <e,n> e) / (l |e|^2).
*/
inline Sphere_bisector_piece bisector_of_sphere_and_surface(const Polynomial_piece& center,
                                                            const Exact_rational& radius,
                                                            const Polynomial_piece& surface)
{
  const std::optional<Unit_normal> normal = unit_normal(surface.coordinates);
  const std::string piece = "the piece " + ranges_in_words(surface.domain);
  if (!normal)
    throw Invalid_input("sphere_surface_bisector: " + piece + " has no rational unit normal");
  const Homogeneous_polynomials offset =
      without_common_factors(piece_at_distance(surface.coordinates, *normal, Exact_rational(-radius)));
  const Polynomial_vector q = center.numerators(), x{offset[0], offset[1], offset[2]};
  const Polynomial_vector n{normal->direction[0], normal->direction[1], normal->direction[2]}, e = x - offset[3] * q;
  const Power_polynomial r(radius), squared_e = dot(e, e), weight = normal->length * squared_e;
  return {bisector_of_point_and_surface(q, x, offset[3], n,
                                        "sphere_surface_bisector: all tangent planes of the offset of " + piece),
          reduced(weight * q + r * squared_e * n - Power_polynomial(2) * r * dot(e, n) * e, weight)};
}

/*
The point and the curve X / w: with e = X - w Q, the tangent t and d = t x e, the direction of the lines of the
bisector,

  P = Q + (<e,t> |e|^2 t + (|t|^2 |e|^2 - 2 <e,t>^2) e) / (2 w |d|^2) + lambda d.
*/
inline Homogeneous_polynomials bisector_of_point_and_curve(const Polynomial_piece& point, const Polynomial_piece& curve,
                                                           const Bisector_range& lambda)
{
  const Polynomial_vector q = point.numerators(), e = curve.numerators() - curve.weight() * q;
  const Polynomial_vector t = scaled_tangent(curve, 0), d = cross(t, e);
  if (is_zero(d))
    throw Invalid_input("point_curve_bisector_surface: the piece " + ranges_in_words(curve.domain) +
                        " is on a line through the point");
  const Power_polynomial step = Power_polynomial(lambda.first) +
      Power_polynomial(Exact_rational(lambda.second - lambda.first)) * Power_polynomial::variable(1);
  const Power_polynomial et = dot(e, t), ee = dot(e, e), weight = Power_polynomial(2) * curve.weight() * dot(d, d);
  return reduced(weight * (q + step * d) + et * ee * t + (dot(t, t) * ee - Power_polynomial(2) * et * et) * e, weight);
}

/*
Two curves X / w and Y / v with tangents s, t: the point in both normal planes and in the plane in the middle of X / w
and Y / v,

  w <P,s> = <X,s>,   v <P,t> = <Y,t>,   2 w v <P, v X - w Y> = v^2 |X|^2 - w^2 |Y|^2,

by Cramer's rule.
*/
inline Homogeneous_polynomials bisector_of_curves(const Polynomial_piece& first, const Polynomial_piece& second)
{
  const Polynomial_vector x = first.numerators(), y = second.numerators();
  const Power_polynomial &w = first.weight(), &v = second.weight();
  const Polynomial_vector s = scaled_tangent(first, 0), t = scaled_tangent(second, 1);
  const Polynomial_vector a = w * s, b = v * t, c = Power_polynomial(2) * w * v * (v * x - w * y), bc = cross(b, c);
  const Power_polynomial determinant = dot(a, bc);
  if (determinant.is_zero())
    throw Invalid_input("curve_bisector_surface: the pieces " + ranges_in_words(first.domain) + " and " +
                        ranges_in_words(second.domain) +
                        " are in one plane, or one of them is a point; "
                        "in a plane, bisector_curves() is the operation for them");
  return reduced(dot(x, s) * bc + dot(y, t) * cross(c, a) + (v * v * dot(x, x) - w * w * dot(y, y)) * cross(a, b),
                 determinant);
}

inline Rational_bisector_piece_3::Coordinates bernstein_coordinates(const Homogeneous_polynomials& f)
{
  std::vector<int> degrees(2, 0);
  for (const Power_polynomial& coordinate : f)
    for (const int axis : {0, 1})
      degrees[axis] = (std::max)(degrees[axis], coordinate.degree(axis));
  return {tensor_of(f[0], degrees), tensor_of(f[1], degrees), tensor_of(f[2], degrees), tensor_of(f[3], degrees)};
}

inline Undecided_part undecided_part(const Polynomial_piece& first, const Polynomial_piece& second,
                                     Undecided_reason reason)
{
  Undecided_part result{{}, {}, in_words(reason)};
  for (const std::size_t operand : {0, 1}) {
    const Polynomial_piece& piece = operand == 0 ? first : second;
    if (piece.domain.empty())
      continue;
    result.parameters.push_back({operand, {}});
    for (const Bisector_range& range : piece.domain)
      result.parameters.back().ranges.push_back(double_range(range));
  }
  return result;
}

// A piece whose feet are the points of the operands.
inline Rational_bisector_piece_3 piece_of_operands(const std::array<Bisector_range, 2>& domain,
                                                   const Homogeneous_polynomials& bisector,
                                                   const Polynomial_piece& first, const Polynomial_piece& second)
{
  return {domain,
          bernstein_coordinates(bisector),
          {bernstein_coordinates(first.coordinates), bernstein_coordinates(second.coordinates)}};
}

// `formula(domain, first, second)` for all pairs of pieces; `own` are the ranges of parameters that no operand has.
template <class Formula>
Rational_bisector_3 bisector_of_pieces(const std::vector<Polynomial_piece>& first_pieces,
                                       const std::vector<Polynomial_piece>& second_pieces,
                                       const std::vector<Bisector_range>& own, const Formula& formula,
                                       const Solver_options& options)
{
  Run_of_steps run(options);
  std::vector<Rational_bisector_piece_3> result;
  std::vector<Undecided_part> undecided;
  for (const Polynomial_piece& first : first_pieces)
    for (const Polynomial_piece& second : second_pieces) {
      if (run.must_stop()) {
        undecided.push_back(undecided_part(first, second, run.reason()));
        continue;
      }
      std::vector<Bisector_range> domain = first.domain;
      domain.insert(domain.end(), second.domain.begin(), second.domain.end());
      domain.insert(domain.end(), own.begin(), own.end());
      result.push_back(formula({domain[0], domain[1]}, first, second));
      run.add_progress(1.0 / static_cast<double>(first_pieces.size() * second_pieces.size()));
    }
  const Summary summary = run.summary(undecided.empty());
  return {std::move(result), std::move(undecided), summary};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_bisector_3 point_surface_bisector(const Exact_map<3>& point,
                                                                          const Exact_map<3>& surface,
                                                                          const Solver_options& options)
{
  const auto formula = [](const std::array<Bisector_range, 2>& domain, const Polynomial_piece& first,
                          const Polynomial_piece& second) {
    return piece_of_operands(domain, bisector_of_point_and_surface(first, second), first, second);
  };
  return bisector_of_pieces(pieces_in_powers(point), pieces_in_powers(surface), {}, formula, options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_bisector_3 sphere_surface_bisector(const Exact_map<3>& center,
                                                                           const Exact_rational& radius,
                                                                           const Exact_map<3>& surface,
                                                                           const Solver_options& options)
{
  const auto formula = [&](const std::array<Bisector_range, 2>& domain, const Polynomial_piece& first,
                           const Polynomial_piece& second) {
    const auto [bisector, foot] = bisector_of_sphere_and_surface(first, radius, second);
    return Rational_bisector_piece_3(domain, bernstein_coordinates(bisector),
                                     {bernstein_coordinates(foot), bernstein_coordinates(second.coordinates)});
  };
  return bisector_of_pieces(pieces_in_powers(center), pieces_in_powers(surface), {}, formula, options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_bisector_3 point_curve_bisector(const Exact_map<3>& point,
                                                                        const Exact_map<3>& curve,
                                                                        const Bisector_range& lambda,
                                                                        const Solver_options& options)
{
  const auto formula = [&](const std::array<Bisector_range, 2>& domain, const Polynomial_piece& first,
                           const Polynomial_piece& second) {
    return piece_of_operands(domain, bisector_of_point_and_curve(first, second, lambda), first, second);
  };
  return bisector_of_pieces(pieces_in_powers(point), pieces_in_powers(curve), {lambda}, formula, options);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_bisector_3 curve_bisector(const Exact_map<3>& first, const Exact_map<3>& second,
                                                                  const Solver_options& options)
{
  const auto formula = [](const std::array<Bisector_range, 2>& domain, const Polynomial_piece& a,
                          const Polynomial_piece& b) {
    return piece_of_operands(domain, bisector_of_curves(a, b), a, b);
  };
  return bisector_of_pieces(pieces_in_powers(first), pieces_in_powers(second, 1), {}, formula, options);
}

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_RATIONAL_BISECTOR_PIECES_H
