// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_G2_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_G2_H

#include <CGAL/Spline_constraints_d/IO/internal/decimal_text.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <class Object>
void write_g2_object(std::ostream& out, const Object& object)
{
  constexpr int d = Object::ambient_dimension, parameters = Object::number_of_parameters;
  const auto& functions = object.representation().functions();
  const auto text = [](const auto& x) { return decimal_text(converted_number<Exact_rational>(x)); };
  out << 100 * parameters << " 1 0 0\n" << d << ' ' << (object.is_rational() ? 1 : 0) << '\n';
  for (int axis = 0; axis < parameters; ++axis) {
    out << functions[0].size(axis) << ' ' << functions[0].degree(axis) + 1 << '\n';
    for (const auto& knot : functions[0].knots(axis))
      out << text(knot) << ' ';
    out << '\n';
  }
  const std::size_t rows = functions[0].size(0), columns = parameters == 1 ? 1 : functions[0].size(parameters - 1);
  for (std::size_t j = 0; j < columns; ++j)
    for (std::size_t i = 0; i < rows; ++i) {
      for (const auto& function : functions)
        out << text(function.coefficients()[i * columns + j]) << ' ';
      out << '\n';
    }
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

writes a curve in the g2 format of the library GoTools, as `read_g2()` reads it back; several can be written one after
another. Numbers are exact if they have 60 decimals at most, else the nearest doubles.
\param out where it is written to.
\param curve a curve in the plane or in space.
*/
template <SplineKernel Kernel, int d>
void write_g2(std::ostream& out, const Bspline_curve<Kernel, d>& curve)
{
  internal::write_g2_object(out, curve);
}

//! \ingroup PkgSplineConstraintsDIO
//! writes a surface in the same way.
template <SplineKernel Kernel>
void write_g2(std::ostream& out, const Bspline_surface_3<Kernel>& surface)
{
  internal::write_g2_object(out, surface);
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_G2_H
