// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SYMBOL_TABLE_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SYMBOL_TABLE_H

#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

The closed ranges of all unknowns that were made by one call of `unknowns()`, in their order.
*/
using Unknown_domains = std::vector<std::pair<Exact_rational, Exact_rational>>;

namespace internal {

// Defined in Elementary_values.h.
std::optional<Exact_rational> rational_value_of(Elementary_function function, const Exact_rational& exponent,
                                                const Exact_rational& x);
bool is_defined_at(Elementary_function function, const Exact_rational& exponent, const Exact_rational& x);

/*
What the indices in the polynomial of a formula mean. The first are the unknowns with a range; then come, in the order
of their first use, splines of unknowns, formulas that something was divided by, unknowns without a range, and values of
elementary functions. What these are taken of is divided by means of reciprocals, which are values, too.
*/
struct Symbol
{
  enum class Kind
  {
    UNKNOWN,
    SPLINE,
    FORMULA,
    WITHOUT_RANGE,
    VALUE
  };
  Kind kind = Kind::UNKNOWN;
  std::vector<int> unknowns;                       // that a spline depends on, one for each of its axes
  std::shared_ptr<const Integer_spline> spline;    // in the ranges of these unknowns
  std::shared_ptr<const Integer_spline> source;    // what the spline was made of
  std::vector<int> source_unknowns;
  Power_polynomial formula; // in symbols of smaller index; of a value, what it is taken of
  Elementary_function function = Elementary_function::RECIPROCAL; // of a value
  Exact_rational exponent;                                        // of a value that is a power
  int sign = 0;                                    // +1 or -1 where this is proved on the whole domain
};

/*
The symbols of all formulas in the unknowns of one call of `unknowns()`. Equal ones are entered once, which makes common
factors and common subexpressions visible. Entries never change, so references to them stay valid; threads may use a
table at the same time.
*/
class Symbol_table
{
  const Unknown_domains m_domains;
  mutable std::mutex m_mutex;
  std::deque<Symbol> m_symbols;

public:
  explicit Symbol_table(Unknown_domains domains);

  const Unknown_domains& domains() const { return m_domains; }

  bool is_unknown(int index) const { return static_cast<std::size_t>(index) < m_domains.size(); }

  const Symbol& operator[](int index) const;

  int size() const;

  // A spline with an unknown for each of its axes, whose ranges lie within its domain: a symbol, or a constant. `sign`,
  // unless 0, was proved of it.
  Power_polynomial spline_of_unknowns(const std::shared_ptr<const Integer_spline>& source,
                                      const std::vector<int>& unknowns, int sign);

  int enter_formula(const Power_polynomial& formula);

  int enter_unknown_without_range();

  int enter_value(Elementary_function function, const Exact_rational& exponent, const Power_polynomial& argument);

  // A polynomial in the symbols of a table without unknowns, in those of this one.
  Power_polynomial imported(const Power_polynomial& polynomial, const Symbol_table& from);

  bool has_values(const Power_polynomial& polynomial) const { return !values_in(polynomial).empty(); }

  // Throws when an unknown occurs in what a function is taken of, and says where that is not possible.
  void require_outside_of_values(int unknown, const Power_polynomial& polynomial, const std::string& where) const;

  // Throws when a value of an elementary function occurs, and says where that is not possible.
  void require_no_values(const Power_polynomial& polynomial, const std::string& where) const;

  // The polynomial with formulas in place of the symbols that stand for them.
  Power_polynomial without_formulas(Power_polynomial polynomial) const;

  bool has_only_unknowns(const Power_polynomial& polynomial) const;

  // The value at a point. Throws when a symbol has none.
  Exact_rational value(const Power_polynomial& polynomial, std::span<const Exact_rational> point) const
  {
    return value(polynomial, point, point);
  }

  // The same with the numbers of a ring that rationals convert to, of the pieces of splines that a place is in.
  template <class NT>
  NT value(const Power_polynomial& polynomial, std::span<const Exact_rational> place, std::span<const NT> point) const
  {
    if (point.size() != m_domains.size())
      throw Invalid_input("Expression: a point with " + std::to_string(point.size()) + " coordinates for " +
                          std::to_string(m_domains.size()) + " unknowns");
    std::vector<std::optional<NT>> known(point.begin(), point.end());
    known.resize(size());
    return value(polynomial, place, known);
  }

private:
  Symbol& add(Symbol::Kind kind);

  // The values that a polynomial needs.
  std::vector<int> values_in(const Power_polynomial& polynomial) const;

