// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Solves a polynomial system in Minibex format and prints every answer with its certificate; with one equality less
// than unknowns, every curve of solutions, and with two less, every surface. With inequalities alone, or still fewer
// equalities, it tells whether there is a solution: one of them, or that there is none by proof. With elementary
// functions there are no curves and surfaces: unless there are as many equalities as unknowns, it tells this, too.
//
//   solve_system FILE [--number-type fast|certified|interval|multiprecision|exact] [--tolerance T] [--test cone|graph]
//                     [--time-limit S] [--sequential] [--whole] [--verify] [--json] [--output FILE] [--chord-error E]
//
// If the program was built with TBB, all cores are used for the number type certified, with the same answers;
// --sequential uses one. --whole solves the system as it is, without decomposing it or eliminating unknowns. --verify
// proves points and clusters once more and prints first of how many this succeeds, not with --json. --output writes
// curves of solutions (.svg, .vtp, .txt) or surfaces (.svg, .vtp, .off, .ply, .stl), these within --chord-error. Exit
// status: 0 when every solution is accounted for, 3 when not, 2 for bad input.
#include "curve_output.h"
#include "solve_system_output.h"
#include "surface_output.h"

#include <CGAL/Spline_constraints_d.h>
#include <CGAL/Spline_constraints_d/IO/read_minibex.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;

struct Arguments
{
  std::string file, number_type = "certified", test = "graph", output;
  SC::Solver_options options;
  double chord_error = 0; // a five hundredth of the domain
  bool has_tolerance = false, json = false, sequential = false, whole = false, verify = false;
};

Arguments parse(int argc, char* argv[])
{
  Arguments result;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] {
      if (++i == argc)
        throw SC::Invalid_input(word + " needs a value");
      return std::string(argv[i]);
    };
    if (word == "--number-type") result.number_type = value();
    else if (word == "--tolerance") {
      result.options.tolerance = number(word, value());
      result.has_tolerance = true;
    }
    else if (word == "--chord-error") result.chord_error = number(word, value());
    else if (word == "--test") result.test = value();
    else if (word == "--time-limit") result.options.time_limit = number(word, value());
    else if (word == "--sequential")
      result.sequential = true;
    else if (word == "--whole") result.whole = true;
    else if (word == "--verify")
      result.verify = true;
    else if (word == "--json") result.json = true;
    else if (word == "--output") result.output = value();
    else if (word.starts_with("--") || !result.file.empty()) throw SC::Invalid_input("unknown argument " + word);
    else result.file = word;
  }
  if (result.file.empty())
    throw SC::Invalid_input("usage: solve_system FILE [--number-type fast|certified|interval|multiprecision|exact]"
                            " [--tolerance T] [--test cone|graph] [--time-limit S] [--sequential] [--whole] [--verify] "
                            "[--json] [--output FILE.svg|.vtp|.txt|.off|.ply|.stl] [--chord-error E]");
  return result;
}

template <class Concurrency_tag>
int solve_for_surfaces(const Arguments& arguments, const std::vector<std::string>& names,
                       const SC::Constraint_system_d& system)
{
  SC::Solver_options options = arguments.options;
  if (!arguments.has_tolerance)
    options.tolerance = 1e-8;
  Progress_bar progress;
  const auto surfaces = SC::Surface_solver_d<SC::Certified_solver_traits, Concurrency_tag>(options)(system, progress);
  progress.clear();
  if (!arguments.output.empty()) {
    double size = 0;
    for (int j = 0; j < 3; ++j)
      size = (std::max)(size, CGAL::to_double(SC::Exact_rational(system.domain(j).second - system.domain(j).first)));
    write_surfaces(arguments.output, surfaces, arguments.chord_error > 0 ? arguments.chord_error : size / 500);
  }
  print_surfaces(names, surfaces);
  return surfaces.is_complete() ? 0 : 3;
}

