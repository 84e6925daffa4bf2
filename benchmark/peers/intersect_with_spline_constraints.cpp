// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// This package: C1(t) - C2(s) = 0 on [0,1]^2, with the default solver.
#include "curve_intersection.h"

#include <CGAL/Spline_constraints_d.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace peers {
namespace {

namespace SC = CGAL::Spline_constraints;

SC::Spline_function coordinate(const Bezier_curve& curve, double Control_point::*axis, int unknown)
{
  std::vector<double> coefficients;
  coefficients.reserve(curve.size());
  for (const Control_point& p : curve)
    coefficients.push_back(p.*axis);
  const int degree = static_cast<int>(curve.size()) - 1;
  return SC::Spline_function::from_bernstein({unknown},
                                             SC::Bernstein_tensor<double>({degree}, std::move(coefficients)));
}

SC::Constraint_system_d intersection_system(const Bezier_curve& a, const Bezier_curve& b)
{
  SC::Constraint_system_d system(std::vector<SC::Constraint_system_d::Domain>(2, {0, 1}));
  for (double Control_point::*axis : {&Control_point::x, &Control_point::y})
    system.add(coordinate(a, axis, 0) - coordinate(b, axis, 1), SC::Relation::EQUAL);
  return system;
}

} // namespace

Run intersect_with_spline_constraints(const Bezier_curve& a, const Bezier_curve& b)
{
  const auto start = std::chrono::steady_clock::now();
  const SC::Constraint_system_d system = intersection_system(a, b);
  const std::chrono::duration<double> building = std::chrono::steady_clock::now() - start;
  const SC::Solution_set_d<double> solutions = SC::solve(system);

  const auto count = [&](SC::Solution_kind kind) { return static_cast<int>(solutions.count(kind)); };
  Run run;
  run.answer.points = count(SC::Solution_kind::CERTIFIED) + count(SC::Solution_kind::CLUSTER);
  run.answer.overlaps = count(SC::Solution_kind::CONTINUUM);
  run.answer.undecided = count(SC::Solution_kind::UNDECIDED);
  run.answer.is_overlap_suspected = std::any_of(solutions.begin(), solutions.end(), [](const auto& solution) {
    return solution.reason() == SC::Undecided_reason::CONTINUUM;
  });
  const SC::Summary& summary = solutions.summary();
  run.phases = {.building = building.count(),
                .setup = summary.setup_seconds,
                .rebuilding = summary.rebuild_seconds,
                .nodes = summary.nodes,
                .rebuilds = summary.restarts};
  return run;
}

} // namespace peers
