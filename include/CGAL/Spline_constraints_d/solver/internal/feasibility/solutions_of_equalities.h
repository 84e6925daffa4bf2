// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SOLUTIONS_OF_EQUALITIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SOLUTIONS_OF_EQUALITIES_H

#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Convex_bound.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Rational_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/solutions_of_systems.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Pairs of a constraint and an unknown, for which it is solved near a point: a row of the Jacobian for each of them, by
elimination with complete pivoting, columns as wide as the domain. Constraints whose gradients depend on others' there
are left out.
*/
inline std::vector<std::pair<std::size_t, int>> pivots_of(Polynomial_family<double>& family,
                                                          const std::vector<std::size_t>& constraints,
                                                          const Double_box& domain, const std::vector<double>& point)
{
  constexpr double dependent = 1e-7;
  const std::size_t n = domain.size();
  std::vector<std::vector<double>> rows;
  family.set_point(point);
  for (const std::size_t i : constraints) {
    std::vector<double> row = family.gradient(family.coefficients(i));
    double size = 0;
    for (std::size_t j = 0; j < n; ++j) {
      row[j] *= domain.radius(j);
      size = (std::max)(size, std::abs(row[j]));
    }
    for (double& x : row)
      x = size > 0 && size < HUGE_VAL ? x / size : 0;
    rows.push_back(std::move(row));
  }
  std::vector<std::pair<std::size_t, int>> result;
  std::vector<bool> is_done(rows.size(), false);
  while (result.size() < rows.size()) {
    std::size_t pivot_row = rows.size(), pivot = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (std::size_t j = 0; j < n && !is_done[i]; ++j)
        if (std::abs(rows[i][j]) > (pivot_row == rows.size() ? dependent : std::abs(rows[pivot_row][pivot]))) {
          pivot_row = i;
          pivot = j;
        }
    if (pivot_row == rows.size())
      break;
    is_done[pivot_row] = true;
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (!is_done[i]) {
        const double multiple = rows[i][pivot] / rows[pivot_row][pivot];
        for (std::size_t j = 0; j < n; ++j)
          rows[i][j] = j == pivot ? 0 : rows[i][j] - multiple * rows[pivot_row][j];
      }
    result.emplace_back(constraints[pivot_row], static_cast<int>(pivot));
  }
  return result;
}

// The unknowns for which the equalities are solved near a point; empty where their gradients are nearly dependent.
inline std::vector<int> dependent_unknowns(Polynomial_family<double>& family, const Feasibility_problem& problem,
                                           const Double_box& domain, const std::vector<double>& point)
{
  std::vector<std::size_t> equalities;
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem[i].relation == Relation::EQUAL)
      equalities.push_back(i);
  std::vector<int> result;
  for (const auto& [constraint, unknown] : pivots_of(family, equalities, domain, point))
    result.push_back(unknown);
  std::sort(result.begin(), result.end());
  return result.size() == equalities.size() ? result : std::vector<int>();
}

// Equalities, and inequalities of a list that are nearly zero, with independent gradients at a point.
inline std::vector<std::size_t> independent_constraints(Polynomial_family<double>& family,
                                                        const Feasibility_problem& problem,
                                                        const std::vector<std::size_t>& inequalities,
                                                        const Double_box& domain, const std::vector<double>& point)
{
  constexpr double nearly_zero = 1e-7;
  std::vector<std::size_t> tight;
  family.set_point(point);
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (problem[i].relation == Relation::EQUAL)
      tight.push_back(i);
  for (const std::size_t i : inequalities)
    if (std::abs(family.value(family.coefficients(i))) < nearly_zero)
      tight.push_back(i);
  std::vector<std::size_t> result;
  for (const auto& [constraint, unknown] : pivots_of(family, tight, domain, point))
    result.push_back(constraint);
  return result;
}

/*
A box with a point that satisfies all constraints, near an approximate one: all unknowns but as many as there are
equalities have rational values, and the others are those of one regular solution that the solver of points certifies,
and whose inequalities it decides.
*/
inline std::optional<Exact_ranges> solution_of_equalities_near(const Feasibility_problem& problem,
                                                               Polynomial_family<double>& family,
                                                               const Double_box& domain,
                                                               const std::vector<double>& point, Feasibility_run& run)
{
  const std::vector<int> dependent = dependent_unknowns(family, problem, domain, point);
  if (dependent.empty())
    return std::nullopt;
  constexpr std::size_t most_nodes = 200;
  constexpr double reach = 1e-3, nearness_of_simple_value = 1e-5; // in units of the domain
  Exact_ranges box;
  for (int j = 0; j < problem.dimension(); ++j) {
    const auto& [lower, upper] = problem.domain()[j];
    const bool is_dependent = std::binary_search(dependent.begin(), dependent.end(), j);
    const double distance = domain.radius(j) * (is_dependent ? reach : nearness_of_simple_value);
    const Exact_rational below = (std::max)(lower, Exact_rational(point[j] - distance)),
                         above = (std::min)(upper, Exact_rational(point[j] + distance));
    if (above < below)
      return std::nullopt;
    if (is_dependent)
      box.emplace_back(below, above);
    else {
      const Exact_rational value = simplest_rational_between(below, above);
      box.emplace_back(value, value);
    }
  }
  const Feasibility_problem rest = problem.on(box);
  Exact_ranges ranges;
  for (const int j : dependent) {
    if (!rest.is_free(j))
      return std::nullopt;
    ranges.push_back(box[j]);
  }
  Constraint_system_d system(ranges);
  for (const auto& [function, relation] : rest.conditions())
    system.add(renumbered(function, dependent), relation);
  for (const auto& solution : solutions_of(system, most_nodes, run))
    if (solution.is_certified()) {
      const auto part = solution.exact_box();
      for (std::size_t k = 0; k < dependent.size(); ++k)
        box[dependent[k]] = part[k];
      return box;
    }
  return std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SOLUTIONS_OF_EQUALITIES_H