std::vector<std::pair<SC::Power_polynomial, SC::Relation>> polynomial_constraints(const SC::Minibex_system& input)
{
  std::vector<std::pair<SC::Power_polynomial, SC::Relation>> result;
  for (const auto& constraint : input.constraints)
    result.emplace_back(constraint.function, constraint.relation);
  return result;
}

// Of polynomials as they are: no tensors are made.
int decide_feasibility(const Arguments& arguments, const SC::Minibex_system& input)
{
  if (arguments.json || !arguments.output.empty())
    throw SC::Invalid_input("the answer whether there is a solution is written neither as JSON nor with --output");
  SC::Solver_options options = arguments.options;
  if (!arguments.has_tolerance)
    options.tolerance = 1e-6;
  const SC::Feasibility_d answer =
      SC::Feasibility_solver_d(options)(input.domains, polynomial_constraints(input), input.values);
  print_feasibility(input.names, answer);
  return answer.is_complete() ? 0 : 3;
}

template <class Solutions>
int print_points(const Arguments& arguments, const SC::Minibex_system& input, const Solutions& solutions)
{
  if (arguments.verify && !arguments.json) {
    std::size_t answers = 0, verified = 0;
    for (const auto& solution : solutions)
      if (solution.kind() == SC::Solution_kind::CERTIFIED || solution.kind() == SC::Solution_kind::CLUSTER) {
        ++answers;
        verified += SC::verify(input.domains, polynomial_constraints(input), input.values, solution);
      }
    std::cout << "verified: " << verified << " of " << answers << '\n';
  }
  arguments.json ? print_json(input.names, solutions) : print_lines(input.names, solutions);
  return solutions.is_complete() ? 0 : 3;
}

// With elementary functions: all solutions of as many equalities as unknowns; of others, whether there is one.
template <class Concurrency_tag>
int solve_with_functions(const Arguments& arguments, const SC::Minibex_system& input)
{
  if (arguments.number_type != "certified" || arguments.whole || arguments.test != "graph")
    throw SC::Invalid_input("elementary functions go with --number-type certified and --test graph, without --whole");
  if (!arguments.output.empty())
    throw SC::Invalid_input("--output is for curves and surfaces, which elementary functions have none of here");
  const auto equalities = std::ranges::count(input.constraints, SC::Relation::EQUAL, &SC::Minibex_constraint::relation);
  if (equalities != static_cast<long>(input.domains.size()))
    return decide_feasibility(arguments, input);
  Progress_bar progress;
  SC::Solver_options options = arguments.options;
  options.visitor = progress;
  const SC::Propagation_solver_d<Concurrency_tag> solver(options);
  const auto solutions = solver(input.domains, polynomial_constraints(input), input.values);
  progress.clear();
  return print_points(arguments, input, solutions);
}

// As many equations as unknowns, by the solver that gets on better.
template <class Concurrency_tag>
int solve_for_points(const Arguments& arguments, const SC::Minibex_system& input)
{
  Progress_bar progress;
  SC::Solver_options options = arguments.options;
  options.visitor = progress;
  const auto solutions = SC::solve_polynomials<Concurrency_tag>(input.domains, polynomial_constraints(input), options);
  progress.clear();
  return print_points(arguments, input, solutions);
}

