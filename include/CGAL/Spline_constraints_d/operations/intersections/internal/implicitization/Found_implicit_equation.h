// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICITIZATION_FOUND_IMPLICIT_EQUATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICITIZATION_FOUND_IMPLICIT_EQUATION_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A polynomial that is zero on a curve in the plane or a surface, and a box around this. None has a lower degree.
struct Found_implicit_equation
{
  std::optional<Power_polynomial> polynomial = {};
  std::vector<std::pair<Exact_rational, Exact_rational>> box = {};
  int least_degree = 1;
  Summary summary = {};
};

// Defined in implicit_equation.h.
template <int d>
Found_implicit_equation implicit_equation_of(const Exact_map<d>& map, int most_degree, const Solver_options& options);

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICITIZATION_FOUND_IMPLICIT_EQUATION_H
