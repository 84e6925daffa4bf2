// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What solve_system prints: one line per answer, or JSON, and a progress bar.
#ifndef SOLVE_SYSTEM_OUTPUT_H
#define SOLVE_SYSTEM_OUTPUT_H

#include <CGAL/Spline_constraints_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>

#include <unistd.h>

#include <charconv>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

// A number of the command line, the whole word.
inline double number(const std::string& option, const std::string& word)
{
  double result = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), result);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(result))
    throw CGAL::Spline_constraints::Invalid_input(option + ": " + word + " is not a number");
  return result;
}

// Shows the share of the domain that is done, on a terminal and after a second.
class Progress_bar
{
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  bool m_is_terminal = isatty(2) != 0, m_is_shown = false;

public:
  void on_progress(double fraction)
  {
    if (!m_is_terminal || std::chrono::steady_clock::now() - m_start < std::chrono::seconds(1))
      return;
    const int done = static_cast<int>(40 * fraction);
    std::cerr << "\r[" << std::string(done, '#') << std::string(40 - done, ' ') << "] "
              << static_cast<int>(100 * fraction) << " %" << std::flush;
    m_is_shown = true;
  }
  bool stop() const { return false; }
  void clear()
  {
    if (m_is_shown)
      std::cerr << '\r' << std::string(50, ' ') << '\r';
  }
};

// Both ends of a range as decimals; rounded outwards where they are rational.
template <class Coordinate>
std::pair<double, double> as_doubles(const std::pair<Coordinate, Coordinate>& range)
{
  using namespace CGAL::Spline_constraints;
  return {to_double_interval(Exact_rational(range.first)).first,
          to_double_interval(Exact_rational(range.second)).second};
}

template <class Solution_set>
void print_summary(const Solution_set& solutions)
{
  using CGAL::Spline_constraints::Solution_kind;
  const char* const least = solutions.is_complete() ? "" : "at least ";
  std::cout << "solutions: " << least << solutions.count(Solution_kind::CERTIFIED) << " certified, " << least
            << solutions.count(Solution_kind::CLUSTER) << " clusters, " << least
            << solutions.count(Solution_kind::CONTINUUM) << " continua, " << solutions.count(Solution_kind::UNDECIDED)
            << " undecided; complete: " << (solutions.is_complete() ? "yes" : "no") << "; nodes "
            << solutions.summary().nodes << "; seconds " << std::setprecision(4) << solutions.summary().seconds << '\n';
}

template <class Solution_set>
void print_lines(const std::vector<std::string>& names, const Solution_set& solutions)
{
  using CGAL::Spline_constraints::Solution_kind;
  int index = 0;
  for (const auto& solution : solutions) {
    std::cout << (solution.is_certified() ? "root " : "box ") << ++index << "  " << solution.kind();
    if (solution.kind() == Solution_kind::CLUSTER && solution.multiplicity() > 0)
      std::cout << " of multiplicity " << solution.multiplicity();
    if (solution.kind() == Solution_kind::CONTINUUM)
      std::cout << " of dimension " << solution.dimension() << " in " << solution.cover().size()
                << (solution.cover().size() == 1 ? " box" : " boxes");
    if (solution.kind() == Solution_kind::UNDECIDED)
      std::cout << " (" << solution.reason() << ')';
    std::cout << ' ' << std::setprecision(17);
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto [lower, upper] = as_doubles(solution[j]);
      std::cout << ' ' << names[j] << " in [" << lower << ',' << upper << ']';
    }
    for (const auto& end : solution.ends()) {
      std::cout << (&end == &solution.ends().front() ? ", a segment from (" : " to (");
      for (std::size_t j = 0; j < names.size(); ++j)
        std::cout << (j == 0 ? "" : ", ") << end[j];
      std::cout << ')';
    }
    std::cout << '\n';
  }
  print_summary(solutions);
}

template <class Solution_set>
void print_json(const std::vector<std::string>& names, const Solution_set& solutions)
{
  std::cout << "{\"solutions\": [" << std::setprecision(17);
  const char* separator = "\n";
  for (const auto& solution : solutions) {
    std::cout << separator << "  {\"kind\": \"" << solution.kind() << "\", \"number_type\": \""
              << solution.number_type() << "\", \"multiplicity\": " << solution.multiplicity() << ", \"reason\": \""
              << solution.reason() << "\", \"box\": {";
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto [lower, upper] = as_doubles(solution[j]);
      std::cout << (j == 0 ? "" : ", ") << '"' << names[j] << "\": [" << lower << ", " << upper << ']';
    }
    std::cout << "}}";
    separator = ",\n";
  }
  const auto& summary = solutions.summary();
  std::cout << "\n],\n\"complete\": " << (summary.is_complete ? "true" : "false") << ", \"why_not\": \""
            << summary.why_not << "\", \"nodes\": " << summary.nodes << ", \"depth\": " << summary.depth
            << ", \"exact_rebuilds\": " << summary.restarts << ", \"seconds\": " << summary.seconds << "}\n";
  print_summary(solutions);
}

