// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICIT_PATCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICIT_PATCH_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/patch_cells.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
A patch A as a part of the set Z where a polynomial f is zero and linear functions, its sides, are not negative. It is
open and closed in Z: a connected set of points of Z belongs to the patch, if one of them does.

This holds if f is regular on A and <grad f, A_u x A_v> has the same sign everywhere, so that A maps neighbourhoods of
its parameters onto neighbourhoods in f = 0, also at seams and breaks; and if each edge, where the patch ends, is in the
plane of a side, which has the patch on one side of it and does not touch it there. An edge that is one point is inside
of the patch, if f is regular in it and the other axis is closed: the patch goes around it. Otherwise it is a tip, where
all this may not be true.
*/
class Implicit_patch
{
  using Tensor = Bernstein_tensor<Exact_rational>;
  using Exact_point = std::array<Exact_rational, 3>;

  const Spline_patch<3>& m_patch;
  Power_polynomial m_polynomial;
  std::array<Power_polynomial, 3> m_gradient;
  std::vector<Power_polynomial> m_sides;
  std::vector<Exact_point> m_tips;

public:
  // Of a patch that satisfies an equation. Nothing if the above is not proved. The patch is not copied.
  static std::optional<Implicit_patch> make(const Spline_patch<3>& patch, const Power_polynomial& polynomial)
  {
    Implicit_patch result(patch, polynomial);
    return result.find_sides() && result.is_open() ? std::optional(std::move(result)) : std::nullopt;
  }

  const Power_polynomial& polynomial() const { return m_polynomial; }
  const std::vector<Power_polynomial>& sides() const { return m_sides; }
  const std::vector<Exact_point>& tips() const { return m_tips; }

  /*
  Whether a point of Z, in some bounds, is proved to be a point of the patch, near one with given parameters. In a box
  around it and a point of the patch, let f = 0 be the graph of a function of two coordinates, all over the rectangle,
  and all sides but one positive; let this one be monotone along one of these coordinates on the graph, and positive
  where that ends. Then the part of Z in the box is connected.
  */
  bool contains(const Vector_bounds<3>& point, const std::array<double, 2>& parameters_near) const
  {
    std::vector<Exact_rational> parameters;
    for (int axis = 0; axis < 2; ++axis) {
      const auto [begin, end] = m_patch.domain(axis);
      parameters.push_back((std::min)((std::max)(Exact_rational(parameters_near[axis]), begin), end));
    }
    const Exact_point near = m_patch(parameters);
    Vector_bounds<3> both = point;
    Exact_rational size(0);
    for (std::size_t i = 0; i < 3; ++i) {
      both[i] = hull(both[i], Rational_interval(near[i]));
      size = (std::max)(size, Exact_rational(both[i].upper - both[i].lower));
    }
    const Mpfr_precision_scope precision(256);
    size = (std::max)(size, Exact_rational(0x1p-60));
    const Near_point local(*this, rounded(near), both);
    constexpr int most_enlargements = 12;
    for (int k = 0; k < most_enlargements; ++k, size *= 8)
      for (std::size_t height = 0; height < 3; ++height)
        if (local.is_connected_in(size, height))
          return true;
    return false;
  }

private:
  Implicit_patch(const Spline_patch<3>& patch, const Power_polynomial& polynomial)
    : m_patch(patch), m_polynomial(polynomial)
  {
    for (int i = 0; i < 3; ++i)
      m_gradient[i] = polynomial.derivative(i);
  }

  bool is_singular(const Exact_point& p) const
  {
    return std::all_of(m_gradient.begin(), m_gradient.end(),
                       [&](const Power_polynomial& f) { return CGAL::is_zero(f(p)); });
  }

  Exact_rational place(int axis, int end) const
  {
    const auto [first, last] = m_patch.domain(axis);
    return end == 0 ? first : last;
  }

  Spline_patch<3> edge(int axis, int end) const { return m_patch.part(axis, {place(axis, end), place(axis, end)}); }

  // Whether all edges have a side, or need none.
  bool find_sides()
  {
    for (const int axis : {0, 1})
      for (const int end : {0, 1})
        if (!m_patch.is_closed(axis) && !find_side(axis, end))
          return false;
    return true;
  }

