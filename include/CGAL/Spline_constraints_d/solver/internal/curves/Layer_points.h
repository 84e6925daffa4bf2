// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_LAYER_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_LAYER_POINTS_H

#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_roots_on_line.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Face_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_analysis.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Depth_first_subdivision.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
All solutions of as many equalities as unknowns in a node, in doubles and from its coefficients alone, if it is certain
that all are simple and inside. That costs a small part of what the solver with exact functions does, and is for those
who go on with it where there is no answer.
*/
class Layer_points
{
public:
  using Box = std::vector<std::pair<double, double>>;

  // In the region there is no other one.
  struct Root
  {
    Box box, region;
  };

private:
  using Node = Box_node<double>;

  static constexpr double largest_width = 0x1p-36; // of a root's box, as a part of the greatest width of the node

  const System_layout& m_layout;
  Summary m_work;
  Node_analysis<double> m_analysis;
  Depth_first_subdivision<double> m_driver;
  Simple_roots_on_line m_on_line{largest_width};
  Local_box m_part; // of a node: what may hold roots
  std::vector<double> m_widths;
  double m_widest = 0;
  std::vector<Root> m_roots;
  std::size_t m_nodes = 0;
  bool m_is_certain = true;

public:
  // What the driver keeps for a node: nothing.
  struct State
  {};

  explicit Layer_points(const System_layout& layout)
    : m_layout(layout), m_analysis(layout, m_work), m_driver(layout), m_widths(layout.dimension)
  {}

  // The node is written here.
  Node& node() { return m_driver.root(); }

  // None if it is not certain.
  std::optional<std::vector<Root>> operator()()
  {
    Node& whole = node();
    m_roots.clear();
    m_nodes = 0;
    m_is_certain = true;
    if (m_layout.dimension == 1)
      return on_line(whole);
    Box domain;
    for (int j = 0; j < m_layout.dimension; ++j) {
      domain.emplace_back(whole.lower[j], whole.upper[j]);
      m_widths[j] = whole.upper[j] - whole.lower[j];
    }
    m_widest = *std::max_element(m_widths.begin(), m_widths.end());
    m_driver.run(*this, State(), 0);
    if (!m_is_certain || !are_inside(domain) || !are_apart())
      return std::nullopt;
    return std::move(m_roots);
  }

  // Shrinks a box that has one root, and around which the functions are written to the node.
  void refine(Box& box)
  {
    Node& around = node();
    m_analysis.look_at(around);
    m_analysis.linear.precondition(m_analysis.view);
    m_part.reset(m_layout.dimension);
    if (!m_analysis.linear.has_inverse() || !m_analysis.linear.contract_by_image(m_part))
      return;
    for (std::size_t j = 0; j < box.size(); ++j) {
      auto& [lower, upper] = box[j];
      lower = (std::max)(lower, place_below(around.lower[j], around.upper[j], m_part.lower[j] + 0.5));
      upper = (std::min)(upper, place_above(around.lower[j], around.upper[j], m_part.upper[j] + 0.5));
    }
  }

  // For the driver.

  bool goes_on(const Node&, const State&, int)
  {
    constexpr std::size_t most_nodes = 256;
    m_is_certain = m_is_certain && ++m_nodes <= most_nodes;
    return m_is_certain;
  }

  Box_verdict examine(Node& node, const State&, int)
  {
    const Image_test test = m_analysis.test_image(node);
    for (int f = 0; f < m_layout.equalities; ++f)
      if (m_analysis.view.lower(f) > 0 || m_analysis.view.upper(f) < 0)
        return Box_verdict::DONE;
    if (test.verdict == Image_test::NO_ROOT)
      return Box_verdict::DONE;
    if (test.verdict == Image_test::ONE_ROOT) {
      add_root(node);
      return Box_verdict::DONE;
    }
    m_part.reset(m_layout.dimension);
    if (!m_analysis.linear.contract_by_equations(m_analysis.view, m_part) ||
        !m_analysis.linear.contract_by_preconditioned(m_part))
      return Box_verdict::DONE;
    // in thinner nodes rounding errors matter, and there may be several roots beyond one another
    const auto share = [&](int j) {
      constexpr double thinnest = 0x1p-12;
      return (std::max)(Box_contraction::thinnest, thinnest * m_widths[j] / (node.upper[j] - node.lower[j]));
    };
    if (is_small(node) || !Box_contraction::is_worth_a_pass(m_part, share))
      return Box_verdict::SPLIT;
    Box_contraction::widen(m_part, share);
    node.restrict_to(m_layout, m_part, Box_contraction::least_gain);
    return Box_verdict::AGAIN;
  }

