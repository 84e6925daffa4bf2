// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_DEPTH_FIRST_PROPAGATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_DEPTH_FIRST_PROPAGATION_H

#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Box_shaving.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Constraint_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Determining_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Krawczyk_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Preconditioned_rows.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Waiting_boxes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What a part of the search has found, and what it left.
struct Propagation_outcome
{
  std::vector<Proved_root> roots; // different ones
  std::vector<Box_of_ranges> undecided;
  Waiting_boxes waiting;
  std::size_t nodes = 0; // and for each eight slices of boxes another one
  double share = 0;      // of the domain that is done
};

// How a part of the search is to be done.
struct Propagation_limits
{
  std::size_t nodes;
  double tolerance; // narrower boxes are not split
  bool uses_slices; // boxes are narrowed by slices, too
};

/*
Looks at a box and its parts, depth-first: boxes are narrowed by the constraints one by one and by combinations of the
equalities, until they are empty, hold one root by proof, or are split. What it does with a box depends on nothing that
was looked at before.
*/
class Depth_first_propagation
{
  const Sparse_system& m_system;
  const Block_order& m_blocks;
  const Determining_unknowns& m_determining;
  Run_control& m_control;
  std::function<void()> m_check;
  Constraint_propagation m_propagation;
  Box_shaving m_shaving;
  Preconditioned_rows m_rows;
  Krawczyk_test m_krawczyk_test;
  Univariate_interval_polynomial m_polynomial;
  Box_of_ranges m_box, m_before;
  std::vector<double> m_rating;
  std::vector<std::pair<int, double>> m_smear; // of the unknowns of the constraint in hand
  std::vector<int> m_shaved;                   // unknowns
  Propagation_limits m_limits{};
  Propagation_outcome m_outcome;

  enum class Verdict
  {
    EMPTY,
    ROOT,
    OPEN
  };

public:
  Depth_first_propagation(const Sparse_system& system, const Block_order& blocks,
                          const Determining_unknowns& determining, Run_control& control)
    : m_system(system), m_blocks(blocks), m_determining(determining), m_control(control),
      m_check([this] { m_control.check(); }), m_propagation(system), m_shaving(m_propagation, m_check),
      m_rows(system, m_check), m_krawczyk_test(m_rows, !system.is_polynomial())
  {}

  Depth_first_propagation(const Depth_first_propagation&) = delete;
  Depth_first_propagation& operator=(const Depth_first_propagation&) = delete;

  // Until no part waits, the limit of nodes is reached, or the run ends.
  Propagation_outcome operator()(const Waiting_boxes& boxes, const Propagation_limits& limits);

private:
  void examine(const Waiting_boxes::Origin& origin);
  Verdict narrow(const Waiting_boxes::Origin& origin);
  Verdict narrow_by_combinations(int block);
  bool narrow_by_slices();
  bool finds_root();
  void split(int depth);
  int unknown_to_split();
  int open_block() const;
  void rate_unknowns();
  void share_rating(double rating, int constraint, int but);

