// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_ZEROS_ON_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_ZEROS_ON_SURFACE_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// Calls `find(zeros, patch, budget)` to add the zeros of functions on a surface; all is undecided if a limit is reached
// before there is a function.
template <class Find>
Found_surface_curves zeros_on_surface(const Spline_patch<3>& patch, Operation_budget& budget, const Find& find)
{
  Surface_zeros zeros(patch, budget);
  try {
    find(zeros);
  } catch (const Run_stopped& stop) {
    zeros.add_undecided(stop.reason);
  }
  return zeros.curves();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_surface_curves silhouettes_of(const Exact_map<3>& surface,
                                                                   const std::array<Exact_rational, 4>& eye,
                                                                   const Solver_options& options)
{
  Operation_budget budget(options);
  const Spline_patch<3> patch(surface);
  return zeros_on_surface(patch, budget, [&](Surface_zeros& zeros) {
    for (const Continuous_part<4>& part : tangent_planes(patch, [&] { budget.check(); }))
      zeros.add(combined(part.functions, eye));
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE Found_surface_curves parabolic_lines_of(const Exact_map<3>& surface,
                                                                       const Solver_options& options)
{
  Operation_budget budget(options);
  const Spline_patch<3> patch(surface);
  return zeros_on_surface(patch, budget, [&](Surface_zeros& zeros) {
    zeros.add(Cell_functions<1>(patch, [&](const Spline_patch<3>& cell) {
      budget.check();
      const auto [uu, uv, vv] = second_form(cell);
      return std::array<Exact_function, 1>{uu * vv - uv * uv};
    }));
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Found_surface_curves>
plane_sections_of(const Exact_map<3>& surface, const Exact_triple& direction, const std::vector<Exact_rational>& levels,
                  const Solver_options& options)
{
  Operation_budget budget(options);
  const Spline_patch<3> patch(surface);
  const Cell_functions<4> coordinates(patch, [](const Spline_patch<3>& cell) {
    const auto& [x, y, z] = cell.numerators();
    return std::array<Exact_function, 4>{x, y, z, cell.weight()};
  });
  std::vector<Found_surface_curves> result;
  for (const Exact_rational& level : levels)
    result.push_back(zeros_on_surface(patch, budget, [&](Surface_zeros& zeros) {
      zeros.add(combined<4>(coordinates, {direction[0], direction[1], direction[2], Exact_rational(-level)}), false);
    }));
  return result;
}

} // namespace Surface_curves
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_INTERNAL_ZEROS_ON_SURFACE_H
