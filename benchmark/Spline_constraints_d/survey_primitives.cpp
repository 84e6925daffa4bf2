// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What pairs of planes, quadrics, tori and ruled surfaces have in common, as patches (P) and as implicit surfaces (I):
// a line per pair with the answers and their times in milliseconds of the processor, and a summary. Numbers of closed
// curves/open curves/singular points; u: undecided; !: not what geometry says.
//
//   survey_primitives [--rounded [SECONDS]]
//
// Then the same patches as programs for CAD write them (in doubles, rotated and moved by irrational numbers), healed
// (H), beside the exact ones (P): the ratio of their times, the best of five in turns, without the time of healing,
// which comes last. With --rounded, the patches as they were written (R), too, with this limit of time or, as users
// ask, with none.

#include "pairs_of_primitives.h"
#include "surfaces_of_cad_programs.h"

#include <CGAL/Spline_constraints_d/geometry/healing/exact_primitives.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

using pairs_of_primitives::Pair;

SC::Implicit_surface_3 implicit(const SC::Power_polynomial& f)
{
  const auto range = [](int lower, int upper) { return std::pair(Rational(lower, 10), Rational(upper, 10)); };
  return SC::Implicit_surface_3(f, {range(-70, 71), range(-72, 73), range(-74, 75)});
}

template <class A, class B>
std::string counts(const A& a, const B& b, double time_limit = 20)
{
  const auto set = SC::intersection_curves(a, b, {.tolerance = 1e-8, .time_limit = time_limit});
  std::ostringstream out;
  out << set.number_of_closed_curves() << '/' << set.number_of_open_curves() << '/' << set.singular_points().size();
  if (!set.points().empty()) // no pair has single points
    out << " and " << set.points().size();
  return set.is_complete() ? out.str() : "u";
}

std::string counts(const Pair& pair, std::size_t representation)
{
  switch (representation) {
  case 0:
    return counts(pair.a.patch, pair.b.patch);
  case 1:
    return counts(pair.a.patch, implicit(pair.b.equation));
  case 2:
    return counts(implicit(pair.a.equation), pair.b.patch);
  default:
    return counts(implicit(pair.a.equation), implicit(pair.b.equation));
  }
}

// Of the processor, whatever else the machine does.
template <class Operation>
double milliseconds(const Operation& operation)
{
  const std::clock_t begin = std::clock();
  operation();
  return 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

bool is_wrong(const std::string& found, const std::string& expected) { return found != "u" && found != expected; }

std::string summary(std::vector<double> numbers)
{
  std::sort(numbers.begin(), numbers.end());
  std::ostringstream out;
  out << "median " << numbers[numbers.size() / 2] << ", 90 % within " << numbers[numbers.size() * 9 / 10]
      << ", greatest " << numbers.back();
  return out.str();
}

void survey_exact(const std::vector<Pair>& pairs)
{
  const std::array<std::string, 4> names{"PP", "PI", "IP", "II"};
  std::array<std::vector<double>, 4> times;
  std::array<int, 4> undecided{}, wrong{};
  for (const Pair& pair : pairs) {
    std::cout << pair.name;
    for (std::size_t k = 0; k < names.size(); ++k) {
      std::string found;
      times[k].push_back(milliseconds([&] { found = counts(pair, k); }));
      undecided[k] += found == "u" && pair.counts[k] != "u" ? 1 : 0;
      wrong[k] += is_wrong(found, pair.counts[k]) ? 1 : 0;
      std::cout << " | " << names[k] << ' ' << found << (is_wrong(found, pair.counts[k]) ? '!' : ' ') << ' '
                << times[k].back();
    }
    std::cout << std::endl;
  }
  for (std::size_t k = 0; k < names.size(); ++k)
    std::cout << names[k] << ": " << times[k].size() << " pairs, " << undecided[k] << " undecided, " << wrong[k]
              << " wrong; " << summary(times[k]) << " ms\n";
}

// Rounded ones are looked at if there is a limit for them; zero is none.
void survey_healed(const std::vector<Pair>& pairs, std::optional<double> limit_of_rounded)
{
  using namespace surfaces_of_cad_programs;
  const Motion motion = Motion::turned({1, 2, -0.7}, 1.1, {std::sqrt(2.0), -std::exp(1.0), 0.123456789});
  std::vector<double> ratios, healing, rounded;
  int undecided = 0, wrong = 0, slow = 0, undecided_rounded = 0, wrong_rounded = 0;
  double displacement = 0, exact_total = 0, healed_total = 0;
  for (const Pair& pair : pairs) {
    const std::vector<Rounded_surface> written_pair{written(pair.a.patch, motion), written(pair.b.patch, motion)};
    SC::Exact_primitives<Surface> result;
    healing.push_back(milliseconds([&] { result = SC::with_exact_primitives(written_pair, 1e-9); }));
    displacement = std::max(displacement, result.displacement());
    const std::vector<Surface> healed = result.simple_splines();
    double exact_time = 1e9, healed_time = 1e9;
    std::string expected, found;
    for (int turn = 0; turn < 5; ++turn) {
      exact_time = std::min(exact_time, milliseconds([&] { expected = counts(pair.a.patch, pair.b.patch); }));
      healed_time = std::min(healed_time, milliseconds([&] { found = counts(healed[0], healed[1]); }));
    }
    exact_total += exact_time;
    healed_total += healed_time;
    ratios.push_back(healed_time / exact_time);
    slow += ratios.back() > 1.5 ? 1 : 0;
    undecided += found == "u" && expected != "u" ? 1 : 0;
    wrong += is_wrong(found, expected) ? 1 : 0;
    std::cout << pair.name << " | " << result.primitives[0].kind << ", " << result.primitives[1].kind << " | P "
              << expected << ' ' << exact_time << " | H " << found << (is_wrong(found, expected) ? '!' : ' ') << ' '
              << healed_time << " | ratio " << ratios.back() << " | healed in " << healing.back();
    if (limit_of_rounded) {
      rounded.push_back(milliseconds([&] { found = counts(written_pair[0], written_pair[1], *limit_of_rounded); }));
      undecided_rounded += found == "u" && expected != "u" ? 1 : 0;
      wrong_rounded += is_wrong(found, expected) ? 1 : 0;
      std::cout << " | R " << found << (is_wrong(found, expected) ? '!' : ' ') << ' ' << rounded.back();
    }
    std::cout << std::endl;
  }
  std::cout << "H: " << ratios.size() << " pairs, " << undecided << " undecided, " << wrong
            << " wrong; nothing moved by more than " << displacement << "; ratio to the time of P " << summary(ratios)
            << ", " << slow << " above 1.5; " << healed_total << " ms for " << exact_total << " ms; healing "
            << summary(healing) << " ms\n";
  if (limit_of_rounded)
    std::cout << "R: " << rounded.size() << " pairs, " << undecided_rounded << " undecided, " << wrong_rounded
              << " with other numbers; " << summary(rounded) << " ms\n";
}

} // namespace

int main(int argc, char* argv[])
{
  try {
    std::optional<double> limit;
    if ((argc == 2 || argc == 3) && std::string(argv[1]) == "--rounded")
      limit = argc == 3 ? std::stod(argv[2]) : 0;
    if ((argc != 1 && !limit) || (argc == 3 && !(*limit > 0))) {
      std::cerr << "usage: survey_primitives [--rounded [SECONDS]]\n";
      return EXIT_FAILURE;
    }
    const std::vector<Pair> pairs = pairs_of_primitives::all_pairs();
    survey_exact(pairs);
    survey_healed(pairs, limit);
  } catch (const std::exception& error) {
    std::cerr << "survey_primitives: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
