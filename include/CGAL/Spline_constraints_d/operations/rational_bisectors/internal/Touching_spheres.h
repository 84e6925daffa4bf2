// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TOUCHING_SPHERES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TOUCHING_SPHERES_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

/*
Spheres that touch a piece X / w of a surface along a whole line where one parameter is constant, as in cylinders,
cones, tori and other canal surfaces, and surfaces of revolution. With the two ends of a line and the normal N at the
first one, the center is on N, as far from one as from the other: with e the difference of both times both weights v, w,

  C = X / w + |e|^2 N / (2 v w <N,e>).

That the sphere touches along the line is the identity (C - X / w) x N = 0.
*/
class Touching_spheres
{
public:
  using Interval = CGAL::Interval_nt<false>;
  using Box = std::array<std::array<double, 2>, 2>;

private:
  Homogeneous_polynomials m_center;
  std::vector<Interval_net> m_nets;
  std::vector<Interval_net> m_slope_nets; // of the numerators of the derivative by the other parameter, its denominator
  std::size_t m_along;
  Power_polynomial m_squared_way, m_squared_weight; // the radius is the root of their quotient
  bool m_has_one_radius;

  Touching_spheres(const Homogeneous_polynomials& center, const Polynomial_vector& way, const Power_polynomial& weight,
                   std::size_t along)
    : m_center(center), m_along(along)
  {
    m_squared_way = dot(way, way);
    m_squared_weight = weight * weight;
    const std::array<Exact_rational, 2> zero{0, 0};
    m_has_one_radius = m_squared_way * Power_polynomial(m_squared_weight(zero)) ==
        m_squared_weight * Power_polynomial(m_squared_way(zero));
    const int across = 1 - static_cast<int>(along);
    const Power_polynomial& w = center[3];
    Homogeneous_polynomials slope;
    for (const std::size_t c : {0, 1, 2})
      slope.push_back(w * center[c].derivative(across) - w.derivative(across) * center[c]);
    slope.push_back(w * w);
    for (const Tensor& f : tensors_of(center))
      m_nets.emplace_back(f);
    for (const Tensor& f : tensors_of(slope))
      m_slope_nets.emplace_back(f);
  }

public:
  // \pre rounding is upwards, here and below.
  static std::optional<Touching_spheres> of(const Homogeneous_polynomials& surface, std::size_t along)
  {
    const std::vector<Power_polynomial> normal = oriented_normal(normal_of(surface));
    const auto at_end = [&](const std::vector<Power_polynomial>& all, int end) {
      std::vector<Power_polynomial> result;
      for (const Power_polynomial& f : all)
        result.push_back(f.substituted(static_cast<int>(along), Power_polynomial(end)));
      return result;
    };
    const Homogeneous_polynomials first = at_end(surface, 0), last = at_end(surface, 1), direction = at_end(normal, 0);
    const Polynomial_vector x{first[0], first[1], first[2]}, n{direction[0], direction[1], direction[2]},
        e = first[3] * Polynomial_vector{last[0], last[1], last[2]} - last[3] * x;
    const Power_polynomial height = Power_polynomial(2) * dot(n, e);
    if (height.is_zero())
      return std::nullopt;
    const Homogeneous_polynomials center = reduced(last[3] * height * x + dot(e, e) * n, first[3] * last[3] * height);
    const Polynomial_vector way = surface[3] * Polynomial_vector{center[0], center[1], center[2]} -
        center[3] * Polynomial_vector{surface[0], surface[1], surface[2]};
    if (!is_zero(cross(way, {normal[0], normal[1], normal[2]})))
      return std::nullopt;
    return Touching_spheres(center, way, surface[3] * center[3], along);
  }

  // The parameter of the lines.
  std::size_t along() const { return m_along; }

  // Whether they are one sphere: the piece is a part of it.
  bool are_one() const
  {
    return m_center[3].is_constant() && m_center[0].is_constant() && m_center[1].is_constant() &&
        m_center[2].is_constant() && m_has_one_radius;
  }

  // Whether the spheres are those of another piece, for the same other parameter.
  bool are_same(const Touching_spheres& other) const
  {
    for (const std::size_t c : {0, 1, 2})
      if (!(m_center[c] * other.m_center[3] == other.m_center[c] * m_center[3]))
        return false;
    return m_along == other.m_along && m_squared_way * other.m_squared_weight == other.m_squared_way * m_squared_weight;
  }

  // Of the feet of balls.
  struct Spheres
  {
    Interval_vector center;
    Interval gap;                   // how much greater their radii are than those of the balls, on the same side
    std::array<Interval, 2> slopes; // derivatives of it
  };

  // None if a radius may be zero.
  std::optional<Spheres> spheres(const Touching_balls& balls) const
  {
    const auto part = [&](const Interval_net& net) {
      return net.restricted(0, balls.box[0][0], balls.box[0][1]).restricted(1, balls.box[1][0], balls.box[1][1]);
    };
    std::vector<Interval_net> center, slope;
    for (const Interval_net& net : m_nets)
      center.push_back(part(net));
    for (const Interval_net& net : m_slope_nets)
      slope.push_back(part(net));
    const Interval weight = center[3].bounds();
    if (weight.inf() <= 0 && weight.sup() >= 0)
      return std::nullopt;
    Spheres result;
    result.center = Foot_grid::hull_of_quotients(center);
    Interval_vector way, change;
    for (const std::size_t c : {0, 1, 2}) {
      way[c] = result.center[c] - balls.foot.point[c];
      change[c] = slope[c].bounds() / slope[3].bounds();
    }
    const Interval radius = dot(way, balls.normal);
    if (radius.inf() <= 0 && radius.sup() >= 0)
      return std::nullopt;
    const Interval side(radius.inf() > 0 ? 1 : -1);
    result.gap = side * (radius - balls.x);
    for (const std::size_t axis : {0, 1})
      result.slopes[axis] =
          side * (balls.foot_slopes[1 - m_along][axis] * dot(change, balls.normal) - balls.slopes[axis]);
    // from the middle of the box on
    for (const std::size_t c : {0, 1, 2})
      way[c] = center[c](0.5, 0.5) / center[3](0.5, 0.5) - balls.middle.foot.point[c];
    Interval gap = side * (dot(way, balls.middle.normal) - balls.middle.x);
    for (const std::size_t axis : {0, 1}) {
      const double greatest = (CGAL::abs(result.slopes[axis]) * Interval(balls.half_widths[axis])).sup();
      gap += Interval(-greatest, greatest);
    }
    result.gap = intersection(result.gap, gap);
    return result;
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TOUCHING_SPHERES_H
