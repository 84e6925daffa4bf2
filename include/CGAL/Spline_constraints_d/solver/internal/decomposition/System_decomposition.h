// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_SYSTEM_DECOMPOSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_SYSTEM_DECOMPOSITION_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// An unknown that an equality gives as an affine function of others.
struct Eliminated_unknown
{
  int unknown;
  Exact_rational constant;
  std::vector<std::pair<int, Exact_rational>> slopes; // of unknowns that are not eliminated
};

// The range of an eliminated unknown for the points of a box.
inline Constraint_system_d::Domain range_of(const Eliminated_unknown& eliminated,
                                            const std::vector<Constraint_system_d::Domain>& box)
{
  Constraint_system_d::Domain result(eliminated.constant, eliminated.constant);
  for (const auto& [unknown, slope] : eliminated.slopes) {
    const auto& [lower, upper] = box[unknown];
    result.first += slope * (CGAL::is_negative(slope) ? upper : lower);
    result.second += slope * (CGAL::is_negative(slope) ? lower : upper);
  }
  return result;
}

// A system of some of the unknowns.
struct System_part
{
  Constraint_system_d system;
  std::vector<int> unknowns; // of the whole system, for each unknown of the part
};

/*
Systems without common unknowns, whose solutions in all combinations, with the eliminated unknowns, are those of the
system that was decomposed; without parts, the system is left as it is.
*/
struct System_decomposition
{
  std::vector<System_part> parts;
  std::vector<Eliminated_unknown> eliminated;
  bool is_without_solutions = false; // which is proved
};

// `check` is called between steps of some microseconds, and ends the work where it throws. Defined in
// decomposition_of.h.
System_decomposition decomposition_of(const Constraint_system_d& system, const std::function<void()>& check = {});

/*
For systems with `freedom` equalities less than unknowns, one or more: one part with all unknowns that are left, and the
eliminated ones, whose values may lie outside of their domains; nothing where there is none to eliminate.
*/
System_decomposition elimination_of(const Constraint_system_d& system, std::size_t freedom,
                                    const std::function<void()>& check = {});

// Whether a box is proved to hold a solution, for a `CLUSTER`, or exactly one, for a `CERTIFIED` answer, by those of
// the parts of the system; defined in proof_by_parts.h.
bool is_solution_proved_by_parts(const Constraint_system_d& system, Solution_kind kind,
                                 const std::vector<Constraint_system_d::Domain>& box);

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_SYSTEM_DECOMPOSITION_H
