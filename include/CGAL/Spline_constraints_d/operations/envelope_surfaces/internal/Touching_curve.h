// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TOUCHING_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TOUCHING_CURVE_H

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/Touching_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// A polynomial piece of a curve, over a range of its parameter: bounds of points and derivatives.
class Curve_nets
{
  std::vector<Interval_net> m_coordinates, m_first, m_second;

  Curve_nets() = default;

public:
  // Bounds over a range.
  struct Frame
  {
    Interval_vector point, first, second;
  };

  //! \pre rounding is upwards, here and below.
  explicit Curve_nets(const Polynomial_piece& curve)
  {
    // numerators of X / w, over w^2 and w^3
    const Power_polynomial& w = curve.weight();
    Homogeneous_polynomials once, twice;
    for (const Power_polynomial& x : curve.numerators()) {
      once.push_back(w * x.derivative(0) - w.derivative(0) * x);
      twice.push_back(w * once.back().derivative(0) - Power_polynomial(2) * w.derivative(0) * once.back());
    }
    once.push_back(w * w);
    twice.push_back(w * w * w);
    const auto nets = [](const Homogeneous_polynomials& list) {
      const std::vector<Tensor> tensors = tensors_of(list);
      return std::vector<Interval_net>(tensors.begin(), tensors.end());
    };
    m_coordinates = nets(curve.coordinates);
    m_first = nets(once);
    m_second = nets(twice);
  }

  Curve_nets restricted(double begin, double end) const
  {
    Curve_nets result;
    for (const auto list : {&Curve_nets::m_coordinates, &Curve_nets::m_first, &Curve_nets::m_second})
      for (const Interval_net& net : this->*list)
        (result.*list).push_back(net.restricted(0, begin, end));
    return result;
  }

  Frame frame() const
  {
    return {Foot_grid::hull_of_quotients(m_coordinates), Foot_grid::hull_of_quotients(m_first),
            Foot_grid::hull_of_quotients(m_second)};
  }

  Foot_grid::Bounds bounds() const { return Foot_grid::Bounds::of(m_coordinates); }
};

/*
Centers F + x n of balls that touch a piece F(u, v) of a surface, with unit normals n, and a piece C(t) of a curve: with
d = F - C,

  |d|^2 + 2 x <d,n> = 0,   <d + x n, C'> = 0.

The unknowns are u, v, t in unit boxes, and x.
*/
class Touching_curve
{
public:
  static constexpr std::size_t equations = 2, unknowns = 4;
  using Interval = CGAL::Interval_nt<false>;
  using Box = std::array<Interval, unknowns>;
  struct Feet
  {
    Foot_frame surface;
    Curve_nets::Frame curve;
  };
  using Graph = Graph_bounds<Feet, unknowns>;

private:
  const Ball_nets* m_surface;
  const Curve_nets* m_curve;
  std::array<std::size_t, 2> m_pieces;
  Interval m_greatest; // of |x|

public:
  //! \pre The nets live longer; rounding is upwards, here and below.
  Touching_curve(const Ball_nets& surface, const Curve_nets& curve, const std::array<std::size_t, 2>& pieces,
                 const Interval& greatest)
    : m_surface(&surface), m_curve(&curve), m_pieces(pieces), m_greatest(greatest)
  {}

  // None if a normal may be zero.
  std::optional<Feet> feet(const Box& box) const
  {
    const std::optional<Foot_frame> frame = nets(box).frame();
    if (!frame)
      return std::nullopt;
    return Feet{*frame, m_curve->restricted(box[2].inf(), box[2].sup()).frame()};
  }

  std::array<Foot_grid::Bounds, 2> bounds(const Box& box) const
  {
    return {nets(box).bounds(), m_curve->restricted(box[2].inf(), box[2].sup()).bounds()};
  }

  // Of x, for these feet; none if there is no such x.
  std::optional<Interval> steps(const Feet& feet) const
  {
    const Interval_vector d = way(feet);
    const Interval height = dot(d, feet.surface.normal), all(-m_greatest.sup(), m_greatest.sup());
    if (height.inf() <= 0 && height.sup() >= 0)
      return all;
    const Interval step = -square_of(d) / (Interval(2) * height);
    return have_common_point(step, all) ? std::optional(intersection(step, all)) : std::nullopt;
  }

  Linear_bounds<equations, unknowns> linear(const Feet& feet, const Interval& x) const
  {
    const Foot_frame& own = feet.surface;
    const Interval_vector d = way(feet), center = combination(d, x, own.normal), &slope = feet.curve.first;
    const Interval two(2);
    Linear_bounds<equations, unknowns> result;
    result.values = {square_of(d) + two * x * dot(d, own.normal), dot(center, slope)};
    for (const std::size_t axis : {0, 1}) {
      result.slopes[0][axis] = two * (dot(d, own.tangents[axis]) + x * dot(d, own.normals[axis]));
      result.slopes[1][axis] = dot(combination(own.tangents[axis], x, own.normals[axis]), slope);
    }
    result.slopes[0][2] = -two * dot(center, slope);
    result.slopes[1][2] = dot(center, feet.curve.second) - square_of(slope);
    result.slopes[0][3] = two * dot(d, own.normal);
    result.slopes[1][3] = dot(own.normal, slope);
    return result;
  }

  // On the surface, and on the curve: there the normal is the direction to the center.
  std::optional<std::array<Touching_balls, 2>> balls(const Graph& graph) const
  {
    std::array<Touching_balls, 2> result;
    Touching_balls &own = result[0], &other = result[1];
    own = balls_on_surface(graph, graph.feet.surface, graph.bounds[0], graph.middle_feet.surface, m_pieces[0], 0,
                           graph.box[3], graph.middle[3], graph.slopes[3]);
    add_mean_values(own);
    other = own;
    const Interval& x = graph.box[3];
    other.is_bounded = x.inf() > 0 || x.sup() < 0;
    if (!other.is_bounded)
      return result;
    const Interval side(x.inf() > 0 ? 1 : -1);
    const auto set = [&](Touching_ball& ball, const Curve_nets::Frame& frame, const Foot_grid::Bounds& foot) {
      ball.foot = foot;
      ball.x = side * ball.x;
      ball.normal = combination({0, 0, 0}, Interval(1) / ball.x, combination(ball.center, Interval(-1), frame.point));
    };
    set(other, graph.feet.curve, graph.bounds[1]);
    set(other.middle, graph.middle_feet.curve, Ball_nets::bounds_of_point(graph.middle_feet.curve.point));
    for (const std::size_t axis : {0, 1})
      other.slopes[axis] = side * own.slopes[axis];
    other.piece = m_pieces[1];
    other.box = {{{graph.box[2].inf(), graph.box[2].sup()}, {0, 1}}};
    return result;
  }

private:
  Ball_nets nets(const Box& box) const
  {
    return m_surface->restricted({{{box[0].inf(), box[0].sup()}, {box[1].inf(), box[1].sup()}}});
  }

  static Interval_vector way(const Feet& feet)
  {
    return combination(feet.surface.point, Interval(-1), feet.curve.point);
  }

  static Interval square_of(const Interval_vector& a)
  {
    return CGAL::square(a[0]) + CGAL::square(a[1]) + CGAL::square(a[2]);
  }
};

} // namespace Envelope_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TOUCHING_CURVE_H
