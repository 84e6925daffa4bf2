// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_SYSTEM_PROBLEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_SYSTEM_PROBLEMS_H

#include "../Spline_constraints_d/benchmark_systems.h"
#include "curve_intersection.h"

#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <string>
#include <utility>
#include <vector>

// Polynomial systems with the numbers that are known of solvers which have no package to install.
namespace peers {

struct System_problem
{
  std::string name;
  solver_test::System system;
  Intersections truth;
  std::string quoted;
};

// Three ellipsoids that meet in the points (+-1, +-1, +-1).
inline solver_test::System three_quadrics()
{
  const auto v = solver_test::variables(3);
  const auto x = solver_test::square(v[0]), y = solver_test::square(v[1]), z = solver_test::square(v[2]);
  return solver_test::with_equalities(solver_test::cube(3, -2, 2),
                                      {x + y + z - 3, x + 2 * y + 3 * z - 6, 3 * x + y + 2 * z - 6});
}

inline std::vector<System_problem> system_problems()
{
  const auto points = [](int count) { return Intersections{.points = count}; };
  const auto chebyshev = [&](int degree, std::string quoted) {
    return System_problem{
        "Chebyshev curves of degree " + std::to_string(degree) + " (" + std::to_string(degree * degree) + ')',
        solver_benchmark::chebyshev_curves(degree).system, points(degree * degree), std::move(quoted)};
  };
  return {
      {"Broyden tridiagonal 4 (2)", solver_benchmark::broyden(4).system, points(2), "IBEX 2.5, IRIT 0.7"},
      {"Broyden tridiagonal 6 (2)", solver_benchmark::broyden(6).system, points(2), "IBEX 3.8, IRIT 7.2"},
      {"Katsura 4 (12)", solver_benchmark::katsura(4).system, points(12), "IBEX 190 · 11 and 1 undecided, IRIT 830"},
      {"three quadrics (8)", three_quadrics(), points(8),
       "other quadrics, 4 or 8 points: IBEX 2.4, Kodiak 5.9 · 14 boxes, IRIT 0.9"},
      chebyshev(16, "IRIT, tolerance 1e-3: 253 of them"),
      chebyshev(20, "IRIT, tolerance 1e-3: 396 of them"),
      chebyshev(24, "IRIT, tolerance 1e-3: 565 of them"),
      chebyshev(30, "IRIT, tolerance 1e-3: 873 of them; tolerance 1e-6: 930 · 900")};
}

inline Run solve_system(const solver_test::System& system)
{
  namespace SC = CGAL::Spline_constraints;
  const auto solutions = SC::solve(system);
  const auto count = [&](SC::Solution_kind kind) { return static_cast<int>(solutions.count(kind)); };
  Run run;
  run.answer.points = count(SC::Solution_kind::CERTIFIED) + count(SC::Solution_kind::CLUSTER);
  run.answer.overlaps = count(SC::Solution_kind::CONTINUUM);
  run.answer.undecided = count(SC::Solution_kind::UNDECIDED);
  return run;
}

} // namespace peers

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_SYSTEM_PROBLEMS_H
