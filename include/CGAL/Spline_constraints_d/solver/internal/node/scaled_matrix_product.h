// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_SCALED_MATRIX_PRODUCT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_SCALED_MATRIX_PRODUCT_H

#include <CGAL/Spline_constraints_d/number/Short_integer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The product of a matrix (row-major), whose columns act on functions times 2^-scale, with an integer matrix, which when
it is empty stands for the identity. The rows are multiplied by powers of two, which makes them integers. Nothing unless
all numbers are finite.
*/
inline std::optional<std::vector<Short_integer>>
scaled_matrix_product(const double* matrix, const std::vector<long>& scale, const std::vector<Short_integer>& integers)
{
  const std::size_t n = scale.size();
  if (!std::all_of(matrix, matrix + n * n, [](double x) { return std::isfinite(x); }))
    return std::nullopt;
  std::vector<Short_integer> product(n * n, Short_integer(0));
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<std::pair<Short_integer, long>> row;
    long finest = (std::numeric_limits<long>::max)();
    for (std::size_t i = 0; i < n; ++i) {
      auto& [factor, exponent] = row.emplace_back(to_dyadic<Short_integer>(matrix[j * n + i]));
      exponent -= scale[i];
      if (factor != 0)
        finest = (std::min)(finest, exponent);
    }
    for (std::size_t i = 0; i < n; ++i) {
      auto& [factor, exponent] = row[i];
      if (factor == 0)
        continue;
      shift_left(factor, static_cast<unsigned long>(exponent - finest));
      if (integers.empty())
        product[j * n + i] = factor;
      else
        for (std::size_t k = 0; k < n; ++k)
          add_product(product[j * n + k], factor, integers[i * n + k]);
    }
  }
  return product;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_SCALED_MATRIX_PRODUCT_H
