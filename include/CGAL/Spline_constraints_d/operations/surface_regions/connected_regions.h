// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_CONNECTED_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_CONNECTED_REGIONS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Connected_regions_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Shared_edges_of_cells.h>
#endif

#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace Surface_regions {

// Defined in Shared_edges_of_cells.h; the compiled library has it.
Connected_regions_3 united_regions(const std::vector<Trimmed_surface_3>& surfaces);

} // namespace Surface_regions
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

the regions of several surfaces, united across edges that two of them have in common: where sides of their polynomial
pieces are the same rational curve with the same parameters, or reversed, or one is a part of the other that begins and
ends at multiples of a sixty-fourth of its range. This is decided exactly; edges that agree in other ways, and those
that are closed curves on one piece, are not common ones here.

\param surfaces the surfaces with their regions.

Complexity: quadratic in the number of sides of polynomial pieces, for comparisons of their ends.
*/
inline Connected_regions_3 connected_regions(const std::vector<Trimmed_surface_3>& surfaces)
{
  return internal::Surface_regions::united_regions(surfaces);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_CONNECTED_REGIONS_H
