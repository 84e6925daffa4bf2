// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUMMING_SOLVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUMMING_SOLVER_H

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <algorithm>
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

  Solution_set_d<double> operator()(const std::vector<Constraint>& constraints)
  {
    Solution_set_d<double> result = m_solver(make_system(constraints));
    add(result.summary());
    return result;
  }

  const Summary& total() const { return m_total; }

private:
  void add(const Summary& s)
  {
    m_total.nodes += s.nodes;
    m_total.restarts += s.restarts;
    m_total.depth = (std::max)(m_total.depth, s.depth);
    m_total.seconds += s.seconds;
    m_total.setup_seconds += s.setup_seconds;
    m_total.rebuild_seconds += s.rebuild_seconds;
    m_total.refinement_seconds += s.refinement_seconds;
    if (m_total.is_complete && !s.is_complete) {
      m_total.is_complete = false;
      m_total.why_not = s.why_not;
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SUMMING_SOLVER_H
