// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SUBDIVISION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SUBDIVISION_H

#include <CGAL/Spline_constraints_d/solver/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Node_analysis.h>
#include <CGAL/Spline_constraints_d/solver/Piecewise_certification.h>
#include <CGAL/Spline_constraints_d/solver/Root_collection.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/termination_tests.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <deque>
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

/*
The depth-first subdivision of the domain. A box ends empty, by a proof; or with all its roots inside regions that hold exactly one root each; or open.
*/
template <class Traits, class Visitor>
class Subdivision
{
  using NT = typename Traits::Number_type;
  using Coordinate = typename Number_traits<NT>::Coordinate;
  using Node = Box_node<NT>;

  enum class Verdict { DONE, CONTRACTED, REBUILT, SPLIT };

  const Constraint_system_d& m_system;
  const System_layout& m_layout;
  Exact_source& m_source;
  const Solver_options& m_options;
  Visitor& m_visitor;
  Root_collection<NT>& m_roots;
  Summary& m_summary;

  typename Traits::Termination_test m_test;
  typename Traits::Reduction m_reduction;
  typename Traits::Splitter m_splitter;

  Node_analysis<NT> m_analysis, m_trial_analysis;   // a solution is certified with all errors, whatever the traits say
  Node m_trial;
  Piecewise_certification<NT> m_piecewise;
  Certified_region<Coordinate> m_across;
  Local_box m_box, m_part;
  std::deque<Node> m_nodes;   // one per level: references stay valid while it grows
  std::vector<Open_box<Coordinate>> m_open;
  std::vector<Relation> m_relations;
  std::vector<double> m_rating, m_widths, m_domain_widths;
  std::vector<Coordinate> m_corner[2];
  Cell m_cell;
  // A root's region is narrowed until Newton's iteration with exact residuals, which cost more, needs about two of them.
  static constexpr double m_fine_contraction = 1e-3;
  double m_tolerance, m_done = 0;
  Undecided_reason m_stop = Undecided_reason::NONE;
  std::chrono::steady_clock::time_point m_deadline, m_last_report;

public:
  Subdivision(const Constraint_system_d& system, const System_layout& layout, Exact_source& source, const Solver_options& options,
              Visitor& visitor, Root_collection<NT>& roots, Summary& summary)
    : m_system(system), m_layout(layout), m_source(source), m_options(options), m_visitor(visitor), m_roots(roots),
      m_summary(summary),
      m_analysis(layout, source, summary, Traits::tracks_rounding), m_trial_analysis(layout, source, summary, true),
      m_piecewise(layout, source), m_tolerance(options.tolerance)
  {
    m_trial.allocate(layout);
    m_across.lower.resize(layout.dimension);
    m_across.upper.resize(layout.dimension);
    for (const auto& inequality : system.inequalities())
      m_relations.push_back(inequality.relation);
    m_last_report = std::chrono::steady_clock::now();
    if (options.time_limit > 0)
      m_deadline = m_last_report + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                     std::chrono::duration<double>((std::min)(options.time_limit, 1e9)));
  }

  // Walks over a box in one cell, which is a `share` of the domain.
  void run(const Cell& cell, const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper, double share)
  {
    m_cell = cell;
    Node& root = level(0);
    root.lower = lower;
    root.upper = upper;
    m_domain_widths.resize(m_layout.dimension);
    for (int j = 0; j < m_layout.dimension; ++j)
      m_domain_widths[j] = width(root, j);
    m_analysis.rebuild(m_cell, root);
    subdivide(0, 0, share);
  }

  std::vector<Open_box<Coordinate>>& open_boxes() { return m_open; }

  /*
  Looks again, with a finer tolerance, at the open boxes that `holds_solution(box)` does not know to hold one; those that turn out empty are dropped. Beside a root that is not regular
  some boxes end at the tolerance just before they would be excluded.
  */
  template <class Predicate>
  void resume(const Predicate& holds_solution)
  {
    if (m_open.size() > 64 || m_stop != Undecided_reason::NONE)
      return;
    const double tolerance = std::exchange(m_tolerance, m_tolerance / 4096);
    std::vector<Open_box<Coordinate>> boxes, kept;
    boxes.swap(m_open);
    for (Open_box<Coordinate>& box : boxes) {
      const bool is_tried = box.reason == Undecided_reason::TOLERANCE &&
                            !m_piecewise.crosses_break(box.cell, box.lower, box.upper) && !holds_solution(box);
      if (is_tried)
        run(box.cell, box.lower, box.upper, 0);
      if (!is_tried || !m_open.empty())
        kept.push_back(std::move(box));
      m_open.clear();
    }
    m_open = std::move(kept);
    m_tolerance = tolerance;
  }

