// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_CERTIFICATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_CERTIFICATION_H

#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Piecewise_certification.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Preconditioned_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_collection.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_analysis.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Proofs that a box around the roots of a node holds exactly one root, or none. The box may reach over the faces of the
node and of the domain; roots that are found go to the collection, each once. All errors count here, whatever the traits
say.
*/
template <class NT>
class Root_certification
{
  using Coordinate = typename Number_traits<NT>::Coordinate;
  using Node = Box_node<NT>;
  using Piecewise = Piecewise_certification<NT>;

  // The Newton operator on a box, and what it was computed from.
  struct Trial
  {
    Image_test result;
    Node_analysis<NT>* analysis;
    Node* node;
  };

  const System_layout& m_layout;
  Exact_source& m_source;
  Root_collection<NT>& m_roots;
  Preconditioned_system<NT>& m_preconditioned;
  Node_analysis<NT> m_analysis;
  Node m_node;   // the box on trial
  Piecewise m_piecewise;
  Certified_region<Coordinate> m_across;
  Local_box m_part;
  Coordinate_box<Coordinate> m_solutions;   // where those of a node lie
  // A root's region is narrowed until Newton's iteration with exact residuals, which cost more, needs only a few of
  // them.
  static constexpr double m_fine_contraction = 0.2;

public:
  Root_certification(const System_layout& layout, Exact_source& source, Preconditioned_system<NT>& preconditioned,
                     Root_collection<NT>& roots, Summary& summary)
    : m_layout(layout), m_source(source), m_roots(roots), m_preconditioned(preconditioned),
      m_analysis(layout, source, summary, true), m_piecewise(layout, source)
  {
    m_node.allocate(layout);
    m_across.lower.resize(layout.dimension);
    m_across.upper.resize(layout.dimension);
  }

  bool crosses_break(const Cell& cell, const std::vector<Coordinate>& lower, const std::vector<Coordinate>& upper) const
  {
    return m_piecewise.crosses_break(cell, lower, upper);
  }

  /*
  All roots of the node lie in the image of the Newton operator. When that is well inside the node's size, a box around
  it is tried: if the operator maps it into itself and contracts, it holds exactly one root; if image and box are
  disjoint, none. `part` is what the reduction left of the node. Returns whether all roots of the node are accounted
  for.
  */
  template <class Test>
  bool certify(const Cell& cell, const Node& node, Node_view& view, const Linear_enclosure& linear,
               const Local_box& part, Test& test)
  {
    const int n = m_layout.dimension;
    bool is_inside = true;
    double reach = 0;
    for (int j = 0; j < n; ++j) {
      const double r = linear.reach(j), c = linear.centre(j);
      reach = r > reach || std::isnan(r) ? r : reach;
      is_inside = is_inside && std::abs(c) + r < 0.5;
    }
    if (!(reach < 0.5))
      return false;
    if (is_known(node, linear, part))
      return true;
    if (!(reach < 0.2) && !(is_inside && test.has_at_most_one_solution(view, linear)))
      return false;

    m_node.copy_from(node);
    const Linear_enclosure* image = &linear;
    bool is_certified = false;
    double contraction = HUGE_VAL;
    for (int round = 0; round < 12; ++round) {
      surround(m_node, *image);
      if (reaches_over_break(cell, m_node))
        return is_certified ? keep_root(cell) : certify_across_break(cell);
      m_node.restrict_to(m_layout, m_part, 0);
      const Trial trial = test_image(cell, !is_certified);
      if (trial.result.verdict == Image_test::NO_ROOT)
        return true;
      image = &trial.analysis->linear;
      if (trial.result.verdict == Image_test::ONE_ROOT) {
        if (trial.result.contraction > 0.9 * contraction)
          break;   // rounding takes over: the region before serves better
        keep_region(trial, !is_certified);
        is_certified = true;
        contraction = trial.result.contraction;
        if (contraction < m_fine_contraction)
          break;
      }
      if (!(trial.result.reach < 0.4))
        break;
    }
    return is_certified && keep_root(cell);
  }

