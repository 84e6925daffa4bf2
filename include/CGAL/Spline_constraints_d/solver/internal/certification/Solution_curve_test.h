// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_SOLUTION_CURVE_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_SOLUTION_CURVE_TEST_H

#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Graph_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_refinement.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Box_node.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_analysis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Tells whether a node looks like a piece of a curve of solutions of at least as many equalities as unknowns, f = 0.

With g = T f of the graph test, where its first n - 1 rows are zero on a graph over one unknown, it is proved that the
solutions in the node have at most dimension one. That the other rows are zero all along the curve is not proved but
tried at a few points.

The test is made on a box that is not thinner on any axis than a quarter of the widest one: in a thin box the unknowns
of short ranges look as if they did not matter.
*/
template <class NT>
class Solution_curve_test
{
  using Coordinate = typename Number_traits<NT>::Coordinate;

  const System_layout& m_layout;
  Exact_source& m_source;
  Node_analysis<NT> m_analysis;
  Box_node<NT> m_node;
  Graph_test m_graph;
  std::vector<double> m_place, m_value, m_spread;
  std::vector<Exact_source::Value> m_values;
  double m_resolution = 0;   // of places in the node
  double m_steps = 0;        // no farther is the curve, in units of a step to it
  enum class Rest { ZERO, NOT_ZERO, UNKNOWN };
  static constexpr double m_slack = 1e-9;

public:
  Solution_curve_test(const System_layout& layout, Exact_source& source, Summary& summary, bool tracks_rounding)
    : m_layout(layout), m_source(source), m_analysis(layout, source, summary, tracks_rounding),
      m_graph(layout.dimension, layout.equalities)
  {
    m_node.allocate(layout);
  }

  // Whether the Jacobian may be singular in a node, as it is along a curve of solutions: cheap, and no for most nodes
  // beside regular roots.
  bool may_be_singular(Node_view& view)
  {
    if (!m_graph.eliminate(view))
      return true;
    const int free = m_graph.parameter();
    for (int i = n() - 1; i < m(); ++i) {
      // of what is left of the row, where the other rows may be a few times their distance from the identity away
      double reach = 0;
      for (int j = 0; j < n(); ++j)
        for (int l = 0; l < m(); ++l)
          reach += std::abs(m_graph.transform(i, l)) * m_graph.radius(l, j) *
              (j == free ? 1 : 2 * std::abs(m_graph.derivative(m_graph.row_of(j), free)));
      if (std::abs(m_graph.derivative(i, free)) > reach)
        return false;
    }
    return true;
  }

  // `view`: of the node. It is only for a thin node that the functions are built on another box.
  bool operator()(const Cell& cell, const Box_node<NT>& node, Node_view& view, const std::vector<double>& domain_widths)
  {
    const bool is_thin = surround(node, domain_widths);
    if (is_thin) {
      m_analysis.rebuild(cell, m_node);
      m_analysis.look_at(m_node);
    } else
      m_node.scale = node.scale;
    return m_graph.eliminate(is_thin ? m_analysis.view : view) && m_graph.is_graph() && are_zero_along_graph(cell);
  }

private:
  int n() const { return m_layout.dimension; }
  int m() const { return m_layout.equalities; }

  // Whether the node was thin.
  bool surround(const Box_node<NT>& node, const std::vector<double>& domain_widths)
  {
    bool is_thin = false;
    double widest = 0;
    const auto width = [&](int j) { return CGAL::to_double(Coordinate(node.upper[j] - node.lower[j])); };
    for (int j = 0; j < n(); ++j)
      if (domain_widths[j] > 0)
        widest = (std::max)(widest, width(j) / domain_widths[j]);
    for (int j = 0; j < n(); ++j) {
      const double margin = 0.5 * (0.25 * widest * domain_widths[j] - width(j));
      m_node.lower[j] = margin > 0 ? below(node.lower[j], margin) : node.lower[j];
      m_node.upper[j] = margin > 0 ? above(node.upper[j], margin) : node.upper[j];
      is_thin = is_thin || margin > 0;
    }
    return is_thin;
  }

  // The rows that the curve does not make zero are zero, up to rounding, at two points of it at least, and nowhere else
  // where it was tried.
  bool are_zero_along_graph(const Cell& cell)
  {
    m_spread.clear();
    for (int i = 0; i < m(); ++i)
      m_spread.push_back(m_graph.spread(i));
    m_steps = (1 + m_slack) / (1 - m_graph.contraction());
    int zeros = 0;
    for (const double parameter : {-0.41, -0.13, 0.17, 0.38}) {
      m_place.assign(n(), 0);
      m_place[m_graph.parameter()] = parameter;
      const Rest rest = rest_on_graph(cell);
      if (rest == Rest::NOT_ZERO || (rest == Rest::ZERO && zeros == 0 && !are_zero_exactly(cell)))
        return false;
      zeros += rest == Rest::ZERO;
    }
    return zeros >= 2;
  }

