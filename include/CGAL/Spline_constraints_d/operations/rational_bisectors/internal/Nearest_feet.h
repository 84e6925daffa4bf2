// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_NEAREST_FEET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_NEAREST_FEET_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
Whether feet F on a surface S are the nearest points of it: whether the ball around a point F + x n of the bisector,
with the normal n at the foot, that touches the surface there, has no point of it inside, for all feet in a part of a
piece at once.

Most cells of the grid are outside of all these balls, by their distance. The others, near the feet, are seen in a
chart: S is projected along a direction d onto a plane, where they are within a disk. Cells are added until all that
reach into the disk have their neighbours. On them <n,d> > 0 and S does not fold, so the projection keeps orientations,
and it is one-to-one over the whole disk if the boundary winds around it once. Along a straight line in the disk the
second derivative of half the squared distance from the center P of a ball is

  1 + c k,  c = <S-P,d> / <n,d>,

per squared length on S, with the normal curvature k. Where this is positive for both principal curvatures, the distance
is strictly convex over the disk, and has its least value at the foot, where its derivative is zero.
*/
class Nearest_feet
{
public:
  using Interval = Foot_grid::Interval;
  using Box = Foot_grid::Box;
  using Cell = Foot_grid::Cell;
  using Bounds = Foot_grid::Bounds;

  enum class Answer
  {
    YES,
    NO,
    UNKNOWN
  };

  // Of feet in a part of a piece, and of the bisector there: x, and the points if they are bounded.
  struct Feet
  {
    Bounds bounds;
    Interval x;
    Box centers;
  };

private:
  using Chart_point = std::array<double, 2>;

  // Cells of a piece from (i,j) to (i + n, j + n), and a ball around them; leaves are single cells.
  struct Node
  {
    Cell first;
    int size;
    std::array<double, 3> center;
    double radius;
    std::array<std::size_t, 4> children;
  };

  // The plane of two vectors and the direction that is projected along, and a disk in the plane.
  struct Chart
  {
    std::array<std::array<double, 3>, 2> axes;
    Box direction;
    Chart_point center;
    double radius = 0;
  };

  Foot_grid& m_grid;
  std::vector<Node> m_nodes;
  std::vector<std::size_t> m_roots;
  std::vector<std::size_t> m_last_visit; // of cells, by the number of the visit
  std::size_t m_visit = 0;

public:
  // \pre rounding is upwards, here and below; the size of the grid is a power of two.
  Nearest_feet(Foot_grid& grid, const Operation_budget& budget) : m_grid(grid), m_last_visit(grid.number_of_cells(), 0)
  {
    for (std::size_t piece = 0; piece < grid.number_of_pieces(); ++piece)
      m_roots.push_back(add_node({piece, {0, 0}}, grid.size(), budget));
  }

