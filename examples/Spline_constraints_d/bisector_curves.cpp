// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of two planar curves, untrimmed: all points at the same distance from both along their normals, the
// poles where it goes to infinity included.
//
//   bisector_curves [A B] [--time-limit S] [--output FILE.svg]
//
// A and B are files of GoTools (.g2) or IRIT (.itd), the first planar curve of each counts; without them, two cubics
// are taken. The curves are drawn. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

Curve read_curve(const std::string& path)
{
  const auto file = path.ends_with(".g2") ? SC::IO::read_g2<K>(path) : SC::IO::read_IRIT<K>(path);
  if (file.curves_2.empty())
    throw SC::Invalid_input(path + ": no planar curve");
  return file.curves_2.front().object;
}

int main(int argc, char* argv[])
{
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    SC::Solver_options options{.tolerance = 1e-8};
    std::vector<std::string> files;
    std::string output = "bisector_curves.svg";
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--time-limit" && i + 1 < words.size())
        options.time_limit = number_of<double>(words[++i]);
      else if (words[i] == "--output" && i + 1 < words.size())
        output = words[++i];
      else
        files.push_back(words[i]);
    if (!files.empty() && files.size() != 2)
      throw SC::Invalid_input("usage: bisector_curves [A B] [--time-limit S] [--output FILE.svg]");
    const Curve a = files.empty() ? SC::bezier_curve(std::vector<K::Point_2>{{-3, 3}, {-1, -5}, {1, 5}, {3, -1}})
                                  : read_curve(files[0]);
    const Curve b = files.empty() ? SC::bezier_curve(std::vector<K::Point_2>{{-3, -3}, {0, -1}, {1, -5}, {4, -3}})
                                  : read_curve(files[1]);
    const auto bisector = SC::bisector_curves(a, b, options);

    const CGAL::Bbox_2 box = a.bbox() + b.bbox();
    const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    const CGAL::Bbox_2 window(box.xmin() - size / 4, box.ymin() - size / 20, box.xmax() + size / 20,
                              box.ymax() + size / 20);
    std::ofstream file(output);
    SC::SVG_writer picture(file, window, 700);
    const char* const colours[] = {"#d62728", "#2ca02c", "#9467bd", "#ff7f0e", "#17becf", "#8c564b"};
    std::size_t index = 0;
    for (const auto& curve : bisector.curves()) {
      const auto samples = bisector.polyline(curve, 1e-3 * size, 2 * size);
      for (std::size_t i = 6; i < samples.size(); i += 12)
        if (CGAL::do_overlap(samples[i].point.bbox(), window))   // the radii of some circles that touch both curves
          picture.polyline(
              std::vector<K::Point_2>{a(samples[i].parameters[0]), samples[i].point, b(samples[i].parameters[1])},
              "#bbb", 1);
      std::cout << "curve " << ++index << "  " << (curve.is_closed ? "closed" : "open") << ", parameters ("
                << samples.front().parameters[0] << ", " << samples.front().parameters[1] << ") to ("
                << samples.back().parameters[0] << ", " << samples.back().parameters[1] << ")"
                << (bisector.ends_at_infinity(curve, 0) || bisector.ends_at_infinity(curve, 1) ? ", to infinity" : "")
                << '\n';
      picture.polyline(samples, colours[(index - 1) % 6], 2);
    }
    for (const auto& [name, points] :
         {std::pair("point", &bisector.points()), std::pair("singular point", &bisector.singular_points())})
      for (const SC::Curve_vertex& vertex : *points)
        std::cout << name << ", parameters (" << vertex.point()[0] << ", " << vertex.point()[1] << ")\n";
    picture.curve(a, "black", 4);
    picture.curve(b, "black", 4);
    std::cout << bisector << '\n';
    return bisector.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
