// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_CONTACT_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_CONTACT_POINTS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/intersections_at.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

the points where two surfaces touch: \f$A(u,v) = B(s,t)\f$ with parallel normals, five equations
\f[ A - B = 0, \qquad \langle A_u, B_s \times B_t\rangle = \langle A_v, B_s \times B_t\rangle = 0. \f]

Each is a `TANGENT` point, once for each pair of parameters, with a seam as for `intersections()`; an `OVERLAP` is a
curve or region of contacts, reported for each pair of polynomial pieces. On a crease, where the tangents of a surface
jump, the contacts of the pieces on both sides count. `Intersection::is_at_end()` tells of poles only,
`Intersection::multiplicity()` is that of the solution of the equations, 1 where the difference of the surfaces over the
common tangent plane has a regular Hessian matrix, in an extreme or a saddle.

A pole touches a surface if the tangents of all directions there are in one plane, and this is the tangent plane. The
apex of a cone has none.

Contacts with a plane are decided by exact signs, also at irrational parameters. Where both surfaces end at a common
edge, with proportional parameters, and lead away from it to different sides, the contacts are those of the edge,
decided as in one unknown; all of it is an `OVERLAP` if the surfaces go on smoothly. Between polynomial pieces that are
linear in a parameter each, and whose lines are not parallel, they are decided as in two unknowns. Other contacts of
curved surfaces at irrational parameters are beyond the bounds that this takes: they stay `UNDECIDED`, with the reason
`OVERDETERMINED`; so is what is near a pole that lies on the other surface, and curves of contacts elsewhere.

\tparam A,B models of `ParametricSurface_3`, or `CGAL::Sphere_3`, `CGAL::Triangle_3`, or one of them `CGAL::Plane_3`, of
the same kernel. Points of the result are those of `A`.
\param a the first surface.
\param b the second surface.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, an object of CGAL is degenerate, a weight is not proved to have
one sign, or an option makes no sense.

Complexity: for each pair of polynomial pieces whose boxes meet, that of a system of five equations in four unknowns, or
of three in two if a surface is a planar parallelogram.
*/
template <class A, class B>
  requires internal::Common::Surface_operands<A, B>
auto contact_points(const A& a, const B& b, const Solver_options& options = {})
{
  using Kernel = typename internal::Common::Intersection_operand<A>::Kernel;
  internal::Common::Budgeted_solver solve(options);
  const auto pair = internal::Common::patch_pair(a, b);
  if (!pair)
    return Intersections<Kernel, 3>();
  std::vector<internal::Common::Common_point> points = internal::Intersections::contacts_of_surfaces(*pair, solve);
  return internal::Intersections::intersections_at<Kernel, 3>(std::move(points), *pair, solve.total());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_CONTACT_POINTS_H
