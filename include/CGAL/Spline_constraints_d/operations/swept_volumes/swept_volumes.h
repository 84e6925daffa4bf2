// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_SWEPT_VOLUMES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_SWEPT_VOLUMES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/Swept_volume_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/swept_volume_finders.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/sweep_envelopes.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/swept_volume_of.h>
#endif

#include <array>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

template <class Range>
concept Range_of_surfaces =
    std::ranges::input_range<Range> && Surface_curves::Surface_operand<std::ranges::range_value_t<Range>>;

template <Range_of_surfaces Surfaces>
std::vector<Common::Exact_map<3>> maps_of(const Surfaces& surfaces)
{
  std::vector<Common::Exact_map<3>> result;
  for (const auto& surface : surfaces)
    result.push_back(Common::Intersection_operand<std::ranges::range_value_t<Surfaces>>::map(surface));
  return result;
}

} // namespace Swept_volumes
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSweptVolumes

the boundary of what a solid sweeps that moves by a rational motion, as a closed mesh. The solid is what a closed
surface bounds, whose edges are poles or seams, such as a sphere, a torus, or a surface of revolution that ends on its
axis; it may have creases.

The envelope of the moving surface, and its first and last position where they bound, are triangulated; the triangles
share the points of common edges. They cut space into cells, which are found with exact numbers. Of each cell one point
is tested with `sweep_intervals()`, by proof; the boundary is that of all cells that are swept. So it is the exact
boundary of what the triangulated surfaces bound, and every cell that is deeper than the chord error was decided
on the exact surfaces. What it bounds may differ from the truth by cells that are thinner, and by this error.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param motion the motion.
\param fineness how fine the triangles are, in space.
\param options the limits, for the operation as a whole, and a visitor.
\throws Invalid_input when the surface has an edge that is neither a seam nor a pole, it is not proved that the maps of
the motion are invertible at all times, a coordinate is not finite, a weight is not proved to
have one sign, or an option makes no sense.

Complexity: that of `sweep_envelope()`; for `t` triangles of which `k` pairs meet \f$O(t \log^3 t + k \log k)\f$; and a
system of three equations for each cell.
Sources: \cgalCite{kes-gcps-05}, section 5; membership by the path of a point seen from the moving solid.
*/
template <internal::Surface_curves::Surface_operand Surface>
Swept_volume_3 swept_volume(const Surface& surface, const Rational_motion_3& motion,
                            const Surface_mesh_options& fineness = {},
                            const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Swept_volumes::swept_volume_of({internal::Common::Intersection_operand<Surface>::map(surface)},
                                                  motion, fineness, options);
}

/*!
\ingroup PkgSplineConstraintsDSweptVolumes

the boundary of what a solid sweeps that several surfaces bound, with edges and corners. Each edge of a surface is a
pole, or the same curve as exactly one other edge, with the same parameter or one that is an affine function of it; that
may be an edge of the same surface, as a seam is. The normals \f$S_u \times S_v\f$ of surfaces with a common edge
point to the same side of the solid. Surfaces may bound several connected parts, and cavities; they do not cross each
other.

To the envelopes of all surfaces, and to their first and last positions, comes what edges sweep while the surface moves
inwards on one side of them alone; corners sweep boundaries of this. Edges with one tangent plane sweep nothing.

\param surfaces a range of models of `ParametricSurface_3`, or of objects of CGAL that are converted to one.
\param motion the motion.
\param fineness how fine the triangles are, in space.
\param options the limits, for the operation as a whole, and a visitor.
\throws Invalid_input when there is no surface, an edge is neither a pole nor the same as exactly one other one, normals
of two surfaces point to different sides, and as above.
*/
template <internal::Swept_volumes::Range_of_surfaces Surfaces>
Swept_volume_3 swept_volume(const Surfaces& surfaces, const Rational_motion_3& motion,
                            const Surface_mesh_options& fineness = {},
                            const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Swept_volumes::swept_volume_of(internal::Swept_volumes::maps_of(surfaces), motion, fineness,
                                                  options);
}

/*!
\ingroup PkgSplineConstraintsDSweptVolumes

when a point lies in a moving solid: the intervals of time, in order. That there are so many is proved; their ends are
the middles of enclosures. The index of the point is the number of intervals; it is swept if there is one.

\param surface the boundary of the solid, as for `swept_volume()`.
\param motion the motion.
\param point the point.
\param options the limits, for the operation as a whole, and a visitor.
\return the intervals, or nothing where they were not decided: the point is on the envelope, or a limit was reached.
\throws Invalid_input as `swept_volume()` does.

Complexity: that of `solve()` for two systems of three equations.
*/
template <internal::Surface_curves::Surface_operand Surface, SplineKernel K>
std::optional<std::vector<std::pair<Exact_rational, Exact_rational>>>
sweep_intervals(const Surface& surface, const Rational_motion_3& motion, const CGAL::Point_3<K>& point,
                const Solver_options& options = {.tolerance = 1e-8})
{
  const auto exact = internal::exact_object(point);
  return internal::Swept_volumes::sweep_intervals_of({internal::Common::Intersection_operand<Surface>::map(surface)},
                                                     motion, {exact.x(), exact.y(), exact.z()}, options);
}

/*!
\ingroup PkgSplineConstraintsDSweptVolumes

the same for a solid whose boundary consists of several surfaces, as `swept_volume()` takes them.
*/
template <internal::Swept_volumes::Range_of_surfaces Surfaces, SplineKernel K>
std::optional<std::vector<std::pair<Exact_rational, Exact_rational>>>
sweep_intervals(const Surfaces& surfaces, const Rational_motion_3& motion, const CGAL::Point_3<K>& point,
                const Solver_options& options = {.tolerance = 1e-8})
{
  const auto exact = internal::exact_object(point);
  return internal::Swept_volumes::sweep_intervals_of(internal::Swept_volumes::maps_of(surfaces), motion,
                                                     {exact.x(), exact.y(), exact.z()}, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_SWEPT_VOLUMES_H
