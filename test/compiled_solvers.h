// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The solvers that many tests and examples use: instantiated in compiled_default_solvers.cpp and
// compiled_other_solvers.cpp.

#ifndef TEST_COMPILED_SOLVERS_H
#define TEST_COMPILED_SOLVERS_H

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

namespace CGAL::Spline_constraints::internal {

extern template std::vector<Solution_d<double>>
all_solutions<Certified_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                             Run_control&, Summary&);

extern template Curve_solution_set_d
all_curves<Certified_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                          Run_control&, const Curve_search&);

extern template std::vector<Solution_d<double>>
all_solutions<Fast_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&, Run_control&,
                                                        Summary&);

extern template std::vector<Solution_d<double>>
all_solutions<Interval_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                            Run_control&, Summary&);

extern template std::vector<Solution_d<Exact_rational>>
all_solutions<Multiprecision_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                                  Run_control&, Summary&);

extern template std::vector<Solution_d<Exact_rational>>
all_solutions<Exact_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                         Run_control&, Summary&);

} // namespace CGAL::Spline_constraints::internal

#endif // TEST_COMPILED_SOLVERS_H
