// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_READ_IRIT_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_READ_IRIT_H

#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/IO/internal/Spline_net.h>
#include <CGAL/Spline_constraints_d/IO/internal/Spline_net_parser.h>
#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <istream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Blocks in brackets within each other; what is outside of them is a comment.
class IRIT_parser : Spline_net_parser
{
  static constexpr int maximal_depth = 200;

public:
  explicit IRIT_parser(const Text_source& source) : Spline_net_parser(source) {}

  template <SplineKernel Kernel>
  Spline_file<Kernel> file()
  {
    Spline_file<Kernel> result;
    for (skip_text(); !m_cursor.is_at_end(); skip_text()) {
      if (m_cursor.peek() == ']')
        m_cursor.fail("a bracket that was not opened");
      parse_block(result, "", 1);
    }
    return result;
  }

private:
  // To the next bracket.
  void skip_text();

  // Strings in quotes may have brackets and blanks in them.
  std::string skip_word();

  std::string next_word();

  void expect(char c);

  void fail_if_not_closed(std::size_t begin) const;

  template <SplineKernel Kernel>
  void parse_block(Spline_file<Kernel>& file, const std::string& outer_name, int depth)
  {
    const std::size_t begin = m_cursor.position();
    if (depth > maximal_depth)
      m_cursor.fail("more than " + std::to_string(maximal_depth) + " blocks within each other");
    expect('[');
    const std::string kind = next_word();
    if (kind == "CURVE" || kind == "SURFACE") {
      add(parse_net(kind == "CURVE" ? 1 : 2, depth), file, outer_name, begin);
      return;
    }
    if (kind == "TRIMSRF" || kind == "TRIVAR" || kind == "MULTIVAR" || kind == "MODEL")
      m_cursor.fail_at(begin, "blocks " + kind + " are not supported", "]");
    if (kind != "OBJECT") {
      skip_to_end(begin, depth);
      return;
    }
    // Attributes come first, then the name, then what the object is.
    std::string name = outer_name;
    for (m_cursor.skip_blanks(); m_cursor.peek() != ']' || m_cursor.is_at_end(); m_cursor.skip_blanks()) {
      fail_if_not_closed(begin);
      if (m_cursor.peek() == '[')
        parse_block(file, name, depth + 1);
      else
        name = skip_word();
    }
    m_cursor.advance();
  }

  void skip_to_end(std::size_t begin, int depth);

  // After SURFACE or CURVE, to the end of the block.
  Spline_net parse_net(std::size_t parameters, int depth);

  decltype(Spline_net::axes)::value_type bezier_axis(int size) const;

  void parse_type_of_points(Spline_net& net);

  // Blocks that begin with a word, but for those of knots.
  void skip_attributes(int depth);

  template <class Axis>
  void parse_block_of_knots(Axis& axis)
  {
    expect('[');
    const std::size_t begin = m_cursor.position();
    const std::string kind = next_word();
    if (kind != "KV" && kind != "KVP")
      m_cursor.fail_at(begin, "expected KV or KVP", "[]");
    axis.is_periodic = kind == "KVP";
    parse_knots(axis);
    expect(']');
  }

