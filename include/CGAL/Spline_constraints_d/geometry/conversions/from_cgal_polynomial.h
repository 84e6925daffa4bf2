// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_FROM_CGAL_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_FROM_CGAL_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Exponent_vector.h>
#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_traits_d.h>

#include <concepts>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Numbers that are no fractions are integers.
template <class Coefficient>
Exact_rational rational_coefficient(const Coefficient& x)
{
  if constexpr (Rational_coordinate<Coefficient> || std::convertible_to<Coefficient, Exact_rational>)
    return converted_number<Exact_rational>(x);
  else
    return scaled_rational(integer_from_digits(x), 0);
}

template <class Coefficient>
Coefficient coefficient_of_type(const Exact_rational& x)
{
  if constexpr (Rational_coordinate<Coefficient>)
    return converted_number<Coefficient>(x);
  else if (denominator_of(x) == 1)
    return integer_of_type<Coefficient>(numerator_of(x));
  else
    throw Invalid_input("to_cgal_polynomial: a coefficient is not an integer");
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

a `CGAL::Polynomial` as a `Power_polynomial`, exactly: its variable \f$i\f$, counted from the innermost, is the unknown
\f$i\f$.

\tparam Coefficient a polynomial again, or integers or rational numbers; doubles are taken exactly.
\throws Invalid_input when a coefficient is not finite, and as `Power_polynomial`.
*/
template <class Coefficient>
Power_polynomial from_cgal_polynomial(const CGAL::Polynomial<Coefficient>& polynomial)
{
  using Traits = CGAL::Polynomial_traits_d<CGAL::Polynomial<Coefficient>>;
  std::vector<std::pair<CGAL::Exponent_vector, typename Traits::Innermost_coefficient_type>> terms;
  typename Traits::Monomial_representation()(polynomial, std::back_inserter(terms));
  Power_polynomial result;
  for (const auto& [exponents, coefficient] : terms) {
    Power_polynomial term(internal::rational_coefficient(coefficient));
    for (std::size_t i = 0; i < exponents.size(); ++i)
      term *= pow(Power_polynomial::variable(static_cast<int>(i)), exponents[i]);
    result += term;
  }
  return result;
}

/*!
\ingroup PkgSplineConstraintsDGeometry

the way back: a `CGAL::Polynomial` of the given type from a `Power_polynomial`.

\tparam Polynomial a `CGAL::Polynomial` with coefficients that are integers or rational numbers.
\throws Invalid_input when there are more unknowns than variables, or a coefficient is not an integer as the type asks
for.
*/
template <class Polynomial>
Polynomial to_cgal_polynomial(const Power_polynomial& polynomial)
{
  using Traits = CGAL::Polynomial_traits_d<Polynomial>;
  using Coefficient = typename Traits::Innermost_coefficient_type;
  const std::vector<int> variables = polynomial.variables();
  if (!variables.empty() && variables.back() >= Traits::d)
    throw Invalid_input("to_cgal_polynomial: unknown " + std::to_string(variables.back()) + " in a polynomial of " +
                        std::to_string(Traits::d) + " variables");
  std::vector<std::pair<CGAL::Exponent_vector, Coefficient>> terms;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    std::vector<int> exponents;
    for (int i = 0; i < Traits::d; ++i)
      exponents.push_back(monomial.exponent(i));
    terms.emplace_back(CGAL::Exponent_vector(exponents.begin(), exponents.end()),
                       internal::coefficient_of_type<Coefficient>(coefficient));
  }
  return typename Traits::Construct_polynomial()(terms.begin(), terms.end());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_FROM_CGAL_POLYNOMIAL_H