  bool find_side(int axis, int end)
  {
    const Spline_patch<3> own = edge(axis, end), opposite = edge(axis, 1 - end);
    const bool is_pole = own.is_one_point();
    const Exact_point point = own(own.first_corner());
    if (is_pole && m_patch.is_closed(1 - axis) && !is_singular(point))
      return true;
    if (is_pole)
      m_tips.push_back(point);
    const std::optional<Exact_point> normal =
        is_pole ? (opposite.is_one_point() ? std::nullopt : normal_of(opposite)) : normal_of(own);
    if (!normal)
      return false;
    Power_polynomial side;
    for (int i = 0; i < 3; ++i)
      side += Power_polynomial((*normal)[i]) * (Power_polynomial::variable(i) - Power_polynomial(point[i]));
    for (const Power_polynomial& oriented : {side, -side})
      if (is_side(oriented, axis, end)) {
        m_sides.push_back(oriented);
        return true;
      }
    return false;
  }

  // Of a plane of an edge; of a straight one, at a right angle to the surface.
  std::optional<Exact_point> normal_of(const Spline_patch<3>& edge) const
  {
    const auto [begin, end] = edge.domain(0);
    std::array<Exact_point, 3> points;
    for (int k = 0; k < 3; ++k)
      points[k] = edge(std::array{Exact_rational(begin + (end - begin) * Exact_rational(k, 3))});
    const Exact_point chord = difference(points[1], points[0]);
    Exact_point normal = cross(chord, difference(points[2], points[0])), slope;
    for (std::size_t i = 0; i < 3; ++i)
      slope[i] = m_gradient[i](points[1]);
    if (normal == Exact_point{})
      normal = cross(chord, slope);
    return normal == Exact_point{} ? std::nullopt : std::optional(normal);
  }

  static Exact_point difference(const Exact_point& a, const Exact_point& b)
  {
    return {Exact_rational(a[0] - b[0]), Exact_rational(a[1] - b[1]), Exact_rational(a[2] - b[2])};
  }