  /*
  The last attempt for a box at the tolerance: boxes of a few sizes around it, equally wide on all axes and with fresh
  coefficients. It finds the regular roots whose boxes became so thin on some axis that rounding hid the others.
  */
  bool certify_around(const Cell& cell, const Node& node)
  {
    for (const double margin : {0x1p-44, 0x1p-37, 0x1p-30, 0x1p-20, 0x1p-10}) {
      for (int j = 0; j < m_layout.dimension; ++j) {
        const double size = margin * (std::max)(1.0, std::abs(CGAL::to_double(node.lower[j])));
        m_node.lower[j] = below(node.lower[j], size);
        m_node.upper[j] = above(node.upper[j], size);
      }
      if (m_piecewise.crosses_break(cell, m_node.lower, m_node.upper)) {
        m_across.lower = m_node.lower;
        m_across.upper = m_node.upper;
        if (certify_across_break(cell))
          return true;
        continue;
      }
      m_analysis.rebuild(cell, m_node);
      const Trial trial = test_image(cell, true, true);
      if (trial.result.verdict == Image_test::NO_ROOT)
        return true;
      if (trial.result.verdict == Image_test::ONE_ROOT) {
        keep_region(trial, true);
        return keep_root(cell);
      }
    }
    return false;
  }

  // Two enclosures that meet while neither lies in the other's region: the same root when a box around both holds only
  // one.
  bool is_same_root(const Coordinate_box<Coordinate>& a, const Coordinate_box<Coordinate>& b)
  {
    for (int j = 0; j < m_layout.dimension; ++j) {
      const Coordinate lower = (std::min)(a[j].first, b[j].first), upper = (std::max)(a[j].second, b[j].second);
      const double margin = 8 * CGAL::to_double(Coordinate(upper - lower));
      m_across.lower[j] = below(lower, margin);
      m_across.upper[j] = above(upper, margin);
    }
    return test_across_break() == Piecewise::ONE_ROOT;
  }

private:
  // Tests the box on trial; when rounding hides the answer, or `is_last_attempt`, from the exact functions.
  Trial test_image(const Cell& cell, bool may_rebuild, bool is_last_attempt = false)
  {
    Trial trial{m_analysis.test_image(m_node), &m_analysis, &m_node};
    if (!may_rebuild || trial.result.verdict != Image_test::OPEN)
      return trial;
    if (m_analysis.is_blurred(m_node) && m_analysis.can_be_sharpened(m_node)) {
      m_analysis.rebuild(cell, m_node);
      trial.result = m_analysis.test_image(m_node);
    }
    if (trial.result.verdict == Image_test::OPEN && m_preconditioned.is_applicable() &&
        (is_last_attempt || m_analysis.is_blurred(m_node))) {
      trial.result = m_preconditioned.test_image(cell, m_node, m_analysis.linear);
      trial.analysis = &m_preconditioned.analysis();
      trial.node = &m_preconditioned.node();
    }
    return trial;
  }

  void keep_region(const Trial& trial, bool is_first)
  {
    m_roots.set_region(*trial.node, trial.analysis->source(), trial.analysis->linear, trial.result.contraction,
                       trial.analysis->bounds, is_first);
  }

  // Decides the box in m_across.
  typename Piecewise::Verdict test_across_break()
  {
    m_across.start.clear();
    const auto verdict = m_piecewise.certify(m_across);
    return verdict == Piecewise::OPEN && m_preconditioned.is_applicable() ? m_preconditioned.certify(m_across)
                                                                          : verdict;
  }

