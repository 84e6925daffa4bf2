// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CURVATURE_BOUNDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CURVATURE_BOUNDS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <cstddef>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

using Common::common_part;
using Common::hull;
using Common::in_doubles;

/*
Enclosures of the curvature of a disk and of its derivatives, by the parameter u of the element it touches and by that
of the point v it passes through.

Along an arc with X' = m D, where m >= 0 is zero in the ends, k_v is zero there, whatever the disk. There k_v / m takes
the place of k_v: it has the same sign in the inside, and in the ends it tells where k grows. Then dv = k_v / m, and dvv
and duv are its derivatives. Where it falls with v, k has one maximum. For other arcs m = 1.
*/
template <Enclosing_number Interval = Common::Interval>
struct Curvature_bounds
{
  Interval value = any_number<Interval>(), du = any_number<Interval>(), dv = any_number<Interval>(),
           dvv = any_number<Interval>(), duv = any_number<Interval>();
  Interval factor{1};             // m
  // another point, a common vertex of element and arc, has a larger curvature, or all are negative
  bool is_below_vertex = false;
};

template <Enclosing_number Interval>
Curvature_bounds<Interval> hull(const Curvature_bounds<Interval>& a, const Curvature_bounds<Interval>& b)
{
  return {hull(a.value, b.value),
          hull(a.du, b.du),
          hull(a.dv, b.dv),
          hull(a.dvv, b.dvv),
          hull(a.duv, b.duv),
          hull(a.factor, b.factor),
          a.is_below_vertex && b.is_below_vertex};
}

// A part of an element, with enclosures.
template <Enclosing_number Interval = Common::Interval>
struct Element_part
{
  std::size_t element;
  Range range;
  Element_jet<Interval> jet;
};

inline const Element_part<>& in_doubles(const Element_part<>& part) { return part; }

template <Enclosing_number Number>
Element_part<> in_doubles(const Element_part<Number>& part)
{
  const auto& [point, point_derivative, normal, normal_derivative] = part.jet;
  return {part.element,
          part.range,
          {in_doubles(point), in_doubles(point_derivative), in_doubles(normal), in_doubles(normal_derivative)}};
}

template <Enclosing_number Interval>
Curvature_bounds<Interval> common_part(const Curvature_bounds<Interval>& a, const Curvature_bounds<Interval>& b)
{
  Curvature_bounds<Interval> result;
  result.value = common_part(a.value, b.value);
  result.du = common_part(a.du, b.du);
  result.dv = common_part(a.dv, b.dv);
  result.dvv = common_part(a.dvv, b.dvv);
  result.duv = common_part(a.duv, b.duv);
  result.factor = common_part(a.factor, b.factor);
  result.is_below_vertex = a.is_below_vertex || b.is_below_vertex;
  return result;
}

// What more is known where derivatives are those by v itself.
template <Enclosing_number Interval>
void add_by_tangent(Curvature_bounds<Interval>& result, Curvature_bounds<Interval> more, const Site_arc_2<Interval>& y,
                    const Range& range)
{
  if (y.has_singular_end()) {
    more.factor = y.tangent_factor(range);
    const bool is_divided = more.factor.inf() > 0;
    more.dvv =
        is_divided ? (more.dvv - more.dv * y.relative_change_of_factor(range)) / more.factor : any_number<Interval>();
    more.dv = is_divided ? more.dv / more.factor : any_number<Interval>();
    more.duv = is_divided ? more.duv / more.factor : any_number<Interval>();
  }
  result = common_part(result, more);
}

// Derivatives of an element beside a point Y, where M is the normal turned left: N_u = growth N + turn M and X_u =
// speed M; p = <M, Y - X>, and p_v / m.
template <Enclosing_number Interval>
struct Element_turn
{
  Interval growth = any_number<Interval>(), turn = any_number<Interval>(), speed = any_number<Interval>(),
           p = any_number<Interval>(), pv = any_number<Interval>();

  // For a point at the end of a way, which moves with the derivative m times a tangent.
  static Element_turn beside(const Element_jet<Interval>& x, const std::array<Interval, 2>& way,
                             const std::array<Interval, 2>& tangent)
  {
    const Interval square = squared_norm(x.normal);
    if (!(square.inf() > 0))
      return {};
    const std::array<Interval, 2> along = turned_left(x.normal);
    return {dot(x.normal_derivative, x.normal) / square, dot(x.normal_derivative, along) / square,
            dot(x.point_derivative, along) / square, dot(along, way), dot(along, tangent)};
  }
};

// f / q and its derivatives; those by v are divided by m, and the second ones are derivatives of these quotients.
template <Enclosing_number Interval = Common::Interval>
struct Curvature_quotient
{
  Interval f{0}, q{0}, fu{0}, qu{0}, fv{0}, qv{0}, fvv{0}, qvv{0}, fuv{0}, quv{0};
  Interval factor{1};   // m

