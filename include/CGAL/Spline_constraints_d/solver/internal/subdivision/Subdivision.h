// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SUBDIVISION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SUBDIVISION_H

#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Multiple_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Preconditioned_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_certification.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_collection.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Solution_curve_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_analysis.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Depth_first_subdivision.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A box in which nothing was proved.
template <class Coordinate>
struct Open_box
{
  std::vector<Coordinate> lower, upper;
  Undecided_reason reason;
  Cell cell;
};

// A part of the domain that is still to be looked at.
template <class Coordinate>
struct Subdivision_task
{
  Cell cell;
  std::vector<Coordinate> lower, upper;
  std::vector<double> domain_widths;   // of the whole cell
  int depth = 0;
  double share = 0;                    // of the domain
};

// What a task may use.
struct Task_limits
{
  std::size_t nodes;         // at least one
  std::size_t looks;         // at C f, and four more for each that pays
  std::size_t attempts;      // to certify boxes around open ones: not for the many of a continuum
  std::size_t open_before;   // boxes that were left open elsewhere
  std::size_t guesses = 16;  // that a box holds a solution which is not regular, and some more for each that is right
  int depth = (std::numeric_limits<int>::max)();   // the first box that was split more often ends the task
};

/*
Points of solutions: what becomes of the boxes in a part of the domain, up to a number of nodes. A box ends empty, by a
proof; or with all its roots inside regions that hold exactly one root each; or open; what is left at the end of the
budget comes back as tasks.
*/
template <class Traits>
class Subdivision
{
public:
  using Coordinate = typename Number_traits<typename Traits::Number_type>::Coordinate;
  using Task = Subdivision_task<Coordinate>;

  // What the driver keeps for a box.
  struct State
  {
    double share;            // of the domain
    // over the box and those that it is a part of, as long as they lie below the planes of splits
    int passes = 0;
    bool is_fresh = false;   // it was rebuilt since it last shrank, and is not rebuilt again
  };

private:
  using NT = typename Traits::Number_type;
  using Node = Box_node<NT>;

  const Constraint_system_d& m_system;
  const System_layout& m_layout;
  const Solver_options& m_options;
  Run_control& m_control;
  Summary& m_summary;

  typename Traits::Termination_test m_test;
  typename Traits::Reduction m_reduction;
  typename Traits::Splitter m_splitter;

  Node_analysis<NT> m_analysis;
  Preconditioned_system<NT> m_preconditioned;
  Root_certification<NT> m_certification;
  std::optional<Solution_curve_test<NT>> m_curve_test;   // for three unknowns and more
  Local_box m_box;
  Depth_first_subdivision<NT> m_driver;
  std::vector<Open_box<Coordinate>> m_open, m_curve_boxes;
  std::vector<Task> m_pending;
  std::vector<Multiple_root> m_multiple_roots;
  const std::vector<Multiple_root>* m_known_multiple_roots = nullptr;
  std::vector<Relation> m_relations;
  std::vector<double> m_rating, m_widths, m_domain_widths;
  Cell m_cell;
  std::size_t m_looks = 0, m_gains = 0, m_most_looks = 0;   // at C f
  std::size_t m_most_attempts = 0, m_most_guesses = 0, m_curve_guesses = 0, m_point_guesses = 0;
  std::size_t m_last_node = 0, m_open_before = 0;
  int m_deepest = 0;
  static constexpr double m_coarsening = 32;
  std::size_t m_poll_interval;   // nodes between looks at the clock
  bool m_has_taken_long = false;
  double m_tolerance, m_done = 0;

public:
  Subdivision(const Constraint_system_d& system, const System_layout& layout, Exact_source& source,
              const Solver_options& options, Run_control& control, Root_collection<NT>& roots, Summary& summary)
    : m_system(system), m_layout(layout), m_options(options), m_control(control), m_summary(summary),
      m_analysis(layout, source, summary, Traits::tracks_rounding), m_preconditioned(system, layout, source, summary),
      m_certification(layout, source, m_preconditioned, roots, summary), m_driver(layout),
      m_poll_interval(poll_interval(layout)), m_tolerance(options.tolerance)
  {
    if (layout.dimension >= 3)
      m_curve_test.emplace(layout, source, summary, Traits::tracks_rounding);
    for (const auto& inequality : system.inequalities())
      m_relations.push_back(inequality.relation);
    m_domain_widths.resize(m_layout.dimension);
    m_widths.resize(m_layout.dimension);
  }

