// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_PARSER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_PARSER_H

#include <CGAL/Spline_constraints_d/IO/Minibex_system.h>
#include <CGAL/Spline_constraints_d/IO/internal/Minibex_expressions.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The sections of a Minibex file; the grammar is the documentation of `read_minibex()`.
class Minibex_parser : Minibex_expressions
{
  static constexpr int maximal_number_of_unknowns = 1 << 16;

  Minibex_system m_system;

public:
  Minibex_parser(std::string_view content, const std::string& file_name, Minibex_subset subset)
    : Minibex_expressions(content, file_name, subset == Minibex_subset::ELEMENTARY)
  {}

  Minibex_system system()
  {
    if (m_token.is_keyword("constants"))
      parse_constants();
    parse_functions();
    refuse_other_sections();
    if (!m_token.is_keyword("variables"))
      fail("expected 'Variables'");
    parse_variables();
    parse_functions();
    refuse_other_sections();
    if (!m_token.is_keyword("constraints"))
      fail("expected 'Constraints'");
    parse_constraints();
    if (m_token.kind != Minibex_token::Kind::END_OF_FILE)
      fail("expected nothing after 'end'");
    if (needs_values())
      m_system.values = std::move(m_values);
    return std::move(m_system);
  }

private:
  // Numbers may have served for domains alone.
  bool needs_values() const
  {
    const auto has = [](const Power_polynomial& polynomial, bool is_value) {
      return std::ranges::any_of(polynomial.variables(),
                                 [&](int j) { return (j >= Elementary_values::first_index) == is_value; });
    };
    return std::ranges::any_of(m_system.constraints, [&](const auto& c) { return has(c.function, true); }) ||
        std::ranges::any_of(m_values.all(), [&](const auto& value) { return has(value.argument, false); });
  }

  void refuse_other_sections() const
  {
    for (std::string_view section : {"constants", "parameters", "minimize"})
      if (m_token.is_keyword(section))
        fail("section '" + std::string(section) +
             (section == "constants" ? "' must come first" : "' is not in the polynomial subset of Minibex"));
  }

  // ---- constants ----

  void parse_constants()
  {
    advance();
    while (!is_at_section()) {
      const std::string name(parse_new_name().text);
      const int size = parse_size_of_array();
      if (!is_at_in() && !m_token.is("="))
        fail("expected '=' or 'in'");
      advance();
      m_constants.emplace(name, size == 0 ? Symbol{false, {parse_number(name)}} : parse_array_of_numbers(name, size));
      expect(";");
    }
  }

  // [n], or nothing: 0.
  int parse_size_of_array()
  {
    if (!skip("["))
      return 0;
    const int size = parse_integer(1, maximal_number_of_unknowns, "size of the array");
    expect("]");
    if (m_token.is("["))
      fail("matrices are not in the polynomial subset of Minibex");
    return size;
  }

  // A constant, or an interval of one number.
  Power_polynomial parse_number(const std::string& name)
  {
    const Minibex_token begin = m_token;
    if (!begin.is("["))
      return m_has_functions ? parse_sum() : parse_constant();
    const auto [lower, upper] = parse_interval();
    if (lower != upper)
      m_lexer.fail(begin, "constant '" + name + "' is an interval; only numbers are supported");
    return lower;
  }

  // (a; b; ...) or (a, b, ...), or one number for all.
  Symbol parse_array_of_numbers(const std::string& name, int size)
  {
    Symbol result{true};
    const Minibex_token begin = m_token;
    if (!skip("(")) {
      result.values.assign(static_cast<std::size_t>(size), parse_number(name));
      return result;
    }
    do
      result.values.push_back(parse_number(name));
    while (skip(";") || skip(","));
    if (result.values.size() != static_cast<std::size_t>(size))
      m_lexer.fail(begin, "'" + name + "' has " + std::to_string(size) + " elements, not " +
                              std::to_string(result.values.size()));
    expect(")");
    return result;
  }

  // ---- functions ----

  void parse_functions()
  {
    while (m_token.is_keyword("function"))
      parse_function();
  }

  // They may have the names of unknowns.
  std::vector<Parameter> parse_parameters()
  {
    std::vector<Parameter> result;
    Symbols unknowns;
    std::swap(m_symbols, unknowns);
    expect("(");
    do {
      const Minibex_token name = parse_new_name();
      for (const Parameter& other : result)
        if (other.name == name.text)
          m_lexer.fail(name, "this name is declared already");
      const int size = parse_size_of_array();
      result.push_back({std::string(name.text), static_cast<std::size_t>(size)});
    } while (skip(","));
    expect(")");
    std::swap(m_symbols, unknowns);
    return result;
  }

  // The statements are read when the function is called.
  void parse_function()
  {
    advance();
    const std::string name(parse_new_name().text);
    std::vector<Parameter> parameters = parse_parameters();
    m_functions.emplace(name, Function{std::move(parameters), place(), m_functions.size()});
    m_usable_functions = m_functions.size();
    bool has_return = false;
    for (; !m_token.is_keyword("end"); advance()) {
      if (m_token.kind == Minibex_token::Kind::END_OF_FILE || is_at_section() || m_token.is_keyword("for"))
        fail("expected the end of function '" + name + "'");
      has_return = has_return || m_token.is_keyword("return");
    }
    if (!has_return)
      fail("expected 'return'");
    advance();
    skip(";");
  }

