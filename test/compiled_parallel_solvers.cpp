// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compiled_parallel_solvers.h"

namespace CGAL::Spline_constraints::internal {

template std::vector<Solution_d<double>>
all_solutions<Certified_solver_traits, CGAL::Parallel_tag>(const Constraint_system_d&, const Solver_options&,
                                                           Run_control&, Summary&);

template Curve_solution_set_d all_curves<Certified_solver_traits, CGAL::Parallel_tag>(const Constraint_system_d&,
                                                                                      const Solver_options&,
                                                                                      Run_control&,
                                                                                      const Curve_search&);

} // namespace CGAL::Spline_constraints::internal
