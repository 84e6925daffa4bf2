// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_UNIT_NORMAL_OF_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_UNIT_NORMAL_OF_PIECE_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial with the square f, if there is one and its factors are found. \pre f is not zero.
std::optional<Power_polynomial> square_root(const Power_polynomial& f);

inline Power_polynomial squared_length(const std::vector<Power_polynomial>& n)
{
  return n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
}

// The unit normal direction / length of a polynomial piece of a surface, in the lowest degree.
struct Unit_normal
{
  std::vector<Power_polynomial> direction;
  Power_polynomial length;
};

// Parameters where not all of some polynomials are zero. \pre one of them is not.
std::array<Exact_rational, 2> parameters_off_zeros(const std::vector<Power_polynomial>& polynomials);

// A cross product of derivatives in the lowest degree, on its own side in one point. \pre it is not zero.
std::vector<Power_polynomial> oriented_normal(const std::vector<Power_polynomial>& normal);

/*
On the side of the cross product of the derivatives, in one point. What this cross product has in common with the
normal, as the distance to a pole of a sphere or the tip of a cone, is divided out first: so the normal is there, too.
None if its coordinates are not rational, or the piece is a curve.
*/
std::optional<Unit_normal> unit_normal(const Homogeneous_polynomials& surface);

// The piece at a distance along its unit normal.
Homogeneous_polynomials piece_at_distance(const Homogeneous_polynomials& surface, const Unit_normal& normal,
                                          const Exact_rational& distance);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Power_polynomial> square_root(const Power_polynomial& f)
{
  Power_polynomial root(1);
  const std::vector<Power_polynomial> factors = square_free_factors(f);
  for (std::size_t k = 0; k < factors.size(); ++k) // factors[k] has the exponent k + 1
    if (!factors[k].is_constant()) {
      if (k % 2 == 0)
        return std::nullopt;
      root *= pow(factors[k], static_cast<int>(k + 1) / 2);
    }
  const Power_polynomial square = root * root;
  const Exact_rational ratio = f.terms().rbegin()->second / square.terms().rbegin()->second;
  const std::optional<Exact_rational> scale = rational_square_root(ratio);
  return scale && square * Power_polynomial(ratio) == f ? std::optional(root * Power_polynomial(*scale)) : std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Exact_rational, 2>
parameters_off_zeros(const std::vector<Power_polynomial>& polynomials)
{
  const Exact_rational half = Exact_rational(1) / 2;
  for (const Power_polynomial& f : polynomials)
    if (value_at(f, half, half) != 0)
      return {half, half};
  for (int n = 2;; ++n) // ends: only the zero polynomial is zero on all points of a fine grid
    for (int i = 1; i < n; ++i)
      for (int j = 1; j <= n; ++j) {
        const Exact_rational u = Exact_rational(i) / n, v = Exact_rational(j) / (n + 1);
        for (const Power_polynomial& f : polynomials)
          if (value_at(f, u, v) != 0)
            return {u, v};
      }
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Power_polynomial>
oriented_normal(const std::vector<Power_polynomial>& normal)
{
  std::vector<Power_polynomial> result = without_common_factors(normal);
  const auto [u, v] = parameters_off_zeros(normal);
  Exact_rational cosine(0);
  for (std::size_t i = 0; i < 3; ++i)
    cosine += value_at(normal[i], u, v) * value_at(result[i], u, v);
  if (cosine < 0)
    for (Power_polynomial& f : result)
      f = -f;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Unit_normal> unit_normal(const Homogeneous_polynomials& surface)
{
  const std::vector<Power_polynomial> normal = normal_of(surface);
  if (normal[0].is_zero() && normal[1].is_zero() && normal[2].is_zero())
    return std::nullopt;
  const auto [u, v] = parameters_off_zeros(normal);
  // Most surfaces fail in a first point.
  if (!rational_square_root(value_at(squared_length(normal), u, v)))
    return std::nullopt;
  const std::vector<Power_polynomial> direction = oriented_normal(normal);
  const std::optional<Power_polynomial> length = square_root(squared_length(direction));
  if (!length)
    return std::nullopt;
  // The length is zero in single points at most, as the direction is, so it has one sign.
  return Unit_normal{direction, value_at(*length, u, v) < 0 ? -*length : *length};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Homogeneous_polynomials piece_at_distance(const Homogeneous_polynomials& surface,
                                                                         const Unit_normal& normal,
                                                                         const Exact_rational& distance)
{
  Homogeneous_polynomials result;
  for (std::size_t i = 0; i < 3; ++i)
    result.push_back(surface[i] * normal.length + Power_polynomial(distance) * normal.direction[i] * surface[3]);
  result.push_back(surface[3] * normal.length);
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_UNIT_NORMAL_OF_PIECE_H
