// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_POINTS_OF_PLACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_POINTS_OF_PLACES_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Space_of_places.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The points of all triangles that the patches of a solid sweep: one for all places that are the same.
class Points_of_places
{
  using Point = Double_kernel::Point_3;
  using Line = Space_of_places::Line;
  using Line_key = std::pair<int, Place_of_solid>;

  const std::vector<Moving_surface>& m_moving;
  const Space_of_places& m_space;
  Triangle_soup& m_soup;
  double m_chord_error;
  std::map<Place_of_solid, std::size_t> m_of_place;
  std::map<Point, std::size_t> m_of_point;
  std::map<Line_key, std::vector<double>> m_lines;                     // parameters of points that are asked for
  std::map<std::pair<Line_key, double>, std::vector<double>> m_places; // of lines from a cut on

public:
  Points_of_places(const std::vector<Moving_surface>& moving, const Space_of_places& space, Triangle_soup& soup,
                   double chord_error)
    : m_moving(moving), m_space(space), m_soup(soup), m_chord_error(chord_error)
  {}

  double chord_error() const { return m_chord_error; }
  const Moving_surface& moving(std::size_t patch) const { return m_moving[patch]; }
  const Point& point(std::size_t index) const { return m_soup.points[index]; }

  std::size_t index_of(const Place_of_solid& place)
  {
    const Place_of_solid own = m_space.canonical(place);
    const auto [known, is_new] = m_of_place.try_emplace(own, 0);
    if (is_new)
      known->second = index_of_point(m_moving[own.patch](own.place));
    return known->second;
  }

  std::size_t index_of_point(const Point& point)
  {
    const auto [known, is_new] = m_of_point.try_emplace(point, m_soup.points.size());
    if (is_new)
      m_soup.points.push_back(point);
    return known->second;
  }

  // Triangles without area, as at poles, are left out.
  void add_triangle(const Corners& corners)
  {
    if (!CGAL::collinear(point(corners[0]), point(corners[1]), point(corners[2])))
      m_soup.triangles.push_back(corners);
  }

  void set_index(const Place_of_solid& place, std::size_t index)
  {
    m_of_place.insert_or_assign(m_space.canonical(place), index);
  }

  // The place on a line along an axis that was asked for before, but for rounding; or asks for this one. Before
  // places_on_line().
  Place on_line(std::size_t patch, int axis, Place place)
  {
    constexpr double rounding = 0x1p-40;
    const auto a = static_cast<std::size_t>(axis);
    const Line line = m_space.line(patch, axis, place);
    std::vector<double>& parameters = m_lines[{line.axis, line.key}];
    const double parameter = line.parameter(place[a]);
    for (const double known : parameters)
      if (std::abs(known - parameter) <= rounding * m_space.length(axis)) {
        place[a] = line.parameter(known);
        return place;
      }
    parameters.push_back(parameter);
    return place;
  }

  // The places on a line from one cut to the next, so close that the chords keep to their error; the same whenever they
  // are asked for.
  std::vector<Place> places_on_line(std::size_t patch, int axis, Place from, double begin, double end)
  {
    const Line line = m_space.line(patch, axis, from);
    if (line.is_reversed)
      std::swap(begin, end);
    const auto [known, is_new] = m_places.try_emplace({{line.axis, line.key}, line.parameter(begin)});
    if (is_new)
      add_places(known->second, line, line.parameter(begin), line.parameter(end));
    std::vector<Place> result;
    for (const double parameter : known->second) {
      from[static_cast<std::size_t>(axis)] = line.parameter(parameter);
      result.push_back(from);
    }
    if (line.is_reversed)
      std::reverse(result.begin(), result.end());
    return result;
  }

private:
  void add_places(std::vector<double>& places, const Line& line, double begin, double end) const
  {
    std::vector<double> asked{begin, end};
    if (const auto own = m_lines.find({line.axis, line.key}); own != m_lines.end())
      std::copy_if(own->second.begin(), own->second.end(), std::back_inserter(asked),
                   [&](double parameter) { return begin < parameter && parameter < end; });
    std::sort(asked.begin(), asked.end());
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    places.push_back(asked.front());
    for (std::size_t i = 1; i < asked.size(); ++i) {
      append_between(places, line, asked[i - 1], asked[i], 0);
      places.push_back(asked[i]);
    }
  }

  void append_between(std::vector<double>& places, const Line& line, double begin, double end, int depth) const
  {
    constexpr int most_depth = 12, least_depth = 2;
    const auto point = [&](double parameter) { return m_moving[line.key.patch](line.at(parameter).place); };
    const double middle = line.axis == 2 ? 0.5 * (begin + end) : Space_of_places::snapped(0.5 * (begin + end));
    const Point p = point(begin), q = point(end);
    const double error = std::sqrt(CGAL::squared_distance(CGAL::midpoint(p, q), point(middle)));
    if (depth == most_depth || (depth >= least_depth && error <= m_chord_error) || (p == q && error == 0) ||
        !(begin < middle && middle < end))
      return;
    append_between(places, line, begin, middle, depth + 1);
    places.push_back(middle);
    append_between(places, line, middle, end, depth + 1);
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_POINTS_OF_PLACES_H
