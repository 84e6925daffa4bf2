// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_DECOMPOSITIONS_DECLARATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_DECOMPOSITIONS_DECLARATIONS_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

struct Found_decomposition
{
  Polynomial_quotient g, h;
};

// All f = g o h with degrees above one, up to fractional linear functions between g and h, by the degrees of h. Defined
// in decompositions.h.
std::vector<Found_decomposition> decompositions_of(const Polynomial_quotient& f, Interruption& interruption);

// 0, 1, -1, 1/2, -1/2, 2, -2, 1/3, -1/3, ...: all rational numbers, once each (Calkin and Wilf 2000, with both signs).
inline Exact_rational small_rational(int index)
{
  Exact_rational result(index == 0 ? 0 : 1);
  int path = (index + 1) / 2, length = 0;
  while (path >> (length + 1) != 0)
    ++length;
  while (length-- > 0)
    result = (path >> length) & 1 ? Exact_rational(result + 1) : Exact_rational(result / (result + 1));
  return index % 2 == 0 ? Exact_rational(-result) : result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_DECOMPOSITIONS_DECLARATIONS_H
