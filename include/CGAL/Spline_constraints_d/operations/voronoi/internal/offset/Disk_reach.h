// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_DISK_REACH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_DISK_REACH_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Whether something is outside of all disks of a part of an element, or in all of them to some extent.
enum class Held { NO, YES, UNKNOWN };

// What is held by some disks, if parts of it are.
inline Held held_by_any(Held a, Held b) { return a == Held::YES || b == Held::YES ? Held::YES : a == Held::NO ? b : a; }

// The point of an element, its normal and the length of that over a range, each with two derivatives. The normal is not
// zero where the derivative is.
template <Enclosing_number Interval>
struct Element_expansion
{
  using Interval_pair = std::array<Interval, 2>;

  inline static const Interval_pair no_way{Interval(0), Interval(0)};

  std::array<Interval_pair, 3> point{no_way, no_way, no_way}, normal{no_way, no_way, no_way};
  std::array<Interval, 3> length;

  Element_expansion(const Site_graph_2<Interval>& graph, const Oriented_element<Interval>& element, const Range& range)
  {
    if (element.is_normal_cone) {
      const Element_jet<Interval> x = graph.element_jet(element, range);
      point[0] = x.point;
      normal[0] = x.normal;
      normal[1] = x.normal_derivative;
    } else {
      const Site_arc_2<Interval>& arc = graph.arcs()[element.object];
      const Curve_jet<Interval> x = arc.jet(range, 3);
      const auto [tangent, change] = arc.tangent_jet(range);
      const Interval side(element.is_reversed ? -1 : 1);
      point = {x[0], x[1], x[2]};
      normal = {side * turned_left(tangent), side * turned_left(change),
                side * turned_left(arc.second_derivative_of_tangent(range))};
    }
    length[0] = CGAL::sqrt(squared_norm(normal[0]));
    length[1] = dot(normal[0], normal[1]) / length[0];
    length[2] = (squared_norm(normal[1]) + dot(normal[0], normal[2]) - CGAL::square(length[1])) / length[0];
  }
};

/*
Where the disks of a given radius r that touch a part of an element hold points of other sites: with D = Y - X, the disk
of u holds Y(v) where H(u,v) = |N| <D,D> - 2 r <N,D> is negative. Bounds of H and its first and second derivatives, from
those of the element.

From them, H is bounded by a polynomial of degree two in the distance from the middle of the part of the element, with
second derivatives from the box: errors are of the third order.
*/
template <Enclosing_number Interval = Common::Interval>
class Disk_reach
{
  using Interval_pair = std::array<Interval, 2>;

  inline static const Interval_pair no_way{Interval(0), Interval(0)};

  const Site_graph_2<Interval>& m_graph;
  Interval m_two_r;
  Range m_range;
  Interval m_shift;   // from the middle of the part
  Element_expansion<Interval> m_over, m_middle;

public:
  struct Jet
  {
    Interval value{0}, u{0}, v{0}, uu{0}, uv{0}, vv{0};
  };

  Disk_reach(const Site_graph_2<Interval>& graph, const Oriented_element<Interval>& element, const Interval& radius,
             const Range& range)
    : m_graph(graph), m_two_r(Interval(2) * radius), m_range(range),
      m_shift(interval_of<Interval>(range) - Interval(range.middle())), m_over(graph, element, range),
      m_middle(graph, element, {range.middle(), range.middle()})
  {}

  // Bounds over the part.
  Jet of_vertex(std::size_t index) const { return of_vertex(m_over, index); }
  Jet of_point(std::size_t arc, const Range& location) const { return of_point(m_over, arc, location); }
  Jet of_arc(std::size_t index, const Range& range) const { return of_arc(m_over, index, range); }

  // In which direction of an arc H grows: the sign of H_v, or, at ends where the derivative of the arc is zero, of its
  // limit.
  int growth(std::size_t arc, const Range& range) const
  {
    const Site_arc_2<Interval>& y = m_graph.arcs()[arc];
    return certain_sign(jet(m_over, y.point(range), y.direction_over(range), no_way).v);
  }

  // Whether the disks hold a vertex, or a part of an arc.
  Held hold_vertex(std::size_t index) const { return held_by_polynomial(of_vertex(m_middle, index), of_vertex(index)); }

  Held hold_arc(std::size_t index, const Range& range) const
  {
    if (const int sign = growth(index, range); sign != 0) {   // the nearest point is in an end
      const double b = sign > 0 ? range.begin : range.end;
      return held_by_polynomial(of_point(m_middle, index, {b, b}), of_point(index, {b, b}));
    }
    const Jet over = of_arc(index, range);
    if (!(over.vv.inf() > 0))
      return Held::UNKNOWN;
    const double b = nearest_in_middle(index, range, range.middle());
    const Jet at = of_arc(m_middle, index, {b, b});
    const Interval least = polynomial(at.value - Interval(0.5) * CGAL::square(at.v) / over.vv,
                                      at.u - at.v * over.uv / over.vv, over.uu - CGAL::square(over.uv) / over.vv);
    return least.inf() > 0 ? Held::NO : hold_moving_point(index, range, b) ? Held::YES : Held::UNKNOWN;
  }