  // Refines the root of the last region. Where that region is much thinner on one axis than on another, or C is poor
  // there, others are certified around the enclosure, with fresh coefficients; or, where that would come near other
  // roots, around its middle.
  bool keep_root(const Cell& cell)
  {
    const Root_enclosure<Coordinate>* enclosure = &m_roots.refine();
    if (certify_at_kink(*enclosure))
      enclosure = &m_roots.refine();
    for (const double least_margin : {0x1p-24, 0x1p-34, 0x1p-44, 0x1p-44, 0x1p-44}) {
      const bool is_first = least_margin == 0x1p-24;
      if (enclosure->error <= 16 || (!is_first && !is_wide(*enclosure)))
        break;
      if (certify_close_to(cell, *enclosure, least_margin, false) ||
          (m_layout.equalities == m_layout.dimension && is_wide(*enclosure) &&
           certify_close_to(cell, *enclosure, least_margin, true)))
        enclosure = &m_roots.refine();
    }
    Coordinate_box<Coordinate> box = make_box(enclosure->lower, enclosure->upper);
    if (m_roots.is_known(box))
      return true;
    if (const auto* known = m_roots.root_that_meets(box))
      return is_same_root(known->enclosure, box);   // or else it may be another one: not to be counted
    m_roots.add(std::move(box));
    return true;
  }

  // At a kink, one inverse for all pieces may bring Newton's iteration no nearer to the root. That with the inverse of
  // the piece where it is does; a box around its limit, in the region, has the same root.
  bool certify_at_kink(const Root_enclosure<Coordinate>& enclosure)
  {
    constexpr int steps = 8;
    const int n = m_layout.dimension;
    const auto cell_of = [&](const std::vector<Coordinate>& point) -> Cell {
      return m_source.cell_of(std::span<const Coordinate>(point));
    };
    if (m_layout.equalities != n || !is_wide(enclosure) ||
        !m_piecewise.crosses_break(cell_of(enclosure.lower), enclosure.lower, enclosure.upper))
      return false;
    std::vector<Coordinate> point(n);
    const auto set_box = [&](double margin) {
      for (int j = 0; j < n; ++j) {
        const double size = margin * (std::max)(1.0, std::abs(CGAL::to_double(point[j])));
        m_node.lower[j] = below(point[j], size);
        m_node.upper[j] = above(point[j], size);
      }
    };
    for (int j = 0; j < n; ++j)
      point[j] = place_between(enclosure.lower[j], enclosure.upper[j], 0.5);
    for (int step = 0; step < steps; ++step) {
      set_box(0x1p-44);
      m_analysis.rebuild(cell_of(point), m_node);
      m_analysis.test_image(m_node);
      for (int j = 0; j < n; ++j) {
        if (!m_analysis.linear.has_inverse() || !std::isfinite(m_analysis.linear.centre(j)))
          return false;
        point[j] += m_analysis.linear.centre(j) * CGAL::to_double(Coordinate(m_node.upper[j] - m_node.lower[j]));
        point[j] = (std::min)((std::max)(point[j], enclosure.lower[j]), enclosure.upper[j]);
      }
    }
    for (const double margin : {0x1p-34, 0x1p-44}) {
      set_box(margin);
      m_roots.clip_to_region(m_node.lower, m_node.upper);
      if (certify_box(cell_of(point), true))
        return true;
    }
    return false;
  }

  // Certifies a box around an enclosure, or around its middle; this one has the same root, since it lies within the
  // region.
  bool certify_close_to(const Cell& cell, const Root_enclosure<Coordinate>& enclosure, double least_margin,
                        bool is_around_middle)
  {
    for (int j = 0; j < m_layout.dimension; ++j) {
      const double lower = CGAL::to_double(enclosure.lower[j]), upper = CGAL::to_double(enclosure.upper[j]);
      const double size = least_margin * (std::max)(1.0, std::abs(lower));
      const double margin =
          is_around_middle ? (std::min)(size - 0.5 * (upper - lower), 0.0) : (std::max)(0.25 * (upper - lower), size);
      m_node.lower[j] = below(enclosure.lower[j], margin);
      m_node.upper[j] = above(enclosure.upper[j], margin);
    }
    if (is_around_middle)
      m_roots.clip_to_region(m_node.lower, m_node.upper);
    return certify_box(cell, is_around_middle);
  }

