// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is special along a curve, drawn into curve_analysis.svg: inflections, vertices, the highest and lowest points, and the lines that touch it twice.
#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/bitangents_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;
using Kind = SC::Curve_feature_kind;

constexpr double scale = 60;

void write_point(std::ostream& out, const K::Point_2& p, const std::string& color, const std::string& shape)
{
  const double x = scale * CGAL::to_double(p.x()), y = -scale * CGAL::to_double(p.y());
  if (shape == "ring")
    out << "<circle cx='" << x << "' cy='" << y << "' r='9' fill='none' stroke='" << color << "' stroke-width='2.5'/>\n";
  else if (shape == "square")
    out << "<rect x='" << x - 4.5 << "' y='" << y - 4.5 << "' width='9' height='9' fill='" << color << "'/>\n";
  else
    out << "<circle cx='" << x << "' cy='" << y << "' r='5' fill='" << color << "'/>\n";
}

void write_line(std::ostream& out, const K::Point_2& p, const K::Point_2& q)
{
  out << "<line x1='" << scale * CGAL::to_double(p.x()) << "' y1='" << -scale * CGAL::to_double(p.y()) << "' x2='" << scale * CGAL::to_double(q.x()) << "' y2='" << -scale * CGAL::to_double(q.y())
      << "' stroke='#888' stroke-width='1'/>\n";
}

template <class Feature>
void report(const std::string& what, const Feature& feature)
{
  const auto& point = feature.point_on_curve();
  std::cout << what << ": " << feature.kind() << " at " << point.parameter() << ", near (" << point.point() << ")\n";
}

int main()
{
  // A closed cubic B-spline curve.
  const std::vector<K::Point_2> points{{0, 0}, {4, -1}, {7, 1}, {5, 2}, {6, 5}, {3, 3}, {1, 5}, {-1, 4}, {1, 2}};
  std::vector<K::FT> period;
  for (std::size_t i = 0; i <= points.size(); ++i)
    period.push_back(K::FT(static_cast<int>(i)));
  const Curve curve = Curve::from_periodic(3, period, points);

  const auto inflections = SC::inflections(curve);
  const auto vertices = SC::curvature_extremes(curve);
  const auto heights = SC::extreme_points(curve, K::Vector_2(0, 1));
  const auto bitangents = SC::bitangents(curve);

  std::ofstream out("curve_analysis.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-55 -310 520 410' width='780' height='615'>\n<style>text { font: 11px sans-serif; fill: #223 }</style>\n"
         "<rect x='-55' y='-310' width='520' height='410' fill='white'/>\n<path fill='#eef' stroke='#1f77b4' stroke-width='2' d='";
  const auto [begin, end] = curve.domain();
  constexpr int steps = 400;
  for (int i = 0; i <= steps; ++i) {
    const K::Point_2 p = curve(begin + (end - begin) * i / steps);
    out << (i == 0 ? 'M' : 'L') << scale * CGAL::to_double(p.x()) << ' ' << -scale * CGAL::to_double(p.y()) << ' ';
  }
  out << "Z'/>\n";

  for (const auto& bitangent : bitangents.bitangents) {
    const K::Point_2 p = bitangent.contact(0).point(), q = bitangent.contact(1).point();
    std::cout << "bitangent: " << bitangent.solution().kind() << " at " << bitangent.contact(0).parameter() << " and " << bitangent.contact(1).parameter() << '\n';
    const K::Vector_2 more = (q - p) * K::FT(0.6 / std::sqrt(CGAL::to_double((q - p).squared_length())));
    write_line(out, p - more, q + more);
  }
  for (const auto& feature : heights.features) {
    report("height", feature);
    write_point(out, feature.point_on_curve().point(), CGAL::certainly(feature.is_global()) ? "#d95f02" : "#fdb863", "ring");
  }
  for (const auto& feature : vertices.features) {
    report("curvature", feature);
    write_point(out, feature.point_on_curve().point(), feature.kind() == Kind::MAXIMUM ? "#d62728" : "#2ca02c", "square");
  }
  for (const auto& feature : inflections.features) {
    report("turn", feature);
    write_point(out, feature.point_on_curve().point(), "#7b3294", "dot");
  }

  const std::vector<std::vector<std::string>> legend{{"#7b3294", "dot", "inflection"}, {"#d62728", "square", "maximum of the curvature"}, {"#2ca02c", "square", "minimum"},
                                                     {"#d95f02", "ring", "highest, lowest point"}, {"#fdb863", "ring", "local extreme of the height"}, {"#888", "line", "bitangent"}};
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const double x = i % 3 == 0 ? -0.5 : i % 3 == 1 ? 2.0 : 5.4, y = i < 3 ? -1.05 : -1.4;
    if (legend[i][1] == "line")
      write_line(out, {x - 0.15, y}, {x + 0.15, y});
    else
      write_point(out, {x, y}, legend[i][0], legend[i][1]);
    out << "<text x='" << scale * x + 14 << "' y='" << -scale * y + 4 << "'>" << legend[i][2] << "</text>\n";
  }
  out << "</svg>\n";

  const bool is_complete = inflections.summary.is_complete && vertices.summary.is_complete && heights.summary.is_complete && bitangents.summary.is_complete;
  std::cout << inflections.count(Kind::INFLECTION) << " inflections, " << vertices.count(Kind::MAXIMUM) << " largest and " << vertices.count(Kind::MINIMUM) << " smallest curvatures, "
            << heights.features.size() << " extreme points, " << bitangents.bitangents.size() << " bitangents; complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete && inflections.count(Kind::INFLECTION) == 6 ? 0 : 1;
}
