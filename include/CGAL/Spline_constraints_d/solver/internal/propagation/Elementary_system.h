// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_ELEMENTARY_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_ELEMENTARY_SYSTEM_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/numbers.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Common_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Constraints with elementary functions as constraints on polynomials, in which functions of one unknown occur as terms of
their own. What a function is taken of becomes an unknown that an equality defines, unless it is linear in one unknown;
so does a value that occurs in products, in other functions, or in many places. Values of numbers are numbers.
*/
class Elementary_system
{
  const std::vector<Elementary_value>& m_values;
  int m_unknowns;
  std::vector<Polynomial_constraint> m_constraints;
  std::vector<Power_polynomial> m_definitions; // of the unknowns that come after those of the constraints
  Elementary_terms m_terms;
  std::vector<int> m_names;          // unknowns in place of values, or -1
  std::vector<std::size_t> m_places; // where a value is a term of its own
  std::vector<char> m_is_factor;     // a value in products or in functions

  static constexpr int first = Elementary_values::first_index, common_name = first - 1;
  static constexpr std::size_t most_places = 2;

  // a function of scale * symbol + shift
  struct Linear_argument
  {
    int symbol;
    Interval scale, shift;
  };

public:
  // Of constraints on so many unknowns. `check()` may end the work by an exception.
  Elementary_system(int unknowns, const std::vector<Polynomial_constraint>& constraints,
                    const Elementary_values& values, const std::function<void()>& check)
    : m_values(values.all()), m_unknowns(unknowns), m_names(m_values.size(), -1), m_places(m_values.size(), 0),
      m_is_factor(m_values.size(), 0)
  {
    const Common_part common(constraints, common_name, check);
    m_constraints = common.constraints();
    m_terms.numbers = elementary::numbers_among(m_values);
    find_factors();
    std::optional<Power_polynomial> common_definition;
    if (common.is_found()) {
      common_definition = std::move(m_constraints.back().first);
      m_constraints.pop_back();
    }
    define_values(check);
    for (auto& [polynomial, relation] : m_constraints)
      polynomial = in_unknowns(polynomial);
    if (common_definition)
      m_definitions.push_back(in_unknowns(*common_definition));
    for (const Power_polynomial& definition : m_definitions)
      m_constraints.emplace_back(definition, Relation::EQUAL);
    name_common_part();
  }

  int dimension() const { return m_unknowns + defined(); }
  int defined() const { return static_cast<int>(m_definitions.size()); }
  // With the definitions at the end.
  const std::vector<Polynomial_constraint>& constraints() const { return m_constraints; }
  const Elementary_terms& terms() const { return m_terms; }

private:
  static bool is_value(int symbol) { return symbol >= first; }
  bool is_number(int symbol) const { return m_terms.numbers.contains(symbol); }

  void find_factors();
  void find_factors(const Power_polynomial& polynomial);
  void define_values(const std::function<void()>& check);
  std::optional<Linear_argument> linear_argument(const Power_polynomial& argument) const;
  Power_polynomial in_unknowns(const Power_polynomial& polynomial) const;
  void name_common_part();

  int unknown_of(int symbol) const { return is_value(symbol) ? m_names[symbol - first] : symbol; }

  // A new unknown, of which the definition is to be added.
  Power_polynomial next_unknown() const { return Power_polynomial::variable(dimension()); }
};

