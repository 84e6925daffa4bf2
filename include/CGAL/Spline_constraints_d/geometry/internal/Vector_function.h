// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_VECTOR_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_VECTOR_FUNCTION_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The ranges of parameters, one for each axis.
using Exact_box = std::vector<std::pair<Exact_rational, Exact_rational>>;

/*
An exact spline in the formula of a construction. Its operators are those of splines, with short cuts for what such
formulas consist of: sums on the same knots, and products of functions of different parameters, among them constants,
whose control points are sums and products of control points.
*/
class Scalar_function
{
  Exact_function m_function;

public:
  Scalar_function() = default;
  Scalar_function(Exact_function function) : m_function(std::move(function)) {}

  Scalar_function(const Exact_box& domain, const Exact_rational& value);

  const Exact_function& function() const { return m_function; }

  Exact_box domain() const;

  // The same as a function of more parameters, which depends on the given axis only.
  Scalar_function on_axis(const Exact_box& domain, int axis) const { return m_function.embedded(domain, {axis}); }

  friend Scalar_function operator+(const Scalar_function& a, const Scalar_function& b);

  friend Scalar_function operator*(const Scalar_function& a, const Scalar_function& b);

  friend Scalar_function operator*(const Scalar_function& a, const Exact_rational& factor)
  {
    return a.m_function * factor;
  }
  friend Scalar_function operator-(const Scalar_function& a, const Scalar_function& b)
  {
    return a + b * Exact_rational(-1);
  }
  friend bool operator==(const Scalar_function& a, const Scalar_function& b) { return a.m_function == b.m_function; }

private:
  // Whether along every axis at most one of them has more than one control point.
  static bool have_separate_parameters(const Exact_function& f, const Exact_function& g);
};

// A vector whose coordinates are exact splines: what constructions compute with. Formulas for points of curves and
// surfaces are written with it as they are for vectors.
template <int d>
struct Vector_function
{
  std::array<Scalar_function, d> x;

  Vector_function() = default;

  explicit Vector_function(const std::array<Exact_function, d>& functions)
  {
    std::copy(functions.begin(), functions.end(), x.begin());
  }

  template <class Vector>
  Vector_function(const Exact_box& domain, const Vector& constant)
    : Vector_function(by_coordinate([&](int i) { return Scalar_function(domain, constant.cartesian(i)); }))
  {}

  std::array<Exact_function, d> functions() const
  {
    std::array<Exact_function, d> result;
    std::transform(x.begin(), x.end(), result.begin(), [](const Scalar_function& f) { return f.function(); });
    return result;
  }

  friend Vector_function operator+(const Vector_function& a, const Vector_function& b)
  {
    return by_coordinate([&](int i) { return a.x[i] + b.x[i]; });
  }

  friend Vector_function operator-(const Vector_function& a, const Vector_function& b)
  {
    return by_coordinate([&](int i) { return a.x[i] - b.x[i]; });
  }

  friend Vector_function operator*(const Vector_function& a, const Scalar_function& f)
  {
    return by_coordinate([&](int i) { return a.x[i] * f; });
  }

  Vector_function on_axis(const Exact_box& domain, int axis) const
  {
    return by_coordinate([&](int i) { return x[i].on_axis(domain, axis); });
  }

  template <class Coordinate>
  static Vector_function by_coordinate(const Coordinate& coordinate)
  {
    Vector_function result;
    for (int i = 0; i < d; ++i)
      result.x[i] = coordinate(i);
    return result;
  }
};

template <int d>
Scalar_function dot(const Vector_function<d>& a, const Vector_function<d>& b)
{
  Scalar_function result = a.x[0] * b.x[0];
  for (int i = 1; i < d; ++i)
    result = result + a.x[i] * b.x[i];
  return result;
}

Vector_function<3> cross(const Vector_function<3>& a, const Vector_function<3>& b);

/*
Rotations and conics are rational in the direction of a point (sigma, tau): their formulas are quadratic forms in it.
Here it runs along straight lines, so that its squares and its product are quadratic splines of the parameter.
*/
struct Direction_path
{
  Scalar_function squared_sigma;
  Scalar_function sigma_tau;
  Scalar_function squared_tau;

  // Half round the origin, (1,0), (1,h), (0,h), (-1,h), (-1,0), along three sides of a rectangle of height h in four
  // pieces: a rotation by twice the angle makes a whole turn.
  static Direction_path half_round(const Exact_rational& h);

  // From (1, first) to (1, last), with tau as the parameter.
  static Direction_path line(const Exact_rational& first, const Exact_rational& last);

  Exact_box domain() const { return squared_sigma.domain(); }

  Direction_path restricted(const Exact_rational& begin, const Exact_rational& end) const
  {
    return by_function(
        [&](const Scalar_function& f) { return Scalar_function(f.function().restricted(0, begin, end)); });
  }

