// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_PRECISION_LADDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_PRECISION_LADDER_H

#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_collection.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/irrational_multiple_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/cell_boxes.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/clusters.h>
#include <CGAL/Spline_constraints_d/solver/solver_traits.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The boxes that doubles leave open climb: they are subdivided again with 128, 256, ... bits and rational corners, from
the exact functions. Only they do; what is decided on the way is reported with the precision that decided it, what is
left at the end with boxes of that precision.

There is no rung of intervals of doubles between: a double node that is rebuilt from the exact functions, and looked at
through C f formed exactly, is as sharp, and ends at the same coordinates. Nor one of rationals above: positions on
boundaries and multiplicities are decided in exact arithmetic on every rung.
*/
class Precision_ladder
{
  using Number = Mpfr_interval;
  using Box = Open_box<Exact_rational>;

  const Constraint_system_d& m_system;
  const System_layout& m_layout;
  Exact_source& m_source;
  const Found_roots<double>& m_known;
  Solver_options m_options;
  Run_control& m_control;
  Summary& m_summary;
  std::size_t m_node_limit;
  std::vector<Multiple_root_search> m_multiple_roots;
  std::vector<Found_root<Exact_rational>> m_climbed;   // roots that were reported, perhaps beside the open box
  // Bounds what is spent on what no precision decides.
  static constexpr std::size_t m_budget = 5000;
  // Boxes where no multiple root was found: after so many, only double roots are looked for.
  std::size_t m_failures = 0;
  static constexpr std::size_t m_most_failures = 8;

public:
  Precision_ladder(const Constraint_system_d& system, const System_layout& layout, Exact_source& source,
                   const Found_roots<double>& known, const Solver_options& options, Run_control& control,
                   Summary& summary)
    : m_system(system), m_layout(layout), m_source(source), m_known(known), m_options(options), m_control(control),
      m_summary(summary), m_node_limit(summary.nodes + m_budget)
  {
    if (options.node_limit > 0)
      m_node_limit = (std::min)(m_node_limit, options.node_limit);
  }

  // Appends what an open box turns out to be, when `answer` is all that doubles can say of it. It climbs when more
  // precision may tell more: not where a solution is known that is not regular, not when the box is large or a limit
  // was reached, and not when roots are too close for it.
  void report(const Open_box<double>& box, const Solution_d<double>& answer, std::vector<Solution_d<double>>& solutions)
  {
    const Exact_box ranges = exact_box(box);
    if (std::any_of(m_multiple_roots.begin(), m_multiple_roots.end(),
                    [&](const Multiple_root_search& known) { return known.covers(ranges); }))
      return;
    const bool is_regular =
        answer.kind() == Solution_kind::CLUSTER && answer.multiplicity() < 2 && holds_regular_solution(box);
    const bool is_open = answer.reason() == Undecided_reason::TOLERANCE;
    bool may_climb = is_regular || is_open;
    if (is_open && m_options.ladder_precision > 0) {
      constexpr std::size_t boxes_of_search = 384;
      m_control.charge(boxes_of_search);
      Multiple_root_search search = search_multiple_root(
          m_system, ranges, m_failures < m_most_failures ? Multiple_root_search::most_multiplicity : 2,
          [&] { return m_control.must_stop(true); });
      if (report_multiple_root(search, solutions))
        return;
      m_failures += search.root ? 0 : 1;
      may_climb = !is_beyond_reach(search);
    }
    if (may_climb)
      climb(box, answer, solutions);
    else
      solutions.push_back(answer);
  }

private:
  static Exact_box exact_box(const Open_box<double>& box)
  {
    Exact_box result;
    for (std::size_t j = 0; j < box.lower.size(); ++j)
      result.emplace_back(Exact_rational(box.lower[j]), Exact_rational(box.upper[j]));
    return result;
  }

  // One sign is missing to tell a double root from two roots and from none, and more bits than the ladder has on both
  // sides did not tell it: the distance of two roots is about the root of that value.
  bool is_beyond_reach(const Multiple_root_search& search) const
  {
    return search.outcome == Multiple_root_search::NOTHING_PROVED && search.root &&
        search.root->bits_of_width() >= 2 * m_options.ladder_precision;
  }

