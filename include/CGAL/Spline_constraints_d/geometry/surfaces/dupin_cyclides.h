// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_DUPIN_CYCLIDES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_DUPIN_CYCLIDES_H

#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A full turn as homogeneous functions of one parameter of a surface: the cosine and the sine are their quotients by
// the weight.
struct Full_turn
{
  Scalar_function cosine, sine, weight;

  static Full_turn on_axis(const Exact_box& domain, int axis)
  {
    const Direction_path path = Direction_path::half_round(Exact_rational(1)).on_axis(domain, axis);
    return {path.squared_sigma - path.squared_tau, path.sigma_tau * Exact_rational(2),
            path.squared_sigma + path.squared_tau};
  }
};

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDConstructions

the Dupin cyclide with the focal ellipse \f$(a \cos\theta, b \sin\theta, 0)\f$, where \f$a^2 = b^2 + c^2\f$: the
envelope of the spheres around its points with the radii \f$\mu - c \cos\theta\f$,
\f[ S = \frac{1}{a - c \cos\theta \cos\psi} \begin{pmatrix} \mu (c - a \cos\theta \cos\psi) + b^2 \cos\theta \\
b \sin\theta\, (a - \mu \cos\psi) \\ b \sin\psi\, (c \cos\theta - \mu) \end{pmatrix}, \f]
of degrees (2,2). It is the surface \f$(x^2+y^2+z^2-\mu^2+b^2)^2 = 4(ax-c\mu)^2 + 4b^2y^2\f$; for \f$c = 0\f$, a
torus. Axis 0 is \f$\theta\f$, once around over \f$[0,4]\f$, axis 1 is \f$\psi\f$, likewise. All lines of curvature
are circles: the lines of the parameters. The `rational_unit_normal()` is
\f$(c - a \cos\theta \cos\psi, -b \sin\theta \cos\psi, -b \sin\psi) / (a - c \cos\theta \cos\psi)\f$, so an offset
is the cyclide of another \f$\mu\f$. For \f$c < \mu < a\f$ it is a ring, whose normals point outwards; otherwise it has
singular points. Exact where the kernel is; other places come by `transformed()`.

\tparam Kernel a `SplineKernel`.
\param a the larger half axis of the ellipse, along \f$x\f$.
\param b the smaller one, along \f$y\f$.
\param c the distance of its foci from the origin.
\param mu the mean radius.
\throws Invalid_input when not \f$b > 0\f$, \f$c \ge 0\f$ and \f$a^2 = b^2 + c^2\f$, exactly, as for 5, 4 and 3; or
when a number is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> dupin_cyclide_surface(const typename Kernel::FT& a, const typename Kernel::FT& b,
                                                const typename Kernel::FT& c, const typename Kernel::FT& mu)
{
  using namespace internal;
  const auto number = [](const typename Kernel::FT& x) { return converted_number<Exact_rational>(x); };
  const Exact_rational A = number(a), B = number(b), C = number(c), M = number(mu);
  if (!(B > 0 && C >= 0 && A > 0 && A * A == B * B + C * C))
    throw Invalid_input("dupin_cyclide_surface: a, b > 0 and c >= 0 with a^2 = b^2 + c^2 are needed");
  const Exact_box domain(2, {Exact_rational(0), Exact_rational(4)});
  const Full_turn theta = Full_turn::on_axis(domain, 0), psi = Full_turn::on_axis(domain, 1);
  const Scalar_function weights = theta.weight * psi.weight, cosines = theta.cosine * psi.cosine;
  const Scalar_function x = (weights * C - cosines * A) * M + theta.cosine * psi.weight * Exact_rational(B * B),
                        y = theta.sine * (psi.weight * A - psi.cosine * M) * B,
                        z = psi.sine * (theta.cosine * C - theta.weight * M) * B;
  return Bspline_surface_3<Kernel>(Bspline_surface_3<Exact_kernel>::from_homogeneous_coordinates(
      {x.function(), y.function(), z.function()}, (weights * A - cosines * C).function()));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_DUPIN_CYCLIDES_H
