// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_NORMAL_CONE_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_NORMAL_CONE_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Disks that touch a vertex p with a normal N = (1-w) n + w m of a normal cone, and pass through a point Y = p + t B of an
arc that begins there, perpendicular to n. With <N, Y - p> = t w c + t^2 e, where c = <m, B(0)>, and |Y - p|^2 = t^2 s,
their curvature is

  k(w,t) = 2 (e + w c / t) / s,

where e, s are smooth functions of t, and c < 0: the arc leaves the half-plane of m.

  s k_t / 2 = a + (w/t^2) b,   a = e' - e s'/s,   b = -c (1 + t s'/s).

Near the vertex b > 0. So if a > 0 k increases with t; and if t^2 a / b is monotone where a < 0 it has one maximum in t
for all w > 0, which moves into the vertex for w = 0 if a < 0 there. Its derivative has the sign of

  a (2 - t b'/b) + t a'.

So it is monotone, too, if a decreases, which may be positive first: then the curvature of the arc has its maximum next
to the vertex.
*/
template <Enclosing_number Interval = Common::Interval>
class Normal_cone_disks
{
  using Interval_pair = std::array<Interval, 2>;

  Interval m_t;
  Interval m_share;           // of m
  Interval m_share_change;    // with the parameter of the element
  double m_direction;         // of the parameter of the arc, away from the vertex
  Interval e, e1, e2, eu, e1u, c, s, s1, s2;
  bool m_is_regular;

public:
  // For the normal in the begin or end of a normal cone, which is perpendicular to the arc, and points up to the end of
  // a range.
  Normal_cone_disks(const Site_graph_2<Interval>& graph, const Element_part<Interval>& part, bool normal,
                    const Arc_end& end, const Range& range)
  {
    const Oriented_element<Interval>& element = graph.elements()[part.element];
    const Range to_vertex = united(range, {end.parameter(), end.parameter()});
    Curve_jet<Interval> y = graph.arcs()[end.arc].jet(to_vertex);
    m_direction = end.is_end ? -1 : 1;
    y[1] = Interval(m_direction) * y[1];
    y[3] = Interval(m_direction) * y[3];
    m_t = end.is_end ? Interval(1) - interval_of<Interval>(range) : interval_of<Interval>(range);
    m_share = normal ? Interval(1) - interval_of<Interval>(part.range) : interval_of<Interval>(part.range);
    m_share_change = Interval(normal ? -1 : 1);
    const Interval half = Interval(1) / Interval(2), third = Interval(1) / Interval(3),
                   sixth = Interval(1) / Interval(6), twelfth = Interval(1) / Interval(12), two(2);
    const auto& [n, nu] = std::pair(part.jet.normal, part.jet.normal_derivative);
    e = half * dot(n, y[2]);
    e1 = sixth * dot(n, y[3]);
    e2 = twelfth * dot(n, y[4]);
    eu = half * dot(nu, y[2]);
    e1u = sixth * dot(nu, y[3]);
    c = dot(element.normals[!normal],
            Interval(m_direction) * graph.arcs()[end.arc].jet({end.parameter(), end.parameter()}, 1)[1]);
    const Interval_pair b1 = half * y[2], b2 = third * y[3];
    s = squared_norm(y[1]);
    s1 = two * dot(y[1], b1);
    s2 = two * (squared_norm(b1) + dot(y[1], b2));
    m_is_regular = s.inf() > 0 && c.sup() < 0;
  }

  Curvature_bounds<Interval> bounds() const
  {
    if (!m_is_regular)
      return {};
    if (!(m_t.inf() > 0)) {
      Curvature_bounds<Interval> result;
      result.value = Interval(-std::numeric_limits<double>::infinity(), (std::max)((Interval(2) * e / s).sup(), 0.0));
      return result;
    }
    const Interval two(2), way(m_direction), t = m_t, slope = c / t, slope1 = -slope / t;   // of c / t
    Curvature_quotient<Interval> k;
    k.f = two * (e + m_share * slope);
    k.q = s;
    k.fu = two * (eu + m_share_change * slope);
    k.qu = k.quv = Interval(0);
    k.fv = way * two * (e1 + m_share * slope1);
    k.qv = way * s1;
    k.fvv = two * (e2 - two * m_share * slope1 / t);
    k.qvv = s2;
    k.fuv = way * two * (e1u + m_share_change * slope1);
    return k.bounds();
  }

  // Whether k increases with the distance from the vertex.
  bool is_increasing() const { return m_is_regular && a().inf() > 0 && one_plus().inf() > 0; }

  // Whether k has at most one maximum.
  bool has_one_maximum() const
  {
    if (!m_is_regular || !(one_plus().inf() > 0))
      return false;
    const Interval ratio = s1 / s, ratio1 = s2 / s - CGAL::square(ratio), a1 = e2 - e1 * ratio - e * ratio1, t = m_t,
                   weight = Interval(2) + t * ratio - CGAL::square(t) * ratio1;
    return (a().sup() < 0 && (a() * weight + t * one_plus() * a1).sup() < 0) || (a1.sup() < 0 && weight.inf() > 0);
  }

private:
  Interval a() const { return e1 - e * s1 / s; }
  Interval one_plus() const { return Interval(1) + m_t * s1 / s; }   // b / -c
};

// Whether an arc lies on a circle through the vertex of a normal cone whose first or last normal points along a
// diameter.
template <Enclosing_number Interval>
bool is_on_circle_through_normal_cone(const Site_graph_2<Interval>& graph,
                                      const Oriented_element<Interval>& normal_cone, bool normal, std::size_t arc)
{
  const Site_arc_2<Interval>& y = graph.arcs()[arc];
  const auto& vertex = graph.vertices()[normal_cone.object];
  // most are elsewhere: this is cheap
  if (!y.circle() || y.turns_back() || y.has_singular_end() || !vertex.is_exact ||
      certain_sign(squared_norm(vertex.point - y.center()) - y.squared_radius()) != 0)
    return false;
  return y.is_on_line_or_circle(vertex.exact_point) &&
      sign_of(
          exact_cross(normal_cone.exact_normals[normal], exact_difference(y.circle()->first, vertex.exact_point))) == 0;
}

/*
How the curvature k of disks that touch the vertex p of a normal cone with a normal N = (1-w) n + w m changes along such
a circle, of which n points along a diameter. The inversion Z = (Y - p) / |Y - p|^2 maps the circle to a line across n,
along which Z moves in one direction T, and k = 2 <N, Z>. So

  k_v = 2 w <m, T> |Y_v| / |Y - p|^2

has the sign of <m, T> for all w > 0, though the disk with w = 0 may touch all of the circle.
*/
template <Enclosing_number Interval>
Curvature_bounds<Interval> along_circle_through_normal_cone(const Site_graph_2<Interval>& graph,
                                                            const Element_part<Interval>& part, bool normal,
                                                            std::size_t arc, const Curve_jet<Interval>& y)
{
  const auto& normal_cone = graph.elements()[part.element];
  const auto& circle = graph.arcs()[arc];
  const auto& p = graph.vertices()[normal_cone.object].point;
  const auto begin = circle.jet({0, 0}, 1);
  const int direction = certain_sign(dot(turned_left(begin[0] - circle.center()), begin[1]));   // around the center
  // <m, T>
  const Interval along = Interval(direction) * dot(turned_left(circle.center() - p), normal_cone.normals[!normal]) /
      CGAL::sqrt(circle.squared_radius());
  const Interval u = interval_of<Interval>(part.range), way = squared_norm(y[0] - p);
  Curvature_bounds<Interval> k;
  if (direction == 0)   // not certain
    return k;
  if (way.inf() > 0) {
    const Interval rate = Interval(2) * along * CGAL::sqrt(squared_norm(y[1])) / way;
    k.dv = (normal ? Interval(1) - u : u) * rate;
    k.duv = Interval(normal ? -1 : 1) * rate;
  }
  if (const int sign = certain_sign(along); sign != 0 && !part.range.is_number())
    k.dv = common_part(
        k.dv, Interval(sign) * Interval(std::numeric_limits<double>::min(), std::numeric_limits<double>::infinity()));
  return k;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_NORMAL_CONE_DISKS_H
