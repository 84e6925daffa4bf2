// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_PERIODIC_KNOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_PERIODIC_KNOTS_H

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
The knots u_0 <= ... <= u_n of one period, u_n being u_0 again, continued by `degree` knots to both sides: those of n +
degree control points, the first `degree` of which come again at the end. All differences are taken from the ends of the
period, so that rounded knots do not decrease either.
*/
template <class NT>
std::vector<NT> unwrapped_knots(int degree, const std::vector<NT>& period, const std::string& who)
{
  if (degree < 1)
    throw Invalid_input(who + ": degree " + std::to_string(degree) + " is too low for a periodic spline");
  if (period.size() < 2)
    throw Invalid_input(who + ": " + std::to_string(period.size()) + " knots, a period needs at least 2");
  check_finite(period, who + ": knot");
  const std::size_t n = period.size() - 1;
  const NT length = period[n] - period[0];
  if (!(NT(0) < length))
    throw Invalid_input(who + ": the period is empty");

  std::vector<NT> knots;
  for (int i = degree; i >= 1; --i) {
    const std::size_t turns = static_cast<std::size_t>(i - 1) / n, back = static_cast<std::size_t>(i - 1) % n + 1;
    knots.push_back(NT(period[0] - NT(period[n] - period[n - back])) - NT(NT(static_cast<int>(turns)) * length));
  }
  knots.insert(knots.end(), period.begin(), period.end());
  for (int i = 1; i <= degree; ++i) {
    const std::size_t turns = static_cast<std::size_t>(i - 1) / n, ahead = static_cast<std::size_t>(i - 1) % n + 1;
    knots.push_back(NT(period[n] + NT(period[ahead] - period[0])) + NT(NT(static_cast<int>(turns)) * length));
  }
  if (std::count(knots.begin(), knots.end(), period[0]) > degree)
    throw Invalid_input(who + ": the ends of the period occur too often together, the spline of degree " +
                        std::to_string(degree) + " is torn there");
  return knots;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_PERIODIC_KNOTS_H
