// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_RUN_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_RUN_H

#include <CGAL/Spline_constraints_d/internal/Parallel_loop.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Chain_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Common_part.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Explicit_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Growing_windows.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Propagation_search.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The search of a box for the solutions of polynomial constraints, which can be interrupted: explicit unknowns are
replaced, a common part is named, and where the constraints are a chain and the search does not end soon, the boxes that
wait are replaced by those that windows of the chain leave.
*/
class Propagation_run
{
  const Solver_options& m_options;
  Run_control& m_control;
  Parallel_loop m_loop;
  std::function<void()> m_check;
  Explicit_unknowns m_explicit_unknowns;
  Box_of_ranges m_box;
  std::optional<Sparse_system> m_system;
  std::optional<Propagation_search> m_search;
  bool m_may_be_chain = true;
  std::size_t m_cells = 0; // that were narrowed

public:
  // Throws Run_stopped when the run ends here.
  Propagation_run(const Box_of_ranges& domain, const std::vector<Polynomial_constraint>& constraints,
                  const Solver_options& options, Run_control& control, const Parallel_loop& loop);

  Propagation_run(const Propagation_run&) = delete;
  Propagation_run& operator=(const Propagation_run&) = delete;

  // Goes on until the search has ended, or so many boxes were looked at in all (0: any number); whether it has ended,
  // for whatever reason.
  bool advance(std::size_t most_nodes);

  // With what was done in windows.
  std::size_t nodes() const { return m_search->nodes() + m_cells; }

  const Explicit_unknowns& explicit_unknowns() const { return m_explicit_unknowns; }
  const Sparse_system& system() const { return *m_system; }
  Propagation_search& search() { return *m_search; }

private:
  void use_windows();
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE
Propagation_run::Propagation_run(const Box_of_ranges& domain, const std::vector<Polynomial_constraint>& constraints,
                                 const Solver_options& options, Run_control& control, const Parallel_loop& loop)
  : m_options(options), m_control(control), m_loop(loop), m_check([this] { m_control.check(); }),
    m_explicit_unknowns(domain, constraints, m_check), m_box(m_explicit_unknowns.reduced(domain))
{
  const int dimension = m_explicit_unknowns.dimension();
  const Common_part common(m_explicit_unknowns.constraints(), dimension, m_check);
  if (common.is_found()) {
    m_system.emplace(dimension + 1, common.constraints(), m_check);
    m_box.push_back(Interval(0));
    m_box.back() = m_system->value(m_system->constraints() - 1, m_box);
    m_may_be_chain = false;
  }
  if (!common.is_found() || !is_finite(m_box.back())) {
    m_box.resize(dimension);
    m_system.emplace(dimension, m_explicit_unknowns.constraints(), m_check);
  }
  m_search.emplace(*m_system, m_options, m_control, m_loop);
  m_search->begin(m_box);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Propagation_run::advance(std::size_t most_nodes)
{
  constexpr std::size_t soon = 1024;
  if (m_may_be_chain && m_search->nodes() < soon) {
    const std::size_t nodes = most_nodes > 0 ? (std::min)(soon, most_nodes) : soon;
    if (m_search->advance(nodes))
      return true;
    if (nodes < soon)
      return false;
    use_windows();
  }
  if (most_nodes > 0 && nodes() >= most_nodes)
    return false;
  return m_search->advance(most_nodes > 0 ? most_nodes - m_cells : 0);
}

// Of chains with small frontiers: work grows exponentially with these. What falls into short blocks is none.
CGAL_SPLINE_CONSTRAINTS_INLINE void Propagation_run::use_windows()
{
  constexpr std::size_t shortest = 16, largest_frontier = 4, most_cells = 0x1p18, most_work = 0x1p23,
                        most_rounds = 256; // then cells cannot be split any more
  constexpr int largest_dimension = 64;    // with dense rows
  m_may_be_chain = false;
  const std::vector<Polynomial_constraint>& constraints = m_explicit_unknowns.constraints();
  const auto is_long = [](const Equation_block& block) { return block.equalities().size() >= shortest; };
  if (!std::ranges::any_of(m_search->blocks().blocks(), is_long) || m_explicit_unknowns.dimension() > largest_dimension)
    return;
  const Chain_order order(constraints, m_explicit_unknowns.dimension());
  if (order.largest_frontier() > largest_frontier)
    return;
  std::vector<Polynomial_constraint> chain;
  for (const int i : order.order())
    chain.push_back(constraints[i]);
  try {
    Growing_windows windows(chain, m_box, m_check, m_loop);
    for (std::size_t round = 0;
         round < most_rounds && !windows.is_done() && windows.cells() < most_cells && windows.work() < most_work &&
         (m_options.node_limit == 0 || m_search->nodes() + windows.work() < m_options.node_limit);
         ++round)
      windows.advance();
    m_cells = windows.work();
    if (windows.is_done()) {
      m_control.begin_part();
      m_search->replace_waiting(windows.boxes(m_box));
    }
  } catch (const Run_stopped&) {
    // the search sees it
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_RUN_H
