// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_DEFAULT_SOLVER_H
#define TEST_DEFAULT_SOLVER_H

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

namespace CGAL::Spline_constraints::internal {

// Instantiated in default_solver.cpp.
extern template std::vector<Solution_d<double>>
all_solutions<Certified_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&, Run_control&, Summary&);

extern template Curve_solution_set_d
all_curves<Certified_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&, Run_control&);

} // namespace CGAL::Spline_constraints::internal

#endif // TEST_DEFAULT_SOLVER_H
