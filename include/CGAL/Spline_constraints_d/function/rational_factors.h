// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_FACTORS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/integer_factors_declarations.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/function/internal/integer_factors.h>
#endif

#include <functional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions
A polynomial in one unknown as a product of irreducible ones, over the rational numbers.
*/
struct Rational_factors
{
  //! One of them.
  struct Factor
  {
    Power_polynomial
        polynomial;   ///< irreducible; integer coefficients without a common divisor, the leading one positive
    int multiplicity; ///< its exponent
  };

  Exact_rational constant;     ///< the factor without the unknown
  std::vector<Factor> factors; ///< all others, each once, by their degrees; none for a constant
};

/*!
\ingroup PkgSplineConstraintsDFunctions

all irreducible factors over the rational numbers of a polynomial in one unknown, whichever index it has: the polynomial
is `constant` times the product of the powers of `factors`, exactly, and none of these is a product itself.

\param f the polynomial.
\param check is called every millisecond or so, and can end the work by an exception.
\throws Invalid_input for the zero polynomial, and when there is more than one unknown.

The polynomial is made square-free (Yun 1976), factored modulo a small prime (Cantor and Zassenhaus 1981), and these
factors are lifted and combined (Zassenhaus 1969). The cost is polynomial in the degree and the size of coefficients,
except for the last step: it is exponential in the number of factors modulo primes, of which irreducible polynomials can
have half as many as their degree, but most have few.
*/
Rational_factors rational_factors(const Power_polynomial& f, std::function<void()> check = {});

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Rational_factors rational_factors(const Power_polynomial& f, std::function<void()> check)
{
  using namespace internal;
  if (f.is_zero())
    throw Invalid_input("rational_factors: the zero polynomial has no factors");
  const std::vector<Exact_rational> coefficients = coefficients_in_one_unknown(f, "rational_factors");
  const Integer_coefficients primitive = with_integers({coefficients})[0];
  const int unknown = f.is_constant() ? 0 : f.variables()[0];
  Interruption interruption(std::move(check));
  Rational_factors result{coefficients.back(), {}};
  for (const Integer_factor& factor : integer_factors(primitive, interruption)) {
    result.factors.push_back({polynomial_in(unknown, factor.polynomial), factor.multiplicity});
    for (int k = 0; k < factor.multiplicity; ++k)
      result.constant /= scaled_rational(factor.polynomial.back(), 0);
  }
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_FACTORS_H