  // The box on trial, whose root is that of the region, if it has one.
  bool certify_box(const Cell& cell, bool must_not_grow)
  {
    if (m_piecewise.crosses_break(cell, m_node.lower, m_node.upper)) {
      m_across.lower = m_node.lower;
      m_across.upper = m_node.upper;
      if (must_not_grow || test_across_break() != Piecewise::ONE_ROOT)
        return false;
      m_roots.set_region(m_across, false);
      return true;
    }
    m_analysis.rebuild(cell, m_node);
    const Trial trial = test_image(cell, true, true);
    if (trial.result.verdict != Image_test::ONE_ROOT)
      return false;
    keep_region(trial, false);
    return true;
  }

  // Some range is wide beside what coordinates could tell apart, zero not taken for a place where they are endlessly
  // fine.
  static bool is_wide(const Root_enclosure<Coordinate>& enclosure)
  {
    for (std::size_t j = 0; j < enclosure.lower.size(); ++j) {
      const double lower = CGAL::to_double(enclosure.lower[j]), upper = CGAL::to_double(enclosure.upper[j]);
      if (upper - lower > 0x1p-46 * (std::max)(1.0, std::abs(lower)))
        return true;
    }
    return false;
  }

  // The part of the node, in m_part, reaches into another cell; its box is left in m_across.
  bool reaches_over_break(const Cell& cell, const Node& node)
  {
    if (!m_source.has_breaks())
      return false;
    for (int j = 0; j < m_layout.dimension; ++j) {
      m_across.lower[j] = place_below(node.lower[j], node.upper[j], m_part.lower[j] + 0.5);
      m_across.upper[j] = place_above(node.lower[j], node.upper[j], m_part.upper[j] + 0.5);
    }
    return m_piecewise.crosses_break(cell, m_across.lower, m_across.upper);
  }

  bool certify_across_break(const Cell& cell)
  {
    switch (test_across_break()) {
    case Piecewise::NO_ROOT:
      return true;
    case Piecewise::ONE_ROOT:
      m_roots.set_region(m_across, true);
      return keep_root(cell);
    default:
      return false;
    }
  }

  // A box around the image with room to spare: half as wide again, not too thin, and many units of the last place wide.
  void surround(const Node& node, const Linear_enclosure& image)
  {
    m_part.reset(m_layout.dimension);
    for (int j = 0; j < m_layout.dimension; ++j) {
      double half_width = 1.5 * image.reach(j) + 0.01;
      if constexpr (std::is_same_v<Coordinate, double>)
        half_width = (std::max)(half_width,
                                0x1p-40 * (std::max)(std::abs(node.lower[j]), std::abs(node.upper[j])) /
                                    (node.upper[j] - node.lower[j]));
      m_part.lower[j] = image.centre(j) - half_width;
      m_part.upper[j] = image.centre(j) + half_width;
    }
  }

  // All roots of the node lie in a region whose only root was found before.
  bool is_known(const Node& node, const Linear_enclosure& linear, const Local_box& part)
  {
    m_solutions.resize(m_layout.dimension);
    for (int j = 0; j < m_layout.dimension; ++j) {
      const double centre = linear.centre(j), reach = linear.reach(j);
      const double lo = (std::max)(part.lower[j], centre - reach), hi = (std::min)(part.upper[j], centre + reach);
      m_solutions[j].first = lo == -0.5 ? node.lower[j] : place_below(node.lower[j], node.upper[j], lo + 0.5);
      m_solutions[j].second = hi == 0.5 ? node.upper[j] : place_above(node.lower[j], node.upper[j], hi + 0.5);
    }
    return m_roots.is_covered(m_solutions);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_ROOT_CERTIFICATION_H
