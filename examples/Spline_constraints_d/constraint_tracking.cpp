// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Motions that are described by what they must satisfy, and no more. An arm with two links moves its hand along a
// narrow tube, through the position in which it is folded and its hand cannot be moved in all directions; then it puts
// something on a table, around a post. Constraints are on the position of the hand; the tracker finds joints. Every
// position is rational and satisfies all constraints exactly. Both are drawn into constraint_tracking.svg.

#include <CGAL/Spline_constraints_d/function/constraint_idioms.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_tracker.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Point = std::vector<SC::Exact_rational>;
using Place = std::array<double, 2>;

// Both links have the length 1; joints are tangents of half angles.
SC::Vector_expression<2> direction(const SC::Expression& half)
{
  return {(1 - half * half) / (1 + half * half), 2 * half / (1 + half * half)};
}
SC::Vector_expression<2> turned(const SC::Vector_expression<2>& a, const SC::Vector_expression<2>& b)
{
  return {a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]};
}

struct Motion
{
  std::vector<Place> elbows, hands;
  std::vector<double> times; // from 0 to 1
  int held = 0, repaired = 0, others = 0;
  std::size_t steps = 0, operations = 0;
};

// Positions at equal steps of time.
Motion follow(SC::Constraint_tracker& tracker, int count, double end, const SC::Vector_expression<2>& elbow,
              const SC::Vector_expression<2>& hand)
{
  Motion motion;
  const auto place = [](const std::array<SC::Exact_rational, 2>& p) {
    return Place{CGAL::to_double(p[0]), CGAL::to_double(p[1])};
  };
  for (int k = 0; k <= count; ++k) {
    const SC::Tracking_step step = tracker.advance(end * k / count);
    ++(step.status == SC::Tracking_status::HELD           ? motion.held
           : step.status == SC::Tracking_status::REPAIRED ? motion.repaired
                                                          : motion.others);
    motion.steps += step.path.empty() ? 0 : step.path.size() - 1;
    motion.operations += step.values.total() + step.gradients.total();
    if (!step.has_point()) {
      std::cout << step << '\n';
      continue;
    }
    motion.elbows.push_back(place(elbow(step.point)));
    motion.hands.push_back(place(hand(step.point)));
    motion.times.push_back(1. * k / count);
  }
  std::cout << motion.held << " held, " << motion.repaired << " repaired, " << motion.others << " others; "
            << motion.steps << " steps of the relaxation, " << motion.operations << " operations\n";
  return motion;
}

// Units of 150.
std::string at(const Place& p) { return std::to_string(150 * p[0]) + ',' + std::to_string(-150 * p[1]); }

std::string color(double time)
{
  const auto part = [&](int first, int last) { return std::to_string(std::lround(first + time * (last - first))); };
  return "rgb(" + part(28, 208) + ',' + part(95, 64) + ',' + part(190, 20) + ')';
}

void draw(std::ostream& out, const Motion& motion, int arms)
{
  const auto polyline = [&](const std::vector<Place>& places, const std::string& style) {
    out << "<polyline fill=\"none\" " << style << " points=\"";
    for (const Place& p : places)
      out << at(p) << ' ';
    out << "\"/>\n";
  };
  polyline(motion.elbows, "stroke=\"#8a94a0\" stroke-width=\"1.5\" stroke-dasharray=\"5 3\"");
  const int last = static_cast<int>(motion.hands.size()) - 1;
  for (int k = 0; k <= arms && last >= 0; ++k) {
    const int i = last * k / arms;
    const bool is_end = k == 0 || k == arms;
    polyline({{0, 0}, motion.elbows[i], motion.hands[i]},
             "stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\"" + std::string(is_end ? "5" : "2.2") +
                 "\" stroke=\"" + color(motion.times[i]) + '"');
    out << "<circle r=\"3.5\" fill=\"#ffffff\" stroke=\"#334455\" transform=\"translate(" << at(motion.elbows[i])
        << ")\"/>\n";
  }
  for (int i = 0; i <= last; ++i)
    out << "<circle r=\"3\" fill=\"" << color(motion.times[i]) << "\" transform=\"translate(" << at(motion.hands[i])
        << ")\"/>\n";
  out << "<circle r=\"7\" fill=\"#334455\"/>\n";
}

