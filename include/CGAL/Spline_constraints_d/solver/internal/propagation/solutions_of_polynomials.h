// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_OF_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_OF_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Search_in_turns.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Common_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/solutions_by_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposed_solutions.h>
#endif

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
/*
Two solvers for one system, with tensors and with sums of monomials. They are tried in turns, for as much counted work,
each time until they have done half as much again as before, or four times as much in the second turn: which one is
faster is not seen beforehand, nor by how much of the domain each has done. Both go on where they were, tensors on a
thread of their own. Many systems are solved in their first turn, which is done without one: in the second turn, tensors
begin anew.
*/
template <class Concurrency_tag>
class Solutions_of_polynomials
{
  using Solution = Solution_d<double>;

  const std::vector<Constraint_system_d::Domain>& m_domain;
  const std::vector<Polynomial_constraint>& m_constraints;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_summary;
  Summary m_propagation_summary;
  Solutions_by_propagation m_propagation; // goes on in each of its turns
  Solver_options m_tensor_options;
  Summary m_tensor_summary;
  std::vector<Solution> m_tensor_solutions;
  std::optional<Constraint_system_d> m_system;
  std::optional<Search_in_turns> m_tensors; // from the second turn on

  // A run with a limit of nodes of its own.
  struct Trial
  {
    std::vector<Solution> solutions;
    bool is_at_limit;
  };

public:
  Solutions_of_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                           const std::vector<Polynomial_constraint>& constraints, const Solver_options& options,
                           Run_control& control, Summary& summary)
    : m_domain(domain), m_constraints(constraints), m_options(options), m_control(control), m_summary(summary),
      m_propagation(domain, constraints, options, control, m_propagation_summary, Parallel_loop::of<Concurrency_tag>())
  {}

  std::vector<Solution> operator()()
  {
    constexpr double largest_tensor = 0x1p13;
    constexpr std::size_t largest_dimension = 500; // of which dense rows may pay
    if (m_domain.size() > largest_dimension || tensor_size(m_constraints) > largest_tensor)
      return by_propagation(0).solutions;
    m_system.emplace(m_domain);
    for (const auto& [polynomial, relation] : m_constraints)
      m_system->add(polynomial, relation);
    double propagation_work = 0;
    try {
      propagation_work = work_of_propagation();
    } catch (const Run_stopped&) {
      return by_propagation(0).solutions; // says what stopped it
    }
    const double tensor_work = work_of_tensors();
    constexpr double first_work = 0x1p23, first_growth = 4, growth = 1.5;
    for (double work = first_work;; work *= work == first_work ? first_growth : growth) {
      const std::size_t nodes = nodes_of_trial(work, tensor_work);
      Trial tensors = work == first_work ? by_tensors(nodes) : by_tensors_in_turns(nodes);
      if (is_at_end(tensors))
        return std::move(tensors.solutions);
      Trial propagation = by_propagation(nodes_of_trial(work, propagation_work));
      if (is_at_end(propagation))
        return std::move(propagation.solutions);
    }
  }

