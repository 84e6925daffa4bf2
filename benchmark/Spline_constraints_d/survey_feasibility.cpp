// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// survey_feasibility [NUMBER [SEED]]: NUMBER random constraint problems (10,000), of which it is known by construction
// whether they can be satisfied. Every answer is checked in exact numbers; what is undecided after 20,000 nodes is
// counted. The exit status is 1 when an answer is wrong.
#include "planted_feasibility.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>

int main(int argc, char* argv[])
{
  using namespace planted_feasibility;
  const int number = argc > 1 ? std::atoi(argv[1]) : 10000, seed = argc > 2 ? std::atoi(argv[2]) : 1;
  struct Row
  {
    int problems = 0, undecided = 0;
    double seconds = 0, longest = 0;
    std::size_t nodes = 0, most_nodes = 0;
  };
  std::map<std::string, Row> rows;
  int wrong = 0;
  for (int k = 0; k < number; ++k) {
    Generator generator(static_cast<unsigned>(seed * number + k));
    const int kind = k % 5, degree = generator.integer(2, 3);
    const bool is_hard = kind == 1 || kind == 3; // all of the domain is to be looked at
    const int dimension = generator.integer(2, !is_hard ? 6 : degree == 2 ? 4 : 3);
    const int equalities = kind == 2 || kind == 3 ? generator.integer(1, dimension - 1) : 0;
    const int inequalities = generator.integer(kind == 1 ? 2 : 1, 6);
    const Problem problem = kind == 0 || kind == 2
        ? generator.with_solutions(dimension, inequalities, equalities, degree)
        : kind == 4 ? generator.touching_balls(dimension, generator.integer(0, 1) == 0)
                    : generator.without_solutions(dimension, inequalities, equalities, degree);
    const SC::Feasibility_d answer =
        SC::Feasibility_solver_d({.tolerance = 1e-6, .node_limit = 20000})(problem.domain, problem.conditions);
    static const char* const names[] = {"planted ball", "planted sum of squares", "planted point on equalities",
                                        "planted sum of squares with equalities", "balls that touch"};
    Row& row = rows[names[kind]];
    ++row.problems;
    row.undecided += !answer.is_complete();
    row.seconds += answer.summary().seconds;
    row.longest = (std::max)(row.longest, answer.summary().seconds);
    row.nodes += answer.summary().nodes;
    row.most_nodes = (std::max)(row.most_nodes, answer.summary().nodes);
    std::string error;
    if (answer.is_complete() && answer.is_feasible() != problem.is_feasible)
      error = "says the contrary";
    else if (answer.is_feasible())
      error = error_of_solution(problem, answer);
    else if (answer.is_infeasible() && answer.excluded().size() < 5000)
      error = error_of_proof(problem, answer, generator);
    if (!error.empty() || !answer.is_complete())
      std::cout << "problem " << k << " (" << names[kind] << ", " << dimension << " unknowns, " << inequalities << '+'
                << equalities << " constraints of degree " << degree << "): " << answer << ' ' << error << ' '
                << (answer.undecided().empty() ? "" : answer.undecided().front().reason) << '\n';
    wrong += !error.empty();
  }
  for (const auto& [name, row] : rows)
    std::cout << name << ": " << row.problems << " problems, " << row.undecided << " undecided, nodes "
              << static_cast<double>(row.nodes) / row.problems << " (most " << row.most_nodes << "), ms "
              << 1000 * row.seconds / row.problems << " (longest " << 1000 * row.longest << ")\n";
  std::cout << wrong << " wrong\n";
  return wrong == 0 ? 0 : 1;
}