  // Whether the box is decided: it holds a multiple root, perhaps an irrational one, or two close to each other, or
  // nothing.
  bool report_multiple_root(Multiple_root_search& search, std::vector<Solution_d<double>>& solutions)
  {
    std::vector<Algebraic_root> roots;
    if (search.outcome == Multiple_root_search::MULTIPLE_ROOT)
      roots.push_back(*search.root);
    else if (search.outcome == Multiple_root_search::CLOSE_ROOTS)
      roots = close_roots(m_system, search);
    std::vector<Position> positions;
    for (Algebraic_root& root : roots)
      positions.push_back(algebraic_position(m_system, root));
    const auto is_decided = [](Position position) {
      return position == Position::INSIDE || position == Position::OUTSIDE;
    };
    if ((roots.empty() && search.outcome != Multiple_root_search::NO_ROOT) ||
        !std::all_of(positions.begin(), positions.end(), is_decided))
      return false;   // more precision may tell
    const int multiplicity = search.outcome == Multiple_root_search::MULTIPLE_ROOT ? search.multiplicity : 1;
    const auto is_in_region = [&](const Solution_d<double>& known) {
      return known.kind() == Solution_kind::CLUSTER && contains(search.region, known.exact_box());
    };
    for (std::size_t i = 0; i < roots.size(); ++i)
      if (positions[i] == Position::INSIDE &&
          (multiplicity > 1 ? std::none_of(solutions.begin(), solutions.end(), is_in_region)
                            : !is_known(found(roots[i]))))
        report(roots[i], multiplicity, solutions);
    m_multiple_roots.push_back(std::move(search));
    return true;
  }

  static Found_root<Exact_rational> found(const Algebraic_root& root)
  {
    return {root.box(), root.region(), Position::INSIDE};
  }

  void report(Algebraic_root& root, int multiplicity, std::vector<Solution_d<double>>& solutions)
  {
    const int bits = root.bits_of_width() < Algebraic_root::bits_of_point
        ? static_cast<int>((std::max)(root.bits_of_width(), 128L))
        : 128;
    root.refine(bits);
    const bool is_regular = multiplicity == 1;
    if (is_regular)
      m_climbed.push_back(found(root));
    const Solution_kind kind = is_regular ? Solution_kind::CERTIFIED : Solution_kind::CLUSTER;
    solutions.emplace_back(Solution_d<Exact_rational>(kind, root.box(), is_regular ? root.region() : Exact_box(),
                                                      Number_traits<Number>::name, Undecided_reason::NONE,
                                                      multiplicity),
                           bits);
  }

  // The solution that is known in a cluster is regular: it is the only one in a much smaller box around it.
  bool holds_regular_solution(const Open_box<double>& box) const
  {
    Certified_region<Exact_rational> region;
    if (const std::vector<Exact_rational> point = rational_solution_in(m_system, box); !point.empty())
      region.lower = region.upper = point;
    else {
      const Partly_rational_solution solution = partly_rational_solution_in(m_system, box);
      region.lower = solution.lower;
      region.upper = solution.upper;
    }
    for (std::size_t j = 0; j < region.lower.size(); ++j) {
      const double margin = 0x1p-150 * (std::max)(1.0, std::abs(CGAL::to_double(region.lower[j])));
      std::tie(region.lower[j], region.upper[j]) =
          dyadic_hull<Exact_rational>(below(region.lower[j], margin), above(region.upper[j], margin), 300);
    }
    return holds_one_root(region);
  }

  bool holds_one_root(Certified_region<Exact_rational>& region) const
  {
    using Certification = Piecewise_certification<Exact_rational>;
    if (Certification(m_layout, m_source).certify(region) == Certification::ONE_ROOT)
      return true;
    Preconditioned_system<Exact_rational> preconditioned(m_system, m_layout, m_source, m_summary);
    return preconditioned.is_applicable() && preconditioned.certify(region) == Certification::ONE_ROOT;
  }

  void climb(const Open_box<double>& box, const Solution_d<double>& answer, std::vector<Solution_d<double>>& solutions)
  {
    std::vector<Box> open{
        {{box.lower.begin(), box.lower.end()}, {box.upper.begin(), box.upper.end()}, box.reason, box.cell}};
    int bits = 0;
    for (int next = 128; !open.empty() && next <= m_options.ladder_precision && m_summary.nodes < m_node_limit &&
         !m_control.must_stop(true);
         next *= 2) {
      bits = next;
      open = step(open, bits, solutions);
    }
    if (bits == 0)
      solutions.push_back(answer);
    else
      for (const Box& left : open)
        solutions.emplace_back(classified<Number>(m_system, left), bits);
  }

