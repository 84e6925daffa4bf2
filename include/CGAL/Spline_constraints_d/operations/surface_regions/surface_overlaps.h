// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_OVERLAPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_OVERLAPS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Surface_overlap_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/overlap_declarations.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Overlap_finder.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_by_zeros.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

the regions in which two surfaces coincide, on both of them. `intersection_curves()` tells that there are some.

Polynomial pieces on a plane, quadric or another surface of degree four at most coincide with others that satisfy the
same equation, between the edges of both: these are pulled back by polynomials that vanish on them, and one point of
each face is decided by exact arithmetic. Others are compared as maps: where one is the other one with parameters that
are changed by a linear function each, or exchanged, as parts of one spline are, the region is a rectangle. What else
such pieces may have in common is undecided, if their boxes meet.

\param a,b models of `ParametricSurface_3`, or objects of CGAL that are converted to one.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: for each piece the linear equations of an implicit polynomial, of degree four at most, and of those of the
edges on it; then as for `accessible_regions()`. Source: \cgalCite{pm-sicad-02} (overlaps).
*/
template <internal::Surface_curves::Surface_operand A, internal::Surface_curves::Surface_operand B>
Surface_overlap_3 surface_overlap(const A& a, const B& b, const Solver_options& options = {.tolerance = 1e-8})
{
  return Surface_overlap_3(internal::Surface_regions::overlap_of(
      internal::Common::Intersection_operand<A>::map(a), internal::Common::Intersection_operand<B>::map(b), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_OVERLAPS_H
