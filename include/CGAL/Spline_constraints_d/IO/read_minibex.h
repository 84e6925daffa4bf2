// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_READ_MINIBEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_READ_MINIBEX_H

#include <CGAL/Spline_constraints_d/IO/Minibex_system.h>
#include <CGAL/Spline_constraints_d/IO/Parse_error.h>
#include <CGAL/Spline_constraints_d/IO/internal/Minibex_parser.h>
#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <istream>
#include <string>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

reads a system of equations and inequalities in a subset of Minibex, the input language of the solver IBEX: of
polynomials, and, where `subset` says so, of elementary functions, quotients and all powers.

\code{.unparsed}
Constants                    // optional
  r = 3/2;  s in 2;  c[3] = (1; 1/2; 1/3);
Function f(a, b[3])          // optional, also after the variables
  d = a^2 + b(1);
  return d*b(2)
end
Variables                    // , or ; between them, ; at the end
  x in [-1e8, 1e8], y in [-r, 2*r];
  z[3] in [0, 1];            // also: in ([0,1]; [0,2]; [-1,1])
Constraints
  x^2 + 7./48*sqr(y) - s*z(1) = 0;
  (x - 1)*z[0]^3 <= max(.5e-3, 1/r);   // z(1) and z[0] are the same unknown
  for i = 1:2;
    f(z(i), c) + sum(k = 1:3, c(k)*z(k)^k) = z(i+1);
  end
end
\endcode

- Keywords are written `end`, `End` or `END`. Comments are those of C++.
- Numbers are read exactly: `0.1` is one tenth and `7./48` is 7/48. A number has at most 20000 digits when written
  without exponent.
- `^` takes a constant integer and associates to the left; it binds stronger than a sign: `-x^2` is \f$-(x^2)\f$.
- `/` divides by a constant. A sign after `/` or `^` that is followed by another `*`, `/` or `^` needs parentheses,
  since IBEX reads `1/-2*3` as `1/(-(2*3))`.
- The elements of an array `z[3]` are `z(1)`, `z(2)`, `z(3)`, or, as in recent versions of IBEX, `z[0]`, `z[1]`, `z[2]`.
- Every unknown needs a domain with finite bounds, which are constant expressions.
- A function takes numbers and arrays, and returns a number. Names that it introduces are its own; it knows constants.
- `min` and `max` take constants.
- With elementary functions: `exp`, `ln` (also `log`), `sqrt`, `abs`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`,
  `sinh`, `cosh`, `tanh`, `pi`; `/` divides by what is no constant; `x^(1/3)` and `x^-2` are powers, and \f$x^y\f$ is
  \f$e^{y \ln x}\f$. Numbers such as `2*pi` are enclosed, and as ends of domains they are rounded outwards. A point
  where a part of the formula is not defined is no solution.
- Not in the subset, and reported as such: other functions than these, `sqr` and one's own, interval constants,
  matrices, the sections `Parameters` and `Minimize`, loops in functions, constraints in parentheses.

Expressions are expanded; the time this takes is bounded by a constant (some seconds) plus a multiple of the length of
the file.

\param in the file's content.
\param file_name how errors call the file.
\param subset what is read of the language.
\throws Parse_error with line, column and the offending text, when the content is not such a system or the limits of
`Power_polynomial` are exceeded;
        also when the stream fails.
*/
Minibex_system read_minibex(std::istream& in, const std::string& file_name,
                            Minibex_subset subset = Minibex_subset::POLYNOMIAL);

/*!
\ingroup PkgSplineConstraintsDIO

reads the file of the given path.
\param path where it is.
\param subset what is read of the language.
\throws Parse_error as above, and when the file cannot be opened.
*/
Minibex_system read_minibex(const std::string& path, Minibex_subset subset = Minibex_subset::POLYNOMIAL);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Minibex_system read_minibex(std::istream& in, const std::string& file_name,
                                                           Minibex_subset subset)
{
  const internal::Text_source source = internal::Text_source::read(in, file_name);
  return internal::Minibex_parser(source.content(), file_name, subset).system();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Minibex_system read_minibex(const std::string& path, Minibex_subset subset)
{
  const internal::Text_source source = internal::Text_source::read(path);
  return internal::Minibex_parser(source.content(), path, subset).system();
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_READ_MINIBEX_H
