// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_RUN_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_RUN_H

#include <CGAL/Spline_constraints_d/solver/Feasibility_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What a search has found of one problem.
struct Feasibility_outcome
{
  Feasibility status = Feasibility::UNDECIDED;
  Exact_ranges box = {}; // with a feasible point
  std::string certificate = {};
  std::vector<Undecided_part> undecided = {};
};

inline Feasibility_outcome feasible_in(Exact_ranges box, std::string certificate)
{
  return {Feasibility::FEASIBLE, std::move(box), std::move(certificate), {}};
}

inline std::vector<Undecided_part::Range> place_of(const Exact_ranges& box)
{
  std::vector<Undecided_part::Range> result;
  for (const auto& range : box)
    result.push_back(to_double_range(range));
  return result;
}

// The limits, the work and the record of a run, for all of its parts.
class Feasibility_run
{
  const Solver_options& m_options;
  Run_control& m_control;
  std::size_t m_nodes = 0, m_ended = 0;
  double m_tolerance;
  std::vector<Feasibility_d::Excluded_part> m_excluded;
  std::vector<std::vector<double>> m_path;

public:
  static constexpr std::size_t most_excluded_parts = 100000;

  Feasibility_run(const Solver_options& options, Run_control& control)
    : m_options(options), m_control(control), m_tolerance(options.tolerance)
  {}

  std::size_t nodes() const { return m_nodes; }
  void add_nodes(std::size_t nodes) { m_nodes += nodes; }

  bool must_stop() { return has_reached_node_limit() || m_control.must_stop(true); }
  // Throws Run_stopped, for work without an answer before it has ended.
  void check()
  {
    if (must_stop())
      throw Run_stopped{reason()};
  }
  Undecided_reason reason() const
  {
    return m_control.reason() == Undecided_reason::NONE && has_reached_node_limit() ? Undecided_reason::NODES
                                                                                    : m_control.reason();
  }

  // For a system that is a part of the run and gets so many nodes.
  Solver_options options_of_system(std::size_t nodes)
  {
    Solver_options result = m_control.options_of_parts(m_options);
    result.tolerance = Solver_options().tolerance;
    const std::size_t left = m_options.node_limit == 0 ? nodes : m_options.node_limit - m_nodes;
    result.node_limit = left < 1 ? 1 : left < nodes ? left : nodes;
    return result;
  }

  // It grows with the number of boxes that have ended at it.
  double tolerance() const { return m_tolerance; }
  void end_at_tolerance()
  {
    if (++m_ended % m_options.coarsening_step == 0)
      m_tolerance *= 2;
  }

  void exclude(std::vector<Undecided_part::Range> place, std::vector<Exact_rational> multipliers)
  {
    if (m_excluded.size() < most_excluded_parts)
      m_excluded.push_back({std::move(place), std::move(multipliers)});
  }
  std::vector<Feasibility_d::Excluded_part>& excluded() { return m_excluded; }
  std::vector<std::vector<double>>& path() { return m_path; }

  // The answer, with what was collected on the way. It is the last call.
  Feasibility_d ended_with(Feasibility_outcome&& outcome)
  {
    const bool is_complete = outcome.status != Feasibility::UNDECIDED;
    return {outcome.status,
            std::move(outcome.box),
            std::move(outcome.certificate),
            std::move(outcome.undecided),
            std::move(m_excluded),
            std::move(m_path),
            summary_of(m_control, m_nodes, reason(), is_complete)};
  }

private:
  bool has_reached_node_limit() const { return m_options.node_limit > 0 && m_nodes >= m_options.node_limit; }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_RUN_H
