// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SVG_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SVG_H

#include <CGAL/Spline_constraints_d/IO/internal/decimal_text.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/bezier_chords.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <ranges>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <class Point>
std::string coordinate_text(const Point& p)
{
  return decimal_text(converted_number<Exact_rational>(p.x())) + ' ' +
      decimal_text(converted_number<Exact_rational>(p.y()));
}

// The box around curves, points or polygons, with a margin of a part of its larger extent.
template <class Range>
CGAL::Bbox_2 box_with_margin(const Range& objects, double share)
{
  CGAL::Bbox_2 box;
  for (const auto& object : objects)
    box += object.bbox();
  const double margin = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()) * share;
  return CGAL::Bbox_2(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin, box.ymax() + margin);
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIO

Draws curves, polygons, points and labels as SVG, with the \f$y\f$-axis upwards, on white.

What is drawn may be put into layers with names, which programs for drawings, such as Inkscape, show and hide one by
one.

Colors are those of SVG, for instance `red` or `#1f77b4`; widths of strokes, diameters of points and sizes of letters
are in pixels. `read_SVG()` reads the curves of the drawing back; those that are polynomial of degree three at most,
exactly, if the control points of their Bézier pieces are numbers of 60 decimals at most.
*/
class SVG_writer
{
  std::ostream& m_out;
  double m_pixel;
  double m_extent;
  double m_units;             // the coordinates of polylines are rounded to multiples of 1 / m_units, a power of ten
  bool m_has_layer = false;

public:
  /*!
  begins a drawing.
  \param out where it is written to.
  \param view what is seen.
  \param width in pixels.
  \throws Invalid_input when the view has no extent, or something is not finite.
  */
  SVG_writer(std::ostream& out, const CGAL::Bbox_2& view, double width = 600);

  /*!
  begins a drawing in which all of some curves, points or polygons is seen.
  \param out where it is written to.
  \param objects what is seen: a range of objects with a `bbox()`.
  \param width in pixels.
  \param margin around them, as a part of their larger extent.
  \throws Invalid_input when they have no extent, or something is not finite.
  */
  template <std::ranges::forward_range Range>
  SVG_writer(std::ostream& out, const Range& objects, double width = 600, double margin = 1. / 30)
    : SVG_writer(out, internal::box_with_margin(objects, margin), width)
  {
  }

  SVG_writer(const SVG_writer&) = delete;
  SVG_writer& operator=(const SVG_writer&) = delete;

  //! ends the drawing.
  ~SVG_writer() { m_out << (m_has_layer ? "</g>\n" : "") << "</g>\n</svg>\n"; }

  //! the size of a pixel, in units of the drawing: a measure for how exactly to draw.
  double pixel() const { return m_pixel; }

  //! the larger extent of what is seen.
  double extent() const { return m_extent; }

  //! begins a layer, above those before, which ends where the next one begins.
  void layer(const std::string& name);

  /*!
  draws a curve: if it is polynomial of degree three at most, as a path of lines and Bézier curves with its own control
  points (coordinates without an end after 60 decimals are rounded to double); else by chords with an error of a tenth
  of a pixel at most, up to rounding. Curves that are discontinuous are drawn connected.
  */
  template <SplineKernel Kernel>
  void curve(const Bspline_curve_2<Kernel>& curve, const std::string& color = "black", double width = 1.5)
  {
    const std::vector<Bspline_curve_2<Kernel>> pieces = curve.bezier_pieces();
    m_out << "<path d='M" << internal::coordinate_text(pieces.front().source());
    for (const Bspline_curve_2<Kernel>& piece : pieces)
      if (!piece.is_rational() && piece.degree() >= 1 && piece.degree() <= 3)
        write_polynomial(piece);
      else
        write_chords(piece);
    m_out << "' " << stroke(color, width) << "/>\n";
  }

  //! draws a point as a disk: a path of length zero with round ends.
  template <SplineKernel Kernel>
  void point(const CGAL::Point_2<Kernel>& p, const std::string& color = "black", double diameter = 7)
  {
    m_out << "<path d='M" << internal::coordinate_text(p) << "h0' stroke-linecap='round' " << stroke(color, diameter)
          << "/>\n";
  }

  /*!
  joins points by chords, their coordinates rounded by a fiftieth of a pixel at most: short numbers for what has many
  points.
  \param points a range of points: of a kernel, or arrays or vectors of coordinates, or samples whose member `point` is
  one of these, as polylines of bisectors, diagrams and curves of solutions
         have them. Of one point nothing is seen.
  \param color of SVG.
  \param width of the stroke, in pixels.
  */
  template <std::ranges::forward_range Range>
  void polyline(const Range& points, const std::string& color = "black", double width = 1.5)
  {
    m_out << "<path d='";
    write_ring(points);
    m_out << "' " << stroke(color, width) << "/>\n";
  }

  //! draws a circle. The numbers are rounded to double.
  template <SplineKernel Kernel>
  void circle(const CGAL::Point_2<Kernel>& center, const typename Kernel::FT& radius,
              const std::string& color = "black", double width = 1.5)
  {
    const auto text = [](const auto& x) { return internal::double_text(internal::converted_number<double>(x)); };
    m_out << "<circle cx='" << text(center.x()) << "' cy='" << text(center.y()) << "' r='" << text(radius) << "' "
          << stroke(color, width) << "/>\n";
  }

