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

// Where a condition comes from: an index, and what its multipliers are to be multiplied by; or two, for those that are
// positive and negative.
struct Condition_origin
{
  std::size_t first, second;
  Exact_rational first_factor{1}, second_factor{1};
};

struct Merged_conditions
{
  Polynomial_conditions conditions;
  std::vector<Condition_origin> origins;
};

inline bool are_opposite(const Power_polynomial& a, const Power_polynomial& b)
{
  return !a.is_zero() && a.terms().size() == b.terms().size() &&
      std::equal(a.terms().begin(), a.terms().end(), b.terms().begin(), [](const auto& own, const auto& other) {
        return own.first == other.first && own.second == -other.second;
      });
}

// f <= 0 and -c f <= 0 with c > 0 are together f = 0, as long as there are fewer equalities than unknowns.
inline Merged_conditions merged(const Polynomial_conditions& conditions, std::size_t dimension, Feasibility_run& run)
{
  Merged_conditions result;
  std::size_t equalities = 0;
  std::vector<Power_polynomial> normal;
  for (const auto& [function, relation] : conditions) {
    run.check();
    const bool is_upper = relation == Relation::GREATER || relation == Relation::GREATER_EQUAL;
    normal.push_back(with_unit_coefficient(is_upper ? -function : function));
    equalities += relation == Relation::EQUAL;
  }
  const auto is_closed = [&](std::size_t i) {
    return conditions[i].second == Relation::LESS_EQUAL || conditions[i].second == Relation::GREATER_EQUAL;
  };
  const auto factor = [&](std::size_t i) {
    return Exact_rational(Exact_rational(1) / CGAL::abs(conditions[i].first.terms().begin()->second));
  };
  std::vector<bool> is_done(conditions.size(), false);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    if (is_done[i])
      continue;
    std::size_t opposite = i;
    for (std::size_t k = i + 1; k < conditions.size() && opposite == i && equalities + 1 < dimension; ++k)
      if (is_closed(i) && is_closed(k) && !is_done[k] && are_opposite(normal[i], normal[k]))
        opposite = k;
    if (opposite == i) {
      result.conditions.push_back(conditions[i]);
      result.origins.push_back({i, i});
      continue;
    }
    is_done[opposite] = true;
    result.conditions.emplace_back(normal[i], Relation::EQUAL);
    result.origins.push_back({i, opposite, factor(i), factor(opposite)});
    ++equalities;
  }
  return result;
}

inline std::vector<Exact_rational> multipliers_of_origins(const std::vector<Exact_rational>& multipliers,
                                                          const Merged_conditions& merged, std::size_t conditions)
{
  std::vector<Exact_rational> result(multipliers.empty() ? 0 : conditions, Exact_rational(0));
  for (std::size_t i = 0; i < multipliers.size(); ++i) {
    const Condition_origin& origin = merged.origins[i];
    if (origin.first == origin.second)
      result[origin.first] = multipliers[i];
    else if (CGAL::is_positive(multipliers[i]))
      result[origin.first] = multipliers[i] * origin.first_factor;
    else
      result[origin.second] = -multipliers[i] * origin.second_factor;
  }
  return result;
}

// The constraints on a box within one cell of the splines as polynomials: equalities, inequalities, polynomials.
inline Polynomial_conditions conditions_on_cell(const Constraint_system_d& system,
                                                const Polynomial_conditions& polynomials, const Exact_ranges& box)
{
  const std::size_t n = box.size();
  Polynomial_conditions result;
  const Constraint_system_d cell = on_cell(system, box);
  for (const Spline_function& function : cell.equalities())
    result.emplace_back(*restricted(function, Partial_point(n)), Relation::EQUAL);
  for (const auto& [function, relation] : cell.inequalities())
    result.emplace_back(*restricted(function, Partial_point(n)), relation);
  result.insert(result.end(), polynomials.begin(), polynomials.end());
  return result;
}

inline Feasibility_outcome outcome_on_cell(const Constraint_system_d& system, const Polynomial_conditions& polynomials,
                                           const Exact_ranges& box, Feasibility_run& run)
try {
  run.check();
  const Polynomial_conditions conditions = conditions_on_cell(system, polynomials, box);
  const Merged_conditions fewer = merged(conditions, box.size(), run);
  Feasibility_problem problem(box);
  for (const auto& [function, relation] : fewer.conditions)
    problem.add(function, relation);
  const std::size_t excluded_before = run.excluded().size();
  Feasibility_outcome result = Feasibility_search(problem, run, true)();
  for (std::size_t k = excluded_before; k < run.excluded().size(); ++k)
    run.excluded()[k].multipliers = multipliers_of_origins(run.excluded()[k].multipliers, fewer, conditions.size());
  return result;
} catch (const Run_stopped& stopped) {
  return {Feasibility::UNDECIDED, {}, {}, {{place_of(box), {}, in_words(stopped.reason)}}};
}

inline void check_constraints(const Constraint_system_d& system, const Polynomial_conditions& polynomials)
{
  const int n = system.dimension();
  int equalities = static_cast<int>(system.equalities().size());
  for (const auto& [function, relation] : polynomials) {
    for (const int v : function.variables())
      if (v >= n)
        throw Invalid_input("Feasibility_solver_d: unknown " + std::to_string(v) + " of a constraint has no range");
    equalities += relation == Relation::EQUAL;
  }
  if (equalities >= n)
    throw Invalid_input("Feasibility_solver_d: " + std::to_string(equalities) + " equalities for " + std::to_string(n) +
                        " unknowns; for all solutions see solve()");
  if (equalities == 0 && system.inequalities().empty() && polynomials.empty())
    throw Invalid_input("Feasibility_solver_d: no constraint");
}

// The next choice of one range for each unknown; false after the last one.
inline bool advance(std::vector<std::size_t>& cell, const std::vector<Exact_ranges>& ranges)
{
  for (std::size_t j = cell.size(); j-- > 0; cell[j] = 0)
    if (++cell[j] < ranges[j].size())
      return true;
  return false;
}

/*
Whether the constraints of a system and polynomials compared with zero can be satisfied, a cell of the splines at a
time. Where the run ends, the cells that are left are one box.
*/
CGAL_SPLINE_CONSTRAINTS_INLINE Feasibility_d feasibility_of(const Constraint_system_d& system,
                                                            const Polynomial_conditions& polynomials,
                                                            const Solver_options& options)
{
  check_constraints(system, polynomials);
  const Upward_rounding_guard guard;
  Run_control control(options);
  Feasibility_run run(options, control);
  Feasibility_outcome outcome{Feasibility::INFEASIBLE, {}, {}, {}};
  const std::vector<Exact_ranges> ranges = ranges_between_breaks(system);
  std::vector<std::size_t> cell(ranges.size(), 0);
  do {
    Exact_ranges box = domain_of(system);
    const bool is_stopped = run.must_stop();
    for (std::size_t j = 0; j < ranges.size() && !is_stopped; ++j)
      box[j] = ranges[j][cell[j]];
    Feasibility_outcome part = outcome_on_cell(system, polynomials, box, run);
    if (part.status == Feasibility::FEASIBLE)
      outcome = std::move(part);
    else if (part.status == Feasibility::UNDECIDED) {
      outcome.status = Feasibility::UNDECIDED;
      outcome.undecided.insert(outcome.undecided.end(), part.undecided.begin(), part.undecided.end());
    }
    if (is_stopped)
      break;
  } while (outcome.status != Feasibility::FEASIBLE && advance(cell, ranges));
  return run.ended_with(std::move(outcome));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_FEASIBILITY_OF_H
