// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_COUNTERFLOW_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_COUNTERFLOW_SYSTEM_H

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>

#include <utility>
#include <vector>

namespace solver_test {

// Two substances that react while they pass each other, in m stages: u_{k-1} - u_{k+1} = 2 u_k (1 + 4 v_k) and
// v_{k-1} - 3 v_{k+1} = 2 v_k (1 + 4 u_k), where u_0, v_0, u_{m+1}, v_{m+1} are given. Moved so that a point is a
// solution, if one is given.
inline std::vector<std::pair<SC::Power_polynomial, SC::Relation>>
counterflow(int stages, const std::vector<Rational>& solution = {})
{
  const auto unknown = [&](int substance, int stage) {
    if (stage < 0 || stage >= stages)
      return SC::Power_polynomial(Rational((stage < 0) == (substance == 0) ? 1 : 0));
    return SC::Power_polynomial::variable(2 * stage + substance);
  };
  std::vector<std::pair<SC::Power_polynomial, SC::Relation>> result;
  for (int k = 0; k < stages; ++k)
    for (int s = 0; s < 2; ++s) {
      const SC::Power_polynomial flow =
          unknown(s, k - 1) - SC::Power_polynomial(Rational(s == 0 ? 1 : 3)) * unknown(s, k + 1);
      const SC::Power_polynomial reaction = SC::Power_polynomial(Rational(2)) * unknown(s, k) *
          (SC::Power_polynomial(Rational(1)) + SC::Power_polynomial(Rational(4)) * unknown(1 - s, k));
      SC::Power_polynomial& polynomial = result.emplace_back(flow - reaction, SC::Relation::EQUAL).first;
      if (!solution.empty())
        polynomial -= SC::Power_polynomial(polynomial(solution));
    }
  return result;
}

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_COUNTERFLOW_SYSTEM_H
