// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTEGRAL_OF_QUOTIENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTEGRAL_OF_QUOTIENT_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The integral of a polynomial over [0,1].
Exact_rational integral(const Bernstein_tensor<Exact_rational>& f);

/*
Bounds of the integral of n/v over [0,1] for a positive polynomial v, whose difference is at most 2 `error`: n/v = q +
(n - q v)/v with a polynomial q, the begin of the power series of the quotient about the middle. Ranges are halved until
the rest is small.
*/
Rational_interval integral_of_quotient(const Bernstein_tensor<Exact_rational>& n,
                                       const Bernstein_tensor<Exact_rational>& v, const Exact_rational& error);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational integral(const Bernstein_tensor<Exact_rational>& f)
{
  Exact_rational sum(0);
  for (const Exact_rational& c : f.coefficients())
    sum += c;
  return Exact_rational(sum / Exact_rational(static_cast<int>(f.coefficients().size())));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Rational_interval integral_of_quotient(const Bernstein_tensor<Exact_rational>& n,
                                                                      const Bernstein_tensor<Exact_rational>& v,
                                                                      const Exact_rational& error)
{
  constexpr std::size_t length = 16;
  constexpr int bits = 128;
  if (const Exact_rational least = v.bounds().first; least > 0) {
    // powers of u, where the range is [-1,1]
    const auto about_middle = [](const Bernstein_tensor<Exact_rational>& f) {
      return f.restricted(0, Exact_rational(1) / 2, Exact_rational(1)).power_coefficients();
    };
    const std::vector<Exact_rational> b = about_middle(v);
    std::vector<Exact_rational> rest = about_middle(n);
    rest.resize((std::max)(rest.size(), length + b.size()));
    Exact_rational result(0), largest_rest(0);
    for (std::size_t k = 0; k < length; ++k) {
      const Exact_rational q = round_to_dyadic(Exact_rational(rest[k] / b[0]), bits);
      for (std::size_t i = 0; i < b.size(); ++i)
        rest[k + i] -= Exact_rational(q * b[i]);
      if (k % 2 == 0)
        result += Exact_rational(q / Exact_rational(static_cast<int>(k + 1)));
    }
    for (const Exact_rational& c : rest)
      largest_rest += CGAL::abs(c);
    largest_rest /= least;
    if (largest_rest <= error)
      return {Exact_rational(result - largest_rest), Exact_rational(result + largest_rest)};
  }
  const auto [n0, n1] = n.split(0);
  const auto [v0, v1] = v.split(0);
  const Rational_interval half(Exact_rational(Exact_rational(1) / 2));
  return half * (integral_of_quotient(n0, v0, error) + integral_of_quotient(n1, v1, error));
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTEGRAL_OF_QUOTIENT_H
