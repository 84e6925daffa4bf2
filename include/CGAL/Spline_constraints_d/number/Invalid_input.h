// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_INVALID_INPUT_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_INVALID_INPUT_H

#include <charconv>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

What the package throws, in release builds too, when the *data* it was handed is unusable: a coefficient that is not a
number, a domain that is empty, knots that decrease, a weight that is zero, sizes that do not match. `what()` says what
is wrong and where (the index of the offending entry).
*/
class Invalid_input
  : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

namespace internal {

// The shortest decimal number that is read as this one.
inline std::string shortest_text(double x)
{
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, x).ptr);
}

// Of operations that approximate: the distance they are given.
template <class Number>
void check_error(const Number& error, const std::string& operation)
{
  if (!(error > 0))
    throw Invalid_input(operation + ": the error must be positive");
}

// Bounds of products of four lengths up to this one, and down to its inverse, are bounded by doubles other than zero
// and infinity.
inline constexpr double most_magnitude = 0x1p250;

// Of operations that would decide nothing with others, after all has been tried: the greatest absolute value of a
// coordinate.
template <class Number>
void check_greatest_coordinate(const Number& greatest, const std::string& operation)
{
  if (greatest > Number(most_magnitude) || (greatest > Number(0) && greatest < Number(1 / most_magnitude)))
    throw Invalid_input(operation + ": the greatest coordinate is not between 2^-250 and 2^250");
}

} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_INVALID_INPUT_H
