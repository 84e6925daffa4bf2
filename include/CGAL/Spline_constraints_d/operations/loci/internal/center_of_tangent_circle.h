// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_CENTER_OF_TANGENT_CIRCLE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_CENTER_OF_TANGENT_CIRCLE_H

#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cmath>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

/*
The center of the circle that touches two curves in given points: on the perpendicular bisector of these, and on both
normals. The normal of the first curve meets the perpendicular bisector in (a + b) / 2 + h d', with d = a - b turned by
90 degrees and h = -<a',d> / (2 a' x d); that of the second one likewise. The better one is taken.
*/
inline Double_pair center_of_tangent_circle(const Pair_of_points& pair)
{
  const auto& [first, second] = pair.tangents;
  const Double_pair& d = pair.chord;
  const double s = cross(first, d) / std::hypot(first[0], first[1]),
               t = cross(second, d) / std::hypot(second[0], second[1]);
  const double h =
      !(std::abs(s) < std::abs(t)) ? -0.5 * dot(first, d) / cross(first, d) : 0.5 * dot(second, d) / cross(second, d);
  const double x = 0.5 * (pair.points[0][0] + pair.points[1][0]), y = 0.5 * (pair.points[0][1] + pair.points[1][1]);
  return d == Double_pair{0, 0} ? Double_pair{x, y} : Double_pair{x - h * d[1], y + h * d[0]};
}

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_CENTER_OF_TANGENT_CIRCLE_H
