// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_NUMBERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_NUMBERS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace elementary {

// What is known of values that are functions of numbers, by their indices.
using Numbers = std::map<int, Interval>;

// All that it is certain of that they are defined.
Numbers numbers_among(const std::vector<Elementary_value>& values);

// A polynomial as monomials with their coefficients, numbers multiplied out.
std::map<Monomial, Interval> without_numbers(const Power_polynomial& polynomial, const Numbers& numbers);

// The value of a polynomial in nothing but numbers; nothing for others.
std::optional<Interval> number_of(const Power_polynomial& polynomial, const Numbers& numbers);

inline Operation operation_of(const Elementary_value& value)
{
  const auto [lower, upper] = to_double_interval(value.exponent);
  return {value.function, Interval(lower, upper)};
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::map<Monomial, Interval> without_numbers(const Power_polynomial& polynomial,
                                                                            const Numbers& numbers)
{
  std::map<Monomial, Interval> result;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Monomial rest;
    const auto [lower, upper] = to_double_interval(coefficient);
    Interval multiple(lower, upper);
    for (const auto& [unknown, exponent] : monomial.powers)
      if (const auto place = numbers.find(unknown); place == numbers.end())
        rest.powers.emplace_back(unknown, exponent);
      else
        for (int e = 0; e < exponent; ++e)
          multiple *= place->second;
    if (const auto [place, is_new] = result.try_emplace(std::move(rest), multiple); !is_new)
      place->second += multiple;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Interval> number_of(const Power_polynomial& polynomial,
                                                                 const Numbers& numbers)
{
  if (!std::ranges::all_of(polynomial.variables(), [&](int unknown) { return numbers.contains(unknown); }))
    return std::nullopt;
  const auto terms = without_numbers(polynomial, numbers);
  return terms.empty() ? Interval(0) : terms.begin()->second;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Numbers numbers_among(const std::vector<Elementary_value>& values)
{
  Numbers result;
  int index = Elementary_values::first_index;
  for (const Elementary_value& value : values) {
    if (const auto argument = number_of(value.argument, result);
        argument && is_in_domain(operation_of(value), *argument))
      result.emplace(index, range_of_values(operation_of(value), *argument));
    ++index;
  }
  return result;
}
#endif

} // namespace elementary
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_NUMBERS_H