inline void print_curves(const std::vector<std::string>& names,
                         const CGAL::Spline_constraints::Curve_solution_set_d& set)
{
  const auto print_box = [&](const auto& box) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto [lower, upper] = as_doubles(box[j]);
      std::cout << (j == 0 ? "" : " ") << names[j] << " in [" << lower << ',' << upper << ']';
    }
    std::cout << '\n';
  };
  std::cout << std::setprecision(17);
  int index = 0;
  for (const auto& curve : set.curves()) {
    std::cout << "curve " << ++index << "  " << (curve.is_closed ? "closed" : "open") << ", " << curve.pieces.size()
              << " pieces, from ";
    print_box(set.vertices()[curve.pieces.front().ends[0]].box);
    if (!curve.is_closed) {
      std::cout << "  to ";
      print_box(set.vertices()[curve.pieces.back().ends[1]].box);
    }
  }
  for (const std::size_t point : set.singular_points()) {
    std::cout << "singular point ";
    print_box(set.vertices()[point].box);
  }
  for (const std::size_t point : set.points()) {
    std::cout << "point ";
    print_box(set.vertices()[point].box);
  }
  for (const auto& region : set.undecided_regions()) {
    std::cout << "undecided (" << region.reason << ") with " << region.vertices.size() << " branches, "
              << region.boxes.size() << " boxes, the first ";
    print_box(region.boxes.front());
  }
  std::cout << std::setprecision(4) << set << '\n';
}

inline void print_surfaces(const std::vector<std::string>& names,
                           const CGAL::Spline_constraints::Surface_solution_set_d& set)
{
  const auto print_box = [&](const auto& box) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto [lower, upper] = as_doubles(box[j]);
      std::cout << (j == 0 ? "" : " ") << names[j] << " in [" << lower << ',' << upper << ']';
    }
    std::cout << '\n';
  };
  int index = 0;
  for (const CGAL::Spline_constraints::Solution_surface& surface : set.surfaces()) {
    std::cout << "surface " << ++index << "  Euler characteristic " << surface.euler_characteristic << ", ";
    if (surface.is_closed())
      std::cout << "closed, ";
    else
      std::cout << surface.boundary.size() << (surface.boundary.size() == 1 ? " boundary loop, " : " boundary loops, ");
    std::cout << "genus " << surface.genus() << ", " << surface.patches.size() << " patches"
              << (surface.is_open_ended ? ", may go on in an undecided region" : "") << '\n';
  }
  std::cout.precision(17);
  for (const auto* points : {&set.points(), &set.singular_points()})
    for (const std::size_t point : *points) {
      std::cout << (points == &set.points() ? "point " : "singular point ");
      print_box(set.vertices()[point].box);
    }
  for (const auto& region : set.undecided_regions()) {
    std::cout << "undecided (" << region.reason << ") with " << region.arcs.size() << " arcs, " << region.boxes.size()
              << " boxes, the first ";
    print_box(region.boxes.front());
  }
  std::cout.precision(4);
  std::cout << set << '\n';
}

inline void print_feasibility(const std::vector<std::string>& names,
                              const CGAL::Spline_constraints::Feasibility_d& answer)
{
  std::cout << std::setprecision(17);
  const auto print_ranges = [&](const auto& box, const auto& ends) {
    for (std::size_t j = 0; j < names.size(); ++j) {
      const auto [lower, upper] = ends(box[j]);
      std::cout << ' ' << names[j] << " in [" << lower << ',' << upper << ']';
    }
    std::cout << '\n';
  };
  if (answer.has_point()) {
    std::cout << "feasible: point (";
    for (std::size_t j = 0; j < names.size(); ++j)
      std::cout << (j == 0 ? "" : ", ") << names[j] << " = " << answer.box()[j].first;
    std::cout << ")\n";
  } else if (answer.is_feasible()) {
    std::cout << "feasible: point";
    print_ranges(answer.box(), [](const auto& range) { return as_doubles(range); });
  } else if (answer.is_infeasible())
    std::cout << "infeasible: proved\n";
  for (const auto& part : answer.undecided()) {
    std::cout << "undecided (" << part.reason << ')';
    if (part.place.empty())
      std::cout << '\n';
    else
      print_ranges(part.place, [](const auto& range) { return range; });
  }
  std::cout << std::setprecision(4) << answer << '\n';
}

#endif // SOLVE_SYSTEM_OUTPUT_H
