// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_TANGENT_DIRECTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_TANGENT_DIRECTION_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_composition.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline Bspline_function<Exact_rational> function_of_parameter(const Power_polynomial& polynomial,
                                                              const std::pair<Exact_rational, Exact_rational>& domain)
{
  const auto& [begin, end] = domain;
  const Bspline_function<Exact_rational> t({1}, {{begin, begin, end, end}}, {begin, end});
  Bspline_function<Exact_rational> result = t * Exact_rational(0);
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Bspline_function<Exact_rational> term = t * Exact_rational(0) + coefficient;
    for (int k = 0; k < monomial.exponent(0); ++k)
      term = term * t;
    result = result + term;
  }
  return result;
}

// The derivative of a curve of one polynomial piece without the common factor of its coordinates, which is zero at
// cusps: what is left has the direction of the tangent there, too. Nothing if there is no factor.
inline std::optional<Planar_map> reduced_derivative(const Differentiated_map& piece)
{
  const Vector_expression<2> tangent = piece(1, unknowns_in({piece.map().domain(0)})[0]);
  const std::vector<Power_polynomial> coordinates{numerator_polynomial(tangent[0]), numerator_polynomial(tangent[1])};
  if (std::all_of(coordinates.begin(), coordinates.end(), [](const Power_polynomial& x) { return x.is_constant(); }))
    return std::nullopt;
  const std::optional<Common_factor> common = common_factor(coordinates);
  if (!common)
    return std::nullopt;
  const auto reduced = [&](std::size_t i) {
    return function_of_parameter(common->cofactors[i], piece.map().domain(0));
  };
  return Planar_map(std::array{reduced(0), reduced(1)});
}

// The smooth parts of a curve; polynomial pieces whose derivative is zero somewhere are parts of their own, with a
// multiple of it that is not.
inline std::vector<Smooth_part> parts_with_tangents(const Planar_map& curve)
{
  std::vector<Smooth_part> result =
      smooth_parts(curve, [](const Differentiated_map& before, const Differentiated_map& after) {
        return has_same_derivative(before, after) && !reduced_derivative(before) && !reduced_derivative(after);
      });
  for (Smooth_part& part : result)
    if (part.curve.map().breaks(0).size() == 2)
      if (const std::optional<Planar_map> tangent = reduced_derivative(part.curve))
        part.curve = part.curve.with_tangent(*tangent);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_TANGENT_DIRECTION_H
