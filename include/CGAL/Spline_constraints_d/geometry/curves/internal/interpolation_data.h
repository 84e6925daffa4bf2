// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_INTERPOLATION_DATA_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_INTERPOLATION_DATA_H

#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The coordinates of a point or vector.
template <class NT, int d, class Object>
std::array<NT, d> array_of_coordinates(const Object& object)
{
  std::array<NT, d> result;
  for (int k = 0; k < d; ++k)
    result[k] = converted_number<NT>(object.cartesian(k));
  return result;
}

// The parameters of points that a curve is to run through: those given, or the integers from 0 on.
template <class FT>
std::vector<FT> interpolation_parameters(std::vector<FT> parameters, std::size_t number_of_points,
                                         const std::string& name)
{
  if (number_of_points < 2)
    throw Invalid_input(name + ": " + std::to_string(number_of_points) + " points, at least 2 are needed");
  if (parameters.empty())
    for (std::size_t i = 0; i < number_of_points; ++i)
      parameters.push_back(FT(static_cast<int>(i)));
  check_count(parameters.size(), number_of_points, name + ": parameters");
  for (std::size_t i = 0; i + 1 < parameters.size(); ++i)
    if (!(parameters[i] < parameters[i + 1]))
      throw Invalid_input(name + ": parameter " + std::to_string(i + 1) + " is not larger than the one before");
  return parameters;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_INTERPOLATION_DATA_H
