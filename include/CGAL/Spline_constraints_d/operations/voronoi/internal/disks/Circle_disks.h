// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CIRCLE_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CIRCLE_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>

#include <array>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The disks that touch an element from inside of a circle, and that circle: their curvature K(u) has a closed form, and
the disk through a point Y(v) with the curvature k(u,v) = 2 <N, Y - X> / |Y - X|^2 has nearly the same one where it is
nearly that circle. The difference k - K is a quotient f / |Y - X|^2 with a small f, which is not obtained as a
difference of large numbers. With the center C, the radius R and W = X - C,

- where the element lies on the circle, K = |N| / R and f = K (R^2 - |Y - C|^2);
- where the point does, f = 2 (<Y - C, Q> - R |Q|), where Q = K W + N, with |Q| = K R - |N|, points from C to the center
  of the disk. With L = |W|, the cross product c of W and N, q = R^2 - L^2 and m = L |N| - <W, N>,

    |Q| = |N| q / (R + L)^2 + 2 R c^2 / (q m),

  a sum of terms that are known well where X is near the circle, and N nearly points to C.
*/
template <Enclosing_number Interval>
class Circle_disks
{
  using Interval_pair = std::array<Interval, 2>;

  // of |Q|^2 and |N|^2 where disks are nearly concentric with the circle
  static constexpr double most_ratio = 1.0 / 64;

  Interval_pair m_center;
  Interval m_radius;
  bool m_is_element;
  Interval m_curvature, m_curvature_derivative;                     // K, K_u
  Interval m_way{0}, m_way_derivative{0};                           // |Q|, |Q|_u
  Interval_pair m_direction{Interval(0), Interval(0)}, m_direction_derivative{Interval(0), Interval(0)};   // Q, Q_u

public:
  // Of an element on a circle.
  static Circle_disks of_element(const Element_jet<Interval>& x, const Site_arc_2<Interval>& circle)
  {
    Circle_disks result(circle, true);
    const Interval length = CGAL::sqrt(squared_norm(x.normal));
    result.m_curvature = length / result.m_radius;
    result.m_curvature_derivative = dot(x.normal, x.normal_derivative) / (length * result.m_radius);
    return result;
  }

  // Of points on a circle around one point of the element; nothing if the disk is not nearly concentric with that.
  static std::optional<Circle_disks> of_points(const Element_jet<Interval>& x, const Site_arc_2<Interval>& circle)
  {
    // most are not inside: this is cheap
    if (!(squared_norm(x.point - circle.center()).sup() < circle.squared_radius().inf()))
      return std::nullopt;
    Circle_disks result(circle, false);
    return result.set_disk_through_points(x, result.quotient_of_points(x)) &&
            CGAL::square(result.m_way).sup() < (Interval(most_ratio) * squared_norm(x.normal)).inf()
        ? std::optional(result)
        : std::nullopt;
  }

  // The same over a part of the element, by mean value forms around that point; nothing if the part is too long for
  // them.
  std::optional<Circle_disks> over(const Element_jet<Interval>& x, const Element_jet<Interval>& middle,
                                   const Interval& shift) const
  {
    Circle_disks result = *this;
    if (!result.set_disk_through_points(x,
                                        quotient_of_points(x).around(quotient_of_points(middle), shift, Interval(0))))
      return std::nullopt;
    const auto tighten = [&](Interval& value, const Interval& at_middle, const Interval& derivative) {
      value = common_part(value, at_middle + derivative * shift);
    };
    tighten(result.m_curvature, m_curvature, result.m_curvature_derivative);
    tighten(result.m_way, m_way, result.m_way_derivative);
    for (const int i : {0, 1})
      tighten(result.m_direction[i], m_direction[i], result.m_direction_derivative[i]);
    return result;
  }

  const Interval& curvature() const { return m_curvature; }
  const Interval& curvature_derivative() const { return m_curvature_derivative; }