  template <class NT>
  NT value(const Power_polynomial& polynomial, std::span<const Exact_rational> place,
           std::vector<std::optional<NT>>& known) const
  {
    const std::vector<int> symbols = polynomial.variables();
    std::vector<NT> values(symbols.empty() ? 0 : symbols.back() + 1, NT(Exact_rational(0)));
    for (int s : symbols) {
      if (!known[s])
        known[s] = value_of_symbol(s, place, known);
      values[s] = *known[s];
    }
    return polynomial.value(std::span<const NT>(values));
  }

  template <class NT>
  NT value_of_symbol(int index, std::span<const Exact_rational> place, std::vector<std::optional<NT>>& known) const
  {
    const Symbol& symbol = (*this)[index];
    if (symbol.kind == Symbol::Kind::WITHOUT_RANGE)
      throw Invalid_input("Expression: an unknown without a range has no value");
    if (symbol.kind == Symbol::Kind::FORMULA)
      return value(symbol.formula, place, known);
    if (symbol.kind == Symbol::Kind::VALUE)
      return value_of_function(symbol, place, known);
    std::vector<Exact_rational> place_of_parameters;
    std::vector<NT> parameters;
    for (int u : symbol.unknowns) {
      place_of_parameters.push_back(place[u]);
      parameters.push_back(*known[u]);
    }
    return symbol.spline->value(std::span<const Exact_rational>(place_of_parameters), std::span<const NT>(parameters));
  }

