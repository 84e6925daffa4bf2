// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FUNCTIONS_ON_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FUNCTIONS_ON_BISECTOR_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// k functions of each piece of a bisector, on the grid of the pieces.
template <std::size_t k, class Functions_of_piece>
Cell_functions<k> functions_on_bisector(const Rational_bisector_3& bisector, const Functions_of_piece& functions)
{
  std::array<std::vector<Exact_rational>, 2> breaks;
  std::vector<std::array<Exact_function, k>> cells;
  for (const Rational_bisector_piece_3& piece : bisector.pieces()) {
    for (const int axis : {0, 1})
      breaks[axis] = internal::united(breaks[axis], {piece.domain()[axis].first, piece.domain()[axis].second});
    const std::vector<Parameter_range> box(piece.domain().begin(), piece.domain().end());
    std::array<Exact_function, k>& cell = cells.emplace_back();
    std::ranges::transform(functions(piece), cell.begin(),
                           [&](const auto& f) { return Exact_function::from_tensor(f, box); });
  }
  return {breaks, std::move(cells)};
}

inline Cell_functions<4> coordinates_on_bisector(const Rational_bisector_3& bisector)
{
  return functions_on_bisector<4>(bisector, [](const auto& piece) { return piece.coordinates(); });
}

// |P - F|^2 - r^2 times both squared weights, where P and F are points of homogeneous coordinates.
inline Bernstein_tensor<Exact_rational> power_of_distance(const Rational_bisector_piece_3::Coordinates& point,
                                                          const Rational_bisector_piece_3::Coordinates& center,
                                                          const Exact_rational& squared_radius)
{
  const Bernstein_tensor<Exact_rational> weight = point[3] * center[3];
  Bernstein_tensor<Exact_rational> result = weight * weight * Exact_rational(-squared_radius);
  for (std::size_t i = 0; i < 3; ++i) {
    const Bernstein_tensor<Exact_rational> difference = point[i] * center[3] - center[i] * point[3];
    result = result + difference * difference;
  }
  return result;
}

// A point as homogeneous coordinates of two parameters.
inline Rational_bisector_piece_3::Coordinates constant_coordinates(const Rational_bisector_3::Kernel::Point_3& p)
{
  const auto constant = [](const Exact_rational& x) { return Bernstein_tensor<Exact_rational>::constant(2, x); };
  return {constant(p.x()), constant(p.y()), constant(p.z()), constant(Exact_rational(1))};
}

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_FUNCTIONS_ON_BISECTOR_H
