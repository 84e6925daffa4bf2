// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_CURVATURE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_CURVATURE_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Circle_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Common_vertex_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Element_ways.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Scaled_sites.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The disk that touches an element in X(u), with the normal N(u), and passes through the point Y(v) of an arc has the
center X + N / k with the curvature

  k(u,v) = 2 <N, Y - X> / |Y - X|^2.

The disk is in the half-plane of N where k > 0. Those with k <= 0 contain a half-plane, and there is no need to tell
them apart.

Where both points belong to one arc, or to two that join smoothly, both <N, Y - X> and |Y - X|^2 are divided by h^2,
with h = v - u: with D = (Y - X) / h, the mean of X' between u and v, and E = <N, Y - X> / h^2, the mean of (1-t) <N(u),
X''(u + t h)>, k = 2 E / |D|^2 has no singularity at v = u, where it is the curvature of the arc. Derivatives of D and E
are means of higher derivatives, and all of them are enclosed by hulls of these.

If it is the disk scaled by a factor c > 1 that passes through Y, |X + N / k - Y| = c |N| / k and

  |Y - X|^2 k^2 - 2 <N, Y - X> k - (c^2 - 1) |N|^2 = 0,

which has one positive solution. Then each disk has such a point: none is a half-plane.
*/
template <Enclosing_number Interval = Common::Interval>
class Disk_curvature
{
  using Interval_pair = std::array<Interval, 2>;

  static constexpr double small = 0x1p-16;  // ranges over which rounding matters
  static constexpr double near = 0x1p-4;   // the ends of an arc, where differences of points are not accurate

  const Site_graph_2<Interval>& m_graph;
  const Scaled_sites<Interval>* m_scaled;   // none, or some sites, but none of an element in question

public:
  explicit Disk_curvature(const Site_graph_2<Interval>& graph, const Scaled_sites<Interval>* scaled = nullptr)
    : m_graph(graph), m_scaled(scaled)
  {}

  const Scaled_sites<Interval>* scaled_sites() const { return m_scaled; }
  bool is_arc_scaled(std::size_t arc) const { return m_scaled != nullptr && m_scaled->arcs[arc]; }
  bool is_vertex_scaled(std::size_t vertex) const { return m_scaled != nullptr && m_scaled->vertices[vertex]; }

  // How an arc goes on for the disks of a part, if both are scaled or neither is: with one maximum of the curvature for
  // both. The arc that goes on has this one as its own continuation.
  std::optional<Arc_end> continuation(const Element_part<Interval>& part, const Arc_end& end) const
  {
    const auto next = next_on_side_of(part, end);
    return next && is_arc_scaled(end.arc) == is_arc_scaled(next->arc) && next_on_side_of(part, *next) == end
        ? next
        : std::nullopt;
  }

  Element_part<Interval> part(std::size_t element, const Range& range) const
  {
    return {element, range, m_graph.element_jet(m_graph.elements()[element], range)};
  }

  // Over a part of an element and a range of an arc, with the enclosures of that.
  Curvature_bounds<Interval> operator()(const Element_part<Interval>& part, std::size_t arc, const Range& range,
                                        const Curve_jet<Interval>& jet) const
  {
    if (part.range.is_number() && range.is_number() && is_arc_scaled(arc))
      return of_scaled_disk(quotient(part, arc, range, jet), part);
    if (part.range.is_number() && range.is_number())
      return with_what_is_common(quotient(part, arc, range, jet).bounds(), part, arc, range, jet, part, jet);
    const double u = part.range.middle(), v = range.middle();
    return (*this)(part, arc, range, jet, this->part(part.element, {u, u}), m_graph.arcs()[arc].jet({v, v}, 2));
  }

  Curvature_bounds<Interval> operator()(const Element_part<Interval>& part, std::size_t arc, const Range& range) const
  {
    return (*this)(part, arc, range, m_graph.arcs()[arc].jet(range));
  }