template <class Number, bool tracks_rounding = true, class Concurrency_tag = CGAL::Sequential_tag>
int solve(Arguments arguments)
{
  const auto start = std::chrono::steady_clock::now();
  const SC::Minibex_system input = SC::read_minibex(arguments.file, SC::Minibex_subset::ELEMENTARY);
  const auto use_rest_of_time = [&] {
    if (double& limit = arguments.options.time_limit; limit > 0)   // what reading has left of it
      limit = (std::max)(limit - std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 1e-9);
  };
  if (!input.values.all().empty()) {
    use_rest_of_time();
    return solve_with_functions<Concurrency_tag>(arguments, input);
  }
  const auto equalities = std::count_if(input.constraints.begin(), input.constraints.end(), [](const auto& constraint) {
    return constraint.relation == SC::Relation::EQUAL;
  });
  if (equalities == 0 || equalities + 2 < static_cast<long>(input.domains.size())) {
    if (!std::is_same_v<Number, double> || !tracks_rounding)
      throw SC::Invalid_input("systems with so few equalities go with --number-type certified");
    use_rest_of_time();
    return decide_feasibility(arguments, input);
  }
  if constexpr (std::is_same_v<Number, double> && tracks_rounding)
    if (equalities == static_cast<long>(input.domains.size()) && !arguments.whole && arguments.test == "graph" &&
        arguments.output.empty()) {
      use_rest_of_time();
      return solve_for_points<Concurrency_tag>(arguments, input);
    }
  SC::Constraint_system_d system(input.domains);
  for (const auto& constraint : input.constraints)
    system.add(constraint.function, constraint.relation);
  use_rest_of_time();

  if (static_cast<int>(system.equalities().size()) + 1 == system.dimension()) {
    if constexpr (std::is_same_v<Number, double> && tracks_rounding)
      if (!arguments.json) {
        const auto curves = arguments.whole
            ? SC::Curve_solver_d<SC::Certified_solver_traits, Concurrency_tag>(arguments.options)(system)
            : SC::solve_curves<Concurrency_tag>(system, arguments.options);
        if (!arguments.output.empty())
          write_curves(arguments.output, input.names, system, curves);
        print_curves(input.names, curves);
        return curves.is_complete() ? 0 : 3;
      }
    throw SC::Invalid_input("curves of solutions go with --number-type certified, and are not written as JSON");
  }

  if (static_cast<int>(system.equalities().size()) + 2 == system.dimension()) {
    if constexpr (std::is_same_v<Number, double> && tracks_rounding)
      if (!arguments.json)
        return solve_for_surfaces<Concurrency_tag>(arguments, input.names, system);
    throw SC::Invalid_input("surfaces of solutions go with --number-type certified, and are not written as JSON");
  }

  if (!arguments.output.empty())
    throw SC::Invalid_input("--output is for curves and surfaces: one or two equalities less than unknowns");

  Progress_bar progress;
  const auto run = [&]<class Test>() {
    using Traits = SC::Solver_traits<Number, Test, SC::Preconditioned_reduction, SC::Smear_splitter, tracks_rounding>;
    const auto solutions = arguments.whole
        ? SC::Subdivision_solver_d<Traits, Concurrency_tag>(arguments.options)(system, progress)
        : SC::Decomposing_solver_d<Traits, Concurrency_tag>(arguments.options)(system, progress);
    progress.clear();
    return print_points(arguments, input, solutions);
  };
  if (arguments.test == "graph")
    return run.template operator()<SC::Graph_box_test>();
  if (arguments.test == "cone") {
    if constexpr (std::is_same_v<Number, double> && tracks_rounding &&
                  std::is_same_v<Concurrency_tag, CGAL::Sequential_tag>)
      return run.template operator()<SC::Normal_cone_test>();
    throw SC::Invalid_input("--test cone goes with --number-type certified, on one core");
  }
  throw SC::Invalid_input("--test must be cone or graph, not " + arguments.test);
}

int main(int argc, char* argv[])
try {
  const Arguments arguments = parse(argc, argv);
  if (arguments.number_type == "fast") return solve<double, false>(arguments);
  if (arguments.number_type == "certified" && arguments.test == "graph" && !arguments.sequential)
    return solve<double, true, CGAL::Parallel_if_available_tag>(arguments);
  if (arguments.number_type == "certified") return solve<double>(arguments);
  if (arguments.number_type == "interval") return solve<CGAL::Interval_nt<false>>(arguments);
  if (arguments.number_type == "multiprecision") return solve<SC::Mpfr_interval>(arguments);
  if (arguments.number_type == "exact") return solve<SC::Exact_rational>(arguments);
  throw SC::Invalid_input("unknown number type " + arguments.number_type);
} catch (const std::exception& error) {
  std::cerr << "solve_system: " << error.what() << '\n';
  return 2;
}
