// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Can all of these constraints be satisfied? Once with a point, which relaxation finds and exact signs check; once with
// a proof that there is none: boxes that cover the domain, each with a combination of the constraints that is positive
// on it. Both are drawn into feasible_points.svg.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;

// The square [-2,2]^2 as 300 x 300 units.
std::string place(double x, double y) { return std::to_string(75 * (x + 2)) + ',' + std::to_string(75 * (2 - y)); }

template <class Curve>
void draw(std::ostream& out, const Curve& curve, const std::string& style)
{
  out << "<polyline " << style << " points=\"";
  for (int k = 0; k <= 200; ++k) {
    const auto [x, y] = curve(k / 200.);
    out << place(x, y) << ' ';
  }
  out << "\"/>\n";
}

// Covers what does not satisfy an inequality by rows of strips.
template <class Holds>
void shade(std::ostream& out, const Holds& holds)
{
  constexpr int strips = 150;
  const auto is_in = [&](int row, int k) { return holds((k + 0.5) * 4 / strips - 2, 2 - (row + 0.5) * 4 / strips); };
  out << "<path fill=\"#33445522\" d=\"";
  for (int row = 0; row < strips; ++row)
    for (int begin = 0, end = 0; begin < strips; begin = end) {
      for (end = begin + 1; end < strips && is_in(row, end) == is_in(row, begin); ++end) {
      }
      if (!is_in(row, begin))
        out << 'M' << 2 * begin << ',' << 2 * row << 'h' << 2 * (end - begin) << "v2h" << 2 * (begin - end) << 'z';
    }
  out << "\"/>\n";
}

int main()
{
  const auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const std::string line = "fill=\"none\" stroke=\"#334455\"", text = "<text x=\"0\" y=\"322\" font-size=\"17\">";
  constexpr double pi = 3.14159265358979;
  std::ofstream out("feasible_points.svg");
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4 -4 658 338\" width=\"658\" height=\"338\">\n"
      << "<clipPath id=\"square\"><rect width=\"300\" height=\"300\"/></clipPath>\n<g clip-path=\"url(#square)\">\n"
      << "<rect width=\"300\" height=\"300\" fill=\"#ffffff\"/>\n";

  const SC::Feasibility_d point = SC::find_feasible_point(square(x) + square(y) >= 1, square(x) + square(y - 1) <= 2,
                                                          y <= 1 - square(x - 1), 5 * x * (y + 1) >= 7);
  std::cout << "four regions: " << point << "\n  by " << point.certificate() << '\n';
  shade(out, [](double u, double v) { return u * u + v * v >= 1; });
  shade(out, [](double u, double v) { return u * u + (v - 1) * (v - 1) <= 2; });
  shade(out, [](double u, double v) { return v <= 1 - (u - 1) * (u - 1); });
  shade(out, [](double u, double v) { return 5 * u * (v + 1) >= 7; });
  const auto circle = [&](double r, double height) {
    return [=](double t) { return std::pair(r * std::cos(2 * pi * t), height + r * std::sin(2 * pi * t)); };
  };
  draw(out, circle(1, 0), line);
  draw(out, circle(std::sqrt(2.), 1), line);
  const auto parabola = [](double t) { return std::pair(4 * t - 2, 1 - (4 * t - 3) * (4 * t - 3)); };
  const auto hyperbola = [](double sign) {
    return [=](double t) { return std::pair(sign * (0.4 + 2 * t), sign * 1.4 / (0.4 + 2 * t) - 1); };
  };
  draw(out, parabola, line);
  draw(out, hyperbola(1), line);
  draw(out, hyperbola(-1), line);
  out << "<polyline fill=\"none\" stroke=\"#c00020\" stroke-width=\"2.5\" points=\"";
  for (const std::vector<double>& step : point.path())
    out << place(step[0], step[1]) << ' ';
  out << "\"/>\n";
  for (const std::vector<double>& step : point.path())
    out << "<circle r=\"3\" fill=\"#c00020\" transform=\"translate(" << place(step[0], step[1]) << ")\"/>\n";
  if (point.has_point())
    out << "<circle r=\"7\" fill=\"#008040\" stroke=\"#ffffff\" stroke-width=\"2\" transform=\"translate("
        << place(CGAL::to_double(point.point()[0]), CGAL::to_double(point.point()[1])) << ")\"/>\n";
  out << "</g>\n<rect width=\"300\" height=\"300\" " << line << "/>\n" << text << "feasible: a point</text>\n";

  // Outside of a circle and inside of a rounded square that does not reach it.
  const SC::Feasibility_d none = SC::find_feasible_point(square(x) + square(y) >= 4, pow(x, 4) + pow(y, 4) <= 6);
  std::cout << "circle and rounded square: " << none << "\n  in " << none.excluded().size() << " boxes\n";
  out << "<g transform=\"translate(350,0)\">\n<rect width=\"300\" height=\"300\" fill=\"#ffffff\"/>\n";
  for (const auto& part : none.excluded()) {
    const bool is_inside = part.multipliers[0] != 0, is_outside = part.multipliers[1] != 0;
    const auto [x0, x1] = part.place[0];
    const auto [y0, y1] = part.place[1];
    out << "<rect stroke=\"#ffffff\" fill=\""
        << (is_inside && is_outside ? "#b79ad6"
                : is_inside         ? "#9fc5e8"
                                    : "#f9cb9c")
        << "\" x=\"" << 75 * (x0 + 2) << "\" y=\"" << 75 * (2 - y1) << "\" width=\"" << 75 * (x1 - x0) << "\" height=\""
        << 75 * (y1 - y0) << "\"/>\n";
  }
  const std::string bold = "fill=\"none\" stroke-width=\"2.5\" stroke=";
  draw(out, circle(2, 0), bold + "\"#1c5fa8\"");
  const auto rounded = [](double t) { return std::copysign(std::pow(6, 0.25) * std::sqrt(std::abs(t)), t); };
  draw(
      out, [&](double t) { return std::pair(rounded(std::cos(2 * pi * t)), rounded(std::sin(2 * pi * t))); },
      bold + "\"#d06000\"");
  out << text << "infeasible: " << none.excluded().size() << " boxes with proofs</text>\n</g>\n</svg>\n";
  return point.is_feasible() && none.is_infeasible() ? 0 : 3;
}