  // ---- unknowns ----

  void parse_variables()
  {
    advance();
    do
      parse_variable();
    while (skip(",") || (skip(";") && !is_at_section()));
    if (!is_at_section())
      fail("expected ',' or ';'");
  }

  void parse_variable()
  {
    if (is_at_section())
      fail("expected a name");
    const Minibex_token name = parse_new_name();
    m_declared = std::string(name.text);
    const int size_of_array = parse_size_of_array();
    const int first = static_cast<int>(m_system.names.size()), size = size_of_array == 0 ? 1 : size_of_array;
    if (first + size > maximal_number_of_unknowns)
      m_lexer.fail(name, "more than " + std::to_string(maximal_number_of_unknowns) + " unknowns");
    if (!is_at_in())
      fail("the domain of '" + m_declared + "' is missing: finite bounds are required,");
    advance();
    parse_domains(size_of_array);
    Symbol symbol{size_of_array > 0};
    for (int i = 0; i < size; ++i) {
      m_system.names.push_back(symbol.is_array ? m_declared + '(' + std::to_string(i + 1) + ')' : m_declared);
      symbol.values.push_back(Power_polynomial::variable(first + i));
    }
    m_symbols.emplace(m_declared, std::move(symbol));
    m_declared.clear();
  }

  // One interval for all elements, or ([a,b]; [c,d]; ...) with one for each.
  void parse_domains(int size_of_array)
  {
    if (size_of_array > 0 && m_token.is("(")) {
      const Minibex_token begin = advance();
      int count = 0;
      do {
        if (count++ < size_of_array)
          m_system.domains.push_back(parse_interval());
        else
          m_lexer.fail(begin, "too many domains for the elements of '" + m_declared + "'");
      } while (skip(";"));
      if (count != size_of_array)
        m_lexer.fail(begin, "too few domains for the elements of '" + m_declared + "'");
      expect(")");
    } else
      m_system.domains.insert(m_system.domains.end(), static_cast<std::size_t>(size_of_array == 0 ? 1 : size_of_array),
                              parse_interval());
  }

  // [a,b], or a number. Ends that are not rational are rounded outwards.
  std::pair<Exact_rational, Exact_rational> parse_interval()
  {
    const Minibex_token begin = m_token;
    if (!skip("["))
      return parse_bounds();
    Exact_rational lower = parse_bounds().first;
    expect(",");
    Exact_rational upper = parse_bounds().second;
    expect("]");
    if (upper < lower)
      m_lexer.fail(begin, m_declared.empty() ? "empty interval" : "the domain of '" + m_declared + "' is empty");
    return {std::move(lower), std::move(upper)};
  }

  // Numbers below and above a constant.
  std::pair<Exact_rational, Exact_rational> parse_bounds()
  {
    const Minibex_token begin = m_token;
    const Power_polynomial value = m_has_functions ? parse_sum() : parse_constant();
    if (value.is_constant())
      return {value.constant_term(), value.constant_term()};
    const Upward_rounding_guard guard;
    at(begin, [&] { m_budget.spend(256.0 * static_cast<double>(m_values.all().size())); });
    const auto range = elementary::number_of(value, elementary::numbers_among(m_values.all()));
    if (!range || !std::isfinite(range->inf()) || !std::isfinite(range->sup()))
      m_lexer.fail(begin, "expected a constant");
    return {Exact_rational(range->inf()), Exact_rational(range->sup())};
  }

  // ---- constraints ----

  void parse_constraints()
  {
    advance();
    parse_list_of_constraints();
    if (m_system.constraints.empty())
      fail("expected a constraint");
    advance();
  }

  void parse_list_of_constraints()
  {
    while (!m_token.is_keyword("end")) {
      const bool is_loop = m_token.is_keyword("for");
      if (is_loop)
        parse_loop();
      else
        parse_constraint();
      if (!skip(";") && !is_loop && !m_token.is_keyword("end"))
        fail("expected an operator, ';' or 'end'");
    }
  }

  // for i = 1:n; constraints end
  void parse_loop()
  {
    advance();
    for_each_index(";", [&] { parse_list_of_constraints(); });
    advance();
  }

  void parse_constraint()
  {
    const int line = m_token.line;
    Power_polynomial function = parse_sum();
    const Minibex_token relation = m_token;
    const std::optional<Relation> kind = relation_of(relation);
    if (!kind)
      fail("expected an operator or '=', '<', '<=', '>=', '>'");
    advance();
    Power_polynomial right = parse_sum();
    at(relation, [&] {
      right.negate(m_budget);
      function.add(std::move(right), m_budget);
    });
    m_system.constraints.push_back({std::move(function), *kind, line});
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_PARSER_H
