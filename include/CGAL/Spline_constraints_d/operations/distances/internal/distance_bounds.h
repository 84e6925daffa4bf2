// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DISTANCE_BOUNDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DISTANCE_BOUNDS_H

#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// The root of a number that is not negative, nearly, also if the number is too great or too small for a double.
double near_root(const Exact_rational& x);

// The closest doubles below and above the roots of the ends of a range. Outside of 2^-900 to 2^900, squares of roots
// would have other errors; there the range is larger.
std::pair<double, double> root_range(const std::pair<double, double>& squares);

// The same of exact ends, the closest doubles or those beside them; \pre they are not negative.
std::pair<double, double> root_range(const std::pair<Deferred_rational, Deferred_rational>& squares);

inline std::pair<double, double> root_range(const std::pair<Exact_rational, Exact_rational>& squares)
{
  return root_range(std::pair(Deferred_rational(squares.first), Deferred_rational(squares.second)));
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE double near_root(const Exact_rational& x)
{
  const Exact_rational most(to_rational(0x1p1000)), least(to_rational(0x1p-1000));
  if (x > most)
    return 0x1p500 * near_root(Exact_rational(x * least));
  if (x > 0 && x < least)
    return 0x1p-500 * near_root(Exact_rational(x * most));
  return std::sqrt(to_nearest_double(x));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<double, double> root_range(const std::pair<double, double>& squares)
{
  const auto& [low, high] = squares;
  const double lower_root = std::sqrt(low), upper_root = std::sqrt(high);
  const bool is_lower_exact = low > 0x1p-900, is_upper_exact = high == 0 || (high > 0x1p-900 && high < 0x1p900);
  return {!is_lower_exact                                  ? 0
              : std::fma(lower_root, lower_root, -low) > 0 ? std::nextafter(lower_root, 0.0)
                                                           : lower_root,
          is_upper_exact && std::fma(upper_root, upper_root, -high) >= 0
              ? upper_root
              : std::nextafter(upper_root, std::numeric_limits<double>::infinity())};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<double, double>
root_range(const std::pair<Deferred_rational, Deferred_rational>& squares)
{
  const double low = squares.first.double_interval().first, high = squares.second.double_interval().second;
  if (low > 0x1p-900 && high < 0x1p900)
    return root_range(std::pair(low, high));
  const auto square = [](double x) { return Exact_rational(to_rational(x) * to_rational(x)); };
  const Exact_rational least = squares.first.exact(), greatest = squares.second.exact();
  double lower = near_root(least), upper = near_root(greatest);
  while (std::isinf(lower) || (lower > 0 && square(lower) > least))
    lower = std::nextafter(lower, 0.0);
  while (!std::isinf(upper) && square(upper) < greatest)
    upper = std::nextafter(upper, std::numeric_limits<double>::infinity());
  return {lower, upper};
}
#endif

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DISTANCE_BOUNDS_H
