// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_TEXT_SOURCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_TEXT_SOURCE_H

#include <CGAL/Spline_constraints_d/IO/Parse_error.h>
#include <CGAL/Spline_constraints_d/IO/internal/decimal_number.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <istream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The content of a file, and where its lines begin. Lines end with LF, CR LF or CR.
class Text_source
{
  std::string m_content, m_file_name;
  std::vector<std::size_t> m_line_begins{0};

public:
  Text_source(std::string content, std::string file_name);

  static Text_source read(std::istream& in, const std::string& file_name);

  static Text_source read(const std::string& path);

  std::string_view content() const { return m_content; }

  // Line and column of a byte, both from 1.
  std::pair<int, int> place(std::size_t position) const;

  [[noreturn]] void fail(std::size_t position, std::size_t size, const std::string& message) const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Text_source::Text_source(std::string content, std::string file_name)
  : m_content(std::move(content)), m_file_name(std::move(file_name))
{
  if (m_content.substr(0, 3) == "\xEF\xBB\xBF") // a byte order mark
    m_content.erase(0, 3);
  for (std::size_t i = 0; i < m_content.size(); ++i)
    if (m_content[i] == '\n' || (m_content[i] == '\r' && m_content.substr(i + 1, 1) != "\n"))
      m_line_begins.push_back(i + 1);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Text_source Text_source::read(std::istream& in, const std::string& file_name)
{
  if (!in)
    throw Parse_error(file_name, 0, 0, "cannot be read", "");
  std::string content{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (in.bad())
    throw Parse_error(file_name, 0, 0, "cannot be read", "");
  return Text_source(std::move(content), file_name);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Text_source Text_source::read(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  if (!in)
    throw Parse_error(path, 0, 0, "cannot be opened", "");
  in.peek(); // a directory opens, but cannot be read
  if (in.bad())
    throw Parse_error(path, 0, 0, "cannot be read", "");
  in.clear();
  return read(in, path);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<int, int> Text_source::place(std::size_t position) const
{
  const auto line = std::upper_bound(m_line_begins.begin(), m_line_begins.end(), position);
  return {static_cast<int>(line - m_line_begins.begin()), static_cast<int>(position - *(line - 1)) + 1};
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Text_source::fail(std::size_t position, std::size_t size,
                                                      const std::string& message) const
{
  const auto [line, column] = place(position);
  throw Parse_error(m_file_name, line, column, message, m_content.substr(position, (std::min)(size, std::size_t(60))));
}
#endif

// Reads a part of a source from its begin to its end.
class Text_cursor
{
  static constexpr std::size_t maximal_size_of_number = 400;
  static constexpr int maximal_exponent = 400;

  const Text_source* m_source;
  std::size_t m_position, m_end;

public:
  Text_cursor(const Text_source& source, std::size_t begin, std::size_t size)
    : m_source(&source), m_position(begin), m_end(begin + size)
  {}
  explicit Text_cursor(const Text_source& source) : Text_cursor(source, 0, source.content().size()) {}

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v'; }

  bool is_at_end() const { return m_position >= m_end; }
  std::size_t position() const { return m_position; }
  char peek(std::size_t ahead = 0) const
  {
    return m_position + ahead < m_end ? m_source->content()[m_position + ahead] : '\0';
  }
  void advance(std::size_t size = 1) { m_position += size; }
  std::string_view rest() const { return m_source->content().substr(m_position, m_end - m_position); }

  void skip_blanks();

  bool skip(char c);

  // The next word, up to a blank or one of the given characters, is what is wrong.
  [[noreturn]] void fail(const std::string& message, std::string_view stops = "") const
  {
    fail_at(m_position, message, stops);
  }

  [[noreturn]] void fail_at(std::size_t position, const std::string& message, std::string_view stops = "") const;

  bool is_at_number() const;

  // A decimal number, exactly.
  Exact_rational number(const std::string& what);

  // An integer from a range.
  int integer(int lower, int upper, const std::string& what);

private:
  void skip_digits();
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Text_cursor::skip_blanks()
{
  while (is_blank(peek()))
    advance();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Text_cursor::skip(char c)
{
  const bool found = peek() == c && !is_at_end();
  advance(found ? 1 : 0);
  return found;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Text_cursor::fail_at(std::size_t position, const std::string& message,
                                                         std::string_view stops) const
{
  const std::string_view text = m_source->content().substr(position, m_end - position);
  std::size_t size = text.empty() ? 0 : 1;
  while (size < text.size() && !is_blank(text[size]) && stops.find(text[size]) == std::string_view::npos)
    ++size;
  m_source->fail(position, size, message);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Text_cursor::is_at_number() const
{
  const std::size_t sign = peek() == '+' || peek() == '-' ? 1 : 0;
  return is_digit(peek(sign)) || (peek(sign) == '.' && is_digit(peek(sign + 1)));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Text_cursor::number(const std::string& what)
{
  if (!is_at_number())
    fail("expected " + what);
  const std::size_t begin = m_position;
  const bool is_negative = peek() == '-';
  advance(peek() == '-' || peek() == '+' ? 1 : 0);
  const std::size_t first = m_position;
  skip_digits();
  if (skip('.'))
    skip_digits();
  int exponent = 0;
  const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
  if ((peek() == 'e' || peek() == 'E') && is_digit(peek(1 + sign)))
    for (advance(1 + sign); is_digit(peek()); advance())
      exponent = (std::min)(10 * exponent + (peek() - '0'), maximal_exponent + 1);
  if (m_position - begin > maximal_size_of_number || exponent > maximal_exponent)
    fail_at(begin, "a number of too many digits");
  Expansion_budget budget(1e9); // the limits are above
  const Exact_rational value = decimal_number(m_source->content().substr(first, m_position - first), budget);
  return is_negative ? Exact_rational(-value) : value;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Text_cursor::integer(int lower, int upper, const std::string& what)
{
  const std::size_t begin = m_position;
  const Exact_rational value = number(what);
  for (std::size_t i = begin; i < m_position; ++i)
    if (!is_digit(m_source->content()[i]) &&
        !(i == begin && !is_letter(m_source->content()[i]) && m_source->content()[i] != '.'))
      fail_at(begin, "expected " + what + ", an integer");
  if (value < lower || value > upper)
    fail_at(begin, what + " is not between " + std::to_string(lower) + " and " + std::to_string(upper));
  return std::stoi(std::string(m_source->content().substr(begin, m_position - begin)));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Text_cursor::skip_digits()
{
  while (is_digit(peek()))
    advance();
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_TEXT_SOURCE_H
