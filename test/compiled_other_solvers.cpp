// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compiled_solvers.h"

namespace CGAL::Spline_constraints::internal {

template std::vector<Solution_d<double>>
all_solutions<Fast_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&, Run_control&,
                                                        Summary&);

template std::vector<Solution_d<double>>
all_solutions<Interval_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                            Run_control&, Summary&);

template std::vector<Solution_d<Exact_rational>>
all_solutions<Multiprecision_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                                  Run_control&, Summary&);

template std::vector<Solution_d<Exact_rational>>
all_solutions<Exact_solver_traits, CGAL::Sequential_tag>(const Constraint_system_d&, const Solver_options&,
                                                         Run_control&, Summary&);

} // namespace CGAL::Spline_constraints::internal