  Answer operator()(const Feet& feet)
  {
    if (!feet.bounds.is_regular)
      return Answer::UNKNOWN;
    const auto is_beyond_focus = [&](const Interval& curvature) {
      return (Interval(1) - feet.x * curvature).sup() < 0;
    };
    if (std::ranges::any_of(feet.bounds.curvatures, is_beyond_focus))
      return Answer::NO; // the distance has no local minimum at the foot
    const std::optional<std::vector<Cell>> near = cells_near_balls(feet);
    if (!near)
      return Answer::NO;
    if (near->empty())
      return Answer::UNKNOWN; // no cell has bounds
    constexpr std::size_t most_cells = 400;
    return near->size() <= most_cells && is_nearest(feet, *near) ? Answer::YES : Answer::UNKNOWN;
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

  // The cells that are not certainly outside of all balls; none if one is certainly inside of all.
  std::optional<std::vector<Cell>> cells_near_balls(const Feet& feet)
  {
    std::vector<Cell> result;
    std::vector<std::size_t> open(m_roots);
    while (!open.empty()) {
      const Node& node = m_nodes[open.back()];
      open.pop_back();
      Bounds ball;
      ball.center = node.center;
      ball.first = ball.second = {0, 0, 0};
      ball.distance = ball.radius = node.radius;
      if (is_outside(ball, feet))
        continue;
      if (node.size > 1) {
        open.insert(open.end(), node.children.begin(), node.children.end());
        continue;
      }
      const Bounds& own = m_grid.bounds(node.first);
      if (power(own, feet.bounds, feet.x).sup() < 0)
        return std::nullopt;
      if (!is_outside(own, feet))
        result.push_back(node.first);
    }
    return result;
  }

  // Of all balls: far from the feet, by the distance from their centers.
  static bool is_outside(const Bounds& cell, const Feet& feet)
  {
    if (!std::isfinite(cell.distance))
      return false;
    if (power(cell, feet.bounds, feet.x).inf() > 0)
      return true;
    // |c + s a + t b - P|^2 >= |c - P|^2 - 2 |<a,c-P>| - 2 |<b,c-P>|
    Box difference;
    for (std::size_t c = 0; c < 3; ++c)
      difference[c] = Interval(cell.center[c]) - feet.centers[c];
    Interval square = CGAL::square(difference[0]) + CGAL::square(difference[1]) + CGAL::square(difference[2]);
    for (const auto* vector : {&cell.first, &cell.second})
      square -= Interval(2) * CGAL::abs(dot({(*vector)[0], (*vector)[1], (*vector)[2]}, difference));
    return square.inf() > 0 && (square_root(square) - Interval(cell.distance) - CGAL::abs(feet.x)).inf() > 0;
  }

  /*
  For points X of a cell,

    |X-F|^2 - 2 x <X-F,n>,

  which is positive outside of the balls. The second term is small near the foot, where the cell is nearly at a right
  angle to the normal.
  */
  static Interval power(const Bounds& cell, const Bounds& feet, const Interval& x)
  {
    if (!std::isfinite(cell.distance) || !std::isfinite(feet.distance))
      return Interval::largest();
    Interval square(0), extent = Interval(cell.radius) + Interval(feet.radius);
    for (std::size_t c = 0; c < 3; ++c)
      square += CGAL::square(Interval(cell.center[c]) - Interval(feet.center[c]));
    const Interval distance = square_root(square) + Interval(-extent.sup(), extent.sup());
    return CGAL::square(Interval((std::max)(distance.inf(), 0.0), distance.sup())) -
        Interval(2) * x * height(cell, feet, feet.normal);
  }

  static Interval dot(const Box& a, const Box& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  // <X,d> for points of a cell, without its center and with it.
  static Interval extent(const Bounds& cell, const Box& d)
  {
    const Interval length = square_root(dot(d, d));
    Interval slack = Interval(cell.distance) * length;
    for (const auto* vector : {&cell.first, &cell.second})
      slack += CGAL::abs(dot({(*vector)[0], (*vector)[1], (*vector)[2]}, d));
    return Interval(-slack.sup(), slack.sup());
  }

  static Interval height(const Bounds& cell, const Box& d)
  {
    return dot({cell.center[0], cell.center[1], cell.center[2]}, d) + extent(cell, d);
  }

  // <X-F,d> for points of a cell.
  static Interval height(const Bounds& cell, const Bounds& feet, const Box& d)
  {
    Box difference;
    for (std::size_t c = 0; c < 3; ++c)
      difference[c] = Interval(cell.center[c]) - Interval(feet.center[c]);
    return dot(difference, d) + extent(cell, d) + extent(feet, d);
  }

  bool is_nearest(const Feet& feet, const std::vector<Cell>& near)
  {
    const std::optional<Chart> chart = chart_of(feet.bounds, near);
    if (!chart)
      return false;
    const std::optional<std::vector<Cell>> cells = cells_around_disk(nearest_cell(feet.bounds, near), *chart);
    if (!cells)
      return false;
    for (const Cell& cell : near)
      if (!is_visited(cell))
        return false;
    for (const Cell& cell : *cells)
      if (reaches_into_disk(cell, *chart) && !is_convex(cell, feet, chart->direction))
        return false;
    return winding_number(*cells, *chart) == 1;
  }

  // \pre there are some.
  const Cell& nearest_cell(const Bounds& feet, const std::vector<Cell>& near)
  {
    const auto squared_distance = [&](const Cell& cell) {
      double result = 0;
      for (std::size_t c = 0; c < 3; ++c)
        result += CGAL::square(m_grid.bounds(cell).center[c] - feet.center[c]);
      return result;
    };
    return *std::ranges::min_element(near, {}, squared_distance);
  }

  // With a disk that has all cells that are near to the balls: those of the feet are.
  std::optional<Chart> chart_of(const Bounds& feet, const std::vector<Cell>& near)
  {
    std::array<double, 3> n;
    for (std::size_t c = 0; c < 3; ++c)
      n[c] = Foot_grid::midpoint(feet.normal[c]);
    const std::size_t least =
        static_cast<std::size_t>(std::ranges::min_element(n, {}, [](double x) { return std::abs(x); }) - n.begin());
    std::array<double, 3> unit{};
    unit[least] = 1;
    const auto cross = [](const auto& a, const auto& b) {
      using Number = std::decay_t<decltype(a[0] * b[0])>;
      return std::array<Number, 3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    Chart result;
    result.axes[0] = cross(unit, n);
    const double length = Foot_grid::norm(result.axes[0]);
    if (!(length > 0))
      return std::nullopt;
    for (double& x : result.axes[0])
      x /= length;
    result.axes[1] = cross(n, result.axes[0]);
    const auto intervals = [](const std::array<double, 3>& a) {
      return Box{Interval(a[0]), Interval(a[1]), Interval(a[2])};
    };
    result.direction = cross(intervals(result.axes[0]), intervals(result.axes[1]));
    for (const std::size_t axis : {0, 1})
      result.center[axis] = Foot_grid::midpoint(projected(feet.point, result, axis));
    for (const Cell& cell : near)
      result.radius = (std::max)(result.radius, farthest(cell, result));
    return std::isfinite(result.radius) ? std::optional(result) : std::nullopt;
  }

  static Interval projected(const Box& box, const Chart& chart, std::size_t axis)
  {
    const std::array<double, 3>& e = chart.axes[axis];
    return box[0] * Interval(e[0]) + box[1] * Interval(e[1]) + box[2] * Interval(e[2]);
  }

  // Squared distances of the points of a cell from the center of the disk, in the chart.
  Interval squared_distances(const Cell& cell, const Chart& chart)
  {
    Interval result(0);
    for (const std::size_t axis : {0, 1})
      result += CGAL::square(projected(m_grid.bounds(cell).point, chart, axis) - Interval(chart.center[axis]));
    return result;
  }

  double farthest(const Cell& cell, const Chart& chart) { return square_root(squared_distances(cell, chart)).sup(); }

  bool reaches_into_disk(const Cell& cell, const Chart& chart)
  {
    return !(squared_distances(cell, chart).inf() > CGAL::square(Interval(chart.radius)).sup());
  }

  bool is_visited(const Cell& cell) const { return m_last_visit[m_grid.index(cell)] == m_visit; }

  bool visit(const Cell& cell) { return std::exchange(m_last_visit[m_grid.index(cell)], m_visit) != m_visit; }

  // From one of them on, with all neighbours of those that reach into the disk; none if some are not known.
  std::optional<std::vector<Cell>> cells_around_disk(const Cell& first, const Chart& chart)
  {
    constexpr std::size_t most_cells = 2000;
    ++m_visit;
    std::vector<Cell> result{first};
    visit(first);
    for (std::size_t k = 0; k < result.size(); ++k) {
      if (!reaches_into_disk(result[k], chart))
        continue;
      for (const int axis : {0, 1})
        for (const int side : {0, 1}) {
          const std::vector<Cell> behind = m_grid.neighbours(result[k], axis, side);
          if (behind.empty() || result.size() > most_cells)
            return std::nullopt;
          for (const Cell& cell : behind)
            if (visit(cell))
              result.push_back(cell);
        }
    }
    return result;
  }

  // That the normal is on the side of the direction, and 1 + c k is positive for both principal curvatures.
  bool is_convex(const Cell& cell, const Feet& feet, const Box& direction)
  {
    const Bounds& bounds = m_grid.bounds(cell);
    if (!bounds.is_regular)
      return false;
    Interval cosine(0), cosine_at_foot(0);
    for (std::size_t c = 0; c < 3; ++c) {
      cosine += bounds.normal[c] * direction[c];
      cosine_at_foot += feet.bounds.normal[c] * direction[c];
    }
    if (!(cosine.inf() > 0))
      return false;
    // from the foot, and from the center
    const Interval first = height(bounds, feet.bounds, direction) - feet.x * cosine_at_foot,
                   second = height(bounds, direction) - dot(feet.centers, direction);
    const Interval c = Interval((std::max)(first.inf(), second.inf()), (std::min)(first.sup(), second.sup())) / cosine;
    return std::ranges::all_of(bounds.curvatures,
                               [&](const Interval& curvature) { return (Interval(1) + c * curvature).inf() > 0; });
  }

  // Of the boundary of cells around the center of the disk. A side of the boundary belongs to a cell whose box in the
  // chart does not reach into the disk, so the angle that is seen of it is less than half a turn.
  int winding_number(const std::vector<Cell>& cells, const Chart& chart)
  {
    double angle = 0;
    for (const Cell& cell : cells)
      for (const int axis : {0, 1})
        for (const int side : {0, 1}) {
          const std::vector<Cell> behind = m_grid.neighbours(cell, axis, side);
          if (!behind.empty() && std::ranges::all_of(behind, [&](const Cell& other) { return is_visited(other); }))
            continue;
          // counterclockwise around the cell
          const bool is_forward = (axis == 1) == (side == 0);
          std::array<int, 2> from{}, to{};
          from[static_cast<std::size_t>(axis)] = to[static_cast<std::size_t>(axis)] = side;
          (is_forward ? to : from)[static_cast<std::size_t>(1 - axis)] = 1;
          const auto first = m_grid.corner(cell, from[0], from[1]), last = m_grid.corner(cell, to[0], to[1]);
          if (!(first.second + last.second < 0x1p-20 * chart.radius))
            return 0;
          const Chart_point a = in_chart(first.first, chart), b = in_chart(last.first, chart);
          angle += std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
        }
    constexpr double turn = 6.283185307179586;
    const double turns = std::round(angle / turn);
    return std::abs(angle - turns * turn) < 0.1 ? static_cast<int>(turns) : 0;
  }

  // From the center of the disk.
  static Chart_point in_chart(const std::array<double, 3>& p, const Chart& chart)
  {
    Chart_point result;
    for (const std::size_t axis : {0, 1}) {
      const std::array<double, 3>& e = chart.axes[axis];
      result[axis] = p[0] * e[0] + p[1] * e[1] + p[2] * e[2] - chart.center[axis];
    }
    return result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_NEAREST_FEET_H
