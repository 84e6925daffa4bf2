// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_POLYLINE_ARRANGEMENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_POLYLINE_ARRANGEMENTS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/Polyline_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace Regions {

template <class Arrangement, class Point>
Arrangement polyline_arrangement(const std::vector<std::vector<Point>>& polylines)
{
  using Vertex = Chord_traits_2::Point_2;
  std::vector<Chord_traits_2::Curve_2> chords;
  std::vector<Vertex> single;
  for (std::size_t c = 0; c < polylines.size(); ++c) {
    std::vector<Vertex> points;
    for (const Point& p : polylines[c]) {
      const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y());
      if (!(std::abs(x) <= most_magnitude && std::abs(y) <= most_magnitude)) // sweeps fail with much greater ones
        throw Invalid_input("to_arrangement: a coordinate of polyline " + std::to_string(c) +
                            " is not between -2^250 and 2^250");
      points.emplace_back(x, y);
    }
    bool is_single = true;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      if (points[i] != points[i + 1]) {
        chords.emplace_back(Chord_segment_traits_2::Curve_2(points[i], points[i + 1]), Chord_label{c, i});
        is_single = false;
      }
    if (is_single && !points.empty())
      single.push_back(points.front());
  }
  Arrangement result;
  CGAL::insert(result, chords.begin(), chords.end());
  for (const Vertex& point : single)
    CGAL::insert_point(result, point);
  return result;
}

// Whether chords meet in common end points only: then the sweep has made no other vertices, and has split no chord.
template <class Arrangement, class Point>
bool is_crossing_free(const Arrangement& arrangement, const std::vector<std::vector<Point>>& polylines)
{
  std::set<Point> points;
  std::size_t chords = 0;
  for (const auto& polyline : polylines) {
    points.insert(polyline.begin(), polyline.end());
    for (std::size_t i = 1; i < polyline.size(); ++i)
      chords += polyline[i - 1] != polyline[i];
  }
  return arrangement.number_of_vertices() == points.size() && arrangement.number_of_edges() == chords;
}

} // namespace Regions
} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_POLYLINE_ARRANGEMENTS_H
