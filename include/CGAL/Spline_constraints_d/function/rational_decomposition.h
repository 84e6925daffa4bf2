// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_DECOMPOSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_DECOMPOSITION_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/decompositions_declarations.h>
#include <CGAL/Spline_constraints_d/function/internal/left_components.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/function/internal/decompositions.h>
#include <CGAL/Spline_constraints_d/function/internal/integer_factors.h>
#endif

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions
A function \f$f = g \circ h\f$, where \f$g\f$ and \f$h\f$ have degrees above one.
*/
struct Functional_decomposition
{
  Polynomial_quotient g; ///< the left component
  Polynomial_quotient h; ///< the right component
};

/*!
\ingroup PkgSplineConstraintsDFunctions

the left component \f$g\f$ of \f$f = g \circ h\f$, of which there is one at most; nothing if there is none.

\throws Invalid_input when \f$f\f$ or \f$h\f$ is constant.

The numerator of \f$f\f$ is \f$\sum_i g_i p^i q^{r-i}\f$ for \f$h = p/q\f$, and so is the denominator. With the linear
function of \f$h\f$ for which \f$\deg p > \deg q\f$, these products have increasing degrees, and the system is
triangular: \f$O(n r)\f$ operations on rational numbers for the degree \f$n\f$ of \f$f\f$ and \f$r\f$ of \f$g\f$.
Modulo a prime, most \f$h\f$ are refused before. Zippel, Rational function decomposition, 1991, section 3.1.
*/
std::optional<Polynomial_quotient> left_component(const Polynomial_quotient& f, const Polynomial_quotient& h);

/*!
\ingroup PkgSplineConstraintsDFunctions

all decompositions of a rational function over the rational numbers, by the degrees of \f$h\f$, up to fractional linear
functions \f$\mu\f$, as \f$g \circ h = (g \circ \mu) \circ (\mu^{-1} \circ h)\f$. Of these, \f$h = p/q\f$ is the one
where \f$q\f$ has a lower degree than \f$p\f$, \f$p\f$ has no term of that degree, and both have integer coefficients
without a common divisor and a positive leading one: a polynomial without a constant, if there is one.

\param f the function.
\param check is called every millisecond or so, and can end the work by an exception.
\throws Invalid_input for a constant.

For polynomials by power series (Kozen and Landau, Polynomial decomposition algorithms, 1989), without factorisation.
Other functions by two fibres: one may take \f$h(a) = 0\f$ and \f$h(b) = \infty\f$ for rational numbers with \f$f(a) \ne
f(b)\f$; then the numerator of \f$h\f$ divides that of \f$f - f(a)\f$, its denominator that of \f$f - f(b)\f$. All of
these divisors are tried, where \f$a\f$ and \f$b\f$ are chosen so that there are few. Proofs: \ref
Spline_constraints_d_rational_decomposition_proofs.
*/
std::vector<Functional_decomposition> decompositions(const Polynomial_quotient& f, std::function<void()> check = {});

/*!
\ingroup PkgSplineConstraintsDFunctions

functions \f$f_1, \dots, f_m\f$ that have no decompositions, with \f$f = f_1 \circ \dots \circ f_m\f$: the last one
with the least degree that is possible, and so on for the rest. Just \f$f\f$, if it has none.

\param f,check as for `decompositions()`.
\throws Invalid_input for a constant.
*/
std::vector<Polynomial_quotient> decompose(const Polynomial_quotient& f, std::function<void()> check = {});

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Polynomial_quotient> left_component(const Polynomial_quotient& f,
                                                                                 const Polynomial_quotient& h)
{
  if (f.degree() == 0 || h.degree() == 0)
    throw Invalid_input("left_component: a function is constant");
  const internal::Pencil pencil(h.numerator_coefficients(), h.denominator_coefficients());
  const std::optional<Polynomial_quotient> g = internal::left_component(f, pencil);
  return g ? std::optional(composed(*g, pencil.of_given())) : std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Functional_decomposition> decompositions(const Polynomial_quotient& f,
                                                                                    std::function<void()> check)
{
  if (f.degree() == 0)
    throw Invalid_input("decompositions: the function is constant");
  internal::Interruption interruption(std::move(check));
  std::vector<Functional_decomposition> result;
  for (internal::Found_decomposition& found : internal::decompositions_of(f, interruption))
    result.push_back({std::move(found.g), std::move(found.h)});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Polynomial_quotient> decompose(const Polynomial_quotient& f,
                                                                          std::function<void()> check)
{
  std::vector<Polynomial_quotient> result;
  for (Polynomial_quotient rest = f;;) {
    std::vector<Functional_decomposition> found = decompositions(rest, check);
    if (found.empty()) {
      result.insert(result.begin(), std::move(rest));
      return result;
    }
    result.insert(result.begin(), std::move(found.front().h));
    rest = std::move(found.front().g);
  }
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RATIONAL_DECOMPOSITION_H
