// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SHEET_LABELS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SHEET_LABELS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Trimmed_envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Sheet_cell.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Nearest_feet.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

/*
The solutions in a box of a sheet, in cells that are cut as long as it is not known whether their feet are the nearest
points of both operands.

In a full graph the label changes along one arc at most if, along each line of one parameter, feet become nearest ones
of both operands where it increases, or others of both. The signs of the least power in the corners then tell whether
there is an arc, as for rational bisectors.
*/
template <class Pair, class First, class Second>
class Sheet_labels
{
public:
  using Cell = Sheet_cell<Pair>;
  using Interval = typename Cell::Interval;
  using Box = typename Cell::Box;
  using Answer = Nearest_feet::Answer;
  using Verdict = Nearest_feet::Verdict;

  struct Leaf
  {
    Cell cell;
    Nearest_feet_label label = Nearest_feet_label::UNDECIDED;
    std::array<Nearest_feet::Competitors, 2> competitors = {}; // that decide it, if there is an arc
    bool is_graph = false;
  };

private:
  // Of both operands.
  struct Both
  {
    Answer answer = Answer::UNKNOWN;
    std::array<int, 2> trends{};
    std::array<Nearest_feet::Competitors, 2> competitors = {};
  };

  static constexpr double least_width = 0x1p-7; // of cells, in unit boxes

  Pair m_pair;
  First& m_first;
  Second& m_second;
  double m_length = 1; // of the range of the last unknown
  Box m_box;
  std::vector<Leaf> m_leaves;

public:
  //! \pre The finders live longer; rounding is upwards, here and below.
  Sheet_labels(const Pair& pair, First& first, Second& second, const Box& box)
    : m_pair(pair), m_first(first), m_second(second), m_box(box)
  {}

  // Cuts cells as long as it helps. When the run ends, what is left is undecided.
  void run(Operation_budget& budget)
  {
    std::vector<Cell> open{Cell(m_box)};
    const Interval& x = m_box.back();
    m_length = (std::max)(x.sup() - x.inf(), 0x1p-1000);
    while (!open.empty()) {
      Cell cell = open.back();
      open.pop_back();
      if (budget.has_ended()) {
        m_leaves.push_back({cell});
        continue;
      }
      Summary work;
      work.nodes = 1;
      budget.add(work);
      cell.contract(m_pair);
      if (cell.state() == Cell::State::EMPTY)
        continue;
      cell.try_to_fill(m_pair);
      Leaf leaf{cell};
      if (!set_label(leaf))
        continue;
      if (leaf.label == Nearest_feet_label::UNDECIDED && !is_small(cell))
        cut(cell, open);
      else
        m_leaves.push_back(std::move(leaf));
    }
  }

  const std::vector<Leaf>& leaves() const { return m_leaves; }

