// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TOUCHING_BALLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TOUCHING_BALLS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_piece.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Interval_net.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

using Interval_vector = std::array<CGAL::Interval_nt<false>, 3>;

inline CGAL::Interval_nt<false> dot(const Interval_vector& a, const Interval_vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Interval_vector combination(const Interval_vector& a, const CGAL::Interval_nt<false>& factor,
                                   const Interval_vector& b)
{
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

// \pre they have a common point.
inline CGAL::Interval_nt<false> intersection(const CGAL::Interval_nt<false>& a, const CGAL::Interval_nt<false>& b)
{
  return {(std::max)(a.inf(), b.inf()), (std::min)(a.sup(), b.sup())};
}

/*
The ball around a point F + x n of the bisector of a surface and a sphere, or a point Q: it touches the surface in the
foot F, with the normal n. With E = F - r n - Q for a sphere of radius r around Q,

  x + r = -|E|^2 / (2 <E,n>).
*/
struct Touching_ball
{
  Foot_grid::Bounds foot;
  Interval_vector normal;
  CGAL::Interval_nt<false> x;
  Interval_vector center;
};

// Feet, their unit normals, and the derivatives of both by the parameters of the piece.
struct Foot_frame
{
  Interval_vector point, normal;
  std::array<Interval_vector, 2> tangents, normals;
};

// Those of feet in a box of a piece, with derivatives by two parameters of the balls: those of the piece, as a rule.
struct Touching_balls : Touching_ball
{
  bool is_bounded = false;                        // else only the next two are known
  CGAL::Interval_nt<false> height;                // <E,n>, zero at poles
  CGAL::Interval_nt<false> distance;              // |x + r|, of the centers from the center of the sphere
  std::array<Interval_vector, 2> tangents;        // derivatives of the feet by the parameters of the piece
  std::array<Interval_vector, 2> normals;         // of the normal by them
  // of the parameters of the piece, each by those of the balls
  std::array<std::array<CGAL::Interval_nt<false>, 2>, 2> foot_slopes{{{1, 0}, {0, 1}}};
  std::array<CGAL::Interval_nt<false>, 2> slopes; // of x
  std::array<Interval_vector, 2> centers;         // of the center
  Touching_ball middle;                           // of the foot in the middle of the box
  std::size_t piece = 0;
  std::array<std::array<double, 2>, 2> box{}; // in the unit box of the piece
  std::array<double, 2> half_widths{};        // of the parameters of the balls

  // Whether the distance has certainly no local minimum at the feet: 1 - x k < 0 for the normal curvature in one of
  // some directions.
  bool are_beyond_focus() const
  {
    const auto form = [&](int a, int b) { return dot(combination(tangents[a], x, normals[a]), tangents[b]); };
    const CGAL::Interval_nt<false> first = form(0, 0), mixed = form(0, 1), second = form(1, 1);
    if (first.sup() < 0 || second.sup() < 0)
      return true;
    for (const double s : {-2., -1., -0.5, 0.5, 1., 2.})
      if ((first + CGAL::Interval_nt<false>(2 * s) * mixed + CGAL::Interval_nt<false>(s * s) * second).sup() < 0)
        return true;
    return false;
  }
};

// Polynomials of a piece, over a box of its parameters.
class Ball_nets
{
  using Interval = CGAL::Interval_nt<false>;

  std::vector<Interval_net> m_coordinates, m_normal;
  std::array<std::vector<Interval_net>, 2> m_tangents; // derivatives of the points, with the denominator
  std::array<std::vector<Interval_net>, 2> m_normals;  // derivatives of the normal
  std::array<double, 2> m_half_widths{0.5, 0.5};

  Ball_nets() = default;

public:
  explicit Ball_nets(const Homogeneous_polynomials& surface)
  {
    const std::vector<Power_polynomial> normal = oriented_normal(normal_of(surface));
    const auto nets = [](const std::vector<Power_polynomial>& list) {
      const std::vector<Tensor> tensors = tensors_of(list);
      return std::vector<Interval_net>(tensors.begin(), tensors.end());
    };
    m_coordinates = nets(surface);
    m_normal = nets(normal);
    const Power_polynomial& w = surface[3];
    for (const int axis : {0, 1}) {
      std::vector<Power_polynomial> tangent, change;
      for (const std::size_t c : {0, 1, 2}) {
        tangent.push_back(w * surface[c].derivative(axis) - w.derivative(axis) * surface[c]);
        change.push_back(normal[c].derivative(axis));
      }
      tangent.push_back(w * w);
      m_tangents[static_cast<std::size_t>(axis)] = nets(tangent);
      m_normals[static_cast<std::size_t>(axis)] = nets(change);
    }
  }

  Ball_nets restricted(const std::array<std::array<double, 2>, 2>& box) const
  {
    const auto part = [&](const std::vector<Interval_net>& nets) {
      std::vector<Interval_net> result;
      for (const Interval_net& net : nets)
        result.push_back(net.restricted(0, box[0][0], box[0][1]).restricted(1, box[1][0], box[1][1]));
      return result;
    };
    Ball_nets result;
    result.m_coordinates = part(m_coordinates);
    result.m_normal = part(m_normal);
    for (const std::size_t axis : {0, 1}) {
      result.m_tangents[axis] = part(m_tangents[axis]);
      result.m_normals[axis] = part(m_normals[axis]);
      result.m_half_widths[axis] = (Interval(m_half_widths[axis]) * (Interval(box[axis][1]) - box[axis][0])).sup();
    }
    return result;
  }

  // Over the box; none if a normal may be zero, or a point has no bounds.
  std::optional<Foot_frame> frame() const
  {
    return frame_of([](const Interval_net& net) { return net.bounds(); }, Foot_grid::hull_of_quotients(m_coordinates));
  }

  Foot_grid::Bounds bounds() const { return Foot_grid::Bounds::of(m_coordinates); }

  // Of a sphere.
  Touching_balls balls(const Interval_vector& center, const Interval& radius) const
  {
    Touching_balls result = first_bounds([](const Interval_net& net) { return net.bounds(); },
                                         Foot_grid::hull_of_quotients(m_coordinates), center, radius);
    result.foot = bounds();
    result.half_widths = m_half_widths;
    if (!result.is_bounded)
      return result;
    const auto in_the_middle = [](const Interval_net& net) { return net(0.5, 0.5); };
    Interval_vector foot;
    for (const std::size_t c : {0, 1, 2})
      foot[c] = in_the_middle(m_coordinates[c]) / in_the_middle(m_coordinates[3]);
    const Touching_balls middle = first_bounds(in_the_middle, foot, center, radius);
    if (!middle.is_bounded) {
      result.is_bounded = false;
      return result;
    }
    result.middle = middle;
    result.middle.foot = bounds_of_point(foot);
    add_mean_values(result);
    return result;
  }

  static Foot_grid::Bounds bounds_of_point(const Interval_vector& point)
  {
    Foot_grid::Bounds result;
    result.point = point;
    result.first = result.second = {0, 0, 0};
    Interval square(0);
    for (const std::size_t c : {0, 1, 2}) {
      result.center[c] = Foot_grid::midpoint(point[c]);
      square += CGAL::square(point[c] - Interval(result.center[c]));
    }
    result.distance = result.radius = square_root(square).sup();
    return result;
  }

private:
  // By the formulas, of bounds of the polynomials.
  template <class Bounds_of_net>
  Touching_balls first_bounds(const Bounds_of_net& bounds, const Interval_vector& foot, const Interval_vector& q,
                              const Interval& radius) const
  {
    Touching_balls result;
    const std::optional<Foot_frame> frame = frame_of(bounds, foot);
    if (!frame) {
      result.height = Interval::largest();
      result.distance = Interval(0, std::numeric_limits<double>::infinity());
      return result;
    }
    result.normal = frame->normal;
    const Interval_vector e = combination(combination(foot, Interval(-1), q), -radius, result.normal);
    result.height = dot(e, result.normal);
    const Interval square = dot_of_squares(e), twice = Interval(2) * result.height;
    if (twice.inf() <= 0 && twice.sup() >= 0) {
      const double greatest = CGAL::abs(twice).sup();
      result.distance = Interval(greatest > 0 ? (Interval(square.inf()) / Interval(greatest)).inf() : 0,
                                 std::numeric_limits<double>::infinity());
      return result;
    }
    const Interval distance = -square / twice;
    result.distance = CGAL::abs(distance);
    result.x = distance - radius;
    result.center = combination(foot, result.x, result.normal);
    result.is_bounded = true;
    result.tangents = frame->tangents;
    result.normals = frame->normals;
    for (const std::size_t axis : {0, 1}) {
      const Interval_vector e_slope = combination(result.tangents[axis], -radius, result.normals[axis]);
      result.slopes[axis] = -Interval(2) * (dot(e, e_slope) + distance * dot(e, result.normals[axis])) / twice;
      result.centers[axis] = combination(combination(result.tangents[axis], result.slopes[axis], result.normal),
                                         result.x, result.normals[axis]);
    }
    return result;
  }

  template <class Bounds_of_net>
  std::optional<Foot_frame> frame_of(const Bounds_of_net& bounds, const Interval_vector& foot) const
  {
    const auto vector = [&](const std::vector<Interval_net>& nets) {
      return Interval_vector{bounds(nets[0]), bounds(nets[1]), bounds(nets[2])};
    };
    const Interval_vector direction = vector(m_normal);
    const Interval length = square_root(dot_of_squares(direction));
    if (!(length.inf() > 0) || !std::isfinite(foot[0].sup() + foot[1].sup() + foot[2].sup()) ||
        !std::isfinite(foot[0].inf() + foot[1].inf() + foot[2].inf()))
      return std::nullopt;
    const Interval_vector zero{0, 0, 0};
    Foot_frame result{foot, combination(zero, Interval(1) / length, direction), {}, {}};
    for (const std::size_t axis : {0, 1}) {
      result.tangents[axis] = tangent(axis, bounds);
      const Interval_vector change = vector(m_normals[axis]);
      // without the part along the normal
      result.normals[axis] =
          combination(zero, Interval(1) / length, combination(change, -dot(result.normal, change), result.normal));
    }
    return result;
  }

  static Interval dot_of_squares(const Interval_vector& a)
  {
    return CGAL::square(a[0]) + CGAL::square(a[1]) + CGAL::square(a[2]);
  }

  template <class Bounds_of_net>
  Interval_vector tangent(std::size_t axis, const Bounds_of_net& bounds) const
  {
    const std::vector<Interval_net>& nets = m_tangents[axis];
    const Interval denominator = bounds(nets[3]);
    Interval_vector result;
    for (const std::size_t c : {0, 1, 2}) {
      result[c] = bounds(nets[c]) / denominator;
      // of a net, the quotients of its values are better bounds
      if (nets[3].bounds().inf() > 0)
        result[c] = intersection(result[c], Interval_net::quotients(nets[c], nets[3]));
    }
    return result;
  }

  // From the middle of the box, along its half widths.
  static void add_mean_values(Touching_balls& balls)
  {
    const auto improve = [&](Interval& value, const Interval& middle, const Interval& by_u, const Interval& by_v) {
      const double change =
          (CGAL::abs(by_u) * Interval(balls.half_widths[0]) + CGAL::abs(by_v) * Interval(balls.half_widths[1])).sup();
      value = intersection(value, middle + Interval(-change, change));
    };
    improve(balls.x, balls.middle.x, balls.slopes[0], balls.slopes[1]);
    for (const std::size_t c : {0, 1, 2}) {
      improve(balls.center[c], balls.middle.center[c], balls.centers[0][c], balls.centers[1][c]);
      improve(balls.normal[c], balls.middle.normal[c], balls.normals[0][c], balls.normals[1][c]);
    }
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_TOUCHING_BALLS_H
