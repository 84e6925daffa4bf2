// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_COMMON_VERTEX_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_COMMON_VERTEX_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Normal_cone_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
What is known of the disks that touch an element and pass through points of an arc, where the element begins or ends in
an end of the arc (see Disk_curvature, for the notation, too).
*/
template <Enclosing_number Interval = Common::Interval>
class Common_vertex_disks
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;

public:
  explicit Common_vertex_disks(const Site_graph_2<Interval>& graph) : m_graph(graph) {}

  // Adds it to bounds, for a part of an element and a range of the arc.
  void add(Curvature_bounds<Interval>& result, const Element_part<Interval>& part, const Arc_end& end,
           const Range& range) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const std::size_t vertex = m_graph.vertex_of(end);
    const Range to_vertex = united(range, {end.parameter(), end.parameter()});
    if (element.is_normal_cone) {
      if (element.object == vertex)
        at_normal_cone(result, part, element, end, range);
      return;
    }
    for (const bool is_end : {false, true}) {
      const Arc_end own{element.object, is_end};
      if (m_graph.vertex_of(own) != vertex || own == end)
        continue;
      const Range own_to_vertex = united(part.range, {own.parameter(), own.parameter()});
      const Smooth_continuation<Interval>* next = m_graph.continuations(own).smooth_at(end);
      if (next != nullptr && m_graph.is_regular(own) && m_graph.is_regular(end))
        result.value = common_part(result.value, across_smooth_joint(part, own, own_to_vertex, *next, to_vertex));
      else if (const auto& nearly = m_graph.nearly_smooth_continuation(own); nearly && nearly->end == end)
        result.value = common_part(result.value, across_nearly_smooth_joint(part, own, *nearly, range));
      else if (own_to_vertex.width() == part.range.width() && to_vertex.width() == range.width())
        at_corner(result, part, own, end, range);
    }
  }

