// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INNER_ROOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INNER_ROOTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/critical_values.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_root.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// Times a positive constant.
inline Integer_polynomial integer_polynomial(const Coefficients& coefficients)
{
  Big_integer denominator(1);
  for (const Exact_rational& c : coefficients)
    denominator = lcm(denominator, denominator_of(c));
  std::vector<Big_integer> result;
  for (const Exact_rational& c : coefficients)
    result.push_back(Big_integer(numerator_of(c) * (denominator / denominator_of(c))));
  return Integer_polynomial(std::move(result));
}

inline Integer_polynomial integer_polynomial(const Bernstein_tensor<Exact_rational>& f)
{
  return integer_polynomial(power_coefficients(f));
}

inline void narrow(Exact_root& root, const Exact_rational& width)
{
  if (root.width() > width * power_of_two(64))
    root.narrow(width);
  while (root.width() > width)
    root.halve();
}

// So small that rational roots are the simplest numbers in intervals around them: their denominators divide the leading
// coefficient.
inline Exact_rational width_for_rational_roots(const Bernstein_tensor<Exact_rational>& f)
{
  const Integer_polynomial polynomial = integer_polynomial(f);
  return quotient(Big_integer(1), Big_integer(2 * polynomial.leading_coefficient() * polynomial.leading_coefficient()));
}

/*
The different roots of a polynomial in the open interval (0,1), in order, in intervals that are apart and at most of a
given width; rational roots with short fractions are points. None of zero.
*/
inline std::vector<Exact_root> inner_roots(const Bernstein_tensor<Exact_rational>& f, const Exact_rational& width)
{
  Integer_polynomial polynomial = integer_polynomial(f);
  std::vector<Exact_root> result;
  if (polynomial.is_zero())
    return result;
  const Exact_rational zero(0), one(1);
  polynomial.remove_root(zero);
  polynomial.remove_root(one);
  for (auto& [factor, exponent] : polynomial.square_free_factors())
    for (Exact_root& root : isolate_roots(
             std::make_shared<const Integer_polynomial>(std::move(factor)), zero, one, [] { return false; },
             [](const auto&, const auto&) {}))
      result.push_back(std::move(root));
  for (Exact_root& root : result) {
    narrow(root, width);
    root.settle_on_simplest_rational();
  }
  for (bool are_apart = false; !are_apart;) {
    are_apart = true;
    std::sort(result.begin(), result.end(),
              [](const Exact_root& a, const Exact_root& b) { return a.lower() < b.lower(); });
    for (std::size_t i = 0; i + 1 < result.size(); ++i)
      if (!(result[i].upper() < result[i + 1].lower())) {
        result[i].halve();
        result[i + 1].halve();
        are_apart = false;
      }
  }
  for (std::size_t i = 0; i < result.size(); ++i)   // the ends of the interval are no roots
    while (!(result[i].lower() > 0 && result[i].upper() < 1))
      result[i].halve();
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INNER_ROOTS_H
