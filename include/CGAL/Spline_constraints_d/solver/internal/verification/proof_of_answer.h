// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_PROOF_OF_ANSWER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_PROOF_OF_ANSWER_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/univariate_verification.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/verification.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace verification {

/*
Proves that all points of a segment are solutions, and satisfy the inequalities or are limits of points that do. Between
breaks an equality is a polynomial along the segment, of at most the sum of its degrees: it is zero when it has one zero
more than that.
*/
inline bool is_segment_of_solutions(const Constraint_system_d& system,
                                    const std::vector<std::vector<Exact_rational>>& ends)
{
  const std::size_t n = ends[0].size();
  const auto box_between = [&](const Exact_rational& t0, const Exact_rational& t1) {
    Box result;
    for (std::size_t j = 0; j < n; ++j) {
      const Exact_rational step = ends[1][j] - ends[0][j], x0 = ends[0][j] + t0 * step, x1 = ends[0][j] + t1 * step;
      result.push_back({(std::min)(x0, x1), (std::max)(x0, x1)});
    }
    return result;
  };
  std::vector<Exact_rational> cuts{Exact_rational(0), Exact_rational(1)};
  int degree = 0;
  for (const Spline_function& function : system.equalities())
    for (const Spline_term& term : function.terms()) {
      degree = (std::max)(degree, std::accumulate(term.degrees.begin(), term.degrees.end(), 0));
      for (std::size_t j = 0; j < term.variables.size(); ++j) {
        const Exact_rational &begin = ends[0][term.variables[j]], &end = ends[1][term.variables[j]];
        for (const Exact_rational& at : term.breaks[j])
          if ((begin < at && at < end) || (end < at && at < begin))
            cuts.push_back(Exact_rational((at - begin) / (end - begin)));
      }
    }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
    for (int k = 1; k <= degree + 1; ++k) {
      const Exact_rational t = cuts[i] + (cuts[i + 1] - cuts[i]) * Exact_rational(k) / Exact_rational(degree + 2);
      if (!satisfies_equalities(system, box_between(t, t)))
        return false;
    }
  constexpr int parts = 16;
  for (int k = 0; k < parts; ++k)
    if (!is_admissible(
            system,
            box_between(Exact_rational(k) / Exact_rational(parts), Exact_rational(k + 1) / Exact_rational(parts)),
            true))
      return false;
  return true;
}


CGAL_SPLINE_CONSTRAINTS_INLINE bool is_proved(const Constraint_system_d& system, Solution_kind kind,
                                              const std::vector<std::pair<Exact_rational, Exact_rational>>& ranges,
                                              const std::vector<std::vector<Exact_rational>>& ends)
{
  Box box;
  for (const auto& [lower, upper] : ranges)
    box.push_back({lower, upper});
  bool result = false;
  switch (kind) {
  case Solution_kind::CERTIFIED: result = has_one_solution(system, box); break;
  case Solution_kind::CLUSTER: result = has_solution(system, box); break;
  case Solution_kind::CONTINUUM: result = !ends.empty() && is_segment_of_solutions(system, ends); break;
  case Solution_kind::UNDECIDED: break;
  }
  return result || (box.size() == 1 && univariate::Proof(system, box[0]).succeeds(kind));
}

} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_PROOF_OF_ANSWER_H
