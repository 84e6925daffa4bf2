// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_AXIS_EMBEDDING_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_AXIS_EMBEDDING_H

#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A tensor as one of more axes: own axis i becomes axis axes[i], the others have degree 0.
*/

// Throws when an axis is missing, repeated, or not below `dimension`.
inline std::vector<int> embedded_degrees(const std::vector<int>& degrees, int dimension, const std::vector<int>& axes)
{
  check_count(axes.size(), degrees.size(), "Bernstein_tensor: axes to embed into");
  std::vector<int> result(dimension, -1);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    if (axes[i] < 0 || axes[i] >= dimension || result[axes[i]] >= 0)
      throw Invalid_input("Bernstein_tensor: axis " + std::to_string(axes[i]) + " to embed into (entry " +
                          std::to_string(i) + ") is out of range or repeated");
    result[axes[i]] = degrees[i];
  }
  std::replace(result.begin(), result.end(), -1, 0);
  return result;
}

// The coefficients in their new order: walks the result in memory order and follows the index in the source.
template <class NT>
std::vector<NT> embedded_coefficients(const std::vector<NT>& data, const std::vector<int>& degrees,
                                      const std::vector<int>& degrees_of_result, const std::vector<int>& axes)
{
  if (std::is_sorted(axes.begin(), axes.end()))
    return data;
  const std::vector<std::size_t> strides = tensor_strides(degrees);
  std::vector<NT> result;
  result.reserve(data.size());
  for_each_index(degrees_of_result, [&](const std::vector<int>& index) {
    std::size_t source = 0;
    for (std::size_t i = 0; i < axes.size(); ++i)
      source += strides[i] * static_cast<std::size_t>(index[axes[i]]);
    result.push_back(data[source]);
  });
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_AXIS_EMBEDDING_H
