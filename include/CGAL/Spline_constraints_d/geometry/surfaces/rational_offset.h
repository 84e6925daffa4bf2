// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_RATIONAL_OFFSET_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_RATIONAL_OFFSET_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/internal/spline_cells.h>
#include <CGAL/Spline_constraints_d/geometry/internal/homogeneous_polynomials.h>
#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial with the square f, if there is one and its factors are found. \pre f is not zero.
inline std::optional<Power_polynomial> square_root(const Power_polynomial& f)
{
  Power_polynomial root(1);
  const std::vector<Power_polynomial> factors = square_free_factors(f);
  for (std::size_t k = 0; k < factors.size(); ++k)   // factors[k] has the exponent k + 1
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

inline Power_polynomial squared_length(const std::vector<Power_polynomial>& n)
{
  return n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
}

// With a positive weight, if the surface has one. \pre the normal of the surface vanishes nowhere.
inline std::optional<Homogeneous_polynomials> rational_offset(const Homogeneous_polynomials& surface,
                                                              const Exact_rational& distance)
{
  const Exact_rational half = Exact_rational(1) / 2;
  const std::vector<Power_polynomial> normal = normal_of(surface);
  // Most surfaces fail in a first point.
  if (!rational_square_root(value_at(squared_length(normal), half, Exact_rational(1) / 3)))
    return std::nullopt;
  const std::vector<Power_polynomial> direction = without_common_factors(normal);
  const std::optional<Power_polynomial> length = square_root(squared_length(direction));
  if (!length)
    return std::nullopt;
  // Neither the length nor the factor between normal and direction has a zero, so their signs are those in the middle.
  Exact_rational cosine(0);
  for (std::size_t i = 0; i < 3; ++i)
    cosine += value_at(normal[i], half, half) * value_at(direction[i], half, half);
  const bool is_negative = value_at(*length, half, half) < 0;
  const Power_polynomial weight = is_negative ? -*length : *length,
                         step(cosine < 0 ? Exact_rational(-distance) : distance);
  Homogeneous_polynomials result;
  for (std::size_t i = 0; i < 3; ++i)
    result.push_back(surface[i] * weight + step * direction[i] * surface[3]);
  result.push_back(surface[3] * weight);
  return result;
}

/*
The continuous surface with these pieces on the cells of a grid, in row-major order, each of which may be multiplied by
a constant: that which makes it fit the one before. None if their homogeneous coordinates do not fit.
*/
inline std::optional<Bspline_surface_3<Exact_kernel>>
joined_surface(std::vector<Homogeneous_polynomials> pieces, const std::array<std::vector<Exact_rational>, 2>& breaks)
{
  const std::size_t columns = breaks[1].size() - 1;
  for (std::size_t c = 1; c < pieces.size(); ++c) {
    const bool is_first_in_row = c % columns == 0;
    const Homogeneous_polynomials& before = pieces[is_first_in_row ? c - columns : c - 1];
    const Exact_rational factor = is_first_in_row
        ? Exact_rational(value_at(before[3], 1, 0) / value_at(pieces[c][3], 0, 0))
        : Exact_rational(value_at(before[3], 0, 1) / value_at(pieces[c][3], 0, 0));
    for (Power_polynomial& f : pieces[c])
      f *= Power_polynomial(factor);
  }
  std::vector<int> degrees(2, 1);
  for (const Homogeneous_polynomials& piece : pieces)
    for (const Power_polynomial& f : piece)
      for (const int axis : {0, 1})
        degrees[axis] = (std::max)(degrees[axis], f.degree(axis));
  Break_grid<Exact_rational> grid(2);
  for (const int axis : {0, 1})
    for (const Exact_rational& t : breaks[axis])
      grid[axis].push_back({t, degrees[axis]});
  std::array<Bspline_function<Exact_rational>, 4> coordinates;
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<Bernstein_tensor<Exact_rational>> tensors;
    for (const Homogeneous_polynomials& piece : pieces)
      tensors.push_back(tensor_of(piece[i], degrees));
    auto [axes, control_points] = assembled_cells(degrees, grid, tensors);
    coordinates[i] = Bspline_function<Exact_rational>::on_axes(std::move(axes), std::move(control_points));
    if (coordinates[i].bezier_pieces() != tensors)
      return std::nullopt;
  }
  return Bspline_surface_3<Exact_kernel>::from_homogeneous_coordinates({coordinates[0], coordinates[1], coordinates[2]},
                                                                       coordinates[3]);
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

an offset as a rational surface with the same parameters, exactly, where it is one: where on each piece the squared
length of the normal is the square of a polynomial with rational coefficients, up to squares. So it is for parts of
spheres, cylinders and tori with rational radii, as functions of this package make them, for cones whose angle has a
rational sine and cosine, planes with a rational unit normal, and other surfaces with a Pythagorean normal. Otherwise,
or if common factors are not found by `common_factor()`, nothing.

All that is known of rational surfaces can be done with it, also what is not supported for `Offset_surface_3`. Its
degrees are as low as common factors of homogeneous coordinates allow, if the pieces then fit together.

Complexity: greatest common divisors of polynomials of three times the degrees, for each piece of the surface; one
evaluation, if the length of the normal in one point is not rational.

Source: Pottmann, Rational curves and surfaces with rational offsets, 1995.
*/
inline std::optional<Bspline_surface_3<CGAL::Simple_cartesian<Exact_rational>>>
rational_offset(const Offset_surface_3& offset)
{
  const auto& surface = offset.rational_surface();
  const auto numerators = surface.homogeneous_coordinates();
  const std::array<std::vector<Bernstein_tensor<Exact_rational>>, 3> pieces{
      numerators[0].bezier_pieces(), numerators[1].bezier_pieces(), numerators[2].bezier_pieces()};
  const auto weights = surface.is_rational()
      ? surface.weight().bezier_pieces()
      : std::vector(pieces[0].size(), Bernstein_tensor<Exact_rational>::constant(2, Exact_rational(1)));
  std::vector<internal::Homogeneous_polynomials> offsets, simpler;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    internal::Homogeneous_polynomials piece;
    for (const auto& coordinate : pieces)
      piece.push_back(internal::polynomial_of(coordinate[c]));
    piece.push_back(internal::polynomial_of(weights[c]));
    const auto own = internal::rational_offset(piece, offset.distance());
    if (!own)
      return std::nullopt;
    offsets.push_back(*own);
    simpler.push_back(internal::without_common_factors(*own));
  }
  const std::array<std::vector<Exact_rational>, 2> breaks{surface.breaks(0), surface.breaks(1)};
  if (auto result = internal::joined_surface(std::move(simpler), breaks))
    return result;
  return internal::joined_surface(std::move(offsets), breaks);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_RATIONAL_OFFSET_H
