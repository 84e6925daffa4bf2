// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_JETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_JETS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace elementary {

// A value and its derivatives by the unknowns; those that are zero are left out.
template <class NT>
struct Jet
{
  NT value;
  std::map<int, NT> gradient = {};
};

template <class NT>
void add_multiple(std::map<int, NT>& sum, const NT& factor, const std::map<int, NT>& gradient)
{
  for (const auto& [unknown, derivative] : gradient)
    if (const auto [place, is_new] = sum.try_emplace(unknown, factor * derivative); !is_new)
      place->second += factor * derivative;
}

// A polynomial in unknowns and values, by the rule of products. `number(c)` is a coefficient in these numbers.
template <class NT, class Number>
Jet<NT> jet_of(const Power_polynomial& polynomial, std::span<const NT> point, const std::vector<Jet<NT>>& values,
               const Number& number)
{
  Jet<NT> result{number(Exact_rational(0))};
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Jet<NT> term{number(coefficient)};
    for (const auto& [symbol, exponent] : monomial.powers) {
      const bool is_value = symbol >= Elementary_values::first_index;
      const Jet<NT> factor = is_value ? values.at(symbol - Elementary_values::first_index)
                                      : Jet<NT>{point[symbol], {{symbol, number(Exact_rational(1))}}};
      for (int e = 0; e < exponent; ++e) {
        for (auto& [unknown, derivative] : term.gradient)
          derivative *= factor.value;
        add_multiple(term.gradient, term.value, factor.gradient);
        term.value *= factor.value;
      }
    }
    result.value += term.value;
    add_multiple(result.gradient, number(Exact_rational(1)), term.gradient);
  }
  return result;
}

/*
All values, one after the other. `function(value, x)` has a value and, where it has one, a derivative; nothing where a
function is not known to be defined. Nothing then, and where a derivative is missing, but of numbers.
*/
template <class NT, class Number, class Function>
std::optional<std::vector<Jet<NT>>> jets_of_values(const Elementary_values& values, std::span<const NT> point,
                                                   const Number& number, const Function& function)
{
  std::vector<Jet<NT>> result;
  for (const Elementary_value& value : values.all()) {
    const Jet<NT> argument = jet_of(value.argument, point, result, number);
    const auto known = function(value, argument.value);
    if (!known || (!known->derivative && !argument.gradient.empty()))
      return std::nullopt;
    Jet<NT>& jet = result.emplace_back(Jet<NT>{known->value});
    if (known->derivative)
      add_multiple(jet.gradient, *known->derivative, argument.gradient);
  }
  return result;
}

} // namespace elementary
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_JETS_H
