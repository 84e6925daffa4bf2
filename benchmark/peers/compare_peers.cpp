// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersections of planar Bezier curves, operations in space, and a few polynomial systems: this package beside the
// programs that users would take instead, in one run on one machine. Prints tables in Markdown. Names of problems on
// the command line select them.
#include "curve_intersection.h"
#include "curve_problems.h"
#include "operation_problems.h"
#include "repeated_runs.h"
#include "system_problems.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace peers {
namespace {

template <class Function>
struct Program
{
  std::string name;
  Function* run; // null where it is not installed
};

using Curve_program = Program<Run(const Bezier_curve&, const Bezier_curve&)>;
using Operation_program = Program<Run(const Operation_problem&)>;

// This package first.
std::vector<Curve_program> curve_programs()
{
  return {{"this package", intersect_with_spline_constraints},
#ifdef PEERS_SISL
          {"SISL, `s1857`", intersect_with_sisl},
#else
          {"SISL, `s1857`", nullptr},
#endif
#ifdef PEERS_OPEN_CASCADE
          {"OpenCASCADE " PEERS_OPEN_CASCADE ", `Geom2dAPI_InterCurveCurve`", intersect_with_open_cascade},
#else
          {"OpenCASCADE, `Geom2dAPI_InterCurveCurve`", nullptr},
#endif
#ifdef PEERS_ALGEBRAIC_KERNEL
          {"CGAL " PEERS_CGAL ", `Algebraic_kernel_d_2`", intersect_with_algebraic_kernel},
#else
          {"CGAL, `Algebraic_kernel_d_2`", nullptr},
#endif
#ifdef PEERS_BEZIER_TRAITS
          {"CGAL " PEERS_CGAL ", `Arr_Bezier_curve_traits_2`", intersect_with_bezier_traits}
#else
          {"CGAL, `Arr_Bezier_curve_traits_2`", nullptr}
#endif
  };
}

std::vector<Operation_program> operation_programs()
{
  return {{"this package", operate_with_spline_constraints},
          {"this package, prepared", operate_with_prepared_splines},
#ifdef PEERS_SISL
          {"SISL", operate_with_sisl},
#else
          {"SISL", nullptr},
#endif
#ifdef PEERS_OPEN_CASCADE
          {"OpenCASCADE " PEERS_OPEN_CASCADE, operate_with_open_cascade}
#else
          {"OpenCASCADE", nullptr}
#endif
  };
}

double median(std::vector<double> values)
{
  if (values.empty())
    return NAN;
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

template <class Projection>
double median(const Runs& runs, const Projection& projection)
{
  std::vector<double> values;
  for (const Run& run : runs.runs)
    values.push_back(static_cast<double>(projection(run.phases)));
  return median(std::move(values));
}

double total(const Runs& runs)
{
  return median(runs, [](const Phases& phases) { return phases.total; });
}

std::string formatted(double value)
{
  std::ostringstream out;
  const int digits = value < 10 ? 2 : value < 100 ? 1 : 0;
  out << std::fixed << std::setprecision(value == 0 ? 0 : value < 0.1 ? 3 : digits) << value;
  return out.str();
}

std::string milliseconds(double seconds) { return formatted(1e3 * seconds); }

std::string in_words(const Intersections& answer)
{
  const auto count = [](int n, const std::string& what) {
    return std::to_string(n) + ' ' + what + (n == 1 ? "" : "s");
  };
  std::string text;
  if (answer.distance > 0) {
    std::ostringstream out;
    out << std::setprecision(9) << answer.distance;
    text = out.str();
  } else if (answer.points > 0 || (answer.overlaps == 0 && answer.undecided == 0))
    text = std::to_string(answer.points);
  if (answer.overlaps > 0)
    text += (text.empty() ? "" : " + ") + count(answer.overlaps, "overlap");
  if (answer.undecided > 0)
    text += (text.empty() ? "" : " + ") + std::to_string(answer.undecided) + " undecided" +
        (answer.is_overlap_suspected ? ", overlap suspected" : "");
  return answer.has_failed ? text + ", reports failure" : text;
}

bool is_right(const Runs& runs, const Intersections& truth)
{
  if (runs.end != Runs::End::FINISHED || runs.runs.empty())
    return false;
  Intersections answer = runs.runs.front().answer;
  if (std::abs(answer.distance - truth.distance) <= 1e-7)
    answer.distance = truth.distance;
  return answer == truth;
}

std::string cell(const Runs& runs, const Intersections& truth)
{
  if (runs.end == Runs::End::TIMED_OUT)
    return "**no answer in time**";
  if (runs.end == Runs::End::CRASHED || runs.runs.empty())
    return "**crash**";
  const std::string answer = in_words(runs.runs.front().answer);
  return milliseconds(total(runs)) + " · " + (is_right(runs, truth) ? answer : "**" + answer + "**");
}

// Calls run(program) in rounds over the programs, so that a slow spell of the machine falls on all of them.
template <class Function, class Run_program>
std::vector<Runs> runs_of(const std::vector<Program<Function>>& programs, const Run_program& run)
{
  constexpr int rounds = 3;
  const Run_limits limits{.least_runs = 2, .seconds = 0.1, .longest_seconds = 0.7, .kill_seconds = 20};
  std::vector<Runs> result(programs.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (programs[i].run == nullptr || result[i].end != Runs::End::FINISHED)
        continue;
      const Runs more = repeated_runs([&] { return run(programs[i].run); }, limits);
      result[i].end = more.end;
      result[i].runs.insert(result[i].runs.end(), more.runs.begin(), more.runs.end());
    }
  return result;
}

// This package, in as many ways as come first, beside the fastest of the others that is right.
std::string ratio(const std::vector<Runs>& runs, const Intersections& truth, std::size_t own)
{
  double fastest = HUGE_VAL;
  for (std::size_t i = own; i < runs.size(); ++i)
    if (is_right(runs[i], truth))
      fastest = (std::min)(fastest, total(runs[i]));
  if (std::isinf(fastest))
    return "no other is right";
  std::string result;
  for (std::size_t i = 0; i < own; ++i)
    result += (i == 0 ? "" : ", ") + (runs[i].runs.empty() ? "-" : formatted(total(runs[i]) / fastest));
  return result;
}

void print_row(const std::vector<std::string>& cells)
{
  std::cout << '|';
  for (const std::string& cell : cells)
    std::cout << ' ' << cell << " |";
  std::cout << std::endl;
}

void print_header(const std::vector<std::string>& cells)
{
  print_row(cells);
  print_row(std::vector<std::string>(cells.size(), "---"));
}

template <class Function>
void print_header_of(const std::vector<Program<Function>>& programs)
{
  std::vector<std::string> header{"problem", "truth"};
  for (const auto& program : programs)
    header.push_back(program.name);
  header.push_back("ratio");
  print_header(header);
}

template <class Problem, class Function>
void print_comparison(const Problem& problem, const std::vector<Program<Function>>& programs,
                      const std::vector<Runs>& runs, std::size_t own = 1)
{
  std::vector<std::string> row{problem.name + ' ' + problem.description, in_words(problem.truth)};
  for (std::size_t i = 0; i < programs.size(); ++i)
    row.push_back(programs[i].run == nullptr ? "not installed" : cell(runs[i], problem.truth));
  row.push_back(ratio(runs, problem.truth, own));
  print_row(row);
}

void compare_operations(const std::string& title, const std::vector<Operation_problem>& problems,
                        const std::set<std::string>& selected)
{
  std::cout << '\n' << title << "\n\n";
  const std::vector<Operation_program> programs = operation_programs();
  print_header_of(programs);
  for (const Operation_problem& problem : problems)
    if (selected.empty() || selected.contains(problem.name))
      print_comparison(problem, programs, runs_of(programs, [&](const auto& run) { return run(problem); }), 2);
}

void compare_curve_intersections(const std::set<std::string>& selected)
{
  std::cout
      << "Intersections of two Bezier curves: CPU time in ms, from the control points to the answer, and the number of "
         "intersections; wrong ones, and what is "
         "not an answer, in bold. Ratio: time of this package to that of the fastest other program that is right.\n\n";
  const std::vector<Curve_program> programs = curve_programs();
  print_header_of(programs);
  std::vector<std::vector<std::string>> details;
  for (const Curve_problem& problem : curve_problems()) {
    if (!selected.empty() && !selected.contains(problem.name))
      continue;
    const std::vector<Runs> runs =
        runs_of(programs, [&](const auto& run) { return run(problem.first, problem.second); });
    print_comparison(problem, programs, runs);

    const Runs& own = runs[0];
    if (own.runs.empty())
      continue;
    const auto of = [&](const auto& projection) { return median(own, projection); };
    const double building = of([](const Phases&p) { return p.building; }),
                 setup = of([](const Phases&p) { return p.setup; }),
                 rebuilding = of([](const Phases&p) { return p.rebuilding; });
    const auto count = [&](const auto& projection) { return std::to_string(std::lround(of(projection))); };
    details.push_back({problem.name, count([](const Phases& p) { return p.nodes; }),
                       count([](const Phases& p) { return p.rebuilds; }), milliseconds(total(own)),
                       milliseconds(building), milliseconds(setup), milliseconds(rebuilding),
                       milliseconds(total(own) - building - setup - rebuilding)});
  }
  std::cout << "\nWhere the time of this package goes, in ms:\n\n";
  print_header({"problem", "nodes", "exact rebuilds", "all", "making the curves", "setup", "exact rebuilds",
                "subdivision and the rest"});
  for (const auto& row : details)
    print_row(row);
}

void print_system_problems(const std::set<std::string>& selected)
{
  std::cout << "\nSystems for which the others cannot be installed here. Time of this package in ms, from the system "
               "to the answer. The numbers beside it are *quoted*: they were "
               "measured elsewhere, on another machine, and say no more than the order of magnitude.\n\n";
  print_header({"system", "this package", "quoted, other machine"});
  for (const System_problem& problem : system_problems()) {
    if (!selected.empty() && !selected.contains(problem.name))
      continue;
    const Runs runs = repeated_runs([&] { return solve_system(problem.system); }, {.least_runs = 5, .seconds = 0.3});
    print_row({problem.name, cell(runs, problem.truth), problem.quoted});
  }
}

} // namespace
} // namespace peers

int main(int argc, char** argv)
{
  const std::set<std::string> selected(argv + 1, argv + argc);
  peers::compare_curve_intersections(selected);
  peers::compare_operations("Operations in space, in the same way: the number of intersections, or the least distance.",
                            peers::operation_problems(), selected);
  peers::compare_operations(
      "Curves of two surfaces, in the same way: the number of curves, which are polylines or splines in the end.",
      peers::surface_problems(), selected);
  peers::print_system_problems(selected);
}
