// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_TENSOR_LAYERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_TENSOR_LAYERS_H

#include <CGAL/Spline_constraints_d/function/bernstein_kernels.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The layers of a tensor along one of its axes: the entries with one index there, in the order of the tensor.
*/

template <class NT>
std::vector<NT> layer_of_tensor(const std::vector<NT>& data, const Axis_view& view, int k)
{
  std::vector<NT> result;
  result.reserve(view.outer * view.inner);
  for (std::size_t o = 0; o < view.outer; ++o) {
    const auto begin = data.begin() + (o * (view.degree + 1) + k) * view.inner;
    result.insert(result.end(), begin, begin + view.inner);
  }
  return result;
}

// The differences of neighbouring layers times the degree, at least 1: Bernstein coefficients of the derivative.
template <class NT>
std::vector<NT> scaled_differences(const std::vector<NT>& data, const Axis_view& view)
{
  const int d = view.degree;
  std::vector<NT> result;
  result.reserve(view.outer * d * view.inner);
  const NT factor(d);
  for (std::size_t o = 0; o < view.outer; ++o) {
    const NT* line = data.data() + o * (d + 1) * view.inner;
    for (std::size_t i = 0; i < d * view.inner; ++i)
      result.push_back(factor * NT(line[i + view.inner] - line[i]));
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_TENSOR_LAYERS_H