  // Whether the disks hold points of an arc near one of them: the nearest ones, in first order.
  bool hold_point_near(std::size_t index, double v) const
  {
    return hold_moving_point(index, Range(), nearest_in_middle(index, Range(), v));
  }

  /*
  Whether the disks that touch a vertex, or a range of an arc from outside, are one at most: along the part, H grows (1)
  or falls (-1) where they are. There H_v is zero, hence v - b = -(H_v + t H_uv) / H_vv, with the distances t and v - b
  from the middle and a point of the range.
  */
  int growth_where_vertex_is_touched(std::size_t index) const
  {
    return certain_sign(of_vertex(m_middle, index).u + m_shift * of_vertex(index).uu);
  }

  int growth_where_arc_is_touched(std::size_t index, const Range& range) const
  {
    const Jet over = of_arc(index, range);
    if (!(over.vv.inf() > 0))
      return 0;
    const double b = nearest_in_middle(index, range, range.middle());
    const Jet at = of_arc(m_middle, index, {b, b});
    return certain_sign(at.u - at.v * over.uv / over.vv + m_shift * (over.uu - over.uv * over.uv / over.vv));
  }

private:
  Jet of_vertex(const Element_expansion<Interval>& element, std::size_t index) const
  {
    return jet(element, m_graph.vertices()[index].point, no_way, no_way);
  }

  Jet of_point(const Element_expansion<Interval>& element, std::size_t arc, const Range& location) const
  {
    return jet(element, m_graph.arcs()[arc].jet(location, 0)[0], no_way, no_way);
  }

  Jet of_arc(const Element_expansion<Interval>& element, std::size_t index, const Range& range) const
  {
    const Curve_jet<Interval> y = m_graph.arcs()[index].jet(range, 2);
    return jet(element, y[0], y[1], y[2]);
  }

  // About where H is least in the middle of the part, near a parameter: Newton's method.
  double nearest_in_middle(std::size_t arc, const Range& range, double v) const
  {
    constexpr int steps = 2;
    for (int i = 0; i < steps; ++i) {
      const Jet at = of_arc(m_middle, arc, {v, v});
      const double next = v - middle(at.v) / middle(at.vv);
      v = at.vv.inf() > 0 && std::isfinite(next) ? std::clamp(next, range.begin, range.end) : v;
    }
    return v;
  }

  // Whether the disks hold the points of a range that move from b in the middle as the nearest ones do there.
  bool hold_moving_point(std::size_t arc, const Range& range, double b) const
  {
    const Jet at = of_arc(m_middle, arc, {b, b});
    const double ratio = at.vv.inf() > 0 ? -middle(at.uv) / middle(at.vv) : 0, along = std::isfinite(ratio) ? ratio : 0;
    const Interval way = m_shift * Interval(along), v = Interval(b) + way;
    const bool is_inside = v.inf() >= range.begin && v.sup() <= range.end;
    const Interval slope(is_inside ? along : 0);
    const Jet over = is_inside ? of_arc(arc, {v.inf(), v.sup()}) : of_arc(arc, {b, b});
    return polynomial(at.value, at.u + slope * at.v,
                      over.uu + Interval(2) * slope * over.uv + CGAL::square(slope) * over.vv)
               .sup() < 0;
  }

  static double middle(const Interval& x) { return x.inf() / 2 + x.sup() / 2; }

  // With a second derivative that depends on the place.
  Interval polynomial(const Interval& value, const Interval& slope, const Interval& second) const
  {
    return value + m_shift * slope + Interval(0.5) * CGAL::square(m_shift) * second;
  }

  Held held_by_polynomial(const Jet& middle, const Jet& over) const
  {
    const int sign = certain_sign(polynomial(middle.value, middle.u, over.uu));
    return sign > 0 ? Held::NO : sign < 0 ? Held::YES : Held::UNKNOWN;
  }

  Jet jet(const Element_expansion<Interval>& element, const Interval_pair& y, const Interval_pair& y_v,
          const Interval_pair& y_vv) const
  {
    const auto& [n, n_u, n_uu] = element.normal;
    const auto& [x, x_u, x_uu] = element.point;
    const auto& [length, length_u, length_uu] = element.length;
    const Interval two(2);
    const Interval_pair d = y - x;
    const Interval dd = squared_norm(d), dd_u = -two * dot(d, x_u), dd_v = two * dot(d, y_v);
    const Interval dd_uu = two * (squared_norm(x_u) - dot(d, x_uu)), dd_uv = -two * dot(x_u, y_v),
                   dd_vv = two * (squared_norm(y_v) + dot(d, y_vv));
    return {dd * length - m_two_r * dot(n, d),
            dd_u * length + dd * length_u - m_two_r * dot(n_u, d),   // <N,X'> = 0
            dd_v * length - m_two_r * dot(n, y_v),
            dd_uu * length + two * dd_u * length_u + dd * length_uu - m_two_r * (dot(n_uu, d) - dot(n_u, x_u)),
            dd_uv * length + dd_v * length_u - m_two_r * dot(n_u, y_v),
            dd_vv * length - m_two_r * dot(n, y_vv)};
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_DISK_REACH_H
