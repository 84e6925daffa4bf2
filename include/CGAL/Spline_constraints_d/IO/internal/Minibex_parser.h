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
#include <CGAL/Spline_constraints_d/IO/Parse_error.h>
#include <CGAL/Spline_constraints_d/IO/internal/Minibex_lexer.h>
#include <CGAL/Spline_constraints_d/IO/internal/decimal_number.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Recursive descent over the polynomial subset of Minibex, one token ahead; the grammar is the documentation of
`read_minibex()`. Expressions are expanded as they are read. What they may cost is bounded by a budget linear in the
size of the file, the depth of recursion by `maximal_depth`.
*/
class Minibex_parser
{
  static constexpr int maximal_depth = 200;
  static constexpr int maximal_number_of_unknowns = 1 << 16;

  struct Symbol
  {
    enum class Kind { SCALAR, ARRAY, CONSTANT } kind = Kind::SCALAR;
    int first_unknown = 0, size = 1;
    Power_polynomial value = {};   // of a constant
  };

  Minibex_lexer m_lexer;
  Minibex_token m_token;   // the next one
  Expansion_budget m_budget;
  std::unordered_map<std::string, Symbol> m_symbols;
  Minibex_system m_system;
  int m_depth = 0;
  std::string m_declared;   // the unknown whose declaration is being read

public:
  Minibex_parser(std::string_view content, const std::string& file_name)
    : m_lexer(content, file_name), m_token(m_lexer.next()),
      m_budget(0x1p23 + 16.0 * static_cast<double>(content.size()))
  {}

  Minibex_system system()
  {
    if (m_token.is_keyword("constants"))
      parse_constants();
    refuse_other_sections();
    if (!m_token.is_keyword("variables"))
      fail("expected 'Variables'");
    parse_variables();
    refuse_other_sections();
    if (!m_token.is_keyword("constraints"))
      fail("expected 'Constraints'");
    parse_constraints();
    if (m_token.kind != Minibex_token::Kind::END_OF_FILE)
      fail("expected nothing after 'end'");
    return std::move(m_system);
  }

private:
  [[noreturn]] void fail(const std::string& message) const { m_lexer.fail(m_token, message); }

  Minibex_token advance() { return std::exchange(m_token, m_lexer.next()); }

  bool skip(std::string_view symbol)
  {
    const bool found = m_token.is(symbol);
    if (found)
      advance();
    return found;
  }

  void expect(std::string_view symbol)
  {
    if (!skip(symbol))
      fail("expected '" + std::string(symbol) + "'");
  }

  // Runs exact arithmetic; its limits and its division by zero become errors at the given token.
  template <class Function>
  auto at(const Minibex_token& token, const Function& function) const
  {
    try {
      return function();
    } catch (const Parse_error&) {
      throw;
    } catch (const Invalid_input& error) {
      m_lexer.fail(token, error.what());
    }
  }

  // ---- sections ----

  void refuse_other_sections() const
  {
    for (std::string_view section : {"constants", "parameters", "function", "minimize"})
      if (m_token.is_keyword(section))
        fail("section '" + std::string(section) +
             (section == "constants" ? "' must come first" : "' is not in the polynomial subset of Minibex"));
  }

  bool is_at_section() const
  {
    for (std::string_view word : {"constants", "variables", "parameters", "function", "minimize", "constraints"})
      if (m_token.is_keyword(word))
        return true;
    return false;
  }

