// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FACTORS_DECLARATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FACTORS_DECLARATIONS_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

struct Integer_factor
{
  Integer_coefficients polynomial; // irreducible and primitive, with a positive leading coefficient
  int multiplicity;
};

// The irreducible factors of a polynomial over the rational numbers, by their degrees. \pre It is not zero, and has no
// zeros at the end. Defined in integer_factors.h.
std::vector<Integer_factor> integer_factors(const Integer_coefficients& f, Interruption& interruption);

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FACTORS_DECLARATIONS_H
