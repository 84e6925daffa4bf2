// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_IDENTITIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_IDENTITIES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

using Exact_vector = std::array<Exact_rational, 3>;

inline Exact_vector difference(const Exact_vector& a, const Exact_vector& b)
{
  return {Exact_rational(a[0] - b[0]), Exact_rational(a[1] - b[1]), Exact_rational(a[2] - b[2])};
}

inline Exact_vector exact_cross(const Exact_vector& a, const Exact_vector& b)
{
  return {Exact_rational(a[1] * b[2] - a[2] * b[1]), Exact_rational(a[2] * b[0] - a[0] * b[2]),
          Exact_rational(a[0] * b[1] - a[1] * b[0])};
}

inline Exact_rational exact_dot(const Exact_vector& a, const Exact_vector& b)
{
  return Exact_rational(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

inline bool is_null(const Exact_vector& a) { return a[0] == 0 && a[1] == 0 && a[2] == 0; }

inline bool vanishes(const Exact_function& f)
{
  return std::all_of(f.coefficients().begin(), f.coefficients().end(), [](const Exact_rational& c) { return c == 0; });
}

inline Exact_vector values_at(const Vector_of_functions<3>& f, const Exact_rational& x)
{
  const std::array<Exact_rational, 1> place{x};
  return {f[0](place), f[1](place), f[2](place)};
}

// So many different numbers from 0 to 1: a polynomial of smaller degree that is zero in all of them is zero.
inline std::vector<Exact_rational> sample_parameters(int count)
{
  std::vector<Exact_rational> result;
  for (int i = 0; i < count; ++i)
    result.emplace_back(Exact_rational(i) / (std::max)(count - 1, 1));
  return result;
}

inline int degree_of(const Vector_of_functions<3>& f, int axis = 0)
{
  return (std::max)({f[0].degree(axis), f[1].degree(axis), f[2].degree(axis)});
}

// The direction of all vectors of a polynomial curve, if they have one; they may be zero somewhere.
inline std::optional<Exact_vector> common_direction(const Vector_of_functions<3>& f)
{
  std::optional<Exact_vector> result;
  for (const Exact_rational& x : sample_parameters(degree_of(f) + 1)) {
    const Exact_vector v = values_at(f, x);
    if (is_null(v))
      continue;
    if (result && !is_null(exact_cross(*result, v)))
      return std::nullopt;
    result = v;
  }
  return result;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_IDENTITIES_H
