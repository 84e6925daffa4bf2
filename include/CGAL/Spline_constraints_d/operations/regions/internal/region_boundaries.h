// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_REGION_BOUNDARIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_REGION_BOUNDARIES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Region_boundaries_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Simple_rings_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// The boundaries that rings are, with the region on their left.
// \throws Run_stopped
Region_boundaries_2 boundaries_of(const Simple_rings_2& rings, std::size_t number_of_curves, Run_of_steps& run);

CGAL_SPLINE_CONSTRAINTS_INLINE Region_boundaries_2 region_boundaries(std::vector<std::vector<Boundary_piece>> curves,
                                                                     const Solver_options& options)
{
  Run_of_steps run(options);
  Region_boundaries_2 result;
  try {
    result = boundaries_of(Simple_rings_2(curves, run), curves.size(), run);
  } catch (const Run_stopped& stop) {
    result.undecided.push_back({box_of_pieces(curves), {}, in_words(stop.reason)});
  }
  result.summary = run.summary(result.undecided.empty());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Bounded_side bounded_side(const std::vector<Boundary_loop_2>& loops,
                                                               const Exact_pair& point)
{
  constexpr int halvings = 24;
  int turns = 0;
  for (const Boundary_loop_2& loop : loops) {
    if (loop.may_contain(point, halvings)) {
      Budgeted_solver solve({});
      if (!common_points<2>(Patch_pair<2>(Spline_patch<2>(point), Spline_patch<2>(loop.curve())), solve).empty())
        return CGAL::ON_BOUNDARY;
    }
    turns += loop.winding_number(point);
  }
  return turns > 0 ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE;
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Region_boundaries_2 boundaries_of(const Simple_rings_2& rings,
                                                                 std::size_t number_of_curves, Run_of_steps& run)
{
  Region_boundaries_2 result;
  result.have_common_vertices = rings.has_rings_that_touch();
  result.arcs_of_curves.resize(number_of_curves);
  std::vector<Planar_region_arc_2> arcs;
  for (std::size_t s = 0; s < rings.strands().size(); ++s) {
    const Boundary_piece &first = rings.strands()[s].front(), &last = rings.strands()[s].back();
    arcs.push_back({first.curve, !rings.has_region_on_left({s, false}), {first.parameters[0], last.parameters[1]}});
    result.arcs_of_curves[first.curve].push_back(arcs.back());
  }
  for (const Simple_rings_2::Ring& ring : rings.rings()) {
    run.check();
    Boundary_loop_2 loop = rings.loop(ring);
    Planar_region_boundary_2 boundary{{}, false, no_boundary};
    for (const Intersection_arc& strand : ring)
      boundary.arcs.push_back(arcs[strand.index]);
    if (!rings.has_region_on_left(ring.front())) {
      std::reverse(boundary.arcs.begin(), boundary.arcs.end());
      loop.reverse();
    }
    boundary.is_hole = !loop.is_counterclockwise();
    if (!boundary.is_hole)
      boundary.outer = result.boundaries.size();
    result.boundaries.push_back(std::move(boundary));
    result.loops.push_back(std::move(loop));
  }
  find_outer_boundaries(result.boundaries, [&](std::size_t i, std::size_t k) {
    run.check();
    return result.loops[i].winding_number(result.loops[k].inner_point()) != 0;
  });
  return result;
}
#endif

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_REGION_BOUNDARIES_H
