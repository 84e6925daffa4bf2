// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BUDGETED_SOLVER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BUDGETED_SOLVER_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/undecided_solution.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

std::vector<Constraint_system_d::Domain> domains_of(const std::vector<Unknown>& unknowns);

// The system with these unknowns, whether constraints use them or not; `check()` may end the work by an exception.
Constraint_system_d system_of(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns,
                              const std::function<void()>& check = {});

// Solves the systems of one operation, and adds up the work. Limits are for all systems together.
class Budgeted_solver
{
  Operation_budget m_budget;

public:
  explicit Budgeted_solver(const Solver_options& options) : m_budget(options) {}
  explicit Budgeted_solver(const Operation_budget& budget) : m_budget(budget) {}

  Solution_set_d<double> operator()(const std::vector<Constraint>& constraints)
  {
    return solved(common_domains(constraints), [&] { return make_system(constraints, check()); });
  }

  // With these unknowns, whether constraints use them or not.
  Solution_set_d<double> operator()(const std::vector<Constraint>& constraints, const std::vector<Unknown>& unknowns)
  {
    return solved(domains_of(unknowns), [&] { return system_of(constraints, unknowns, check()); });
  }

  Solution_set_d<double> operator()(const Constraint_system_d& system);

  Operation_budget& budget() { return m_budget; }
  const Summary& total() const { return m_budget.total(); }

  // One for a few more nodes, whose work is added afterwards.
  Budgeted_solver limited(std::size_t nodes) const;

  void add_work_of(const Budgeted_solver& limited);

  bool has_node_limit() const { return m_budget.has_node_limit(); }

  // Whether there are no nodes left.
  bool has_reached_node_limit() const { return m_budget.has_reached_node_limit(); }

  // Whether there is no time left or the visitor stops the run, so that systems need not be made.
  bool must_stop() const { return m_budget.must_stop(); }

  // Whether there are no nodes left, either; and why the run has ended, if it has.
  bool has_ended() const { return m_budget.has_ended(); }
  Undecided_reason reason() const { return m_budget.reason(); }

private:
  std::function<void()> check() const
  {
    return [this] { m_budget.check(); };
  }

  // Of a system in a domain. Where the run ends before it is made, all of the domain is undecided.
  template <class Make_system>
  Solution_set_d<double> solved(const std::vector<Constraint_system_d::Domain>& domain, const Make_system& make)
  {
    try {
      return (*this)(make());
    } catch (const Run_stopped& stop) {
      Summary summary;
      summary.is_complete = false;
      summary.why_not = stop.reason;
      return Solution_set_d<double>({undecided_solution(domain, stop.reason)}, summary);
    }
  }
};

// Whether constraints without unknowns are satisfied.
bool hold(const std::vector<Constraint>& constraints);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Constraint_system_d::Domain> domains_of(const std::vector<Unknown>& unknowns)
{
  std::vector<Constraint_system_d::Domain> result;
  for (const Unknown& unknown : unknowns)
    result.push_back(unknown.domain());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Constraint_system_d system_of(const std::vector<Constraint>& constraints,
                                                             const std::vector<Unknown>& unknowns,
                                                             const std::function<void()>& check)
{
  Constraint_system_d system(domains_of(unknowns));
  for (const Constraint& constraint : constraints)
    system.add(constraint, check);
  return system;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solution_set_d<double> Budgeted_solver::operator()(const Constraint_system_d& system)
{
  Solution_set_d<double> result = Subdivision_solver_d<Certified_solver_traits>(m_budget.remaining())(system);
  m_budget.add(result.summary());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Budgeted_solver Budgeted_solver::limited(std::size_t nodes) const
{
  Budgeted_solver result(*this);
  result.m_budget.limit_nodes(nodes);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Budgeted_solver::add_work_of(const Budgeted_solver& limited)
{
  Summary more = limited.total();
  more.nodes -= total().nodes;
  more.restarts -= total().restarts;
  more.seconds -= total().seconds;
  more.setup_seconds -= total().setup_seconds;
  more.rebuild_seconds -= total().rebuild_seconds;
  m_budget.add(more);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool hold(const std::vector<Constraint>& constraints)
{
  return std::all_of(constraints.begin(), constraints.end(), [](const Constraint& c) {
    return is_satisfied(c.relation, CGAL::sign(c.function.constant_term()));
  });
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BUDGETED_SOLVER_H