  std::optional<Box_split<State>> split(const Node& node, const State&, int)
  {
    constexpr double place = 125.0 / 256;
    int widest = 0;
    const auto width = [&](int j) { return (node.upper[j] - node.lower[j]) / m_widths[j]; };
    for (int j = 1; j < m_layout.dimension; ++j)
      if (width(j) > width(widest))
        widest = j;
    m_is_certain = !is_small(node) && node.can_split(widest);
    return m_is_certain ? std::optional(Box_split<State>{widest, place, State(), State()}) : std::nullopt;
  }

private:
  static Box box_of(const Node& node)
  {
    Box result;
    for (std::size_t j = 0; j < node.lower.size(); ++j)
      result.emplace_back(node.lower[j], node.upper[j]);
    return result;
  }

  std::optional<std::vector<Root>> on_line(Node& line)
  {
    const auto roots = m_on_line(line.coefficients(), line.errors()[0], line.lower[0], line.upper[0]);
    if (!roots)
      return std::nullopt;
    for (const auto& [box, region] : *roots)
      m_roots.push_back({{box}, {region}});
    return std::move(m_roots);
  }

  // The only one in a node, which is shrunk until rounding errors stop it.
  void add_root(Node& node)
  {
    constexpr int most_steps = 12;
    constexpr double least_gain = 0.5;
    Root root{{}, box_of(node)};
    for (int step = 0; step < most_steps; ++step) {
      m_part.reset(m_layout.dimension);
      if (!m_analysis.linear.has_inverse() || !m_analysis.linear.contract_by_image(m_part) ||
          !gains(m_part, least_gain))
        break;
      node.restrict_to(m_layout, m_part, least_gain);
      m_analysis.look_at(node);
      m_analysis.linear.precondition(m_analysis.view);
    }
    m_is_certain = m_is_certain && is_small(node);
    root.box = box_of(node);
    m_roots.push_back(std::move(root));
  }

  static bool gains(const Local_box& part, double least_gain)
  {
    for (int j = 0; j < part.dimension(); ++j)
      if (part.width(j) <= 1 - least_gain)
        return true;
    return false;
  }

  bool is_small(const Node& node) const
  {
    for (int j = 0; j < m_layout.dimension; ++j)
      if (!(node.upper[j] - node.lower[j] <= largest_width * m_widest))
        return false;
    return true;
  }

  bool are_inside(const Box& domain) const
  {
    return std::all_of(m_roots.begin(), m_roots.end(), [&](const Root& root) {
      for (std::size_t j = 0; j < domain.size(); ++j)
        if (!(domain[j].first < root.box[j].first && root.box[j].second < domain[j].second))
          return false;
      return true;
    });
  }

  // Not the same one, from nodes side by side.
  bool are_apart() const
  {
    for (std::size_t i = 0; i < m_roots.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        bool is_apart = false;
        for (std::size_t j = 0; j < m_roots[i].box.size(); ++j)
          is_apart = is_apart || m_roots[i].box[j].second < m_roots[k].box[j].first ||
              m_roots[k].box[j].second < m_roots[i].box[j].first;
        if (!is_apart)
          return false;
      }
    return true;
  }
};

// The same on a face of a node, whose place is the range of its unknown.
class Face_points
{
  const int m_axis;
  const Face_restriction m_face;
  Layer_points m_points;

public:
  Face_points(const System_layout& layout, int axis) : m_axis(axis), m_face(layout, axis), m_points(m_face.layout()) {}

  std::optional<std::vector<Layer_points::Root>> operator()(const Box_node<double>& node, bool is_upper)
  {
    m_face(node, is_upper, m_points.node());
    auto roots = m_points();
    const double value = is_upper ? node.upper[m_axis] : node.lower[m_axis];
    for (std::size_t i = 0; roots && i < roots->size(); ++i)
      for (Layer_points::Box* ranges : {&(*roots)[i].box, &(*roots)[i].region})
        ranges->insert(ranges->begin() + m_axis, {value, value});
    return roots;
  }

  // Shrinks the box of a root on the upper face of a small node that holds it.
  void refine(const Box_node<double>& around, Layer_points::Box& box)
  {
    m_face(around, true, m_points.node());
    const std::pair<double, double> place = box[static_cast<std::size_t>(m_axis)];
    box.erase(box.begin() + m_axis);
    m_points.refine(box);
    box.insert(box.begin() + m_axis, place);
  }
};

inline Exact_ranges exact_ranges(const Layer_points::Box& box)
{
  Exact_ranges result;
  result.reserve(box.size() + 1); // there may be another axis to come
  for (const auto& [lower, upper] : box)
    result.emplace_back(Exact_rational(lower), Exact_rational(upper));
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_LAYER_POINTS_H
