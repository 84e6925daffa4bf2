// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_OF_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_OF_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_search.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Polynomial_conditions = std::vector<std::pair<Power_polynomial, Relation>>;

// The ranges of each unknown between the breaks of all splines.
inline std::vector<Exact_ranges> ranges_between_breaks(const Constraint_system_d& system)
{
  std::vector<std::vector<Exact_rational>> ends;
  for (const auto& [lower, upper] : domain_of(system))
    ends.push_back({lower, upper});
  const auto add_breaks = [&](const Spline_function& function) {
    for (const Spline_term& term : function.terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        for (const Exact_rational& at : term.breaks[j])
          if (std::vector<Exact_rational>& all = ends[term.variables[j]]; all[0] < at && at < all[1])
            all.push_back(at);
  };
  for (const Spline_function& function : system.equalities())
    add_breaks(function);
  for (const auto& inequality : system.inequalities())
    add_breaks(inequality.function);
  std::vector<Exact_ranges> result;
  for (std::vector<Exact_rational>& all : ends) {
    Exact_ranges& ranges = result.emplace_back();
    if (all[0] == all[1]) {
      ranges.emplace_back(all[0], all[1]);
      continue;
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::size_t k = 0; k + 1 < all.size(); ++k)
      ranges.emplace_back(all[k], all[k + 1]);
  }
  return result;
}

// f <= 0 and -c f <= 0 with c > 0 are together f = 0. Of each condition that is left: the two that it stands for, by
// their indices.
struct Merged_conditions
{
  Polynomial_conditions conditions;
  std::vector<std::pair<std::size_t, std::size_t>> origins;
};

inline Merged_conditions merged(const Polynomial_conditions& conditions, std::size_t dimension)
{
  Merged_conditions result;
  std::size_t equalities = 0;
  std::vector<Power_polynomial> normal;
  for (const auto& [function, relation] : conditions) {
    const bool is_upper = relation == Relation::GREATER || relation == Relation::GREATER_EQUAL;
    normal.push_back(with_unit_coefficient(is_upper ? -function : function));
    equalities += relation == Relation::EQUAL;
  }
  const auto is_closed = [&](std::size_t i) {
    return conditions[i].second == Relation::LESS_EQUAL || conditions[i].second == Relation::GREATER_EQUAL;
  };
  std::vector<bool> is_done(conditions.size(), false);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (is_done[i])
      continue;
    std::size_t opposite = i;
    for (std::size_t k = i + 1; k < conditions.size() && opposite == i && equalities + 1 < dimension; ++k)
      if (is_closed(i) && is_closed(k) && !is_done[k] && !normal[i].is_zero() && normal[k] == -normal[i])
        opposite = k;
    result.conditions.push_back(conditions[i]);
    result.origins.emplace_back(i, opposite);
    if (opposite != i) {
      is_done[opposite] = true;
      result.conditions.back() = {normal[i], Relation::EQUAL};
      ++equalities;
    }
  }
  return result;
}

/*
Whether the constraints of a system and polynomials compared with zero can be satisfied, a cell of the splines at a
time.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE Feasibility_d feasibility_of(const Constraint_system_d& system,
                                                            const Polynomial_conditions& polynomials,
                                                            const Solver_options& options)
{
  const std::size_t n = static_cast<std::size_t>(system.dimension());
  std::size_t equalities = system.equalities().size();
  for (const auto& [function, relation] : polynomials) {
    for (const int v : function.variables())
      if (v >= system.dimension())
        throw Invalid_input("Feasibility_solver_d: unknown " + std::to_string(v) + " of a constraint has no range");
    equalities += relation == Relation::EQUAL;
  }
  if (equalities >= n)
    throw Invalid_input("Feasibility_solver_d: " + std::to_string(equalities) + " equalities for " + std::to_string(n) +
                        " unknowns; for all solutions see solve()");
  if (equalities + system.inequalities().size() + polynomials.size() == 0)
    throw Invalid_input("Feasibility_solver_d: no constraint");

  const Upward_rounding_guard guard;
  Run_control control(options);
  Feasibility_run run(options, control);
  Feasibility_outcome outcome{Feasibility::INFEASIBLE, {}, {}, {}};
  const std::vector<Exact_ranges> ranges = ranges_between_breaks(system);
  std::vector<std::size_t> cell(n, 0);
  for (bool is_last = false; !is_last && outcome.status != Feasibility::FEASIBLE;) {
    Exact_ranges box;
    for (std::size_t j = 0; j < n; ++j)
      box.push_back(ranges[j][cell[j]]);
    if (run.must_stop()) {
      outcome.status = Feasibility::UNDECIDED;
      outcome.undecided.push_back({place_of(domain_of(system)), {}, in_words(run.reason())});
      break;
    }
    Polynomial_conditions conditions;
    const Constraint_system_d on_this_cell = on_cell(system, box);
    for (const Spline_function& function : on_this_cell.equalities())
      conditions.emplace_back(*restricted(function, Partial_point(n)), Relation::EQUAL);
    for (const auto& [function, relation] : on_this_cell.inequalities())
      conditions.emplace_back(*restricted(function, Partial_point(n)), relation);
    conditions.insert(conditions.end(), polynomials.begin(), polynomials.end());
    const Merged_conditions fewer = merged(conditions, n);
    Feasibility_problem problem(box);
    for (const auto& [function, relation] : fewer.conditions)
      problem.add(function, relation);
    const std::size_t excluded_before = run.excluded().size();
    Feasibility_outcome part = Feasibility_search(problem, run, true)();
    for (std::size_t k = excluded_before; k < run.excluded().size(); ++k) {
      std::vector<Exact_rational>& multipliers = run.excluded()[k].multipliers;
      std::vector<Exact_rational> original(multipliers.empty() ? 0 : conditions.size(), Exact_rational(0));
      for (std::size_t i = 0; i < multipliers.size(); ++i) {
        const auto& [first, second] = fewer.origins[i];
        if (first == second)
          original[first] = multipliers[i];
        else
          original[CGAL::is_positive(multipliers[i]) ? first : second] = CGAL::abs(multipliers[i]);
      }
      multipliers = std::move(original);
    }
    if (part.status == Feasibility::FEASIBLE)
      outcome = std::move(part);
    else if (part.status == Feasibility::UNDECIDED) {
      outcome.status = Feasibility::UNDECIDED;
      outcome.undecided.insert(outcome.undecided.end(), part.undecided.begin(), part.undecided.end());
    }
    is_last = true;
    for (std::size_t j = n; is_last && j-- > 0;) {
      is_last = cell[j] + 1 == ranges[j].size();
      cell[j] = is_last ? 0 : cell[j] + 1;
    }
  }
  const bool is_complete = outcome.status != Feasibility::UNDECIDED;
  return {outcome.status,
          std::move(outcome.box),
          std::move(outcome.certificate),
          std::move(outcome.undecided),
          std::move(run.excluded()),
          std::move(run.path()),
          run.summary(is_complete)};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_OF_H
