// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What Minkowski sums and swept areas of random scenes say of random points and areas, beside samples of both
// boundaries and closed forms. The scenes are the same ones each time.
//
//   survey_sums sums|sweeps [FIRST END [POINTS]]
//
// Scenes are those with the numbers from FIRST to before END, each with that many points: 2,000, if none is given. A
// point is not compared where samples do not tell, in a strip along the boundary.
#include "random_sums_2.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>

using K = CGAL::Simple_cartesian<double>;

namespace {

struct Totals
{
  std::size_t scenes = 0, complete = 0, refused = 0, arcs = 0, holes = 0;
  std::size_t closed_forms = 0;
  double greatest_difference = 0;   // from closed forms, relative
  double area = 0, estimate = 0, variance = 0, greatest_deviations = 0;
  random_sums::Comparison points;
  double seconds = 0, longest = 0;

  void add(const random_sums::Comparison& c)
  {
    points.points += c.points;
    points.near_boundary += c.near_boundary;
    points.inside += c.inside;
    points.outside += c.outside;
    points.wrong_in_polygons += c.wrong_in_polygons;
    points.wrong_in_sum += c.wrong_in_sum;
    points.uncertain += c.uncertain;
    area += c.area;
    estimate += c.estimate;
    variance += c.deviation * c.deviation;
    greatest_deviations = std::max(greatest_deviations, std::abs(c.area - c.estimate) / c.deviation);
  }
};

void ask(unsigned number, bool is_sweep, std::size_t points, Totals& totals)
{
  constexpr int samples = 400;
  random_sums::Scenes<K> scenes(number);
  const unsigned kind = number % random_sums::Scenes<K>::kinds;
  const auto scene = is_sweep ? scenes.sweep(kind) : scenes.sum(kind);
  const auto begin = std::chrono::steady_clock::now();
  const auto sum = scene.result();
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  ++totals.scenes;
  totals.seconds += seconds;
  totals.longest = std::max(totals.longest, seconds);
  totals.complete += sum.is_complete();
  for (const auto& boundary : sum.boundaries()) {
    totals.arcs += boundary.arcs.size();
    totals.holes += boundary.is_hole;
  }
  const auto comparison = random_sums::compare(scene, sum, points, samples, number);
  totals.add(comparison);
  if (scene.area) {
    ++totals.closed_forms;
    totals.greatest_difference = std::max(totals.greatest_difference, std::abs(comparison.area / *scene.area - 1));
  }
  const std::size_t wrong = comparison.wrong_in_polygons + comparison.wrong_in_sum;
  if (!sum.is_complete() || wrong > 0 || std::abs(comparison.area - comparison.estimate) > 4 * comparison.deviation ||
      seconds > 10)
    std::cout << "scene " << number << ": " << (sum.is_complete() ? "complete" : "not complete") << ", " << wrong
              << " wrong, area " << comparison.area << " beside " << comparison.estimate << " +- "
              << comparison.deviation << " (" << seconds << " s)" << std::endl;
}

} // namespace

int main(int argc, char* argv[])
{
  const std::string what = argc > 1 ? argv[1] : "";
  if (what != "sums" && what != "sweeps") {
    std::cerr << "survey_sums sums|sweeps [FIRST END [POINTS]]\n";
    return 2;
  }
  const unsigned first = argc > 3 ? static_cast<unsigned>(std::atoi(argv[2])) : 0,
                 end = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 120;
  const std::size_t points = argc > 4 ? static_cast<std::size_t>(std::atoi(argv[4])) : 2000;
  Totals totals;
  for (unsigned number = first; number < end; ++number)
    try {
      ask(number, what == "sweeps", points, totals);
    } catch (const CGAL::Spline_constraints::Invalid_input& error) {
      ++totals.refused;
      std::cout << "scene " << number << ": " << error.what() << std::endl;
    }
  const auto& p = totals.points;
  std::cout << what << ": " << totals.scenes << " scenes, " << totals.complete << " complete, " << totals.refused
            << " refused; " << totals.arcs << " arcs, " << totals.holes << " holes; " << totals.seconds
            << " s, at most " << totals.longest << " s\n"
            << p.points << " points, " << p.inside << " inside, " << p.outside << " outside, " << p.near_boundary
            << " near the boundary; wrong: " << p.wrong_in_polygons << " by polygons, " << p.wrong_in_sum
            << " of a tenth by the sum, which leaves " << p.uncertain << " open\n"
            << "areas " << totals.area << " beside " << totals.estimate << " +- " << std::sqrt(totals.variance)
            << ", at most " << totals.greatest_deviations << " standard errors; " << totals.closed_forms
            << " closed forms, differing by " << totals.greatest_difference << " at most\n";
}
