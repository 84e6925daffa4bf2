// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUMMING_SOLVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUMMING_SOLVER_H

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Solves the systems of one operation, and adds up the work.
class Summing_solver
{
  Subdivision_solver_d<Certified_solver_traits> m_solver;
  Summary m_total;

public:
  explicit Summing_solver(const Solver_options& options) : m_solver(options) {}

  Solution_set_d<double> operator()(const std::vector<Constraint>& constraints) { return (*this)(make_system(constraints)); }

  Solution_set_d<double> operator()(const Constraint_system_d& system)
  {
    Solution_set_d<double> result = m_solver(system);
    m_total += result.summary();
    return result;
  }

  const Summary& total() const { return m_total; }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUMMING_SOLVER_H
