// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_SEARCH_H

#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Constraint_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Krawczyk_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Preconditioned_rows.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
All solutions in a box, by depth-first search: boxes are narrowed by the constraints one by one and by combinations of
the equalities, until they are empty, hold one root by proof, or are split.
*/
class Propagation_search
{
  // The boxes that wait, one after the other.
  struct Waiting
  {
    int split_unknown, depth;
  };

  const Sparse_system& m_system;
  const Solver_options& m_options;
  Run_control& m_control;
  std::function<void()> m_check;
  Constraint_propagation m_propagation;
  Preconditioned_rows m_rows;
  Krawczyk_test m_krawczyk_test;
  Univariate_interval_polynomial m_polynomial;
  std::vector<Interval> m_waiting_boxes;
  std::vector<Waiting> m_waiting;
  Box_of_ranges m_box, m_before;
  std::vector<double> m_rating;
  std::vector<std::pair<int, double>> m_smear; // of the unknowns of the constraint in hand
  double m_tolerance;
  std::vector<Proved_root> m_roots;
  std::vector<Box_of_ranges> m_undecided, m_rest;
  std::size_t m_nodes = 0;
  Undecided_reason m_reason = Undecided_reason::NONE;

  enum class Verdict
  {
    EMPTY,
    ROOT,
    OPEN
  };

public:
  Propagation_search(const Sparse_system& system, const Solver_options& options, Run_control& control)
    : m_system(system), m_options(options), m_control(control), m_check([this] { m_control.check(); }),
      m_propagation(system), m_rows(system, m_check), m_krawczyk_test(m_rows, !system.is_polynomial()),
      m_tolerance(options.tolerance)
  {}

  // Looks at all of a box.
  void run(const Box_of_ranges& domain)
  {
    begin(domain);
    if (!advance(m_options.node_limit))
      end(Undecided_reason::NODES);
  }

  // The box is to be looked at.
  void begin(const Box_of_ranges& domain) { push(domain, -1, 0); }

  // These boxes are to be looked at, and nothing else any more.
  void replace_waiting(const std::vector<Box_of_ranges>& boxes)
  {
    m_waiting.clear();
    m_waiting_boxes.clear();
    const int depth = static_cast<int>(std::ceil(std::log2((std::max)(boxes.size(), std::size_t(1)))));
    for (const Box_of_ranges& box : boxes)
      push(box, -1, depth);
  }

  // Until no box waits, or so many were looked at in all (0: any number); whether it has ended, by a limit of the run,
  // too.
  bool advance(std::size_t most_nodes)
  {
    while (!m_waiting.empty()) {
      if (m_control.must_stop(true)) {
        end(m_control.reason());
        return true;
      }
      if (most_nodes > 0 && m_nodes >= most_nodes)
        return false;
      const Waiting node = pop();
      try {
        examine(node);
      } catch (const Run_stopped& stopped) {
        m_rest.push_back(m_box);
        end(stopped.reason);
        return true;
      }
    }
    return true;
  }

  // Leaves all that waits.
  void end(Undecided_reason reason)
  {
    m_reason = reason;
    while (!m_waiting.empty()) {
      pop();
      m_rest.push_back(m_box);
    }
  }

  // Different ones, each the only one in its region; not all of them need lie in the box.
  std::vector<Proved_root>& roots() { return m_roots; }
  // Boxes at the tolerance.
  const std::vector<Box_of_ranges>& undecided() const { return m_undecided; }
  // Boxes that were not looked at, because of a limit.
  const std::vector<Box_of_ranges>& rest() const { return m_rest; }
  Undecided_reason reason() const { return m_reason; }
  std::size_t nodes() const { return m_nodes; }

private:
  void push(const Box_of_ranges& box, int split_unknown, int depth)
  {
    m_waiting_boxes.insert(m_waiting_boxes.end(), box.begin(), box.end());
    m_waiting.push_back({split_unknown, depth});
  }

