// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_PLANAR_LAYERS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_PLANAR_LAYERS_2_H

#include <CGAL/Spline_constraints_d/IO/planar_layers_2.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_WKT.h>

#include <ostream>
#include <string>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

draws layers into an SVG drawing, each as a layer of its name and in its color: areas filled, polylines and points on
them.
\param picture where to.
\param layers what is drawn.
\param width of polylines, in pixels.
*/
template <SplineKernel Kernel>
void draw(SVG_writer& picture, const Planar_layers_2<Kernel>& layers, double width = 2.5)
{
  for (const Planar_layer_2<Kernel>& layer : layers) {
    picture.layer(layer.name);
    for (const auto& area : layer.areas)
      picture.polygon(area, layer.color);
    for (const auto& line : layer.lines)
      picture.polyline(line, layer.color, width);
    for (const auto& point : layer.points)
      picture.point(point, layer.color, 3 * width);
  }
}

/*!
\ingroup PkgSplineConstraintsDIO

draws the `planar_layers()` of a result, with an error of an eighth of a pixel.
\tparam Result what a planar operation returns.
\param picture where to.
\param result what is drawn.
\param width of polylines, in pixels.
*/
template <internal::Planar_result Result>
void draw(SVG_writer& picture, const Result& result, double width = 2.5)
{
  draw(picture, planar_layers(result, picture.pixel() / 8), width);
}

//! \ingroup PkgSplineConstraintsDIO
//! draws the edges of a diagram, a medial axis or a trimmed bisector as above, as far as the radius of their disks is
//! at most the larger extent of the view.
template <internal::Unbounded_planar_result Result>
void draw(SVG_writer& picture, const Result& result, double width = 2.5)
{
  draw(picture, planar_layers(result, picture.pixel() / 8, picture.extent()), width);
}

namespace internal {

template <class Range>
std::string WKT_line_of(const Range& points)
{
  return listed(points, [](const auto& p) { return WKT_point(p.x(), p.y()); });
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

writes layers as well-known text (WKT): for each, a line with its areas, `POLYGON` or `MULTIPOLYGON`, one with its
polylines, `MULTILINESTRING`, and one with its points, `MULTIPOINT`, in this order; those that are not there are left
out. Coordinates are rounded to doubles, and are read back as those, for instance by `CGAL::IO::read_WKT()`. Names are
not written.
\param out where the text is written to.
\param layers what is written.
*/
template <SplineKernel Kernel>
void write_WKT(std::ostream& out, const Planar_layers_2<Kernel>& layers)
{
  for (const Planar_layer_2<Kernel>& layer : layers) {
    if (!layer.areas.empty())
      write_WKT(out, layer.areas);
    if (!layer.lines.empty())
      out << "MULTILINESTRING "
          << internal::listed(layer.lines, [](const auto& line) { return internal::WKT_line_of(line); }) << '\n';
    if (!layer.points.empty())
      out << "MULTIPOINT " << internal::WKT_line_of(layer.points) << '\n';
  }
}

/*!
\ingroup PkgSplineConstraintsDIO

writes the `planar_layers()` of a result as above. A `Planar_region_2` is written with its circular arcs instead, by its
own overload.
\tparam Result what a planar operation returns.
\param out where the text is written to.
\param result what is written.
\param error the distance between curves and chords; positive.
\throws Invalid_input when the error is not positive.
*/
template <internal::Planar_result Result>
void write_WKT(std::ostream& out, const Result& result, double error)
{
  write_WKT(out, planar_layers(result, error));
}

//! \ingroup PkgSplineConstraintsDIO
//! writes the edges of a diagram, a medial axis or a trimmed bisector, which may be unbounded, as above. \throws
//! Invalid_input as `planar_layers()` does.
template <internal::Unbounded_planar_result Result>
void write_WKT(std::ostream& out, const Result& result, double error, double most_radius)
{
  write_WKT(out, planar_layers(result, error, most_radius));
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_PLANAR_LAYERS_2_H
