// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_LEXER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_LEXER_H

#include <CGAL/Spline_constraints_d/IO/Parse_error.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

struct Minibex_token
{
  enum class Kind { NAME, NUMBER, SYMBOL, END_OF_FILE };

  Kind kind = Kind::END_OF_FILE;
  std::string_view text;   // into the file's content
  int line = 1, column = 1;

  bool is(std::string_view symbol) const { return kind == Kind::SYMBOL && text == symbol; }
  bool is_name() const { return kind == Kind::NAME; }
  bool is_number() const { return kind == Kind::NUMBER; }

  // Keywords are written in lower case, in upper case, or with a capital.
  bool is_keyword(std::string_view lower_case) const
  {
    if (kind != Kind::NAME || text.size() != lower_case.size())
      return false;
    const auto upper = [](char c) { return static_cast<char>(c - 'a' + 'A'); };
    if (text == lower_case)
      return true;
    if (text[0] != upper(lower_case[0]))
      return false;
    return text.substr(1) == lower_case.substr(1)
           || std::equal(text.begin(), text.end(), lower_case.begin(), [&](char a, char b) { return a == upper(b); });
  }
};

/*
Cuts the content of a Minibex file into tokens, one at a time, in time linear in the content. Lines end with LF, CR LF
or CR.
*/
class Minibex_lexer
{
  std::string_view m_content;
  const std::string* m_file_name;
  std::size_t m_position = 0, m_line_begin = 0;
  int m_line = 1;

public:
  Minibex_lexer(std::string_view content, const std::string& file_name) : m_content(content), m_file_name(&file_name)
  {
    if (m_content.substr(0, 3) == "\xEF\xBB\xBF")   // a byte order mark
      m_content.remove_prefix(3);
  }

  [[noreturn]] void fail(const Minibex_token& token, const std::string& message) const
  {
    throw Parse_error(*m_file_name, token.line, token.column, message, std::string(token.text.substr(0, 60)));
  }

  // Of the next character.
  std::size_t position() const { return m_position; }

  Minibex_token next()
  {
    skip_blanks();
    Minibex_token token = token_here(0);
    if (m_position == m_content.size())
      return token;
    const char c = peek();
    std::size_t size = 1;
    if (is_letter(c)) {
      token.kind = Minibex_token::Kind::NAME;
      while (is_letter(peek(size)) || is_digit(peek(size)))
        ++size;
    } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
      token.kind = Minibex_token::Kind::NUMBER;
      size = size_of_number();
    } else {
      token.kind = Minibex_token::Kind::SYMBOL;
      if ((c == '<' || c == '>') && peek(1) == '=')
        size = 2;
      else if (std::string_view("+-*/^()[],;=<>:").find(c) == std::string_view::npos)
        fail(token_here(1), "unexpected character");
    }
    token.text = m_content.substr(m_position, size);
    m_position += size;
    return token;
  }

private:
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

  char peek(std::size_t ahead = 0) const
  {
    return m_position + ahead < m_content.size() ? m_content[m_position + ahead] : '\0';
  }

  Minibex_token token_here(std::size_t size) const
  {
    return {Minibex_token::Kind::END_OF_FILE, m_content.substr(m_position, size), m_line,
            static_cast<int>(m_position - m_line_begin) + 1};
  }

  // digits [. digits] or . digits, then an optional exponent
  std::size_t size_of_number() const
  {
    std::size_t size = 0;
    const auto skip_digits = [&] {
      while (is_digit(peek(size)))
        ++size;
    };
    skip_digits();
    if (peek(size) == '.') {
      ++size;
      skip_digits();
    }
    if (peek(size) == 'e' || peek(size) == 'E') {
      const std::size_t sign = peek(size + 1) == '+' || peek(size + 1) == '-' ? 1 : 0;
      if (!is_digit(peek(size + 1 + sign)))
        fail(token_here(size + 1 + sign), "a number with an exponent that has no digits");
      size += 1 + sign;
      skip_digits();
    }
    return size;
  }

  void skip_blanks()
  {
    for (;;) {
      const char c = peek();
      if (m_position == m_content.size())
        return;
      if (c == ' ' || c == '\t' || c == '\f' || c == '\v')
        ++m_position;
      else if (c == '\n' || c == '\r')
        skip_line_end();
      else if (c == '/' && peek(1) == '/')
        while (m_position < m_content.size() && peek() != '\n' && peek() != '\r')
          ++m_position;
      else if (c == '/' && peek(1) == '*')
        skip_long_comment();
      else
        return;
    }
  }

  void skip_line_end()
  {
    m_position += peek() == '\r' && peek(1) == '\n' ? 2 : 1;
    ++m_line;
    m_line_begin = m_position;
  }

  void skip_long_comment()
  {
    const Minibex_token begin = token_here(2);
    m_position += 2;
    while (!(peek() == '*' && peek(1) == '/')) {
      if (m_position == m_content.size())
        fail(begin, "a comment that is not closed");
      if (peek() == '\n' || peek() == '\r')
        skip_line_end();
      else
        ++m_position;
    }
    m_position += 2;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_MINIBEX_LEXER_H