  // What the rows that the curve does not make zero are on it, where the parameter has its value; the place moves
  // there.
  Rest rest_on_graph(const Cell& cell)
  {
    constexpr int most_steps = 60;
    std::vector<Coordinate> point(m_node.lower.size());
    m_resolution = std::is_same_v<Coordinate, double> ? 0x1p-45 : 0x1p-28;   // that of place_below()
    for (int j = 0; j < n(); ++j) {
      const double lower = CGAL::to_double(m_node.lower[j]),
                   width = CGAL::to_double(Coordinate(m_node.upper[j] - m_node.lower[j]));
      m_resolution = (std::max)(m_resolution, 0x1p-52 * std::abs(lower) / width);
    }
    for (int step = 0; step < most_steps; ++step) {
      for (int j = 0; j < n(); ++j)
        point[j] = place_below(m_node.lower[j], m_node.upper[j], m_place[j] + 0.5);
      evaluate(cell, std::span<const Coordinate>(point));
      double longest = 0;
      for (int j = 0; j < n(); ++j)
        if (const int row = m_graph.row_of(j); row >= 0)
          longest = (std::max)(longest, std::abs(m_value[row]));
      if (is_not_zero_within(m_steps * (longest + 8 * m_resolution)))
        return Rest::NOT_ZERO;
      for (int j = 0; j < n(); ++j)
        if (const int row = m_graph.row_of(j); row >= 0) {
          m_place[j] -= m_value[row];
          if (!(std::abs(m_place[j]) < 0.6))
            return Rest::UNKNOWN;
        }
      if (longest < 8 * m_resolution)
        return are_zero(64 * m_resolution) ? Rest::ZERO : Rest::NOT_ZERO;
    }
    return Rest::UNKNOWN;
  }

  // The curve passes the last place within this distance, inside of the node, and some row that it does not make zero
  // is too large there to be zero on it.
  bool is_not_zero_within(double distance) const
  {
    for (int j = 0; j < n(); ++j)
      if (j != m_graph.parameter() && !(std::abs(m_place[j]) + distance < 0.5))
        return false;
    for (int i = n() - 1; i < m(); ++i)
      if (std::abs(m_value[i]) > m_spread[i] * distance * (1 + m_slack))
        return true;
    return false;
  }

  // g at a point, in m_value.
  template <class C>
  void evaluate(const Cell& cell, std::span<const C> point)
  {
    m_source.evaluate(cell, point, m_values);
    m_value.assign(m(), 0);
    for (int l = 0; l < m(); ++l) {
      const long exponent = (std::max)(-3000L, (std::min)(m_values[l].exponent - m_node.scale[l], 3000L));
      const double value = std::ldexp(m_values[l].mantissa, static_cast<int>(exponent));
      for (int i = 0; i < m(); ++i)
        m_value[i] += m_graph.transform(i, l) * value;
    }
  }

  // Moves on with rational coordinates, since what is zero up to the rounding of doubles may be a pair of roots.
  bool are_zero_exactly(const Cell& cell)
  {
    constexpr int bits = 160, most_steps = 200;   // beyond the width of the node
    std::vector<Exact_rational> point;
    std::vector<double> widths;
    int finest = bits;
    for (int j = 0; j < n(); ++j) {
      widths.push_back(CGAL::to_double(Coordinate(m_node.upper[j] - m_node.lower[j])));
      point.push_back(Exact_rational(place_below(m_node.lower[j], m_node.upper[j], m_place[j] + 0.5)));
      finest = (std::max)(finest, bits - std::ilogb(widths[j]));
    }
    for (int step = 0; step < most_steps; ++step) {
      evaluate(cell, std::span<const Exact_rational>(point));
      double longest = 0;
      for (int j = 0; j < n(); ++j)
        if (const int row = m_graph.row_of(j); row >= 0) {
          point[j] = stepped(point[j], -m_value[row] * widths[j], finest);
          longest = (std::max)(longest, std::abs(m_value[row]));
        }
      if (longest < std::ldexp(1.0, 8 - bits))
        return are_zero(std::ldexp(1.0, 32 - bits));
    }
    return false;
  }

  // At the point of the last value, relative to what would cancel.
  bool are_zero(double rounding) const
  {
    for (int i = n() - 1; i < m(); ++i) {
      double size = 0;
      for (int l = 0; l < m(); ++l)
        for (int j = 0; j < n(); ++j)
          size += std::abs(m_graph.transform(i, l) * m_graph.middle(l, j));
      if (!(std::abs(m_value[i]) <= rounding * size))
        return false;
    }
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_SOLUTION_CURVE_TEST_H