  // The label of the solution near to unknowns in the unit boxes; none if there is no leaf.
  std::optional<Nearest_feet_label> label(const std::array<double, Pair::unknowns - 1>& at) const
  {
    std::optional<Nearest_feet_label> result;
    if (!contains(m_box, at))
      return result;
    for (const Leaf& leaf : m_leaves) {
      if (!contains(leaf.cell.box(), at))
        continue;
      Nearest_feet_label own = leaf.label;
      if (own == Nearest_feet_label::BOTH)
        own = label_beside_arc(leaf, at);
      if (own != Nearest_feet_label::UNDECIDED)
        return own;
      result = own;
    }
    return result;
  }

private:
  static bool contains(const Box& box, const std::array<double, Pair::unknowns - 1>& at)
  {
    constexpr double rounding = 0x1p-40;
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i] < box[i].inf() - rounding || at[i] > box[i].sup() + rounding)
        return false;
    return true;
  }

  double width(const Cell& cell, std::size_t i) const
  {
    return i + 1 < Pair::unknowns ? cell.width(i) : cell.width(i) / m_length;
  }

  bool is_small(const Cell& cell) const
  {
    const auto is_narrow = [&](std::size_t i) { return width(cell, i) < least_width; };
    if (cell.state() == Cell::State::GRAPH)
      return std::ranges::all_of(cell.parameters(), is_narrow);
    for (std::size_t i = 0; i < Pair::unknowns; ++i)
      if (!is_narrow(i))
        return false;
    return true;
  }

  // Beside the middle: in symmetrical scenes, labels change there.
  static std::array<Interval, 2> parts(const Interval& range)
  {
    constexpr double share = 15. / 32;
    const double middle = range.inf() + share * (range.sup() - range.inf());
    return {Interval(range.inf(), middle), Interval(middle, range.sup())};
  }

  void cut(const Cell& cell, std::vector<Cell>& open) const
  {
    if (cell.state() != Cell::State::GRAPH) {
      std::size_t widest = 0;
      for (std::size_t i = 1; i < Pair::unknowns; ++i)
        if (width(cell, i) > width(cell, widest))
          widest = i;
      for (const Interval& range : parts(cell.box()[widest]))
        open.push_back(cell.cut(widest, range));
      return;
    }
    const auto& [p, q] = cell.parameters();
    constexpr double much = 4;
    std::vector<Interval> first{cell.box()[p]}, second{cell.box()[q]};
    const auto halve = [](std::vector<Interval>& ranges) {
      const std::array<Interval, 2> halves = parts(ranges[0]);
      ranges.assign(halves.begin(), halves.end());
    };
    if (width(cell, p) * much > width(cell, q))
      halve(first);
    if (width(cell, q) * much > width(cell, p))
      halve(second);
    for (const Interval& a : first)
      for (const Interval& b : second)
        open.push_back(cell.part({a, b}));
  }

  Both verdict(const std::array<Touching_balls, 2>& balls)
  {
    Both result;
    std::array<Verdict, 2> own{m_first(balls[0]), {}};
    if (own[0].answer == Answer::NO) {
      result.answer = Answer::NO;
      return result;
    }
    own[1] = m_second(balls[1]);
    if (own[1].answer == Answer::NO) {
      result.answer = Answer::NO;
      return result;
    }
    if (own[0].answer == Answer::YES && own[1].answer == Answer::YES) {
      result.answer = Answer::YES;
      return result;
    }
    for (const std::size_t axis : {0, 1}) {
      int trend = 0;
      bool is_common = true;
      for (const Verdict& one : own)
        if (one.answer != Answer::YES) {
          is_common = is_common && one.trends[axis] != 0 && (trend == 0 || trend == one.trends[axis]);
          trend = one.trends[axis];
        }
      result.trends[axis] = is_common ? trend : 0;
    }
    for (const std::size_t k : {0, 1})
      if (own[k].answer != Answer::YES)
        result.competitors[k] = std::move(own[k].competitors);
    return result;
  }

  // False if the cell has no solutions.
  bool set_label(Leaf& leaf)
  {
    if (leaf.cell.state() != Cell::State::GRAPH)
      return true;
    const auto graph = leaf.cell.graph(m_pair);
    if (!graph)
      return true;
    leaf.is_graph = true;
    const auto balls = m_pair.balls(*graph);
    if (!balls)
      return false;
    Both both = verdict(*balls);
    if (both.answer != Answer::UNKNOWN)
      leaf.label = both.answer == Answer::YES ? Nearest_feet_label::NEAREST : Nearest_feet_label::NOT_NEAREST;
    else if (leaf.cell.is_full())
      set_arc(leaf, both);
    return true;
  }

  // If the label has a trend.
  void set_arc(Leaf& leaf, Both& both)
  {
    leaf.competitors = both.competitors;
    for (const std::size_t axis : {0, 1}) {
      if (both.trends[axis] == 0 || !(both.trends[1 - axis] != 0 || changes_once_on_sides(leaf, axis)))
        continue;
      std::array<int, 4> corners{};
      std::size_t k = 0;
      const std::array<Interval, 2> ranges{leaf.cell.box()[leaf.cell.parameters()[0]],
                                           leaf.cell.box()[leaf.cell.parameters()[1]]};
      for (const double a : {ranges[0].inf(), ranges[0].sup()})
        for (const double b : {ranges[1].inf(), ranges[1].sup()}) {
          corners[k] = sign_at(leaf, {Interval(a), Interval(b)});
          if (corners[k++] == 0)
            return;
        }
      const bool is_one = std::ranges::all_of(corners, [&](int sign) { return sign == corners[0]; });
      leaf.label = !is_one ? Nearest_feet_label::BOTH
          : corners[0] > 0 ? Nearest_feet_label::NEAREST
                           : Nearest_feet_label::NOT_NEAREST;
      return;
    }
  }

  // Whether the label changes once at most along both sides where the parameter of an axis is constant.
  bool changes_once_on_sides(const Leaf& leaf, std::size_t axis)
  {
    const Interval range = leaf.cell.box()[leaf.cell.parameters()[axis]];
    return changes_once_on_side(leaf, axis, range.inf()) && changes_once_on_side(leaf, axis, range.sup());
  }

  // In parts that are halved a few times, until they have one label or a trend.
  bool changes_once_on_side(const Leaf& leaf, std::size_t axis, double at)
  {
    constexpr int most_depth = 3;
    struct Part
    {
      Interval range;
      int depth;
    };
    const auto values = [&](const Interval& along) {
      return axis == 0 ? std::array{Interval(at), along} : std::array{along, Interval(at)};
    };
    std::vector<Part> open{{leaf.cell.box()[leaf.cell.parameters()[1 - axis]], 0}};
    int changes = 0, last = sign_at(leaf, values(Interval(open[0].range.inf())));
    while (!open.empty() && changes <= 1) {
      const auto [range, depth] = open.back();
      open.pop_back();
      const Both both = verdict_on_part(leaf.cell.part(values(range)));
      int next = both.answer == Answer::YES ? 1 : both.answer == Answer::NO ? -1 : 0;
      if (next == 0 && both.trends[1 - axis] != 0)
        next = sign_at(leaf, values(Interval(range.sup())));
      if (next == 0) {
        if (depth == most_depth)
          return false;
        const double middle = Foot_grid::midpoint(range);
        open.push_back({Interval(middle, range.sup()), depth + 1});
        open.push_back({Interval(range.inf(), middle), depth + 1});
        continue;
      }
      if (last != 0 && next != last)
        ++changes;
      last = next;
    }
    return changes <= 1;
  }

  Both verdict_on_part(Cell part)
  {
    part.contract(m_pair);
    const auto graph = part.state() == Cell::State::GRAPH ? part.graph(m_pair) : std::nullopt;
    const auto balls = graph ? m_pair.balls(*graph) : std::nullopt;
    return balls ? verdict(*balls) : Both();
  }

  // Of the least power for these values of the parameters: 1 if feet are nearest, -1 if they are not, or 0.
  int sign_at(const Leaf& leaf, const std::array<Interval, 2>& values) const
  {
    const std::optional<Box> solution = leaf.cell.solution_at(m_pair, values);
    const auto feet = solution ? m_pair.feet(*solution) : std::nullopt;
    if (!feet)
      return 0;
    typename Pair::Graph graph;
    graph.box = graph.middle = *solution;
    graph.feet = graph.middle_feet = *feet;
    graph.bounds = m_pair.bounds(*solution);
    for (auto& slopes : graph.slopes)
      slopes = {0, 0};
    graph.half_widths = {0, 0};
    const auto balls = m_pair.balls(graph);
    if (!balls)
      return 0;
    int result = 1;
    const auto take = [&](const auto& finder, std::size_t k) {
      if (!leaf.competitors[k].empty() && result >= 0)
        result = (std::min)(result, finder.least_power((*balls)[k], leaf.competitors[k]).first);
    };
    take(m_first, 0);
    take(m_second, 1);
    return result;
  }

  Nearest_feet_label label_beside_arc(const Leaf& leaf, const std::array<double, Pair::unknowns - 1>& at) const
  {
    Box point = leaf.cell.box();
    std::copy(at.begin(), at.end(), point.begin());
    const auto feet = m_pair.feet(point);
    const std::optional<Interval> steps = feet ? m_pair.steps(*feet) : std::nullopt;
    if (!steps)
      return Nearest_feet_label::UNDECIDED;
    point.back() = *steps;
    std::array<Interval, 2> values;
    for (const std::size_t k : {0, 1}) {
      const std::size_t axis = leaf.cell.parameters()[k];
      const Interval& range = leaf.cell.box()[axis];
      values[k] = (std::min)((std::max)(Foot_grid::midpoint(point[axis]), range.inf()), range.sup());
    }
    const int sign = sign_at(leaf, values);
    return sign > 0 ? Nearest_feet_label::NEAREST
        : sign < 0  ? Nearest_feet_label::NOT_NEAREST
                    : Nearest_feet_label::UNDECIDED;
  }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_SHEET_LABELS_H
