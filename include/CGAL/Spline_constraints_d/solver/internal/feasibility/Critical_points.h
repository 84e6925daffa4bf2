// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CRITICAL_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CRITICAL_POINTS_H

#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Rational_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/solutions_of_systems.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Decides whether constraints have a common solution in a box whose facets hold none, for sets that touch; there are none
on the facets even without the inequations.

Let f be the largest of the functions of the inequalities g_i <= 0, g_i < 0. If there is a solution, f is at most zero
there; f has a least value on the zeros of the equalities h_k in the box; where that is negative, its place satisfies
all inequalities, and where it is zero, every solution is such a place. So it is a solution itself, does not lie on a
facet, and by F. John's theorem there are A, numbers l_i > 0 for i in A, and n_k, such that

  sum l_i grad g_i + sum n_k grad h_k = 0,   g_i = f for i in A,   h = 0,   sum l_i + sum n_k^2 = 1,

and by Caratheodory's theorem A has at most n - m + 1 elements, or none. For each A these are as many equations as
unknowns, or one more where A is empty; f is not an unknown but the value of one of the functions in A. If no system has
a solution that satisfies all inequalities, there is none in the box. Any one that does is a solution, whatever led to
it.

Without inequalities a coordinate takes the place of f.
*/
class Critical_points
{
  const Feasibility_problem& m_problem;
  Feasibility_run& m_run;
  Rational_points& m_points;
  std::vector<int> m_unknowns; // free ones
  std::vector<std::size_t> m_equalities, m_inequalities, m_inequations;
  Feasibility_outcome m_outcome{Feasibility::INFEASIBLE, {}, {}, {}};

public:
  // Of the problem on the box that is its domain.
  Critical_points(const Feasibility_problem& problem, Rational_points& points, Feasibility_run& run)
    : m_problem(problem), m_run(run), m_points(points), m_unknowns(problem.free_unknowns())
  {
    for (std::size_t i = 0; i < problem.size(); ++i)
      (problem[i].relation == Relation::EQUAL           ? m_equalities
           : problem[i].relation == Relation::NOT_EQUAL ? m_inequations
                                                        : m_inequalities)
          .push_back(i);
  }

  Feasibility_outcome operator()()
  {
    constexpr std::size_t most_systems = 500;
    const std::size_t n = m_unknowns.size(), m = m_equalities.size();
    const std::size_t most = (std::min)(m_inequalities.size(), n < m ? 0 : n - m + 1);
    std::size_t systems = 0;
    for (std::size_t size = m == 0 ? 1 : 0; size <= most; ++size) {
      std::vector<std::size_t> active;
      if (!for_each_subset(size, 0, active, [&] {
            if (++systems > most_systems)
              leave_undecided("more sets of constraints may touch than are looked at");
            else
              look_at(active, std::nullopt);
            return m_outcome.status == Feasibility::INFEASIBLE || (is_undecided() && systems <= most_systems);
          }))
        break;
    }
    if (m_inequalities.empty() && m_outcome.status == Feasibility::INFEASIBLE)
      look_at({}, m_unknowns.front());
    return std::move(m_outcome);
  }

private:
  bool is_undecided() const { return m_outcome.status == Feasibility::UNDECIDED; }

  void leave_undecided(const std::string& reason)
  {
    if (!is_undecided())
      m_outcome.undecided.push_back({place_of(m_problem.domain()), {}, reason});
    m_outcome.status = Feasibility::UNDECIDED;
  }

  template <class Visitor>
  bool for_each_subset(std::size_t size, std::size_t first, std::vector<std::size_t>& chosen, const Visitor& visit)
  {
    if (chosen.size() == size)
      return visit();
    for (std::size_t i = first; i < m_inequalities.size(); ++i) {
      chosen.push_back(m_inequalities[i]);
      const bool goes_on = for_each_subset(size, i + 1, chosen, visit);
      chosen.pop_back();
      if (!goes_on)
        return false;
    }
    return true;
  }

  struct Additions
  {
    bool is_strict = false;       // f < 0
    bool has_inequations = false; // which is left out otherwise
  };

  // Solutions where the inequalities `active` are equal, or an unknown is extreme.
  void look_at(const std::vector<std::size_t>& active, std::optional<int> extreme)
  {
    if (m_run.must_stop())
      return leave_undecided(in_words(m_run.reason()));
    try {
      if (active.empty() || m_inequations.empty())
        take_solutions(critical_system(active, extreme, {}), !m_inequations.empty());
      else {
        // Where f is negative there are solutions beside the zeros of inequations; else all solutions are critical.
        take_solutions(critical_system(active, extreme, {.is_strict = true}), true);
        take_solutions(critical_system(active, extreme, {.has_inequations = true}), false);
      }
    } catch (const Invalid_input&) {
      leave_undecided("sets touch, and the system that decides it has too many coefficients");
    }
  }

