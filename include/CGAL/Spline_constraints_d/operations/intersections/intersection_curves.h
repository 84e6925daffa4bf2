// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTION_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTION_CURVES_H

#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Found_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/surface_shapes.h>

namespace CGAL {
namespace Spline_constraints {
/*!
\ingroup PkgSplineConstraintsDIntersections

all curves that two surfaces have in common, with proofs of their number and of how they are connected; with a plane as
one of the surfaces, plane sections and contour lines of the other one.

Operands are taken exactly, and all is decided by `solve_curves()`: no closed curve is lost, however small, nothing is
joined by distance. Of a parametric surface and a plane, sphere or other implicit surface \f$f = 0\f$ the equation is
\f$f(S(u,v)) = 0\f$; of two parametric surfaces \f$A(u,v) = B(s,t)\f$, three equations in four unknowns, or one in two
if both are polynomial height fields over the same two coordinates; of two implicit ones \f$f = g = 0\f$ in space. Of a
parametric surface that is proved to be all of an equation \f$f = 0\f$ of degree four at most, or the part of it between
planes that its edges lie in, as rectangles, spheres, cylinders, cones, tori and their pieces are, and another
parametric one, it is \f$f(B(s,t)) = 0\f$ as well. An implicit surface that ends at its box within the bounds of a
parametric one adds the coordinates as unknowns.

A curve that crosses the seam of a closed surface is joined there: both ends are solutions of the same equations, so
they are the same point when no others come into question.

The surfaces may touch: points where they do so alone, or where two curves cross, are singular points, if they lie
neither on an edge, a seam or a break nor have a degenerate quadratic part. Contact curves are found where one surface
is implicit and the equation has a repeated factor, on each piece of the other surface; of two implicit surfaces, where
a pair of polynomials with the same common zeros that are regular is found, or two of them; and of two parametric
surfaces, where an equation of one of them, of degree four at most, has a repeated factor on the other one (see the
manual). `Intersection_curve::kind()` tells them from others. Other contacts are undecided, and so are pieces of surface
that coincide; two parametric surfaces that do, as they are the same map but for an affine change of parameters or have
an inner point and an equation of degree four at most in common, are told at once, all undecided for the reason "the
surfaces overlap". Where both are parametric planes, spheres, cylinders, cones or tori but for rounding, and no limit
of time or nodes is given, a run that does not come to an end after a counted amount of work, more than it takes any of
these to cross, leaves the rest undecided for a reason such as "rounded cylinder and torus; heal with a tolerance": see
`with_exact_primitives()`. Limits in the options take its place. A curve along an edge, a seam or a break is found where
one equation says so, as it does of a parametric surface and an implicit one or one with an equation, where it is on an
edge of both if the planes of the edge separate them, and along contacts of two parametric ones that both have an
equation.

A curve goes on through a pole, an edge of a surface that is one point, if the surface has a tangent plane there and two
branches end in it in opposite directions. A pole that lies on the other surface is a singular point otherwise, such as
the apex of a cone, where it lies on no other edge; none, one or many branches end there. Of two parametric surfaces
this is found, as a rule, if the one that a pole lies on has an equation of degree four at most, and no seam or pole
there; else what is near the pole is undecided.

\tparam A,B models of `ParametricSurface_3`, objects of CGAL with a conversion to one of these, `CGAL::Plane_3`,
`CGAL::Sphere_3`, or `Implicit_surface_3`, not both `CGAL::Plane_3`. Both have the same kernel, which is that of the
result; `Implicit_surface_3` goes with any, two of them have results in
        `CGAL::Simple_cartesian<double>`.
\param a the first surface.
\param b the second surface.
\param options those of `solve_curves()`.
\throws Invalid_input when a coordinate is not finite, an object of CGAL is degenerate, a weight is not proved to have
one sign, the boxes of two implicit surfaces have no more than a face in common, or an option makes no sense.

Complexity: that of `solve_curves()`; of splines with many pieces only those whose bounds meet are looked at. The
implicit equation of a surface, if it is needed, costs the exact solution of 35 linear equations at most.

Source: \cgalCite{p-cgl-03}.
*/
template <class A, class B>
requires internal::Intersections::Surface_pair<A, B>
    Surface_intersection<internal::Intersections::Common_surface_kernel<A, B>>
    intersection_curves(const A& a, const B& b, const Solver_options& options = {.tolerance = 1e-8})
{
  return Surface_intersection<internal::Intersections::Common_surface_kernel<A, B>>(
      internal::Intersections::intersection_of(internal::Intersections::surface_shape(a),
                                               internal::Intersections::surface_shape(b), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTION_CURVES_H
