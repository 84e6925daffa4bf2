// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The default solvers with TBB: instantiated in compiled_parallel_solvers.cpp.

#ifndef TEST_COMPILED_PARALLEL_SOLVERS_H
#define TEST_COMPILED_PARALLEL_SOLVERS_H

#include "compiled_solvers.h"

namespace CGAL::Spline_constraints::internal {

extern template std::vector<Solution_d<double>>
all_solutions<Certified_solver_traits, CGAL::Parallel_tag>(const Constraint_system_d&, const Solver_options&,
                                                           Run_control&, Summary&);

extern template Curve_solution_set_d all_curves<Certified_solver_traits, CGAL::Parallel_tag>(const Constraint_system_d&,
                                                                                             const Solver_options&,
                                                                                             Run_control&,
                                                                                             const Curve_search&);

} // namespace CGAL::Spline_constraints::internal

#endif // TEST_COMPILED_PARALLEL_SOLVERS_H