std::string text(double x, double y, const std::string& words)
{
  return "<text font-size=\"15\" fill=\"#334455\" transform=\"translate(" + at({x, y}) + ")\">" + words + "</text>\n";
}

int main()
{
  std::ofstream out("constraint_tracking.svg");
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-185 -300 800 340\" width=\"800\" height=\"340\">\n"
      << "<rect x=\"-185\" y=\"-300\" width=\"800\" height=\"340\" fill=\"#ffffff\"/>\n";

  // The second joint is measured from the folded arm on. The hand stays in the tube and is pushed from 1 to -1.
  const auto [a, b, t] = SC::unknowns({0, 4}, {-1, 1}, {0, 2});
  const SC::Vector_expression<2> elbow = direction(a), end = elbow - turned(elbow, direction(b));
  const auto hand = SC::unknowns({{-2, 2}, {-2, 2}, {0, 2}});
  SC::Constraint_tracker tube(t, {0.57, 0.57, 0});
  tube.link(hand, {end[0], end[1], t});
  tube.add(SC::interval(hand[1], -0.05, 0.05));
  tube.add(SC::pusher(hand[0], 1, 1, hand[2]));
  std::cout << "tube: " << tube.operations_of_check() << " for all constraints\n  ";
  const Motion folded = follow(tube, 40, 2, elbow, end);
  out << "<rect x=\"-185\" y=\"-7.5\" width=\"370\" height=\"15\" fill=\"#bfe3c8\"/>\n";
  draw(out, folded, 12);
  out << text(-1.1, 1.8, "along a tube, folded on the way: |y| ≤ 1/20") << text(0.9, -0.22, "t = 0")
      << text(-1.1, -0.22, "t = 2");

  // Farther than the second joint lets it.
  tube.add(hand[0] <= -1.5);
  const SC::Tracking_step none = tube.advance(2);
  std::cout << "  and farther: " << none.status << '\n';

  // A lid comes down over a table; a cone leads to its middle; a post is in the way.
  const auto [c, d, s] = SC::unknowns({-1, 4}, {-4, 0}, {0, 1});
  const SC::Vector_expression<2> joint = direction(c), tool = joint + turned(joint, direction(d));
  const auto place = SC::unknowns({{-2, 2}, {-2, 2}, {0, 1}});
  const SC::Expression &x = place[0], &y = place[1];
  SC::Constraint_tracker table(s, {1.4, -0.7, 0});
  table.link(place, {tool[0], tool[1], s});
  table.add(y >= 0.25);
  table.add(SC::pusher(y, 1.5, 1.2, place[2]));
  table.add(SC::interval(x, 1.2 - 0.75 * (y - 0.2), 1.2 + 0.5 * (y - 0.2)));
  table.add(SC::obstacle(square(x - 1) + square(y - 0.9) < 0.04));
  std::cout << "table: " << table.operations_of_check() << " for all constraints\n  ";
  const Motion put = follow(table, 40, 1, joint, tool);
  out << "<g transform=\"translate(270,0)\">\n<polygon fill=\"#bfe3c8\" points=\"" << at({1.1625, 0.25}) << ' '
      << at({1.225, 0.25}) << ' ' << at({1.85, 1.5}) << ' ' << at({0.225, 1.5}) << "\"/>\n"
      << "<rect x=\"120\" y=\"-30\" width=\"140\" height=\"8\" fill=\"#8a6f4d\"/>\n"
      << "<path stroke=\"#8a6f4d\" stroke-width=\"6\" d=\"M135,-26V20M245,-26V20\"/>\n"
      << "<circle cx=\"150\" cy=\"-135\" r=\"30\" fill=\"#f0b0a0\" stroke=\"#b03020\"/>\n";
  draw(out, put, 10);
  if (!put.hands.empty())
    out << "<rect x=\"-11\" y=\"-7\" width=\"22\" height=\"14\" fill=\"none\" stroke=\"#b03020\" stroke-width=\"2\" "
        << "transform=\"translate(" << at(put.hands.back()) << ")\"/>\n";
  out << text(0, 1.8, "down a cone, around a post") << text(0.6, 1.55, "t = 0") << text(1.32, 0.3, "t = 1")
      << "</g>\n</svg>\n";
  return folded.others + put.others == 0 && none.status == SC::Tracking_status::INFEASIBLE ? 0 : 3;
}
