// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_MULTIPLE_ROOT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_MULTIPLE_ROOT_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Contact_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Double_root_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/point_values.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/matrix_inverse.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A rational solution that is not regular, and a box around it without any other one.
struct Multiple_root
{
  std::vector<Exact_rational> point;
  int multiplicity = 0;
  std::vector<double> lower, upper;

  template <class Coordinate>
  bool covers(const std::vector<Coordinate>& box_lower, const std::vector<Coordinate>& box_upper) const
  {
    for (std::size_t j = 0; j < lower.size(); ++j)
      if (box_lower[j] < Coordinate(lower[j]) || Coordinate(upper[j]) < box_upper[j])
        return false;
    return true;
  }
};

/*
The simplest fraction in a range, when its denominator is small: by continued fractions in doubles. It is a guess, and
rounding may make it a wrong one.
*/
inline std::optional<Exact_rational> short_rational_between(double lower, double upper)
{
  if (upper < 0) {
    const auto opposite = short_rational_between(-upper, -lower);
    return opposite ? std::optional(Exact_rational(-*opposite)) : std::nullopt;
  }
  if (lower <= 0)
    return Exact_rational(0);
  constexpr double largest_numerator = 0x1p50, largest_denominator = 0x1p22;
  double p0 = 0, p1 = 1, q0 = 1, q1 = 0;   // the last two convergents
  for (bool is_last = false; !is_last;) {
    const double whole = std::floor(lower);
    is_last = whole == lower || whole + 1 <= upper;
    const double digit = whole < lower && is_last ? whole + 1 : whole;
    p0 = std::exchange(p1, digit * p1 + p0);
    q0 = std::exchange(q1, digit * q1 + q0);
    if (!(p1 <= largest_numerator) || !(q1 <= largest_denominator))
      return std::nullopt;
    const double begin = lower - whole, end = upper - whole;
    lower = 1 / end;
    upper = 1 / begin;
  }
  return Exact_rational(p1) / Exact_rational(q1);
}

// The point is no solution, or a regular one: doubles tell this of most guesses.
inline bool is_certainly_not_multiple(const Constraint_system_d& system, const std::vector<Exact_rational>& point)
{
  const Rounded_values at_point(point);
  if (std::any_of(system.equalities().begin(), system.equalities().end(),
                  [&](const Spline_function& f) { return at_point.value(f).is_certainly_not_zero(); }))
    return true;
  const int n = static_cast<int>(point.size());
  std::vector<Derivative_range> ranges;
  std::vector<double> middle, inverse(n * n), entries(n);
  for (const Spline_function& function : system.equalities())
    for (const auto& [value, error] : at_point.gradient(function)) {
      ranges.emplace_back(value - error, value + error);
      middle.push_back(value);
    }
  bool is_regular = invert(n, middle, inverse);
  for (int j = 0; j < n && is_regular; ++j)
    is_regular = contraction_row(
                     n, n, j, inverse.data() + j * n,
                     [&](int i, int k) -> const Derivative_range& { return ranges[i * n + k]; }, entries.data()) < 0.5;
  return is_regular;
}

/*
The multiple root that is the simplest rational point of a box of doubles, with a Jacobian of rank n - 1, and alone in a
box around this one: as large as is proved, up to the size `widths`.
*/
inline std::optional<Multiple_root> multiple_root_in(const Constraint_system_d& system,
                                                     const std::vector<double>& lower, const std::vector<double>& upper,
                                                     const std::vector<double>& widths)
{
  const std::size_t n = lower.size();
  if (system.equalities().size() != n)
    return std::nullopt;
  Multiple_root result;
  result.point.reserve(n);
  for (std::size_t j = 0; j < n; ++j) {
    const auto coordinate = short_rational_between(lower[j], upper[j]);
    if (!coordinate)
      return std::nullopt;
    result.point.push_back(*coordinate);
  }
  if (is_certainly_not_multiple(system, result.point))
    return std::nullopt;
  for (const Spline_function& function : system.equalities())
    if (!CGAL::is_zero(evaluate_exactly(function, result.point)))
      return std::nullopt;
  const Double_root_test test(system, result.point);
  if (!test.has_corank_one())
    return std::nullopt;
  std::optional<Contact_test> contact;   // of higher order
  if (!test.is_double_root())
    contact.emplace(system, result.point, test.eliminated(), test.row_of());
  result.multiplicity = contact ? contact->order() : 2;
  if (result.multiplicity == 0)
    return std::nullopt;
  std::vector<double> centre, least(n), radius(n);
  for (std::size_t j = 0; j < n; ++j) {
    centre.push_back(CGAL::to_double(result.point[j]));
    least[j] = (std::max)(centre[j] - lower[j], upper[j] - centre[j]) * (1 + 1e-9) + std::abs(centre[j]) * 1e-15;
  }
  for (double share = 1; share >= 0x1p-20; share /= 4) {
    for (std::size_t j = 0; j < n; ++j)
      radius[j] = (std::max)(least[j], share * widths[j]);
    if (!(contact ? contact->is_alone(radius) : test.is_alone(radius)))
      continue;
    for (std::size_t j = 0; j < n; ++j) {   // inwards, whatever the rounding mode
      const double reach = radius[j] * (1 - 1e-12) - std::abs(centre[j]) * 1e-15;
      result.lower.push_back(centre[j] - reach);
      result.upper.push_back(centre[j] + reach);
    }
    return result;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_MULTIPLE_ROOT_H