  // The disks that pass through the end of an arc.
  Curvature_bounds<Interval> operator()(const Element_part<Interval>& part, const Arc_end& end) const
  {
    return (*this)(part, end.arc, {end.parameter(), end.parameter()});
  }

  // The same with the enclosures in the middles of both ranges, for mean value forms: <N, Y - X> is small beside both
  // factors where curves are nearly parallel.
  Curvature_bounds<Interval> operator()(const Element_part<Interval>& part, std::size_t arc, const Range& range,
                                        const Curve_jet<Interval>& jet, const Element_part<Interval>& middle,
                                        const Curve_jet<Interval>& jet_in_middle) const
  {
    const Interval shift_u = interval_of<Interval>(part.range) - Interval(middle.range.begin),
                   shift_v = interval_of<Interval>(range) - Interval(range.middle());
    const bool is_small = (std::max)(part.range.width(), range.width()) < small;
    const Range at_middle{range.middle(), range.middle()};
    const auto way_of = [&](const Element_part<Interval>& x, const Range& y, const Curve_jet<Interval>& jet_of_y) {
      return is_small ? ways().to_arc(x, arc, y, jet_of_y) : jet_of_y[0] - x.jet.point;
    };
    const Interval_pair whole_way = way_of(part, range, jet);
    const Curvature_quotient<Interval>
        in_middle = quotient(middle.jet, arc, at_middle, jet_in_middle, way_of(middle, at_middle, jet_in_middle)),
        k = quotient(part.jet, arc, range, jet, whole_way).around(in_middle, shift_u, shift_v);
    if (is_arc_scaled(arc))
      return of_scaled_disk(k, part);
    const Curvature_bounds<Interval> bounds = k.bounds();
    const bool is_maximum_known = certain_sign(bounds.dv) != 0 || bounds.dvv.sup() < 0;   // if there is one
    if (is_maximum_known && !(is_small && is_beside_element(part.element, arc)))
      return with_what_is_common(bounds, part, arc, range, jet, middle, jet_in_middle);
    const Site_arc_2<Interval>& y = m_graph.arcs()[arc];
    const auto turn = m_graph.elements()[part.element].is_normal_cone
        ? std::nullopt
        : std::optional(Element_turn<Interval>::beside(part.jet, whole_way,
                                                       y.has_singular_end() ? y.tangent_jet(range)[0] : jet[1]));
    return with_what_is_common(k.bounds_around(in_middle.bounds(), shift_u, shift_v, turn), part, arc, range, jet,
                               middle, jet_in_middle);
  }

