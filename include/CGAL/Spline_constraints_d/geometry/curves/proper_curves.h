// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_PROPER_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_PROPER_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Proper_reparametrization.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/traced_curves_declarations.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/geometry/curves/internal/traced_curves.h>
#endif

#include <concepts>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Exactly: doubles are rational numbers.
template <SplineKernel Kernel, int d>
Bspline_curve<Exact_kernel, d> in_exact_numbers(const Bspline_curve<Kernel, d>& curve)
{
  if constexpr (std::same_as<Kernel, Exact_kernel>)
    return curve;
  else
    return Bspline_curve<Exact_kernel, d>(curve);
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDCurveProperness
/// @{

/*!
the tracing index: how many parameters almost all points of the image have, complex ones and infinity included, for the
map of a polynomial or rational piece beyond its ends. The greatest one of the pieces; successive ones with the same map
are one piece.

Coordinates are taken exactly as they are: most curves with rounded ones are proper. Common zeros of all numerators and
the weight are divided out first. The index divides the degree of the map, and does not change with elevation, knot
insertion or restriction.

\param curve a curve in the plane or in space.
\throws Invalid_input when a piece is one point, whose index is not defined.

The parameters of a point are the zeros of a greatest common divisor of polynomials in one unknown. Two points give a
candidate for \f$h\f$ in \f$c = \tilde c \circ h\f$, and if \f$\tilde c\f$ exists, the degree of \f$h\f$ is proved to be
the index: some common divisors of polynomials with the degree of the curve. Luroth's theorem; Sederberg, Improperly
parametrized rational curves, 1986, who takes a common divisor in two unknowns. Proofs: \ref
Spline_constraints_d_properness_proofs.
*/
template <SplineKernel Kernel, int d>
int tracing_index(const Bspline_curve<Kernel, d>& curve)
{
  return internal::Proper::tracing_index(internal::in_exact_numbers(curve));
}

/*!
whether the tracing index is 1: no piece takes more than finitely many points twice. Different pieces may still run over
each other; `Proper_reparametrization::times()` tells.
\throws Invalid_input as `tracing_index()`.
*/
template <SplineKernel Kernel, int d>
bool is_proper(const Bspline_curve<Kernel, d>& curve)
{
  return tracing_index(curve) == 1;
}

/*!
whether all pieces of two curves are parts of one algebraic curve: pieces whose maps become equal, when they are made
proper, by a fractional linear function of the parameter.
\throws Invalid_input as `tracing_index()`.
*/
template <SplineKernel First_kernel, SplineKernel Second_kernel, int d>
bool have_same_support(const Bspline_curve<First_kernel, d>& first, const Bspline_curve<Second_kernel, d>& second)
{
  return internal::Proper::have_same_support(internal::in_exact_numbers(first), internal::in_exact_numbers(second));
}

/*!
a curve as proper ones after functions of its parameter, \f$c = \tilde c \circ h\f$, with the parameters at which it
turns back on itself. All pieces on one algebraic curve are taken together: a circle of four arcs that is run through
twice, polynomial pieces that go forth and back, an edge that comes again.

Each component of the answer is a part of an algebraic curve that the curve covers without gaps, with exact numbers.
Its ends are exact where they are rational, else it is longer by less than \f$2^{-100}\f$ in its parameter. What lies
between two ends that are not that far apart counts as covered.

\param curve a curve in the plane or in space.
\param options limits of time and a visitor. When one ends the run, all of the curve is undecided.
\throws Invalid_input as `tracing_index()`, or when an option makes no sense.

Complexity: for each piece as `tracing_index()`, for each two pieces of the same degree three common divisors at most,
and the isolation of the critical points of \f$h\f$.
*/
template <SplineKernel Kernel, int d>
Proper_reparametrization<d> proper_reparametrization(const Bspline_curve<Kernel, d>& curve,
                                                     const Solver_options& options = {})
{
  return internal::Proper::proper_reparametrization(internal::in_exact_numbers(curve), options);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_PROPER_CURVES_H
