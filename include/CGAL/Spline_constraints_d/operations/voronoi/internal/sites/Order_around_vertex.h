// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ORDER_AROUND_VERTEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ORDER_AROUND_VERTEX_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Arc_germ.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Oriented_element_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The order of the arcs around a vertex of a planar graph, counterclockwise.
*/
template <Enclosing_number Interval, class Graph>
class Order_around_vertex
{
  const Graph& m_graph;

public:
  explicit Order_around_vertex(const Graph& graph) : m_graph(graph) {}

  // By directions, and by germs where these are equal. Returns whether there is one order.
  bool sort(std::vector<Arc_end>& ends) const
  {
    const auto is_before = [&](const Arc_end& a, const Arc_end& b) {
      const Exact_pair &p = m_graph.direction(a), &q = m_graph.direction(b);
      if (half_of_directions(p) != half_of_directions(q))
        return half_of_directions(p) < half_of_directions(q);
      const int turn = sign_of(exact_cross(p, q));
      return turn != 0 ? turn > 0 : is_germ_before(a, b);
    };
    std::stable_sort(ends.begin(), ends.end(), is_before);
    return std::adjacent_find(ends.begin(), ends.end(),
                              [&](const Arc_end& a, const Arc_end& b) { return !is_before(a, b); }) == ends.end();
  }

  // Whether the angles between successive arcs are the same for the ends of the arcs and those of their pieces: less
  // than 180 degrees, or that because one curve passes.
  bool is_proved(const std::vector<Arc_end>& ends) const
  {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const Arc_end &a = ends[i], &b = ends[(i + 1) % ends.size()];
      if (m_graph.is_exact(a) && m_graph.is_exact(b))
        continue;
      const auto way = [&](const Arc_end& end) {
        return Interval(end.is_end ? -1 : 1) * m_graph.arcs()[end.arc].jet({end.parameter(), end.parameter()}, 1)[1];
      };
      const bool is_one_curve = sign_of(exact_cross(m_graph.direction(a), m_graph.direction(b))) == 0 &&
          a.is_end != b.is_end && (a.is_end ? b.arc == a.arc + 1 : a.arc == b.arc + 1);
      if (!is_one_curve && certain_sign(dot(turned_left(way(a)), way(b))) <= 0)
        return false;
    }
    return true;
  }

private:
  // Of arcs that leave a vertex in one direction. Others than pieces of one curve have no more coefficients in common
  // than their degrees allow.
  bool is_germ_before(const Arc_end& a, const Arc_end& b) const
  {
    if (!m_graph.is_exact(a) || !m_graph.is_exact(b))
      return false;
    const std::size_t order =
        static_cast<std::size_t>(m_graph.arcs()[a.arc].degree() * m_graph.arcs()[b.arc].degree()) + 1;
    return Arc_germ(m_graph.arcs()[a.arc], a.is_end, order) < Arc_germ(m_graph.arcs()[b.arc], b.is_end, order);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_ORDER_AROUND_VERTEX_H
