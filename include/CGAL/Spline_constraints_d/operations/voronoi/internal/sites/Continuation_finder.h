// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CONTINUATION_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CONTINUATION_FINDER_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Arc_germ.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Oriented_element_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_vertex_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
How arcs go on beyond the vertices of a planar graph, smoothly or nearly so.
*/
template <Enclosing_number Interval, class Graph>
class Continuation_finder
{
  using Vertex = Site_vertex<Interval>;

  const Graph& m_graph;

public:
  explicit Continuation_finder(const Graph& graph) : m_graph(graph) {}

  // Adds them to `continuations`, of each arc and end.
  void append(const Vertex& vertex, std::vector<std::array<Arc_continuations<Interval>, 2>>& continuations) const
  {
    for (const Arc_end& a : vertex.ends)
      for (const Arc_end& b : vertex.ends) {
        const Exact_pair p = m_graph.direction(a), q = m_graph.direction(b);
        if (sign_of(exact_dot(p, q)) >= 0)
          continue;
        const Exact_pair s = m_graph.arcs()[a.arc].derivative_at(a.is_end),
                         t = m_graph.arcs()[b.arc].derivative_at(b.is_end);
        const std::size_t k = CGAL::abs(s[0]) < CGAL::abs(s[1]);
        const int turn = sign_of(exact_cross(p, q));
        const bool has_ratio = sign_of(s[k]) != 0 && sign_of(t[k]) != 0;
        if (!has_ratio && m_graph.is_regular(a) && m_graph.is_regular(b))
          continue;
        const Exact_rational ratio = has_ratio ? CGAL::abs(Exact_rational(t[k] / s[k])) : Exact_rational(0);
        if (turn == 0) {
          const Smooth_continuation<Interval> next{b,
                                                   !has_ratio ? any_number<Interval>()
                                                       : m_graph.is_exact(a) && m_graph.is_exact(b)
                                                       ? interval_of<Interval>(ratio)
                                                       : ratio_of_speeds(a, b, k)};
          const bool goes_on = goes_on_as(vertex, a, b) && goes_on_as(vertex, b, a);
          if (goes_on)
            continuations[a.arc][a.is_end].only = next;
          if (goes_on || (m_graph.is_exact(a) && m_graph.is_exact(b)))
            continuations[a.arc][a.is_end].smooth.push_back(next);
        } else if (has_ratio && vertex.ends.size() == 2 && is_small_turn(p, q))
          continuations[a.arc][a.is_end].nearly_smooth =
              nearly_smooth_continuation(a, b, s, t, 1 / CGAL::to_double(ratio), turn > 0);
      }
  }

private:
  // Which of several opposite arcs goes on as another one: that next to it around the vertex; if there is one on each
  // side, that of the same curve.
  bool goes_on_as(const Vertex& vertex, const Arc_end& a, const Arc_end& b) const
  {
    const auto is_opposite = [&](const Arc_end& end) {
      return are_same_directions(m_graph.direction(end), m_graph.direction(b));
    };
    if (std::count_if(vertex.ends.begin(), vertex.ends.end(), is_opposite) == 1)
      return true;
    const Oriented_element<Interval> left{false, a.arc, !a.is_end}, right{false, a.arc, a.is_end};
    const Arc_end &next = m_graph.next_around_vertex(left, a), &last = m_graph.next_around_vertex(right, a);
    return (b == next || b == last) &&
        (!is_opposite(next) || !is_opposite(last) ||
         (m_graph.curve_of_arc(a.arc) == m_graph.curve_of_arc(b.arc) && a.is_end != b.is_end));
  }

  // Of absolute values.
  Interval ratio_of_speeds(const Arc_end& a, const Arc_end& b, std::size_t coordinate) const
  {
    const auto speed = [&](const Arc_end& end) {
      return CGAL::sqrt(
          CGAL::square(m_graph.arcs()[end.arc].jet({end.parameter(), end.parameter()}, 1)[1][coordinate]));
    };
    return speed(b) / speed(a);
  }

  // From the derivatives of both arcs.
  static Nearly_smooth_continuation<Interval> nearly_smooth_continuation(const Arc_end& a, const Arc_end& b,
                                                                         const Exact_pair& s, const Exact_pair& t,
                                                                         double scale, bool is_left_reflex)
  {
    const Exact_rational to_end(a.is_end ? 1 : -1), away(b.is_end ? -scale : scale);
    const auto jump = [&](std::size_t k) { return interval_of<Interval>(Exact_rational(away * t[k] - to_end * s[k])); };
    return {b, scale, {jump(0), jump(1)}, is_left_reflex};
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CONTINUATION_FINDER_H
