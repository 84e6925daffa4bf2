// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LAYER_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LAYER_CURVES_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Layer_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Face_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Graph_box_search.h>
#include <CGAL/Spline_constraints_d/solver/solver_traits.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The curves of a system on the part of a plane that is a face of a node, in doubles: from the layer of the node's own
coefficients there, with bounds on their errors, and points on planes in that plane from layers of this layer. Exact
functions are not asked, which costs a small part of what they do. All is proved to be regular, or there is no answer.

As for curves in general, the points on the boundary of a box are known before it is looked at. It is finished when it
has no solutions, or when they are a graph over one of the unknowns. Each point is a regular one on one face of the box,
and inside of it: there the graph goes through the face, so that pieces begin and end at the points in turns.
*/
class Layer_curves : Graph_box_search<Certified_solver_traits>
{
  using Search = Graph_box_search<Certified_solver_traits>;
  using Search::Node;

public:
  using Range = std::pair<double, double>;
  using Box = Layer_points::Box;

  // On a plane in the plane; in the region, there is no other one on both.
  struct Point
  {
    Box box, region;
    int fixed; // unknown
  };

  // Between two of the points, over one unknown.
  struct Piece
  {
    Box box;
    int parameter;
    std::array<std::size_t, 2> ends;
  };

  // What the driver keeps for a node.
  struct State
  {
    std::vector<std::size_t> points = {}; // on its boundary
  };

private:
  Solver_options m_own_options;
  const Face_restriction m_plane;
  std::deque<Face_points> m_on_side; // per unknown that is fixed on a side, too
  Node m_below, m_above;
  std::vector<double> m_widths;
  std::vector<Point> m_points;
  std::vector<Piece> m_pieces;
  Summary m_work;
  std::size_t m_nodes = 0;
  bool m_is_certain = true;

public:
  // Whether there are equalities for surfaces alone, of moderate degrees.
  static bool fit(const System_layout& layout)
  {
    return layout.functions == layout.equalities && layout.equalities == layout.dimension - 2 &&
        Face_restriction::has_moderate_degrees(layout);
  }

  // On planes that fix an unknown. \pre `fit(layout)`
  Layer_curves(const System_layout& layout, int axis, const Solver_options& options, Run_control& control)
    : Search(Face_restriction(layout, axis).layout(), 1, m_widths, m_own_options, control, m_work),
      m_own_options(options), m_plane(layout, axis)
  {
    for (int j = 0; j < m_layout.dimension; ++j)
      m_on_side.emplace_back(m_layout, j);
    m_below.allocate(m_layout);
    m_above.allocate(m_layout);
  }

  // Goes to the face at the upper end of a node that was looked at.
  void start(const Node& node)
  {
    m_points.clear();
    m_pieces.clear();
    m_nodes = 0;
    m_is_certain = true;
    Node& root = m_driver.root();
    m_plane(node, true, root);
    m_analysis.look_at(root);
    m_widths.clear();
    double largest = 1;
    for (int j = 0; j < m_layout.dimension; ++j) {
      m_widths.push_back(root.upper[j] - root.lower[j]);
      largest = (std::max)({largest, std::abs(root.lower[j]), std::abs(root.upper[j])});
    }
    constexpr double thinnest = 0x1p-16; // in thinner boxes rounding errors matter
    m_own_options.tolerance = thinnest * *std::min_element(m_widths.begin(), m_widths.end()) / largest;
  }

  // Adds the points on a side, where an unknown is at an end of its range; false if they are not certain.
  bool add_points_on_side(int unknown, bool is_upper) { return add_points(m_driver.root(), unknown, is_upper); }

  // The curves, if they are certain; the points on all sides have been added.
  bool find_curves()
  {
    State boundary;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      boundary.points.push_back(i);
    m_driver.run(*this, std::move(boundary), 0);
    return m_is_certain;
  }

  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Piece>& pieces() const { return m_pieces; }
  std::size_t nodes() const { return m_nodes; }

  // For the driver.

  bool goes_on(const Node&, const State&, int)
  {
    constexpr std::size_t most_nodes = 512;
    m_is_certain = m_is_certain && ++m_nodes <= most_nodes && limit() == Undecided_reason::NONE;
    return m_is_certain;
  }

  Box_verdict examine(Node& node, const State& state, int)
  {
    return examine_node(node, [&] { return joined(node, state.points, m_graph.parameter()); });
  }

  std::optional<Box_split<State>> split(const Node& node, const State& state, int)
  {
    for (const int axis : rated_axes(node, 0))
      for (const double place : {125.0 / 256, 137.0 / 256, 113.0 / 256, 149.0 / 256, 65.0 / 256, 189.0 / 256})
        if (auto parts = parts_at(node, state, axis, place))
          return parts;
    m_is_certain = false;
    return std::nullopt;
  }

private:
  bool add_points(const Node& node, int unknown, bool is_upper)
  {
    auto roots = m_on_side[static_cast<std::size_t>(unknown)](node, is_upper);
    for (std::size_t i = 0; roots && i < roots->size(); ++i)
      m_points.push_back({std::move((*roots)[i].box), std::move((*roots)[i].region), unknown});
    return roots.has_value();
  }

  // None where the plane is too close to a known point, or points on it are not certain.
  std::optional<Box_split<State>> parts_at(const Node& node, const State& state, int axis, double place)
  {
    const double value = place_between(node.lower[axis], node.upper[axis], place);
    if (value == node.lower[axis])
      return std::nullopt;
    State below, above;
    for (const std::size_t i : state.points) {
      const auto& [least, most] = m_points[i].box[static_cast<std::size_t>(axis)];
      if (least <= value && value <= most)
        return std::nullopt;
      (most < value ? below : above).points.push_back(i);
    }
    m_below.copy_from(node);
    m_below.split(m_layout, axis, place, m_above);
    const std::size_t before = m_points.size();
    if (!add_points(m_below, axis, true))
      return std::nullopt;
    for (std::size_t i = before; i < m_points.size(); ++i)
      for (State* part : {&below, &above})
        part->points.push_back(i);
    return Box_split<State>{axis, place, std::move(below), std::move(above)};
  }

  // Makes the pieces of a graph; false when the order of the points is not certain.
  bool joined(const Node& node, std::vector<std::size_t> points, int parameter)
  {
    const auto place = [&](std::size_t i) { return m_points[i].box[static_cast<std::size_t>(parameter)]; };
    std::sort(points.begin(), points.end(), [&](std::size_t i, std::size_t k) { return place(i) < place(k); });
    for (std::size_t k = 1; k < points.size(); ++k)
      if (place(points[k]).first <= place(points[k - 1]).second)
        return false;
    if (points.size() % 2 != 0)
      return false;
    Box box;
    for (int j = 0; j < m_layout.dimension; ++j)
      box.emplace_back(node.lower[j], node.upper[j]);
    for (std::size_t k = 0; k < points.size(); k += 2)
      m_pieces.push_back({box, parameter, {points[k], points[k + 1]}});
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LAYER_CURVES_H
