// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_TOKENS_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_TOKENS_H

#include <CGAL/Spline_constraints_d/IO/Parse_error.h>
#include <CGAL/Spline_constraints_d/IO/internal/Minibex_lexer.h>
#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Expansion_budget.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The tokens of a Minibex file, one ahead, and the words that are no names. What reading costs is bounded by a budget
// linear in the size of the file, the depth of recursion by `maximal_depth`.
class Minibex_tokens
{
protected:
  static constexpr int maximal_depth = 200;

  // Where reading goes on.
  struct Place
  {
    Minibex_lexer lexer;
    Minibex_token token;
  };

  Minibex_lexer m_lexer;
  Minibex_token m_token; // the next one
  Expansion_budget m_budget;
  int m_depth = 0;

  Minibex_tokens(std::string_view content, const std::string& file_name)
    : m_lexer(content, file_name), m_token(m_lexer.next()),
      m_budget(0x1p23 + 16.0 * static_cast<double>(content.size()))
  {}

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

  bool is_at_in() const { return m_token.is_name() && m_token.text == "in"; }

  Place place() const { return {m_lexer, m_token}; }

  // Runs exact arithmetic; its limits and its division by zero become errors at the given token.
  template <class Work>
  auto at(const Minibex_token& token, const Work& work) const
  {
    try {
      return work();
    } catch (const Parse_error&) {
      throw;
    } catch (const Invalid_input& error) {
      m_lexer.fail(token, error.what());
    }
  }

  // To read something again costs as much as to expand terms of the same number.
  void return_to(const Place& place)
  {
    const std::size_t distance = m_lexer.position() - (std::min)(m_lexer.position(), place.lexer.position());
    at(m_token, [&] { m_budget.spend(16.0 + static_cast<double>(distance)); });
    m_lexer = place.lexer;
    m_token = place.token;
  }

  void go_deeper()
  {
    if (++m_depth > maximal_depth)
      fail("parentheses nested more than " + std::to_string(maximal_depth) + " deep");
  }

  bool is_at_section() const
  {
    for (std::string_view word : {"constants", "variables", "parameters", "function", "minimize", "constraints"})
      if (m_token.is_keyword(word))
        return true;
    return false;
  }

  static bool is_function_of_minibex(std::string_view name)
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
    return is_function_of_minibex(token.text) || is_at_section();
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_TOKENS_H
