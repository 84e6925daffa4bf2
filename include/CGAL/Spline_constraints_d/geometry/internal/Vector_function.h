// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_VECTOR_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_VECTOR_FUNCTION_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>

#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The ranges of parameters, one for each axis.
using Exact_box = std::vector<std::pair<Exact_rational, Exact_rational>>;

inline Exact_box domain_of(const Exact_function& f)
{
  Exact_box result;
  for (int j = 0; j < f.dimension(); ++j)
    result.push_back(f.domain(j));
  return result;
}

inline Exact_function constant_function(const Exact_box& domain, const Exact_rational& value)
{
  std::vector<std::vector<Exact_rational>> knots;
  for (const auto& range : domain)
    knots.push_back({range.first, range.second});
  return Exact_function(std::vector<int>(domain.size(), 0), std::move(knots), {value});
}

// A vector whose coordinates are exact splines: what constructions compute with. Formulas for points of curves and surfaces are written with it as they are for vectors.
template <int d>
struct Vector_function
{
  std::array<Exact_function, d> x;

  friend Vector_function operator+(const Vector_function& a, const Vector_function& b)
  {
    return by_coordinate([&](int i) { return a.x[i] + b.x[i]; });
  }

  friend Vector_function operator-(const Vector_function& a, const Vector_function& b)
  {
    return by_coordinate([&](int i) { return a.x[i] - b.x[i]; });
  }

  friend Vector_function operator*(const Vector_function& a, const Exact_function& f)
  {
    return by_coordinate([&](int i) { return a.x[i] * f; });
  }

  // The same as a function of more parameters, which depends on the given axis only.
  Vector_function on_axis(const Exact_box& domain, int axis) const
  {
    return by_coordinate([&](int i) { return x[i].embedded(domain, {axis}); });
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
Exact_function dot(const Vector_function<d>& a, const Vector_function<d>& b)
{
  Exact_function result = a.x[0] * b.x[0];
  for (int i = 1; i < d; ++i)
    result = result + a.x[i] * b.x[i];
  return result;
}

inline Vector_function<3> cross(const Vector_function<3>& a, const Vector_function<3>& b)
{
  return Vector_function<3>::by_coordinate([&](int i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    return a.x[j] * b.x[k] - a.x[k] * b.x[j];
  });
}

inline Vector_function<2> constant_vector(const Exact_box& domain, const Exact_kernel::Vector_2& v)
{
  return Vector_function<2>::by_coordinate([&](int i) { return constant_function(domain, v.cartesian(i)); });
}

inline Vector_function<3> constant_vector(const Exact_box& domain, const Exact_kernel::Vector_3& v)
{
  return Vector_function<3>::by_coordinate([&](int i) { return constant_function(domain, v.cartesian(i)); });
}

/*
Rotations are rational in the two coordinates (sigma, tau) of a point that goes round the origin: half a round of it makes a whole turn. This is such a half round, along the sides
of a rectangle, in four pieces: (1,0), (1,h), (0,h), (-1,h), (-1,0).
*/
struct Half_round
{
  Exact_function sigma;
  Exact_function tau;

  explicit Half_round(const Exact_rational& height)
    : sigma({1}, {{0, 0, 1, 2, 3, 4, 4}}, {1, 1, 0, -1, -1}), tau({1}, {{0, 0, 1, 2, 3, 4, 4}}, {0, height, height, height, 0})
  {}

  Half_round restricted(const Exact_rational& begin, const Exact_rational& end) const
  {
    return {sigma.restricted(0, begin, end), tau.restricted(0, begin, end)};
  }

  Half_round on_axis(const Exact_box& domain, int axis) const { return {sigma.embedded(domain, {axis}), tau.embedded(domain, {axis})}; }

private:
  Half_round(Exact_function s, Exact_function t) : sigma(std::move(s)), tau(std::move(t)) {}
};

/*
A vector turned about an axis by twice the angle with the tangent |axis| tau / sigma, times the weight sigma^2 + |axis|^2 tau^2 (Cayley's form of a rotation): polynomial in all
that goes in, for an axis of any length.
*/
inline Vector_function<3> rotated(const Vector_function<3>& p, const Vector_function<3>& axis, const Half_round& path)
{
  const Exact_function squared_tau = path.tau * path.tau;
  const Exact_function cosine = path.sigma * path.sigma - squared_tau * dot(axis, axis), sine = path.sigma * path.tau * Exact_rational(2);
  return p * cosine + cross(axis, p) * sine + axis * (dot(axis, p) * squared_tau * Exact_rational(2));
}

inline Exact_function rotation_weight(const Vector_function<3>& axis, const Half_round& path)
{
  return path.sigma * path.sigma + path.tau * path.tau * dot(axis, axis);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_VECTOR_FUNCTION_H
