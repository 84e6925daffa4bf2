// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OVERLAP_DECLARATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OVERLAP_DECLARATIONS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// On both surfaces; defined in Overlap_finder.h.
std::array<Trimmed_surface_3, 2> overlap_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                            const Solver_options& options);

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_OVERLAP_DECLARATIONS_H
