// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_VISIBLE_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_VISIBLE_REGIONS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Access.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/access_regions.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_by_zeros.h>
#endif

#include <CGAL/Point_3.h>
#include <CGAL/Sphere_3.h>
#include <CGAL/Vector_3.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

the parts of a surface that are seen from a point, past balls and past the surface itself: where the segment from
\f$S(u,v)\f$ to the eye \f$p\f$ has no other point of the surface and none of the balls in it. Both sides of the surface
are seen; of one that encloses a solid only the outer one is, from outside. Labels are values of `Access` as numbers,
`FREE` and `OBSTRUCTED`.

The regions are bounded by silhouettes, shadows of edges, and the curves of `accessible_regions()` with \f$O = p - S\f$.
On a plane or quadric without folds, with edges in planes, as spheres, cylinders, cones and ellipsoids and parts of them
are, a ray has one other point of the surface at most, and the curves are zeros of polynomials. On all other surfaces,
cells are cut as past the surfaces of `Tool_obstacles_3`; there a silhouette may end at an edge. A small cell is
undecided where a silhouette passes a pole or a crease, where the end of one casts a shadow on a part of the surface far
from it, where shadows touch, and next to an edge all of whose rays are in its plane; and all of the surface if a ball
has an irrational radius or the eye in it.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param eye the point.
\param spheres the balls.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when a sphere is degenerate, a coordinate is not finite, a weight is not proved to have one sign,
or an option makes no sense.

Complexity: that of `accessible_regions()`, and for each face that of the intersection of a point and the surface.
Source: \cgalCite{kes-gcps-05} (visibility), \cgalCite{ek-gcs-01}, section 3.5.
*/
template <internal::Surface_curves::Surface_operand Surface>
Trimmed_surface_3
visible_regions(const Surface& surface, const CGAL::Point_3<internal::Surface_curves::Operand_kernel<Surface>>& eye,
                const std::vector<CGAL::Sphere_3<internal::Surface_curves::Operand_kernel<Surface>>>& spheres = {},
                const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_regions;
  return ray_regions(internal::Common::Intersection_operand<Surface>::map(surface),
                     {exact_spheres(spheres, "visible_regions")},
                     {{}, internal::Surface_curves::exact_triple(eye), true}, options);
}

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions
the same from a point at infinity in a direction.
\param surface,spheres,options as above.
\param direction to the eye, of any length.
\throws Invalid_input as above, and when the direction is zero.
*/
template <internal::Surface_curves::Surface_operand Surface>
Trimmed_surface_3
visible_regions(const Surface& surface,
                const CGAL::Vector_3<internal::Surface_curves::Operand_kernel<Surface>>& direction,
                const std::vector<CGAL::Sphere_3<internal::Surface_curves::Operand_kernel<Surface>>>& spheres = {},
                const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_regions;
  const Exact_triple exact = internal::Surface_curves::exact_triple(direction);
  if (exact[0] == 0 && exact[1] == 0 && exact[2] == 0)
    throw Invalid_input("visible_regions: the direction is zero");
  return ray_regions(internal::Common::Intersection_operand<Surface>::map(surface),
                     {exact_spheres(spheres, "visible_regions")}, Sight{{exact, {}, {}}, {}, true}, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_VISIBLE_REGIONS_H
