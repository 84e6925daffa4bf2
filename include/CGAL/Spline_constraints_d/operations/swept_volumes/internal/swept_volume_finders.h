// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_FINDERS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/Swept_volume_3.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Defined in swept_volume_of.h; the compiled library has them.
Swept_volume_3 swept_volume_of(const std::vector<Common::Exact_map<3>>& surfaces, const Rational_motion_3& motion,
                               const Surface_mesh_options& fineness, const Solver_options& options);

std::optional<std::vector<std::pair<Exact_rational, Exact_rational>>>
sweep_intervals_of(const std::vector<Common::Exact_map<3>>& surfaces, const Rational_motion_3& motion,
                   const std::array<Exact_rational, 3>& point, const Solver_options& options);

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEPT_VOLUME_FINDERS_H