  // The weight is first in the file.
  std::vector<Exact_rational> parse_point(const Spline_net& net);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void IRIT_parser::skip_text()
{
  while (!m_cursor.is_at_end() && m_cursor.peek() != '[' && m_cursor.peek() != ']')
    skip_word();
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string IRIT_parser::skip_word()
{
  const std::size_t begin = m_cursor.position();
  if (m_cursor.skip('"')) {
    while (!m_cursor.is_at_end() && m_cursor.peek() != '"')
      m_cursor.advance(m_cursor.peek() == '\\' && m_cursor.peek(1) != '\0' ? 2 : 1);
    m_cursor.advance(m_cursor.is_at_end() ? 0 : 1);
  } else
    do
      m_cursor.advance();
    while (!m_cursor.is_at_end() && !Text_cursor::is_blank(m_cursor.peek()) &&
           std::string("[]\"").find(m_cursor.peek()) == std::string::npos);
  return std::string(m_source.content().substr(begin, m_cursor.position() - begin));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string IRIT_parser::next_word()
{
  m_cursor.skip_blanks();
  return m_cursor.is_at_end() || m_cursor.peek() == '[' || m_cursor.peek() == ']' ? std::string() : skip_word();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void IRIT_parser::expect(char c)
{
  m_cursor.skip_blanks();
  if (!m_cursor.skip(c))
    m_cursor.fail(std::string("expected '") + c + "'", "[]");
}

CGAL_SPLINE_CONSTRAINTS_INLINE void IRIT_parser::fail_if_not_closed(std::size_t begin) const
{
  if (m_cursor.is_at_end())
    m_cursor.fail_at(begin, "a bracket that is not closed");
}

CGAL_SPLINE_CONSTRAINTS_INLINE void IRIT_parser::skip_to_end(std::size_t begin, int depth)
{
  for (int open = 1; open > 0;) {
    skip_text();
    fail_if_not_closed(begin);
    open += m_cursor.peek() == '[' ? 1 : -1;
    if (depth + open > maximal_depth)
      m_cursor.fail("more than " + std::to_string(maximal_depth) + " blocks within each other");
    m_cursor.advance();
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Spline_net IRIT_parser::parse_net(std::size_t parameters, int depth)
{
  Spline_net net;
  net.axes.resize(parameters);
  m_cursor.skip_blanks();
  const std::size_t begin = m_cursor.position();
  const std::string form = next_word();
  if (form != "BSPLINE" && form != "BEZIER")
    m_cursor.fail_at(begin, "expected BSPLINE or BEZIER", "[]");
  for (auto& axis : net.axes)
    axis.size = parse_size();
  for (auto& axis : net.axes)
    if (form == "BSPLINE")
      axis.order = parse_order(axis.size);
    else
      axis = bezier_axis(axis.size);
  parse_type_of_points(net);
  skip_attributes(depth);
  if (form == "BSPLINE")
    for (auto& axis : net.axes)
      parse_block_of_knots(axis);
  check_size(net);
  for (std::size_t left = net.number_of_points(); left > 0; --left)
    net.points.push_back(parse_point(net));
  expect(']');
  return net;
}

CGAL_SPLINE_CONSTRAINTS_INLINE decltype(Spline_net::axes)::value_type IRIT_parser::bezier_axis(int size) const
{
  decltype(Spline_net::axes)::value_type axis{size, size, {}, false};
  if (size > 100)
    m_cursor.fail("Bezier curves and surfaces of an order above 100 are not supported,");
  axis.knots.assign(static_cast<std::size_t>(size), Exact_rational(0));
  axis.knots.insert(axis.knots.end(), static_cast<std::size_t>(size), Exact_rational(1));
  return axis;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void IRIT_parser::parse_type_of_points(Spline_net& net)
{
  m_cursor.skip_blanks();
  const std::size_t begin = m_cursor.position();
  const std::string type = next_word();
  if (type != "E2" && type != "E3" && type != "P2" && type != "P3")
    m_cursor.fail_at(begin, "expected the type of the control points, E2, E3, P2 or P3", "[]");
  net.is_rational = type[0] == 'P';
  net.dimension = type[1] - '0';
}

CGAL_SPLINE_CONSTRAINTS_INLINE void IRIT_parser::skip_attributes(int depth)
{
  for (m_cursor.skip_blanks();
       m_cursor.peek() == '[' && Text_cursor::is_letter(m_cursor.peek(1)) && m_cursor.rest().substr(1, 2) != "KV";
       m_cursor.skip_blanks()) {
    const std::size_t begin = m_cursor.position();
    m_cursor.advance();
    skip_to_end(begin, depth);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_rational> IRIT_parser::parse_point(const Spline_net& net)
{
  expect('[');
  std::vector<Exact_rational> point = parse_coordinates(net);
  expect(']');
  if (net.is_rational)
    std::rotate(point.begin(), point.begin() + 1, point.end());
  return point;
}
#endif

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

reads the curves and surfaces of a data file of the solid modeller IRIT (`.itd`): the blocks `CURVE` and `SURFACE`,
`BSPLINE` or `BEZIER`, in objects and groups of objects. Their name is that of the innermost object that has one.

Control points are of the type `E2`, `E3`, `P2` or `P3`; those of the last two are the weight and the coordinates
multiplied by it. A `BEZIER` curve is over \f$[0,1]\f$. An axis with periodic knots (`KVP`) is unwrapped: its first
control points come again at the end. Text outside of brackets, attributes, and blocks of other objects like `POLYGON`
or `MATRIX` are skipped.

Numbers are taken as the decimals they are, so that objects are exact in exact kernels.

\tparam Kernel the kernel of the curves and surfaces, a `SplineKernel`; those of floating point numbers round what has
been read exactly.
\param in the file's content.
\param file_name how errors call the file.
\throws Parse_error with line, column and the offending text, when the content is not of this form, blocks are nested
more than 200 deep, an order is above 100 or above the number of control points, a number has more
        than 400 characters or an exponent beyond 400, knots or weights are not valid, a surface is in the plane, or
        there is a block `TRIMSRF`, `TRIVAR`, `MULTIVAR` or `MODEL`; also when the stream fails.

Complexity: linear in the length of the file.
*/
template <SplineKernel Kernel>
Spline_file<Kernel> read_IRIT(std::istream& in, const std::string& file_name)
{
  return internal::IRIT_parser(internal::Text_source::read(in, file_name)).template file<Kernel>();
}

/*!
\ingroup PkgSplineConstraintsDIO

reads the file of the given path.
\throws Parse_error as above, and when the file cannot be opened.
*/
template <SplineKernel Kernel>
Spline_file<Kernel> read_IRIT(const std::string& path)
{
  return internal::IRIT_parser(internal::Text_source::read(path)).template file<Kernel>();
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_READ_IRIT_H
