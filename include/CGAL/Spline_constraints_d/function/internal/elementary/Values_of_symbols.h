// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_VALUES_OF_SYMBOLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_VALUES_OF_SYMBOLS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <map>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Polynomials in the symbols of a table as polynomials in its unknowns and values.
class Values_of_symbols
{
  const Symbol_table& m_symbols;
  Elementary_values& m_values;
  std::map<int, Power_polynomial> m_known;

public:
  Values_of_symbols(const Symbol_table& symbols, Elementary_values& values) : m_symbols(symbols), m_values(values) {}

  Power_polynomial operator()(const Power_polynomial& polynomial)
  {
    if (m_symbols.has_only_unknowns(polynomial))
      return polynomial;
    const std::vector<int> symbols = polynomial.variables();
    std::vector<Power_polynomial> values(symbols.back() + 1);
    for (const int s : symbols)
      values[s] = value_of(s);
    return polynomial.value(std::span<const Power_polynomial>(values));
  }

private:
  const Power_polynomial& value_of(int index)
  {
    if (const auto known = m_known.find(index); known != m_known.end())
      return known->second;
    return m_known[index] = computed(index);
  }

  Power_polynomial computed(int index)
  {
    const Symbol& symbol = m_symbols[index];
    switch (symbol.kind) {
    case Symbol::Kind::UNKNOWN:
      break;
    case Symbol::Kind::FORMULA:
      return (*this)(symbol.formula);
    case Symbol::Kind::VALUE: {
      const Power_polynomial argument = (*this)(symbol.formula);
      return symbol.function == Elementary_function::POWER ? m_values.power(argument, symbol.exponent)
                                                           : m_values.value(symbol.function, argument);
    }
    case Symbol::Kind::SPLINE:
      return polynomial_of_spline(symbol);
    case Symbol::Kind::WITHOUT_RANGE:
      throw Invalid_input("an unknown without a range");
    }
    return Power_polynomial::variable(index);
  }

  Power_polynomial polynomial_of_spline(const Symbol& symbol) const
  {
    if (symbol.spline->pieces().size() > 1)
      throw Invalid_input("a spline of several pieces together with elementary functions");
    std::vector<Exact_rational> place;
    std::vector<Power_polynomial> unknowns;
    for (const int u : symbol.unknowns) {
      place.push_back(m_symbols.domains()[u].first);
      unknowns.push_back(Power_polynomial::variable(u));
    }
    return symbol.spline->value(std::span<const Exact_rational>(place), std::span<const Power_polynomial>(unknowns));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_VALUES_OF_SYMBOLS_H
