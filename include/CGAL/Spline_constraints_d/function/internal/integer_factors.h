// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FACTORS_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/Zassenhaus_factors.h>
#include <CGAL/Spline_constraints_d/function/internal/integer_factors_declarations.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Integer_factor> integer_factors(const Integer_coefficients& f,
                                                                           Interruption& interruption)
{
  std::vector<Integer_factor> result;
  for (const auto& [square_free, multiplicity] : Integer_polynomial(f).square_free_factors()) {
    Integer_coefficients rest = primitive_part(square_free.coefficients());
    if (rest.front() == 0) {
      result.push_back({{Big_integer(0), Big_integer(1)}, multiplicity});
      rest.erase(rest.begin());
    }
    if (rest.size() > 1)
      for (Integer_coefficients& factor : Zassenhaus_factors(std::move(rest), interruption)())
        result.push_back({std::move(factor), multiplicity});
  }
  for (Integer_factor& factor : result)
    if (factor.polynomial.back() < 0)
      for (Big_integer& x : factor.polynomial)
        x = -x;
  std::sort(result.begin(), result.end(), [](const Integer_factor& a, const Integer_factor& b) {
    const auto degrees = std::pair(a.polynomial.size(), b.polynomial.size());
    return degrees.first != degrees.second
        ? degrees.first < degrees.second
        : std::tie(a.multiplicity, a.polynomial) < std::tie(b.multiplicity, b.polynomial);
  });
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FACTORS_H
