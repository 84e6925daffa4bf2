// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_DECIMAL_TEXT_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_DECIMAL_TEXT_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <array>
#include <charconv>
#include <cstddef>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The shortest decimal number that is read back as the same double, whatever the locale.
std::string double_text(double x);

// A number as a decimal: exactly if it has 60 decimals at most, else the text of the nearest double.
std::string decimal_text(const Exact_rational& x);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::string double_text(double x)
{
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x).ptr;
  return std::string(text.data(), end);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string decimal_text(const Exact_rational& x)
{
  constexpr int most_decimals = 60;
  Big_integer mantissa = abs(numerator_of(x));
  const Big_integer denominator = denominator_of(x);
  Big_integer power(1);
  std::size_t decimals = 0;
  for (; decimals < most_decimals && power % denominator != 0; ++decimals)
    power *= 10;
  if (power % denominator != 0)
    return double_text(to_nearest_double(x));
  mantissa *= power / denominator;
  std::string digits = mantissa.str();
  if (digits.size() <= decimals)
    digits.insert(0, decimals + 1 - digits.size(), '0');
  if (decimals > 0)
    digits.insert(digits.size() - decimals, 1, '.');
  return x < 0 ? '-' + digits : digits;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_DECIMAL_TEXT_H
