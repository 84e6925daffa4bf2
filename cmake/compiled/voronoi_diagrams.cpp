// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams, medial axes, trimmed bisectors, sectors and offsets, for curves of all kernels.
// The solvers, and what other sources of the library have, are declared alone.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/traced_diagrams.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/traced_sectors.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/traced_offsets.h>

namespace CGAL::Spline_constraints::internal::Voronoi {

CGAL_SPLINE_CONSTRAINTS_DIAGRAMS(, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_SECTORS(, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_OFFSETS(, CGAL::Sequential_tag)

} // namespace CGAL::Spline_constraints::internal::Voronoi
