// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_UNIVARIATE_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_UNIVARIATE_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A function of one parameter, as a polynomial in one that is 0 and 1 at the ends of its domain. \pre There are no
// breaks.
inline Power_polynomial univariate_polynomial(const Bspline_function<Exact_rational>& f)
{
  const std::vector<Exact_rational> powers =
      Bernstein_tensor<Exact_rational>({f.degree(0)}, f.coefficients()).power_coefficients();
  Power_polynomial result;
  for (std::size_t k = powers.size(); k-- > 0;)
    result = result * Power_polynomial::variable(0) + powers[k];
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_UNIVARIATE_POLYNOMIAL_H
