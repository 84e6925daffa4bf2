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
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Ball_powers.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Cell_tree.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Fine_cells.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_charts.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_rectangles.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Lines_of_spheres.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_spheres.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
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

Most cells of the grid are outside of all these balls, by their distance. Near to the feet all is outside by a chart, or
by spheres that touch the surface along lines. What is left is outside or has a trend: the power of each of its points
increases, or that of all decreases, with one parameter of the feet. So does the least one of these powers then, whose
sign is the label: it changes once at most.
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

  // What decides a label: parts of the surface, and spheres that touch it along lines.
  struct Competitors
  {
    std::vector<Part_of_piece> parts = {};
    const Touching_spheres* spheres = nullptr;

    bool empty() const { return parts.empty() && !spheres; }
  };

  // How the label changes within a box of feet.
  struct Verdict
  {
    Answer answer = Answer::UNKNOWN;
    // If that is unknown: for both parameters whether feet become nearest ones (1) or others (-1) where it increases,
    // at most once on each line; 0 if this is not known.
    std::array<int, 2> trends{};
    // The parts of the surface which are not certainly outside of the balls, but for a neighbourhood of the feet where
    // all is; if there is a trend.
    Competitors competitors = {};

    bool is_known() const { return answer != Answer::UNKNOWN || trends[0] != 0 || trends[1] != 0; }
  };

private:
  Foot_grid& m_grid;
  Fine_cells m_fine;
  Lines_of_spheres m_lines;
  Foot_charts m_charts;
  Foot_rectangles m_rectangles;
  Cell_tree m_tree;

public:
  // \pre rounding is upwards, here and below; the size of the grid is a power of two.
  Nearest_feet(Foot_grid& grid, const std::vector<Polynomial_piece>& surface, const Operation_budget& budget)
    : m_grid(grid), m_fine(grid, surface), m_lines(grid, surface, budget), m_charts(grid), m_rectangles(grid, m_fine),
      m_tree(grid, budget)
  {}

  Verdict operator()(const Touching_balls& balls)
  {
    if (balls.are_beyond_focus())
      return {Answer::NO}; // the distance has no local minimum at the foot
    const Verdict by_lines = verdict_by_lines(balls);
    if (by_lines.answer != Answer::UNKNOWN)
      return by_lines;
    const std::optional<std::vector<Cell>> near =
        m_tree.cells_near_balls(balls, [](const Cell&, int) { return false; });
    if (!near)
      return {Answer::NO};
    constexpr std::size_t most_cells = 400;
    if (near->empty() || near->size() > most_cells) // if there are none, no cell has bounds
      return by_lines;
    if (m_charts.is_nearest(balls, *near))
      return {Answer::YES};
    if (by_lines.is_known())
      return by_lines;
    const Verdict by_chart = verdict_by_chart(balls, *near);
    return by_chart.is_known() ? by_chart : verdict_by_rectangle(balls, *near);
  }

  // The sign of the least power of what decides a label, for one ball, and a number that is near to it; zero if it is
  // too near to zero.
  std::pair<int, double> least_power(const Touching_balls& ball, const Competitors& competitors) const
  {
    double least = std::numeric_limits<double>::infinity();
    int sign = 1;
    if (competitors.spheres) {
      const std::optional<Touching_spheres::Spheres> spheres = competitors.spheres->spheres(ball);
      if (!spheres)
        return {0, 0};
      least = Foot_grid::midpoint(spheres->gap);
      sign = spheres->gap.inf() > 0 ? 1 : spheres->gap.sup() < 0 ? -1 : 0;
    }
    for (std::size_t k = 0; k < competitors.parts.size() && sign >= 0; ++k)
      sign = (std::min)(sign, m_fine.sign_of_power(competitors.parts[k], ball.middle, least));
    return {sign, least};
  }

