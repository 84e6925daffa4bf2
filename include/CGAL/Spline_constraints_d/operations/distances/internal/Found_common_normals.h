// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_COMMON_NORMALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_COMMON_NORMALS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

struct Found_common_normals
{
  std::vector<Located_distance<3>> pairs = {};
  std::vector<Undecided_part> undecided = {};
  Summary summary = {};
};

// Defined in Common_normal_finder.h.
Found_common_normals common_normals_of(const Exact_map<3>& first, const Exact_map<3>& second,
                                       const Solver_options& options);

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_COMMON_NORMALS_H
