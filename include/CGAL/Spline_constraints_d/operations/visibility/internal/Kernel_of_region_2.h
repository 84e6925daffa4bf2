// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_OF_REGION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_OF_REGION_2_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Kernel_edge_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

// The kernel of a region, without a kernel of CGAL, for all of these; defined in kernel_of_region.h.
struct Kernel_of_region_2
{
  using Bounds = Vector_bounds<2>;

  Curve_parts_2 parts;
  std::vector<Exact_pair> flat;   // corners of a kernel, or of a set around it, without interior
  std::optional<Exact_pair> centre;
  std::vector<Kernel_edge_2> edges;
  std::vector<Bounds> vertices;   // the sources of edges
  bool may_have_interior = true, is_straight = true;
  std::vector<Undecided_part> undecided;
  Summary summary;

  std::size_t after(std::size_t edge) const { return (edge + 1) % edges.size(); }
};

// Of a region with these curves, each of which is given as its pieces, and this one boundary, or boundaries that touch.
Kernel_of_region_2 kernel_of_region(const std::vector<std::vector<Boundary_piece>>& curves,
                                    const std::vector<Boundary_loop_2>& loops, const Solver_options& options);

// Bounds of the area.
std::pair<Exact_rational, Exact_rational> area_of_kernel(const Kernel_of_region_2& kernel, double error);

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_KERNEL_OF_REGION_2_H