  template <class NT>
  NT value_of_function(const Symbol& symbol, std::span<const Exact_rational> place,
                       std::vector<std::optional<NT>>& known) const
  {
    if constexpr (std::same_as<NT, Exact_rational>) {
      const NT argument = value(symbol.formula, place, known);
      if (!is_defined_at(symbol.function, symbol.exponent, argument))
        throw Invalid_input("Expression: " + in_words(symbol.function) + " is not defined at the point of evaluation");
      if (const auto result = rational_value_of(symbol.function, symbol.exponent, argument))
        return *result;
    }
    throw Invalid_input("Expression: the value of " + in_words(symbol.function) + " is no rational number");
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Symbol_table::Symbol_table(Unknown_domains domains) : m_domains(std::move(domains))
{
  for (const auto& [lower, upper] : m_domains)
    add(Symbol::Kind::UNKNOWN).sign = lower > 0 ? 1 : upper < 0 ? -1 : 0;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Symbol& Symbol_table::operator[](int index) const
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  return m_symbols[index];
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Symbol_table::size() const
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  return static_cast<int>(m_symbols.size());
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Symbol_table::spline_of_unknowns(
    const std::shared_ptr<const Integer_spline>& source, const std::vector<int>& unknowns, int sign)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  const auto position = std::find_if(m_symbols.begin(), m_symbols.end(), [&](const Symbol& s) {
    return s.source == source && s.source_unknowns == unknowns && s.sign == sign;
  });
  if (position != m_symbols.end())
    return Power_polynomial::variable(static_cast<int>(position - m_symbols.begin()));

  Integer_spline restricted = *source;
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    restricted =
        restricted.restricted(static_cast<int>(j), m_domains[unknowns[j]].first, m_domains[unknowns[j]].second);
  if (restricted.is_constant())
    return restricted.constant();
  auto [axes, spline] = restricted.without_trivial_axes();
  std::vector<int> own_unknowns;
  for (int axis : axes)
    own_unknowns.push_back(unknowns[axis]);
  for (std::size_t i = m_domains.size(); i < m_symbols.size(); ++i)
    if (m_symbols[i].kind == Symbol::Kind::SPLINE && m_symbols[i].unknowns == own_unknowns &&
        m_symbols[i].sign == sign && *m_symbols[i].spline == spline)
      return Power_polynomial::variable(static_cast<int>(i));
  Symbol& symbol = add(Symbol::Kind::SPLINE);
  symbol.unknowns = std::move(own_unknowns);
  symbol.spline = std::make_shared<const Integer_spline>(std::move(spline));
  symbol.source = source;
  symbol.source_unknowns = unknowns;
  symbol.sign = sign;
  return Power_polynomial::variable(static_cast<int>(m_symbols.size()) - 1);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Symbol_table::enter_formula(const Power_polynomial& formula)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  for (std::size_t i = m_domains.size(); i < m_symbols.size(); ++i)
    if (m_symbols[i].kind == Symbol::Kind::FORMULA && m_symbols[i].formula == formula)
      return static_cast<int>(i);
  add(Symbol::Kind::FORMULA).formula = formula;
  return static_cast<int>(m_symbols.size()) - 1;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Symbol_table::enter_unknown_without_range()
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  add(Symbol::Kind::WITHOUT_RANGE);
  return static_cast<int>(m_symbols.size()) - 1;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Symbol_table::enter_value(Elementary_function function,
                                                             const Exact_rational& exponent,
                                                             const Power_polynomial& argument)
{
  const std::lock_guard<std::mutex> lock(m_mutex);
  for (std::size_t i = m_domains.size(); i < m_symbols.size(); ++i)
    if (const Symbol& s = m_symbols[i];
        s.kind == Symbol::Kind::VALUE && s.function == function && s.exponent == exponent && s.formula == argument)
      return static_cast<int>(i);
  Symbol& symbol = add(Symbol::Kind::VALUE);
  symbol.function = function;
  symbol.exponent = exponent;
  symbol.formula = argument;
  symbol.sign = function == Elementary_function::EXPONENTIAL || function == Elementary_function::HYPERBOLIC_COSINE;
  return static_cast<int>(m_symbols.size()) - 1;
}

// By their names in the order of the other table, where each comes after those that it needs.
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Symbol_table::imported(const Power_polynomial& polynomial,
                                                                       const Symbol_table& from)
{
  std::vector<Power_polynomial> names;
  const auto renamed = [&](const Power_polynomial& p) { return p.value(std::span<const Power_polynomial>(names)); };
  for (int i = 0, size = from.size(); i < size; ++i) {
    const Symbol& symbol = from[i];
    names.push_back(Power_polynomial::variable(
        symbol.kind == Symbol::Kind::VALUE ? enter_value(symbol.function, symbol.exponent, renamed(symbol.formula))
                                           : enter_formula(renamed(symbol.formula))));
  }
  return renamed(polynomial);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<int> Symbol_table::values_in(const Power_polynomial& polynomial) const
{
  std::vector<int> result, waiting = polynomial.variables();
  std::set<int> seen;
  while (!waiting.empty()) {
    const int s = waiting.back();
    waiting.pop_back();
    const Symbol& symbol = (*this)[s];
    if (!seen.insert(s).second)
      continue;
    if (symbol.kind == Symbol::Kind::VALUE)
      result.push_back(s);
    if (symbol.kind == Symbol::Kind::VALUE || symbol.kind == Symbol::Kind::FORMULA)
      for (const int inner : symbol.formula.variables())
        waiting.push_back(inner);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void
Symbol_table::require_outside_of_values(int unknown, const Power_polynomial& polynomial, const std::string& where) const
{
  for (const int s : values_in(polynomial))
    if ((*this)[s].formula.degree(unknown) > 0)
      throw Invalid_input(where + ": the unknown occurs in " + in_words((*this)[s].function));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Symbol_table::require_no_values(const Power_polynomial& polynomial,
                                                                    const std::string& where) const
{
  if (const std::vector<int> values = values_in(polynomial); !values.empty())
    throw Invalid_input(where + ": a formula with " + in_words((*this)[values.front()].function) +
                        ", where only polynomials and splines are possible; solve(), Propagation_solver_d and "
                        "find_feasible_point() take elementary functions");
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Symbol_table::without_formulas(Power_polynomial polynomial) const
{
  for (;;) {
    const std::vector<int> symbols = polynomial.variables();
    const auto last =
        std::find_if(symbols.rbegin(), symbols.rend(), [&](int s) { return (*this)[s].kind == Symbol::Kind::FORMULA; });
    if (last == symbols.rend())
      return polynomial;
    polynomial = polynomial.substituted(*last, (*this)[*last].formula);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Symbol_table::has_only_unknowns(const Power_polynomial& polynomial) const
{
  const std::vector<int> symbols = polynomial.variables();
  return symbols.empty() || is_unknown(symbols.back());
}

CGAL_SPLINE_CONSTRAINTS_INLINE Symbol& Symbol_table::add(Symbol::Kind kind)
{
  Symbol& result = m_symbols.emplace_back();
  result.kind = kind;
  return result;
}
#endif

// The symbols of two formulas, at least one of which may have none. Throws when they have different ones.
inline const std::shared_ptr<Symbol_table>& common_symbols(const std::shared_ptr<Symbol_table>& a,
                                                           const std::shared_ptr<Symbol_table>& b)
{
  if (a != nullptr && b != nullptr && a != b)
    throw Invalid_input(a->domains().empty() || b->domains().empty()
                            ? "Expression: a function of numbers where one of unknowns is needed"
                            : "Expression: unknowns from different calls of unknowns() in one formula");
  return a == nullptr ? b : a;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SYMBOL_TABLE_H
