// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_EXACT_VECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_EXACT_VECTOR_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <std::size_t d>
using Exact_vector = std::array<Exact_rational, d>;

template <std::size_t d>
Exact_rational exact_dot(const Exact_vector<d>& a, const Exact_vector<d>& b)
{
  Exact_rational result(a[0] * b[0]);
  for (std::size_t i = 1; i < d; ++i)
    result += Exact_rational(a[i] * b[i]);
  return result;
}

template <std::size_t d>
Exact_vector<d> exact_difference(const Exact_vector<d>& a, const Exact_vector<d>& b)
{
  Exact_vector<d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = Exact_rational(a[i] - b[i]);
  return result;
}

inline Exact_rational exact_cross(const Exact_vector<2>& a, const Exact_vector<2>& b)
{
  return Exact_rational(a[0] * b[1] - a[1] * b[0]);
}

inline Exact_vector<3> exact_cross(const Exact_vector<3>& a, const Exact_vector<3>& b)
{
  Exact_vector<3> result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = Exact_rational(a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3]);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_EXACT_VECTOR_H
