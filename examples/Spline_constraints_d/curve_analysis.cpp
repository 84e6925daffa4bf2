// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is special along a curve, drawn into curve_analysis.svg: inflections, vertices, the highest and lowest points,
// and the lines that touch it twice.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/bitangents_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;
using Kind = SC::Curve_feature_kind;

template <class Feature>
void show(SC::SVG_writer& picture, const std::string& what, const Feature& feature, const std::string& color,
          double diameter = 9)
{
  const auto& point = feature.point_on_curve();
  picture.point(point.point(), color, diameter);
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
  SC::SVG_writer picture(out, CGAL::Bbox_2(-0.9, -1.6, 7.7, 5.1), 780);
  picture.curve(curve, "#1f77b4", 2);
  for (const auto& bitangent : bitangents.bitangents()) {
    const K::Point_2 p = bitangent.contact(0).point(), q = bitangent.contact(1).point();
    std::cout << "bitangent: " << bitangent.solution().kind() << " at " << bitangent.contact(0).parameter() << " and "
              << bitangent.contact(1).parameter() << '\n';
    const K::Vector_2 more = (q - p) * K::FT(0.6 / std::sqrt(CGAL::to_double((q - p).squared_length())));
    picture.curve(SC::segment_curve(p - more, q + more), "#888", 1);
  }
  for (const auto& feature : heights.features())
    show(picture, "height", feature, CGAL::certainly(feature.is_global()) ? "#d95f02" : "#fdb863", 16);
  for (const auto& feature : vertices.features())
    show(picture, "curvature", feature, feature.kind() == Kind::MAXIMUM ? "#d62728" : "#2ca02c");
  for (const auto& feature : inflections.features())
    show(picture, "turn", feature, "#7b3294");

  const std::vector<std::pair<std::string, std::string>> legend{{"inflection", "#7b3294"},
                                                                {"maximum of the curvature", "#d62728"},
                                                                {"minimum", "#2ca02c"},
                                                                {"highest, lowest point", "#d95f02"},
                                                                {"local extreme of the height", "#fdb863"},
                                                                {"bitangent", "#888"}};
  for (std::size_t i = 0; i < legend.size(); ++i)
    picture.label(K::Point_2(i % 3 == 0       ? -0.6
                                 : i % 3 == 1 ? 1.9
                                              : 5.4,
                             i < 3 ? -1.1 : -1.45),
                  legend[i].first, legend[i].second);

  const bool is_complete = inflections.summary().is_complete && vertices.summary().is_complete &&
      heights.summary().is_complete && bitangents.summary().is_complete;
  std::cout << (is_complete ? "" : "at least ") << inflections.count(Kind::INFLECTION) << " inflections, "
            << vertices.count(Kind::MAXIMUM) << " largest and " << vertices.count(Kind::MINIMUM)
            << " smallest curvatures, " << heights.features().size() << " extreme points, "
            << bitangents.bitangents().size() << " bitangents; complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete && inflections.count(Kind::INFLECTION) == 6 ? 0 : 1;
}
