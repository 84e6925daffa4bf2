// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_NORMALS_BETWEEN_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_NORMALS_BETWEEN_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Arc_germ.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/arc_directions.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The first and last normals of the normal cones between the directions p and q of two arcs around a vertex, q
// clockwise from p. `is_only`: there is no other arc; `is_first`: p is the first one of the order around the vertex.
inline std::vector<std::array<Exact_pair, 2>> normals_between(const Exact_pair& p, const Exact_pair& q, bool is_only,
                                                              bool is_first)
{
  const Exact_pair from{p[1], Exact_rational(-p[0])}, to{Exact_rational(-q[1]), q[0]},
      ahead{Exact_rational(-p[0]), Exact_rational(-p[1])};
  const int side = sign_of(exact_cross(q, p));   // the angle from q to p is below 180 degrees if positive
  // the last case: all arcs leave in one direction
  if (!is_only && side >= 0 && !(is_first && are_same_directions(p, q)))
    return {};
  if (!is_only && side != 0 && sign_of(exact_dot(from, to)) >= 0)
    return {std::array{from, with_length_of(from, to)}};
  // more than 90 degrees: in two steps
  const Exact_pair middle = is_only || side == 0 ? ahead : direction_between(from, to);
  return {std::array{from, with_length_of(from, middle)}, std::array{middle, with_length_of(middle, to)}};
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_NORMALS_BETWEEN_H