  void parse_constants()
  {
    advance();
    while (!is_at_section()) {
      const Minibex_token name = parse_new_name();
      if (m_token.is("["))
        fail("arrays of constants are not in the polynomial subset of Minibex");
      Symbol symbol{Symbol::Kind::CONSTANT};
      if (skip("="))
        symbol.value = parse_constant();
      else if (m_token.is_name() && m_token.text == "in") {
        const Minibex_token in = advance();
        const auto [lower, upper] = parse_interval();
        if (lower != upper)
          m_lexer.fail(in, "constant '" + std::string(name.text) + "' is an interval; only numbers are supported");
        symbol.value = lower;
      } else
        fail("expected '=' or 'in'");
      m_symbols.emplace(std::string(name.text), std::move(symbol));
      expect(";");
    }
  }

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
    Symbol symbol{Symbol::Kind::SCALAR, static_cast<int>(m_system.names.size())};
    if (skip("[")) {
      symbol.kind = Symbol::Kind::ARRAY;
      symbol.size = parse_integer(1, maximal_number_of_unknowns, "size of the array");
      expect("]");
      if (m_token.is("["))
        fail("matrices of unknowns are not in the polynomial subset of Minibex");
    }
    if (symbol.first_unknown + symbol.size > maximal_number_of_unknowns)
      m_lexer.fail(name, "more than " + std::to_string(maximal_number_of_unknowns) + " unknowns");
    if (!(m_token.is_name() && m_token.text == "in"))
      fail("the domain of '" + m_declared + "' is missing: finite bounds are required,");
    advance();
    parse_domains(symbol);
    for (int i = 1; i <= symbol.size; ++i)
      m_system.names.push_back(symbol.kind == Symbol::Kind::ARRAY ? m_declared + '(' + std::to_string(i) + ')'
                                                                  : m_declared);
    m_symbols.emplace(m_declared, std::move(symbol));
    m_declared.clear();
  }

  // One interval for all elements, or ([a,b]; [c,d]; ...) with one for each.
  void parse_domains(const Symbol& symbol)
  {
    if (symbol.kind == Symbol::Kind::ARRAY && m_token.is("(")) {
      const Minibex_token begin = advance();
      int count = 0;
      do {
        if (count++ < symbol.size)
          m_system.domains.push_back(parse_interval());
        else
          m_lexer.fail(begin, "too many domains for the elements of '" + m_declared + "'");
      } while (skip(";"));
      if (count != symbol.size)
        m_lexer.fail(begin, "too few domains for the elements of '" + m_declared + "'");
      expect(")");
    } else
      m_system.domains.insert(m_system.domains.end(), static_cast<std::size_t>(symbol.size), parse_interval());
  }

  std::pair<Exact_rational, Exact_rational> parse_interval()
  {
    const Minibex_token begin = m_token;
    expect("[");
    Exact_rational lower = parse_constant().constant_term();
    expect(",");
    Exact_rational upper = parse_constant().constant_term();
    expect("]");
    if (upper < lower)
      m_lexer.fail(begin, m_declared.empty() ? "empty interval" : "the domain of '" + m_declared + "' is empty");
    return {std::move(lower), std::move(upper)};
  }

  void parse_constraints()
  {
    advance();
    while (!m_token.is_keyword("end")) {
      parse_constraint();
      if (!skip(";") && !m_token.is_keyword("end"))
        fail("expected an operator, ';' or 'end'");
    }
    if (m_system.constraints.empty())
      fail("expected a constraint");
    advance();
  }

  void parse_constraint()
  {
    if (m_token.is_keyword("for"))
      fail("loops are not in the polynomial subset of Minibex");
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

  static std::optional<Relation> relation_of(const Minibex_token& token)
  {
    for (Relation relation :
         {Relation::EQUAL, Relation::LESS, Relation::LESS_EQUAL, Relation::GREATER_EQUAL, Relation::GREATER})
      if (token.is(symbol(relation)))
        return relation;
    return std::nullopt;
  }

  // ---- names ----

  static bool is_function(std::string_view name)
  {
    static constexpr std::array<std::string_view, 24> functions{
        "diff", "max",  "min",  "atan2", "sign", "abs",  "exp",   "ln",    "sqrt",  "cos",   "sin",  "tan",
        "acos", "asin", "atan", "cosh",  "sinh", "tanh", "acosh", "asinh", "atanh", "floor", "ceil", "chi"};
    return std::find(functions.begin(), functions.end(), name) != functions.end();
  }

  bool is_reserved(const Minibex_token& token) const
  {
    for (std::string_view word : {"begin", "end", "for", "return"})
      if (token.is_keyword(word))
        return true;
    for (std::string_view word : {"in", "inf", "mid", "sup", "sum", "integer", "pi", "oo"})
      if (token.text == word)
        return true;
    return is_function(token.text) || is_at_section();
  }

  Minibex_token parse_new_name()
  {
    if (!m_token.is_name())
      fail("expected a name");
    if (is_reserved(m_token))
      fail("a reserved word cannot be a name");
    if (m_symbols.count(std::string(m_token.text)) != 0)
      fail("this name is declared already");
    return advance();
  }

  // ---- expressions ----

  Power_polynomial parse_sum()
  {
    if (++m_depth > maximal_depth)
      fail("parentheses nested more than " + std::to_string(maximal_depth) + " deep");
    Power_polynomial sum = parse_product();
    while (m_token.is("+") || m_token.is("-")) {
      const Minibex_token sign = advance();
      Power_polynomial summand = parse_product();
      at(sign, [&] {
        if (sign.is("-"))
          summand.negate(m_budget);
        sum.add(std::move(summand), m_budget);
      });
    }
    --m_depth;
    return sum;
  }

  Power_polynomial parse_product()
  {
    Power_polynomial product = parse_signed();
    while (m_token.is("*") || m_token.is("/")) {
      const Minibex_token operation = advance();
      const bool is_division = operation.is("/");
      const Minibex_token begin = m_token;
      const Power_polynomial factor = parse_signed();
      if (is_division && (begin.is("-") || begin.is("+")))
        refuse_after_sign(begin);
      at(operation, [&] {
        if (is_division)
          product.divide(factor, m_budget);
        else
          product = Power_polynomial::product(product, factor, m_budget);
      });
    }
    return product;
  }

  // In IBEX a sign binds weaker than * and /, so that a/-b*c is a/(-(b*c)) there; we do not guess what was meant.
  void refuse_after_sign(const Minibex_token& sign) const
  {
    if (m_token.is("*") || m_token.is("/") || m_token.is("^"))
      m_lexer.fail(sign, "an ambiguous sign: write parentheses");
  }

  Power_polynomial parse_signed()
  {
    bool is_negative = false;
    const Minibex_token sign = m_token;
    while (m_token.is("-") || m_token.is("+"))
      is_negative ^= advance().is("-");
    Power_polynomial result = parse_power();
    if (is_negative)
      at(sign, [&] { result.negate(m_budget); });
    return result;
  }

  Power_polynomial parse_power()
  {
    Power_polynomial result = parse_operand();
    while (m_token.is("^")) {
      const Minibex_token operation = advance();
      const Minibex_token begin = m_token;
      int exponent = parse_exponent();
      at(operation, [&] {
        if (exponent < 0) {
          if (!result.is_constant())
            throw Invalid_input("a negative exponent on a base that is not a constant");
          result = Power_polynomial(1).divide(result, m_budget);
          exponent = -exponent;
        }
        result = Power_polynomial::power(result, exponent, m_budget);
      });
      if (begin.is("-") || begin.is("+"))
        refuse_after_sign(begin);
    }
    return result;
  }

  int parse_exponent()
  {
    const Minibex_token begin = m_token;
    bool is_negative = false;
    while (m_token.is("-") || m_token.is("+"))
      is_negative ^= advance().is("-");
    const int size = integer_value(begin, parse_operand(), -1'000'000, 1'000'000, "exponent");
    return is_negative ? -size : size;
  }

  Power_polynomial parse_operand()
  {
    if (m_token.is_number()) {
      const Minibex_token number = advance();
      return at(number, [&] { return Power_polynomial(decimal_number(number.text, m_budget)); });
    }
    if (skip("("))
      return parse_parenthesis();
    if (!m_token.is_name())
      fail("expected a number, a name or '('");
    const auto position = m_symbols.find(std::string(m_token.text));
    if (position == m_symbols.end())
      return parse_other_name();
    const Symbol& symbol = position->second;
    const Minibex_token name = advance();
    if (symbol.kind != Symbol::Kind::ARRAY && (m_token.is("(") || m_token.is("[")))
      fail("'" + std::string(name.text) + "' is not an array: expected an operator");
    if (symbol.kind == Symbol::Kind::CONSTANT)
      return symbol.value;
    if (symbol.kind == Symbol::Kind::SCALAR)
      return Power_polynomial::variable(symbol.first_unknown);
    return Power_polynomial::variable(symbol.first_unknown + parse_index(symbol));
  }

  Power_polynomial parse_parenthesis()
  {
    Power_polynomial result = parse_sum();
    if (relation_of(m_token))
      fail("a constraint in parentheses is not supported: expected ')'");
    expect(")");
    return result;
  }

  // x(i) counts from 1, x[i] from 0.
  int parse_index(const Symbol& symbol)
  {
    const bool is_round = m_token.is("(");
    if (!is_round && !m_token.is("["))
      fail("an array needs an index: expected '('");
    advance();
    const int index = parse_integer(is_round ? 1 : 0, symbol.size - (is_round ? 0 : 1), "index");
    expect(is_round ? ")" : "]");
    return is_round ? index - 1 : index;
  }

  Power_polynomial parse_other_name()
  {
    const std::string name(m_token.text);
    if (name == "sqr") {
      const Minibex_token function = advance();
      expect("(");
      const Power_polynomial argument = parse_parenthesis();
      return at(function, [&] { return Power_polynomial::product(argument, argument, m_budget); });
    }
    if (name == "oo")
      fail(m_declared.empty() ? "infinity is not a number" : "the domain of '" + m_declared + "' must be finite");
    if (name == "pi" || is_function(name))
      fail("'" + name + "' is not in the polynomial subset of Minibex");
    fail(is_reserved(m_token) ? "expected a number, a name or '('" : "unknown name");
  }

  // ---- constants ----

  Power_polynomial parse_constant()
  {
    const Minibex_token begin = m_token;
    Power_polynomial value = parse_sum();
    if (!value.is_constant())
      m_lexer.fail(begin, "expected a constant");
    return value;
  }

  int parse_integer(int minimum, int maximum, const char* what)
  {
    const Minibex_token begin = m_token;
    return integer_value(begin, parse_sum(), minimum, maximum, what);
  }

  int integer_value(const Minibex_token& begin, const Power_polynomial& p, int minimum, int maximum,
                    const char* what) const
  {
    if (!p.is_constant() || denominator_of(p.constant_term()) != 1)
      m_lexer.fail(begin, std::string("the ") + what + " must be a constant integer");
    const Big_integer value = numerator_of(p.constant_term());
    if (value < minimum || value > maximum)
      m_lexer.fail(begin,
                   std::string("the ") + what + " must be between " + std::to_string(minimum) + " and " +
                       std::to_string(maximum));
    return static_cast<int>(value.convert_to<long>());
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_PARSER_H
