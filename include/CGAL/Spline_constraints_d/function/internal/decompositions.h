// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_DECOMPOSITIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_DECOMPOSITIONS_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/Two_fibres.h>
#include <CGAL/Spline_constraints_d/function/internal/decompositions_declarations.h>
#include <CGAL/Spline_constraints_d/function/internal/left_components.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The only polynomial h of a degree k with the leading coefficient one and h(0) = 0 that f can have as its right
component, if f = g o h for polynomials (Kozen and Landau 1989): h^r and f, divided by its leading coefficient, have the
same k highest coefficients, so that h comes from a power series, the r-th root y of that of f, with r f y' = f' y.
*/
inline std::vector<Exact_rational> only_right_component(const Integer_coefficients& f, std::size_t k)
{
  const std::size_t n = f.size() - 1;
  const Exact_rational r(static_cast<double>(n / k));
  std::vector<Exact_rational> from_top, root(1, Exact_rational(1));
  for (std::size_t i = 0; i < k; ++i)
    from_top.push_back(scaled_rational(f[n - i], 0) / scaled_rational(f[n], 0));
  for (std::size_t m = 1; m < k; ++m) {
    Exact_rational sum(0); // m r y_m = sum_i (i - r (m - i)) f_i y_(m-i)
    for (std::size_t i = 1; i <= m; ++i)
      sum += (Exact_rational(static_cast<double>(i)) - r * Exact_rational(static_cast<double>(m - i))) * from_top[i] *
          root[m - i];
    root.push_back(sum / (r * Exact_rational(static_cast<double>(m))));
  }
  std::vector<Exact_rational> result(k + 1, Exact_rational(0));
  for (std::size_t i = 0; i < k; ++i)
    result[k - i] = root[i];
  return result;
}

inline std::vector<Found_decomposition> decompositions_of_polynomial(const Polynomial_quotient& f,
                                                                     Interruption& interruption)
{
  const Integer_coefficients& coefficients = f.numerator_coefficients();
  const std::size_t n = coefficients.size() - 1;
  std::vector<Found_decomposition> result;
  for (std::size_t k = 2; 2 * k <= n; ++k)
    if (n % k == 0) {
      interruption.add_work(n * n * n);
      const Pencil pencil(with_integers({only_right_component(coefficients, k)})[0],
                          Integer_coefficients(1, Big_integer(1)));
      if (std::optional<Polynomial_quotient> g = left_component(f, pencil))
        result.push_back({std::move(*g), pencil.function()});
    }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Found_decomposition> decompositions_of(const Polynomial_quotient& f,
                                                                                  Interruption& interruption)
{
  return f.is_polynomial() ? decompositions_of_polynomial(f, interruption) : Two_fibres(f, interruption)();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_DECOMPOSITIONS_H
