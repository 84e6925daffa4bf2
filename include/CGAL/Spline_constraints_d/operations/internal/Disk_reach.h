// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_REACH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_REACH_H

#include <CGAL/Spline_constraints_d/operations/internal/Site_graph_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Whether something is outside of all disks of a part of a front, or in all of them to some extent.
enum class Held { NO, YES, UNKNOWN };

// What is held by some disks, if parts of it are.
inline Held held_by_any(Held a, Held b) { return a == Held::YES || b == Held::YES ? Held::YES : a == Held::NO ? b : a; }

/*
Where the disks of a given radius r that touch a part of a front hold points of other sites: with D = Y - X, the disk of u holds Y(v) where H(u,v) = |N| <D,D> - 2 r <N,D> is negative. Bounds of H and its first and second derivatives, from those of the front.
*/
class Disk_reach
{
  inline static const Interval_pair no_way{Interval(0), Interval(0)};

  const Site_graph_2& m_graph;
  const Front& m_front;
  Interval m_two_r;
  Range m_range;
  std::array<Interval_pair, 3> m_point{no_way, no_way, no_way}, m_normal{no_way, no_way, no_way};   // with derivatives
  Interval m_length{0}, m_length_u{0}, m_length_uu{0};   // of the normal

public:
  struct Jet
  {
    Interval value{0}, u{0}, v{0}, uu{0}, uv{0}, vv{0};
  };

  // Of a front with a derivative that is not zero; elsewhere bounds are infinite.
  Disk_reach(const Site_graph_2& graph, const Front& front, const Interval& radius, const Range& range) : m_graph(graph), m_front(front), m_two_r(Interval(2) * radius), m_range(range)
  {
    if (front.is_fan) {
      const Front_jet x = graph.front_jet(front, range);
      m_point[0] = x.point;
      m_normal[0] = x.normal;
      m_normal[1] = x.normal_derivative;
    } else {
      const Curve_jet x = graph.arcs()[front.object].jet(range, 3);
      const Interval side(front.is_reversed ? -1 : 1);
      for (std::size_t k = 0; k < 3; ++k) {
        m_point[k] = x[k];
        m_normal[k] = side * turned_left(x[k + 1]);
      }
    }
    m_length = CGAL::sqrt(squared_norm(m_normal[0]));
    m_length_u = dot(m_normal[0], m_normal[1]) / m_length;
    m_length_uu = (squared_norm(m_normal[1]) + dot(m_normal[0], m_normal[2]) - CGAL::square(m_length_u)) / m_length;
  }

  Jet of_vertex(std::size_t index) const { return jet(m_graph.vertices()[index].point, no_way, no_way); }

  // Of one point of an arc.
  Jet of_point(std::size_t arc, const Range& location) const { return jet(m_graph.arcs()[arc].jet(location, 0)[0], no_way, no_way); }

  Jet of_arc(std::size_t index, const Range& range) const
  {
    const Curve_jet y = m_graph.arcs()[index].jet(range, 2);
    return jet(y[0], y[1], y[2]);
  }

  // In which direction of an arc H grows: the sign of H_v, or, at ends where the derivative of the arc is zero, of its limit.
  int growth(std::size_t arc, const Range& range) const
  {
    const Site_arc_2& y = m_graph.arcs()[arc];
    const Jet along = jet(y.point(range), y.direction_over(range), no_way);
    return certain_sign(along.v);
  }

  // Whether the disks hold a vertex, or a part of an arc.
  Held hold_vertex(std::size_t index) const { return held_by_polynomial(in_middle().of_vertex(index), of_vertex(index)); }

  /*
  If there is a nearest point inside of the part, H has there a polynomial of degree two in the distance from the middle of the part of the front, with second derivatives from the box: errors are of the third order.
  */
  Held hold_arc(std::size_t index, const Range& range) const
  {
    if (const int sign = growth(index, range); sign != 0) {   // the nearest point is in an end
      const double b = sign > 0 ? range.begin : range.end;
      return held_by_polynomial(in_middle().of_point(index, {b, b}), of_point(index, {b, b}));
    }
    const Jet over = of_arc(index, range);
    if (!(over.vv.inf() > 0))
      return Held::UNKNOWN;
    const Disk_reach middle = in_middle();
    double b = range.middle();
    for (int k = 0; k < 2; ++k)
      b = (std::min)((std::max)(b - (middle.of_arc(index, {b, b}).v / over.vv).inf(), range.begin), range.end);
    const Jet at = middle.of_arc(index, {b, b});
    const Interval half(0.5), t = interval_of<Interval>(m_range) - Interval(m_range.middle()), tt = CGAL::square(t);
    const Interval least = at.value - half * CGAL::square(at.v) / over.vv + t * (at.u - at.v * over.uv / over.vv) + half * tt * (over.uu - CGAL::square(over.uv) / over.vv);
    if (least.inf() > 0)
      return Held::NO;
    const Interval slope((-over.uv / over.vv).inf()), v = Interval(b) + t * slope;
    const Interval reached = at.value + t * (at.u + slope * at.v) + half * tt * (over.uu + Interval(2) * slope * over.uv + CGAL::square(slope) * over.vv);
    return reached.sup() < 0 && v.inf() >= range.begin && v.sup() <= range.end ? Held::YES : Held::UNKNOWN;
  }

private:
  Disk_reach in_middle() const { return {m_graph, m_front, m_two_r / Interval(2), {m_range.middle(), m_range.middle()}}; }

  Held held_by_polynomial(const Jet& middle, const Jet& over) const
  {
    const Interval t = interval_of<Interval>(m_range) - Interval(m_range.middle());
    const int sign = certain_sign(middle.value + t * middle.u + Interval(0.5) * CGAL::square(t) * over.uu);
    return sign > 0 ? Held::NO : sign < 0 ? Held::YES : Held::UNKNOWN;
  }

  Jet jet(const Interval_pair& y, const Interval_pair& y_v, const Interval_pair& y_vv) const
  {
    const auto& [n, n_u, n_uu] = m_normal;
    const auto& [x, x_u, x_uu] = m_point;
    const Interval two(2);
    const Interval_pair d = y - x;
    const Interval dd = squared_norm(d), dd_u = -two * dot(d, x_u), dd_v = two * dot(d, y_v);
    const Interval dd_uu = two * (squared_norm(x_u) - dot(d, x_uu)), dd_uv = -two * dot(x_u, y_v), dd_vv = two * (squared_norm(y_v) + dot(d, y_vv));
    return {dd * m_length - m_two_r * dot(n, d),
            dd_u * m_length + dd * m_length_u - m_two_r * dot(n_u, d),   // <N,X'> = 0
            dd_v * m_length - m_two_r * dot(n, y_v),
            dd_uu * m_length + two * dd_u * m_length_u + dd * m_length_uu - m_two_r * (dot(n_uu, d) - dot(n_u, x_u)),
            dd_uv * m_length + dd_v * m_length_u - m_two_r * dot(n_u, y_v),
            dd_vv * m_length - m_two_r * dot(n, y_vv)};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_REACH_H
