// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NEAR_FRACTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NEAR_FRACTION_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <cmath>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A number as a quotient with a positive denominator: a fraction of integers, or any double and 1.
struct Fraction
{
  double numerator = 0, denominator = 1;
};

// The first convergent of the continued fraction of a number that is not farther from it than the tolerance; none if
// its numerator or denominator is greater than the given one. Denominators grow at least like the powers of the golden
// ratio.
std::optional<Fraction> near_fraction(double x, double tolerance, double most);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Fraction> near_fraction(double x, double tolerance, double most)
{
  double p = 1, q = 0, last_p = 0, last_q = 1, rest = x;
  for (;;) {
    const double whole = std::floor(rest);
    last_p = std::exchange(p, whole * p + last_p);
    last_q = std::exchange(q, whole * q + last_q);
    if (!(std::abs(p) <= most && q <= most))
      return std::nullopt;
    if (std::abs(p - x * q) <= tolerance * q)
      return Fraction{p, q};
    rest = 1 / (rest - whole);
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NEAR_FRACTION_H
