// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_ANALYSIS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_ANALYSIS_H

#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/termination_tests.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What the Newton operator says of a box.
struct Image_test
{
  enum Verdict { NO_ROOT, ONE_ROOT, OPEN } verdict;
  double contraction, reach;
};

/*
A node and what is known of it: its bounds, its linear rows and how far rounding has blurred them.
*/
template <class NT>
class Node_analysis
{
  using Coordinate = typename Number_traits<NT>::Coordinate;
  using Node = Box_node<NT>;

  const System_layout& m_layout;
  Exact_source* m_source; // null for nodes that cannot be built anew
  Summary& m_summary;
  Lowered_node<NT> m_lowered;
  std::vector<double> m_error_sum, m_variation, m_no_errors;
  bool m_tracks_rounding;

public:
  Node_view view;
  Linear_enclosure linear;
  std::vector<double> bounds;   // on |I - C J|, of the last test_image()

  // Without `tracks_rounding` the error bounds are left out of everything that the view says.
  Node_analysis(const System_layout& layout, Exact_source& source, Summary& summary, bool tracks_rounding)
    : m_layout(layout), m_source(&source), m_summary(summary), m_no_errors(layout.errors, 0.0),
      m_tracks_rounding(tracks_rounding), view(layout), linear(layout.dimension, layout.equalities)
  {}

  // For nodes that are made from others alone.
  Node_analysis(const System_layout& layout, Summary& summary)
    : m_layout(layout), m_source(nullptr), m_summary(summary), m_no_errors(layout.errors, 0.0), m_tracks_rounding(true),
      view(layout), linear(layout.dimension, layout.equalities)
  {}

  // Looks at a node; its linear rows are formed on demand.
  void look_at(Node& node)
  {
    m_lowered.lower(m_layout, node, view);
    if (!m_tracks_rounding)
      view.reset(view.coefficients(), m_no_errors.data());
    if constexpr (std::is_same_v<NT, double>)
      for (std::size_t e = 0; e < m_layout.errors; ++e)
        node.sizes()[e] = (std::max)(std::abs(view.block_lower(e)), std::abs(view.block_upper(e)));
  }

  // Applies the Newton operator to the box of a node: mapped into itself by a contraction, it holds exactly one root of
  // C f; image and box disjoint, none.
  Image_test test_image(Node& node)
  {
    look_at(node);
    linear.precondition(view);
    if (!linear.has_inverse())
      return {Image_test::OPEN, HUGE_VAL, HUGE_VAL};
    bool is_mapped_inside = true;
    double reach = 0;
    for (int j = 0; j < m_layout.dimension; ++j) {
      if (std::abs(linear.centre(j)) - linear.reach(j) > 0.5)
        return {Image_test::NO_ROOT, HUGE_VAL, HUGE_VAL};
      is_mapped_inside = is_mapped_inside && std::abs(linear.centre(j)) + linear.reach(j) < 0.5;
      reach = linear.reach(j) > reach || std::isnan(linear.reach(j)) ? linear.reach(j) : reach;
    }
    constexpr double largest_contraction = 1 - 0x1p-8;   // beyond, the region would be of no use for the refinement
    const double contraction = is_mapped_inside ? contraction_bound(view, linear, bounds) : HUGE_VAL;
    return {contraction <= largest_contraction ? Image_test::ONE_ROOT : Image_test::OPEN, contraction, reach};
  }

  // The rounding error, that of the analysis included, has become visible beside what the equations leave undecided.
  bool is_blurred(const Node& node)
  {
    m_error_sum.assign(m_layout.functions, 0);
    visit_errors(node, [&](int f, double error) {
      m_error_sum[f] += error;
      return false;
    });
    return linear.is_blurred_by(m_error_sum);
  }

  Exact_source& source() { return *m_source; }

  // The error of some equality is well above that of a fresh start, where coefficients are rounded once and, near a
  // root, as small as the function varies.
  bool can_be_sharpened(const Node& node)
  {
    m_variation.assign(m_layout.functions, 0);
    for (const Block& block : m_layout.blocks)
      for (std::size_t m = 0; m < block.functions.size(); ++m) {
        const std::size_t entry = block.first_error + m;
        m_variation[block.functions[m]] += view.block_upper(entry) - view.block_lower(entry);
      }
    return visit_errors(
        node, [&](int f, double error) { return error > 8 * analysis_error * m_variation[f] && error > 0x1p-900; });
  }

  // Starts again from the exact functions on the box of the node. \pre there are some
  void rebuild(const Cell& cell, Node& node)
  {
    const auto start = std::chrono::steady_clock::now();
    m_source->bernstein_coefficients(cell, std::span<const Coordinate>(node.lower),
                                     std::span<const Coordinate>(node.upper), node.coefficients().data(),
                                     node.errors().data(), node.scale);
    for (std::size_t e = 0; e < m_layout.errors; ++e)
      node.sizes()[e] = node.errors()[e] * 0x1p50;
    ++m_summary.restarts;
    m_summary.rebuild_seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

private:
  // Calls visit(function, error) with the error of every block, that of the analysis included, until it returns true.
  template <class Visitor>
  bool visit_errors(const Node& node, const Visitor& visit)
  {
    const double* errors = m_lowered.errors(node);
    for (const Block& block : m_layout.blocks)
      for (std::size_t m = 0; m < block.functions.size() && block.functions[m] < m_layout.equalities; ++m) {
        const std::size_t entry = block.first_error + m;
        const double size = (std::max)(std::abs(view.block_lower(entry)), std::abs(view.block_upper(entry)));
        if (visit(block.functions[m], errors[entry] + analysis_error * size))
          return true;
      }
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_ANALYSIS_H
