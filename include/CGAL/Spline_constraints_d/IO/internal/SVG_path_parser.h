// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_PATH_PARSER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_PATH_PARSER_H

#include <CGAL/Spline_constraints_d/IO/internal/Bezier_path.h>
#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/IO/internal/elliptical_arc.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Blanks with at most one comma among them; whether there was a comma.
inline bool skip_separator(Text_cursor& cursor)
{
  cursor.skip_blanks();
  const bool found = cursor.skip(',');
  cursor.skip_blanks();
  return found;
}

// Path data of SVG 1.1, section 8.3; what is no path data is an error.
class SVG_path_parser
{
  using Point = Exact_kernel::Point_2;
  using Vector = Exact_kernel::Vector_2;

  Text_cursor m_cursor;
  Bezier_path m_path{Point(0, 0)};
  std::vector<Bezier_path> m_finished;
  bool m_is_relative = false, m_has_begun = false;
  Point m_control{0, 0};          // the last control point of the curve before
  char m_kind_of_control = ' ';   // C or Q, if that was such a curve

public:
  explicit SVG_path_parser(const Text_cursor& data) : m_cursor(data) {}

  std::vector<Bezier_path> paths()
  {
    for (m_cursor.skip_blanks(); !m_cursor.is_at_end(); m_cursor.skip_blanks())
      parse_command();
    finish(m_path.target());
    return std::move(m_finished);
  }

private:
  void finish(const Point& next_source)
  {
    if (!m_path.empty())
      m_finished.push_back(std::move(m_path));
    m_path = Bezier_path(next_source);
  }

  void parse_command()
  {
    const std::size_t begin = m_cursor.position();
    const char letter = m_cursor.peek();
    const char upper = letter >= 'a' ? static_cast<char>(letter - 'a' + 'A') : letter;
    if (std::string("MLHVCSQTAZ").find(upper) == std::string::npos)
      m_cursor.fail("expected a command of path data");
    if (!m_has_begun && upper != 'M')
      m_cursor.fail("path data begins with M");
    m_has_begun = true;
    m_is_relative = letter != upper;
    m_cursor.advance();
    if (upper == 'Z') {
      m_path.close();
      finish(Point(m_path.source()));
      m_kind_of_control = ' ';
      return;
    }
    char command = upper;
    do {
      m_cursor.skip_blanks();
      parse_piece(command, begin);
      command = upper == 'M' ? 'L' : upper;
    } while (skip_separator(m_cursor) || m_cursor.is_at_number());
  }

  void parse_piece(char command, std::size_t begin)
  {
    char kind_of_control = ' ';
    switch (command) {
    case 'M': finish(point()); break;
    case 'L': m_path.add({point()}); break;
    case 'H': m_path.add({Point(coordinate(m_path.target().x()), m_path.target().y())}); break;
    case 'V': m_path.add({Point(m_path.target().x(), coordinate(m_path.target().y()))}); break;
    case 'C':
    case 'S': {
      const Point first = command == 'C' ? next_point() : reflected('C');
      m_control = next_point();
      m_path.add({first, m_control, point()});
      kind_of_control = 'C';
      break;
    }
    case 'Q':
    case 'T':
      m_control = command == 'Q' ? next_point() : reflected('Q');
      m_path.add({m_control, point()});
      kind_of_control = 'Q';
      break;
    default: parse_arc(begin);
    }
    m_kind_of_control = kind_of_control;
  }

  void parse_arc(std::size_t begin)
  {
    const Exact_rational rx = CGAL::abs(next_number()), ry = CGAL::abs(next_number()), angle = next_number();
    const bool is_large = flag(), is_positive = flag();
    const Point target = point();
    if (rx == 0 || ry == 0)
      return m_path.add({target});
    try {
      add_elliptical_arc(m_path, {unit_vector_of_degrees(angle), rx, ry}, is_large, is_positive, target);
    } catch (const Invalid_input& error) {
      m_cursor.fail_at(begin, error.what());
    }
  }

  Exact_rational coordinate(const Exact_rational& origin)
  {
    const Exact_rational x = m_cursor.number("a coordinate");
    return m_is_relative ? Exact_rational(origin + x) : x;
  }

  Point point()
  {
    const Point origin = m_path.target();
    const Exact_rational x = coordinate(origin.x());
    skip_separator(m_cursor);
    const Exact_rational y = coordinate(origin.y());
    return {x, y};
  }

  // The same with a separator after it, where something has to follow.
  Point next_point()
  {
    const Point p = point();
    skip_separator(m_cursor);
    return p;
  }

  Exact_rational next_number()
  {
    const Exact_rational x = m_cursor.number("a number");
    skip_separator(m_cursor);
    return x;
  }

  // Flags are one character each, and need no separator.
  bool flag()
  {
    const char c = m_cursor.peek();
    if (c != '0' && c != '1')
      m_cursor.fail("expected a flag, 0 or 1");
    m_cursor.advance();
    skip_separator(m_cursor);
    return c == '1';
  }

  Point reflected(char kind) const
  {
    return m_kind_of_control == kind ? m_path.target() + (m_path.target() - m_control) : m_path.target();
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_PATH_PARSER_H
