// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_MOVEMENT_BOUND_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_MOVEMENT_BOUND_H

#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

// A double that is not less than the root.
inline double root_rounded_up(const Exact_rational& square)
{
  if (square == 0)
    return 0;
  const double infinity = std::numeric_limits<double>::infinity(),
               above = std::nextafter(to_nearest_double(square), infinity);
  return std::nextafter(std::nextafter(std::sqrt(above), infinity), infinity);
}

/*
A number that no point of one spline is farther than from the point of the other one at the same parameters, where
weights are proved positive by their coefficients; none elsewhere. The difference of the two is a spline of vectors
over one of weights, thus in the hull of the quotients of their coefficients.
*/
template <int d>
std::optional<double> movement_bound(const Homogeneous_spline<Exact_rational, d>& a,
                                     const Homogeneous_spline<Exact_rational, d>& b)
{
  std::vector<Exact_function> functions;
  const Exact_function weight_of_a = a.weight(), weight_of_b = b.weight();
  if (weight_of_a.axes() == weight_of_b.axes() && weight_of_a.coefficients() == weight_of_b.coefficients()) {
    for (int i = 0; i < d; ++i)
      functions.push_back(a.numerator(i) - b.numerator(i));
    functions.push_back(weight_of_a);
  } else {
    for (int i = 0; i < d; ++i)
      functions.push_back(a.numerator(i) * weight_of_b - b.numerator(i) * weight_of_a);
    functions.push_back(weight_of_a * weight_of_b);
  }
  bring_to_common_knots(functions);
  Exact_rational greatest = 0;
  for (std::size_t k = 0; k < functions[d].coefficients().size(); ++k) {
    const Exact_rational& weight = functions[d].coefficients()[k];
    if (!(weight > 0))
      return std::nullopt;
    Exact_rational square = 0;
    for (int i = 0; i < d; ++i) {
      const Exact_rational x = functions[i].coefficients()[k] / weight;
      square += x * x;
    }
    greatest = (std::max)(greatest, square);
  }
  return root_rounded_up(greatest);
}

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_MOVEMENT_BOUND_H
