// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What one of the planar operations says of each of many drawings: a line per drawing that is not complete, is refused,
// or is slow, and a summary with times.
//
//   survey_drawings
// diagram|smoothed=DEGREES|axis|offset=DISTANCE|square_sum|disk_sum|sum_and_offset|sweep|hull|kernel|visible
// FILE_OR_FOLDER...
//
// Of a folder, all drawings in it are taken, as of a folder of glyphs. With smoothed, what is asked for is the diagram
// of the curves with smooth joints, up to some angle. With sum_and_offset the sum with a disk is compared with the
// offset at its radius, which other code makes: by their areas. Regions and sums are those of drawings whose closed
// curves bound a region. Offsets, axes and sums of others are refused.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/smooth_joints.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
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
  const auto left = std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                                  [](const auto& vertex) { return !vertex.is_resolved; });
  return answer(diagram.is_complete(), static_cast<std::size_t>(left));
}

std::string answer_of_sum(const SC::Minkowski_sum_2<K>& sum)
{
  return answer(sum.is_complete(), sum.undecided().size());
}

SC::Planar_region_2<K> region(const Curves& curves) { return SC::planar_region(curves); }

SC::Minkowski_sum_2<K> sum_with_disk(const Curves& curves)
{
  return SC::minkowski_sum(region(curves), SC::planar_region(SC::circle_curve(Point(0, 0), SC::Exact_rational(1, 2))));
}

// Of polygons next to the boundary of what an operation returns.
template <class Result>
double area(const Result& result)
{
  SC::Exact_rational area(0);
  for (const auto& polygon : result.polygons_with_holes(1e-5)) {
    area += polygon.outer_boundary().area();
    for (const auto& hole : polygon.holes())
      area += hole.area();
  }
  return SC::to_nearest_double(area);
}

std::string answer_of_sum_and_offset(const Curves& curves)
{
  constexpr double most_difference = 1e-3;   // of areas, of chords that are no more than 1e-5 away from the arcs
  const auto sum = sum_with_disk(curves);
  const auto offset = SC::trimmed_offset(region(curves), 0.5);
  if (!sum.is_complete() || !offset.is_complete())
    return answer(false, sum.undecided().size());
  const double difference = std::abs(area(sum) - area(offset));
  return difference < most_difference ? "" : "areas differ by " + std::to_string(difference);
}

// What is asked of the curves of a drawing.
std::function<std::string(const Curves&)> operation(const std::string& name)
{
  if (name == "diagram")
    return [](const Curves& curves) { return answer_of_diagram(SC::voronoi_diagram(curves)); };
  if (name.starts_with("smoothed="))
    return [angle = std::atof(name.c_str() + 9) * CGAL_PI / 180](const Curves& curves) {
      return answer_of_diagram(SC::voronoi_diagram(SC::with_smooth_joints<K>(curves, angle).curves));
    };
  if (name == "axis")
    return [](const Curves& curves) { return answer_of_diagram(SC::medial_axis(region(curves))); };
  if (name.starts_with("offset="))
    return [distance = std::atof(name.c_str() + 7)](const Curves& curves) {
      return answer(SC::trimmed_offset(region(curves), distance).is_complete(), 1);
    };
  if (name == "square_sum")
    return [](const Curves& curves) {
      return answer_of_sum(SC::minkowski_sum(
          region(curves),
          SC::planar_region(SC::polyline_curve(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}))));
    };
  if (name == "disk_sum")
    return [](const Curves& curves) { return answer_of_sum(sum_with_disk(curves)); };
  if (name == "sum_and_offset")
    return answer_of_sum_and_offset;
  if (name == "sweep")
    return [](const Curves& curves) {
      return answer_of_sum(SC::swept_area(region(curves), SC::bezier_curve<K>({{0, 0}, {1, 2}, {2, -1}, {3, 1}})));
    };
  if (name == "hull")
    return [](const Curves& curves) { return answer(SC::convex_hull(curves).is_complete(), 1); };
  if (name == "kernel")
    return [](const Curves& curves) { return answer(SC::region_kernel(region(curves)).is_complete(), 1); };
  if (name == "visible")
    return [](Curves curves) {
      curves.push_back(SC::polyline_curve(
          std::vector<Point>{{-1000, -1000}, {1000, -1000}, {1000, 1000}, {-1000, 1000}, {-1000, -1000}}));
      return answer(
          SC::visible_part(Point(SC::Exact_rational(731, 100), SC::Exact_rational(-617, 100)), curves).is_complete(),
          1);
    };
  return {};
}

// The files, and the drawings in folders, in order.
std::vector<std::string> drawings(const std::vector<std::string>& arguments)
{
  std::vector<std::string> result;
  for (const std::string& argument : arguments)
    if (std::filesystem::is_directory(argument)) {
      for (const auto& entry : std::filesystem::directory_iterator(argument))
        if (entry.path().extension() == ".svg")
          result.push_back(entry.path().string());
    } else
      result.push_back(argument);
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace

int main(int argc, char* argv[])
{
  const auto ask = operation(argc > 1 ? argv[1] : "");
  if (!ask) {
    std::cerr << "survey_drawings "
                 "diagram|smoothed=DEGREES|axis|offset=DISTANCE|square_sum|disk_sum|sum_and_offset|sweep|hull|kernel|"
                 "visible FILE_OR_FOLDER...\n";
    return 2;
  }
  int complete = 0, incomplete = 0, refused = 0;
  double total = 0, greatest = 0;
  for (const std::string& drawing : drawings({argv + 2, argv + argc})) {
    const auto begin = std::chrono::steady_clock::now();
    std::string said;
    try {
      said = ask(SC::IO::read_SVG_curves<K>(drawing));
      ++(said.empty() ? complete : incomplete);
    } catch (const SC::Invalid_input& error) {
      said = error.what();
      ++refused;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    total += seconds;
    greatest = (std::max)(greatest, seconds);
    if (!said.empty() || seconds > slow)
      std::cout << drawing << ": " << (said.empty() ? "complete" : said) << ", " << seconds << " s" << std::endl;
  }
  std::cout << argv[1] << ": " << complete << " complete, " << incomplete << " incomplete, " << refused << " refused; "
            << total << " s, the slowest " << greatest << " s\n";
}