// Sets the ranges of defined unknowns to what those before them say; false when a function is defined nowhere.
bool set_defined_unknowns(const Sparse_system& system, Box_of_ranges& box);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_system::find_factors(const Power_polynomial& polynomial)
{
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    const auto factors = std::count_if(monomial.powers.begin(), monomial.powers.end(),
                                       [&](const auto& power) { return !is_number(power.first); });
    for (const auto& [symbol, exponent] : monomial.powers)
      if (is_value(symbol)) {
        ++m_places[symbol - first];
        if (factors > 1 || exponent > 1)
          m_is_factor[symbol - first] = 1;
      }
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_system::find_factors()
{
  for (const auto& [polynomial, relation] : m_constraints)
    find_factors(polynomial);
  for (std::size_t k = 0; k < m_values.size(); ++k)
    if (const auto linear = linear_argument(m_values[k].argument)) {
      if (is_value(linear->symbol))
        m_is_factor[linear->symbol - first] = 1;
    } else
      find_factors(m_values[k].argument);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Elementary_system::Linear_argument>
Elementary_system::linear_argument(const Power_polynomial& argument) const
{
  Linear_argument result{-1, Interval(1), Interval(0)};
  for (const auto& [monomial, coefficient] : elementary::without_numbers(argument, m_terms.numbers)) {
    if (monomial.powers.empty())
      result.shift = coefficient;
    else if (monomial.total_degree() == 1 && result.symbol < 0 && !has_zero(coefficient)) {
      result.symbol = monomial.powers.front().first;
      result.scale = coefficient;
    } else
      return std::nullopt;
  }
  return result.symbol < 0 ? std::nullopt : std::optional<Linear_argument>(result);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_system::define_values(const std::function<void()>& check)
{
  for (std::size_t k = 0; k < m_values.size(); ++k) {
    check();
    const int symbol = first + static_cast<int>(k);
    if (is_number(symbol))
      continue;
    Elementary_term function{elementary::operation_of(m_values[k])};
    if (const auto linear = linear_argument(m_values[k].argument)) {
      function.unknown = unknown_of(linear->symbol);
      function.scale = linear->scale;
      function.shift = linear->shift;
    } else {
      function.unknown = dimension();
      m_definitions.push_back(in_unknowns(m_values[k].argument) - next_unknown());
    }
    m_terms.functions[symbol] = function;
    if (m_is_factor[k] != 0 || m_places[k] == 0 || m_places[k] > most_places) {
      const Power_polynomial definition = Power_polynomial::variable(symbol) - next_unknown();
      m_names[k] = dimension();
      m_definitions.push_back(definition);
    }
  }
}

// The unknown for the common part keeps the index that it has got.
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Elementary_system::in_unknowns(const Power_polynomial& polynomial) const
{
  Power_polynomial result;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Monomial own;
    for (const auto& [symbol, exponent] : monomial.powers)
      own = own *
          Monomial{{{is_value(symbol) && m_names[symbol - first] >= 0 ? m_names[symbol - first] : symbol, exponent}}};
    result += polynomial_of_term(own, coefficient);
  }
  return result;
}

// The last one.
CGAL_SPLINE_CONSTRAINTS_INLINE void Elementary_system::name_common_part()
{
  for (auto& [polynomial, relation] : m_constraints)
    if (polynomial.degree(common_name) > 0)
      polynomial = polynomial.substituted(common_name, Power_polynomial::variable(dimension() - 1));
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool set_defined_unknowns(const Sparse_system& system, Box_of_ranges& box)
{
  box.resize(system.dimension(), Interval(0));
  const auto is_bounded = [&](int definition) {
    return std::ranges::all_of(system.occurrences(definition),
                               [&](const auto& occurrence) { return is_finite(box[occurrence.unknown]); });
  };
  for (int j = system.dimension() - system.defined(); j < system.dimension(); ++j) {
    const int definition = system.definition(j);
    box[j] = Interval(0);
    Interval range = elementary::entire_line();
    if (const auto parts = system.elementary_parts(definition);
        parts.size() == 1 && system.occurrences(definition).size() == 1) {
      const Elementary_term& function = system.function(parts[0].function);
      Interval argument = function.argument(box);
      if (!elementary::restrict_to_domain(function.operation, argument))
        return false;
      range = system.constant(definition) +
          parts[0].coefficient * elementary::range_of_values(function.operation, argument);
    } else if (is_bounded(definition))
      range = system.value(definition, box);
    box[j] = std::isnan(range.inf()) || std::isnan(range.sup()) ? elementary::entire_line() : range;
  }
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_ELEMENTARY_SYSTEM_H
