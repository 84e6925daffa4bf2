// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_WKT_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_WKT_H

#include <CGAL/Spline_constraints_d/IO/internal/decimal_text.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

template <SplineKernel Kernel>
class Planar_region_2;

namespace internal {

// Points in order: corners of a polyline, or the ends and inner points of arcs of circles in turn.
struct WKT_run
{
  bool is_circular;
  std::vector<std::string> points;
};

using WKT_ring = std::vector<WKT_run>;    // closed
using WKT_part = std::vector<WKT_ring>;   // the outer boundary, and holes

template <class Range, class Text_of>
std::string listed(const Range& range, const Text_of& text_of)
{
  std::string result;
  for (const auto& element : range)
    result += (result.empty() ? "(" : ", ") + text_of(element);
  return result + ')';
}

inline std::string text_of_run(const WKT_run& run)
{
  return (run.is_circular ? "CIRCULARSTRING " : "") +
      listed(run.points, [](const std::string& point) { return point; });
}

inline std::string text_of_part(const WKT_part& part)
{
  return listed(part, [](const WKT_ring& ring) {
    return ring.size() == 1 ? text_of_run(ring[0]) : "COMPOUNDCURVE " + listed(ring, text_of_run);
  });
}

inline bool is_curved(const WKT_part& part)
{
  return std::any_of(part.begin(), part.end(),
                     [](const WKT_ring& ring) { return ring.size() > 1 || ring[0].is_circular; });
}

inline void write_parts(std::ostream& out, const std::vector<WKT_part>& parts)
{
  const bool has_arcs = std::any_of(parts.begin(), parts.end(), is_curved);
  if (parts.size() == 1)
    out << (has_arcs ? "CURVEPOLYGON " : "POLYGON ") << text_of_part(parts[0]);
  else if (parts.empty())
    out << "MULTIPOLYGON EMPTY";
  else
    out << (has_arcs ? "MULTISURFACE " : "MULTIPOLYGON ") << listed(parts, [](const WKT_part& part) {
      return (is_curved(part) ? "CURVEPOLYGON " : "") + text_of_part(part);
    });
  out << '\n';
}

template <class NT>
std::string WKT_point(const NT& x, const NT& y)
{
  return double_text(converted_number<double>(x)) + ' ' + double_text(converted_number<double>(y));
}

template <class Kernel, class Container>
WKT_ring WKT_ring_of(const CGAL::Polygon_2<Kernel, Container>& polygon)
{
  if (polygon.size() < 3)
    throw Invalid_input("write_WKT: a polygon has less than three corners");
  WKT_ring result{{false, {}}};
  for (auto p = polygon.vertices_begin(); p != polygon.vertices_end(); ++p)
    result[0].points.push_back(WKT_point(p->x(), p->y()));
  result[0].points.push_back(result[0].points.front());
  return result;
}

// Points between the ends of a piece: of an arc of a circle one, or three if it is the whole circle.
template <class Piece>
std::vector<std::string> inner_points(const Piece& piece, bool is_circular, double error)
{
  std::vector<std::string> result;
  if (is_circular)
    for (const int quarter : piece.at(0) == piece.at(1) ? std::vector<int>{1, 2, 3} : std::vector<int>{2}) {
      const auto p = piece.at(Exact_rational(quarter) / 4);
      result.push_back(WKT_point(p[0], p[1]));
    }
  else
    for (const auto& [x, y] : piece.inner_corners(error))
      result.push_back(WKT_point(x, y));
  return result;
}

// Of a loop of a region.
template <class Loop>
WKT_ring WKT_ring_of(const Loop& loop, double error)
{
  WKT_ring result;
  std::string end = WKT_point(loop.source()[0], loop.source()[1]);
  for (const auto& piece : loop.pieces()) {
    const bool is_circular = to_circle(Loop({piece}).curve()).has_value();
    if (result.empty() || result.back().is_circular != is_circular)
      result.push_back({is_circular, {end}});
    std::vector<std::string>& points = result.back().points;
    const std::vector<std::string> inner = inner_points(piece, is_circular, error);
    points.insert(points.end(), inner.begin(), inner.end());
    const auto p = piece.at(1);
    end = WKT_point(p[0], p[1]);
    points.push_back(end);
  }
  return result;
}

} // namespace internal

namespace IO {

/*!
\ingroup PkgSplineConstraintsDIO

writes polygons as well-known text (WKT), in one line: a `POLYGON`, or, if there are none or several, a `MULTIPOLYGON`.
Coordinates are rounded to doubles, and are read back as those.
\param out where the text is written to.
\param polygons the polygons, as those of `Planar_region_2`, `Trimmed_offset_2` and `Minkowski_sum_2`.
\throws Invalid_input when a polygon is unbounded, or a boundary has less than three corners.
*/
template <class Kernel, class Container>
void write_WKT(std::ostream& out, const std::vector<CGAL::Polygon_with_holes_2<Kernel, Container>>& polygons)
{
  std::vector<internal::WKT_part> parts;
  for (const auto& polygon : polygons) {
    internal::WKT_part part{internal::WKT_ring_of(polygon.outer_boundary())};
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      part.push_back(internal::WKT_ring_of(*hole));
    parts.push_back(std::move(part));
  }
  internal::write_parts(out, parts);
}

/*!
\ingroup PkgSplineConstraintsDIO

writes a region as well-known text (WKT) with curves, in one line. Polynomial pieces of the boundaries that are arcs of
circles, which is decided exactly, become `CIRCULARSTRING`s, in a `CURVEPOLYGON` or a `MULTISURFACE` of these; others
become chords. If there are no such arcs, the text is a `POLYGON` or a `MULTIPOLYGON`.
\param out where the text is written to.
\param region the region.
\param error the distance of other curves from their chords, at most, up to rounding of coordinates to doubles;
positive.
\throws Invalid_input when the error is not positive, or the region is not complete.
*/
template <SplineKernel Kernel>
void write_WKT(std::ostream& out, const Planar_region_2<Kernel>& region, double error)
{
  internal::check_error(error, "write_WKT");
  std::vector<internal::WKT_part> parts;
  for (const std::vector<std::size_t>& boundaries : internal::Regions::parts_of_boundaries(region.boundaries())) {
    internal::WKT_part& part = parts.emplace_back();
    for (const std::size_t b : boundaries)
      part.push_back(internal::WKT_ring_of(region.loops()[b], error));
  }
  internal::write_parts(out, parts);
}

} // namespace IO
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_WRITE_WKT_H
