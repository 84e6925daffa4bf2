// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_GRAPH_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_GRAPH_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Convolution_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Vertex_classes.h>
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
namespace Minkowski_sum {

/*
Pieces of a convolution, cut where they pass rational points that others end in, so that pieces which are the same along
a part are the same as a whole. One of those with the same direction is kept, and none of those with opposite
directions, as the sum is on both sides then. Ends that are proved to be the same point have the same number.
*/
class Convolution_graph_2
{
  std::vector<Convolution_piece_2> m_pieces;
  std::vector<std::array<std::size_t, 2>> m_vertices;   // at the ends of the pieces
  std::size_t m_number_of_vertices = 0;

public:
  // \throws Run_stopped
  Convolution_graph_2(std::vector<Convolution_piece_2> pieces, Run_of_steps& control) : m_pieces(std::move(pieces))
  {
    std::vector<Exact_pair> points;
    for (Convolution_piece_2& piece : m_pieces) {
      control.check();
      piece.find_end_points();
      for (const int e : {0, 1})
        if (piece.end(e).point)
          points.push_back(*piece.end(e).point);
    }
    if (!split_at(points, control))
      join_pieces(control);
  }

  const std::vector<Convolution_piece_2>& pieces() const { return m_pieces; }
  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  std::size_t vertex(std::size_t piece, int end) const { return m_vertices[piece][static_cast<std::size_t>(end)]; }

  // Cuts pieces at points that they have in common with others. Returns whether there are any.
  // \throws Run_stopped
  bool split_at(std::vector<Exact_pair> points, Run_of_steps& control)
  {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    std::vector<Interval_pair> boxes = boxes_of_pieces();
    bool result = false;
    for (const Exact_pair& point : points) {
      control.check();
      result = split_at(point, boxes) || result;
    }
    if (result)
      join_pieces(control);
    return result;
  }

private:
  std::vector<Interval_pair> boxes_of_pieces() const
  {
    std::vector<Interval_pair> result;
    for (const Convolution_piece_2& piece : m_pieces)
      result.push_back(piece(piece.range()).point);
    return result;
  }

  static bool ends_in(const Convolution_piece_2& piece, const Exact_pair& point)
  {
    return piece.end(0).point == point || piece.end(1).point == point;
  }

  bool split_at(const Exact_pair& point, std::vector<Interval_pair>& boxes)
  {
    const Interval_pair p{interval_of(point[0]), interval_of(point[1])};
    std::size_t ends = 0;
    std::vector<std::pair<std::size_t, Exact_rational>> cuts;
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (may_meet(p, boxes[i])) {
        if (ends_in(m_pieces[i], point))
          ++ends;
        else if (const auto t = m_pieces[i].parameter_of(point))
          cuts.emplace_back(i, *t);
      }
    if (ends + cuts.size() < 2)
      return false;
    for (const auto& [i, t] : cuts) {
      const std::array<Convolution_piece_2, 2> parts = m_pieces[i].split(t, point);
      m_pieces[i] = parts[0];
      m_pieces.push_back(parts[1]);
      boxes.push_back(boxes[i]);
    }
    return !cuts.empty();
  }

  // Numbers the ends, and removes pieces that are the same as others. Most pairs have no point in common.
  void join_pieces(Run_of_steps& control)
  {
    const std::size_t n = m_pieces.size();
    const std::vector<Interval_pair> boxes = boxes_of_pieces();
    Vertex_classes ends(2 * n);
    std::vector<bool> is_removed(n, false);
    for (std::size_t i = 0; i < n; ++i) {
      control.check();
      for (std::size_t j = i + 1; j < n; ++j) {
        if (!may_meet(boxes[i], boxes[j]))
          continue;
        for (const int d : {0, 1})
          for (const int e : {0, 1})
            if (are_same(m_pieces[i], d, m_pieces[j], e))
              ends.join(2 * i + d, 2 * j + e);
        if (are_opposite(m_pieces[i], m_pieces[j]))
          is_removed[i] = is_removed[j] = true;
        else if (are_equal(m_pieces[i], m_pieces[j])) {
          is_removed[j] = true;
          ends.join(2 * i, 2 * j);
          ends.join(2 * i + 1, 2 * j + 1);
        }
      }
    }
    std::vector<Convolution_piece_2> kept;
    m_vertices.clear();
    for (std::size_t i = 0; i < n; ++i)
      if (!is_removed[i]) {
        kept.push_back(m_pieces[i]);
        m_vertices.push_back({ends.of(2 * i), ends.of(2 * i + 1)});
      }
    m_pieces = std::move(kept);
    m_number_of_vertices = 2 * n;
  }

