// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_ELEMENTARY_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_ELEMENTARY_FUNCTION_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A function of one real number that is no polynomial, on the largest set of real numbers where it is defined.
*/
enum class Elementary_function
{
  RECIPROCAL,         //!< \f$1/x\f$ for \f$x \ne 0\f$
  POWER,              //!< \f$x^r\f$ with a constant \f$r\f$, for \f$x > 0\f$, and \f$x = 0\f$ if \f$r > 0\f$
  SQUARE_ROOT,        //!< the root \f$\ge 0\f$, for \f$x \ge 0\f$
  EXPONENTIAL,        //!< \f$e^x\f$
  LOGARITHM,          //!< to the base \f$e\f$, for \f$x > 0\f$
  SINE,               //!< of an angle in radians, as those that follow
  COSINE,             //!< cosine
  TANGENT,            //!< where the cosine is not zero
  ARC_SINE,           //!< in \f$[-\pi/2, \pi/2]\f$, for \f$|x| \le 1\f$
  ARC_COSINE,         //!< in \f$[0, \pi]\f$, for \f$|x| \le 1\f$
  ARC_TANGENT,        //!< in \f$(-\pi/2, \pi/2)\f$
  HYPERBOLIC_SINE,    //!< \f$(e^x - e^{-x})/2\f$
  HYPERBOLIC_COSINE,  //!< \f$(e^x + e^{-x})/2\f$
  HYPERBOLIC_TANGENT, //!< their quotient
  ABSOLUTE_VALUE      //!< \f$|x|\f$
};

/*!
\ingroup PkgSplineConstraintsDFunctions
the name of a function in formulas, as Minibex has it; of `RECIPROCAL` and `POWER`, which are written with operators,
none.
\param function the function.
*/
inline std::string_view name_of(Elementary_function function)
{
  constexpr std::array<std::string_view, 15> names{"",     "",     "sqrt", "exp",  "ln",   "sin",  "cos", "tan",
                                                   "asin", "acos", "atan", "sinh", "cosh", "tanh", "abs"};
  return names[static_cast<std::size_t>(function)];
}

namespace internal {

// For messages.
inline std::string in_words(Elementary_function function)
{
  return function == Elementary_function::RECIPROCAL ? "a reciprocal"
      : function == Elementary_function::POWER       ? "a power"
                                                     : "the function " + std::string(name_of(function));
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions
the function with a name in formulas; nothing when there is none.
\param name the name; `log` is the logarithm, too.
*/
inline std::optional<Elementary_function> elementary_function_of_name(std::string_view name)
{
  if (name == "log")
    return Elementary_function::LOGARITHM;
  for (int k = 0; k <= static_cast<int>(Elementary_function::ABSOLUTE_VALUE); ++k)
    if (!name.empty() && name_of(static_cast<Elementary_function>(k)) == name)
      return static_cast<Elementary_function>(k);
  return std::nullopt;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_ELEMENTARY_FUNCTION_H