  //! fills a polygon, given as `polyline()` takes its points; an edge, in pixels, closes the gap to its neighbours.
  template <std::ranges::forward_range Range>
  void polygon(const Range& points, const std::string& color, double edge = 0.2)
  {
    m_out << "<path d='";
    write_ring(points);
    m_out << "Z' fill='" << color << "' " << stroke(color, edge) << "/>\n";
  }

  //! fills a polygon but for its holes, as above.
  template <class Kernel, class Container>
  void polygon(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon, const std::string& color)
  {
    m_out << "<path d='";
    write_ring(polygon.outer_boundary());
    for (const auto& hole : polygon.holes()) {
      m_out << "Z";
      write_ring(hole);
    }
    m_out << "Z' fill='" << color << "' fill-rule='evenodd' " << stroke(color, 0.2) << "/>\n";
  }

  //! writes a text that begins at a point.
  template <SplineKernel Kernel>
  void label(const CGAL::Point_2<Kernel>& p, const std::string& text, const std::string& color = "black",
             double size = 14)
  {
    m_out << "<text transform='translate(" << internal::coordinate_text(p) << ") scale("
          << internal::double_text(m_pixel) << ' ' << internal::double_text(-m_pixel) << ")' fill='" << color
          << "' font-size='" << internal::double_text(size) << "'>" << escaped(text) << "</text>\n";
  }

private:
  std::string stroke(const std::string& color, double width) const;

  template <class Range>
  void write_ring(const Range& points)
  {
    const char* command = "M";
    for (const auto& p : points) {
      const std::array<double, 2> at = coordinates(p);
      m_out << command << rounded_text(at[0]) << ' ' << rounded_text(at[1]);
      command = "L";
    }
  }

  // Of a point of a kernel, of coordinates in a row, or of a sample with such a point.
  template <class Point>
  static std::array<double, 2> coordinates(const Point& p)
  {
    if constexpr (requires { p.point; })
      return coordinates(p.point);
    else if constexpr (requires { p.x(); })
      return {internal::converted_number<double>(p.x()), internal::converted_number<double>(p.y())};
    else
      return {p[0], p[1]};
  }

  // With so many decimals that the rounding is not seen.
  std::string rounded_text(double x) const;

  template <class Curve>
  void write_polynomial(const Curve& piece)
  {
    const auto points = piece.control_points();
    m_out << "\n" << " LQC"[piece.degree()];
    for (std::size_t i = 1; i < points.size(); ++i)
      m_out << (i == 1 ? "" : " ") << internal::coordinate_text(points[i]);
  }

  template <class Curve>
  void write_chords(const Curve& piece)
  {
    std::vector<std::array<double, 2>> points;
    internal::append_chords(points, internal::rounded_bezier(piece), m_pixel / 10);
    for (const auto& p : points)
      m_out << "\nL" << internal::double_text(p[0]) << ' ' << internal::double_text(p[1]);
  }

  static std::string escaped(const std::string& text);
};

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

draws curves in black, with a margin of a twentieth of their extent.
\param out where the drawing is written to.
\param curves one curve or more.
\throws Invalid_input when there are no curves, or they are all one point.
*/
template <SplineKernel Kernel>
void write_SVG(std::ostream& out, const std::vector<Bspline_curve_2<Kernel>>& curves)
{
  SVG_writer writer(out, curves, 600, 1. / 20);
  for (const Bspline_curve_2<Kernel>& curve : curves)
    writer.curve(curve);
}

} // namespace IO
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE SVG_writer::SVG_writer(std::ostream& out, const CGAL::Bbox_2& view, double width)
  : m_out(out), m_pixel((view.xmax() - view.xmin()) / width),
    m_extent((std::max)(view.xmax() - view.xmin(), view.ymax() - view.ymin())),
    m_units(std::pow(10., std::ceil(std::log10(25 / m_pixel))))
{
  const double w = view.xmax() - view.xmin(), h = view.ymax() - view.ymin();
  if (!(std::isfinite(w) && std::isfinite(h) && std::isfinite(m_pixel) && std::isfinite(h / m_pixel) && w > 0 &&
        h > 0 && m_pixel > 0))
    throw Invalid_input("SVG_writer: the view or its width has no extent, or is not finite");
  const auto text = internal::double_text;
  m_out << "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "
           "style='background: white' viewBox='"
        << text(view.xmin()) << ' ' << text(-view.ymax()) << ' ' << text(w) << ' ' << text(h) << "' width='"
        << text(width) << "' height='" << text(h / m_pixel) << "'>\n"
        << "<g transform='scale(1 -1)' fill='none' stroke-linejoin='round' font-family='sans-serif'>\n";
}

CGAL_SPLINE_CONSTRAINTS_INLINE void SVG_writer::layer(const std::string& name)
{
  m_out << (m_has_layer ? "</g>\n" : "") << "<g inkscape:groupmode='layer' inkscape:label='" << escaped(name) << "'>\n";
  m_has_layer = true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string SVG_writer::rounded_text(double x) const
{
  const double rounded = std::round(x * m_units) / m_units;
  return internal::double_text((std::isfinite(rounded) ? rounded : x) + 0.); // no -0
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string SVG_writer::escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
    result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '\'' ? "&apos;" : std::string(1, c);
  return result;
}
#endif

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::string SVG_writer::stroke(const std::string& color, double width) const
{
  return "stroke='" + color + "' stroke-width='" + internal::double_text(width * m_pixel) + "'";
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_SVG_H
