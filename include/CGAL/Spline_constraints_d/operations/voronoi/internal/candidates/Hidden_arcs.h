// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_HIDDEN_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_HIDDEN_ARCS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Arcs that leave an end of the arc of an element on its other side, if only by a tiny angle.

A disk that touches the element in X, and has none of its arc inside, lies beyond the arc where both are graphs over the
tangent in X. An arc that begins in the end P on the other side stays there, as it meets that of the element only in
ends, if the graph is planar; so where it goes away from P along the tangent, no farther than the arc of the element
does, no such disk passes through it.
*/
template <Enclosing_number Interval>
class Hidden_arcs
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;

public:
  explicit Hidden_arcs(const Site_graph_2<Interval>& graph) : m_graph(graph) {}

  // Whether no disk that touches the part of an element, and has no curve inside, passes through a candidate.
  bool hold(const Element_part<Interval>& part, const Disk_candidate<Interval>& candidate) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (element.is_normal_cone || candidate.kind != Disk_candidate<Interval>::Kind::ARC ||
        candidate.index == element.object || !m_graph.is_planar())
      return false;
    for (const bool own_end : {false, true})
      for (const bool end : {false, true})
        if (const Arc_end own{element.object, own_end}, other{candidate.index, end};
            m_graph.vertex_of(own) == m_graph.vertex_of(other) && is_on_other_side(element, own, other) &&
            is_along(part, own, other, candidate.range))
          return true;
    return false;
  }

private:
  static Interval sign_away(const Arc_end& end) { return Interval(end.is_end ? -1 : 1); }

  static Range up_to(const Arc_end& end, double way) { return end.is_end ? Range{1 - way, 1} : Range{0, way}; }

  // Whether an arc leaves the common vertex on the side on which the disks of an element are not.
  bool is_on_other_side(const Oriented_element<Interval>& element, const Arc_end& own, const Arc_end& other) const
  {
    const int side = element.is_reversed == own.is_end ? 1 : -1;   // of the disks, seen from the vertex: 1 left
    const auto direction = [&](const Arc_end& end) {
      return sign_away(end) * m_graph.arcs()[end.arc].direction_over({end.parameter(), end.parameter()});
    };
    int turn = certain_sign(dot(turned_left(direction(own)), direction(other)));
    if (turn == 0 && m_graph.is_exact(own) && m_graph.is_exact(other))
      turn = sign_of(exact_cross(m_graph.direction(own), m_graph.direction(other)));
    return turn == -side;
  }

  // Whether an arc, up to the end of a range, goes along the tangents of the part from the common vertex on, and the
  // arc of the element does so farther.
  bool is_along(const Element_part<Interval>& part, const Arc_end& own, const Arc_end& other, const Range& range) const
  {
    constexpr double least_way = 1.0 / 8;   // of the arc of the element
    const Site_arc_2<Interval> &x = m_graph.arcs()[own.arc], &y = m_graph.arcs()[other.arc];
    const double reached = other.is_end ? range.begin : range.end, way = other.is_end ? 1 - reached : reached,
                 least = (std::max)(least_way, own.is_end ? 1 - part.range.begin : part.range.end);
    // what is cut in a rounded parameter may go on behind a crossing
    if (!(m_graph.are_ends_exact(own.arc) && m_graph.are_ends_exact(other.arc)) && way > 0.5)
      return false;
    const Interval_pair tangent = sign_away(own) * x.direction_over(part.range);
    if (!(dot(sign_away(other) * y.direction_over(united(range, {other.parameter(), other.parameter()})), tangent)
              .inf() > 0))
      return false;
    const Interval_pair last = y.point({reached, reached});
    for (double w = 1; w >= least; w /= 2)
      if (const double end = own.is_end ? 1 - w : w; dot(x.point({end, end}) - last, tangent).inf() > 0 &&
          dot(sign_away(own) * x.direction_over(up_to(own, w)), tangent).inf() > 0)
        return true;
    return false;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_HIDDEN_ARCS_H
