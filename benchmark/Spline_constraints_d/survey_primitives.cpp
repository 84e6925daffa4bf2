// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What pairs of planes, quadrics, tori and ruled surfaces have in common, as patches (P) and as implicit surfaces (I):
// a line per pair with the answers and their times in milliseconds, and a summary. Numbers of closed curves/open
// curves/singular points; u: undecided; !: not what geometry says.

#include "pairs_of_primitives.h"

#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <iostream>
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
std::string counts(const A& a, const B& b)
{
  const auto set = SC::intersection_curves(a, b, {.tolerance = 1e-8, .time_limit = 20});
  std::ostringstream out;
  out << set.number_of_closed_curves() << '/' << set.number_of_open_curves() << '/' << set.singular_points().size();
  if (!set.points().empty())   // no pair has single points
    out << " and " << set.points().size();
  return set.is_complete() ? out.str() : "u";
}

std::string counts(const Pair& pair, std::size_t representation)
{
  switch (representation) {
  case 0: return counts(pair.a.patch, pair.b.patch);
  case 1: return counts(pair.a.patch, implicit(pair.b.equation));
  case 2: return counts(implicit(pair.a.equation), pair.b.patch);
  default: return counts(implicit(pair.a.equation), implicit(pair.b.equation));
  }
}

} // namespace

int main()
{
  const std::array<std::string, 4> names{"PP", "PI", "IP", "II"};
  std::array<std::vector<double>, 4> times;
  std::array<int, 4> undecided{}, wrong{};
  for (const Pair& pair : pairs_of_primitives::all_pairs()) {
    std::cout << pair.name;
    for (std::size_t k = 0; k < names.size(); ++k) {
      const auto begin = std::chrono::steady_clock::now();
      const std::string found = counts(pair, k);
      const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;
      times[k].push_back(time.count());
      const bool is_undecided = found == "u" && pair.counts[k] != "u",
                 is_wrong = found != "u" && found != pair.counts[k];
      undecided[k] += is_undecided ? 1 : 0;
      wrong[k] += is_wrong ? 1 : 0;
      std::cout << " | " << names[k] << ' ' << found << (is_wrong ? '!' : ' ') << ' ' << time.count();
    }
    std::cout << std::endl;
  }
  for (std::size_t k = 0; k < names.size(); ++k) {
    std::sort(times[k].begin(), times[k].end());
    std::cout << names[k] << ": " << times[k].size() << " pairs, " << undecided[k] << " undecided, " << wrong[k]
              << " wrong; median " << times[k][times[k].size() / 2] << ", 90 % within "
              << times[k][times[k].size() * 9 / 10] << ", greatest " << times[k].back() << " ms\n";
  }
}