  Direction_path on_axis(const Exact_box& domain, int axis) const
  {
    return by_function([&](const Scalar_function& f) { return f.on_axis(domain, axis); });
  }

private:
  template <class Change>
  Direction_path by_function(const Change& change) const
  {
    return {change(squared_sigma), change(sigma_tau), change(squared_tau)};
  }
};

/*
A vector turned about an axis by twice the angle with the tangent |axis| tau / sigma, times the weight sigma^2 +
|axis|^2 tau^2 (Cayley's form of a rotation): polynomial in all that goes in, for an axis of any length.
*/
Vector_function<3> rotated(const Vector_function<3>& p, const Vector_function<3>& axis, const Direction_path& path);

inline Scalar_function rotation_weight(const Vector_function<3>& axis, const Direction_path& path)
{
  return path.squared_sigma + path.squared_tau * dot(axis, axis);
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Scalar_function::Scalar_function(const Exact_box& domain, const Exact_rational& value)
{
  std::vector<std::vector<Exact_rational>> knots;
  for (const auto& range : domain)
    knots.push_back({range.first, range.second});
  m_function = Exact_function(std::vector<int>(domain.size(), 0), std::move(knots), {value});
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_box Scalar_function::domain() const
{
  Exact_box result;
  for (int j = 0; j < m_function.dimension(); ++j)
    result.push_back(m_function.domain(j));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Scalar_function operator+(const Scalar_function& a, const Scalar_function& b)
{
  const Exact_function &f = a.m_function, &g = b.m_function;
  if (f.axes() != g.axes())
    return f + g;
  std::vector<Exact_rational> sums;
  for (std::size_t k = 0; k < f.coefficients().size(); ++k)
    sums.emplace_back(f.coefficients()[k] + g.coefficients()[k]);
  return with_coefficients(f, std::move(sums));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Scalar_function operator*(const Scalar_function& a, const Scalar_function& b)
{
  const Exact_function &f = a.m_function, &g = b.m_function;
  if (a.domain() != b.domain() || !Scalar_function::have_separate_parameters(f, g))
    return f * g;
  std::vector<Knot_axis<Exact_rational>> axes;
  for (int j = 0; j < f.dimension(); ++j)
    axes.push_back((f.size(j) > 1 ? f : g).axes()[j]);
  std::vector<Exact_rational> products;
  const std::vector<int> extents_f = control_extents(f), extents_g = control_extents(g);
  const std::vector<std::size_t> strides_f = tensor_strides(extents_f), strides_g = tensor_strides(extents_g);
  std::vector<int> extents;
  for (std::size_t j = 0; j < extents_f.size(); ++j)
    extents.push_back(extents_f[j] + extents_g[j]);
  for_each_index(extents, [&](const std::vector<int>& index) {
    std::size_t at_f = 0, at_g = 0;
    for (std::size_t j = 0; j < index.size(); ++j)
      (extents_f[j] > 0 ? at_f : at_g) +=
          static_cast<std::size_t>(index[j]) * (extents_f[j] > 0 ? strides_f[j] : strides_g[j]);
    products.emplace_back(f.coefficients()[at_f] * g.coefficients()[at_g]);
  });
  return Exact_function::on_axes(std::move(axes), std::move(products));
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Scalar_function::have_separate_parameters(const Exact_function& f,
                                                                              const Exact_function& g)
{
  for (int j = 0; j < f.dimension(); ++j)
    if (f.size(j) > 1 && g.size(j) > 1)
      return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Vector_function<3> cross(const Vector_function<3>& a, const Vector_function<3>& b)
{
  return Vector_function<3>::by_coordinate([&](int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return a.x[j] * b.x[k] - a.x[k] * b.x[j];
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE Direction_path Direction_path::half_round(const Exact_rational& h)
{
  const Exact_rational half = h / 2, square = h * h;
  const auto spline = [](std::vector<Exact_rational> control_points) {
    return Scalar_function(Exact_function({2}, {{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}}, std::move(control_points)));
  };
  return {spline({1, 1, 1, 0, 0, 0, 1, 1, 1}), spline({0, half, h, half, 0, -half, -h, -half, 0}),
          spline({0, 0, square, square, square, square, square, 0, 0})};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Direction_path Direction_path::line(const Exact_rational& first,
                                                                   const Exact_rational& last)
{
  const auto spline = [&](std::vector<Exact_rational> control_points) {
    return Scalar_function(Exact_function({2}, {{first, first, first, last, last, last}}, std::move(control_points)));
  };
  return {spline({1, 1, 1}), spline({first, Exact_rational((first + last) / 2), last}),
          spline({first * first, first * last, last * last})};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Vector_function<3> rotated(const Vector_function<3>& p, const Vector_function<3>& axis,
                                                          const Direction_path& path)
{
  const Scalar_function cosine = path.squared_sigma - path.squared_tau * dot(axis, axis),
                        twice_squared_tau = path.squared_tau * Exact_rational(2);
  return p * cosine + cross(axis, p) * (path.sigma_tau * Exact_rational(2)) + axis * (dot(axis, p) * twice_squared_tau);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_VECTOR_FUNCTION_H
