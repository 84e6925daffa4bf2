// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_OF_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_OF_CURVES_2_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/Hull_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

// A convex hull without a kernel, for all kernels; defined in hull_of_curves.h.
struct Hull_of_curves_2
{
  Curve_parts_2 parts;
  std::vector<Exact_pair> points;
  std::vector<Hull_edge_2> edges;
  std::vector<Undecided_part> undecided;
  Summary summary;

  Exact_pair point(std::size_t curve, const Exact_rational& parameter) const
  {
    return curve < parts.number_of_curves() ? parts.point(curve, parameter) : points[curve - parts.number_of_curves()];
  }
};

// Of curves, each of which is given as its pieces, and points.
// \throws Invalid_input as `Convex_hull_2`
Hull_of_curves_2 hull_of_curves(const std::vector<std::vector<Boundary_piece>>& curves, std::vector<Exact_pair> points,
                                const Solver_options& options);

// Bounds of the area.
std::pair<Exact_rational, Exact_rational> area_of_hull(const Hull_of_curves_2& hull, double error);

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_OF_CURVES_2_H
