// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What one of the planar operations says of each of many drawings: a line per drawing that is not complete, is refused, or is slow, and a summary with times.
//
//   survey_drawings diagram|axis|offset=DISTANCE|square_sum|disk_sum|sweep|hull|kernel|visible FILE...
//
// Regions and sums are those of drawings whose closed curves bound a region. Offsets, axes and sums of others are refused.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/visible_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi_diagrams_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;

namespace {

constexpr double slow = 5;   // seconds

// Answers in words: empty when all is proved.
std::string answer(bool is_complete, std::size_t left)
{
  return is_complete ? "" : "incomplete, " + std::to_string(left) + " places";
}

template <class Diagram>
std::string answer_of_diagram(const Diagram& diagram)
{
  const auto left = std::count_if(diagram.vertices().begin(), diagram.vertices().end(), [](const auto& vertex) { return !vertex.is_resolved; });
  return answer(diagram.is_complete(), static_cast<std::size_t>(left));
}

std::string answer_of_sum(const SC::Minkowski_sum_2<K>& sum) { return answer(sum.is_complete(), sum.undecided().size()); }

// What is asked of the curves of a drawing.
std::function<std::string(const Curves&)> operation(const std::string& name)
{
  const auto region = [](const Curves& curves) { return SC::planar_region(curves); };
  if (name == "diagram")
    return [](const Curves& curves) { return answer_of_diagram(SC::voronoi_diagram(curves)); };
  if (name == "axis")
    return [=](const Curves& curves) { return answer_of_diagram(SC::medial_axis(region(curves))); };
  if (name.starts_with("offset="))
    return [=, distance = std::atof(name.c_str() + 7)](const Curves& curves) { return answer(SC::trimmed_offset(region(curves), distance).is_complete(), 1); };
  if (name == "square_sum")
    return [=](const Curves& curves) { return answer_of_sum(SC::minkowski_sum(region(curves), SC::planar_region(SC::polyline_curve(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}})))); };
  if (name == "disk_sum")
    return [=](const Curves& curves) { return answer_of_sum(SC::minkowski_sum(region(curves), SC::planar_region(SC::circle_curve(Point(0, 0), SC::Exact_rational(1, 2))))); };
  if (name == "sweep")
    return [=](const Curves& curves) { return answer_of_sum(SC::swept_area(region(curves), SC::bezier_curve<K>({{0, 0}, {1, 2}, {2, -1}, {3, 1}}))); };
  if (name == "hull")
    return [](const Curves& curves) { return answer(SC::convex_hull(curves).is_complete(), 1); };
  if (name == "kernel")
    return [=](const Curves& curves) { return answer(SC::region_kernel(region(curves)).is_complete(), 1); };
  if (name == "visible")
    return [](Curves curves) {
      curves.push_back(SC::polyline_curve(std::vector<Point>{{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}, {-1000, -1000}}));
      return answer(SC::visible_part(Point(SC::Exact_rational(731, 100), SC::Exact_rational(-617, 100)), curves).is_complete(), 1);
    };
  return {};
}

} // namespace

int main(int argc, char* argv[])
{
  const auto ask = operation(argc > 1 ? argv[1] : "");
  if (!ask) {
    std::cerr << "survey_drawings diagram|axis|offset=DISTANCE|square_sum|disk_sum|sweep|hull|kernel|visible FILE...\n";
    return 2;
  }
  int complete = 0, incomplete = 0, refused = 0;
  double total = 0, greatest = 0;
  for (int i = 2; i < argc; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    std::string said;
    try {
      said = ask(SC::IO::read_SVG_curves<K>(argv[i]));
      ++(said.empty() ? complete : incomplete);
    } catch (const SC::Invalid_input& error) {
      said = error.what();
      ++refused;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    total += seconds;
    greatest = (std::max)(greatest, seconds);
    if (!said.empty() || seconds > slow)
      std::cout << argv[i] << ": " << (said.empty() ? "complete" : said) << ", " << seconds << " s" << std::endl;
  }
  std::cout << argv[1] << ": " << complete << " complete, " << incomplete << " incomplete, " << refused << " refused; " << total << " s, the slowest " << greatest << " s\n";
}
