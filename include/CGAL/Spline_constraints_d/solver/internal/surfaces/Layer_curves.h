// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LAYER_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LAYER_CURVES_H

#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Graph_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Simple_roots_on_line.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Face_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Depth_first_subdivision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The curves of one equality in three unknowns on the part of a plane that is a face of a node, in doubles: from the layer
of the node's own coefficients there, with a bound on their errors, and on lines in that plane from layers of this
layer. Exact functions are not asked, which costs a small part of what they do. All is proved to be regular, or there is
no answer.

As for curves in general, the points on the boundary of a rectangle are known before it is looked at. It is finished
when it has no solutions, or when they are a graph over one of the unknowns. Each point is a simple root on one side of
the rectangle and no corner: there the graph goes through the side, so that pieces begin and end at the points in turns.
*/
class Layer_curves
{
public:
  using Range = std::pair<double, double>;

  // On a line in the plane; in the region, there is no other one on this line.
  struct Point
  {
    std::array<Range, 2> box, region;
    int fixed; // unknown, of two
  };

  // Between two of the points, over one unknown.
  struct Piece
  {
    std::array<Range, 2> box;
    int parameter;
    std::array<std::size_t, 2> ends;
  };

private:
  using Node = Box_node<double>;
  using Indices = std::vector<std::size_t>;

  // What the driver keeps for a rectangle.
  struct Rectangle
  {
    Indices points; // on its boundary
  };

  const Face_restriction m_plane;
  const std::array<Face_restriction, 2> m_lines; // that fix either unknown
  Node_view m_view;
  Graph_test m_graph{2, 1};
  Depth_first_subdivision<double> m_driver;
  Node m_below, m_above;
  std::array<Node, 2> m_on_line;
  Simple_roots_on_line m_roots{0x1p-36};
  std::vector<Point> m_points;
  std::vector<Piece> m_pieces;
  std::size_t m_nodes = 0;
  bool m_is_certain = true;

public:
  using State = Rectangle;

  // Whether there is one equality, of moderate degrees, in three unknowns, and nothing else.
  static bool fit(const System_layout& layout)
  {
    constexpr int largest_degree = 32;
    return layout.dimension == 3 && layout.equalities == 1 && layout.functions == 1 &&
        std::all_of(layout.blocks.begin(), layout.blocks.end(), [](const Block& block) {
             return std::all_of(block.degrees.begin(), block.degrees.end(),
                                [](int degree) { return degree <= largest_degree; });
           });
  }

  // On planes that fix an unknown. \pre `fit(layout)`
  Layer_curves(const System_layout& layout, int axis)
    : m_plane(layout, axis), m_lines{Face_restriction(m_plane.layout(), 0), Face_restriction(m_plane.layout(), 1)},
      m_view(m_plane.layout()), m_driver(m_plane.layout())
  {
    m_below.allocate(m_plane.layout());
    m_above.allocate(m_plane.layout());
    for (std::size_t k = 0; k < 2; ++k)
      m_on_line[k].allocate(m_lines[k].layout());
  }

  // Goes to the face at the upper end of a node that was looked at.
  void start(const Node& node)
  {
    m_points.clear();
    m_pieces.clear();
    m_nodes = 0;
    m_is_certain = true;
    m_plane(node, true, m_driver.root());
    look_at(m_driver.root());
  }

  // Adds the points on a side of the rectangle, where an unknown of two is at an end of its range; false if they are
  // not certain.
  bool add_points_on_side(int unknown, bool is_upper) { return add_points(m_driver.root(), unknown, is_upper); }

  // The curves, if they are certain; the points on all sides have been added.
  bool find_curves()
  {
    Indices boundary;
    for (std::size_t i = 0; i < m_points.size(); ++i)
      boundary.push_back(i);
    m_driver.run(*this, Rectangle{std::move(boundary)}, 0);
    return m_is_certain;
  }

  const std::vector<Point>& points() const { return m_points; }
  const std::vector<Piece>& pieces() const { return m_pieces; }
  std::size_t nodes() const { return m_nodes; }

  // For the driver.

  bool goes_on(const Node&, const Rectangle&, int)
  {
    constexpr std::size_t most_nodes = 512;
    m_is_certain = m_is_certain && ++m_nodes <= most_nodes;
    return m_is_certain;
  }