  // Walks over a task.
  void run(const Task& task, const Task_limits& limits)
  {
    m_cell = task.cell;
    m_domain_widths = task.domain_widths;
    m_last_node = m_summary.nodes + limits.nodes;
    m_open_before = limits.open_before;
    m_deepest = limits.depth;
    m_tolerance =
        m_options.tolerance * std::pow(m_coarsening, static_cast<double>(m_open_before / m_options.coarsening_step));
    m_most_looks = limits.looks;
    m_most_attempts = limits.attempts;
    m_most_guesses = limits.guesses;
    m_looks = m_gains = m_curve_guesses = m_point_guesses = 0;
    Node& root = m_driver.root();
    root.lower = task.lower;
    root.upper = task.upper;
    m_analysis.source().set_home(m_cell, std::span<const Coordinate>(task.lower),
                                 std::span<const Coordinate>(task.upper));
    m_analysis.rebuild(m_cell, root);
    m_driver.run(*this, State{task.share}, task.depth);
    m_analysis.source().leave_home();
    m_control.add_progress(std::exchange(m_done, 0));
  }

  // The task that a box in one cell is.
  static Task make_task(const Cell& cell, const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper,
                        double share)
  {
    Task task{.cell = cell, .lower = lower, .upper = upper, .domain_widths = {}, .share = share};
    for (std::size_t j = 0; j < lower.size(); ++j)
      task.domain_widths.push_back(CGAL::to_double(Coordinate(upper[j] - lower[j])));
    return task;
  }

  std::vector<Task>& pending() { return m_pending; }

  // Looks at C f of the last task, and how many of them decided a node.
  std::size_t looks() const { return m_looks; }
  std::size_t gains() const { return m_gains; }

  Root_certification<NT>& certification() { return m_certification; }
  std::vector<Open_box<Coordinate>>& open_boxes() { return m_open; }

  // Boxes that look like pieces of a curve of solutions; their solutions have at most dimension one.
  std::vector<Open_box<Coordinate>>& curve_boxes() { return m_curve_boxes; }

  // Multiple roots; and others, found elsewhere.
  std::vector<Multiple_root>& multiple_roots() { return m_multiple_roots; }
  void set_known_multiple_roots(const std::vector<Multiple_root>* roots) { m_known_multiple_roots = roots; }

  // Tries whether the simplest point of a box is a multiple root; if so, it is kept.
  bool guess_multiple_root(const Cell& cell, const std::vector<Coordinate>& box_lower,
                           const std::vector<Coordinate>& box_upper, const std::vector<double>& widths)
  {
    constexpr std::size_t boxes_of_guess = 16;
    m_control.charge(boxes_of_guess);
    const auto root_between = [&](const std::vector<double>& lower, const std::vector<double>& upper) {
      return multiple_root_in(m_system, lower, upper, widths);
    };
    std::optional<Multiple_root> root;
    if constexpr (std::is_same_v<Coordinate, double>)
      root = root_between(box_lower, box_upper);
    else {
      std::vector<double> lower, upper;
      for (int j = 0; j < m_layout.dimension; ++j) {
        lower.push_back(to_double_interval(box_lower[j]).first);
        upper.push_back(to_double_interval(box_upper[j]).second);
      }
      root = root_between(lower, upper);
    }
    if (!root || !clip_to_cell(cell, *root))
      return false;
    m_multiple_roots.push_back(std::move(*root));
    return true;
  }

  // For the driver: false when the budget is used up; then the box is left for a later task.
  bool goes_on(const Node& node, const State& state, int depth)
  {
    ++m_summary.nodes;
    m_summary.depth = (std::max)(m_summary.depth, depth);
    if (m_summary.nodes <= m_last_node && depth <= m_deepest && !must_stop())
      return true;
    m_last_node = --m_summary.nodes;
    m_pending.push_back({m_cell, node.lower, node.upper, m_domain_widths, depth, state.share});
    return false;
  }

  Box_verdict examine(Node& node, State& state, int depth)
  {
    const Box_verdict verdict =
        holds_multiple_root(node, state.passes++) ? Box_verdict::DONE : look_at(node, state, depth);
    if (verdict == Box_verdict::DONE)
      m_done += state.share;
    return verdict;
  }

  // None for a box that looks like a piece of a curve, or is too small.
  std::optional<Box_split<State>> split(Node& node, const State& state, int depth)
  {
    const bool is_curve = is_piece_of_curve(node, depth);
    const int axis = is_curve ? -1 : choose_axis(node);
    if (axis < 0) {
      if (is_curve)
        m_curve_boxes.push_back({node.lower, node.upper, Undecided_reason::CONTINUUM, m_cell});
      else if (m_open.size() >= m_most_attempts || !m_certification.certify_around(m_cell, node))
        leave_open(node);
      m_done += state.share;
      return std::nullopt;
    }
    // Off the middle the first time an axis is cut: roots like to sit on the planes of symmetry.
    const double place = m_widths[axis] > 0.9 ? 125.0 / 256 : 0.5;
    return Box_split<State>{
        axis, place, {.share = state.share / 2, .passes = state.passes}, {.share = state.share / 2}};
  }

private:
  // Beyond the cell the equalities are others.
  bool clip_to_cell(const Cell& cell, Multiple_root& root)
  {
    for (int j = 0; j < m_layout.dimension; ++j)
      if (const auto& breaks = m_analysis.source().breaks(j); breaks.size() > 2) {
        root.lower[j] = (std::max)(root.lower[j], to_double_interval(breaks[cell[j]]).second);
        root.upper[j] = (std::min)(root.upper[j], to_double_interval(breaks[cell[j] + 1]).first);
        if (root.point[j] <= breaks[cell[j]] || breaks[cell[j] + 1] <= root.point[j])
          return false;
      }
    return true;
  }

