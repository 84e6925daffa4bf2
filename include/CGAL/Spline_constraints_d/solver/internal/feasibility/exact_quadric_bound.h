// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_EXACT_QUADRIC_BOUND_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_EXACT_QUADRIC_BOUND_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_problem.h>

#include <CGAL/number_utils.h>

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
A lower bound of a polynomial of degree at most two on a box, exactly, by completing squares: its least value everywhere
where it has one, and parts that are linear at their ends. Nothing where it is not convex, or has a higher degree.
*/
inline std::optional<Exact_rational> exact_lower_bound(const Power_polynomial& polynomial, const Exact_ranges& box)
{
  const std::size_t n = box.size();
  if (polynomial.total_degree() > 2)
    return std::nullopt;
  std::vector<std::vector<Exact_rational>> form(n, std::vector<Exact_rational>(n, Exact_rational(0))); // x form x
  std::vector<Exact_rational> slopes(n, Exact_rational(0));
  Exact_rational constant(0);
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    const auto& powers = monomial.powers;
    if (powers.empty())
      constant = coefficient;
    else if (monomial.total_degree() == 1)
      slopes[powers[0].first] = coefficient;
    else if (powers.size() == 1)
      form[powers[0].first][powers[0].first] = coefficient;
    else
      form[powers[0].first][powers[1].first] = form[powers[1].first][powers[0].first] = coefficient / Exact_rational(2);
  }
  // p x_j^2 + (2 r + s) x_j is least where 2 p x_j = - (2 r + s), with r linear in the others
  for (std::size_t j = 0; j < n; ++j) {
    const Exact_rational pivot = form[j][j];
    if (CGAL::is_negative(pivot))
      return std::nullopt;
    if (CGAL::is_zero(pivot)) {
      for (std::size_t k = j + 1; k < n; ++k)
        if (!CGAL::is_zero(form[j][k]))
          return std::nullopt;
      constant += slopes[j] * (CGAL::is_negative(slopes[j]) ? box[j].second : box[j].first);
      continue;
    }
    constant -= slopes[j] * slopes[j] / (Exact_rational(4) * pivot);
    for (std::size_t k = j + 1; k < n; ++k) {
      const Exact_rational multiple = form[j][k] / pivot;
      if (CGAL::is_zero(multiple))
        continue;
      slopes[k] -= multiple * slopes[j];
      for (std::size_t l = j + 1; l < n; ++l)
        form[k][l] -= multiple * form[j][l];
    }
  }
  return constant;
}

/*
Multipliers with simple ratios, near those given, whose combination of the constraints of a problem is proved to be
positive on a box, or not negative and strict: for sets that touch, or nearly do. Empty where none are found.
*/
inline std::vector<Exact_rational> exact_multipliers(const Feasibility_problem& problem,
                                                     const std::vector<double>& multipliers, const Exact_ranges& box)
{
  double largest = 0;
  for (const double multiplier : multipliers)
    largest = (std::max)(largest, std::abs(multiplier));
  if (!(largest > 0) || !(largest < HUGE_VAL))
    return {};
  for (const double reach : {0x1p-40, 0x1p-30, 0x1p-22, 0x1p-14}) {
    std::vector<Exact_rational> rounded(multipliers.size(), Exact_rational(0));
    Power_polynomial sum;
    bool is_strict = false;
    for (std::size_t i = 0; i < multipliers.size(); ++i) {
      const double ratio = multipliers[i] / largest;
      if (!(std::abs(ratio) > reach))
        continue;
      const Exact_rational simple =
          simplest_rational_between(Exact_rational(ratio - reach), Exact_rational(ratio + reach));
      rounded[i] = simple;
      if (CGAL::is_negative(simple) && problem[i].is_inequality())
        return {};
      sum += Power_polynomial(simple) * problem[i].function;
      is_strict = is_strict || problem[i].relation == Relation::LESS;
    }
    if (const auto lower = exact_lower_bound(sum, box);
        lower && (CGAL::is_positive(*lower) || (is_strict && CGAL::is_zero(*lower))))
      return rounded;
  }
  return {};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_EXACT_QUADRIC_BOUND_H
