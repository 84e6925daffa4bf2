// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_UNIVARIATE_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_UNIVARIATE_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_of_powers.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A function of one parameter, as a polynomial in one that is 0 and 1 at the ends of its domain. \pre There are no
// breaks.
inline Power_polynomial univariate_polynomial(const Bspline_function<Exact_rational>& f)
{
  const Bernstein_tensor<Exact_rational> piece({f.degree(0)}, f.coefficients());
  return polynomial_of_powers(piece.degrees(), piece.power_coefficients(),
                              [](std::size_t) { return Power_polynomial::variable(0); });
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_UNIVARIATE_POLYNOMIAL_H
