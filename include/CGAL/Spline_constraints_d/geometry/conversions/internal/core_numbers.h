// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_INTERNAL_CORE_NUMBERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_INTERNAL_CORE_NUMBERS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/CORE_algebraic_number_traits.h>

#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The value of an algebraic number if it is found to be rational: the simplest rational number within 400 bits around it
is the only candidate, and compared with it exactly. So every rational number is found whose numerator and denominator
have less than 190 bits.
*/
inline std::optional<Exact_rational> rational_value_of(const CORE::Expr& x)
{
  if (x.sign() == 0)
    return Exact_rational(0);
  const CORE::BigRat near = x.approx(CORE::extLong(400), CORE::extLong::getPosInfty()).BigRatValue();
  const Exact_rational middle = converted_number<Exact_rational>(near);
  const Exact_rational width = CGAL::abs(middle) * scaled_rational(Big_integer(1), -390);
  const Exact_rational candidate =
      simplest_rational_between(Exact_rational(middle - width), Exact_rational(middle + width));
  if (CORE::Expr(converted_number<CORE::BigRat>(candidate)) != x)
    return std::nullopt;
  return candidate;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_INTERNAL_CORE_NUMBERS_H
