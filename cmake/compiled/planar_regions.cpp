// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is computed of all curves of a drawing together: regions, hulls, sums, what is seen, Voronoi diagrams, medial axes,
// trimmed bisectors, sectors and offsets. What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/hull_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_model_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/region_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/kernel_of_region.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/sight_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/traced_diagrams.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/traced_sectors.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/traced_offsets.h>

namespace CGAL::Spline_constraints::internal::Voronoi {

CGAL_SPLINE_CONSTRAINTS_DIAGRAMS(, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_SECTORS(, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_OFFSETS(, CGAL::Sequential_tag)
#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED_WITH_TBB
CGAL_SPLINE_CONSTRAINTS_DIAGRAMS(, CGAL::Parallel_tag)
CGAL_SPLINE_CONSTRAINTS_SECTORS(, CGAL::Parallel_tag)
CGAL_SPLINE_CONSTRAINTS_OFFSETS(, CGAL::Parallel_tag)
#endif

} // namespace CGAL::Spline_constraints::internal::Voronoi
