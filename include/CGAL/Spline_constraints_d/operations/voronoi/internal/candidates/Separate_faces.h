// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SEPARATE_FACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SEPARATE_FACES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Element_ways.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Arcs that disks see from a side on which another face of the planar graph is.

A disk that touches an element in X, passes through Y and has no curve inside has the chord XY inside, too: all of it
but its ends is in the face of the element. Of a face, the boundary is one cycle of elements for each connected
component of the graph. So if the chord begins, in Y, on a side of an arc that belongs to another cycle of the component
of the element, there is no such disk. In the end of the arc, the chord begins in the angle between two successive arcs,
and these have that end as well: it is left to them if the arc is not one of them, or to the other one if that is seen
from the side of the element.
*/
template <Enclosing_number Interval = Common::Interval>
class Separate_faces
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;
  bool m_is_planar;

public:
  // With scaled sites, curves may be in disks that touch others.
  Separate_faces(const Site_graph_2<Interval>& graph, bool are_any_scaled)
    : m_graph(graph), m_is_planar(graph.is_planar() && !are_any_scaled)
  {}

  // Whether an element is neither in a face on the left nor in one on the right of an arc.
  bool hold(std::size_t element, std::size_t arc) const
  {
    return m_is_planar && !may_see(element, arc, true) && !may_see(element, arc, false);
  }

  // Whether all disks that touch the part of an element, and pass through a candidate, have the chord on a side of the
  // arc where the element is not; with the middle of the part.
  bool hold(const Element_part<Interval>& part, const Element_part<Interval>& middle,
            const Disk_candidate<Interval>& candidate) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const std::size_t arc = candidate.index;
    if (!m_is_planar || candidate.kind != Disk_candidate<Interval>::Kind::ARC ||
        (!element.is_normal_cone && element.object == arc))
      return false;
    const bool is_on_left = may_see(part.element, arc, true), is_on_right = may_see(part.element, arc, false);
    if (is_on_left == is_on_right)
      return !is_on_left;
    const Interval_pair direction =
        m_graph.arcs()[arc].has_singular_end() ? m_graph.arcs()[arc].direction_over(candidate.range) : candidate.jet[1];
    if (turn_to_element(direction, part, middle, arc, candidate.range) != (is_on_left ? -1 : 1))
      return false;
    const auto is_left_out = [&](bool end) {
      return is_left_to_others(part, middle, {arc, end}, is_on_left != end);
    };
    return (candidate.range.begin > 0 || is_left_out(false)) && (candidate.range.end < 1 || is_left_out(true));
  }

private:
  bool may_see(std::size_t element, std::size_t arc, bool is_left) const
  {
    const Oriented_element<Interval> &a = m_graph.elements()[element], &b = m_graph.elements()[2 * arc + !is_left];
    return a.component != b.component || a.cycle == b.cycle;
  }

  // Whether the way from points of an arc to those of an element turns left from a vector, 1, or right, -1; by mean
  // values, as elements and arcs nearly have one direction.
  int turn_to_element(const Interval_pair& vector, const Element_part<Interval>& part,
                      const Element_part<Interval>& middle, std::size_t arc, const Range& range) const
  {
    const Interval_pair normal = turned_left(vector);
    const double v = range.middle();
    const Curve_jet<Interval> jet = m_graph.arcs()[arc].jet(range, 1),
                              jet_in_middle = range.is_number() ? jet : m_graph.arcs()[arc].jet({v, v}, 1);
    const Interval shift_u = interval_of<Interval>(part.range) - Interval(middle.range.begin),
                   shift_v = interval_of<Interval>(range) - Interval(v);
    return certain_sign(shift_u * dot(normal, part.jet.point_derivative) - shift_v * dot(normal, jet[1]) -
                        dot(normal, Element_ways<Interval>(m_graph).to_arc(middle, arc, {v, v}, jet_in_middle)));
  }

  // Whether the chords to the end of an arc begin outside of the angle between this and the next arc around the vertex,
  // which comes counterclockwise, or clockwise; or on the side of the next one where the angle is.
  bool is_left_to_others(const Element_part<Interval>& part, const Element_part<Interval>& middle, const Arc_end& end,
                         bool is_counterclockwise) const
  {
    const Oriented_element<Interval>& side = m_graph.elements()[2 * end.arc + (is_counterclockwise == end.is_end)];
    const Arc_end& next = m_graph.next_around_vertex(side, end);
    if (next == end)
      return false;
    const auto direction = [&](const Arc_end& e) {
      return Interval(e.is_end ? -1 : 1) * m_graph.arcs()[e.arc].direction_over({e.parameter(), e.parameter()});
    };
    const Interval_pair first = direction(end), last = direction(next);
    // below 180 degrees: 1
    const int way = is_counterclockwise ? 1 : -1, angle = way * certain_sign(dot(turned_left(first), last));
    const auto turn = [&](const Interval_pair& vector) {
      return way * turn_to_element(vector, part, middle, end.arc, {end.parameter(), end.parameter()});
    };
    const int turn_from_next = turn(last);
    return turn_from_next < 0 || (angle > 0 && (turn_from_next > 0 || turn(first) < 0)) ||
        (angle < 0 && turn_from_next > 0 && turn(first) < 0);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SEPARATE_FACES_H
