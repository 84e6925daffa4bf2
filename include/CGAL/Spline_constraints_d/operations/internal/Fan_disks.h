// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_FAN_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_FAN_DISKS_H

#include <CGAL/Spline_constraints_d/operations/internal/Curvature_bounds.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Disks that touch a vertex p with a normal N = (1-w) n + w m of a fan, and pass through a point Y = p + t B of an arc that begins there, perpendicular to n. With <n, Y - p> = t^2 e, <m, Y - p> = t c and |Y - p|^2 = t^2 s, their curvature is

  k(w,t) = 2 ((1-w) e + (w/t) c) / s,

where e, c, s are smooth functions of t, and c < 0: the arc leaves the half-plane of m.

  s k_t / 2 = (1-w) a + (w/t^2) b,   a = e' - e s'/s,   b = -c + t (c' - c s'/s).

Near the vertex b > 0. So if a > 0 k increases with t; and if a < 0 and t^2 a / b is monotone it has one maximum in t for all w > 0, which moves into the vertex for w = 0.
*/
template <Enclosing_number Interval>
class Basic_fan_disks
{
  using Interval_pair = std::array<Interval, 2>;
  using Curve_jet = Basic_curve_jet<Interval>;
  using Site_graph_2 = Basic_site_graph_2<Interval>;
  using Front = Basic_front<Interval>;
  using Front_part = Basic_front_part<Interval>;
  using Curvature_bounds = Basic_curvature_bounds<Interval>;
  using Curvature_quotient = Basic_curvature_quotient<Interval>;

  Interval m_t, m_other_share;
  double m_direction;   // of the parameter of the arc, away from the vertex
  double m_share_sign;  // 1 - w or w is the share of n
  Interval m_share;
  Interval e, e1, e2, c, c1, c2, s, s1, s2;
  bool m_is_regular;

public:
  // For the normal in the begin or end of a fan, which is perpendicular to the arc, and points up to the end of a range.
  Basic_fan_disks(const Site_graph_2& graph, const Front_part& part, bool normal, const Arc_end& end, const Range& range)
  {
    const Front& front = graph.fronts()[part.front];
    const Range to_vertex = united(range, {end.parameter(), end.parameter()});
    Curve_jet y = graph.arcs()[end.arc].jet(to_vertex);
    m_direction = end.is_end ? -1 : 1;
    y[1] = Interval(m_direction) * y[1];
    y[3] = Interval(m_direction) * y[3];
    m_t = end.is_end ? Interval(1) - interval_of<Interval>(range) : interval_of<Interval>(range);
    m_share = normal ? interval_of<Interval>(part.range) : Interval(1) - interval_of<Interval>(part.range);
    m_other_share = normal ? Interval(1) - interval_of<Interval>(part.range) : interval_of<Interval>(part.range);
    m_share_sign = normal ? 1 : -1;
    const Interval half = Interval(1) / Interval(2), third = Interval(1) / Interval(3), sixth = Interval(1) / Interval(6), twelfth = Interval(1) / Interval(12), two(2);
    const Interval_pair &n = front.normals[normal], &m = front.normals[!normal];
    e = half * dot(n, y[2]);
    e1 = sixth * dot(n, y[3]);
    e2 = twelfth * dot(n, y[4]);
    c = dot(m, y[1]);
    c1 = half * dot(m, y[2]);
    c2 = third * dot(m, y[3]);
    const Interval_pair b1 = half * y[2], b2 = third * y[3];
    s = squared_norm(y[1]);
    s1 = two * dot(y[1], b1);
    s2 = two * (squared_norm(b1) + dot(y[1], b2));
    m_is_regular = s.inf() > 0 && c.sup() < 0;
  }

  Curvature_bounds bounds() const
  {
    if (!m_is_regular)
      return {};
    if (!(m_t.inf() > 0)) {
      Curvature_bounds result;
      result.value = Interval(-std::numeric_limits<double>::infinity(), (std::max)((Interval(2) * m_share * e / s).sup(), 0.0));
      return result;
    }
    const Interval two(2), way(m_direction), sign(m_share_sign), w = m_other_share, t = m_t, tt = CGAL::square(t);
    Curvature_quotient k;
    k.f = two * (m_share * e + w * c / t);
    k.q = s;
    k.fu = sign * two * (e - c / t);
    k.qu = k.quv = Interval(0);
    k.fv = way * two * (m_share * e1 + w * (c1 * t - c) / tt);
    k.qv = way * s1;
    k.fvv = two * (m_share * e2 + w * (c2 / t - two * c1 / tt + two * c / (tt * t)));
    k.qvv = s2;
    k.fuv = way * sign * two * (e1 - (c1 * t - c) / tt);
    return k.bounds();
  }

  // Whether k increases with the distance from the vertex.
  bool is_increasing() const { return m_is_regular && a().inf() > 0 && b().inf() > 0; }

  // Whether k has at most one maximum.
  bool has_one_maximum() const
  {
    if (!m_is_regular || !(a().sup() < 0 && b().inf() > 0))
      return false;
    const Interval a1 = e2 - (e1 * s1 + e * s2) / s + e * CGAL::square(s1 / s), b1 = -c * s1 / s + m_t * (c2 - (c1 * s1 + c * s2) / s + c * CGAL::square(s1 / s));
    const Interval ratio = a() / b(), ratio1 = (a1 - ratio * b1) / b();
    return (Interval(2) * ratio + m_t * ratio1).sup() < 0;
  }

private:
  Interval a() const { return e1 - e * s1 / s; }
  Interval b() const { return -c + m_t * (c1 - c * s1 / s); }
};

using Fan_disks = Basic_fan_disks<Interval>;

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_FAN_DISKS_H
