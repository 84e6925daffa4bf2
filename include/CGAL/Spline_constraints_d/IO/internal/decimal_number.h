// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_DECIMAL_NUMBER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_DECIMAL_NUMBER_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Most digits that a number may have when it is written out without an exponent: enough for any coefficient of a
// polynomial.
inline constexpr long maximal_number_of_digits = 20000;

/*
The exact value of an unsigned decimal number: digits with at most one point among them, then, possibly, an exponent (e
or E). Throws Invalid_input when it has too many digits or the budget is used up.
*/
Exact_rational decimal_number(std::string_view text, Expansion_budget& budget);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational decimal_number(std::string_view text, Expansion_budget& budget)
{
  const std::size_t e = text.find_first_of("eE");
  std::string digits;
  long decimals = 0;
  bool after_point = false;
  for (const char c : text.substr(0, e)) {
    if (c == '.') {
      after_point = true;
      continue;
    }
    if (!digits.empty() || c != '0')
      digits += c;
    decimals += after_point ? 1 : 0;
  }
  long exponent = 0;
  if (e != std::string_view::npos) {
    const bool is_negative = text[e + 1] == '-';
    for (const char c : text.substr(e + 1))
      if (c != '-' && c != '+' && exponent <= 2 * maximal_number_of_digits)
        exponent = 10 * exponent + (c - '0');
    exponent = is_negative ? -exponent : exponent;
  }
  if (static_cast<long>(digits.size()) > maximal_number_of_digits || decimals > maximal_number_of_digits ||
      exponent > maximal_number_of_digits || exponent < -maximal_number_of_digits)
    throw Invalid_input("a number of more than " + std::to_string(maximal_number_of_digits) + " digits");
  if (digits.empty())
    return Exact_rational(0);
  const double words =
      static_cast<double>(static_cast<long>(digits.size()) + decimals + (exponent < 0 ? -exponent : exponent)) / 19;
  budget.spend(arithmetic_work(words, words));
  Big_integer mantissa, power;
  mpz_set_str(mantissa.backend().data(), digits.c_str(), 10);
  exponent -= decimals;
  mpz_ui_pow_ui(power.backend().data(), 10, static_cast<unsigned long>(exponent < 0 ? -exponent : exponent));
  if (exponent < 0)
    return scaled_rational(mantissa, 0) / scaled_rational(power, 0);
  return scaled_rational(mantissa * power, 0);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_DECIMAL_NUMBER_H
