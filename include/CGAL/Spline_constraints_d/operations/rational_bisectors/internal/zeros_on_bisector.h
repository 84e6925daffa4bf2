// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_ZEROS_ON_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_ZEROS_ON_BISECTOR_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/functions_on_bisector.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// Over the cells of a part of the grid.
inline Cell_functions<1> restricted(Cell_functions<1> functions, const Cell_functions<4>& part)
{
  for (const int axis : {0, 1}) {
    const std::vector<Exact_rational>& breaks = functions.breaks(axis);
    const auto index = [&](const Exact_rational& t) {
      return static_cast<std::size_t>(std::ranges::find(breaks, t) - breaks.begin());
    };
    functions = functions.part(axis, index(part.domain(axis).first), index(part.domain(axis).second));
  }
  return functions;
}

// Where points of a patch are that goes to infinity.
inline Place_of_unknowns place_on_bisector(const Spline_patch<3>& patch)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Surface_shape surface(patch);
  return {[surface](const std::vector<double>& unknowns) {
            return surface.point(std::vector<double>(unknowns.begin(), unknowns.begin() + 2));
          },
          [=](const Curve_vertex::Exact_box&) {
            return std::vector<Undecided_part::Range>(3, {-infinity, infinity});
          },
          {2}};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Found_surface_curves>
zeros_on_bisector(const Rational_bisector_3& bisector, const Function_of_piece& function, const Solver_options& options)
{
  Operation_budget budget(options);
  const auto functions =
      functions_on_bisector<1>(bisector, [&](const auto& piece) { return std::array{function(piece)}; });
  std::vector<Found_surface_curves> result;
  for (const Continuous_part<4>& part : continuous_parts(coordinates_on_bisector(bisector), false)) {
    const auto [x, y, z, w] = part.functions.splines();
    const Spline_patch<3> patch({x, y, z}, w, true);
    Surface_zeros zeros(patch, budget, place_on_bisector(patch));
    zeros.add(restricted(functions, part.functions), false);
    result.push_back(zeros.curves());
  }
  return result;
}

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_ZEROS_ON_BISECTOR_H