private:
  // D and E on the way through the vertex, with a parameter in which the derivative has no jump.
  Interval across_smooth_joint(const Element_part<Interval>& part, const Arc_end& own, const Range& own_range,
                               const Smooth_continuation<Interval>& continuation, const Range& range) const
  {
    return across_joint(part, own, own_range, continuation.end, range, Interval(1) / continuation.speed_ratio,
                        Interval(0));
  }

  /*
  The same with a jump J of the derivative, at the distance a from X and b from Y: E gets the term <N, J> b / (a + b)^2.
  It is large only in a small neighbourhood of the vertex, where J is small.
  */
  Interval across_nearly_smooth_joint(const Element_part<Interval>& part, const Arc_end& own,
                                      const Nearly_smooth_continuation<Interval>& continuation,
                                      const Range& range) const
  {
    const Interval scale(continuation.scale);
    const double a = distance(own, part.range).inf();
    const Interval distances = distance(continuation.end, range) / scale;
    const double b = std::clamp(a, distances.inf(), distances.sup());   // where the term is greatest
    const Interval jump = dot(part.jet.normal, continuation.jump);
    const Interval term = a + b > 0 ? jump * Interval(0, (Interval(b) / CGAL::square(Interval(a) + Interval(b))).sup())
                                    : number_of_sign(certain_sign(jump));
    const Range own_range = united(part.range, {own.parameter(), own.parameter()}),
                other_range = united(range, {continuation.end.parameter(), continuation.end.parameter()});
    return across_joint(part, own, own_range, continuation.end, other_range, scale, term);
  }

  Interval across_joint(const Element_part<Interval>& part, const Arc_end& own, const Range& own_range,
                        const Arc_end& other, const Range& range, const Interval& scale, const Interval& jump) const
  {
    const Curve_jet<Interval> x = m_graph.arcs()[own.arc].jet(own_range, 2),
                              y = m_graph.arcs()[other.arc].jet(range, 2);
    const Interval to_end(own.is_end ? 1 : -1), away(other.is_end ? -1 : 1);
    const Interval q = squared_norm(hull(to_end * x[1], (away * scale) * y[1]));
    const Interval bend = CGAL::square(scale) * dot(part.jet.normal, y[2]);
    return q.inf() > 0
        ? ((own_range.is_number() ? bend : hull(dot(part.jet.normal, x[2]), bend)) + Interval(2) * jump) / q
        : any_number<Interval>();
  }

  // A number of which only the sign is known, or not even that.
  static Interval number_of_sign(int sign)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return Interval(sign > 0 ? 0 : -infinity, sign < 0 ? 0 : infinity);
  }

  // From an end of an arc, of the parameters of a range.
  static Interval distance(const Arc_end& end, const Range& range)
  {
    return end.is_end ? Interval(1) - interval_of<Interval>(range) : interval_of<Interval>(range);
  }

  // Below the half-plane of the normal, or perpendicular to the first or last normal of the normal cone.
  void at_normal_cone(Curvature_bounds<Interval>& result, const Element_part<Interval>& part,
                      const Oriented_element<Interval>& element, const Arc_end& end, const Range& range) const
  {
    const Range to_vertex = united(range, {end.parameter(), end.parameter()});
    const Site_arc_2<Interval>& arc = m_graph.arcs()[end.arc];
    const Curve_jet<Interval> y = arc.jet(to_vertex, 2);
    // the outgoing mean derivative, up to a positive factor
    const Interval_pair b =
        Interval(end.is_end ? -1 : 1) * (arc.has_singular_end() ? arc.direction_over(to_vertex) : y[1]);
    if (dot(part.jet.normal, b).sup() < 0)
      result.value = common_part(result.value, number_of_sign(-1));
    if (!m_graph.is_regular(end))
      return;
    // The arc begins below the half-plane of the normal, if only by a small angle.
    if (const Interval q = squared_norm(y[1]); q.inf() > 0)
      result.value = common_part(
          result.value, Interval(-std::numeric_limits<double>::infinity(), (dot(part.jet.normal, y[2]) / q).sup()));
    for (const bool k : {false, true})
      if (m_graph.is_perpendicular(element, k, end)) {
        const Normal_cone_disks<Interval> disks(m_graph, part, k, end, range);
        Curvature_bounds<Interval> more = disks.bounds();
        const bool touches_vertex = end.is_end ? range.end == 1 : range.begin == 0;
        if (touches_vertex && disks.is_increasing())
          more.dv = common_part(
              more.dv,
              end.is_end ? Interval(-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::min())
                         : Interval(std::numeric_limits<double>::min(), std::numeric_limits<double>::infinity()));
        add_by_tangent(result, more, arc, range);
      }
  }

  /*
  p - X = s D and Y - p = t B: <N, Y - X> = s^2 E + t <N, B>, where E belongs to the disk through p. Behind a convex
  corner <N, B> < 0. Then k < 0 if E <= 0; else k is less than that of the disk through p if
  <N, B> |D|^2 <= 2 s E <B, D>; for t and B any number and direction with that product will do.
  */
  void at_corner(Curvature_bounds<Interval>& result, const Element_part<Interval>& part, const Arc_end& own,
                 const Arc_end& other, const Range& range) const
  {
    const Curve_jet<Interval> x = m_graph.arcs()[own.arc].jet(part.range, 2);
    const Interval_pair d = Interval(own.is_end ? 1 : -1) * x[1],
                        b = Interval(other.is_end ? -1 : 1) * m_graph.arcs()[other.arc].direction_over(range);
    const Interval nb = dot(part.jet.normal, b), e = dot(part.jet.normal, x[2]) / Interval(2);
    if (!(nb.sup() < 0))
      return;
    const Interval s(part.range.width());
    const Interval turn = Interval(2) * s * Interval((std::max)(e.sup(), 0.0)) * dot(b, d), square = squared_norm(d);
    result.is_below_vertex = e.sup() <= 0 || nb.sup() * square.inf() <= (std::min)(turn.inf(), 0.0);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_COMMON_VERTEX_DISKS_H
