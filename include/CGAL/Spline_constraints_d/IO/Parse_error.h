// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_PARSE_ERROR_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_PARSE_ERROR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

What readers throw when a file is not what they expect. `what()` is `file:line:column: message near 'text'`.
*/
class Parse_error
  : public Invalid_input
{
  std::string m_file, m_message, m_text;
  int m_line, m_column;

public:
  //! \param file the name of the file, as it was given to the reader.
  //! \param line,column where the offending text begins, counted from 1; both 0 when the file could not be read at all.
  //! \param message what is wrong.
  //! \param text the offending text; empty for the end of the file.
  Parse_error(std::string file, int line, int column, std::string message, std::string text)
    : Invalid_input(full_message(file, line, column, message, text)), m_file(std::move(file)),
      m_message(std::move(message)), m_text(std::move(text)), m_line(line), m_column(column)
  {}

  //! the name of the file, as it was given to the reader.
  const std::string& file() const { return m_file; }

  //! the line of the offending text, from 1; 0 when the file could not be read at all.
  int line() const { return m_line; }

  //! the column of its first byte, from 1; 0 when the file could not be read at all.
  int column() const { return m_column; }

  //! the offending text (at most 60 bytes of it); empty at the end of the file.
  const std::string& text() const { return m_text; }

  //! what is wrong, without the place.
  const std::string& message() const { return m_message; }

private:
  static std::string full_message(const std::string& file, int line, int column, const std::string& message,
                                  const std::string& text);

  // Other bytes than printable ASCII are shown as \xNN, so that a message never upsets a terminal.
  static std::string printable(const std::string& text);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::string Parse_error::full_message(const std::string& file, int line, int column,
                                                                     const std::string& message,
                                                                     const std::string& text)
{
  if (line == 0)
    return file + ": " + message;
  return file + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + message + " near " +
      (text.empty() ? std::string("the end of the file") : '\'' + printable(text) + '\'');
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string Parse_error::printable(const std::string& text)
{
  const char* const digits = "0123456789abcdef";
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f)
      result += c;
    else
      result += std::string("\\x") + digits[byte >> 4] + digits[byte & 15];
  }
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_PARSE_ERROR_H