  // The disks that pass through a vertex.
  Curvature_bounds<Interval> operator()(const Element_part<Interval>& part, std::size_t vertex) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const Interval_pair zero{Interval(0), Interval(0)};
    if (is_vertex_scaled(vertex))
      return of_scaled_disk(
          quotient(part.jet, m_graph.vertices()[vertex].point - part.jet.point, zero, zero, Interval(1)), part);
    const auto through_vertex = [&](const Element_part<Interval>& x, const Interval_pair& way) {
      return quotient(x.jet, way, zero, zero, Interval(1));
    };
    const Interval_pair whole_way = ways().to_vertex(part, vertex);
    Curvature_bounds<Interval> result;
    if (element.is_normal_cone || part.range.is_number())
      result = through_vertex(part, whole_way).bounds();
    else {
      const double u = part.range.middle();
      const Element_part<Interval> middle = this->part(part.element, {u, u});
      const Curvature_bounds<Interval> in_middle = through_vertex(middle, ways().to_vertex(middle, vertex)).bounds();
      result = through_vertex(part, whole_way)
                   .bounds_around(in_middle, interval_of<Interval>(part.range) - Interval(u), Interval(0),
                                  Element_turn<Interval>::beside(part.jet, whole_way, zero));
    }
    if (!element.is_normal_cone)
      for (const bool is_end : {false, true})
        if (const Arc_end end{element.object, is_end}; m_graph.vertex_of(end) == vertex &&
            gap(part.range, {end.parameter(), end.parameter()}) <= (std::max)(4 * part.range.width(), near))
          add_by_element(result, within_arc(part, element.object, {end.parameter(), end.parameter()}));
    return result;
  }

  // The disks that pass through points of a box. Those of half-planes do not matter.
  Interval through_box(const Element_part<Interval>& part, const Interval_pair& box) const
  {
    const Interval_pair d = box - part.jet.point;
    Curvature_quotient<Interval> k;
    k.f = Interval(2) * dot(part.jet.normal, d);
    k.q = squared_norm(d);
    if (m_scaled != nullptr)
      return hull(Interval(0), of_scaled_disk(k, part).value);
    return k.f.sup() <= 0 ? Interval(0) : k.q.inf() > 0 ? k.f / k.q : any_number<Interval>();
  }

  // The disks that touch an element from within the circle that it lies on have the curvature of that.
  std::optional<Curvature_bounds<Interval>> of_own_circle(const Element_part<Interval>& part) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (element.is_normal_cone || !m_graph.arcs()[element.object].circle())
      return std::nullopt;
    const Site_arc_2<Interval>& arc = m_graph.arcs()[element.object];
    const double u = part.range.middle();
    const Element_jet<Interval> x = m_graph.element_jet(element, {u, u});
    if (!(dot(x.normal, arc.center() - x.point).inf() > 0))
      return std::nullopt;
    Curvature_bounds<Interval> result;
    result.value = CGAL::sqrt(squared_norm(part.jet.normal) / arc.squared_radius());
    result.du = dot(part.jet.normal, part.jet.normal_derivative) / (arc.squared_radius() * result.value);
    return result;
  }

  // The side of that circle on which all points are, 1 outside, -1 inside; 0 if that is not certain. Disks through
  // points outside are larger, those through points inside smaller.
  int side_of_own_circle(const Element_part<Interval>& part, const Interval_pair& points) const
  {
    const Site_arc_2<Interval>& arc = m_graph.arcs()[m_graph.elements()[part.element].object];
    return certain_sign(squared_norm(points - arc.center()) - arc.squared_radius());
  }

