// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BUDGETED_SOLVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BUDGETED_SOLVER_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The system with these unknowns, whether constraints use them or not.
inline Constraint_system_d system_of(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns)
{
  std::vector<Constraint_system_d::Domain> domain;
  for (const Unknown& unknown : unknowns)
    domain.push_back(unknown.domain());
  Constraint_system_d system(std::move(domain));
  for (const Constraint& constraint : constraints)
    system.add(constraint);
  return system;
}

// Solves the systems of one operation, and adds up the work. Limits of time and nodes are for all systems together,
// that of time also for what is done between them.
class Budgeted_solver
{
  using Clock = std::chrono::steady_clock;

  Solver_options m_options;
  Summary m_total;
  Clock::time_point m_start = Clock::now();

public:
  explicit Budgeted_solver(const Solver_options& options) : m_options(options) { m_options.check(); }

  Solution_set_d<double> operator()(const std::vector<Constraint>& constraints)
  {
    return solve(make_system(constraints));
  }

  // With these unknowns, whether constraints use them or not.
  Solution_set_d<double> operator()(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns)
  {
    return solve(system_of(constraints, unknowns));
  }

  const Summary& total() const { return m_total; }

  // One for a few more nodes, whose work is added afterwards.
  Budgeted_solver limited(std::size_t nodes) const
  {
    Budgeted_solver result(*this);
    const std::size_t limit = m_total.nodes + nodes;
    if (m_options.node_limit == 0 || limit < m_options.node_limit)
      result.m_options.node_limit = limit;
    return result;
  }

  void add_work_of(const Budgeted_solver& limited) { m_total = limited.m_total; }

  // Whether there are no nodes left.
  bool has_reached_node_limit() const { return m_options.node_limit > 0 && m_total.nodes >= m_options.node_limit; }

  // Whether there is no time left or the visitor stops the run, so that systems need not be made.
  bool must_stop() const
  {
    return (m_options.time_limit > 0 && seconds() >= m_options.time_limit) || m_options.visitor.stop();
  }

private:
  Solution_set_d<double> solve(const Constraint_system_d& system)
  {
    Solution_set_d<double> result = Subdivision_solver_d<Certified_solver_traits>(remaining_options())(system);
    m_total += result.summary();
    return result;
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  // With what is left of the limits, a little at least: zero would be no limit.
  Solver_options remaining_options() const
  {
    Solver_options result = m_options;
    if (m_options.time_limit > 0)
      result.time_limit = (std::max)(m_options.time_limit - seconds(), 1e-9);
    if (m_options.node_limit > 0)
      result.node_limit = m_total.nodes < m_options.node_limit ? m_options.node_limit - m_total.nodes : 1;
    return result;
  }
};

// Whether constraints without unknowns are satisfied.
inline bool hold(const std::vector<Constraint>& constraints)
{
  return std::all_of(constraints.begin(), constraints.end(), [](const Constraint& c) {
    return is_satisfied(c.relation, CGAL::sign(c.function.constant_term()));
  });
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BUDGETED_SOLVER_H
