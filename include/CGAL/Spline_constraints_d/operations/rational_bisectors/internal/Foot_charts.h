// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_CHARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_CHARTS_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Ball_powers.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
Whether feet F on a surface S are nearer to the centers of balls that touch S there than all other points of some cells.

These cells are seen in a chart: S is projected along a direction d onto a plane, where they are within a disk. Cells
are added until all that reach into the disk have their neighbours. On them <n,d> > 0 and S does not fold, so the
projection keeps orientations, and it is one-to-one over the whole disk if the boundary winds around it once. Along a
straight line in the disk the second derivative of half the squared distance from the center P of a ball is

  1 + c k,  c = <S-P,d> / <n,d>,

per squared length on S, with the normal curvature k. Where this is positive for both principal curvatures, the distance
is strictly convex over the disk, and has its least value at the foot, where its derivative is zero.
*/
class Foot_charts
{
  using Interval = Foot_grid::Interval;
  using Box = Foot_grid::Box;
  using Cell = Foot_grid::Cell;
  using Bounds = Foot_grid::Bounds;
  using Chart_point = std::array<double, 2>;

  // The plane of two vectors and the direction that is projected along, and a disk in the plane.
  struct Chart
  {
    std::array<std::array<double, 3>, 2> axes;
    Box direction;
    Chart_point center;
    double radius = 0;
  };

  Foot_grid& m_grid;
  std::vector<std::size_t> m_last_visit; // of cells, by the number of the visit
  std::size_t m_visit = 0;

public:
  // \pre rounding is upwards, here and below.
  explicit Foot_charts(Foot_grid& grid) : m_grid(grid), m_last_visit(grid.number_of_cells(), 0) {}

  // \pre there are some cells.
  bool is_nearest(const Touching_balls& balls, const std::vector<Cell>& near)
  {
    const std::optional<Chart> chart = chart_of(balls, near);
    if (!chart)
      return false;
    const std::optional<std::vector<Cell>> cells = cells_around_disk(nearest_cell(balls.foot, near), *chart);
    if (!cells)
      return false;
    for (const Cell& cell : near)
      if (!is_visited(cell))
        return false;
    for (const Cell& cell : *cells)
      if (reaches_into_disk(cell, *chart) && !is_convex(cell, balls, chart->direction))
        return false;
    return winding_number(*cells, *chart) == 1;
  }

private:
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
  std::optional<Chart> chart_of(const Touching_balls& balls, const std::vector<Cell>& near)
  {
    std::array<double, 3> n;
    for (std::size_t c = 0; c < 3; ++c)
      n[c] = Foot_grid::midpoint(balls.normal[c]);
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
      result.center[axis] = Foot_grid::midpoint(projected(balls.foot, result, axis));
    for (const Cell& cell : near)
      result.radius = (std::max)(result.radius, farthest(cell, result));
    return std::isfinite(result.radius) ? std::optional(result) : std::nullopt;
  }

  static Interval projected(const Bounds& bounds, const Chart& chart, std::size_t axis)
  {
    if (!std::isfinite(bounds.distance))
      return Interval::largest();
    const std::array<double, 3>& e = chart.axes[axis];
    return Ball_powers::height(bounds, {Interval(e[0]), Interval(e[1]), Interval(e[2])});
  }

  // Squared distances of the points of a cell from the center of the disk, in the chart.
  Interval squared_distances(const Cell& cell, const Chart& chart)
  {
    Interval result(0);
    for (const std::size_t axis : {0, 1})
      result += CGAL::square(projected(m_grid.bounds(cell), chart, axis) - Interval(chart.center[axis]));
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
  bool is_convex(const Cell& cell, const Touching_balls& balls, const Box& direction)
  {
    const Bounds& bounds = m_grid.bounds(cell);
    const Foot_grid::Shape& shape = m_grid.shape(cell);
    if (!shape.is_regular || !std::isfinite(bounds.distance))
      return false;
    Interval cosine(0), cosine_at_foot(0);
    for (std::size_t c = 0; c < 3; ++c) {
      cosine += shape.normal[c] * direction[c];
      cosine_at_foot += balls.normal[c] * direction[c];
    }
    if (!(cosine.inf() > 0))
      return false;
    // from the foot, and from the center
    const Interval first = Ball_powers::height(bounds, balls.foot, direction) - balls.x * cosine_at_foot,
                   second = Ball_powers::height(bounds, direction) - dot(balls.center, direction);
    const Interval c = Interval((std::max)(first.inf(), second.inf()), (std::min)(first.sup(), second.sup())) / cosine;
    return std::ranges::all_of(shape.curvatures,
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

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_CHARTS_H
