// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POLYNOMIAL_QUOTIENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POLYNOMIAL_QUOTIENT_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A rational function of one unknown with rational coefficients, in lowest terms: as an algebraic object, without the
domain that `Rational_function` has. Equal functions have equal representations.
*/
class Polynomial_quotient
{
  using Coefficients = internal::Integer_coefficients;

  // without common factors, all coefficients together too; the leading one of the denominator is positive
  Coefficients m_numerator, m_denominator;

public:
  //! zero.
  Polynomial_quotient() : m_denominator(1, internal::Big_integer(1)) {}

  //! a polynomial. \throws Invalid_input when it has more than one unknown.
  explicit Polynomial_quotient(const Power_polynomial& polynomial)
    : Polynomial_quotient(polynomial, Power_polynomial(1))
  {}

  //! the quotient of two polynomials in one unknown, whichever index it has.
  //! \throws Invalid_input when there are more unknowns, or the denominator is zero.
  Polynomial_quotient(const Power_polynomial& numerator, const Power_polynomial& denominator);

#ifndef DOXYGEN_RUNNING
  Polynomial_quotient(Coefficients numerator, Coefficients denominator);

  const Coefficients& numerator_coefficients() const { return m_numerator; }
  const Coefficients& denominator_coefficients() const { return m_denominator; }
#endif

  //! the numerator, with integer coefficients, in the unknown 0.
  Power_polynomial numerator() const { return internal::polynomial_in(0, m_numerator); }

  //! the denominator, with integer coefficients, in the unknown 0.
  Power_polynomial denominator() const { return internal::polynomial_in(0, m_denominator); }

  //! the degree: the greater one of those of numerator and denominator; how often a value is taken, with complex
  //! numbers, infinity, and multiplicities.
  int degree() const
  {
    return static_cast<int>((std::max)({m_numerator.size(), m_denominator.size(), std::size_t(1)})) - 1;
  }

  //! whether the denominator is constant.
  bool is_polynomial() const { return m_denominator.size() == 1; }

  //! the value; nothing at a pole.
  std::optional<Exact_rational> operator()(const Exact_rational& x) const;

  //! the function \f$f \circ g\f$ for one that is not constant; its degree is the product of theirs.
  friend Polynomial_quotient composed(const Polynomial_quotient& f, const Polynomial_quotient& g)
  {
    const auto n = static_cast<std::size_t>(f.degree());
    const std::vector<Coefficients> a = internal::powers_of(g.m_numerator, n + 1),
                                    b = internal::powers_of(g.m_denominator, n + 1);
    const auto homogeneous = [&](const Coefficients& polynomial) {
      Coefficients result;
      for (std::size_t k = 0; k < polynomial.size(); ++k)
        internal::add_multiple(result, internal::product_of(a[k], b[n - k]), polynomial[k]);
      return result;
    };
    return Polynomial_quotient(homogeneous(f.m_numerator), homogeneous(f.m_denominator));
  }

  //! equality of functions.
  friend bool operator==(const Polynomial_quotient& a, const Polynomial_quotient& b)
  {
    return a.m_numerator == b.m_numerator && a.m_denominator == b.m_denominator;
  }

  //! the formula with the given name of the unknown.
  std::string to_string(const std::string& unknown = "x") const;

  //! writes `f.to_string()`.
  friend std::ostream& operator<<(std::ostream& out, const Polynomial_quotient& f) { return out << f.to_string(); }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Polynomial_quotient::Polynomial_quotient(const Power_polynomial& numerator,
                                                                        const Power_polynomial& denominator)
{
  const std::string who("Polynomial_quotient");
  if (denominator.is_zero())
    throw Invalid_input(who + ": the denominator is zero");
  if (!numerator.is_constant() && !denominator.is_constant() && numerator.variables() != denominator.variables())
    throw Invalid_input(who + ": numerator and denominator have different unknowns");
  std::vector<Coefficients> both = internal::with_integers(
      {internal::coefficients_in_one_unknown(numerator, who), internal::coefficients_in_one_unknown(denominator, who)});
  *this = Polynomial_quotient(std::move(both[0]), std::move(both[1]));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Polynomial_quotient::Polynomial_quotient(Coefficients numerator,
                                                                        Coefficients denominator)
{
  using internal::Integer_polynomial;
  std::vector<Coefficients> both{internal::trimmed(std::move(numerator)), internal::trimmed(std::move(denominator))};
  const Coefficients common = common_divisor(Integer_polynomial(both[0]), Integer_polynomial(both[1])).coefficients();
  if (common.size() > 1)
    for (Coefficients& f : both)
      f = internal::exact_quotient(std::move(f), internal::primitive_part(common)).value();
  internal::divide_by_common_content(both);
  if (both[1].back() < 0)
    for (Coefficients& f : both)
      for (internal::Big_integer& x : f)
        x = -x;
  m_numerator = std::move(both[0]);
  m_denominator = std::move(both[1]);
  if (m_numerator.empty())
    m_denominator.assign(1, internal::Big_integer(1));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_rational>
Polynomial_quotient::operator()(const Exact_rational& x) const
{
  const internal::Big_integer p = internal::numerator_of(x), q = internal::denominator_of(x);
  const auto n = static_cast<std::size_t>(degree());
  const internal::Big_integer above = internal::homogeneous_value(m_numerator, n, p, q),
                              below = internal::homogeneous_value(m_denominator, n, p, q);
  if (below == 0)
    return std::nullopt;
  return below < 0 ? internal::quotient(internal::Big_integer(-above), internal::Big_integer(-below))
                   : internal::quotient(above, below);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string Polynomial_quotient::to_string(const std::string& unknown) const
{
  const std::vector<std::string> names{unknown};
  const std::string above = numerator().to_string(names);
  return is_polynomial() && m_denominator[0] == 1 ? above : "(" + above + ")/(" + denominator().to_string(names) + ")";
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POLYNOMIAL_QUOTIENT_H
