// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_PROOF_BY_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_PROOF_BY_PARTS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Exact_box.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The box of each part holds a solution of it, and the values that these give to eliminated unknowns lie in the box.
CGAL_SPLINE_CONSTRAINTS_INLINE bool is_solution_proved_by_parts(const Constraint_system_d& system, Solution_kind kind,
                                                                const Exact_box& box)
{
  const System_decomposition decomposition = decomposition_of(system);
  const auto is_in_box = [&](const Eliminated_unknown& eliminated) {
    const auto range = range_of(eliminated, box), domain = system.domain(eliminated.unknown);
    const auto& own = box[eliminated.unknown];
    return own.first <= (std::max)(range.first, domain.first) && (std::min)(range.second, domain.second) <= own.second;
  };
  const auto is_solved = [&](const System_part& part) {
    Exact_box of_part;
    for (const int unknown : part.unknowns)
      of_part.push_back(box[unknown]);
    return verification::is_proved(part.system, Solution_kind::CERTIFIED, of_part, {}) ||
        (kind == Solution_kind::CLUSTER && verification::is_proved(part.system, Solution_kind::CLUSTER, of_part, {}));
  };
  return !decomposition.parts.empty() &&
      std::all_of(decomposition.eliminated.begin(), decomposition.eliminated.end(), is_in_box) &&
      std::all_of(decomposition.parts.begin(), decomposition.parts.end(), is_solved);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_PROOF_BY_PARTS_H
