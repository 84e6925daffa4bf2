// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All curves that two B-spline surfaces have in common: transversal ones, and those along which they touch (tangent).
//
//   surface_intersection [A B] [--time-limit S] [--output FILE.svg|FILE.vtp]
//
// A and B are files of GoTools (.g2) or IRIT (.itd), the first surface of each counts; without them
// data/surfaces/waves.g2 and ring.g2 are taken. The curves are drawn on the surfaces (.svg; those along which they
// touch in violet, single and singular points as dots), or written as polylines and points (.vtp, for ParaView). Exit
// status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include "arguments.h"
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_VTP.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;

#ifndef DATA_DIRECTORY
#define DATA_DIRECTORY "data/"
#endif

Surface read_surface(const std::string& path)
{
  const auto file = path.ends_with(".g2") ? SC::IO::read_g2<K>(path) : SC::IO::read_IRIT<K>(path);
  if (file.surfaces_3.empty())
    throw SC::Invalid_input(path + ": no surface");
  return file.surfaces_3.front().object;
}

void write(const std::string& path, const Surface& a, const Surface& b, const SC::Surface_intersection<K>& set,
           const std::vector<std::vector<K::Point_3>>& polylines)
{
  std::ofstream out(path);
  if (path.ends_with(".svg")) {
    Scene scene;
    scene.add(a, {150, 190, 235});
    scene.add(b, {255, 190, 110});
    for (std::size_t i = 0; i < polylines.size(); ++i)
      scene.add(polylines[i], set.curves()[i].kind() == SC::Intersection_kind::TANGENT ? "#7a00a8" : "#c00020");
    for (const auto* points : {&set.singular_points(), &set.points()})
      for (const auto& point : *points)
        scene.mark(point.point(), "black");
    scene.write(out);
  } else {
    std::vector<std::vector<K::Point_3>> all = polylines;
    for (const auto* points : {&set.points(), &set.singular_points()})
      for (const auto& point : *points)
        all.push_back({point.point()});
    SC::IO::write_VTP(out, all);
  }
}

int main(int argc, char* argv[])
{
  try {
    std::vector<std::string> files, words(argv + 1, argv + argc);
    std::string output = "surface_intersection.svg";
    SC::Solver_options options{.tolerance = 1e-8};
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--output" && i + 1 < words.size())
        output = words[++i];
      else if (words[i] == "--time-limit" && i + 1 < words.size())
        options.time_limit = number_of<double>(words[++i]);
      else
        files.push_back(words[i]);
    if (files.empty())
      files = {DATA_DIRECTORY "surfaces/waves.g2", DATA_DIRECTORY "surfaces/ring.g2"};
    if (files.size() != 2)
      throw SC::Invalid_input("usage: surface_intersection [A B] [--time-limit S] [--output FILE.svg|FILE.vtp]");
    const Surface a = read_surface(files[0]), b = read_surface(files[1]);
    const auto set = SC::intersection_curves(a, b, options);
    std::vector<std::vector<K::Point_3>> polylines;
    for (const SC::Intersection_curve& curve : set.curves()) {
      polylines.push_back(set.polyline(curve, 1e-3));
      std::cout << "curve " << polylines.size() << "  " << (curve.is_closed ? "closed, " : "open, ") << curve.kind()
                << ", " << polylines.back().size() << " points from (" << polylines.back().front() << ")\n";
    }
    for (const auto& point : set.points())
      std::cout << "point (" << point.point() << "), " << point.kind() << '\n';
    for (const auto& point : set.singular_points())
      std::cout << "singular point (" << point.point() << ")\n";
    write(output, a, b, set, polylines);
    std::cout << set << '\n';
    return set.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
