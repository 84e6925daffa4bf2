// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_INVALID_INPUT_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_INVALID_INPUT_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

What the package throws, in release builds too, when the *data* it was handed is unusable: a coefficient that is not a number, a
domain that is empty, knots that decrease, a weight that is zero, sizes that do not match. `what()` says what is wrong and where
(the index of the offending entry).
*/
class Invalid_input
  : public std::invalid_argument
{
public:
  using std::invalid_argument::invalid_argument;
};

namespace internal {

// Of operations that approximate: the distance they are given.
template <class Number>
void check_error(const Number& error, const std::string& operation)
{
  if (!(error > 0))
    throw Invalid_input(operation + ": the error must be positive");
}

} // namespace internal

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_INVALID_INPUT_H
