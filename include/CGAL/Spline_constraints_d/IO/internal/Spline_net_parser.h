// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SPLINE_NET_PARSER_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SPLINE_NET_PARSER_H

#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/IO/internal/Spline_net.h>
#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What the parsers of files of splines have in common: numbers after blanks, and what the file bounds or refuses.
class Spline_net_parser
{
  static constexpr int maximal_order = 100;

protected:
  const Text_source& m_source;
  Text_cursor m_cursor;

  explicit Spline_net_parser(const Text_source& source) : m_source(source), m_cursor(source) {}

  int integer(int lower, int upper, const std::string& what);

  Exact_rational number(const std::string& what);

  // Sizes and orders are bounded by what can follow in the file.
  int parse_size();

  int parse_order(int size) { return integer(1, (std::min)(maximal_order, size), "the order"); }

  template <class Axis>
  void parse_knots(Axis& axis)
  {
    for (int left = axis.unwrapped_size() + axis.order; left > 0; --left)
      axis.knots.push_back(number("a knot"));
  }

  // The coordinates, and the weight if there is one, in the order of the file.
  std::vector<Exact_rational> parse_coordinates(const Spline_net& net);

  // So that periodic axes do not make a small file large.
  void check_size(const Spline_net& net);

  // What begins at a position.
  template <SplineKernel Kernel>
  void add(const Spline_net& net, Spline_file<Kernel>& file, const std::string& name, std::size_t begin) const
  {
    try {
      net.add_to(file, name, m_source.place(begin));
    } catch (const Invalid_input& error) {
      m_cursor.fail_at(begin, error.what());
    }
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE int Spline_net_parser::integer(int lower, int upper, const std::string& what)
{
  m_cursor.skip_blanks();
  return m_cursor.integer(lower, upper, what);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Spline_net_parser::number(const std::string& what)
{
  m_cursor.skip_blanks();
  return m_cursor.number(what);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Spline_net_parser::parse_size()
{
  m_cursor.skip_blanks();
  const int most = static_cast<int>((std::min)(m_cursor.rest().size(), std::size_t(1) << 30));
  return integer(1, (std::max)(most, 1), "a number of control points that fits the file");
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_rational> Spline_net_parser::parse_coordinates(const Spline_net& net)
{
  std::vector<Exact_rational> result;
  for (int left = net.dimension + (net.is_rational ? 1 : 0); left > 0; --left)
    result.push_back(number("a coordinate"));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Spline_net_parser::check_size(const Spline_net& net)
{
  m_cursor.skip_blanks();
  if (net.number_of_points() > m_cursor.rest().size())
    m_cursor.fail("the file is too short for its control points,");
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SPLINE_NET_PARSER_H
