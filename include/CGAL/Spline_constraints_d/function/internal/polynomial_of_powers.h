// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_OF_POWERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_OF_POWERS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The polynomial with all these coefficients of powers of parameters, those of the last axis fastest, where
// `replacement(axis)` takes the place of a parameter: an unknown, or a polynomial.
template <class Replacement>
Power_polynomial polynomial_of_powers(const std::vector<int>& degrees, const std::vector<Exact_rational>& coefficients,
                                      const Replacement& replacement)
{
  Power_polynomial result;
  std::size_t next = 0;
  for_each_index(degrees, [&](const std::vector<int>& exponents) {
    const Exact_rational& coefficient = coefficients[next++];
    if (coefficient == Exact_rational(0))
      return;
    Power_polynomial term(coefficient);
    for (std::size_t axis = 0; axis < exponents.size(); ++axis)
      if (exponents[axis] > 0)
        term *= pow(replacement(axis), exponents[axis]);
    result += std::move(term);
  });
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_OF_POWERS_H