  template <class Vector>
  static Vector cross(const Vector& a, const Vector& b)
  {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  // Whether a linear function is not negative on the patch, zero on an edge, and grows from there.
  bool is_side(const Power_polynomial& side, int axis, int end) const
  {
    bool result = true;
    for_each_cell(m_patch, [&](const Patch_cell& cell) {
      const Tensor value = composed(side, 1, cell.functions);
      if (!result || value.bounds().first < 0) {
        result = false;
        return;
      }
      if (!cell.is_at_edge[axis][end])
        return;
      const Tensor slope = end == 0 ? value.derivative(axis) : -value.derivative(axis);
      result = value.face(axis, end).bounds().second == 0 && value.degree(axis) > 0 &&
          slope.face(axis, end).bounds().first > 0;
    });
    return result;
  }

  // Whether <grad f, A_u x A_v> has one sign, except at poles.
  bool is_open() const
  {
    int sign = 0;
    bool result = true;
    for_each_cell(m_patch, [&](const Patch_cell& cell) {
      std::array<std::array<bool, 2>, 2> may_be_zero{};
      for (const int axis : {0, 1})
        for (const int end : {0, 1})
          may_be_zero[axis][end] = cell.is_at_edge[axis][end] && m_patch.pole(axis, place(axis, end));
      result = result && has_sign(orientation(cell.functions), may_be_zero, sign, 0);
    });
    return result;
  }

  Tensor orientation(const std::array<Tensor, 4>& x) const
  {
    std::array<std::array<Tensor, 3>, 2> tangents;
    for (int axis = 0; axis < 2; ++axis)
      for (std::size_t i = 0; i < 3; ++i)
        tangents[axis][i] = x[i].derivative(axis) * x[3] - x[i] * x[3].derivative(axis);
    const std::array<Tensor, 3> normal = cross(tangents[0], tangents[1]);
    const int degree = m_polynomial.total_degree() - 1;
    return composed(m_gradient[0], degree, x) * normal[0] + composed(m_gradient[1], degree, x) * normal[1] +
        composed(m_gradient[2], degree, x) * normal[2];
  }

  // The same sign everywhere, except on some edges; 0: that of the first coefficient that has one.
  static bool has_sign(const Tensor& value, const std::array<std::array<bool, 2>, 2>& may_be_zero, int& sign, int depth)
  {
    const auto [least, greatest] = value.bounds();
    if (sign == 0)
      sign = least >= 0 ? 1 : greatest <= 0 ? -1 : 0;
    if (sign != 0 && (sign > 0 ? least >= 0 : greatest <= 0) && !has_zeros(value, may_be_zero))
      return true;
    constexpr int most = 4;
    if (depth == most)
      return false;
    const int axis = depth % 2;
    const auto [lower, upper] = value.split(axis);
    std::array<std::array<bool, 2>, 2> of_lower = may_be_zero, of_upper = may_be_zero;
    of_lower[axis][1] = of_upper[axis][0] = false;
    return has_sign(lower, of_lower, sign, depth + 1) && has_sign(upper, of_upper, sign, depth + 1);
  }

  // Where the coefficients have one sign: inside, on an edge or at a corner that is not on an edge where there may be
  // some.
  static bool has_zeros(const Tensor& value, const std::array<std::array<bool, 2>, 2>& may_be_zero)
  {
    const auto is_zero = [](const Tensor& t) {
      return std::all_of(t.coefficients().begin(), t.coefficients().end(),
                         [](const Exact_rational& x) { return x == 0; });
    };
    bool result = is_zero(value);
    for (const int axis : {0, 1})
      for (const int end : {0, 1})
        if (!may_be_zero[axis][end]) {
          const Tensor face = value.face(axis, end);
          result = result || is_zero(face);
          for (const int corner : {0, 1})
            result = result || (!may_be_zero[1 - axis][corner] && is_zero(face.face(0, corner)));
        }
    return result;
  }

  static Exact_point rounded(const Exact_point& p)
  {
    return {Exact_rational(CGAL::to_double(p[0])), Exact_rational(CGAL::to_double(p[1])),
            Exact_rational(CGAL::to_double(p[2]))};
  }

  // The equation and the sides in coordinates around a point, where enclosures of their values are tight.
  class Near_point
  {
    using Interval_box = std::array<Mpfr_interval, 3>;

    Power_polynomial m_polynomial;
    std::vector<Power_polynomial> m_sides;
    Vector_bounds<3> m_bounds;

  public:
    Near_point(const Implicit_patch& patch, const Exact_point& origin, Vector_bounds<3> bounds)
      : m_polynomial(moved(patch.m_polynomial, origin)), m_bounds(std::move(bounds))
    {
      for (const Power_polynomial& side : patch.m_sides)
        m_sides.push_back(moved(side, origin));
      for (std::size_t i = 0; i < 3; ++i)
        m_bounds[i] = m_bounds[i] - Rational_interval(origin[i]);
    }

    // In the bounds, to which a size is added, and more of it to the height.
    bool is_connected_in(const Exact_rational& size, std::size_t height) const
    {
      Vector_bounds<3> bounds = m_bounds;
      Interval_box box;
      for (std::size_t i = 0; i < 3; ++i) {
        const Exact_rational margin(i == height ? Exact_rational(4 * size) : size);
        bounds[i] = {Exact_rational(bounds[i].lower - margin), Exact_rational(bounds[i].upper + margin)};
        box[i] = Mpfr_interval(bounds[i].lower, bounds[i].upper);
      }
      const auto face = [&](std::size_t axis, int end) {
        Interval_box result = box;
        const Exact_rational& value = end == 0 ? bounds[axis].lower : bounds[axis].upper;
        result[axis] = Mpfr_interval(value, value);
        return result;
      };
      const Power_polynomial slope = m_polynomial.derivative(static_cast<int>(height));
      const CGAL::Sign below = certain_sign(m_polynomial, face(height, 0));
      if (certain_sign(slope, box) == CGAL::ZERO || below == CGAL::ZERO ||
          certain_sign(m_polynomial, face(height, 1)) != -below)
        return false;
      const auto is_monotone = [&](const Power_polynomial& side, std::size_t axis) {
        return certain_sign(side.derivative(static_cast<int>(axis)) * slope -
                                side.derivative(static_cast<int>(height)) *
                                    m_polynomial.derivative(static_cast<int>(axis)),
                            box) != CGAL::ZERO;
      };
      const auto is_positive_at_end = [&](const Power_polynomial& side, std::size_t axis) {
        return certain_sign(side, face(axis, 0)) == CGAL::POSITIVE ||
            certain_sign(side, face(axis, 1)) == CGAL::POSITIVE;
      };
      std::size_t open = 0;
      return std::all_of(m_sides.begin(), m_sides.end(), [&](const Power_polynomial& side) {
        if (certain_sign(side, box) == CGAL::POSITIVE)
          return true;
        bool result = false;
        for (std::size_t axis = 0; axis < 3; ++axis)
          result = result || (axis != height && is_positive_at_end(side, axis) && is_monotone(side, axis));
        return result && open++ == 0;
      });
    }

  private:
    static Power_polynomial moved(Power_polynomial f, const Exact_point& origin)
    {
      for (int i = 0; i < 3; ++i)
        f = f.substituted(i, Power_polynomial::variable(i) + Power_polynomial(origin[static_cast<std::size_t>(i)]));
      return f;
    }

    static CGAL::Sign certain_sign(const Power_polynomial& f, const Interval_box& box)
    {
      const auto sign = f.value(std::span<const Mpfr_interval>(box)).sign();
      return CGAL::is_certain(sign) ? CGAL::get_certain(sign) : CGAL::ZERO;
    }
  };
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_IMPLICIT_PATCH_H
