// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_POINTS_OF_PLACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_POINTS_OF_PLACES_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Moving_surface.h>

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

// The box of all places of a moving surface, cut into cells by planes. Some of its faces are the same: seams of the
// surface, or of a closed motion; some are one point at a time, poles.
struct Space_of_places
{
  std::array<std::vector<double>, 3> cuts;      // with both ends
  std::array<bool, 3> is_closed{};              // both ends are the same
  std::array<std::array<bool, 2>, 2> is_pole{}; // the ends of an axis of the surface

  bool is_at_pole(const Place& place, int axis) const
  {
    const auto a = static_cast<std::size_t>(axis);
    return (is_pole[a][0] && place[a] == cuts[a].front()) || (is_pole[a][1] && place[a] == cuts[a].back());
  }

  // One of the places that are the same point at the same time.
  Place canonical(Place place) const
  {
    for (std::size_t a = 0; a < 3; ++a)
      if (is_closed[a] && place[a] == cuts[a].back())
        place[a] = cuts[a].front();
    for (int axis : {0, 1})
      if (is_at_pole(place, axis))
        place[static_cast<std::size_t>(1 - axis)] = cuts[static_cast<std::size_t>(1 - axis)].front();
    return place;
  }
};

// The points of all triangles that a moving surface sweeps: one for all places that are the same.
class Points_of_places
{
  using Point = Double_kernel::Point_3;

  const Moving_surface& m_moving;
  const Space_of_places& m_space;
  Triangle_soup& m_soup;
  double m_chord_error;
  std::map<Place, std::size_t> m_of_place;
  std::map<Point, std::size_t> m_of_point;
  std::map<std::pair<int, Place>, std::vector<double>> m_lines; // parameters of points that are asked for, by axis
  std::map<std::pair<std::pair<int, Place>, double>, std::vector<double>> m_places; // of lines from a cut on

public:
  Points_of_places(const Moving_surface& moving, const Space_of_places& space, Triangle_soup& soup, double chord_error)
    : m_moving(moving), m_space(space), m_soup(soup), m_chord_error(chord_error)
  {}

  double chord_error() const { return m_chord_error; }
  const Moving_surface& moving() const { return m_moving; }
  const Point& point(std::size_t index) const { return m_soup.points[index]; }

  std::size_t index_of(const Place& place)
  {
    const Place own = m_space.canonical(place);
    const auto [known, is_new] = m_of_place.try_emplace(own, 0);
    if (is_new)
      known->second = index_of_point(m_moving(own));
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

  void set_index(const Place& place, std::size_t index)
  {
    m_of_place.insert_or_assign(m_space.canonical(place), index);
  }

  // The place on a line along an axis that was asked for before, but for rounding; or asks for this one. Before
  // places_on_line().
  Place on_line(int axis, Place place)
  {
    constexpr double rounding = 0x1p-40;
    const auto a = static_cast<std::size_t>(axis);
    std::vector<double>& parameters = m_lines[line_key(axis, place)];
    const double range = m_space.cuts[a].back() - m_space.cuts[a].front();
    for (double known : parameters)
      if (std::abs(known - place[a]) <= rounding * range) {
        place[a] = known;
        return place;
      }
    parameters.push_back(place[a]);
    return place;
  }

  // The places on a line from one cut to the next, so close that the chords keep to their error; the same whenever they
  // are asked for.
  std::vector<Place> places_on_line(int axis, Place from, double begin, double end)
  {
    const auto a = static_cast<std::size_t>(axis);
    from[a] = begin;
    const auto [known, is_new] = m_places.try_emplace({line_key(axis, from), begin});
    if (is_new)
      add_places(known->second, a, from, end);
    std::vector<Place> result;
    for (double parameter : known->second) {
      from[a] = parameter;
      result.push_back(from);
    }
    return result;
  }

private:
  void add_places(std::vector<double>& places, std::size_t axis, const Place& from, double end) const
  {
    std::vector<double> asked{from[axis], end};
    if (const auto line = m_lines.find(line_key(static_cast<int>(axis), from)); line != m_lines.end())
      std::copy_if(line->second.begin(), line->second.end(), std::back_inserter(asked),
                   [&](double parameter) { return from[axis] < parameter && parameter < end; });
    std::sort(asked.begin(), asked.end());
    asked.erase(std::unique(asked.begin(), asked.end()), asked.end());
    places.push_back(asked.front());
    for (std::size_t i = 1; i < asked.size(); ++i) {
      append_between(places, axis, from, asked[i - 1], asked[i], 0);
      places.push_back(asked[i]);
    }
  }

  std::pair<int, Place> line_key(int axis, const Place& place) const
  {
    Place key = m_space.canonical(place);
    key[static_cast<std::size_t>(axis)] = 0;
    return {axis, key};
  }

  void append_between(std::vector<double>& places, std::size_t axis, const Place& line, double begin, double end,
                      int depth) const
  {
    constexpr int most_depth = 12, least_depth = 2;
    Place first = line, middle = line, last = line;
    first[axis] = begin;
    middle[axis] = 0.5 * (begin + end);
    last[axis] = end;
    const Point p = m_moving(first), q = m_moving(last);
    const double error = std::sqrt(CGAL::squared_distance(CGAL::midpoint(p, q), m_moving(middle)));
    if (depth == most_depth || (depth >= least_depth && error <= m_chord_error) || (p == q && error == 0) ||
        !(begin < middle[axis] && middle[axis] < end))
      return;
    append_between(places, axis, line, begin, middle[axis], depth + 1);
    places.push_back(middle[axis]);
    append_between(places, axis, line, middle[axis], end, depth + 1);
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_POINTS_OF_PLACES_H
