// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All circles that touch three curves, drawn into tangent_circles.svg, and the eight that touch three circles, into
// circles_of_apollonius.svg; those without a point of the curves inside are bold.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/tangent_circles_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;

constexpr double scale = 32;

void write_curve(std::ostream& out, const Curve& curve)
{
  constexpr int steps = 120;
  const auto [begin, end] = curve.domain();
  out << "<path class='curve' d='";
  for (int i = 0; i <= steps; ++i) {
    const K::Point_2 p = curve(begin + (end - begin) * i / steps);
    out << (i == 0 ? 'M' : 'L') << scale * CGAL::to_double(p.x()) << ' ' << -scale * CGAL::to_double(p.y()) << ' ';
  }
  out << "'/>\n";
}

// Finds and draws them; to the left and right, above and below the origin the picture shows as much as given. The
// numbers of all circles and of empty ones, if they are proved.
std::array<std::size_t, 2> draw(const std::vector<Curve>& curves, const std::string& path, int width, int height)
{
  const auto result = SC::tangent_circles(curves[0], curves[1], curves[2]);
  std::ofstream out(path);
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='" << -width << ' ' << -height << ' ' << 2 * width << ' '
      << 2 * height << "' width='" << 5 * width / 2 << "' height='" << 5 * height / 2
      << "'>\n<style>.curve "
         "{ fill: none; stroke: #1f77b4; stroke-width: 4 }"
         " .touching { fill: none; stroke: #999; stroke-width: 1 } .empty { fill: #d62728; fill-opacity: 0.08; stroke: "
         "#d62728; stroke-width: 3 }"
         " .contact { fill: #222 } text { font: 13px sans-serif; fill: #223 }</style>\n<rect x='"
      << -width << "' y='" << -height << "' width='" << 2 * width << "' height='" << 2 * height << "' fill='white'/>\n";
  for (const auto emptiness : {SC::Emptiness::NOT_EMPTY, SC::Emptiness::UNDECIDED, SC::Emptiness::EMPTY})
    for (const auto& circle : result.circles())
      if (circle.emptiness() == emptiness) {
        std::cout << circle.solution().kind() << ", " << emptiness << ": center (" << circle.center(0).value() << ", "
                  << circle.center(1).value() << "), radius " << circle.radius().value() << '\n';
        out << "<circle class='" << (emptiness == SC::Emptiness::EMPTY ? "empty" : "touching") << "' cx='"
            << scale * circle.center(0).value() << "' cy='" << -scale * circle.center(1).value() << "' r='"
            << scale * circle.radius().value() << "'/>\n";
      }
  for (const Curve& curve : curves)
    write_curve(out, curve);
  for (const auto& circle : result.circles())
    if (circle.emptiness() == SC::Emptiness::EMPTY)
      for (std::size_t i = 0; i < 3; ++i) {
        const K::Point_2 p = circle.contact(i).point();
        out << "<circle class='contact' cx='" << scale * CGAL::to_double(p.x()) << "' cy='"
            << -scale * CGAL::to_double(p.y()) << "' r='4'/>\n";
      }
  out << "<text x='" << 10 - width << "' y='" << height - 12 << "'>" << result.circles().size()
      << " circles touch three curves, " << result.count(SC::Emptiness::EMPTY)
      << " of them empty (bold)</text>\n</svg>\n";
  std::cout << result.summary() << '\n';
  if (!result.summary().is_complete || result.count(SC::Emptiness::UNDECIDED) > 0)
    return {};
  return {result.circles().size(), result.count(SC::Emptiness::EMPTY)};
}

int main()
{
  // A channel between two cubic B-spline curves with an ellipse in it.
  const std::vector<K::FT> knots{0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
  const std::vector<Curve> channel{
      Curve(3, knots, {{-9, 3}, {-6, 2}, {-3, 4}, {0, 3}, {3, 4}, {6, 2}, {9, 4}}),
      Curve(3, knots, {{-9, -2}, {-6, -4}, {-3, -2}, {0, -4}, {3, -3}, {6, -3}, {9, -2}}),
      SC::ellipse_curve(K::Point_2(0, 0), K::Vector_2(2, K::FT(1) / 2), K::Vector_2(K::FT(-1) / 3, 1))};
  const std::array<std::size_t, 2> in_channel = draw(channel, "tangent_circles.svg", 300, 180);

  const std::vector<Curve> circles{SC::circle_curve(K::Point_2(-3, -1), K::FT(3) / 2),
                                   SC::circle_curve(K::Point_2(K::FT(5) / 2, -2), K::FT(2)),
                                   SC::circle_curve(K::Point_2(K::FT(-1) / 2, 3), K::FT(1))};
  const std::array<std::size_t, 2> of_apollonius = draw(circles, "circles_of_apollonius.svg", 300, 250);
  return in_channel[1] == 2 && of_apollonius[0] == 8 ? 0 : 1;
}
