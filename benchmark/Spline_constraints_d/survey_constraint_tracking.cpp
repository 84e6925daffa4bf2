// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What gradients of random graphs cost, and what it costs to follow a moving target with the hand of an arm of 2 to 16
// links, or to go through the folded position of one. The exit status is 1 when a gradient takes more than the theorem
// of Baur and Strassen allows, or a target is lost.
#include "linked_arm.h"
#include "random_graphs.h"

#include <CGAL/Spline_constraints_d/function/constraint_idioms.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <random>
#include <vector>

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Operation_count;

bool survey_gradients(int unknowns, int steps)
{
  std::mt19937 random(static_cast<unsigned>(unknowns * 1000 + steps));
  constexpr int graphs = 1000;
  double sum = 0, largest = 0, sum_of_products = 0, largest_of_products = 0;
  std::size_t operations = 0;
  for (int run = 0; run < graphs; ++run) {
    SC::Expression_graph graph(unknowns);
    std::vector<random_graphs::Random_formula> formulas;
    for (int i = 0; i < unknowns; ++i)
      formulas.push_back({graph.unknown(i), 0, 1});
    while (formulas.size() < static_cast<std::size_t>(unknowns + steps) ||
           graph.operations(formulas.back().node).multiplications == 0)
      formulas.push_back(random_graphs::random_formula(formulas, 1 << 20, false, random));
    auto nodes = graph.gradient(formulas.back().node);
    nodes.push_back(formulas.back().node);
    const Operation_count own = graph.operations(nodes.back()), all = graph.operations(nodes);
    const double ratio = 1. * all.total() / own.total(), of_products = 1. * all.multiplications / own.multiplications;
    operations += own.total();
    sum += ratio;
    largest = (std::max)(largest, ratio);
    sum_of_products += of_products;
    largest_of_products = (std::max)(largest_of_products, of_products);
  }
  std::cout << unknowns << " unknowns, " << 1. * operations / graphs << " operations: T(G')/T(G) " << sum / graphs
            << ", at most " << largest << "; of products and quotients " << sum_of_products / graphs << ", at most "
            << largest_of_products << '\n';
  return largest < 5 && largest_of_products <= 3;
}

bool survey_arm(int links)
{
  constexpr int times = 1000;
  const linked_arm::Arm arm(links);
  SC::Constraint_tracker tracker(arm.joints.back(), std::vector<Exact_rational>(links + 1, Exact_rational(1) / 10),
                                 {.is_search_allowed = false});
  arm.link(tracker);
  const SC::Expression& t = arm.time();
  tracker.add(
      SC::toleranced_move(arm.end(), SC::Vector_expression(links * (1 - t) / 2, 1 + t), Exact_rational(1) / 50));
  tracker.advance(0);
  std::size_t steps = 0;
  int held = 0, repaired = 0;
  Operation_count values, gradients, violated;
  const auto start = std::chrono::steady_clock::now();
  for (int k = 1; k <= times; ++k) {
    const SC::Tracking_step step = tracker.advance(Exact_rational(k) / times);
    steps += step.path.empty() ? 0 : step.path.size() - 1;
    values += step.values;
    gradients += step.gradients;
    violated += step.violated;
    held += step.status == SC::Tracking_status::HELD;
    repaired += step.status == SC::Tracking_status::REPAIRED;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << links << " links: check " << tracker.operations_of_check().total() << " operations; " << held
            << " held, " << repaired << " repaired of " << times << "; per time " << 1. * steps / times << " steps, V "
            << 1. * values.total() / times << ", U " << 1. * gradients.total() / times << ", U / sum c "
            << 1. * gradients.multiplications / violated.multiplications << " (products), "
            << 1. * gradients.total() / violated.total() << " (all), " << 1e6 * seconds / times << " us\n";
  return held + repaired == times;
}

// Through the position in which an arm of two links is folded, in a tube around a line.
bool survey_folding(int width, int times)
{
  const auto [a, b, t] = SC::unknowns({0, 4}, {-1, 1}, {0, 2});
  const auto elbow = linked_arm::direction(a), end = elbow - linked_arm::turned(elbow, linked_arm::direction(b));
  const auto hand = SC::unknowns({{-2, 2}, {-2, 2}, {0, 2}});
  SC::Constraint_tracker tracker(t, {Exact_rational(4) / 7, Exact_rational(4) / 7, 0});
  tracker.link(hand, {end[0], end[1], t});
  tracker.add(SC::interval(width * hand[1], -1, 1));
  tracker.add(SC::pusher(hand[0], 1, 1, hand[2]));
  std::size_t steps = 0, most = 0;
  int held = 0, repaired = 0;
  for (int k = 0; k <= times; ++k) {
    const SC::Tracking_step step = tracker.advance(Exact_rational(2 * k) / times);
    const std::size_t own = step.path.empty() ? 0 : step.path.size() - 1;
    steps += own;
    most = (std::max)(most, own);
    held += step.status == SC::Tracking_status::HELD;
    repaired += step.status == SC::Tracking_status::REPAIRED;
  }
  std::cout << "folded within 1/" << width << ", " << times + 1 << " times: " << held << " held, " << repaired
            << " repaired; " << 1. * steps / (times + 1) << " steps per time, at most " << most << '\n';
  return held + repaired == times + 1;
}

} // namespace

int main()
{
  bool is_right = true;
  for (const int unknowns : {1, 4, 16, 64})
    for (const int steps : {50, 500})
      is_right = survey_gradients(unknowns, steps) && is_right;
  for (const int links : {2, 4, 8, 16})
    is_right = survey_arm(links) && is_right;
  for (const int width : {20, 200, 2000})
    for (const int times : {40, 400, 4000})
      is_right = survey_folding(width, times) && is_right;
  return is_right ? 0 : 1;
}
