// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_OF_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_OF_CURVES_2_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Visible_edge_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

// What is seen from a point, without a kernel, for all kernels; defined in sight_of_curves.h.
struct Sight_of_curves_2
{
  Exact_pair viewpoint;
  Curve_parts_2 parts;
  std::vector<Visible_edge_2> edges;
  std::vector<Undecided_part> undecided;
  Summary summary;
};

// Of curves, each of which is given as a whole and as its pieces.
// \throws Invalid_input as `Visible_part_2`
Sight_of_curves_2 sight_of_curves(const Exact_pair& viewpoint, const std::vector<Spline_patch<2>>& curves,
                                  const std::vector<std::vector<Boundary_piece>>& pieces,
                                  const Solver_options& options);

// Bounds of the area.
std::pair<Exact_rational, Exact_rational> area_of_sight(const Sight_of_curves_2& sight, double error);

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_OF_CURVES_2_H