private:
  Node& level(std::size_t index)
  {
    while (m_nodes.size() <= index)
      m_nodes.emplace_back().allocate(m_layout);
    return m_nodes[index];
  }

  static double width(const Node& node, int j) { return CGAL::to_double(Coordinate(node.upper[j] - node.lower[j])); }

  // The lower part of a split stays in its place, the upper part goes one level up and is finished first.
  void subdivide(std::size_t index, int depth, double share)
  {
    Node& node = level(index);
    for (bool is_fresh = false;;) {
      ++m_summary.nodes;
      m_summary.depth = (std::max)(m_summary.depth, depth);
      if (must_stop()) {
        leave_open(node, m_stop);
        return;
      }
      const Verdict verdict = examine(node, is_fresh);
      is_fresh = verdict == Verdict::REBUILT;
      switch (verdict) {
      case Verdict::DONE:
        m_done += share;
        return;
      case Verdict::CONTRACTED:
      case Verdict::REBUILT:
        break;
      case Verdict::SPLIT:
        const int axis = choose_axis(node);
        if (axis < 0) {
          if (!certify_around(node))
            leave_open(node, Undecided_reason::TOLERANCE);
          m_done += share;
          return;
        }
        // Off the middle the first time an axis is cut: roots like to sit on the planes of symmetry.
        const double t = m_widths[axis] > 0.9 ? 125.0 / 256 : 0.5;
        node.split(m_layout, axis, t, level(index + 1));
        share /= 2;
        subdivide(index + 1, ++depth, share);
      }
    }
  }

  // `is_fresh`: the node was rebuilt since it last shrank, and is not rebuilt again.
  Verdict examine(Node& node, bool is_fresh)
  {
    m_analysis.look_at(node);
    if (is_excluded(m_analysis.view))
      return Verdict::DONE;
    m_analysis.linear.precondition(m_analysis.view);
    m_box.reset(m_layout.dimension);
    if (!m_reduction.contract(m_analysis.view, m_analysis.linear, m_box))
      return Verdict::DONE;
    if (m_analysis.linear.has_inverse() && certify(node))
      return Verdict::DONE;
    if (contract(node))
      return Verdict::CONTRACTED;
    if (!is_fresh && m_analysis.is_blurred(node)) {
      m_analysis.rebuild(m_cell, node);
      return Verdict::REBUILT;
    }
    return Verdict::SPLIT;
  }

  // No control point of an equality, or of an inequality, reaches the values that would satisfy it.
  bool is_excluded(Node_view& view)
  {
    for (int f = 0; f < m_layout.equalities; ++f)
      if (view.lower(f) > 0 || view.upper(f) < 0)
        return true;
    for (std::size_t g = 0; g < m_relations.size(); ++g)
      if (is_certainly_violated(m_relations[g], view.lower(m_layout.equalities + g), view.upper(m_layout.equalities + g)))
        return true;
    return false;
  }

  /*
  All roots of the node lie in the image of the Newton operator. When that is well inside the node's size, a box around it (which may reach over the faces of
  the node, and of the domain) is tried: if the operator maps it into itself and contracts, it holds exactly one root; if image and box are disjoint, none.
  Returns whether all roots of the node are accounted for.
  */
  bool certify(Node& node)
  {
    const int n = m_layout.dimension;
    bool is_inside = true;
    double reach = 0;
    for (int j = 0; j < n; ++j) {
      const double r = m_analysis.linear.reach(j), c = m_analysis.linear.centre(j);
      reach = r > reach || std::isnan(r) ? r : reach;
      is_inside = is_inside && std::abs(c) + r < 0.5;
    }
    if (!(reach < 0.5))
      return false;
    if (is_known(node))
      return true;
    if (!(reach < 0.25) && !(is_inside && m_test.has_at_most_one_solution(m_analysis.view, m_analysis.linear)))
      return false;

    m_trial.copy_from(node);
    const Linear_enclosure* image = &m_analysis.linear;
    bool is_certified = false;
    double contraction = HUGE_VAL;
    for (int round = 0; round < 12; ++round) {
      surround(m_trial, *image, m_part);
      if (reaches_over_break(m_trial))
        return is_certified ? keep_root() : certify_across_break();
      m_trial.restrict_to(m_layout, m_part, 0);
      Image_test result = m_trial_analysis.test_image(m_trial);
      if (result.verdict == Image_test::OPEN && !is_certified && m_trial_analysis.can_be_sharpened(m_trial)) {
        m_trial_analysis.rebuild(m_cell, m_trial);
        result = m_trial_analysis.test_image(m_trial);
      }
      if (result.verdict == Image_test::NO_ROOT)
        return true;
      image = &m_trial_analysis.linear;
      if (result.verdict == Image_test::ONE_ROOT) {
        if (result.contraction > 0.9 * contraction)
          break;   // rounding takes over: the region before serves better
        m_roots.set_region(m_trial, *image, result.contraction, m_trial_analysis.bounds, !is_certified);
        is_certified = true;
        contraction = result.contraction;
        if (contraction < m_fine_contraction)
          break;
      }
      if (!(result.reach < 0.4))
        break;
    }
    return is_certified && keep_root();
  }

  // Refines the root of the last region. Where that region is much thinner on one axis than on another, or C is poor there, others are certified
  // around the enclosure, with fresh coefficients.
  bool keep_root()
  {
    Root_enclosure<Coordinate> enclosure = m_roots.refine();
    for (int attempt = 0; attempt < 6 && enclosure.error > 16; ++attempt) {
      for (int j = 0; j < m_layout.dimension; ++j) {
        const double lower = CGAL::to_double(enclosure.lower[j]), upper = CGAL::to_double(enclosure.upper[j]);
        const double margin = (std::max)(0.25 * (upper - lower), 0x1p-24 * (std::max)(1.0, std::abs(lower)));
        m_trial.lower[j] = below(enclosure.lower[j], margin);
        m_trial.upper[j] = above(enclosure.upper[j], margin);
      }
      if (m_piecewise.crosses_break(m_cell, m_trial.lower, m_trial.upper)) {
        m_across.lower = m_trial.lower;
        m_across.upper = m_trial.upper;
        m_across.start.clear();
        if (m_piecewise.certify(m_across) != Piecewise_certification<NT>::ONE_ROOT)
          break;
        m_roots.set_region(m_across, false);
      } else {
        m_trial_analysis.rebuild(m_cell, m_trial);
        const Image_test result = m_trial_analysis.test_image(m_trial);
        if (result.verdict != Image_test::ONE_ROOT)
          break;
        m_roots.set_region(m_trial, m_trial_analysis.linear, result.contraction, m_trial_analysis.bounds, false);
      }
      enclosure = m_roots.refine();
    }
    if (!meets_same_root(enclosure))
      m_roots.add(std::move(enclosure));
    return true;
  }

  // Two enclosures that meet while neither lies in the other's region: the same root when a box around both holds only one.
  bool meets_same_root(const Root_enclosure<Coordinate>& enclosure)
  {
    const auto* known = m_roots.root_that_meets(enclosure);
    if (known == nullptr || m_roots.is_known(enclosure))
      return false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const Coordinate lower = (std::min)(known->enclosure.lower[j], enclosure.lower[j]);
      const Coordinate upper = (std::max)(known->enclosure.upper[j], enclosure.upper[j]);
      const double margin = 8 * CGAL::to_double(Coordinate(upper - lower));
      m_across.lower[j] = below(lower, margin);
      m_across.upper[j] = above(upper, margin);
    }
    m_across.start.clear();
    return m_piecewise.certify(m_across) == Piecewise_certification<NT>::ONE_ROOT;
  }

  // The part of the node, in m_part, reaches into another cell; its box is left in m_across.
  bool reaches_over_break(const Node& node)
  {
    if (!m_source.has_breaks())
      return false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      m_across.lower[j] = place_below(node.lower[j], node.upper[j], m_part.lower[j] + 0.5);
      m_across.upper[j] = place_above(node.lower[j], node.upper[j], m_part.upper[j] + 0.5);
    }
    return m_piecewise.crosses_break(m_cell, m_across.lower, m_across.upper);
  }

  bool certify_across_break()
  {
    switch (m_piecewise.certify(m_across)) {
    case Piecewise_certification<NT>::NO_ROOT:
      return true;
    case Piecewise_certification<NT>::ONE_ROOT:
      m_roots.set_region(m_across, true);
      return keep_root();
    default:
      return false;
    }
  }

  /*
  The last attempt for a box at the tolerance: boxes of a few sizes around it, equally wide on all axes and with fresh coefficients. It finds the regular roots whose boxes became
  so thin on some axis that rounding hid the others. Not for the many boxes of a continuum.
  */
  bool certify_around(const Node& node)
  {
    if (m_open.size() > 64)
      return false;
    for (const double margin : {0x1p-44, 0x1p-37, 0x1p-30, 0x1p-20, 0x1p-10}) {
      for (int j = 0; j < m_layout.dimension; ++j) {
        const double size = margin * (std::max)(1.0, std::abs(CGAL::to_double(node.lower[j])));
        m_trial.lower[j] = below(node.lower[j], size);
        m_trial.upper[j] = above(node.upper[j], size);
      }
      if (m_piecewise.crosses_break(m_cell, m_trial.lower, m_trial.upper)) {
        m_across = {.lower = m_trial.lower, .upper = m_trial.upper, .inverse = {}, .scale = {}, .bounds = {}, .start = {}};
        if (certify_across_break())
          return true;
        continue;
      }
      m_trial_analysis.rebuild(m_cell, m_trial);
      const Image_test result = m_trial_analysis.test_image(m_trial);
      if (result.verdict == Image_test::NO_ROOT)
        return true;
      if (result.verdict == Image_test::ONE_ROOT) {
        m_roots.set_region(m_trial, m_trial_analysis.linear, result.contraction, m_trial_analysis.bounds, true);
        return keep_root();
      }
    }
    return false;
  }

  // A box around the image with room to spare: twice its size, not too thin, and many units of the last place wide.
  void surround(const Node& node, const Linear_enclosure& image, Local_box& part) const
  {
    part.reset(m_layout.dimension);
    for (int j = 0; j < m_layout.dimension; ++j) {
      double half_width = 2 * image.reach(j) + 0.01;
      if constexpr (std::is_same_v<Coordinate, double>)
        half_width = (std::max)(half_width, 0x1p-40 * (std::max)(std::abs(node.lower[j]), std::abs(node.upper[j])) / width(node, j));
      part.lower[j] = image.centre(j) - half_width;
      part.upper[j] = image.centre(j) + half_width;
    }
  }

  // All roots of the node lie in a region whose only root was found before.
  bool is_known(const Node& node)
  {
    for (auto& corner : m_corner)
      corner.resize(m_layout.dimension);
    for (int j = 0; j < m_layout.dimension; ++j) {
      const double centre = m_analysis.linear.centre(j), reach = m_analysis.linear.reach(j);
      const double lo = (std::max)(m_box.lower[j], centre - reach), hi = (std::min)(m_box.upper[j], centre + reach);
      m_corner[0][j] = lo == -0.5 ? node.lower[j] : place_below(node.lower[j], node.upper[j], lo + 0.5);
      m_corner[1][j] = hi == 0.5 ? node.upper[j] : place_above(node.lower[j], node.upper[j], hi + 0.5);
    }
    return m_roots.is_covered(m_corner[0], m_corner[1]);
  }

  // Shrinks the node to what the reduction left of it, when that is worth a pass. No axis becomes a small part of its width at once: one that collapses would
  // hide the others.
  bool contract(Node& node)
  {
    constexpr double least_gain = 0.1, thinnest = 0x1p-10;
    double volume = 1;
    for (int j = 0; j < m_layout.dimension; ++j) {
      const double least = (std::max)(thinnest, finest_width(node, j) / width(node, j));
      if (m_box.width(j) < least) {
        const double centre = 0.5 * (m_box.lower[j] + m_box.upper[j]);
        m_box.lower[j] = (std::max)(-0.5, centre - 0.5 * least);
        m_box.upper[j] = (std::min)(0.5, centre + 0.5 * least);
      }
      if (m_box.width(j) <= 1 - least_gain)
        volume *= m_box.width(j);
    }
    if (volume > 0.7)
      return false;
    node.restrict_to(m_layout, m_box, least_gain);
    return true;
  }

  // Below this width an axis counts as decided.
  double least_width(const Node& node, int j) const
  {
    const double lower = std::abs(CGAL::to_double(node.lower[j])), upper = std::abs(CGAL::to_double(node.upper[j]));
    return m_tolerance * (std::max)({1.0, lower, upper});
  }

  // While another axis is wider than the tolerance, an axis may become as thin as this: near y = x^2 a box of width h needs the height h^2.
  // Doubles end earlier: a box has to stay many units of its last place wide to shrink at all, and beside zero far from underflow.
  double finest_width(const Node& node, int j) const
  {
    const double finest = (std::max)(m_tolerance * least_width(node, j), 0x1p-250 * m_domain_widths[j]);
    if constexpr (std::is_same_v<Coordinate, double>)
      return (std::max)(finest, 0x1p-46 * (std::max)(std::abs(node.lower[j]), std::abs(node.upper[j])));
    return finest;
  }

  // The best rated axis to split; -1 when there is none left.
  int choose_axis(const Node& node)
  {
    const int n = m_layout.dimension;
    m_widths.resize(n);
    bool is_open = false;
    for (int j = 0; j < n; ++j) {
      m_widths[j] = m_domain_widths[j] > 0 ? width(node, j) / m_domain_widths[j] : 0;
      is_open = is_open || (width(node, j) > least_width(node, j) && node.can_split(j));
    }
    if (!is_open)
      return -1;
    m_splitter.rate(m_analysis.view, m_widths, m_rating);
    int best = -1;
    for (int j = 0; j < n; ++j)
      if (width(node, j) > finest_width(node, j) && node.can_split(j) &&
          (best < 0 || m_rating[j] > m_rating[best] * (1 + 1e-9) ||
           (m_rating[j] >= m_rating[best] * (1 - 1e-9) && m_widths[j] > m_widths[best])))
        best = j;
    return best;
  }

  // Too many boxes that end at the tolerance are the mark of a continuum: it is then covered more and more coarsely.
  void leave_open(const Node& node, Undecided_reason reason)
  {
    m_open.push_back({node.lower, node.upper, reason, m_cell});
    if (reason == Undecided_reason::TOLERANCE && m_open.size() % m_options.coarsening_step == 0)
      m_tolerance *= 32;
  }

  bool must_stop()
  {
    if (m_stop != Undecided_reason::NONE)
      return true;
    if (m_options.node_limit > 0 && m_summary.nodes > m_options.node_limit)
      m_stop = Undecided_reason::NODES;
    else if (m_summary.nodes % (std::is_same_v<NT, double> ? 32 : 1) == 0) {
      const auto now = std::chrono::steady_clock::now();
      if (m_options.time_limit > 0 && now >= m_deadline)
        m_stop = Undecided_reason::TIME;
      else if (m_visitor.stop())
        m_stop = Undecided_reason::STOPPED;
      else if (now - m_last_report > std::chrono::milliseconds(50)) {
        m_last_report = now;
        m_visitor.on_progress(m_done);
      }
    }
    return m_stop != Undecided_reason::NONE;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SUBDIVISION_H
