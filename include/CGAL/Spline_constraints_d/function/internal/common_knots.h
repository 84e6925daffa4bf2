// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_COMMON_KNOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_COMMON_KNOTS_H

#include <CGAL/Spline_constraints_d/function/internal/spline_cells.h>
#include <CGAL/Spline_constraints_d/function/knot_vector.h>
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
What operations on two splines need of their knots.
*/

template <class NT>
bool have_same_domain(const std::vector<Knot_axis<NT>>& a, const std::vector<Knot_axis<NT>>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Knot_axis<NT>& x, const Knot_axis<NT>& y) {
    return x.begin() == y.begin() && x.end() == y.end();
  });
}

// Throws unless both have the same domain; the message names the axis.
template <class NT>
void check_same_domain(const std::vector<Knot_axis<NT>>& a, const std::vector<Knot_axis<NT>>& b)
{
  check_count(b.size(), a.size(), "Bspline_function: dimension of the second operand");
  for (std::size_t j = 0; j < a.size(); ++j)
    if (!(a[j].begin() == b[j].begin() && a[j].end() == b[j].end()))
      throw Invalid_input("Bspline_function: the operands have different domains on axis " + std::to_string(j));
}

template <class NT>
std::vector<int> highest_degrees(const std::vector<Knot_axis<NT>>& a, const std::vector<Knot_axis<NT>>& b)
{
  std::vector<int> result;
  for (std::size_t j = 0; j < a.size(); ++j)
    result.push_back((std::max)(a[j].degree, b[j].degree));
  return result;
}

// The breaks of a sum or product of the given degrees.
template <class NT>
Break_grid<NT> common_break_grid(const std::vector<Knot_axis<NT>>& a, const std::vector<Knot_axis<NT>>& b,
                                 const std::vector<int>& degrees)
{
  Break_grid<NT> result;
  for (std::size_t j = 0; j < degrees.size(); ++j)
    result.push_back(common_breaks(degrees[j], a[j], b[j]));
  return result;
}

template <class NT>
bool are_clamped(const std::vector<Knot_axis<NT>>& axes)
{
  return std::all_of(axes.begin(), axes.end(), [](const Knot_axis<NT>& axis) { return axis.is_clamped(); });
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_COMMON_KNOTS_H
