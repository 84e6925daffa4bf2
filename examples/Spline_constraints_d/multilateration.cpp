// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a receiver is whose clock is wrong: the distances to three stations, close to each other in a large box, are
// all measured with one unknown error. The differences of the equations are linear, so that they are decomposed to one
// equation in one unknown; the nodes are printed beside those of the system as it is.
//
// Writes multilateration.svg: the stations with the measured distances, grey circles, and the true ones, which meet in
// the receiver. Exit status: 0 when the answers agree and are complete, else 3.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/solver.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  const std::array<K::Point_2, 3> stations{K::Point_2(0, 0), K::Point_2(6, 1), K::Point_2(1, 5)};
  const std::array<double, 3> measured{6.25, 4.75, 5};

  auto [x, y, error] = SC::unknowns({-1000, 1000}, {-1000, 1000}, {-1000, 1000});
  std::vector<SC::Constraint> constraints;
  for (int i = 0; i < 3; ++i) {
    constraints.push_back(square(x - stations[i].x()) + square(y - stations[i].y()) == square(measured[i] - error));
    constraints.push_back(measured[i] > error);
  }
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const auto solutions = SC::solve(system), whole = SC::Subdivision_solver_d<>()(system);

  std::cout.precision(16);
  for (const auto& s : solutions)
    std::cout << s.kind() << ": x in [" << s[0].first << ", " << s[0].second << "], y in [" << s[1].first << ", "
              << s[1].second << "], error in [" << s[2].first << ", " << s[2].second << "]\n";
  std::cout << solutions.summary().nodes << " nodes; as a whole " << whole.summary().nodes << '\n';
  if (solutions.size() != 1 || whole.size() != 1 || !solutions.is_complete() || !whole.is_complete())
    return 3;

  std::ofstream file("multilateration.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-7, -7, 12, 11), 600);
  const std::vector<double> place = solutions[0].point();
  const K::Point_2 receiver(place[0], place[1]);
  const std::array<const char*, 3> colors{"#1f77b4", "#2ca02c", "#ff7f0e"};
  for (int i = 0; i < 3; ++i) {
    picture.circle(stations[i], measured[i], "#bbb", 1);
    picture.circle(stations[i], measured[i] - place[2], colors[i], 2.5);
    picture.polyline(std::vector<K::Point_2>{stations[i], receiver}, colors[i], 1);
    picture.point(stations[i], colors[i], 8);
  }
  picture.point(receiver, "#d62728", 10);
  picture.label(K::Point_2(receiver.x() + 1, receiver.y() + 1.6), "receiver", "#d62728", 16);
}
