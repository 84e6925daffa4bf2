// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_BAND_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_BAND_2_H

#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/Line_function_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

// How a point lies to all lines that pass through both ends of a band: outside of all of them, inside of all of them,
// or on one of them, in the band or beyond one of its ends. These are closed convex sets that cover the plane.
enum class Zone
{
  OUTER,
  INNER,
  BAND,
  TAIL,
  HEAD
};

inline constexpr std::array<Zone, 5> all_zones{Zone::OUTER, Zone::INNER, Zone::BAND, Zone::TAIL, Zone::HEAD};

/*
A band: the part of a strip between two parallel lines in which an edge lies. Its corners are at the tail and at the
head of the edge, on the inner and on the outer line. All functions are positive in the direction that they are named
after; `tail` and `head` are so in the band.
*/
struct Band_2
{
  Point tail_inner, tail_outer, head_inner, head_outer;
  Line_function_2 inner, outer;                      // zero on the sides, positive outside
  Line_function_2 tail, head;                        // zero on the ends
  Line_function_2 rising, falling;                   // zero on the diagonals from the inner, and from the outer tail
  std::array<std::vector<Line_function_2>, 5> zones; // none of them is negative in the zone

  Band_2(const Point& ti, const Point& to, const Point& hi, const Point& ho)
    : tail_inner(ti), tail_outer(to), head_inner(hi), head_outer(ho), inner(Line_function_2::through(ti, hi, to)),
      outer(-Line_function_2::through(to, ho, ti)), tail(Line_function_2::through(ti, to, hi)),
      head(Line_function_2::through(hi, ho, ti)), rising(Line_function_2::through(ti, ho, to)),
      falling(Line_function_2::through(to, hi, ho)), zones{{{outer, rising, falling},
                                                            {-inner, -rising, -falling},
                                                            {inner, -outer, tail, head},
                                                            {-tail, rising, -falling},
                                                            {-head, -rising, falling}}}
  {}

  const std::vector<Line_function_2>& zone(Zone z) const { return zones[static_cast<std::size_t>(z)]; }

  std::array<Point, 4> corners() const { return {tail_inner, head_inner, head_outer, tail_outer}; }

  bool has(const Point& p) const
  {
    const auto& sides = zone(Zone::BAND);
    return std::none_of(sides.begin(), sides.end(), [&](const auto& f) { return CGAL::is_negative(f(p)); });
  }

  // Whether one of the sides has all of another band beyond it.
  bool is_separated_by_a_side(const Band_2& other) const
  {
    const auto& sides = zone(Zone::BAND);
    const auto points = other.corners();
    return std::any_of(sides.begin(), sides.end(), [&](const auto& f) {
      return std::all_of(points.begin(), points.end(), [&](const Point& p) { return CGAL::is_negative(f(p)); });
    });
  }
};

// Disjoint convex polygons are separated by the line of a side of one of them.
inline bool are_disjoint(const Band_2& a, const Band_2& b)
{
  return a.is_separated_by_a_side(b) || b.is_separated_by_a_side(a);
}

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_BAND_2_H
