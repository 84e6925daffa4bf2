// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Constraints as a paper writes them: the circles that touch three circles, where a curve meets itself, and where a
// planet is at a given time.
#include <CGAL/Spline_constraints_d.h>

#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using Spline = SC::Bspline_function<Number>;

// A spline of degree 2 with four pieces that begin at 0, 1, 2 and 3.
Spline spline(const std::vector<Number>& control_points)
{
  return Spline({2}, {{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}}, control_points);
}

// The four quarters of a circle are rational quadratic curves, from (1,0) to (0,1) for example ((1-t^2)/(1+t^2),
// 2t/(1+t^2)).
SC::Spline_map<1, 2> circle(int x, int y, int radius)
{
  const Spline weight = spline({1, 1, 2, 1, 1, 1, 2, 1, 1});
  const Spline cosine = spline({1, 1, 0, -1, -1, -1, 0, 1, 1});
  const Spline sine = spline({0, 1, 2, 1, 0, -1, -2, -1, 0});
  return SC::Spline_map<1, 2>(
      {cosine * Number(radius) + weight * Number(x), sine * Number(radius) + weight * Number(y)}, weight);
}

// Circles that touch three curves. Their centers are at equal distances from points of the curves (two linear
// equations, which Cramer's rule solves) and on the normals there.
bool touch_three_curves()
{
  const auto c1 = circle(0, 0, 1), c2 = circle(5, 0, 2), c3 = circle(1, 6, 1);
  auto [u, v, w] = SC::parameters(c1, c2, c3);
  const auto center = meet(equidistant_hyperplane(c1(u), c2(v)), equidistant_hyperplane(c1(u), c3(w)));
  const auto solutions = SC::solve(dot(center - c1(u), derivative(c1)(u)) == 0,
                                   dot(center - c2(v), derivative(c2)(v)) == 0,
                                   dot(center - c3(w), derivative(c3)(w)) == 0);
  for (const auto& solution : solutions) {
    std::vector<Number> contact;   // in the middle of the box that is proved to hold the solution
    for (const auto& [lower, upper] : solution.exact_box())
      contact.push_back((lower + upper) / 2);
    const auto p = center(contact);
    std::cout << solution.kind() << ": center (" << CGAL::to_double(p[0]) << ", " << CGAL::to_double(p[1]) << ")\n";
  }
  return solutions.is_complete() && solutions.size() == 8;
}

// Where a cubic curve meets itself: c(u) = c(v) without the solutions u = v, a factor that is divided out.
bool meet_itself()
{
  const SC::Spline_map<1, 2> c(
      {Spline({3}, {{0, 0, 0, 0, 1, 1, 1, 1}}, {0, 4, -3, 1}), Spline({3}, {{0, 0, 0, 0, 1, 1, 1, 1}}, {0, 2, 2, 0})});
  auto [u, v] = SC::parameters(c, c);
  const auto chord = divided_exactly(c(u) - c(v), u - v);
  const auto solutions = SC::solve(chord.x() == 0, chord.y() == 0, u < v);
  for (const auto& solution : solutions)
    std::cout << solution.kind() << ": parameters in [" << solution[0].first << ", " << solution[0].second << "] and ["
              << solution[1].first << ", " << solution[1].second << "]\n";
  return solutions.is_complete() && solutions.size() == 1;
}

// A third of a year after it was next to the sun, on an ellipse of eccentricity 3/5: Kepler's equation for the
// eccentric anomaly, and the angle at the sun.
bool follow_planet()
{
  auto [anomaly, angle] = SC::unknowns({0, 7}, {0, 3});
  const std::vector<SC::Constraint> constraints{anomaly - Number(3, 5) * sin(anomaly) == 2 * SC::Expression::pi() / 3,
                                                tan(angle / 2) == 2 * tan(anomaly / 2)};
  const auto solutions = SC::solve(constraints);
  for (const auto& solution : solutions)
    std::cout << solution.kind() << ": eccentric anomaly " << solution.point()[0] << ", angle " << solution.point()[1]
              << (SC::verify(constraints, solution) ? ", verified\n" : "\n");
  return solutions.is_complete() && solutions.size() == 1;
}

int main()
{
  const bool have_touched = touch_three_curves(), has_met_itself = meet_itself(), is_followed = follow_planet();
  return have_touched && has_met_itself && is_followed ? 0 : 1;
}
