// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_REGION_BOUNDARIES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_REGION_BOUNDARIES_2_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/enum.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// The boundaries of a region without a kernel, for all kernels; defined in region_boundaries.h.
struct Region_boundaries_2
{
  std::vector<Planar_region_boundary_2> boundaries;
  std::vector<Boundary_loop_2> loops;                              // in the same order
  std::vector<std::vector<Planar_region_arc_2>> arcs_of_curves;    // of each curve, in its direction
  bool have_common_vertices = false;
  std::vector<Undecided_part> undecided;                           // if there is any, there are no boundaries
  Summary summary;
};

// Of the region between curves, each of which is given as its pieces.
// \throws Invalid_input as `Planar_region_2`
Region_boundaries_2 region_boundaries(std::vector<std::vector<Boundary_piece>> curves, const Solver_options& options);

CGAL::Bounded_side bounded_side(const std::vector<Boundary_loop_2>& loops, const Exact_pair& point);

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_REGION_BOUNDARIES_2_H