  // Wide beside the tolerance, and with a double inside.
  bool may_be_split(const Interval& range) const
  {
    return width(range) >= m_limits.tolerance * (std::max)(1.0, magnitude(range)) && range.inf() < middle(range) &&
        middle(range) < range.sup();
  }
  // Those that are not defined by others.
  int unknowns_to_split() const { return m_system.dimension() - m_system.defined(); }
  bool is_at_tolerance() const
  {
    return std::none_of(m_box.begin(), m_box.begin() + unknowns_to_split(),
                        [&](const Interval& range) { return may_be_split(range); });
  }
  double ignorance(int j) const { return magnitude(m_box[j]) > 0 ? width(m_box[j]) / magnitude(m_box[j]) : 0; }
  // The largest one of the unknowns of a block that may be split; of all blocks for -1.
  double largest_ignorance(int block) const
  {
    double result = 0;
    for (int j = 0; j < unknowns_to_split(); ++j)
      if ((block < 0 || m_blocks.block(j) == block) && may_be_split(m_box[j]))
        result = (std::max)(result, ignorance(j));
    return result;
  }
  bool is_bounded() const
  {
    return std::all_of(m_box.begin(), m_box.end(), [](const Interval& range) { return is_finite(range); });
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Propagation_outcome Depth_first_propagation::operator()(const Waiting_boxes& boxes,
                                                                                       const Propagation_limits& limits)
{
  m_limits = limits;
  m_outcome.waiting = boxes;
  while (!m_outcome.waiting.is_empty() && m_outcome.nodes < m_limits.nodes && !m_control.must_stop(true)) {
    const Waiting_boxes::Origin origin = m_outcome.waiting.pop(m_box);
    try {
      examine(origin);
    } catch (const Run_stopped&) {
      m_outcome.waiting.push(m_box, origin);
    }
  }
  return std::exchange(m_outcome, {});
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Depth_first_propagation::examine(const Waiting_boxes::Origin& origin)
{
  ++m_outcome.nodes;
  const Verdict verdict = narrow(origin);
  if (verdict == Verdict::OPEN && !(is_at_tolerance() && finds_root())) {
    if (!is_at_tolerance()) {
      split(origin.depth);
      return;
    }
    m_outcome.undecided.push_back(m_box);
  }
  m_outcome.share += Waiting_boxes::share_of(origin);
}

// By the constraints that know of the split, then by combinations of those of the first block that is not solved, and
// of the next one when it is.
CGAL_SPLINE_CONSTRAINTS_INLINE Depth_first_propagation::Verdict
Depth_first_propagation::narrow(const Waiting_boxes::Origin& origin)
{
  constexpr int many_unknowns = 64;
  if (origin.split_unknown < 0)
    m_propagation.wake_all();
  else
    m_propagation.wake_constraints_of(origin.split_unknown);
  if (!m_propagation.narrow(m_box))
    return Verdict::EMPTY;
  if (!m_system.is_polynomial() && !is_bounded())
    return Verdict::OPEN;
  if (m_limits.uses_slices && !narrow_by_slices())
    return Verdict::EMPTY;
  // where functions are steep, the elimination leaves out much that the inverse knows together
  if (!m_system.is_polynomial() && (origin.split_unknown < 0 || m_system.dimension() > many_unknowns) &&
      m_rows.invert(m_box) && !m_rows.narrow(m_box))
    return Verdict::EMPTY;
  for (int block = open_block();;) {
    const Verdict verdict = narrow_by_combinations(block);
    const int next = verdict == Verdict::OPEN ? open_block() : block;
    if (next <= block)
      return verdict;
    block = next;
  }
}

// And by the constraints in turns, while that gains much.
CGAL_SPLINE_CONSTRAINTS_INLINE Depth_first_propagation::Verdict
Depth_first_propagation::narrow_by_combinations(int block)
{
  constexpr int most_rounds = 12;
  constexpr double least_gain = 0.1, of_all_for_proof = 0.5;
  for (int round = 0; round < most_rounds; ++round) {
    if (!m_rows.eliminate(m_box, m_blocks.blocks()[block]))
      return Verdict::OPEN;
    m_before = m_box;
    if (!m_rows.narrow(m_box))
      return Verdict::EMPTY;
    bool is_gain = false, is_gain_everywhere = true;
    for (int j = 0; j < m_system.dimension(); ++j) {
      const double old_width = width(m_before[j]), new_width = width(m_box[j]);
      is_gain = is_gain || new_width < (1 - least_gain) * old_width;
      is_gain_everywhere = is_gain_everywhere &&
          (new_width <= of_all_for_proof * old_width || new_width <= 0x1p-40 * magnitude(m_box[j]));
    }
    if (is_gain_everywhere && finds_root())
      return Verdict::ROOT;
    if (!is_gain)
      return Verdict::OPEN;
    for (int j = 0; j < m_system.dimension(); ++j)
      if (width(m_box[j]) < (1 - least_gain) * width(m_before[j]))
        m_propagation.wake_constraints_of(j);
    if (!m_propagation.narrow(m_box))
      return Verdict::EMPTY;
  }
  return Verdict::OPEN;
}

// Of all unknowns, those first that are to be split first.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Depth_first_propagation::narrow_by_slices()
{
  constexpr std::size_t slices_of_node = 8; // take about as long as one
  rate_unknowns();
  m_shaved.clear();
  for (int j = 0; j < unknowns_to_split(); ++j)
    if (may_be_split(m_box[j]))
      m_shaved.push_back(j);
  std::ranges::stable_sort(m_shaved, [&](int i, int j) { return m_rating[i] > m_rating[j]; });
  const std::size_t before = m_shaving.slices();
  const bool is_left = std::ranges::all_of(m_shaved, [&](int j) { return m_shaving(j, m_box); });
  m_outcome.nodes += (m_shaving.slices() - before) / slices_of_node;
  return is_left;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Depth_first_propagation::finds_root()
{
  if (!m_system.is_polynomial() && !is_bounded())
    return false;
  const auto root = m_krawczyk_test(m_box);
  if (!root)
    return false;
  add_unless_known(*root, m_outcome.roots);
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Depth_first_propagation::split(int depth)
{
  const int unknown = unknown_to_split();
  const Interval range = m_box[unknown];
  const double at = middle(range);
  m_box[unknown] = Interval(at, range.sup());
  m_outcome.waiting.push(m_box, {unknown, depth + 1});
  m_box[unknown] = Interval(range.inf(), at);
  m_outcome.waiting.push(m_box, {unknown, depth + 1});
}

// The first one that is not solved, beside others: what is known of later ones depends on it.
CGAL_SPLINE_CONSTRAINTS_INLINE int Depth_first_propagation::open_block() const
{
  constexpr double solved = 0x1p-20;
  const double least = solved * largest_ignorance(-1);
  int result = static_cast<int>(m_blocks.blocks().size()) - 1;
  for (int j = 0; j < unknowns_to_split() && result > 0; ++j)
    if (m_blocks.block(j) < result && may_be_split(m_box[j]) && ignorance(j) >= least)
      result = m_blocks.block(j);
  return result;
}

// The one with the largest rating of those of the first open block that are not much better known than others there.
CGAL_SPLINE_CONSTRAINTS_INLINE int Depth_first_propagation::unknown_to_split()
{
  constexpr double well_known = 0.01, preference = 10;
  rate_unknowns();
  const int block = open_block();
  const double least = well_known * largest_ignorance(block);
  int result = -1;
  double best = -1;
  for (int j = 0; j < unknowns_to_split(); ++j)
    if (m_blocks.block(j) == block && may_be_split(m_box[j]) && ignorance(j) >= least)
      if (const double rating = m_rating[j] * (m_determining[j] ? preference : 1) * std::sqrt(std::sqrt(ignorance(j)));
          result < 0 || rating > best) {
        result = j;
        best = rating;
      }
  return result;
}

// By the sum over the constraints of its share in their variation (the smear of Kearfott). What defined unknowns have
// is shared by those that define them.
CGAL_SPLINE_CONSTRAINTS_INLINE void Depth_first_propagation::rate_unknowns()
{
  m_rating.assign(m_system.dimension(), 0);
  for (int i = 0; i < m_system.constraints(); ++i)
    share_rating(1, i, -1);
  for (int j = m_system.dimension() - 1; j >= unknowns_to_split(); --j)
    share_rating(m_rating[j], m_system.definition(j), j);
}

// Adds to the ratings of the unknowns of a constraint, but one.
CGAL_SPLINE_CONSTRAINTS_INLINE void Depth_first_propagation::share_rating(double rating, int constraint, int but)
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

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_DEPTH_FIRST_PROPAGATION_H