  // The common part with the mean value forms around the middle of the ranges.
  Curvature_quotient<Interval> around(const Curvature_quotient<Interval>& middle, const Interval& shift_u,
                                      const Interval& shift_v) const
  {
    Curvature_quotient<Interval> k = *this;
    k.fv = common_part(fv, middle.fv + fuv * shift_u + fvv * shift_v);
    k.qv = common_part(qv, middle.qv + quv * shift_u + qvv * shift_v);
    k.f = common_part(f, middle.f + fu * shift_u + factor * k.fv * shift_v);
    k.q = common_part(q, middle.q + qu * shift_u + factor * k.qv * shift_v);
    return k;
  }

  Curvature_bounds<Interval> bounds() const
  {
    Curvature_bounds<Interval> k;
    k.factor = factor;
    if (!(q.inf() > 0))
      return k;
    k.value = f / q;
    k.du = (fu - k.value * qu) / q;
    k.dv = (fv - k.value * qv) / q;
    k.dvv = (fvv - k.value * qvv - Interval(2) * factor * k.dv * qv) / q;
    k.duv = (fuv - k.du * qv - k.dv * qu - k.value * quv) / q;
    return k;
  }

  /*
  As above, within the mean value forms around the middle of the ranges. Each bound is as good as the others: f_v - k
  q_v has terms that cancel, as where disks are nearly those of the curvature of the arc, of which the mean value form
  shows the difference if f_vv - k q_vv is known. Beside an element

    k_u = growth k + 2 (turn + speed k) p / q.

  Where disks are nearly those of the curvature of the element, as next to a smooth joint and on its own arc, turn +
  speed k is small, which differences of f_u and k q_u do not show.
  */
  Curvature_bounds<Interval> bounds_around(const Curvature_bounds<Interval>& middle, const Interval& shift_u,
                                           const Interval& shift_v,
                                           const std::optional<Element_turn<Interval>>& element = std::nullopt) const
  {
    Curvature_bounds<Interval> k = bounds();
    if (!(q.inf() > 0 && std::isfinite(k.dvv.sup() - k.dvv.inf())))
      return k;
    const Interval two(2);
    const bool is_turn_known = element && std::isfinite(element->turn.sup() - element->turn.inf());
    const auto tighten = [&] {
      k.du = common_part(k.du, (fu - k.value * qu) / q);
      k.value = common_part(k.value, middle.value + k.du * shift_u + factor * k.dv * shift_v);
      k.dvv = common_part(k.dvv, (fvv - k.value * qvv - two * factor * k.dv * qv) / q);
      k.duv = common_part(k.duv, (fuv - k.du * qv - k.dv * qu - k.value * quv) / q);
      if (is_turn_known) {
        const Interval s = element->p / q, sv = (element->pv - s * qv) / q,
                       turn = element->turn + element->speed * k.value;
        k.du = common_part(k.du, element->growth * k.value + two * turn * s);
        k.duv = common_part(k.duv, element->growth * k.dv + two * (element->speed * k.dv * s + turn * sv));
      }
      k.dv = common_part(k.dv, middle.dv + k.duv * shift_u + k.dvv * shift_v);
    };
    constexpr double most_share = 0.5;   // of the width that is left
    double width = std::numeric_limits<double>::infinity();
    const auto is_better = [&] {
      const double last = std::exchange(width, k.dvv.sup() - k.dvv.inf());
      return width < most_share * last;
    };
    do
      tighten();
    while (is_better());
    return k;
  }

  /*
  The positive zero k = (f + r) / (2 q) = 2 m / (r - f) of q k^2 - f k - m, with r^2 = f^2 + 4 m q, and its derivatives,
  by those of the equation; m > 0 does not depend on v.
  */
  Curvature_bounds<Interval> positive_zero(const Interval& m, const Interval& mu) const
  {
    Curvature_bounds<Interval> k;
    k.factor = factor;
    const Interval two(2), square(0, (std::max)(q.sup(), 0.0)),
        r = CGAL::sqrt(CGAL::square(f) + Interval(4) * m * common_part(q, square));
    const double most = (r - f).sup();   // 0 where the points are the same
    k.value = Interval(most > 0 ? (two * m / Interval(most)).inf() : std::numeric_limits<double>::max(),
                       std::numeric_limits<double>::infinity());
    if (!(q.inf() > 0 && r.inf() > 0))
      return k;
    k.value = common_part(k.value, (f + r) / (two * q));
    if (const Interval other = r - f; other.inf() > 0)
      k.value = common_part(k.value, two * m / other);
    const Interval kk = CGAL::square(k.value);
    k.du = (fu * k.value - qu * kk + mu) / r;
    k.dv = (fv - qv * k.value) * k.value / r;
    k.dvv =
        (fvv * k.value - qvv * kk - factor * (two * (two * qv * k.value - fv) * k.dv + two * q * CGAL::square(k.dv))) /
        r;
    k.duv = (fuv * k.value - quv * kk - (two * qu * k.value - fu) * k.dv - (two * qv * k.value - fv) * k.du -
             two * q * k.du * k.dv) /
        r;
    return k;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CURVATURE_BOUNDS_H
