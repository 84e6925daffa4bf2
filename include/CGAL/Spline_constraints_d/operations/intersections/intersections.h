// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/elementary_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/intersections_at.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// By exact patches of both operands.
template <SplineKernel Kernel, int d, class A, class B>
Spline_constraints::Intersections<Kernel, d> general_intersections(const A& a, const B& b, Budgeted_solver solve,
                                                                   const Known_solutions& known = std::nullopt)
{
  const auto pair = patch_pair(a, b);
  if (!pair)
    return {};
  std::vector<Common_point> points = common_points<d>(*pair, solve, known);
  return intersections_at<Kernel, d>(std::move(points), *pair, solve.total());
}

} // namespace Intersections
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDIntersections

all common points of two operands, each a point, a curve or a surface: the solutions of \f$A(u) = B(v)\f$, in the plane
for points and curves, in space also for a point or curve with a surface. Two surfaces have curves in common, see
`intersection_curves()`; where they touch in points, `contact_points()` finds these.

A common point is reported once for each pair of parameters: where an operand crosses itself, there are several. On the
seam of a closed operand, where two parameters stand for one point, it is the lower one. At a pole of a surface, an edge
that is one point, a whole range stands for it, which is one answer. A point on a knot is found once.

Operands are taken exactly (doubles are rational numbers), and so are all decisions. Whether a common point is at an end
of a parameter is a system with one unknown less; the solver finds all of its solutions where the first one has just
one. Systems with more equations than unknowns, as of two curves in space, are decided by exact signs: operands that
miss each other by however little do not meet. If the points of an operand are affine in its parameters, as those of a
point, segment or parallelogram, these are eliminated.

In kernels of floating point numbers, closed forms come first: for points, lines, rays, segments, circles, spheres,
planes, triangles, and the cylinders, cones and frusta of `surface_of_revolution()`, each two that meet in points, and
for polynomial curves with each of these. Intervals of doubles decide, and rational numbers only the signs that these
leave open; no operand is converted. Answers have ranges of doubles then and no `solution()`. A circle or sphere is the
one of its center and squared radius as these are stored, with the parameters that its conversion would have without
rounding. Other pairs of polynomial curves, in the plane, and of a polynomial curve and surface, in one piece each are
solved as they are: where all solutions are regular and none is next to an end that is not common to both curves,
nothing more is done. What is not decided so is left to exact splines, as described here.

An `OVERLAP` is proved for curves in the plane, for polynomial curves \f$C(t) = D(at + b)\f$ in one piece each, also in
space, whose control polygons run forward in one direction, for a line or segment that lies in a surface, for a curve in
a planar parallelogram, and for a curve \f$C(t) = S(q(t))\f$ on a surface, where \f$q\f$ is a polynomial of degree three
at most that meets breaks and edges of the surface at rational parameters, and for a curve and a surface on the same
sphere; other parameters of the surface for the same points are not looked for. Its parameter ranges are exact where the
solver finds a segment or an interval with rational ends, and for linear \f$q\f$; for others, that on the curve is.
Otherwise they are enclosures, those of a surface on a sphere its domain. Other curves in space that lie in a surface
are `UNDECIDED`. An end of an overlap of curves that is found again, as a corner of another piece or on a seam, is not
reported again, unless the operands touch there and are in space or of degree higher than four.

Curves that nearly coincide take no more work the nearer they are, but for the lengths of numbers. Where the solver has
not decided two curves within 500 nodes, and 100 for each two pieces whose control polygons have meeting boxes, one
parameter is eliminated exactly for each two pieces (Sederberg, Anderson, Goldman 1984), if one of them has degree six
at most and the product of their degrees is at most 36: all roots of one polynomial are isolated, and the kernel of the
Bezout matrix tells the other parameter. This gives all common points, with their kinds and multiplicities, those of
curves in space that touch at irrational parameters included; they have no `solution()`. Two pieces on one algebraic
curve are left to the solver alone, and overlaps that go on over breaks are joined. Where degrees are higher, or both
curves cross themselves in one common point, the solver goes on. What it leaves undecided of planar curves of degree
four at most is then looked at box by box: a point so found at a break is a `TANGENT` point without a multiplicity.

