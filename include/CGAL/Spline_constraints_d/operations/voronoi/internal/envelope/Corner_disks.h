// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Disks that touch two arcs near their common vertex p, in an angle of less than 180 degrees. With X = p + s A on the
element and Y = p + t B on the other arc, s > 0 and t = m s, the curvature of the disk that touches the element in X and
passes through Y is

  k = g(s,m) / s,   g = 2 <N, Z> / |Z|^2,   Z = m B - A,

and g is a smooth function with one maximum in m for small s, also for s = 0. If the other arc is scaled, g is the
positive zero of |Z|^2 g^2 - 2 <N, Z> g - (c^2 - 1) |N|^2; the angle may have any size, and the maximum may be that of
the vertex, m = 0.
*/
template <Enclosing_number Interval = Common::Interval>
class Corner_disks
{
  using Interval_pair = std::array<Interval, 2>;

  static constexpr double far_ratio = 16;   // of the distances from the vertex, in units of the ratio of speeds
  // of the curvature that is attained: the maximum is higher than others, also when it is rounded
  static constexpr double most_share = 1 - 0x1p-20;
  static constexpr int steps = 12, most_halvings = 60;   // in angles that are tiny the maximum is narrow

public:
  // The only maximum of k in t, for all s: a curvature that it exceeds, and whether it is in the vertex.
  struct Maximum
  {
    double least_curvature;
    bool is_in_vertex;
  };

private:
  Interval m_s;
  Interval_pair m_normal, m_a, m_b, m_derivative, m_second;
  double m_speed_ratio;
  std::optional<Interval> m_excess;   // of scaled disks: (c^2 - 1) |N|^2

public:
  // For the part of an element, which begins or ends in one end of its arc, and a range of the other arc that begins or
  // ends there too.
  Corner_disks(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
               const Element_part<Interval>& part, const Arc_end& own, const Arc_end& other, const Range& range)
  {
    const Curve_jet<Interval> x = graph.arcs()[own.arc].jet(part.range, 1), y = graph.arcs()[other.arc].jet(range, 2);
    const Interval own_way(own.is_end ? -1 : 1), way(other.is_end ? -1 : 1);
    m_s = Interval(0, (Interval(part.range.end) - Interval(part.range.begin)).sup());
    m_normal = part.jet.normal;
    m_a = own_way * x[1];
    m_b = m_derivative = way * y[1];
    m_second = y[2];
    m_speed_ratio = std::sqrt(squared_norm(m_a).sup() / squared_norm(m_b).sup());
    if (curvature.is_arc_scaled(other.arc))
      m_excess = curvature.scaled_sites()->excess * squared_norm(m_normal);
  }

  // If k has just one maximum in t, for all s.
  std::optional<Maximum> only_maximum() const
  {
    if (!std::isfinite(m_speed_ratio) || !(m_excess || dot(m_normal, m_b).inf() > 0))
      return std::nullopt;
    const double attained =
        most_share * (std::max)(bounds(Interval(0)).value.inf(), bounds(Interval(m_speed_ratio)).value.inf());
    Stationary_points found = Stationary_points::NONE;
    if (!(attained > 0) || !are_far_points_lower(attained) || !visit_near_points(attained, found))
      return std::nullopt;
    const bool is_in_vertex = found == Stationary_points::NONE;
    if (const Curvature_bounds<Interval> vertex = bounds(Interval(0));
        !is_in_vertex && !(vertex.value.sup() < attained || vertex.dv.inf() > 0))
      return std::nullopt;
    return Maximum{(Interval(attained) / Interval(m_s.sup())).inf(), is_in_vertex};
  }

  // Whether k is less than some number divided by s, for all s.
  bool are_all_lower(double number) const
  {
    Stationary_points found = Stationary_points::NONE;
    return std::isfinite(m_speed_ratio) && bounds(Interval(0)).value.sup() < number && are_far_points_lower(number) &&
        visit_near_points(number, found) && found == Stationary_points::NONE;
  }

private:
  Curvature_bounds<Interval> of_disk(const Curvature_quotient<Interval>& k) const
  {
    return m_excess ? k.positive_zero(*m_excess, Interval(0)) : k.bounds();
  }

  // Of g, and of its derivatives by m.
  Curvature_bounds<Interval> bounds(const Interval& m) const
  {
    const Interval two(2);
    const Interval_pair z = m * m_b - m_a;
    // Products with m are formed last: what the vectors have in common cancels before.
    Curvature_quotient<Interval> k;
    k.q =
        common_part(squared_norm(z), CGAL::square(m) * squared_norm(m_b) - two * m * dot(m_a, m_b) + squared_norm(m_a));
    k.f = two * (m * dot(m_normal, m_b) - dot(m_normal, m_a));
    k.fv = two * dot(m_normal, m_derivative);
    k.qv = two * (m * dot(m_b, m_derivative) - dot(m_a, m_derivative));
    k.fvv = two * m_s * dot(m_normal, m_second);
    k.qvv = two * (squared_norm(m_derivative) + m_s * dot(z, m_second));
    return of_disk(k);
  }

  // With l = s / t, t k is what g is with B - l A in place of Z; where t > M s, k is below that bound divided by M s.
  bool are_far_points_lower(double attained) const
  {
    const Interval most = Interval(far_ratio) * Interval(m_speed_ratio), l(0, (Interval(1) / most).sup());
    const Interval_pair z = m_b - l * m_a;
    Curvature_quotient<Interval> k;
    k.f = Interval(2) * (dot(m_normal, m_b) - l * dot(m_normal, m_a));
    k.q = squared_norm(z);
    return (of_disk(k).value - Interval(attained) * most).sup() < 0;
  }

  // What has been found up to some m: none; some, up to there; or some, and none behind them.
  enum class Stationary_points { NONE, HERE, BEFORE };

  // Whether g has at most one maximum of at least what is attained: all points where it may be stationary, and that
  // high, are next to each other, and g_mm < 0 there.
  bool visit_near_points(double attained, Stationary_points& found) const
  {
    const double most = (Interval(far_ratio) * Interval(m_speed_ratio)).sup();
    // steps grow with m
    const auto end = [&](int k) { return k == steps ? most : m_speed_ratio * far_ratio * k * k / (steps * steps); };
    for (int i = 0; i < steps; ++i)
      if (!visit(end(i), end(i + 1), attained, most_halvings, found))
        return false;
    return true;
  }

  // Visits a range of m. Returns false when there may be two maxima.
  bool visit(double begin, double end, double attained, int halvings, Stationary_points& found) const
  {
    const Curvature_bounds<Interval> k = bounds(Interval(begin, end));
    const auto slope = [&](double m) { return certain_sign(bounds(Interval(m)).dv); };
    if (k.value.sup() < attained || certain_sign(k.dv) != 0 ||
        (k.dvv.sup() < 0 && (slope(begin) < 0 || slope(end) > 0))) {
      if (found == Stationary_points::HERE)
        found = Stationary_points::BEFORE;
      return true;
    }
    if (k.dvv.sup() < 0) {
      const bool is_first = found != Stationary_points::BEFORE;   // else there may be a low minimum between
      found = Stationary_points::HERE;
      return is_first;
    }
    const double middle = begin + (end - begin) / 2;
    return halvings > 0 && visit(begin, middle, attained, halvings - 1, found) &&
        visit(middle, end, attained, halvings - 1, found);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_DISKS_H
