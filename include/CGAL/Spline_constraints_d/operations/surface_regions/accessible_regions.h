// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_ACCESSIBLE_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_ACCESSIBLE_REGIONS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Access.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/access_regions.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_by_zeros.h>
#endif

#include <CGAL/Sphere_3.h>
#include <CGAL/Triangle_3.h>

#include <ranges>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

What may be in the way of a tool.
*/
template <SplineKernel Kernel>
struct Tool_obstacles_3
{
  std::vector<CGAL::Sphere_3<Kernel>> balls{};       ///< balls
  std::vector<CGAL::Triangle_3<Kernel>> triangles{}; ///< triangles, as the faces of a polyhedron
  std::vector<Bspline_surface_3<Kernel>> surfaces{}; ///< surfaces
};

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

the parts of a surface that a straight tool, as in 5-axis milling, reaches past balls: where the ray from
\f$S(u,v)\f$ along the axis \f$O(u,v)\f$ of the tool has no point in one of the balls, and \f$\langle O, V\rangle > 0\f$
if the directions are limited to a hemisphere around \f$V\f$. Labels are values of `Access` as numbers.

The regions are bounded by the zeros of \f$|(c-S) \times O|^2 - r^2 |O|^2\f$, where the line of the tool touches a ball,
of \f$|S-c|^2 - r^2\f$, and of \f$\langle O, V\rangle\f$, with their topology by proof. In each face one ray is decided
by exact arithmetic; faces with the same label are united, so that lines which touch a ball behind the surface bound
nothing. The axis is the direction, the field, or the normal \f$S_u \times S_v\f$ of the surface in its lowest degree,
so that poles are no exception. Where a singular point of the curves is not proved, a small cell is undecided.

The radius of a thick tool, a cylinder with a half-ball at its end, is added to those of the balls.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param spheres a range of `CGAL::Sphere_3` of the kernel of the surface.
\param axis the directions of the tool.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input as `accessibility_boundaries()`; the message names the sphere.

Complexity: that of `solve_curves()` with one equation in two unknowns, for each curve and each polynomial piece of the
surface, or part of it that curves are told apart in; and of two equations for each two of them in one part. Source:
\cgalCite{ek-gcs-01}, section 3.5; regions, for curves there.
*/
template <internal::Surface_curves::Surface_operand Surface, std::ranges::input_range Spheres>
Trimmed_surface_3 accessible_regions(const Surface& surface, const Spheres& spheres,
                                     const Tool_axis<internal::Surface_curves::Operand_kernel<Surface>>& axis = {},
                                     const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_regions;
  return ray_regions(internal::Common::Intersection_operand<Surface>::map(surface),
                     {exact_spheres(spheres, "accessible_regions")},
                     {internal::Surface_curves::exact_tool_axis(axis), {}, false}, options);
}

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

the same past triangles as well, as those of a mesh: with the radius \f$r\f$ of the tool, around vertices \f$V\f$,
edges from these along \f$e\f$, and planes with normals \f$n\f$ there are spheres, pipes and offset planes,
\f[ |(V-S) \times O|^2 = r^2 |O|^2, \; |V-S|^2 = r^2, \; \langle V-S, O \times e\rangle^2 = r^2 |O \times e|^2, \;
|(V-S) \times e|^2 = r^2 |e|^2, \; \langle V-S, n\rangle^2 = r^2 |n|^2, \f]
and faces are decided by the distances of one ray, exactly. Where such curves would touch, as those around an edge and
its end do, the outer one has a radius that is greater by 1/256, so that they cross: what is free is free of all that is
within \f$r\f$ of the ray, and what is not has something within \f$r\,(1 + 1/128)\f$. A thin tool has the exact
regions.

Surfaces are in the way of a thin tool, which is a line, in all directions. Then the regions are bounded by contours of
the surfaces along the axis, by their edges, and by curves where they meet the source. Cells of the domain are cut until
rays meet a surface from all of a cell or from none of it, or can only come to meet one along a direction, so that there
is one arc; no curve is solved for. Where a contour ends at an edge or passes a pole, and where surfaces touch, a small
cell is undecided. With a radius, a surface is given by triangles next to it: if they are within
\f$\varepsilon\f$, a tool with the radius \f$r + \varepsilon\f$ tells what is certainly reached.

\param surface,axis,options as above.
\param obstacles the balls, triangles and surfaces, which need not fit together. Surfaces come without a radius of the
tool, a hemisphere, triangles, or balls with an irrational radius; otherwise all is undecided.
\throws Invalid_input also when a triangle is degenerate.

Complexity: as above, with two curves for each vertex and edge, and one for each plane; past surfaces, cells in
proportion to the length of boundaries, in each of which points are located by bisection.
*/
template <internal::Surface_curves::Surface_operand Surface>
Trimmed_surface_3
accessible_regions(const Surface& surface,
                   const Tool_obstacles_3<internal::Surface_curves::Operand_kernel<Surface>>& obstacles,
                   const Tool_axis<internal::Surface_curves::Operand_kernel<Surface>>& axis = {},
                   const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_regions;
  const std::string operation = "accessible_regions";
  return ray_regions(internal::Common::Intersection_operand<Surface>::map(surface),
                     {exact_spheres(obstacles.balls, operation), exact_triangles(obstacles.triangles, operation),
                      exact_surfaces(obstacles.surfaces)},
                     {internal::Surface_curves::exact_tool_axis(axis), {}, false}, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_ACCESSIBLE_REGIONS_H