private:
  // A parameter of the feet, and whether feet become nearest ones (1) or others (-1) where it increases.
  struct Target
  {
    std::size_t axis;
    int trend;
  };

  // Where spheres touch the surface along lines.
  Verdict verdict_by_lines(const Touching_balls& balls)
  {
    for (const std::size_t along : {0, 1}) {
      const Touching_spheres* lines = m_lines.spheres(balls.piece, along);
      const auto spheres = lines ? lines->spheres(balls) : std::nullopt;
      if (!spheres)
        continue;
      for (const int margin : {m_grid.size(), 8, 2}) {
        if (!m_lines.are_outside_nearby(balls, along, margin, spheres->center))
          continue;
        const auto is_nearby = [&](const Cell& first, int size) {
          return m_lines.are_nearby(balls, along, margin, first, size);
        };
        const std::optional<std::vector<Cell>> near = m_tree.cells_near_balls(balls, is_nearby);
        if (!near)
          return {Answer::NO};
        std::vector<std::size_t> parts;
        for (const Cell& cell : *near)
          parts.push_back(m_fine.of_cell(cell));
        const Verdict result = verdict_on_parts(balls, parts, {lines, spheres});
        if (result.is_known())
          return result;
        break;
      }
    }
    return {};
  }

  // Where the feet are nearest within a chart, but for parts of the surface that are farther away.
  Verdict verdict_by_chart(const Touching_balls& balls, const std::vector<Cell>& near)
  {
    std::vector<std::size_t> parts;
    std::vector<Cell> next_to_feet;
    for (const Cell& cell : near)
      if (is_next_to_feet(balls, cell))
        next_to_feet.push_back(cell);
      else
        parts.push_back(m_fine.of_cell(cell));
    const bool is_proved = !next_to_feet.empty() && !parts.empty() && m_charts.is_nearest(balls, next_to_feet);
    return is_proved ? verdict_on_parts(balls, parts, {}) : Verdict();
  }

  // Where the squared distance is convex in the parameters.
  Verdict verdict_by_rectangle(const Touching_balls& balls, const std::vector<Cell>& near)
  {
    const std::optional<Foot_rectangles::Others> others = m_rectangles.others(balls, near);
    if (!others)
      return {};
    if (others->has_point_inside)
      return {Answer::NO};
    if (others->parts.empty())
      return {Answer::YES};
    return verdict_on_parts(balls, others->parts, {});
  }

  // Spheres that touch along lines, or none: then what is near to the feet is outside.
  struct Near_spheres
  {
    const Touching_spheres* lines = nullptr;
    std::optional<Touching_spheres::Spheres> spheres = {};
  };

  // If all other parts of the surface are outside.
  Verdict verdict_on_parts(const Touching_balls& balls, const std::vector<std::size_t>& parts, const Near_spheres& near)
  {
    if (near.lines && near.spheres->gap.sup() < 0)
      return {Answer::NO};
    const bool has_spheres = near.lines && !(near.spheres->gap.inf() > 0);
    constexpr std::size_t most_parts = 200;
    if (parts.size() > most_parts)
      return {};
    for (const std::size_t axis : {0, 1})
      for (const int trend : {1, -1}) {
        const Target target{axis, trend};
        Competitors found;
        if (has_spheres) {
          const Interval& slope = near.spheres->slopes[axis];
          if (!(trend > 0 ? slope.inf() > 0 : slope.sup() < 0))
            continue;
          found.spheres = near.lines;
        }
        const Answer answer = competitors(balls, parts, target, found.parts);
        if (answer == Answer::NO)
          return {Answer::NO};
        if (answer == Answer::UNKNOWN)
          continue;
        if (found.empty())
          return {Answer::YES};
        Verdict result;
        result.trends[axis] = trend;
        result.trends[1 - axis] = trend_of_other(near, found, 1 - axis);
        result.competitors = std::move(found);
        return result;
      }
    return {};
  }

  // Of the other parameter, if all that decides the label has it without being cut.
  static int trend_of_other(const Near_spheres& near, const Competitors& found, std::size_t axis)
  {
    if (!found.parts.empty() || !found.spheres)
      return 0;
    const Interval& slope = near.spheres->slopes[axis];
    return slope.inf() > 0 ? 1 : slope.sup() < 0 ? -1 : 0;
  }

  // Where the power is zero, and so has no trend.
  bool is_next_to_feet(const Touching_balls& balls, const Cell& cell)
  {
    const Bounds& bounds = m_grid.bounds(cell);
    if (!std::isfinite(bounds.radius))
      return true;
    double square = 0;
    for (std::size_t c = 0; c < 3; ++c)
      square += CGAL::square(bounds.center[c] - balls.foot.center[c]);
    return std::sqrt(square) < balls.foot.radius + 2 * bounds.radius;
  }

  // Those of parts that are not certainly outside, if they have a trend; or NO if a point is certainly inside.
  Answer competitors(const Touching_balls& balls, std::vector<std::size_t> open, const Target& target,
                     std::vector<Part_of_piece>& found)
  {
    while (!open.empty()) {
      const std::size_t part = open.back();
      open.pop_back();
      const Ball_powers::Change change = Ball_powers::change_of_power(balls, m_fine.bounds(part));
      if (change.least > 0)
        continue;
      if (Ball_powers::greatest_power(balls, m_fine.sample(part)) < 0)
        return Answer::NO;
      if (change.trends[target.axis] == target.trend) {
        found.push_back(m_fine.part(part));
        continue;
      }
      constexpr int most_depth = 4;
      if (m_fine.depth(part) >= most_depth || !std::isfinite(m_fine.bounds(part).distance))
        return Answer::UNKNOWN;
      const std::array<std::size_t, 4> quarters = m_fine.quarters(part);
      open.insert(open.end(), quarters.begin(), quarters.end());
    }
    return Answer::YES;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_NEAREST_FEET_H
