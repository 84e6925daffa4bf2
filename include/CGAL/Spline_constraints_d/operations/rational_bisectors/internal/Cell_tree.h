// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_CELL_TREE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_CELL_TREE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Ball_powers.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// The cells of a grid in a tree of balls around them.
class Cell_tree
{
  using Interval = Foot_grid::Interval;
  using Box = Foot_grid::Box;
  using Cell = Foot_grid::Cell;
  using Bounds = Foot_grid::Bounds;

  // Cells of a piece from (i,j) to (i + n, j + n), and a ball around them; leaves are single cells.
  struct Node
  {
    Cell first;
    int size;
    std::array<double, 3> center;
    double radius;
    std::array<std::size_t, 4> children;
  };

  Foot_grid& m_grid;
  std::vector<Node> m_nodes;
  std::vector<std::size_t> m_roots;

public:
  // \pre rounding is upwards, here and below; the size of the grid is a power of two.
  Cell_tree(Foot_grid& grid, const Operation_budget& budget) : m_grid(grid)
  {
    for (std::size_t piece = 0; piece < grid.number_of_pieces(); ++piece)
      m_roots.push_back(add_node({piece, {0, 0}}, grid.size(), budget));
  }

  // The cells that are not certainly outside of all balls; none if one is certainly inside of all.
  // Blocks of cells are left out if `is_left_out(first cell, size)`.
  template <class Is_left_out>
  std::optional<std::vector<Cell>> cells_near_balls(const Touching_balls& balls, const Is_left_out& is_left_out)
  {
    std::vector<Cell> result;
    std::vector<std::size_t> open(m_roots);
    while (!open.empty()) {
      const Node& node = m_nodes[open.back()];
      open.pop_back();
      if (is_left_out(node.first, node.size))
        continue;
      Bounds ball;
      ball.center = node.center;
      ball.first = ball.second = {0, 0, 0};
      ball.distance = ball.radius = node.radius;
      if (Ball_powers::is_outside(ball, balls))
        continue;
      if (node.size > 1) {
        open.insert(open.end(), node.children.begin(), node.children.end());
        continue;
      }
      const Bounds& own = m_grid.bounds(node.first);
      if (Ball_powers::power(own, balls.foot, balls.normal, balls.x).sup() < 0)
        return std::nullopt;
      if (!Ball_powers::is_outside(own, balls))
        result.push_back(node.first);
    }
    return result;
  }

private:
  std::size_t add_node(const Cell& first, int size, const Operation_budget& budget)
  {
    budget.check();
    const std::size_t index = m_nodes.size();
    m_nodes.push_back({first, size, {}, 0, {}});
    Box box = m_grid.bounds(first).point;
    if (size > 1) {
      const int half = size / 2;
      std::size_t k = 0;
      for (const int i : {0, half})
        for (const int j : {0, half}) {
          const std::size_t child = add_node({first.piece, {first.at[0] + i, first.at[1] + j}}, half, budget);
          m_nodes[index].children[k++] = child;
          const Node& node = m_nodes[child];
          const bool has_bounds = std::isfinite(node.radius);
          for (std::size_t c = 0; c < 3; ++c) {
            if (!has_bounds) {
              box[c] = Interval::largest();
              continue;
            }
            const Interval range = Interval(node.center[c]) + Interval(-node.radius, node.radius);
            box[c] = Interval((std::min)(box[c].inf(), range.inf()), (std::max)(box[c].sup(), range.sup()));
          }
        }
    }
    // Where a weight may be zero, points have no bounds.
    const bool is_bounded =
        std::ranges::all_of(box, [](const Interval& x) { return std::isfinite(x.inf()) && std::isfinite(x.sup()); });
    if (!is_bounded) {
      m_nodes[index].radius = std::numeric_limits<double>::infinity();
      return index;
    }
    Interval square(0);
    for (std::size_t c = 0; c < 3; ++c) {
      m_nodes[index].center[c] = Foot_grid::midpoint(box[c]);
      square += CGAL::square(box[c] - Interval(m_nodes[index].center[c]));
    }
    m_nodes[index].radius = square_root(square).sup();
    return index;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_CELL_TREE_H
