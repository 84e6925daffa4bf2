// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ARC_DIRECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ARC_DIRECTIONS_H

#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The sum, without taking splines on the same knots apart.
inline Exact_function quick_sum(const Exact_function& a, const Exact_function& b)
{
  if (a.degree(0) != b.degree(0) || a.knots(0) != b.knots(0))
    return a + b;
  std::vector<Exact_rational> coefficients = a.coefficients();
  for (std::size_t k = 0; k < coefficients.size(); ++k)
    coefficients[k] += b.coefficients()[k];
  return Exact_function(a.degrees(), {a.knots(0)}, std::move(coefficients));
}

// The inner product of a curve with a direction, times the weight.
template <int d>
Exact_function height_of(const Spline_patch<d>& arc, const Exact_vector<d>& direction)
{
  std::optional<Exact_function> result;
  for (int i = 0; i < d; ++i)
    if (direction[i] != 0) {
      const Exact_function term = arc.numerators()[i] * direction[i];
      result = result ? quick_sum(*result, term) : term;
    }
  return result ? *result : arc.numerators()[0] * Exact_rational(0);
}

// Whether <C, direction> increases strictly along a curve of one piece: its derivative is nowhere negative, and not
// zero everywhere.
template <int d>
bool is_increasing(const Spline_patch<d>& arc, const Exact_vector<d>& direction)
{
  const Exact_function height = height_of<d>(arc, direction);
  const Exact_function slope = arc.is_rational()
      ? height.derivative(0) * arc.weight() - height * arc.weight().derivative(0)
      : height.derivative(0);
  const auto [least, greatest] = slope.bounds();
  return least >= 0 && greatest > 0;
}

template <int d>
std::vector<Exact_vector<d>> axis_directions()
{
  std::vector<Exact_vector<d>> result;
  for (int i = 0; i < d; ++i)
    for (const int sign : {1, -1}) {
      result.emplace_back().fill(Exact_rational(0));
      result.back()[i] = Exact_rational(sign);
    }
  return result;
}

// From one end of a curve to the other, scaled so that the largest coordinate is 1.
template <int d>
Exact_vector<d> chord_of(const Spline_patch<d>& arc)
{
  const auto [begin, end] = arc.domain(0);
  const Exact_vector<d> from = arc(std::array{begin}), to = arc(std::array{end});
  Exact_vector<d> result;
  Exact_rational largest(0);
  for (int i = 0; i < d; ++i) {
    result[i] = Exact_rational(to[i] - from[i]);
    largest = (std::max)(largest, Exact_rational(CGAL::abs(result[i])));
  }
  if (largest > 0)
    for (Exact_rational& coordinate : result)
      coordinate /= largest;
  return result;
}

// A vector with positive inner products with both, unless they are opposite or zero.
template <int d>
Exact_vector<d> direction_between(const Exact_vector<d>& a, const Exact_vector<d>& b)
{
  const Exact_rational product = exact_dot(a, b), a_factor(exact_dot(b, b) - product),
                       b_factor(exact_dot(a, a) - product);
  Exact_vector<d> result;
  for (int i = 0; i < d; ++i)
    result[i] = Exact_rational(a[i] * a_factor + b[i] * b_factor);
  return exact_dot(result, a) > 0 ? result : a;   // zero if they are parallel
}

// Whether a line or plane is proved to lie between two curves. It is parallel to the chord of one of them, in space to
// both.
template <int d>
bool are_separated(const Spline_patch<d>& a, const Spline_patch<d>& b, const Exact_vector<d>& a_chord,
                   const Exact_vector<d>& b_chord)
{
  const auto is_between = [&](const Exact_vector<d>& normal) {
    const auto range = [&](const Spline_patch<d>& arc) {
      Vector_of_functions<d> heights;
      heights.fill(height_of<d>(arc, normal));
      return arc.with_numerators(std::move(heights)).values()[0];
    };
    const Rational_interval first = range(a), second = range(b);
    return first.upper < second.lower || second.upper < first.lower;
  };
  if constexpr (d == 2)
    return is_between({Exact_rational(-a_chord[1]), a_chord[0]}) ||
        is_between({Exact_rational(-b_chord[1]), b_chord[0]});
  else
    return is_between(exact_cross(a_chord, b_chord));
}

// Where the derivative of a curve of one piece is zero.
template <int d>
Solution_set_d<double> zeros_of_derivative(const Spline_patch<d>& arc, Budgeted_solver& solve)
{
  const auto [begin, end] = arc.domain(0);
  const std::vector<Unknown> t = unknowns({std::array<Bound, 2>{Bound(begin), Bound(end)}});
  const Vector_expression<d> tangent = Parametric_vector<d>(arc).tangent(0)(t);
  std::vector<Constraint> constraints;
  for (int i = 0; i < d; ++i)
    if (const Constraint constraint = tangent[i] == 0; !constraint.function.is_zero())
      constraints.push_back(constraint);
  return solve(constraints);
}

/*
Whether C' = 0 somewhere on a polynomial curve, and det(C''(s), C'''(t)) has the same sign for all s and t, in the plane
of two coordinates. Such a curve has one cusp C(c), and does not meet itself: by Taylor's formula det(C''(c), C'(t)) is
the integral of (t - r) det(C''(c), C'''(r)) from c to t, so that C moves strictly to one side of its tangent in the
cusp.
*/
template <int d>
bool has_simple_cusp(const Spline_patch<d>& arc, Budgeted_solver& solve)
{
  if (arc.is_rational())
    return false;
  Vector_bounds<d> second, third;
  for (int i = 0; i < d; ++i) {
    const Exact_function derivative = arc.numerators()[i].derivative(0).derivative(0);
    second[i] = Rational_interval(derivative.bounds());
    third[i] = Rational_interval(derivative.derivative_bounds(0));
  }
  bool has_one_sign = false;
  for (int i = 0; i < d; ++i)
    for (int k = 0; k < i; ++k) {
      const Rational_interval determinant = second[i] * third[k] - second[k] * third[i];
      has_one_sign = has_one_sign || determinant.lower > 0 || determinant.upper < 0;
    }
  if (!has_one_sign)
    return false;
  return zeros_of_derivative<d>(arc, solve).count(Solution_kind::CERTIFIED) == 1;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ARC_DIRECTIONS_H
