// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CURVATURE_FORMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CURVATURE_FORMS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

/*
Of a function with gradient g and matrix H of second derivatives: the numerators of the Gaussian curvature of its level
surfaces, E2 / |g|^4 with E2 = g^T adj(H) g, and of the sum of their principal curvatures, E1 / |g|^3 with
E1 = |g|^2 tr(H) - g^T H g. The form d^T H d on the tangent plane has the determinant E2 / |g|^2 and the trace
E1 / |g|^2 in an orthonormal basis. In other affine coordinates, E2 is multiplied by a positive constant; where
E2 >= 0, E1 keeps its sign.
*/
template <class Ring>
struct Curvature_forms
{
  Ring gaussian, mean;
};

// H by rows, above its diagonal: 00, 01, 02, 11, 12, 22.
template <class Ring>
Curvature_forms<Ring> curvature_forms(const std::array<Ring, 3>& g, const std::array<Ring, 6>& H)
{
  const auto minor = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return Ring(H[a] * H[b]) - Ring(H[c] * H[d]);
  };
  const std::array<Ring, 3> squares{Ring(g[0] * g[0]), Ring(g[1] * g[1]), Ring(g[2] * g[2])},
      products{Ring(g[1] * g[2]), Ring(g[0] * g[2]), Ring(g[0] * g[1])};
  const Ring twice = Ring(products[0] * minor(2, 1, 0, 4)) + Ring(products[1] * minor(1, 4, 3, 2)) +
      Ring(products[2] * minor(2, 4, 1, 5));
  Ring gaussian = Ring(squares[0] * minor(3, 5, 4, 4)) + Ring(squares[1] * minor(0, 5, 2, 2)) +
      Ring(squares[2] * minor(0, 3, 1, 1));
  gaussian += twice;
  gaussian += twice;
  const Ring mixed = Ring(products[0] * H[4]) + Ring(products[1] * H[2]) + Ring(products[2] * H[1]);
  Ring mean = Ring(squares[0] * Ring(H[3] + H[5])) + Ring(squares[1] * Ring(H[0] + H[5])) +
      Ring(squares[2] * Ring(H[0] + H[3]));
  mean -= mixed;
  mean -= mixed;
  return {gaussian, mean};
}

// The six second derivatives from first ones: `derivative(function, axis)`.
template <class Ring, class Derivative>
std::array<Ring, 6> second_derivatives(const std::array<Ring, 3>& g, const Derivative& derivative)
{
  return {derivative(g[0], 0), derivative(g[0], 1), derivative(g[0], 2),
          derivative(g[1], 1), derivative(g[1], 2), derivative(g[2], 2)};
}

// The place of an entry among the six.
constexpr std::size_t place_of_entry(std::size_t i, std::size_t j)
{
  constexpr std::size_t places[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
  return places[i][j];
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CURVATURE_FORMS_H
