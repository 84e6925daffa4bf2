// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*
soak_solver [count = 10000] [first seed = 1] [seconds per exact run = 0.5]

Solves random systems, one per seed, with Certified_solver_traits and with Exact_solver_traits, and compares the
answers. A root that one of them certifies is the same as one of the other, or it meets a box that the other one leaves
undecided or reports as a cluster. Runs that reach their limit leave the rest of the domain undecided; they are compared
all the same, and counted. Prints

- matched: roots that both certified;
- lost: planted solutions, and roots that only Exact_solver_traits certified, for which Certified_solver_traits has no
  answer at all;
- extra: the other way round, and answers that count one root twice;
- the roots that one certified and the other left open, the answers that verify() did not prove, the runs that reached a
  limit;

after every 1000 systems and at the end, and the seeds of systems with lost or extra roots or answers that were not
proved. The exit status is 0 when there are none, else 1.
*/

#include "soak_systems.h"

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <utility>
#include <vector>

using namespace solver_benchmark;
using Solution_kind = SC::Solution_kind;
using Box = std::vector<std::pair<Rational, Rational>>;

struct Answer
{
  bool is_certified;
  Box box, region;
};

struct Run
{
  std::vector<Answer> answers;
  bool is_limited;
};

struct Counts
{
  std::size_t systems = 0, planted = 0, matched = 0, lost = 0, extra = 0, open_in_certified = 0, open_in_exact = 0,
              unproved = 0;
  std::size_t certified_limited = 0, exact_limited = 0, certified_incomplete = 0, exact_incomplete = 0;
};

static bool meet(const Box& a, const Box& b)
{
  for (std::size_t j = 0; j < a.size(); ++j)
    if (a[j].second < b[j].first || b[j].second < a[j].first)
      return false;
  return true;
}

static bool is_inside(const Box& inner, const Box& outer)
{
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].first < outer[j].first || outer[j].second < inner[j].second)
      return false;
  return true;
}

// Both boxes hold the same root of the equalities: each holds one, and the region of one of them, in which there is no
// other, holds the other box.
static bool have_same_root(const Answer& a, const Answer& b)
{
  return a.is_certified && b.is_certified && meet(a.box, b.box) &&
      (is_inside(b.box, a.region) || is_inside(a.box, b.region));
}

template <class Traits>
static Run solved(const Soak_system& problem, double seconds, Counts& counts, std::size_t& incomplete)
{
  const auto solutions = SC::Subdivision_solver_d<Traits>({.time_limit = seconds})(problem.system);
  Run run{{}, solutions.summary().why_not == SC::Undecided_reason::TIME};
  incomplete += !solutions.is_complete();
  for (const auto& solution : solutions) {
    run.answers.push_back({solution.is_certified(), solution.exact_box(), solution.exact_uniqueness_region()});
    counts.unproved += solution.kind() != Solution_kind::UNDECIDED && !verify(problem.system, solution);
  }
  return run;
}

// Looks for the certified roots of one run in another.
struct Comparison
{
  std::size_t matched = 0, open = 0, missing = 0, doubled = 0;

  Comparison(const Run& run, const Run& other)
  {
    for (const Answer& answer : run.answers) {
      if (!answer.is_certified)
        continue;
      const auto same = std::count_if(other.answers.begin(), other.answers.end(),
                                      [&](const Answer& a) { return have_same_root(answer, a); });
      const bool is_met = std::any_of(other.answers.begin(), other.answers.end(),
                                      [&](const Answer& a) { return meet(answer.box, a.box); });
      matched += same == 1;
      doubled += same > 1;
      open += same == 0 && is_met;
      missing += same == 0 && !is_met;
    }
  }
};

static std::size_t count_lost(const std::vector<Point>& planted, const Run& run)
{
  return std::count_if(planted.begin(), planted.end(), [&](const Point& point) {
    Box box;
    for (const Coordinate& c : point)
      box.emplace_back(c.lower, c.upper);
    return std::none_of(run.answers.begin(), run.answers.end(),
                        [&](const Answer& answer) { return meet(answer.box, box); });
  });
}

static void compare(std::uint64_t seed, double seconds, Counts& counts)
{
  constexpr double seconds_certified = 5;
  const Soak_system problem = Soak_systems(seed).make();
  const std::size_t unproved_before = counts.unproved;
  const Run certified =
      solved<SC::Certified_solver_traits>(problem, seconds_certified, counts, counts.certified_incomplete);
  const Run exact = solved<SC::Exact_solver_traits>(problem, seconds, counts, counts.exact_incomplete);
  const Comparison forth(certified, exact), back(exact, certified);
  const std::size_t lost = back.missing + count_lost(problem.planted, certified);
  const std::size_t extra = forth.missing + forth.doubled + back.doubled + count_lost(problem.planted, exact);
  ++counts.systems;
  counts.planted += problem.planted.size();
  counts.matched += forth.matched;
  counts.lost += lost;
  counts.extra += extra;
  counts.open_in_exact += forth.open;
  counts.open_in_certified += back.open;
  counts.certified_limited += certified.is_limited;
  counts.exact_limited += exact.is_limited;
  if (const std::size_t unproved = counts.unproved - unproved_before; lost + extra + unproved > 0)
    std::cout << "seed " << seed << " (" << problem.name << ", " << problem.system.dimension() << " unknowns): " << lost
              << " lost, " << extra << " extra, " << unproved << " not proved" << std::endl;
}

static void print(const Counts& counts)
{
  std::cout << counts.systems << " systems, " << counts.planted << " planted solutions\n"
            << "matched: " << counts.matched << "\nlost: " << counts.lost << "\nextra: " << counts.extra
            << "\nopen in certified: " << counts.open_in_certified << "\nopen in exact: " << counts.open_in_exact
            << "\nnot proved by verify(): " << counts.unproved
            << "\nincomplete, certified: " << counts.certified_incomplete << " (" << counts.certified_limited
            << " at the time limit)\nincomplete, exact: " << counts.exact_incomplete << " (" << counts.exact_limited
            << " at the time limit)" << std::endl;
}

int main(int count_of_arguments, char** arguments)
{
  const std::uint64_t count = count_of_arguments > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10000;
  const std::uint64_t first = count_of_arguments > 2 ? std::strtoull(arguments[2], nullptr, 10) : 1;
  const double seconds = count_of_arguments > 3 ? std::strtod(arguments[3], nullptr) : 0.5;
  Counts counts;
  for (std::uint64_t seed = first; seed < first + count; ++seed) {
    compare(seed, seconds, counts);
    if (counts.systems % 1000 == 0 || counts.systems == count)
      print(counts);
  }
  return counts.systems > 0 && counts.lost == 0 && counts.extra == 0 ? 0 : 1;
}