Of planar curves, `Intersection::passage()` tells whether they cross or touch, at corners too: by the tangents on both
sides, or where two of these have one direction, by the curvatures and higher derivatives. A corner that both have
counts once, and is `TRANSVERSAL`, where each two pieces meet there with multiplicity one and the curves cross, and a
`TANGENT` point without a multiplicity where they touch.

A line, ray or plane is cut by a box around the other operand, beyond all common points. The parameter \f$t\f$ of a ray
stands for the point \f$p + t\,(q - p)\f$ with its source \f$p\f$ and `second_point()` \f$q\f$, that of a line for \f$p
+ t\,d\f$ with \f$d\f$ its `to_vector()` and \f$p\f$ its `point()` in space, the point next to the origin in the plane.
Other objects of CGAL have the parameters that `to_bspline_surface()` gives them, or, where it does not know them,
`to_bspline_curve()`.

\tparam A,B `CGAL::Point_2`, `CGAL::Point_3`, models of `ParametricCurve_2`, `ParametricCurve_3` or
`ParametricSurface_3`, objects of CGAL with a conversion to one of these (segments, circles, triangles, spheres and
others), or one of them `CGAL::Line_2`, `CGAL::Line_3`, `CGAL::Ray_2`, `CGAL::Ray_3` or `CGAL::Plane_3`. Both have the
same kernel and are in the same dimension. Points of the result are those of `A`.
\param a the first operand.
\param b the second operand.
\param options those of the solver; limits hold for the operation as a whole, and a tolerance concerns only what remains
undecided.
\throws Invalid_input when a coordinate is not finite, an object of CGAL is degenerate, a weight is not proved to have
one sign, or an option makes no sense.

Complexity: that of closed forms is constant, or for a curve of degree \f$n\f$, for each piece, that of isolating the
roots of a polynomial of degree \f$n\f$ or \f$2n\f$. Otherwise that of a system in as many unknowns as the operands have
parameters that are not eliminated; and of one with an unknown less for each solution at an end. For two pieces of
curves of degrees \f$m\f$ and \f$n \le m\f$, elimination takes \f$n 2^n\f$ products of polynomials in one parameter, and
isolates the roots of one of degree \f$mn\f$. Source: \cgalCite{ek-gcs-01}, section 2.
*/
template <class A, class B>
  requires internal::Common::Intersection_operands<A, B>
Intersections<typename internal::Common::Intersection_operand<A>::Kernel,
              internal::Common::Intersection_operand<A>::dimension>
intersections(const A& a, const B& b, const Solver_options& options = {})
{
  using Operand = internal::Common::Intersection_operand<A>;
  constexpr int d = Operand::dimension;
  using Kernel = typename Operand::Kernel;
  using namespace internal::Intersections;
  if constexpr (!std::is_floating_point_v<typename Kernel::FT>)
    return general_intersections<Kernel, d>(a, b, Budgeted_solver(options));
  else {
    const auto first = elementary_operand<d>(a), second = elementary_operand<d>(b);
    if (auto found = elementary_intersections<Kernel>(first, second, options))
      return std::move(*found);
    Budgeted_solver solve(options);
    Regular_points<d> regular = regular_points(first, second, solve);
    if (regular.points)
      return intersections_at<Kernel>(std::move(*regular.points), solve.total());
    return general_intersections<Kernel, d>(a, b, std::move(solve), regular.solutions);
  }
}

/*!
\ingroup PkgSplineConstraintsDIntersections

the same, written to an output iterator, one after the other: also those that are undecided.
\param a,b,options as above.
\param output takes objects of type `Intersection` with the kernel and dimension of the operands.
\returns the output iterator behind the last one.
\throws Invalid_input as the function above.
*/
template <class A, class B, class Output>
requires internal::Common::Intersection_operands<A, B> &&
    std::output_iterator<Output,
                         Intersection<typename internal::Common::Intersection_operand<A>::Kernel,
                                      internal::Common::Intersection_operand<A>::dimension>>
        Output intersections(const A& a, const B& b, Output output, const Solver_options& options = {})
{
  const auto found = intersections(a, b, options);
  return std::copy(found.begin(), found.end(), output);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERSECTIONS_H
