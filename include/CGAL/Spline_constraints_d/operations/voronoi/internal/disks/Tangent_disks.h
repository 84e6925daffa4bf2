// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_TANGENT_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_TANGENT_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_expansion.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/second_derivatives.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The disks that touch an element in X(u), with the normal N(u), and the line or circle of an arc. With a point P and a
normal M of the line, on the side of the element, or the center C and radius r of the circle and s = 1 outside of it, -1
inside, their curvature in units of the normal is

  k = (|M| |N| - <M, N>) / <M, X - P>    or    k = 2 (r |N| - s <N, X - C>) / (s (|X - C|^2 - r^2)),

a function of u alone: it does not depend on how well it is known where the disks touch the arc, if that is in its
inside.
*/
template <Enclosing_number Interval = Common::Interval>
class Tangent_disks
{
  using Interval_pair = std::array<Interval, 2>;

  // Numerator and denominator of k, and their derivatives.
  struct Quotient
  {
    Interval f, q, fu, qu, fuu, quu;

    Interval value() const { return f / q; }
    Interval slope(const Interval& k) const { return (fu - k * qu) / q; }
    Interval second_derivative(const Interval& k, const Interval& ku) const
    {
      return (fuu - Interval(2) * ku * qu - k * quu) / q;
    }
  };

  Quotient m_at_middle, m_over_part;
  Interval m_shift;   // from the middle
  Interval m_value;   // over the part
  Curvature_expansion<Interval> m_expansion;

public:
  // Nothing where it is not certain that all of them touch the arc in its inside.
  static std::optional<Tangent_disks> over(const Site_graph_2<Interval>& graph,
                                           const Disk_curvature<Interval>& curvature,
                                           const Element_part<Interval>& part, std::size_t arc)
  {
    const Site_arc_2<Interval>& y = graph.arcs()[arc];
    const int side =
        y.is_on_line_or_circle() && !y.turns_back() && !curvature.is_arc_scaled(arc) ? side_of(y, part) : 0;
    if (side == 0 || !is_touched_inside(y, curvature, part, arc))
      return std::nullopt;
    const double u = part.range.middle();
    const Tangent_disks result(quotient(graph, y, side, curvature.part(part.element, {u, u})),
                               quotient(graph, y, side, part), interval_of<Interval>(part.range) - Interval(u));
    return result.value().inf() > 0 && std::isfinite(result.value().sup()) ? std::optional(result) : std::nullopt;
  }

  // The curvature over the part, and with its derivatives.
  const Interval& value() const { return m_value; }
  const Curvature_expansion<Interval>& expansion() const { return m_expansion; }

  // The difference of this curvature f / q and another one, times q: where the element is next to the line or circle,
  // and q small, derivatives of f and q change less than those of f / q.
  Curvature_expansion<Interval> difference(const Curvature_expansion<Interval>& other) const
  {
    const auto value = [](const Quotient& x, const Interval& k) { return x.f - k * x.q; };
    const auto slope = [](const Quotient& x, const Interval& k, const Interval& ku) {
      return x.fu - ku * x.q - k * x.qu;
    };
    const Interval k = other.value(m_shift), ku = other.derivative(m_shift);
    return {value(m_at_middle, other.at_middle), slope(m_at_middle, other.at_middle, other.slope_at_middle),
            slope(m_over_part, k, ku),
            m_over_part.fuu - other.second_derivative * m_over_part.q - Interval(2) * ku * m_over_part.qu -
                k * m_over_part.quu};
  }

private:
  Tangent_disks(const Quotient& at_middle, const Quotient& over_part, const Interval& shift)
    : m_at_middle(at_middle), m_over_part(over_part), m_shift(shift), m_value(over_part.value())
  {
    constexpr int rounds = 2;   // of mean value forms, each of which makes the others better
    m_expansion.at_middle = at_middle.value();
    m_expansion.slope_at_middle = at_middle.slope(m_expansion.at_middle);
    for (int i = 0; i < rounds; ++i) {
      m_expansion.slope = common_part(over_part.slope(m_value), m_expansion.derivative(shift));
      m_expansion.second_derivative =
          common_part(m_expansion.second_derivative, over_part.second_derivative(m_value, m_expansion.slope));
      m_value = common_part(m_value, m_expansion.value(shift));
    }
  }

  /*
  Disks through the points of a line or circle have one greatest and one least curvature, and those where it is positive
  are connected: the greatest one is between two points if it grows from each of them towards the other one; and between
  one outside of these and one of them, from which it grows towards the former.
  */
  static bool is_touched_inside(const Site_arc_2<Interval>& y, const Disk_curvature<Interval>& curvature,
                                const Element_part<Interval>& part, std::size_t arc)
  {
    const auto at = [&](double v) { return curvature(part, arc, {v, v}, y.jet({v, v})); };
    const auto begin = at(0), end = at(1);
    const bool grows = begin.dv.inf() > 0, falls = end.dv.sup() < 0;
    return (grows && falls) || (begin.value.sup() <= 0 && end.value.inf() > 0 && falls) ||
        (end.value.sup() <= 0 && begin.value.inf() > 0 && grows);
  }

  // On which side of the direction of a line, or of a circle, a part is.
  static int side_of(const Site_arc_2<Interval>& y, const Element_part<Interval>& part)
  {
    if (y.is_straight())
      return certain_sign(dot(turned_left(along(y)), part.jet.point - y.point({0, 0})));
    return certain_sign(squared_norm(part.jet.point - y.center()) - y.squared_radius());
  }

  static Interval_pair along(const Site_arc_2<Interval>& y) { return y.point({1, 1}) - y.point({0, 0}); }

  static Quotient quotient(const Site_graph_2<Interval>& graph, const Site_arc_2<Interval>& y, int side,
                           const Element_part<Interval>& part)
  {
    const auto& [x, xu, n, nu] = part.jet;
    const auto [xuu, nuu] = second_derivatives(graph, part);
    const Interval norm = CGAL::sqrt(squared_norm(n)), norm_u = dot(n, nu) / norm,
                   norm_uu = (squared_norm(nu) + dot(n, nuu) - CGAL::square(norm_u)) / norm;
    if (y.is_straight()) {
      const Interval_pair m = Interval(side) * turned_left(along(y));
      const Interval length = CGAL::sqrt(squared_norm(m));
      return {length * norm - dot(m, n),      dot(m, x - y.point({0, 0})),
              length * norm_u - dot(m, nu),   dot(m, xu),
              length * norm_uu - dot(m, nuu), dot(m, xuu)};
    }
    const Interval two(2), s(side), radius = CGAL::sqrt(y.squared_radius());
    const Interval_pair d = x - y.center();
    return {two * (radius * norm - s * dot(n, d)),
            s * (squared_norm(d) - y.squared_radius()),
            two * (radius * norm_u - s * dot(nu, d)),
            s * two * dot(d, xu),
            two * (radius * norm_uu - s * (dot(nuu, d) + dot(nu, xu))),
            s * two * (squared_norm(xu) + dot(d, xuu))};
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_TANGENT_DISKS_H
