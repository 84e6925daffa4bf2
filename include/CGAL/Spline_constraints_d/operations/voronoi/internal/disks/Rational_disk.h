// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_RATIONAL_DISK_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_RATIONAL_DISK_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Of a point from the line that a straight arc is on.
inline Exact_rational squared_distance_from_line(const Exact_pair& p, const Exact_arc_2& arc)
{
  const Exact_pair a = arc.at(0), d = exact_difference(arc.at(1), a);
  const Exact_rational area = exact_cross(d, exact_difference(p, a));
  return Exact_rational(area * area / exact_dot(d, d));
}

// A disk whose center and squared radius are rational, so that it is decided exactly what it touches.
struct Rational_disk
{
  Exact_pair center;
  Exact_rational squared_radius;

  bool touches(const Exact_pair& point) const { return squared_distance_of<2>(point, center) == squared_radius; }

  // Whether it touches the line or the circle that an arc is on; false for other arcs. Circles touch where the distance
  // of their centers is the sum or the difference of the radii: (d^2 - r^2 - s^2)^2 = 4 r^2 s^2.
  bool touches_line_or_circle(const Exact_arc_2& arc) const
  {
    if (arc.is_straight())
      return squared_distance_from_line(center, arc) == squared_radius;
    if (!arc.circle())
      return false;
    const auto& [other_center, square] = *arc.circle();
    const Exact_rational rest = squared_distance_of<2>(center, other_center) - square - squared_radius;
    return rest * rest == 4 * square * squared_radius;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_RATIONAL_DISK_H