  // Replaces f and its derivatives in the quotient of k by those of k - K, for a point Y with the derivative m T, where
  // T' is known.
  Curvature_quotient<Interval> difference(Curvature_quotient<Interval> k, const Interval_pair& point,
                                          const Interval_pair& tangent, const Interval_pair& change) const
  {
    const Interval two(2);
    const Interval_pair from_center = point - m_center;
    if (m_is_element) {
      const Interval inside = CGAL::square(m_radius) - squared_norm(from_center),
                     along = two * dot(tangent, from_center);
      k.f = m_curvature * inside;
      k.fu = m_curvature_derivative * inside;
      k.fv = -m_curvature * along;
      k.fvv = -m_curvature * two * (k.factor * squared_norm(tangent) + dot(change, from_center));
      k.fuv = -m_curvature_derivative * along;
    } else {
      k.f = two * (dot(from_center, m_direction) - m_radius * m_way);
      k.fu = two * (dot(from_center, m_direction_derivative) - m_radius * m_way_derivative);
      k.fv = two * dot(tangent, m_direction);
      k.fvv = two * dot(change, m_direction);
      k.fuv = two * dot(tangent, m_direction_derivative);
    }
    return k;
  }

private:
  Circle_disks(const Site_arc_2<Interval>& circle, bool is_element)
    : m_center(circle.center()), m_radius(CGAL::sqrt(circle.squared_radius())), m_is_element(is_element)
  {}

  // K = 2 (R |N| + <W, N>) / (R^2 - |W|^2).
  Curvature_quotient<Interval> quotient_of_points(const Element_jet<Interval>& x) const
  {
    const Interval two(2), length = CGAL::sqrt(squared_norm(x.normal));
    const Interval_pair w = x.point - m_center;
    Curvature_quotient<Interval> k;
    k.f = two * (m_radius * length + dot(w, x.normal));
    k.fu = two * (m_radius * dot(x.normal, x.normal_derivative) / length + dot(w, x.normal_derivative));
    k.q = CGAL::square(m_radius) - squared_norm(w);
    k.qu = -two * dot(w, x.point_derivative);
    return k;
  }

  // With what the quotient tells of K, more over long parts than the sum does. Returns whether all numbers are known.
  bool set_disk_through_points(const Element_jet<Interval>& x, const Curvature_quotient<Interval>& quotient)
  {
    const Interval two(2), n = CGAL::sqrt(squared_norm(x.normal)), n_u = dot(x.normal, x.normal_derivative) / n;
    const Interval_pair w = x.point - m_center;
    const Interval l = CGAL::sqrt(squared_norm(w)), q = CGAL::square(m_radius) - squared_norm(w),
                   m = l * n - dot(w, x.normal), c = dot(turned_left(w), x.normal), sum = m_radius + l;
    if (!(q.inf() > 0 && m.inf() > 0))
      return false;
    // the normal and the derivative of the point are perpendicular
    const Interval q_u = -two * dot(w, x.point_derivative), l_u = -q_u / (two * l),
                   m_u = l_u * n + l * n_u - dot(w, x.normal_derivative);
    const Interval c_u = dot(turned_left(x.point_derivative), x.normal) + dot(turned_left(w), x.normal_derivative),
                   tilt = two * m_radius * c / (q * m);
    m_way = n * q / CGAL::square(sum) + two * m_radius * CGAL::square(c) / (q * m);
    m_way_derivative = (n_u * q + n * q_u - two * n * q * l_u / sum) / CGAL::square(sum) +
        tilt * (two * c_u - c * (q_u / q + m_u / m));
    const Curvature_bounds<Interval> k = quotient.bounds();
    m_curvature = common_part(k.value, (m_way + n) / m_radius);
    m_curvature_derivative = common_part(k.du, (m_way_derivative + n_u) / m_radius);
    m_way = common_part(m_way, m_curvature * m_radius - n);
    m_way_derivative = common_part(m_way_derivative, m_curvature_derivative * m_radius - n_u);
    m_direction = m_curvature * w + x.normal;
    m_direction_derivative = m_curvature_derivative * w + m_curvature * x.point_derivative + x.normal_derivative;
    return true;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CIRCLE_DISKS_H