  // Subdivides the boxes with a number of bits; returns what stays open.
  std::vector<Box> step(const std::vector<Box>& boxes, int bits, std::vector<Solution_d<double>>& solutions)
  {
    const Mpfr_precision_scope precision(bits);
    constexpr int guard_bits = 24;
    m_options.tolerance = std::ldexp(1.0, guard_bits - bits);
    Root_collection<Number> roots(m_system, m_layout, m_source, bits);
    using Walk = Subdivision<Solver_traits<Number>>;
    Walk subdivision(m_system, m_layout, m_source, m_options, m_control, roots, m_summary);
    for (const Box& box : boxes)
      visit_cell_boxes<Exact_rational>(
          m_source, box.lower, box.upper, bits, [&](const Cell& cell, const auto& lower, const auto& upper) {
            const std::size_t budget = m_summary.nodes < m_node_limit ? m_node_limit - m_summary.nodes : 0;
            subdivision.run(Walk::make_task(cell, lower, upper, 0),
                            {.nodes = budget, .looks = 32, .attempts = 64, .open_before = 0, .guesses = 0});
          });
    std::vector<Box>& open = subdivision.open_boxes();
    const Undecided_reason reason =
        m_control.reason() == Undecided_reason::NONE ? Undecided_reason::TOLERANCE : m_control.reason();
    for (const auto& task : subdivision.pending())
      open.push_back({task.lower, task.upper, reason, task.cell});
    merge_boxes_that_meet(open);
    std::vector<Solution_d<Exact_rational>> reported;
    for (const auto& root : roots.roots()) {
      if (is_known(root))
        continue;
      if (meets_known(root.enclosure)) {
        if (!is_same_as_known(root)) // or else it may be another one: not to be counted
          open.push_back(open_box(root.enclosure));
        continue;
      }
      report_root<Number>(root, reported);
      m_climbed.push_back(root);
    }
    for (const auto& solution : reported)
      solutions.emplace_back(solution, bits);
    return std::move(open);
  }

  // Whether it is so for a root that was certified in double, or on a higher rung, beside the open box.
  template <class Predicate>
  bool is_any_known(const Predicate& predicate) const
  {
    return std::any_of(m_known.roots().begin(), m_known.roots().end(), predicate) ||
        std::any_of(m_climbed.begin(), m_climbed.end(), predicate);
  }

  bool is_known(const Found_root<Exact_rational>& root) const
  {
    return is_any_known([&](const auto& known) {
      return lies_in(root.enclosure, known.region) || lies_in(known.enclosure, root.region);
    });
  }

  bool meets_known(const Exact_box& box) const
  {
    return is_any_known([&](const auto& known) { return meet(box, known.enclosure); });
  }

  // The least box around the enclosures of the root and of a known one that meet, a little wider, holds only one.
  bool is_same_as_known(const Found_root<Exact_rational>& root) const
  {
    return is_any_known([&](const auto& known) {
      if (!meet(root.enclosure, known.enclosure))
        return false;
      Certified_region<Exact_rational> region;
      for (std::size_t j = 0; j < root.enclosure.size(); ++j) {
        const Exact_rational first(known.enclosure[j].first), second(known.enclosure[j].second);
        const Exact_rational lower = (std::min)(root.enclosure[j].first, first),
                             upper = (std::max)(root.enclosure[j].second, second), margin = (upper - lower) / 8;
        region.lower.push_back(lower - margin);
        region.upper.push_back(upper + margin);
      }
      return holds_one_root(region);
    });
  }

  Box open_box(const Exact_box& enclosure) const
  {
    Box result{{}, {}, Undecided_reason::TOLERANCE, {}};
    for (const auto& [lower, upper] : enclosure) {
      result.lower.push_back(lower);
      result.upper.push_back(upper);
    }
    result.cell = m_source.cell_of(std::span<const Exact_rational>(result.lower));
    return result;
  }

  template <class Box_of_numbers, class Other_box>
  static bool meet(const Box_of_numbers& a, const Other_box& b)
  {
    for (std::size_t j = 0; j < a.size(); ++j)
      if (Exact_rational(a[j].second) < Exact_rational(b[j].first) ||
          Exact_rational(b[j].second) < Exact_rational(a[j].first))
        return false;
    return true;
  }

  template <class Box_of_numbers, class Other_box>
  static bool lies_in(const Box_of_numbers& inner, const Other_box& outer)
  {
    for (std::size_t j = 0; j < inner.size(); ++j)
      if (Exact_rational(inner[j].first) < Exact_rational(outer[j].first) ||
          Exact_rational(outer[j].second) < Exact_rational(inner[j].second))
        return false;
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_PRECISION_LADDER_H