  // As a tensor it is to be made within the time in which a run stops.
  static void check_size(const Power_polynomial& polynomial)
  {
    constexpr double most_coefficients = 50000;
    double size = 1;
    for (const auto& [unknown, degree] : polynomial.degrees())
      size *= degree + 1;
    if (size > most_coefficients)
      throw Invalid_input("Feasibility_solver_d: a system of critical points has too many coefficients");
  }

  // Unknowns: the free ones; the l_i in the order of A, the last of them omitted where their sum is one; the n_k.
  Constraint_system_d critical_system(const std::vector<std::size_t>& active, std::optional<int> extreme,
                                      const Additions& additions) const
  {
    const int n = static_cast<int>(m_unknowns.size()), multipliers = static_cast<int>(active.size()),
              m = static_cast<int>(m_equalities.size());
    const bool has_simple_sum = m == 0 && multipliers > 0;
    Exact_ranges domain;
    for (const int j : m_unknowns)
      domain.push_back(m_problem.domain()[j]);
    std::vector<Power_polynomial> factors;
    Power_polynomial sum(-1);
    for (int a = 0; a < multipliers; ++a) {
      if (has_simple_sum && a + 1 == multipliers) {
        factors.push_back(-sum);
        break;
      }
      factors.push_back(Power_polynomial::variable(static_cast<int>(domain.size())));
      domain.emplace_back(0, 1);
      sum += factors.back();
    }
    if (extreme) {
      factors.push_back(Power_polynomial::variable(static_cast<int>(domain.size())));
      domain.emplace_back(0, 1);
      sum += factors.back();
    }
    for (int k = 0; k < m; ++k) {
      factors.push_back(Power_polynomial::variable(static_cast<int>(domain.size())));
      domain.emplace_back(-1, 1);
      sum += factors.back() * factors.back();
    }
    std::vector<Power_polynomial> functions;
    for (const std::size_t i : active)
      functions.push_back(renumbered(m_problem[i].function, m_unknowns));
    if (extreme)
      functions.push_back(renumbered(Power_polynomial::variable(*extreme), m_unknowns));
    for (const std::size_t i : m_equalities)
      functions.push_back(renumbered(m_problem[i].function, m_unknowns));

    Constraint_system_d system(domain);
    for (int j = 0; j < n; ++j) {
      Power_polynomial stationary;
      for (std::size_t i = 0; i < functions.size(); ++i)
        stationary += factors[i] * functions[i].derivative(j);
      check_size(stationary);
      system.add(stationary, Relation::EQUAL);
    }
    for (int a = 1; a < multipliers; ++a)
      system.add(functions[a] - functions[0], Relation::EQUAL);
    for (int k = 0; k < m; ++k)
      system.add(functions[functions.size() - m + k], Relation::EQUAL);
    if (!has_simple_sum)
      system.add(sum, Relation::EQUAL);
    bool is_strict = additions.is_strict;
    for (const std::size_t i : active)
      is_strict = is_strict || m_problem[i].relation == Relation::LESS;
    if (!active.empty())
      system.add(functions[0], is_strict ? Relation::LESS : Relation::LESS_EQUAL);
    for (const std::size_t i : m_inequalities)
      if (!std::binary_search(active.begin(), active.end(), i))
        system.add(renumbered(m_problem[i].function, m_unknowns), m_problem[i].relation);
    if (additions.has_inequations)
      for (const std::size_t i : m_inequations)
        system.add(renumbered(m_problem[i].function, m_unknowns), Relation::NOT_EQUAL);
    return system;
  }

  // `is_doubtful`: inequations were left out.
  void take_solutions(const Constraint_system_d& system, bool is_doubtful)
  {
    constexpr std::size_t most_nodes = 20000;
    if (m_outcome.status == Feasibility::FEASIBLE)
      return;
    Feasibility_outcome found = outcome_of(solutions_of(system, most_nodes, m_run), m_problem, m_unknowns, m_points,
                                           "a certified point where sets touch");
    const bool is_point = found.status == Feasibility::FEASIBLE && found.certificate.starts_with("exact");
    if (found.status == Feasibility::FEASIBLE && is_doubtful && !is_point)
      leave_undecided("a point was found that satisfies all but what must not be zero");
    else if (found.status == Feasibility::FEASIBLE)
      m_outcome = std::move(found);
    else if (found.status == Feasibility::UNDECIDED)
      leave_undecided("sets may touch: " + found.undecided.front().reason);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CRITICAL_POINTS_H
