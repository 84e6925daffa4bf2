// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SINGULAR_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SINGULAR_POINTS_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/near_fraction.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Face_signs.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/curvature_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

inline bool is_singular_point(const Form& form, const Form::Barycentric& tau)
{
  for (const Exact_rational& x : tau)
    if (CGAL::sign(x) == CGAL::NEGATIVE)
      return false;
  for (int axis = 1; axis <= 3; ++axis)
    if (!CGAL::is_zero(form.derivative(0, axis)(tau)))
      return false;
  return CGAL::is_zero(form(tau));
}

// The solution of three linear equations in doubles, by Cramer's rule; not finite where there is none.
inline std::array<double, 3> solution_of_three(const std::array<double, 6>& H, const std::array<double, 3>& b)
{
  const auto entry = [&](std::size_t i, std::size_t j) { return H[place_of_entry(i % 3, j % 3)]; };
  std::array<double, 3> result{};
  double determinant = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      const double cofactor = entry(i + 1, j + 1) * entry(i + 2, j + 2) - entry(i + 1, j + 2) * entry(i + 2, j + 1);
      result[j] += cofactor * b[i];
      if (i == 0)
        determinant += cofactor * entry(i, j);
    }
  for (double& x : result)
    x /= determinant;
  return result;
}

/*
A point with rational barycentric coordinates in the tetrahedron where a function and its gradient are zero, near a
given one: a critical point by Newton's method in doubles, whose coordinates are replaced by near fractions. Whether it
is a singular point is checked exactly; where there is none with coordinates that doubles tell, nothing is found.
*/
inline std::optional<Form::Barycentric> rational_singular_point(const Form& form, const Form::Barycentric& start)
{
  const auto in_doubles = [](const Form& f) {
    return f.converted<double>([](const Exact_rational& x) { return to_nearest_double(x); });
  };
  using Rounded = Bernstein_simplex<double, 3>;
  const auto along = [](const Rounded& f, int axis) { return f.derivative(0, axis + 1); };
  const Rounded f = in_doubles(form);
  const std::array<Rounded, 3> gradient{along(f, 0), along(f, 1), along(f, 2)};
  const std::array<Rounded, 6> hessian = second_derivatives(gradient, along);
  Rounded::Barycentric tau;
  for (int i = 0; i < 4; ++i)
    tau[i] = to_nearest_double(start[i]);
  for (int step = 0; step < 30; ++step) {
    std::array<double, 3> g;
    std::array<double, 6> H;
    for (std::size_t i = 0; i < 3; ++i)
      g[i] = gradient[i](tau);
    for (std::size_t i = 0; i < 6; ++i)
      H[i] = hessian[i](tau);
    const std::array<double, 3> change = solution_of_three(H, g);
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(std::abs(change[i]) < 10)) // no number, or away from the tetrahedron
        return std::nullopt;
      tau[i + 1] -= change[i];
      tau[0] += change[i];
    }
  }
  Form::Barycentric result;
  result[0] = Exact_rational(1);
  for (int i = 1; i < 4; ++i) {
    const auto fraction = near_fraction(tau[i], 1e-9, 1e6);
    if (!fraction)
      return std::nullopt;
    result[i] = Exact_rational(to_rational(fraction->numerator) / to_rational(fraction->denominator));
    result[0] -= result[i];
  }
  return is_singular_point(form, result) ? std::optional(result) : std::nullopt;
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_SINGULAR_POINTS_H
