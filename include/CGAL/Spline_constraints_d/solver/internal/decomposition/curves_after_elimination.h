// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_CURVES_AFTER_ELIMINATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_CURVES_AFTER_ELIMINATION_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Box_lifting.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#endif

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The same curves in the unknowns of the whole system.
inline Curve_solution_set_d lifted(const Curve_solution_set_d& found, Box_lifting& lifting)
{
  std::vector<Curve_vertex> vertices = found.vertices();
  for (Curve_vertex& vertex : vertices)
    vertex.box = lifting.vertex(vertex.box);
  std::vector<Solution_curve> curves = found.curves();
  for (Solution_curve& curve : curves)
    for (Curve_piece& piece : curve.pieces) {
      piece.box = lifting(piece.box);
      piece.parameter = piece.parameter < 0 ? piece.parameter : lifting.unknown(piece.parameter);
    }
  std::vector<Undecided_region> undecided = found.undecided_regions();
  for (Undecided_region& region : undecided)
    for (Exact_box& box : region.boxes)
      box = lifting(box);
  return {std::move(vertices),     std::move(curves),    found.points(),
          found.singular_points(), std::move(undecided), found.summary()};
}

/*
All curves of solutions, found with fewer unknowns where equalities of degree one allow that and bounds on these are not
reached. If something is undecided then, without limits, or not in the domain, the system is solved as it is.
*/
template <class Traits, class Concurrency_tag>
Curve_solution_set_d curves_after_elimination(const Constraint_system_d& system, const Solver_options& options,
                                              Run_control& control)
{
  Summary work;
  const auto is_empty = [&](const Constraint_system_d& on_bound) {
    const auto found =
        Subdivision_solver_d<Traits, Concurrency_tag>(options_for_bound(options, work, control))(on_bound);
    work.nodes += found.summary().nodes;
    return found.empty();
  };
  const auto with_work = [&](const Curve_solution_set_d& found) -> Curve_solution_set_d {
    Summary summary = found.summary();
    summary.nodes += work.nodes;
    return {found.vertices(),          found.curves(), found.points(), found.singular_points(),
            found.undecided_regions(), summary};
  };
  const System_decomposition decomposition = elimination_within_bounds(system, 1, control, is_empty);
  if (!decomposition.eliminated.empty()) {
    const Curve_solution_set_d found =
        all_curves<Traits, Concurrency_tag>(decomposition.parts.front().system, rest_of(options, work), control, {});
    Box_lifting lifting(system, decomposition);
    Curve_solution_set_d result = lifted(found, lifting);
    if (lifting.are_in_domain() && (result.is_complete() || has_limits_reached(result.undecided_regions())))
      return with_work(result);
    work.nodes += found.summary().nodes;
  }
  return with_work(all_curves<Traits, Concurrency_tag>(system, rest_of(options, work), control, {}));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_CURVES_AFTER_ELIMINATION_H
