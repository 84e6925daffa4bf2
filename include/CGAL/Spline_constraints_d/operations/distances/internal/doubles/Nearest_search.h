// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_SEARCH_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Piece_search.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Rounded_spline.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// A point as an operand: its pyramid is one box.
template <int d>
class Point_operand
{
  Rounded_point<d> m_point;
  typename Rounded_spline<d>::Node m_node;

  // Nearest doubles, with their error.
  Point_operand(const std::array<double, d>& coordinates, double error)
    : m_point(coordinates, error), m_node{{coordinates, coordinates}, -1, {0, 0}, {1, 1}}
  {
    for (int i = 0; i < d; ++i) {
      m_node.box.lower[i] = -(error - coordinates[i]);
      m_node.box.upper[i] += error;
    }
  }

  template <class NT>
  static std::array<double, d> rounded(const std::array<NT, d>& point)
  {
    std::array<double, d> result;
    std::transform(point.begin(), point.end(), result.begin(), nearest_double<NT>);
    return result;
  }

  template <class NT>
  static double error_of(const std::array<NT, d>& point, const std::array<double, d>& rounded)
  {
    return std::equal(point.begin(), point.end(), rounded.begin(), is_double<NT>)
        ? 0
        : unit * greatest_magnitude(rounded.data(), d) + (std::numeric_limits<double>::min)();
  }

public:
  template <class NT>
  explicit Point_operand(const std::array<NT, d>& point)
    : Point_operand(rounded(point), error_of(point, rounded(point)))
  {}

  bool is_usable() const
  {
    return std::all_of(m_point.coordinates().begin(), m_point.coordinates().end(),
                       [](double x) { return std::isfinite(x); });
  }
  int number_of_axes() const { return 0; }
  int number_of_cells(int) const { return 1; }
  Closedness closedness(int) const { return Closedness::OPEN; }
  const Rounded_piece<d>& piece(const std::array<int, 2>&) const { return m_point.piece(); }
  const typename Rounded_spline<d>::Node& node(int) const { return m_node; }
};

/*
All pairs of points of two operands that may be nearest, in doubles with certain bounds: pairs of pieces whose boxes are
near enough, by descent in both pyramids, and what a `Piece_search` finds in them.
*/
template <int d>
class Nearest_search
{
  using Candidate = Nearest_candidate<d>;
  using Node = typename Rounded_spline<d>::Node;

  struct Task
  {
    double lower; // bound of squared distances
    int a, b;     // nodes
  };

  Piece_search<d> m_search;
  std::vector<Task> m_tasks;
  bool m_is_decided = false;

public:
  // Rounding has to be upward. Storage of earlier calls is used again.
  template <class A, class B>
  void find(const A& a, const B& b)
  {
    m_search.restart();
    m_tasks.clear();
    m_tasks.push_back({squared_distance(a.node(0), b.node(0)), 0, 0});
    while (!m_tasks.empty()) {
      const Task task = m_tasks.back();
      m_tasks.pop_back();
      const Node &first = a.node(task.a), &second = b.node(task.b);
      if (task.lower > m_search.upper())
        continue;
      if (first.child < 0 && second.child < 0)
        m_search.search(a.piece(first.cell), b.piece(second.cell), {first.cell, second.cell});
      else if (second.child < 0 || (first.child >= 0 && width(first) >= width(second)))
        push(a, b, {first.child, task.b}, {first.child + 1, task.b});
      else
        push(a, b, {task.a, second.child}, {task.a, second.child + 1});
    }
    std::erase_if(candidates(), [&](const Candidate& c) { return c.squared_distance.inf() > m_search.upper(); });
    keep_common_candidates(a, b);
    m_is_decided = m_is_decided && !candidates().empty();
  }

  // Whether all nearest points are candidates.
  bool is_decided() const { return m_is_decided; }

  // Pairs of points of which no other one is known to be nearer.
  std::vector<Candidate>& candidates() { return m_search.candidates(); }
  const std::vector<Candidate>& candidates() const { return m_search.candidates(); }

  // The square of the least distance.
  Interval squared_distance() const
  {
    double lower = (std::min)(m_search.undecided(), m_search.upper());
    for (const Candidate& candidate : candidates())
      lower = (std::min)(lower, candidate.squared_distance.inf());
    return {(std::max)(lower, 0.0), m_search.upper()};
  }

  // Two points at the upper end of that range, nearly.
  const Candidate& best() const { return m_search.best(); }

