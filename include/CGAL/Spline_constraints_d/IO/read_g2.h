// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_READ_G2_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_READ_G2_H

#include <CGAL/Spline_constraints_d/IO/Spline_file.h>
#include <CGAL/Spline_constraints_d/IO/internal/Spline_net.h>
#include <CGAL/Spline_constraints_d/IO/internal/Spline_net_parser.h>
#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <cstddef>
#include <istream>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Numbers between blanks.
class G2_parser : Spline_net_parser
{
public:
  explicit G2_parser(const Text_source& source) : Spline_net_parser(source) {}

  template <SplineKernel Kernel>
  Spline_file<Kernel> file()
  {
    Spline_file<Kernel> result;
    for (m_cursor.skip_blanks(); !m_cursor.is_at_end(); m_cursor.skip_blanks()) {
      const std::size_t begin = m_cursor.position();
      add(parse_object(), result, "", begin);
    }
    return result;
  }

private:
  Spline_net parse_object();
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Spline_net G2_parser::parse_object()
{
  const std::size_t begin = m_cursor.position();
  const int type = integer(0, 1000000, "the type of a class");
  if (type != 100 && type != 200)
    m_cursor.fail_at(begin, "only the classes 100 (curves) and 200 (surfaces) are supported,");
  integer(0, 1000, "a version");
  integer(0, 1000, "a version");
  for (int left = integer(0, 1000, "the number of auxiliary data"); left > 0; --left)
    number("auxiliary data");
  Spline_net net;
  net.dimension = integer(2, 3, "the dimension");
  net.is_rational = integer(0, 1, "whether there are weights") == 1;
  net.axes.resize(type == 100 ? 1 : 2);
  for (auto& axis : net.axes) {
    axis.size = parse_size();
    axis.order = parse_order(axis.size);
    parse_knots(axis);
  }
  check_size(net);
  for (std::size_t left = net.number_of_points(); left > 0; --left)
    net.points.push_back(parse_coordinates(net));
  return net;
}
#endif

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

reads the curves and surfaces of a file in the g2 format of the library GoTools: its classes 100 (`SplineCurve`), in the
plane or in space, and 200 (`SplineSurface`), in space, rational or not.

Each begins with its class, two numbers of a version, and the number of auxiliary data with these; then follow the
dimension, 1 or 0 for rational or not, for each parameter the number of control points, the order and the knots, and the
control points, the first parameter fastest; those of rational ones are multiplied by their weight, which comes last.

Numbers are taken as the decimals they are, so that objects are exact in exact kernels.

\tparam Kernel the kernel of the curves and surfaces, a `SplineKernel`; those of floating point numbers round what has
been read exactly.
\param in the file's content.
\param file_name how errors call the file.
\throws Parse_error with line, column and the offending text, when the content is not of this form, another class is
found, an order is above 100 or above the number of control points, a number has more than
        400 characters or an exponent beyond 400, knots or weights are not valid, or a surface is in the plane; also
        when the stream fails.

Complexity: linear in the length of the file.
*/
template <SplineKernel Kernel>
Spline_file<Kernel> read_g2(std::istream& in, const std::string& file_name)
{
  return internal::G2_parser(internal::Text_source::read(in, file_name)).template file<Kernel>();
}

/*!
\ingroup PkgSplineConstraintsDIO

reads the file of the given path.
\throws Parse_error as above, and when the file cannot be opened.
*/
template <SplineKernel Kernel>
Spline_file<Kernel> read_g2(const std::string& path)
{
  return internal::G2_parser(internal::Text_source::read(path)).template file<Kernel>();
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_READ_G2_H
