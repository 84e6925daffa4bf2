// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_TERMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_TERMS_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <locale>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The terms of a polynomial in power form with their coefficients, none of them zero.
using Polynomial_terms = std::map<Monomial, Exact_rational>;

// The unknown with the largest index; -1 when there is none.
int largest_variable(const Polynomial_terms& terms);

// The largest exponent of every unknown that occurs.
std::map<int, int> degrees_of(const Polynomial_terms& terms);

// The value at a point, in the numbers of a ring that rationals convert to.
template <class NT>
NT value_of(const Polynomial_terms& terms, std::span<const NT> point)
{
  if (const int last = largest_variable(terms); last >= 0 && static_cast<std::size_t>(last) >= point.size())
    throw Invalid_input("Power_polynomial: a point of " + std::to_string(point.size()) + " coordinates, but unknown " +
                        std::to_string(last) + " occurs");
  std::map<std::pair<int, int>, NT> powers;   // each power of a coordinate is computed once
  NT result(Exact_rational(0));
  for (const auto& [monomial, coefficient] : terms) {
    NT value(coefficient);
    for (const auto& power_of_unknown : monomial.powers) {
      auto position = powers.find(power_of_unknown);
      if (position == powers.end()) {
        NT power(Exact_rational(1)), square(point[static_cast<std::size_t>(power_of_unknown.first)]);
        for (int rest = power_of_unknown.second; rest > 0; rest >>= 1) {
          if (rest & 1)
            power *= square;
          if (rest > 1)
            square *= square;
        }
        position = powers.emplace(power_of_unknown, power).first;
      }
      value *= position->second;
    }
    result += value;
  }
  return result;
}

// The formula with the given names of the unknowns.
std::string formula_of(const Polynomial_terms& terms, std::span<const std::string> names);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE int largest_variable(const Polynomial_terms& terms)
{
  int result = -1;
  for (const auto& [monomial, coefficient] : terms)
    if (!monomial.powers.empty())
      result = (std::max)(result, monomial.powers.back().first);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::map<int, int> degrees_of(const Polynomial_terms& terms)
{
  std::map<int, int> result;
  for (const auto& [monomial, coefficient] : terms)
    for (const auto& [variable, exponent] : monomial.powers) {
      int& largest = result[variable];
      largest = (std::max)(largest, exponent);
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string formula_of(const Polynomial_terms& terms, std::span<const std::string> names)
{
  if (const int last = largest_variable(terms); last >= 0 && static_cast<std::size_t>(last) >= names.size())
    throw Invalid_input("Power_polynomial: " + std::to_string(names.size()) + " names, but unknown " +
                        std::to_string(last) + " occurs");
  std::ostringstream out;
  out.imbue(std::locale::classic());
  for (const auto& [monomial, coefficient] : terms) {
    const bool is_negative = CGAL::is_negative(coefficient);
    if (&coefficient == &terms.begin()->second)
      out << (is_negative ? "-" : "");
    else
      out << (is_negative ? " - " : " + ");
    const Exact_rational size = is_negative ? Exact_rational(-coefficient) : coefficient;
    const bool shows_coefficient = monomial.powers.empty() || size != Exact_rational(1);
    if (shows_coefficient)
      out << numerator_of(size);
    if (const Big_integer denominator = denominator_of(size); denominator != 1)
      out << '/' << denominator;
    for (std::size_t i = 0; i < monomial.powers.size(); ++i) {
      out << (i > 0 || shows_coefficient ? "*" : "") << names[static_cast<std::size_t>(monomial.powers[i].first)];
      if (monomial.powers[i].second > 1)
        out << '^' << monomial.powers[i].second;
    }
  }
  return terms.empty() ? "0" : out.str();
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_TERMS_H
