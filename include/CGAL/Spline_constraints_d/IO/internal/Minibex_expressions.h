// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_EXPRESSIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_EXPRESSIONS_H

#include <CGAL/Spline_constraints_d/IO/internal/Minibex_lexer.h>
#include <CGAL/Spline_constraints_d/IO/internal/Minibex_tokens.h>
#include <CGAL/Spline_constraints_d/IO/internal/decimal_number.h>
#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Expressions of Minibex, by recursive descent. They are expanded as they are read. What is written once and meant several
times, as the body of a loop, of a sum or of a function, is read again each time. Elementary functions are values of
their arguments, where they are wanted.
*/
class Minibex_expressions : protected Minibex_tokens
{
protected:
  static constexpr int largest_integer = 1'000'000;

  // A number, an unknown, or an array of these.
  struct Symbol
  {
    bool is_array = false;
    std::vector<Power_polynomial> values = {};
  };
  using Symbols = std::unordered_map<std::string, Symbol>;

  struct Parameter
  {
    std::string name;
    std::size_t size;   // of an array; 0: a number
  };

  struct Function
  {
    std::vector<Parameter> parameters;
    Place body;
    std::size_t number;   // it may use those before it
  };

  Symbols m_constants, m_symbols;   // the latter are seen outside of functions, or in the present one
  std::unordered_map<std::string, Function> m_functions;
  std::size_t m_usable_functions = 0;
  std::string m_declared;   // the unknown whose declaration is being read
  const bool m_has_functions;
  Elementary_values m_values;

  Minibex_expressions(std::string_view content, const std::string& file_name, bool has_functions)
    : Minibex_tokens(content, file_name), m_has_functions(has_functions)
  {}

  // ---- names ----

  Minibex_token parse_new_name()
  {
    if (!m_token.is_name())
      fail("expected a name");
    if (is_reserved(m_token))
      fail("a reserved word cannot be a name");
    if (const std::string name(m_token.text); find(name) != nullptr || m_functions.count(name) != 0)
      fail("this name is declared already");
    return advance();
  }

  const Symbol* find(const std::string& name) const
  {
    for (const Symbols* symbols : {&m_symbols, &m_constants})
      if (const auto position = symbols->find(name); position != symbols->end())
        return &position->second;
    return nullptr;
  }

  // ---- expressions ----

