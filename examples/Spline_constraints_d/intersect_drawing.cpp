// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Reads the curves of the SVG drawing data/drawing.svg, intersects all pairs of them in exact numbers, and draws them with their intersections into
// intersect_drawing.svg.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/pairwise_intersections.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <fstream>
#include <iostream>
#include <map>
#include <ranges>
#include <string>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Kind = SC::Intersection_kind;

#ifndef DATA_DIRECTORY
#define DATA_DIRECTORY "data/"
#endif

int main()
{
  try {
    const auto drawing = SC::IO::read_SVG<K>(DATA_DIRECTORY "drawing.svg");
    std::ofstream file("intersect_drawing.svg");
    SC::SVG_writer picture(file, CGAL::Bbox_2(0, -80, 120, -5), 720);
    for (const auto& element : drawing)
      picture.curve(element.curve, "#1f77b4", 2);

    std::map<Kind, int> count;
    const auto result = SC::pairwise_intersections(std::views::transform(drawing, [](const auto& element) { return element.curve; }));
    for (const auto& [i, j, intersections] : result.pairs)
      for (const auto& x : intersections) {
        ++count[x.kind()];
        picture.point(x.point(), x.kind() == Kind::TRANSVERSAL ? "#2ca02c" : "#d62728", 9);
        std::cout << drawing[i].id << " and " << drawing[j].id << ": " << x.kind() << " near (" << CGAL::to_double(x.point().x()) << ", " << CGAL::to_double(x.point().y()) << ")\n";
      }
    const bool is_complete = result.summary.is_complete;
    const std::string summary = std::to_string(count[Kind::TRANSVERSAL]) + " crossings (green), " + std::to_string(count[Kind::TANGENT]) + " contact (red); complete: " + (is_complete ? "yes" : "no");
    picture.label(K::Point_2(5, -78), summary);
    std::cout << summary << '\n';
    return is_complete && count[Kind::TRANSVERSAL] == 16 && count[Kind::TANGENT] == 1 ? 0 : 1;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