private:
  // There is nothing to go on with: it has ended, or the run as a whole has.
  bool is_at_end(const Trial& trial) const
  {
    return !trial.is_at_limit || m_control.reason() != Undecided_reason::NONE ||
        (m_options.node_limit > 0 && m_summary.nodes >= m_options.node_limit);
  }

  static constexpr double largest_small_dimension = 64;

  // In about equal units of 20 ns: a pass over all coefficients, and over the derivatives, of which the inverse counts
  // where there are many.
  double work_of_tensors() const
  {
    const double n = static_cast<double>(m_domain.size());
    double result = n * n * (n <= largest_small_dimension ? 1 : n / 32);
    for (const Polynomial_constraint& constraint : m_constraints)
      result += tensor_size({constraint});
    return result;
  }

  // Sums of multiples of all terms, and an elimination, which is sparse where unknowns are many; of one block at once.
  double work_of_propagation() const
  {
    const auto check = [this] { m_control.check(); };
    const int dimension = static_cast<int>(m_domain.size());
    const Common_part common(m_constraints, dimension, check);
    const Sparse_system system(dimension + (common.is_found() ? 1 : 0), common.constraints(), check);
    double inequality_terms = 0, result = 0;
    for (const auto& [polynomial, relation] : common.constraints())
      inequality_terms += relation == Relation::EQUAL ? 0 : static_cast<double>(polynomial.terms().size());
    const Block_order order(system);
    for (const Equation_block& block : order.blocks()) {
      const double n = static_cast<double>((std::min)(block.unknowns().size(), m_domain.size()));
      double terms = inequality_terms;
      for (const int i : block.equalities())
        terms += static_cast<double>(common.constraints()[i].first.terms().size());
      result = (std::max)(
          result, (std::min)(n, largest_small_dimension) * terms + n * n * (n <= largest_small_dimension ? n / 8 : 1));
    }
    return result;
  }

  static std::size_t nodes_of_trial(double work, double work_of_node)
  {
    return static_cast<std::size_t>((std::clamp)(work / work_of_node, 16.0, 0x1p52));
  }

  // The limits that are left, with so many nodes at most; 0: no other limit.
  Solver_options options_of_trial(std::size_t nodes) const
  {
    Solver_options result = m_options;
    if (m_options.node_limit > 0)
      result.node_limit = (std::max)(m_options.node_limit, m_summary.nodes + 1) - m_summary.nodes;
    if (nodes > 0 && (result.node_limit == 0 || nodes < result.node_limit))
      result.node_limit = nodes;
    return result;
  }

  // What earlier trials left open is not left open by the last one.
  void add_work(const Summary& work)
  {
    m_summary += work;
    m_summary.is_complete = work.is_complete;
    m_summary.why_not = work.why_not;
  }

  // From the beginning.
  Trial by_tensors(std::size_t nodes)
  {
    Summary work;
    m_control.begin_part();
    auto solutions = decomposed_solutions<Certified_solver_traits, Concurrency_tag>(*m_system, options_of_trial(nodes),
                                                                                    m_control, work);
    add_work(work);
    const bool is_at_limit = std::any_of(solutions.begin(), solutions.end(),
                                         [](const Solution& s) { return s.reason() == Undecided_reason::NODES; });
    return {std::move(solutions), is_at_limit};
  }

  // Goes on where they were, until they have looked at so many boxes in all these turns.
  Trial by_tensors_in_turns(std::size_t nodes)
  {
    if (!m_tensors)
      m_tensors.emplace([this] {
        const Mpfr_precision_scope precision(m_options.precision);
        m_tensor_solutions = decomposed_solutions<Certified_solver_traits, Concurrency_tag>(
            *m_system, m_tensor_options, m_control, m_tensor_summary);
      });
    m_control.begin_part();
    const std::size_t before = m_tensors->nodes(), turn = nodes > before ? nodes - before : 1;
    const std::size_t limit = options_of_trial(turn).node_limit;
    m_control.set_turns(&*m_tensors);
    const bool is_ended = m_tensors->advance(limit, limit < turn);
    m_control.set_turns(nullptr);
    if (!is_ended) {
      m_summary.nodes += m_tensors->nodes() - before;
      return {{}, true};
    }
    m_summary.nodes -= before; // which are in what follows
    add_work(m_tensor_summary);
    return {std::move(m_tensor_solutions), false};
  }

  // Goes on with the search where it was, until it has looked at so many boxes in all its turns; 0: at any number.
  Trial by_propagation(std::size_t nodes)
  {
    m_control.begin_part();
    const Upward_rounding_guard guard;
    const std::size_t before = m_propagation.nodes();
    const Solver_options options = options_of_trial(nodes > before ? nodes - before : nodes);
    const bool is_ended = m_propagation.advance(options.node_limit > 0 ? before + options.node_limit : 0);
    const std::size_t own = m_propagation.nodes() - before;
    if (!is_ended && (m_options.node_limit == 0 || m_summary.nodes + own < m_options.node_limit)) {
      m_summary.nodes += own;
      return {{}, true};
    }
    m_summary.nodes -= before; // which are in what follows
    m_propagation_summary = Summary();
    auto solutions = m_propagation.found();
    add_work(m_propagation_summary);
    return {std::move(solutions), false};
  }
};

template <class Concurrency_tag>
Solution_set_d<double> solution_set_of_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                                                   const std::vector<Polynomial_constraint>& constraints,
                                                   const Solver_options& options)
{
  check_polynomials(domain, constraints);
  const Mpfr_precision_scope precision(options.precision);
  Run_control control(options);
  Summary summary;
  auto solutions = Solutions_of_polynomials<Concurrency_tag>(domain, constraints, options, control, summary)();
  return finished_set(std::move(solutions), summary, control);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_SOLUTIONS_OF_POLYNOMIALS_H