  std::size_t number_of_parts() const { return m_search.number_of_parts(); }

private:
  template <class A, class B>
  void push(const A& a, const B& b, const std::array<int, 2>& one, const std::array<int, 2>& other)
  {
    Task near{squared_distance(a.node(one[0]), b.node(one[1])), one[0], one[1]},
        far{squared_distance(a.node(other[0]), b.node(other[1])), other[0], other[1]};
    if (near.lower > far.lower)
      std::swap(near, far);
    for (const Task& task : {far, near}) // the last one comes next
      if (!(task.lower > m_search.upper()))
        m_tasks.push_back(task);
  }

  // A lower bound; rounding is upward.
  static double squared_distance(const Node& a, const Node& b)
  {
    double result = 0;
    for (int i = 0; i < d; ++i) {
      const double gap = (std::max)(a.box.lower[i] - b.box.upper[i], b.box.lower[i] - a.box.upper[i]);
      result += gap > 0 ? gap * gap : 0;
    }
    return result * (1 - 16 * unit);
  }

  static double width(const Node& node)
  {
    double result = 0;
    for (int i = 0; i < d; ++i)
      result = (std::max)(result, node.box.upper[i] - node.box.lower[i]);
    return result;
  }

  // A parameter of a candidate: the operand and axis it belongs to.
  template <class A>
  static std::array<int, 2> place_of(const A& a, int parameter)
  {
    return parameter < a.number_of_axes() ? std::array{0, parameter} : std::array{1, parameter - a.number_of_axes()};
  }

  /*
  A nearest point on a break is one of all pieces that meet there, so each of their searches has found it. If one has
  not, the point is none; if all have, it counts once, with the lower parameter at a seam.
  */
  template <class A, class B>
  void keep_common_candidates(const A& a, const B& b)
  {
    const int parameters = a.number_of_axes() + b.number_of_axes();
    const auto cells = [&](const std::array<int, 2>& place) {
      return place[0] == 0 ? a.number_of_cells(place[1]) : b.number_of_cells(place[1]);
    };
    const auto closedness = [&](const std::array<int, 2>& place) {
      return place[0] == 0 ? a.closedness(place[1]) : b.closedness(place[1]);
    };
    const auto is_closed = [&](const std::array<int, 2>& place) { return closedness(place) == Closedness::CLOSED; };
    const auto break_of = [&](const Candidate& c, int parameter, const std::array<int, 2>& place) {
      const int result = c.cells[place[0]][place[1]] + c.sides[parameter];
      return is_closed(place) && result == cells(place) ? 0 : result;
    };
    const auto is_same = [&](const Candidate& x, const Candidate& y) {
      for (int i = 0; i < parameters; ++i) {
        const auto place = place_of(a, i);
        const bool is_inside = x.sides[i] < 0;
        if (is_inside != (y.sides[i] < 0))
          return false;
        if (is_inside ? x.cells[place[0]][place[1]] != y.cells[place[0]][place[1]] ||
                    x.ranges[i].upper < y.ranges[i].lower || y.ranges[i].upper < x.ranges[i].lower
                      : break_of(x, i, place) != break_of(y, i, place))
          return false;
      }
      return true;
    };
    const auto pieces_at = [&](const Candidate& c) {
      std::ptrdiff_t result = 1;
      for (int i = 0; i < parameters; ++i)
        if (const auto place = place_of(a, i); c.sides[i] >= 0) {
          const int at = break_of(c, i, place);
          result *= is_closed(place) || (at > 0 && at < cells(place)) ? 2 : 1;
        }
      return result;
    };
    const auto may_be_at_seam = [&](const Candidate& c) {
      for (int i = 0; i < parameters; ++i)
        if (const auto place = place_of(a, i); c.sides[i] >= 0 && closedness(place) == Closedness::UNKNOWN)
          if (const int at = break_of(c, i, place); at == 0 || at == cells(place))
            return true;
      return false;
    };
    const auto is_before = [](const Candidate& x, const Candidate& y) {
      return std::tie(x.cells, x.parameters) < std::tie(y.cells, y.parameters);
    };
    std::vector<Candidate>& all = candidates();
    m_is_decided = m_search.undecided() > m_search.upper() && std::none_of(all.begin(), all.end(), may_be_at_seam);
    if (std::all_of(all.begin(), all.end(), [&](const Candidate& c) { return pieces_at(c) == 1; }))
      return;
    std::sort(all.begin(), all.end(), is_before);
    for (std::size_t i = 0; i < all.size();) {
      const Candidate first = all[i];
      const auto is_one = [&](const Candidate& c) { return is_same(first, c); };
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(i);
      const bool is_nearest = std::count_if(begin, all.end(), is_one) >= pieces_at(first);
      all.erase(std::remove_if(begin + 1, all.end(), is_one), all.end());
      if (is_nearest)
        ++i;
      else
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_SEARCH_H