  Power_polynomial parse_sum()
  {
    go_deeper();
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
        if (is_division && (factor.is_constant() || !m_has_functions))
          product.divide(factor, m_budget);
        else if (is_division)
          product = Power_polynomial::product(product, value_of(factor, [&] { return m_values.reciprocal(factor); }),
                                              m_budget);
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
      const Power_polynomial exponent = parse_exponent();
      at(operation, [&] { result = power_of(result, exponent, begin); });
      if (begin.is("-") || begin.is("+"))
        refuse_after_sign(begin);
    }
    return result;
  }

  Power_polynomial parse_exponent()
  {
    const Minibex_token begin = m_token;
    bool is_negative = false;
    while (m_token.is("-") || m_token.is("+"))
      is_negative ^= advance().is("-");
    Power_polynomial exponent = parse_operand();
    if (!m_has_functions)
      integer_value(begin, exponent, -largest_integer, largest_integer, "exponent");
    return is_negative ? -std::move(exponent) : exponent;
  }

  // Integers first; what is no constant is carried over by the logarithm.
  Power_polynomial power_of(const Power_polynomial& base, const Power_polynomial& exponent, const Minibex_token& begin)
  {
    if (!exponent.is_constant())
      return value_of(base, [&] {
        const Power_polynomial logarithm = m_values.value(Elementary_function::LOGARITHM, base);
        return m_values.value(Elementary_function::EXPONENTIAL,
                              Power_polynomial::product(exponent, logarithm, m_budget));
      });
    const Exact_rational number = exponent.constant_term();
    if (denominator_of(number) != 1)
      return value_of(base, [&] { return m_values.power(base, number); });
    const int count = integer_value(begin, exponent, -largest_integer, largest_integer, "exponent");
    if (count >= 0)
      return Power_polynomial::power(base, count, m_budget);
    if (!base.is_constant() && !m_has_functions)
      throw Invalid_input("a negative exponent on a base that is not a constant");
    return Power_polynomial::power(value_of(base, [&] { return m_values.reciprocal(base); }), -count, m_budget);
  }

  // To make a value costs as much as to write its argument.
  template <class Make>
  Power_polynomial value_of(const Power_polynomial& argument, const Make& make)
  {
    m_budget.spend(64.0 * (1.0 + static_cast<double>(argument.terms().size())));
    return make();
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
    const Symbol* symbol = find(std::string(m_token.text));
    if (symbol == nullptr)
      return parse_other_name();
    const Minibex_token name = advance();
    if (symbol->is_array)
      return symbol->values[parse_index(symbol->values.size())];
    if (m_token.is("(") || m_token.is("["))
      fail("'" + std::string(name.text) + "' is not an array: expected an operator");
    return symbol->values.front();
  }

  Power_polynomial parse_parenthesis()
  {
    Power_polynomial result = parse_sum();
    if (relation_of(m_token))
      fail("a constraint in parentheses is not supported: expected ')'");
    expect(")");
    return result;
  }

  static std::optional<Relation> relation_of(const Minibex_token& token)
  {
    for (Relation relation :
         {Relation::EQUAL, Relation::LESS, Relation::LESS_EQUAL, Relation::GREATER_EQUAL, Relation::GREATER})
      if (token.is(symbol(relation)))
        return relation;
    return std::nullopt;
  }

  // x(i) counts from 1, x[i] from 0.
  std::size_t parse_index(std::size_t size)
  {
    const bool is_round = m_token.is("(");
    if (!is_round && !m_token.is("["))
      fail("an array needs an index: expected '('");
    advance();
    const int index = parse_integer(is_round ? 1 : 0, static_cast<int>(size) - (is_round ? 0 : 1), "index");
    expect(is_round ? ")" : "]");
    return static_cast<std::size_t>(is_round ? index - 1 : index);
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
    if (name == "sum")
      return parse_indexed_sum();
    if (name == "min" || name == "max")
      return parse_extreme(name == "min");
    if (const auto position = m_functions.find(name); position != m_functions.end())
      return parse_call(position->second);
    if (name == "oo")
      fail(m_declared.empty() ? "infinity is not a number" : "the domain of '" + m_declared + "' must be finite");
    const auto function = elementary_function_of_name(name);
    if (m_has_functions && (name == "pi" || function))
      return parse_value(function);
    if (name == "pi" || function || is_function_of_minibex(name))
      fail("'" + name + "' is not in the " + (m_has_functions ? "" : "polynomial ") + "subset of Minibex");
    fail(is_reserved(m_token) ? "expected a number, a name or '('" : "unknown name");
  }

  // A function of what follows in parentheses; without one, pi.
  Power_polynomial parse_value(const std::optional<Elementary_function>& function)
  {
    const Minibex_token name = advance();
    if (!function)
      return 4 * m_values.value(Elementary_function::ARC_TANGENT, Power_polynomial(1));
    expect("(");
    const Power_polynomial argument = parse_parenthesis();
    return at(name, [&] { return value_of(argument, [&] { return m_values.value(*function, argument); }); });
  }

  // ---- what is read several times ----

  // Calls read() with `index` as each integer of the range that is written next, as 1:n, up to `end`.
  template <class Read>
  void for_each_index(const std::string& end, const Read& read)
  {
    const std::string index(parse_new_name().text);
    expect("=");
    const Minibex_token begin = m_token;
    const int first = parse_integer(-largest_integer, largest_integer, "begin of the range");
    expect(":");
    const int last = parse_integer(-largest_integer, largest_integer, "end of the range");
    if (last < first)
      m_lexer.fail(begin, "an empty range");
    expect(end);
    go_deeper();
    const Place body = place();
    for (int i = first; i <= last; ++i) {
      if (i > first)
        return_to(body);
      m_symbols[index] = {false, {Power_polynomial(i)}};
      read();
    }
    m_symbols.erase(index);
    --m_depth;
  }

  // sum(i = 1:n, expression)
  Power_polynomial parse_indexed_sum()
  {
    const Minibex_token begin = advance();
    Power_polynomial result;
    expect("(");
    for_each_index(",", [&] {
      Power_polynomial summand = parse_sum();
      at(begin, [&] { result.add(std::move(summand), m_budget); });
    });
    expect(")");
    return result;
  }

  // The least or the greatest of constants.
  Power_polynomial parse_extreme(bool is_least)
  {
    const Minibex_token name = advance();
    std::vector<Exact_rational> values;
    expect("(");
    do {
      const Power_polynomial value = parse_sum();
      if (!value.is_constant())
        m_lexer.fail(name, "'" + std::string(name.text) + "' of unknowns is not in the polynomial subset of Minibex");
      values.push_back(value.constant_term());
    } while (skip(","));
    expect(")");
    return *(is_least ? std::min_element(values.begin(), values.end())
                      : std::max_element(values.begin(), values.end()));
  }

  // A call of a function: its statements are read with the values of its parameters.
  Power_polynomial parse_call(const Function& function)
  {
    const Minibex_token name = m_token;
    if (function.number >= m_usable_functions)
      fail("a function that is not defined before");
    advance();
    expect("(");
    Symbols arguments;
    for (const Parameter& parameter : function.parameters) {
      if (!arguments.empty() && !skip(","))
        fail("too few arguments of '" + std::string(name.text) + "'");
      arguments[parameter.name] = parse_argument(parameter);
    }
    if (m_token.is(","))
      fail("too many arguments of '" + std::string(name.text) + "'");
    expect(")");
    go_deeper();
    const Place after = place();
    return_to(function.body);
    std::swap(m_symbols, arguments);
    const std::size_t usable = std::exchange(m_usable_functions, function.number);
    const Power_polynomial result = parse_statements();
    m_usable_functions = usable;
    std::swap(m_symbols, arguments);
    return_to(after);
    --m_depth;
    return result;
  }

  Symbol parse_argument(const Parameter& parameter)
  {
    if (parameter.size == 0)
      return {false, {parse_sum()}};
    const Symbol* array = m_token.is_name() ? find(std::string(m_token.text)) : nullptr;
    if (array == nullptr || !array->is_array || array->values.size() != parameter.size)
      fail("expected the name of an array of size " + std::to_string(parameter.size));
    advance();
    return *array;
  }

  // name = expression; ... return expression
  Power_polynomial parse_statements()
  {
    while (!m_token.is_keyword("return")) {
      const std::string name(parse_new_name().text);
      expect("=");
      m_symbols[name] = {false, {parse_sum()}};
      expect(";");
    }
    advance();
    return parse_sum();
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

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_EXPRESSIONS_H