  static bool are_same(const Convolution_piece_2& p, int p_end, const Convolution_piece_2& q, int q_end)
  {
    const auto &a = p.end(p_end).point, &b = q.end(q_end).point;
    return a && b ? *a == *b : Convolution_piece_2::are_same(p, p_end, q, q_end);
  }

  // Whether two pieces are the same curve with the same direction.
  static bool are_equal(const Convolution_piece_2& p, const Convolution_piece_2& q)
  {
    return (are_same(p, 0, q, 0) && are_same(p, 1, q, 1) && are_on_same_curve(p, q, false)) ||
        have_equal_ranges(p, q) || have_same_directions(p, q, false);
  }

  static bool are_opposite(const Convolution_piece_2& p, const Convolution_piece_2& q)
  {
    return (are_same(p, 0, q, 1) && are_same(p, 1, q, 0) && are_on_same_curve(p, q, true)) ||
        have_same_directions(p, q, true);
  }

  // Of two pieces with the same ends. Circles through two points are the same if they have the same tangent in one of
  // them.
  static bool are_on_same_curve(const Convolution_piece_2& p, const Convolution_piece_2& q, bool are_opposite)
  {
    if (p.is_straight() || q.is_straight())
      return p.is_straight() && q.is_straight();
    const auto &d = p.end(0).direction, &e = q.end(are_opposite ? 1 : 0).direction;
    if (p.is_circular() && q.is_circular() && d && e && sign_of(exact_cross(*d, *e)) == 0)
      return true;
    return have_same_operands(p, q, are_opposite);
  }

  // Whether the arcs of two pieces are the same up to translations that cancel out.
  static bool have_same_operands(const Convolution_piece_2& p, const Convolution_piece_2& q, bool are_opposite)
  {
    if (p.has_corner() != q.has_corner())
      return false;
    const auto moving = translation(p.moving_arc(), q.moving_arc(), are_opposite);
    const auto turning = p.has_corner() ? std::optional(exact_difference(q.turning_arc().at(1), p.turning_arc().at(1)))
                                        : translation(p.turning_arc(), q.turning_arc(), are_opposite);
    return moving && turning && sign_of((*moving)[0] + (*turning)[0]) == 0 &&
        sign_of((*moving)[1] + (*turning)[1]) == 0;
  }

  /*
  Where ends are not rational, but those of sums of the same curves, and have the same directions, or opposite ones:
  elements that overlap have each direction once together. Turning arcs, which turn to the left, are not there in
  opposite directions.
  */
  static bool have_same_directions(const Convolution_piece_2& p, const Convolution_piece_2& q, bool are_opposite)
  {
    for (const int e : {0, 1}) {
      const auto &d = p.end(e).direction, &f = q.end(are_opposite ? 1 - e : e).direction;
      if (!d || !f || sign_of(exact_cross(*d, *f)) != 0 || sign_of(exact_dot(*d, *f)) != (are_opposite ? -1 : 1))
        return false;
    }
    const auto overlap = [](const Region_element& a, const Region_element& b, bool is_reversed) {
      const Range other = is_reversed ? Range{1 - b.range.end, 1 - b.range.begin} : b.range;
      return (a.turn == Turn::LEFT || a.turn == Turn::RIGHT) && a.range.begin < other.end && other.begin < a.range.end;
    };
    const bool have_corners = p.has_corner() && q.has_corner();
    return (have_corners ||
            (!are_opposite && !p.has_corner() && !q.has_corner() &&
             overlap(p.turning_element(), q.turning_element(), false))) &&
        overlap(p.moving_element(), q.moving_element(), are_opposite) && have_same_operands(p, q, are_opposite);
  }

  // Where ends are not rational, both are the points with the same exact direction, at the same inflection, or cut at
  // the same parameter of the moving arc, which is a number or the only cusp in its range.
  static bool have_equal_ranges(const Convolution_piece_2& p, const Convolution_piece_2& q)
  {
    for (const int e : {0, 1}) {
      const Convolution_end &a = p.end(e), &b = q.end(e);
      const bool has_direction = a.direction && b.direction && are_parallel(*a.direction, *b.direction),
                 is_at_inflection = a.inflection && a.inflection == b.inflection,
                 is_cut = !a.direction && !b.direction && a.inflection == b.inflection;
      if (a.range.begin != b.range.begin || a.range.end != b.range.end ||
          !(has_direction || is_at_inflection || is_cut))
        return false;
    }
    // which has each direction once
    const Range &turning = p.turning_element().range, &other = q.turning_element().range;
    return turning.begin == other.begin && turning.end == other.end && have_same_operands(p, q, false);
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CONVOLUTION_GRAPH_2_H
