// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_PARTS_OF_PLANE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_PARTS_OF_PLANE_H

#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Band_2.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Banded_polygon_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

// A convex polygon with interior, within one zone of each of the first bands.
struct Part_of_plane
{
  std::vector<Point> corners;
  std::vector<Zone> zones;
};

// The corners of the part of a convex polygon with interior in which a function is not negative; none, if this part has
// no interior.
inline std::vector<Point> clipped(const std::vector<Point>& corners, const Line_function_2& f)
{
  std::vector<Exact_rational> values;
  for (const Point& p : corners)
    values.push_back(f(p));
  if (std::none_of(values.begin(), values.end(), [](const auto& v) { return CGAL::is_positive(v); }))
    return {};
  std::vector<Point> result;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t j = (i + 1) % corners.size();
    if (!CGAL::is_negative(values[i]))
      result.push_back(corners[i]);
    if (CGAL::sign(values[i]) * CGAL::sign(values[j]) == CGAL::NEGATIVE)
      result.push_back(corners[i] + Exact_rational(values[i] / (values[i] - values[j])) * (corners[j] - corners[i]));
  }
  return result;
}

inline bool is_in_zone(const std::vector<Point>& corners, const std::vector<Line_function_2>& zone)
{
  return std::all_of(zone.begin(), zone.end(), [&](const Line_function_2& f) {
    return std::none_of(corners.begin(), corners.end(), [&](const Point& p) { return CGAL::is_negative(f(p)); });
  });
}

inline std::vector<Point> clipped(std::vector<Point> corners, const std::vector<Line_function_2>& zone)
{
  for (const Line_function_2& f : zone)
    if (!corners.empty())
      corners = clipped(corners, f);
  return corners;
}

// Adds the parts of a part in the zones of a further band, but for one zone that is left out.
inline void add_cut_parts(Part_of_plane part, const Band_2& band, std::optional<Zone> left_out,
                          std::vector<Part_of_plane>& parts)
{
  const auto add = [&](std::vector<Point> corners, Zone zone) {
    if (corners.empty() || zone == left_out)
      return;
    parts.push_back({std::move(corners), part.zones});
    parts.back().zones.push_back(zone);
  };
  // Most parts are in one zone.
  for (const Zone zone : all_zones)
    if (is_in_zone(part.corners, band.zone(zone)))
      return add(std::move(part.corners), zone);
  for (const Zone zone : all_zones)
    if (zone != left_out)
      add(clipped(part.corners, band.zone(zone)), zone);
}

// All vertices of the arrangement of all lines are inside, so that each of its faces is met in its interior.
inline Polygon window_of_lines(const std::vector<Band_2>& bands)
{
  std::vector<Line_function_2> lines;
  for (const Band_2& band : bands)
    lines.insert(lines.end(), {band.inner, band.outer, band.rising, band.falling});
  const Point& first = bands.front().tail_inner;
  Exact_rational x_min = first.x(), x_max = x_min, y_min = first.y(), y_max = y_min;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!CGAL::is_zero(determinant(lines[i], lines[j]))) {
        const Point p = common_zero(lines[i], lines[j]);
        x_min = (std::min)(x_min, Exact_rational(p.x()));
        x_max = (std::max)(x_max, Exact_rational(p.x()));
        y_min = (std::min)(y_min, Exact_rational(p.y()));
        y_max = (std::max)(y_max, Exact_rational(p.y()));
      }
  const Exact_rational margin((x_max - x_min + y_max - y_min) / 8);
  x_min -= margin;
  y_min -= margin;
  x_max += margin;
  y_max += margin;
  Polygon result;
  for (const Point& corner : {Point(x_min, y_min), Point(x_max, y_min), Point(x_max, y_max), Point(x_min, y_max)})
    result.push_back(corner);
  return result;
}

inline Part_of_plane whole_plane(const Banded_polygon_2& polygon)
{
  return {{polygon.window.begin(), polygon.window.end()}, {}};
}

inline Point inner_point(const std::vector<Point>& corners)
{
  Exact_kernel::Vector_2 sum = CGAL::NULL_VECTOR;
  for (const Point& p : corners)
    sum = sum + (p - CGAL::ORIGIN);
  return CGAL::ORIGIN + sum / Exact_rational(static_cast<unsigned long>(corners.size()));
}

/*
Whether the points of a part of the plane are inside of the models in which they have a signature. That depends on the
edges alone in whose bands the part is: none, one, or two neighbours.
*/
class Location_rule
{
  std::vector<std::size_t> m_bands; // neighbours in order
  bool m_is_reflex = false;         // between them
  bool m_is_inside = false;         // if it is in no band

public:
  Location_rule(const Banded_polygon_2& polygon, const Part_of_plane& part)
  {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
      if (part.zones[i] == Zone::BAND)
        m_bands.push_back(i);
    CGAL_assertion(m_bands.size() <= 2);
    if (m_bands.empty())
      m_is_inside = polygon.polygon.bounded_side(inner_point(part.corners)) == CGAL::ON_BOUNDED_SIDE;
    else if (m_bands.size() == 2)
      m_is_reflex = polygon.is_reflex[(m_bands[0] + 1) % n == m_bands[1] ? m_bands[1] : m_bands[0]];
  }

  Signature_location operator()(const std::string& signature) const
  {
    const auto is_right = [&](std::size_t band) { return signature[band] == 'R'; };
    const bool is_inside = m_bands.empty() ? m_is_inside
        : m_is_reflex                      ? std::any_of(m_bands.begin(), m_bands.end(), is_right)
                                           : std::all_of(m_bands.begin(), m_bands.end(), is_right);
    return is_inside ? Signature_location::INSIDE : Signature_location::OUTSIDE;
  }
};

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_PARTS_OF_PLANE_H
