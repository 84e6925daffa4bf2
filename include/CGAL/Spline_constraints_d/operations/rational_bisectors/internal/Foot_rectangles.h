// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_RECTANGLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_RECTANGLES_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Ball_powers.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Fine_cells.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

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
namespace Rational_bisectors {

/*
Feet on a surface, and fine parts of it that are not outside of balls that touch it there: those around the feet, which
are farther than the feet if the squared distance is convex on a rectangle of parameters around them all, and others.
*/
class Foot_rectangles
{
  Foot_grid& m_grid;
  Fine_cells& m_fine;

public:
  // Parts that are not known to be outside, but for those around the feet.
  struct Others
  {
    bool has_point_inside = false; // of all balls, certainly
    std::vector<std::size_t> parts = {};
  };

  //! \pre rounding is upwards, here and below; the arguments live longer.
  Foot_rectangles(Foot_grid& grid, Fine_cells& fine) : m_grid(grid), m_fine(fine) {}

  // None if it is not known that what is around the feet is outside.
  std::optional<Others> others(const Touching_balls& balls, const std::vector<Foot_grid::Cell>& near)
  {
    for (const int depth : {1, 2, 4}) {
      Others result;
      const std::optional<std::vector<std::size_t>> parts = parts_near_balls(balls, near, depth);
      if (!parts)
        return Others{true, {}};
      constexpr std::size_t most_parts = 300;
      if (parts->size() > most_parts)
        return std::nullopt;
      if (is_convex(balls.center, {balls.piece, rectangle_around_feet(balls, *parts, result.parts)}))
        return result;
    }
    return std::nullopt;
  }

private:
  // Those that are not outside, none if a point is inside.
  std::optional<std::vector<std::size_t>> parts_near_balls(const Touching_balls& balls,
                                                           const std::vector<Foot_grid::Cell>& near, int depth)
  {
    std::vector<std::size_t> open, result;
    for (const Foot_grid::Cell& cell : near)
      open.push_back(m_fine.of_cell(cell));
    while (!open.empty()) {
      const std::size_t part = open.back();
      open.pop_back();
      if (Ball_powers::change_of_power(balls, m_fine.bounds(part)).least > 0)
        continue;
      if (Ball_powers::greatest_power(balls, m_fine.sample(part)) < 0)
        return std::nullopt;
      if (m_fine.depth(part) >= depth || !std::isfinite(m_fine.bounds(part).distance)) {
        result.push_back(part);
        continue;
      }
      const std::array<std::size_t, 4> quarters = m_fine.quarters(part);
      open.insert(open.end(), quarters.begin(), quarters.end());
    }
    return result;
  }

  static bool touch(const Parameter_rectangle& a, const Parameter_rectangle& b)
  {
    return a[0][0] <= b[0][1] && b[0][0] <= a[0][1] && a[1][0] <= b[1][1] && b[1][0] <= a[1][1];
  }

  // Around the feet and all parts that touch it; others go to a list.
  Parameter_rectangle rectangle_around_feet(const Touching_balls& balls, std::vector<std::size_t> parts,
                                            std::vector<std::size_t>& others) const
  {
    Parameter_rectangle result = balls.box;
    const auto take = [&](std::size_t part) {
      const Part_of_piece& own = m_fine.part(part);
      if (own.piece != balls.piece || !touch(own.box, result))
        return false;
      for (const std::size_t axis : {0, 1})
        result[axis] = {(std::min)(result[axis][0], own.box[axis][0]), (std::max)(result[axis][1], own.box[axis][1])};
      return true;
    };
    while (std::erase_if(parts, take) > 0)
      continue;
    others = std::move(parts);
    return result;
  }

  bool is_convex(const Interval_vector& center, const Part_of_piece& rectangle)
  {
    std::array<std::array<int, 2>, 2> range;
    for (const std::size_t axis : {0, 1})
      for (const std::size_t side : {0, 1})
        range[axis][side] =
            std::clamp(static_cast<int>(std::floor(rectangle.box[axis][side] * m_grid.size())), 0, m_grid.size() - 1);
    std::vector<std::size_t> open;
    for (int i = range[0][0]; i <= range[0][1]; ++i)
      for (int j = range[1][0]; j <= range[1][1]; ++j)
        open.push_back(m_fine.of_cell({rectangle.piece, {i, j}}));
    constexpr int most_depth = 4;
    constexpr std::size_t most_parts = 2000;
    for (std::size_t count = 0; !open.empty(); ++count) {
      const std::size_t part = open.back();
      open.pop_back();
      if (!touch(m_fine.part(part).box, rectangle.box) || m_fine.is_distance_convex(part, center))
        continue;
      if (m_fine.depth(part) >= most_depth || count > most_parts)
        return false;
      const std::array<std::size_t, 4> quarters = m_fine.quarters(part);
      open.insert(open.end(), quarters.begin(), quarters.end());
    }
    return true;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FOOT_RECTANGLES_H
