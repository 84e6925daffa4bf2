// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SINGULAR_ENDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SINGULAR_ENDS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
What is known next to ends of arcs in which the derivative is zero, and the curvature infinite: X' = m D with a factor m
>= 0 that is zero there, and a direction D.

The curvature of a disk through two points near such an end is a quotient of two numbers that are both nearly zero. But
from the element with the normal N in a point X(u), which is perpendicular to D(u), Y(v) - X(u) is the integral of m D,
and <N, D(s)> = (s - u) <N, D'> for some D' between: where <N, D'> <= 0, all of the arc is behind the line through X
that is perpendicular to N, and no disk that touches the element passes through it.
*/
template <Enclosing_number Interval = Common::Interval>
class Singular_ends
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;

public:
  explicit Singular_ends(const Site_graph_2<Interval>& graph) : m_graph(graph) {}

  // Whether no disk that touches the part of an element passes through a candidate, as this is behind it.
  bool is_behind(const Element_part<Interval>& part, const Disk_candidate<Interval>& candidate) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (candidate.kind == Disk_candidate<Interval>::Kind::VERTEX)
      return !element.is_normal_cone && is_singular(element.object) &&
          is_vertex_behind(part, element.object, candidate.index);
    if (candidate.kind != Disk_candidate<Interval>::Kind::ARC ||
        !(is_singular(candidate.index) || (!element.is_normal_cone && is_singular(element.object))))
      return false;
    if (!element.is_normal_cone && element.object == candidate.index)
      return bends_away(part, candidate.index, united(part.range, candidate.range));
    for (const bool is_end : {false, true})
      if (is_behind_at_end(part, {candidate.index, is_end}, candidate.range))
        return true;
    return false;
  }

  // A lower bound of the curvature <N, D'> / (m |D|^2) of the arc of an element: of disks that touch it and pass
  // through a point next to that.
  double own_curvature(const Element_part<Interval>& part) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (element.is_normal_cone || !is_singular(element.object))
      return 0;
    const Site_arc_2<Interval>& arc = m_graph.arcs()[element.object];
    const auto [direction, change] = arc.tangent_jet(part.range);
    const double bend = dot(part.jet.normal, change).inf();
    return bend > 0
        ? (Interval(bend) / Interval((arc.tangent_factor(part.range) * squared_norm(direction)).sup())).inf()
        : 0;
  }

private:
  bool is_singular(std::size_t arc) const { return m_graph.arcs()[arc].has_singular_end(); }

  // Whether <N, D'> <= 0 on a range of an arc.
  bool bends_away(const Element_part<Interval>& part, std::size_t arc, const Range& range) const
  {
    return dot(part.jet.normal, m_graph.arcs()[arc].tangent_jet(range)[1]).sup() <= 0;
  }

  bool is_vertex_behind(const Element_part<Interval>& part, std::size_t arc, std::size_t vertex) const
  {
    for (const bool is_end : {false, true})
      if (const Arc_end end{arc, is_end}; m_graph.vertex_of(end) == vertex &&
          bends_away(part, arc, united(part.range, {end.parameter(), end.parameter()})))
        return true;
    return false;
  }

  // From the normals of a normal cone, all arcs at its vertex begin behind it. From those of an arc that ends in the
  // same vertex p, Y - X = (Y - p) + (p - X).
  bool is_behind_at_end(const Element_part<Interval>& part, const Arc_end& end, const Range& range) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const Range to_vertex = united(range, {end.parameter(), end.parameter()});
    const std::size_t vertex = m_graph.vertex_of(end);
    if (element.is_normal_cone)
      return element.object == vertex && bends_away(part, end.arc, to_vertex);
    for (const bool is_end : {false, true})
      if (const Arc_end own{element.object, is_end}; m_graph.vertex_of(own) == vertex && m_graph.is_exact(own) &&
          m_graph.is_exact(end) && is_vertex_behind(part, own.arc, vertex) &&
          is_beyond_vertex_behind(part, own, end, to_vertex))
        return true;
    return false;
  }

  // Whether <N(u), B(s)> <= 0 for the outgoing directions B of an arc; also where these are perpendicular in the
  // vertex: it is <N(0), B(0)> + u <N', B(s)> + s <N(0), B'>, with the distances u and s from the vertex.
  bool is_beyond_vertex_behind(const Element_part<Interval>& part, const Arc_end& own, const Arc_end& end,
                               const Range& to_vertex) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const double u = own.parameter();
    const auto [direction, change] = m_graph.arcs()[end.arc].tangent_jet(to_vertex);
    const Interval_pair b = Interval(end.is_end ? -1 : 1) * direction,
                        turn = Interval(own.is_end ? -1 : 1) *
        m_graph.element_jet(element, united(part.range, {u, u})).normal_derivative;
    if (dot(part.jet.normal, b).sup() <= 0)
      return true;
    return sign_of(exact_dot(m_graph.exact_normal(element, Exact_rational(u)), m_graph.direction(end))) <= 0 &&
        dot(turn, b).sup() <= 0 && dot(m_graph.element_jet(element, {u, u}).normal, change).sup() <= 0;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SINGULAR_ENDS_H