  static double width(const Node& node, int j) { return CGAL::to_double(Coordinate(node.upper[j] - node.lower[j])); }

  // The node lies in the box of a multiple root. It may hold a new one when it has shrunk again and again, but nothing
  // else came of it: then boxes shrink by a constant factor only.
  bool holds_multiple_root(const Node& node, int passes)
  {
    const auto covers = [&](const Multiple_root& root) { return root.covers(node.lower, node.upper); };
    if (std::any_of(m_multiple_roots.begin(), m_multiple_roots.end(), covers) ||
        (m_known_multiple_roots != nullptr &&
         std::any_of(m_known_multiple_roots->begin(), m_known_multiple_roots->end(), covers)))
      return true;
    if ((passes != 6 && passes != 12 && passes != 24) ||
        m_point_guesses >= m_most_guesses + 8 * m_multiple_roots.size())
      return false;
    ++m_point_guesses;
    m_has_taken_long = true;
    return guess_multiple_root(m_cell, node.lower, node.upper, m_domain_widths) && covers(m_multiple_roots.back());
  }

  // With two unknowns a common factor of the equalities would tell. Asked now and then, and not many times more often
  // than it pays.
  bool is_piece_of_curve(const Node& node, int depth)
  {
    const int n = m_layout.dimension;
    if (!m_curve_test || depth == 0 || depth % n != 0 ||
        m_curve_guesses >= m_most_guesses + 16 * m_curve_boxes.size() ||
        !m_curve_test->may_be_singular(m_analysis.view))
      return false;
    ++m_curve_guesses;
    m_has_taken_long = true;
    return (*m_curve_test)(m_cell, node, m_analysis.view, m_domain_widths);
  }

  Box_verdict look_at(Node& node, State& state, int depth)
  {
    const bool is_fresh = std::exchange(state.is_fresh, false);
    m_analysis.look_at(node);
    if (is_excluded(m_analysis.view))
      return Box_verdict::DONE;
    m_analysis.linear.precondition(m_analysis.view);
    m_box.reset(m_layout.dimension);
    if (!m_reduction.contract(m_analysis.view, m_analysis.linear, m_box))
      return Box_verdict::DONE;
    if (m_analysis.linear.has_inverse() &&
        m_certification.certify(m_cell, node, m_analysis.view, m_analysis.linear, m_box, m_test))
      return Box_verdict::DONE;
    if (contract(node))
      return Box_verdict::AGAIN;
    const bool is_blurred = m_analysis.is_blurred(node);
    if (is_blurred && !is_fresh && m_analysis.can_be_sharpened(node)) {
      m_analysis.rebuild(m_cell, node);
      state.is_fresh = true;
      return Box_verdict::AGAIN;
    }
    const bool is_wanted = is_blurred || (depth >= 24 && depth % 8 == 0 && !m_analysis.linear.has_inverse());
    const bool pays = m_looks < m_most_looks + 4 * m_gains;   // not on a continuum, where no C helps
    return is_wanted && pays && m_preconditioned.is_applicable() ? look_closer(node) : Box_verdict::SPLIT;
  }

  // No control point of an equality, or of an inequality, reaches the values that would satisfy it.
  bool is_excluded(Node_view& view)
  {
    for (int f = 0; f < m_layout.equalities; ++f)
      if (view.lower(f) > 0 || view.upper(f) < 0)
        return true;
    for (std::size_t g = 0; g < m_relations.size(); ++g)
      if (is_certainly_violated(m_relations[g], view.lower(m_layout.equalities + g),
                                view.upper(m_layout.equalities + g)))
        return true;
    return false;
  }

  // Looks at C f, formed exactly: for a node that rounding blurs although its coefficients are fresh, and now and then
  // for a deep one, since the linear rows do not see how the equations cancel beyond their slopes.
  Box_verdict look_closer(Node& node)
  {
    ++m_looks;
    m_has_taken_long = true;
    const Box_verdict verdict = look_at_preconditioned(node);
    m_gains += verdict == Box_verdict::DONE;
    return verdict;
  }

