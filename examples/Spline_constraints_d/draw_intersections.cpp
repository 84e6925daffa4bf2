// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Draws the curves y = T(x) and x = T(y), T the Chebyshev polynomial of degree 6, with their 36 intersections and,
// around each of them, a box that is proved to hold no other, into draw_intersections.svg.
#include <CGAL/Spline_constraints_d.h>

#include <cmath>
#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;

constexpr int degree = 6, steps = 12 * degree;
// the domain [-1,1]^2 is `size` wide, its centre is the origin
constexpr double size = 400, pi = 3.14159265358979323846;

SC::Expression chebyshev(const SC::Expression& x)
{
  SC::Expression previous(1), current = x;
  for (int d = 1; d < degree; ++d) {
    const SC::Expression next = 2*x*current - previous;
    previous = current;
    current = next;
  }
  return current;
}

// The curve (cos a, cos 6a) as a smooth path of cubic arcs: points and tangents every pi / steps.
void write_curve(std::ostream& out, const char* style, bool is_mirrored)
{
  const auto point = [&](double a, double forward) {
    const double h = forward * pi / (3 * steps);
    const double u = std::cos(a) - h * std::sin(a), v = std::cos(degree * a) - h * degree * std::sin(degree * a);
    out << size / 2 * (is_mirrored ? v : u) << ' ' << -size / 2 * (is_mirrored ? u : v) << ' ';
  };
  out << "<path class='" << style << "' d='M";
  point(0, 0);
  for (int i = 0; i < steps; ++i) {
    out << (i == 0 ? "C" : "");
    point(pi * i / steps, 1);
    point(pi * (i + 1) / steps, -1);
    point(pi * (i + 1) / steps, 0);
  }
  out << "'/>\n";
}

int main()
{
  auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
  const auto solutions = SC::solve(chebyshev(x) == y, chebyshev(y) == x);
  const std::size_t count = solutions.count(SC::Solution_kind::CERTIFIED);
  const char* complete = solutions.is_complete() ? "yes" : "no";

  std::ofstream out("draw_intersections.svg");
  out.precision(5);
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-212 -212 424 480' width='636' height='720'>\n<style>"
         "path { fill: none; stroke-width: 1.6 } .a { stroke: #1f77b4 } .b { stroke: #d9822b } .domain { fill: "
         "#fcfcfd; stroke: #99a; stroke-width: 0.8 }"
         " .region { fill: #2ca02c; fill-opacity: 0.16; stroke: #2ca02c; stroke-opacity: 0.55; stroke-width: 0.5 } "
         ".root { fill: #111 }"
         " text { font: 13px sans-serif; fill: #223 }</style>\n<rect x='-212' y='-212' width='424' height='480' "
         "fill='white'/>\n"
         "<rect class='domain' x='-200' y='-200' width='400' height='400'/>\n";
  for (const auto& s : solutions) {
    const auto &u = s.uniqueness_region()[0], &v = s.uniqueness_region()[1];
    out << "<rect class='region' x='" << size / 2 * u.first << "' y='" << -size / 2 * v.second << "' width='"
        << size / 2 * (u.second - u.first) << "' height='" << size / 2 * (v.second - v.first) << "'/>\n";
  }
  write_curve(out, "a", false);
  write_curve(out, "b", true);
  for (const auto& s : solutions)
    out << "<circle class='root' cx='" << size / 2 * s.point()[0] << "' cy='" << -size / 2 * s.point()[1]
        << "' r='2.6'/>\n";
  out << "<path class='a' d='M-200 226h22'/><text x='-170' y='230'>y = T(x)</text><path class='b' d='M-200 "
         "248h22'/><text x='-170' y='252'>x = T(y)</text>\n"
         "<circle class='root' cx='-33' cy='226' r='2.6'/><text x='-16' y='230'>"
      << count << " certified roots, complete: " << complete
      << "</text>\n<rect class='region' x='-40' y='241' width='14' height='14'/><text x='-16' y='252'>holds no other "
         "root</text>\n</svg>\n";
  std::cout << count << " certified roots, complete: " << complete << ", drawn into draw_intersections.svg\n";
  return out && count == degree * degree && solutions.is_complete() ? 0 : 1;
}