  Waiting pop()
  {
    const auto first = m_waiting_boxes.end() - m_system.dimension();
    m_box.assign(first, m_waiting_boxes.end());
    m_waiting_boxes.erase(first, m_waiting_boxes.end());
    const Waiting result = m_waiting.back();
    m_waiting.pop_back();
    return result;
  }

  void examine(const Waiting& node);
  Verdict narrow(const Waiting& node);
  bool finds_root();
  void split(int depth);
  int unknown_to_split();
  void rate_unknowns();
  void share_rating(double rating, int constraint, int but);

  // Wide beside the tolerance, and with a double inside.
  bool may_be_split(const Interval& range) const
  {
    return width(range) >= m_tolerance * (std::max)(1.0, magnitude(range)) && range.inf() < middle(range) &&
        middle(range) < range.sup();
  }
  // Those that are not defined by others.
  int unknowns_to_split() const { return m_system.dimension() - m_system.defined(); }
  bool is_at_tolerance() const
  {
    return std::none_of(m_box.begin(), m_box.begin() + unknowns_to_split(),
                        [&](const Interval& range) { return may_be_split(range); });
  }
  bool is_bounded() const
  {
    return std::all_of(m_box.begin(), m_box.end(), [](const Interval& range) { return is_finite(range); });
  }
  void leave_undecided()
  {
    m_undecided.push_back(m_box);
    if (m_undecided.size() % m_options.coarsening_step == 0)
      m_tolerance *= 2;
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Propagation_search::examine(const Waiting& node)
{
  ++m_nodes;
  const Verdict verdict = narrow(node);
  if (verdict == Verdict::OPEN && !(is_at_tolerance() && finds_root())) {
    if (!is_at_tolerance()) {
      split(node.depth);
      return;
    }
    leave_undecided();
  }
  m_control.add_progress(std::ldexp(1.0, -node.depth));
}

// By the constraints that know of the split, then by combinations and the constraints in turns, while that gains much.
CGAL_SPLINE_CONSTRAINTS_INLINE Propagation_search::Verdict Propagation_search::narrow(const Waiting& node)
{
  constexpr int most_rounds = 12, many_unknowns = 64;
  constexpr double least_gain = 0.1, of_all_for_proof = 0.5;
  if (node.split_unknown < 0)
    m_propagation.wake_all();
  else
    m_propagation.wake_constraints_of(node.split_unknown);
  if (!m_propagation.narrow(m_box))
    return Verdict::EMPTY;
  if (!m_system.is_polynomial() && !is_bounded())
    return Verdict::OPEN;
  // where functions are steep, the elimination leaves out much that the inverse knows together
  if (!m_system.is_polynomial() && (node.split_unknown < 0 || m_system.dimension() > many_unknowns) &&
      m_rows.invert(m_box) && !m_rows.narrow(m_box))
    return Verdict::EMPTY;
  for (int round = 0; round < most_rounds; ++round) {
    if (!m_rows.eliminate(m_box))
      return Verdict::OPEN;
    m_before = m_box;
    if (!m_rows.narrow(m_box))
      return Verdict::EMPTY;
    bool is_gain = false, is_gain_everywhere = true;
    for (int j = 0; j < m_system.dimension(); ++j) {
      const double old_width = width(m_before[j]), new_width = width(m_box[j]);
      if (new_width < (1 - least_gain) * old_width) {
        is_gain = true;
        m_propagation.wake_constraints_of(j);
      }
      is_gain_everywhere = is_gain_everywhere &&
          (new_width <= of_all_for_proof * old_width || new_width <= 0x1p-40 * magnitude(m_box[j]));
    }
    if (is_gain_everywhere && finds_root())
      return Verdict::ROOT;
    if (!is_gain)
      return Verdict::OPEN;
    if (!m_propagation.narrow(m_box))
      return Verdict::EMPTY;
  }
  return Verdict::OPEN;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Propagation_search::finds_root()
{
  if (!m_system.is_polynomial() && !is_bounded())
    return false;
  const auto root = m_krawczyk_test(m_box);
  if (!root)
    return false;
  if (std::none_of(m_roots.begin(), m_roots.end(), [&](const Proved_root& other) { return are_equal(*root, other); }))
    m_roots.push_back(*root);
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Propagation_search::split(int depth)
{
  const int unknown = unknown_to_split();
  const Interval range = m_box[unknown];
  const double at = middle(range);
  m_box[unknown] = Interval(at, range.sup());
  push(m_box, unknown, depth + 1);
  m_box[unknown] = Interval(range.inf(), at);
  push(m_box, unknown, depth + 1);
}

// The one with the largest rating of those that are not much better known than others.
CGAL_SPLINE_CONSTRAINTS_INLINE int Propagation_search::unknown_to_split()
{
  constexpr double well_known = 0.01;
  rate_unknowns();
  const auto ignorance = [&](int j) { return magnitude(m_box[j]) > 0 ? width(m_box[j]) / magnitude(m_box[j]) : 0; };
  double largest = 0;
  for (int j = 0; j < unknowns_to_split(); ++j)
    if (may_be_split(m_box[j]))
      largest = (std::max)(largest, ignorance(j));
  int result = -1;
  double best = -1;
  for (int j = 0; j < unknowns_to_split(); ++j)
    if (may_be_split(m_box[j]) && ignorance(j) >= well_known * largest)
      if (const double rating = m_rating[j] * std::sqrt(std::sqrt(ignorance(j))); result < 0 || rating > best) {
        result = j;
        best = rating;
      }
  return result;
}

// By the sum over the constraints of its share in their variation (the smear of Kearfott). What defined unknowns have
// is shared by those that define them.
CGAL_SPLINE_CONSTRAINTS_INLINE void Propagation_search::rate_unknowns()
{
  m_rating.assign(m_system.dimension(), 0);
  for (int i = 0; i < m_system.constraints(); ++i)
    share_rating(1, i, -1);
  for (int j = m_system.dimension() - 1; j >= unknowns_to_split(); --j)
    share_rating(m_rating[j], m_system.definition(j), j);
}

// Adds to the ratings of the unknowns of a constraint, but one.
CGAL_SPLINE_CONSTRAINTS_INLINE void Propagation_search::share_rating(double rating, int constraint, int but)
{
  m_smear.clear();
  double sum = 0;
  const auto add = [&](int unknown, const Interval& slope) {
    const double smear = unknown == but ? 0 : magnitude(slope) * width(m_box[unknown]);
    m_smear.emplace_back(unknown, smear);
    sum += smear;
  };
  for (const auto& occurrence : m_system.occurrences(constraint)) {
    if (!is_finite(m_box[occurrence.unknown])) {
      add(occurrence.unknown, Interval(1));
      continue;
    }
    m_system.set_polynomial_in(occurrence, constraint, m_box, m_polynomial);
    add(occurrence.unknown, m_polynomial.range_of_derivative(m_box[occurrence.unknown]));
  }
  for (const auto& part : m_system.elementary_parts(constraint)) {
    const Elementary_term& function = m_system.function(part.function);
    const Interval argument = function.argument(m_box);
    add(function.unknown,
        part.coefficient * function.scale *
            elementary::range_of_derivative(function.operation, argument,
                                            elementary::range_of_values(function.operation, argument)));
  }
  if (sum > 0 && std::isfinite(sum))
    for (const auto& [unknown, smear] : m_smear)
      m_rating[unknown] += rating * smear / sum;
  else if (!m_system.is_polynomial()) // near poles
    for (const auto& [unknown, smear] : m_smear)
      m_rating[unknown] += std::isfinite(smear) ? 0 : rating;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_SEARCH_H
