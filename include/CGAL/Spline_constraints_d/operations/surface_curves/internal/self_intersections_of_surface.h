// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SELF_INTERSECTIONS_OF_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SELF_INTERSECTIONS_OF_SURFACE_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/curves_within_budget.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/found_intersections.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Cell_pairs.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Equal_point_pairs.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

CGAL_SPLINE_CONSTRAINTS_INLINE Found_intersection self_intersection_of(const Exact_map<3>& surface,
                                                                       const Solver_options& options)
{
  Operation_budget budget(options);
  const Spline_patch<3> patch(surface);
  const Surface_shape shape(patch);
  std::vector<Solved_part> parts;
  const auto add_undecided = [&](const Parameter_box& cells, Undecided_reason reason) {
    parts.push_back({Surface_equations(shape, Constraint_system_d(cells)), undecided_curves(cells, reason)});
  };
  bool is_stopped = false;
  const Parameter_box whole{patch.domain(0), patch.domain(1), patch.domain(0), patch.domain(1)};
  const auto add = [&](const auto& make_system) {
    if (is_stopped || budget.must_stop()) {   // one part stands for all that follow
      if (!std::exchange(is_stopped, true))
        add_undecided(whole, budget.reason());
      return;
    }
    Constraint_system_d system = make_system();
    Curve_solution_set_d solutions = curves_within_budget(system, budget);
    parts.push_back({Surface_equations(shape, std::move(system)), std::move(solutions)});
  };
  try {
    const Cell_pairs pairs(patch, [&] { budget.check(); });
    for (const Spline_patch<3>& cell : pairs.single_cells())
      add([&] { return Equal_point_pairs(cell).system(); });
    for (const Parameter_box& cells : pairs.cells_apart())
      add([&] { return equal_points_of(patch, cells); });
    for (const Parameter_box& cells : pairs.undecided())
      add_undecided(cells, Undecided_reason::TOLERANCE);
  } catch (const Run_stopped& stop) {   // before there were pairs of cells
    add_undecided(whole, stop.reason);
  }
  if (parts.empty())
    parts.push_back({Surface_equations(shape, std::nullopt), Curve_solution_set_d({}, {}, {}, {}, {}, Summary())});
  return found_intersection(std::move(parts));
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_SELF_INTERSECTIONS_OF_SURFACE_H