  Box_verdict look_at_preconditioned(Node& node)
  {
    const Image_test image = m_preconditioned.test_image(m_cell, node, m_analysis.linear);
    if (image.verdict == Image_test::NO_ROOT)
      return Box_verdict::DONE;
    Node_analysis<NT>& closer = m_preconditioned.analysis();
    if (!closer.linear.contract_by_equations(closer.view, m_box) || !closer.linear.contract_by_preconditioned(m_box))
      return Box_verdict::DONE;
    if (closer.linear.has_inverse() && m_certification.certify(m_cell, node, closer.view, closer.linear, m_box, m_test))
      return Box_verdict::DONE;
    return contract(node) ? Box_verdict::AGAIN : Box_verdict::SPLIT;
  }

  // Shrinks the node to what the reduction left of it, when that is worth a pass.
  bool contract(Node& node)
  {
    Box_contraction::widen(m_box, [&](int j) { return finest_width(node, j) / width(node, j); });
    if (!Box_contraction::is_worth_a_pass(m_box, [](int) { return 0.0; }))
      return false;
    for (int j = 0; j < m_layout.dimension; ++j)
      m_widths[j] = width(node, j);
    node.restrict_to(m_layout, m_box, Box_contraction::least_gain);
    bool is_smaller = false;   // a few units of the last place may round back to where they were
    for (int j = 0; j < m_layout.dimension; ++j)
      is_smaller = is_smaller || width(node, j) < m_widths[j];
    return is_smaller;
  }

  // Below this width an axis counts as decided.
  double least_width(const Node& node, int j) const
  {
    const double lower = std::abs(CGAL::to_double(node.lower[j])), upper = std::abs(CGAL::to_double(node.upper[j]));
    return m_tolerance * (std::max)({1.0, lower, upper});
  }

  // While another axis is wider than the tolerance, an axis may become as thin as this: near y = x^2 a box of width h
  // needs the height h^2. Doubles end earlier: a box has to stay many units of its last place wide to shrink at all,
  // and beside zero far from underflow.
  double finest_width(const Node& node, int j) const
  {
    const double finest = m_tolerance * least_width(node, j);
    if constexpr (std::is_same_v<Coordinate, double>)
      return (std::max)({finest, 0x1p-250 * m_domain_widths[j],
                         0x1p-49 * (std::max)(std::abs(node.lower[j]), std::abs(node.upper[j]))});
    return finest;
  }

  // A look at the clock takes as long as some ten numbers of a node.
  static std::size_t poll_interval(const System_layout& layout)
  {
    constexpr std::size_t many_numbers = 4096;
    return std::is_same_v<NT, double> ? (std::max)(std::size_t(1), many_numbers / (128 + layout.size)) : 1;
  }

  bool must_stop()
  {
    const bool is_asked = std::exchange(m_has_taken_long, false) || m_summary.nodes % m_poll_interval == 0;
    if (is_asked)
      m_control.add_progress(std::exchange(m_done, 0));
    return m_control.must_stop(is_asked);
  }

  // The best rated axis to split; -1 when there is none left. However it is rated, an axis is not split while another
  // is thousands of times wider: where two equations say nearly the same of some unknowns, the others would have to
  // wait for their last digit.
  int choose_axis(const Node& node)
  {
    constexpr double thinnest = 0x1p-12;
    const int n = m_layout.dimension;
    bool is_open = false;
    double widest = 0;
    for (int j = 0; j < n; ++j) {
      m_widths[j] = m_domain_widths[j] > 0 ? width(node, j) / m_domain_widths[j] : 0;
      is_open = is_open || (width(node, j) > least_width(node, j) && node.can_split(j));
      if (width(node, j) > finest_width(node, j) && node.can_split(j))
        widest = (std::max)(widest, m_widths[j]);
    }
    if (!is_open)
      return -1;
    m_splitter.rate(m_analysis.view, m_widths, m_rating);
    int best = -1;
    for (int j = 0; j < n; ++j)
      if (width(node, j) > finest_width(node, j) && node.can_split(j) && m_widths[j] >= thinnest * widest &&
          (best < 0 || m_rating[j] > m_rating[best] * (1 + 1e-9) ||
           (m_rating[j] >= m_rating[best] * (1 - 1e-9) && m_widths[j] > m_widths[best])))
        best = j;
    return best;
  }

  // Too many boxes that end at the tolerance are the mark of a continuum: it is then covered more and more coarsely.
  void leave_open(const Node& node)
  {
    m_open.push_back({node.lower, node.upper, Undecided_reason::TOLERANCE, m_cell});
    if ((m_open_before + m_open.size()) % m_options.coarsening_step == 0)
      m_tolerance *= m_coarsening;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SUBDIVISION_H
