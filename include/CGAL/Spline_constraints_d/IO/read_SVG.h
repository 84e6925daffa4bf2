// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_READ_SVG_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_READ_SVG_H

#include <CGAL/Spline_constraints_d/IO/internal/SVG_exact_curve.h>
#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_PUGIXML
#include <CGAL/Spline_constraints_d/IO/internal/SVG_reader.h>
#endif

#include <concepts>
#include <istream>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

A curve of an SVG drawing: a shape, or one subpath of a path.
*/
template <SplineKernel Kernel>
struct SVG_curve
{
  //! the curve.
  Bspline_curve_2<Kernel> curve;
  //! the attribute `id` of its element; empty if there is none.
  std::string id;
  //! the name of the element: `path`, `line`, `polyline`, `polygon`, `rect`, `circle` or `ellipse`.
  std::string element;
  //! where the element begins in the file, counted from 1.
  int line = 0, column = 0;
};

namespace internal {

template <SplineKernel Kernel>
std::vector<SVG_curve<Kernel>> svg_curves(const Text_source& source)
{
  std::vector<SVG_curve<Kernel>> result;
  for (const SVG_exact_curve& exact : exact_curves_of_SVG(source)) {
    const auto [line, column] = source.place(exact.position);
    try {
      result.push_back({Bspline_curve_2<Kernel>(exact.curve), exact.id, exact.element, line, column});
    } catch (const Invalid_input& error) {
      source.fail(exact.position, 1 + exact.element.size(), error.what());
    }
  }
  return result;
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

reads the curves of an SVG drawing (SVG 1.1): the elements `path`, `line`, `polyline`, `polygon`, `rect`, `circle` and
`ellipse`, in the order of the document. It needs the library pugixml; programs link `pugixml::pugixml`.

- Coordinates are those of the drawing, in user units (96 to the inch), with \f$y\f$ negated: curves are seen as in a
  viewer when the \f$y\f$-axis points upwards.
  Transformations of elements and of groups `g` are applied, the `viewBox` is not.
- Each subpath becomes one curve. Its Bézier pieces are over \f$[i, i+1]\f$, have the degree of the highest, and are
  joined without any smoothness, as `bezier_pieces()`
  gives them back. Pieces
  of length zero are dropped, and so are curves without any other.
- Circles, ellipses and arcs are rational quadratic curves.
- Numbers are taken as the decimals they are; so curves are exact in exact kernels, except for these. *Rotations*, skews
  and rotated arcs by angles that are no multiples
  of 90 degrees have the tangent
  of half the angle rounded to double; a rotation stays a rotation. *Arcs* with an irrational center lie on an ellipse
  with half axes in the given ratio, and have the given end points; only its size is rounded, with a relative error of
  about \f$2^{-90}\f$ times the quotient of the half axis and the chord.
- Half axes of arcs that are too short are scaled, as SVG says; circles, ellipses and rectangles without extent are
  dropped.
- Only `svg`, `g`, `a` and `switch` are looked into; `defs`, `text`, `symbol` and others are not. `use` and `svg` within
  `svg` are errors, as are lengths in percent or
  relative to fonts. Styles are not read.

\tparam Kernel the kernel of the curves, a `SplineKernel`; those of floating point numbers round what has been read
exactly.
\param in the file's content, in UTF-8.
\param file_name how errors call the file.
\throws Parse_error with line, column and the offending text, when the content is no such drawing, a number has more
than 400 characters or an exponent beyond 400, elements are nested more
        than 200 deep, a transformation is not invertible, or an arc is not determined because its ends are next to each
        other; also when the stream fails.

Complexity: linear in the length of the file.
*/
template <SplineKernel Kernel>
std::vector<SVG_curve<Kernel>> read_SVG(std::istream& in, const std::string& file_name)
{
  return internal::svg_curves<Kernel>(internal::Text_source::read(in, file_name));
}

/*!
\ingroup PkgSplineConstraintsDIO

reads the file of the given path.
\throws Parse_error as above, and when the file cannot be opened.
*/
template <SplineKernel Kernel>
std::vector<SVG_curve<Kernel>> read_SVG(const std::string& path)
{
  return internal::svg_curves<Kernel>(internal::Text_source::read(path));
}

/*!
\ingroup PkgSplineConstraintsDIO

reads the curves of the file of the given path, without their names and places.
\throws Parse_error as `read_SVG()`.
*/
template <SplineKernel Kernel>
std::vector<Bspline_curve_2<Kernel>> read_SVG_curves(const std::string& path)
{
  std::vector<Bspline_curve_2<Kernel>> result;
  for (SVG_curve<Kernel>& element : read_SVG<Kernel>(path))
    result.push_back(std::move(element.curve));
  return result;
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_READ_SVG_H