  Box_verdict examine(Node& node, const Rectangle& rectangle, int)
  {
    look_at(node);
    const bool is_finished = m_view.lower(0) > 0 || m_view.upper(0) < 0 ||
        (m_graph.eliminate(m_view) &&
         (m_graph.is_empty(m_view) || (m_graph.is_graph() && joined(node, rectangle.points, m_graph.parameter()))));
    return is_finished ? Box_verdict::DONE : Box_verdict::SPLIT;
  }

  std::optional<Box_split<Rectangle>> split(const Node& node, const Rectangle& rectangle, int)
  {
    const double* const lower = m_view.derivative_lower(0);
    const double* const upper = m_view.derivative_upper(0);
    const auto steepness = [&](int j) { return (std::max)(std::abs(lower[j]), std::abs(upper[j])); };
    const int steeper = steepness(1) > steepness(0) ? 1 : 0;
    for (const int axis : {steeper, 1 - steeper})
      for (const double place : {125.0 / 256, 137.0 / 256, 113.0 / 256, 149.0 / 256, 65.0 / 256, 189.0 / 256})
        if (auto parts = parts_at(node, rectangle, axis, place))
          return parts;
    m_is_certain = false;
    return std::nullopt;
  }

private:
  // The sizes of the coefficients are the ones that a cut has to know.
  void look_at(Node& node)
  {
    m_view.reset(node.coefficients().data(), node.errors().data());
    node.sizes()[0] = (std::max)(std::abs(m_view.block_lower(0)), std::abs(m_view.block_upper(0)));
  }

  bool add_points(const Node& node, int unknown, bool is_upper)
  {
    Node& line = m_on_line[static_cast<std::size_t>(unknown)];
    m_lines[static_cast<std::size_t>(unknown)](node, is_upper, line);
    const auto roots = m_roots(line.coefficients(), line.errors()[0], line.lower[0], line.upper[0]);
    if (!roots)
      return false;
    const double value = is_upper ? node.upper[unknown] : node.lower[unknown];
    for (const auto& [box, region] : *roots) {
      Point& point = m_points.emplace_back();
      point.fixed = unknown;
      point.box[unknown] = point.region[unknown] = {value, value};
      point.box[1 - unknown] = box;
      point.region[1 - unknown] = region;
    }
    return true;
  }

  // None where the line is too close to a known point, or points on it are not certain.
  std::optional<Box_split<Rectangle>> parts_at(const Node& node, const Rectangle& rectangle, int axis, double place)
  {
    const double value = place_between(node.lower[axis], node.upper[axis], place);
    if (value == node.lower[axis])
      return std::nullopt;
    Rectangle below, above;
    for (const std::size_t i : rectangle.points) {
      const auto& [least, most] = m_points[i].box[static_cast<std::size_t>(axis)];
      if (least <= value && value <= most)
        return std::nullopt;
      (most < value ? below : above).points.push_back(i);
    }
    m_below.copy_from(node);
    m_below.split(m_plane.layout(), axis, place, m_above);
    const std::size_t before = m_points.size();
    if (!add_points(m_below, axis, true))
      return std::nullopt;
    for (std::size_t i = before; i < m_points.size(); ++i)
      for (Rectangle* part : {&below, &above})
        part->points.push_back(i);
    return Box_split<Rectangle>{axis, place, std::move(below), std::move(above)};
  }

  // Makes the pieces of a graph; false when the order of the points is not certain.
  bool joined(const Node& node, Indices points, int parameter)
  {
    const auto place = [&](std::size_t i) { return m_points[i].box[static_cast<std::size_t>(parameter)]; };
    std::sort(points.begin(), points.end(), [&](std::size_t i, std::size_t k) { return place(i) < place(k); });
    for (std::size_t k = 1; k < points.size(); ++k)
      if (place(points[k]).first <= place(points[k - 1]).second)
        return false;
    if (points.size() % 2 != 0)
      return false;
    for (std::size_t k = 0; k < points.size(); k += 2)
      m_pieces.push_back({{Range(node.lower[0], node.upper[0]), Range(node.lower[1], node.upper[1])},
                          parameter,
                          {points[k], points[k + 1]}});
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_LAYER_CURVES_H
