// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SIMPLEX_FACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SIMPLEX_FACES_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/internal/simplex/edge_zeros.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions
how often the coefficients on the edge of two vertices change their sign, where all signs are certain: no zero within
the edge if never, exactly one, a simple one, if once; and otherwise an upper bound. Zero coefficients do not count.

Of faces, signs of coefficients tell no such thing: two arcs may cut off two corners, with one change of sign along each
edge.
*/
template <SplineNumberType NT, int d>
std::optional<int> sign_changes_of_edge(const Bernstein_simplex<NT, d>& f, int i, int j)
{
  std::vector<CGAL::Sign> signs;
  const auto edge = f.template face<2>({i, j});
  for (const NT& x : edge.coefficients()) {
    const CGAL::Uncertain<CGAL::Sign> sign = Number_traits<NT>::sign(x);
    if (!CGAL::is_certain(sign))
      return std::nullopt;
    signs.push_back(sign.inf());
  }
  return internal::number_of_sign_changes(signs);
}

/*!
\ingroup PkgSplineConstraintsDFunctions
the number of different zeros strictly between two vertices on their edge, crossings and contacts; -1 if all of the edge
is zero. Where the coefficients do not tell, by Sturm's theorem. Complexity: \f$O(k^3)\f$ operations then.
*/
template <SplineNumberType NT, int d>
requires(Number_traits<NT>::is_exact) int zeros_of_edge(const Bernstein_simplex<NT, d>& f, int i, int j)
{
  return internal::number_of_zeros_within(f.template face<2>({i, j}).coefficients());
}

//! \ingroup PkgSplineConstraintsDFunctions
//! the number of those where the function changes its sign: the crossings of the edge; 0 if all of the edge is zero.
template <SplineNumberType NT, int d>
requires(Number_traits<NT>::is_exact) int crossings_of_edge(const Bernstein_simplex<NT, d>& f, int i, int j)
{
  return internal::number_of_crossings_within(f.template face<2>({i, j}).coefficients());
}

/*!
\ingroup PkgSplineConstraintsDFunctions

the number of derivatives that two polynomials, on two simplices with a common face, have in common on that face: -1 if
not even the values agree, and the greater degree if the polynomials are the same. Of two with \f$r\f$ derivatives in
common the coefficients satisfy
\f$b'_{s\,e_o+\mu} = \sum_{|\nu|=s} \frac{s!}{\nu!} \beta^\nu\, b_{\nu+\mu}\f$ for \f$s = 0,\dots,r\f$ and all \f$\mu\f$
without vertex \f$o\f$.
\param f the one.
\param g the other, on the simplex in which a point takes the place of the vertex `opposite`.
\param opposite the vertex \f$o\f$ that is not on the common face.
\param point barycentric coordinates \f$\beta\f$ of the point in the simplex of `f`.
*/
template <SplineNumberType NT, int d>
requires(Number_traits<NT>::is_exact) int order_of_continuity(
    const Bernstein_simplex<NT, d>& f, const Bernstein_simplex<NT, d>& g, int opposite,
    const typename Bernstein_simplex<NT, d>::Barycentric& point)
{
  const int degree = (std::max)(f.degree(), g.degree());
  const Bernstein_simplex<NT, d> own = f.elevated(degree).replaced(opposite, point), other = g.elevated(degree);
  int result = degree;
  other.visit_coefficients([&](const auto& exponents, const NT& x) {
    if (!(own.coefficient(exponents) == x))
      result = (std::min)(result, exponents[opposite] - 1);
  });
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_SIMPLEX_FACES_H