private:
  Element_ways<Interval> ways() const { return Element_ways<Interval>(m_graph); }

  // What more is known of the disks through a vertex, which has no parameter, from those through the end of an arc.
  static void add_by_element(Curvature_bounds<Interval>& result, const Curvature_bounds<Interval>& more)
  {
    result.value = common_part(result.value, more.value);
    result.du = common_part(result.du, more.du);
  }

  // Where several arcs leave a vertex in the same direction, that on the side from which disks touch them.
  std::optional<Arc_end> next_on_side_of(const Element_part<Interval>& part, const Arc_end& end) const
  {
    const auto& vertex = m_graph.vertices()[m_graph.vertex_of(end)];
    if (const auto only = m_scaled != nullptr && vertex.ends.size() > 2 && m_graph.is_exact(end)
            ? m_scaled->continuation(m_graph, end)
            : std::nullopt)
      return only;
    if (vertex.ends.size() > 2 && m_graph.is_exact(end)) {
      const Interval_pair tangent = m_graph.arcs()[end.arc].direction_over({end.parameter(), end.parameter()});
      const int side = certain_sign(dot(turned_left(tangent), part.jet.point - vertex.point)) * (end.is_end ? 1 : -1);
      if (const auto beside = side != 0 ? m_graph.continuation_beside(end, side > 0) : std::nullopt)
        return beside;
    }
    const auto& smooth = m_graph.continuation(end);
    return smooth ? std::optional(smooth->end) : std::nullopt;
  }

  Curvature_bounds<Interval> of_scaled_disk(const Curvature_quotient<Interval>& k,
                                            const Element_part<Interval>& part) const
  {
    const Interval_pair& n = part.jet.normal;
    return k.positive_zero(m_scaled->excess * squared_norm(n),
                           Interval(2) * m_scaled->excess * dot(n, part.jet.normal_derivative));
  }

  static double gap(const Range& a, const Range& b) { return (std::max)(a.begin, b.begin) - (std::min)(a.end, b.end); }

  // And what is known where the element lies on the arc, has a vertex in common with it, or touches a circle on which
  // one of them lies.
  Curvature_bounds<Interval> with_what_is_common(Curvature_bounds<Interval> result, const Element_part<Interval>& part,
                                                 std::size_t arc, const Range& range, const Curve_jet<Interval>& jet,
                                                 const Element_part<Interval>& middle,
                                                 const Curve_jet<Interval>& jet_in_middle) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (!element.is_normal_cone && element.object == arc)
      add_by_tangent(result, within_arc(part, arc, range), m_graph.arcs()[arc], range);
    else
      add_by_circles(result, part, arc, range, jet, middle, jet_in_middle);
    for (const bool is_end : {false, true})
      Common_vertex_disks<Interval>(m_graph).add(result, part, {arc, is_end}, range);
    if (element.is_normal_cone)
      for (const bool normal : {false, true})
        if (is_on_circle_through_normal_cone(m_graph, element, normal, arc))
          result = common_part(result, along_circle_through_normal_cone(m_graph, part, normal, arc, jet));
    return result;
  }

  void add_by_circles(Curvature_bounds<Interval>& result, const Element_part<Interval>& part, std::size_t arc,
                      const Range& range, const Curve_jet<Interval>& jet, const Element_part<Interval>& middle,
                      const Curve_jet<Interval>& jet_in_middle) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const Site_arc_2<Interval> &y = m_graph.arcs()[arc],
          *own = element.is_normal_cone ? nullptr : &m_graph.arcs()[element.object];
    const double v = range.middle();
    const Interval shift_u = interval_of<Interval>(part.range) - Interval(middle.range.begin),
                   shift_v = interval_of<Interval>(range) - Interval(v);
    const auto difference = [&](const Circle_disks<Interval>& disks, const Element_part<Interval>& x,
                                const Range& range, const Curve_jet<Interval>& jet) {
      const auto [tangent, change] = y.has_singular_end() ? y.tangent_jet(range) : std::array{jet[1], jet[2]};
      return disks.difference(quotient(x.jet, arc, range, jet, jet[0] - x.jet.point), jet[0], tangent, change);
    };
    const auto add = [&](const Circle_disks<Interval>& disks, const Circle_disks<Interval>& in_middle) {
      Curvature_bounds<Interval> k = difference(disks, part, range, jet)
                                         .around(difference(in_middle, middle, {v, v}, jet_in_middle), shift_u, shift_v)
                                         .bounds();
      k.value += disks.curvature();
      k.du += disks.curvature_derivative();
      result = common_part(result, k);
    };
    if (own != nullptr && own->circle() && dot(part.jet.normal, own->center() - part.jet.point).inf() > 0)
      add(Circle_disks<Interval>::of_element(part.jet, *own), Circle_disks<Interval>::of_element(middle.jet, *own));
    if (const auto disk = y.circle() ? Circle_disks<Interval>::of_points(middle.jet, y) : std::nullopt)
      if (const auto disks = disk->over(part.jet, middle.jet, shift_u))
        add(*disks, *disk);
  }

  Curvature_quotient<Interval> quotient(const Element_part<Interval>& part, std::size_t arc, const Range& range,
                                        const Curve_jet<Interval>& jet) const
  {
    return quotient(part.jet, arc, range, jet, ways().to_arc(part, arc, range, jet));
  }

  Curvature_quotient<Interval> quotient(const Element_jet<Interval>& x, std::size_t arc, const Range& range,
                                        const Curve_jet<Interval>& jet, const Interval_pair& way) const
  {
    const Site_arc_2<Interval>& y = m_graph.arcs()[arc];
    if (!y.has_singular_end())
      return quotient(x, way, jet[1], jet[2], Interval(1));
    const auto [tangent, change] = y.tangent_jet(range);
    return quotient(x, way, tangent, change, y.tangent_factor(range));
  }

  // Whether disks that touch an element and an arc may be nearly those of the curvature of the element: on its own arc,
  // and on one that goes on smoothly.
  bool is_beside_element(std::size_t element, std::size_t arc) const
  {
    const Oriented_element<Interval>& f = m_graph.elements()[element];
    const auto goes_on = [&](bool is_end) {
      const auto& all = m_graph.continuations({f.object, is_end}).smooth;
      return std::any_of(all.begin(), all.end(),
                         [&](const Smooth_continuation<Interval>& next) { return next.end.arc == arc; });
    };
    return !f.is_normal_cone && (f.object == arc || goes_on(false) || goes_on(true));
  }

  // For a point at the end of a way d, which moves with the derivative m D.
  static Curvature_quotient<Interval> quotient(const Element_jet<Interval>& x, const Interval_pair& d,
                                               const Interval_pair& tangent, const Interval_pair& change,
                                               const Interval& factor)
  {
    const Interval two(2);
    Curvature_quotient<Interval> k;
    k.factor = factor;
    k.f = two * dot(x.normal, d);
    k.q = squared_norm(d);
    k.fu = two * dot(x.normal_derivative, d);   // the normal and the derivative of the point are perpendicular
    k.qu = -two * dot(d, x.point_derivative);
    k.fv = two * dot(x.normal, tangent);
    k.qv = two * dot(d, tangent);
    k.fvv = two * dot(x.normal, change);
    k.qvv = two * (factor * squared_norm(tangent) + dot(d, change));
    k.fuv = two * dot(x.normal_derivative, tangent);
    k.quv = -two * dot(x.point_derivative, tangent);
    return k;
  }

  /*
  With the mean derivative D and G = D_u, the mean of (1-t) X'', which has E = <N, G>. Around the middle c of u and v,

    D = X'(c) + h^2/24 X''',  G = X''(c)/2 - h/12 X'''(c) + h^2/48 X'''',  D_v = X''(c)/2 + h/12 X'''(c) + h^2/48 X'''',

  with last derivatives somewhere between u and v; so that little is lost by hulls if h is small.
  */
  Curvature_bounds<Interval> within_arc(const Element_part<Interval>& part, std::size_t arc, const Range& range) const
  {
    const Interval h = interval_of<Interval>(range) - interval_of<Interval>(part.range), hh = CGAL::square(h);
    const Interval middle = (interval_of<Interval>(range) + interval_of<Interval>(part.range)) / Interval(2);
    const Curve_jet<Interval> x = m_graph.arcs()[arc].jet(united(part.range, range)),
                              y = m_graph.arcs()[arc].jet(
                                  {(std::max)(middle.inf(), 0.0), (std::min)(middle.sup(), 1.0)}, 3);
    const Interval two(2), half = Interval(1) / two, third = Interval(1) / Interval(3),
                           sixth = Interval(1) / Interval(6);
    const Interval_pair d = common_part(x[1], y[1] + (hh / Interval(24)) * x[3]), change = (h / Interval(12)) * y[3],
                        rest = (hh / Interval(48)) * x[4];
    const Interval_pair g = common_part(half * x[2], half * y[2] - change + rest),
                        dv = common_part(half * x[2], half * y[2] + change + rest);
    const auto [n, nu] = std::pair(part.jet.normal, part.jet.normal_derivative);
    Curvature_quotient<Interval> k;
    k.f = two * dot(n, g);
    k.q = squared_norm(d);
    k.fu = two * (dot(nu, g) + third * dot(n, x[3]));
    k.qu = two * dot(d, g);
    k.fv = third * dot(n, x[3]);
    k.qv = two * dot(d, dv);
    k.fvv = sixth * dot(n, x[4]);
    k.qvv = two * (squared_norm(dv) + third * dot(d, x[3]));
    k.fuv = third * dot(nu, x[3]) + sixth * dot(n, x[4]);
    k.quv = two * (dot(g, dv) + sixth * dot(d, x[3]));
    return k.bounds();
  }

};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_CURVATURE_H
