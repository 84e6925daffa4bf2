// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All curves that two B-spline surfaces have in common: transversal ones, and those along which they touch (tangent).
//
//   surface_intersection [A B] [--heal TOLERANCE] [--near DISTANCE] [--time-limit S] [--output FILE.svg|FILE.vtp]
//
// A and B are files of GoTools (.g2) or IRIT (.itd), the first surface of each counts; without them
// data/surfaces/waves.g2 and ring.g2 are taken. With --heal, primitives are made exact, moved by no more than the
// tolerance, before. Corners, seams and poles that nearly coincide, up to the last digits or the distance given by
// --near, are named besides. The curves are drawn on the surfaces (.svg; those along which they
// touch in violet, single and singular points as dots), or written as polylines and points (.vtp, for ParaView). Exit
// status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include "arguments.h"
#include "healing.h"
#include "near_coincidences.h"
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/IO/write_VTP.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <array>
#include <fstream>
#include <iostream>
#include <optional>

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

struct Curves
{
  std::vector<std::vector<K::Point_3>> polylines;
  std::vector<SC::Intersection_kind> kinds;
  std::vector<K::Point_3> points;   // single and singular ones
};

void write(const std::string& path, const Surface& a, const Surface& b, const Curves& curves)
{
  std::ofstream out(path);
  if (path.ends_with(".svg")) {
    Scene scene;
    scene.add(a, {150, 190, 235});
    scene.add(b, {255, 190, 110});
    for (std::size_t i = 0; i < curves.polylines.size(); ++i)
      scene.add(curves.polylines[i], curves.kinds[i] == SC::Intersection_kind::TANGENT ? "#7a00a8" : "#c00020");
    for (const K::Point_3& point : curves.points)
      scene.mark(point, "black");
    scene.write(out);
  } else {
    std::vector<std::vector<K::Point_3>> all = curves.polylines;
    for (const K::Point_3& point : curves.points)
      all.push_back({point});
    SC::IO::write_VTP(out, all);
  }
}

// Prints what was found, and moves it to where the data are.
template <class Kernel>
Curves curves_of(const SC::Surface_intersection<Kernel>& set, const Rounded_motion& moved)
{
  Curves result;
  for (const SC::Intersection_curve& curve : set.curves()) {
    std::vector<K::Point_3>& polyline = result.polylines.emplace_back();
    for (const auto& point : set.polyline(curve, 1e-3))
      polyline.push_back(moved(point));
    result.kinds.push_back(curve.kind());
    std::cout << "curve " << result.polylines.size() << "  " << (curve.is_closed ? "closed, " : "open, ")
              << curve.kind() << ", " << polyline.size() << " points from (" << polyline.front() << ")\n";
  }
  for (const auto& point : set.points()) {
    result.points.push_back(moved(point.point()));
    std::cout << "point (" << result.points.back() << "), " << point.kind() << '\n';
  }
  for (const auto& point : set.singular_points()) {
    result.points.push_back(moved(point.point()));
    std::cout << "singular point (" << result.points.back() << ")\n";
  }
  return result;
}

// Special points of both surfaces that nearly coincide; whether all were found.
template <class Surface>
bool print_near_coincidences(const Surface& a, const Surface& b, std::optional<double> distance,
                             const SC::Solver_options& options)
{
  const auto near = SC::near_coincidences(a, b, distance, options);
  for (const auto& pair : near) {
    print_near_coincidence<2, 2>(pair, [] { std::cout << " of A"; }, [] { std::cout << " of B"; });
    std::cout << '\n';
  }
  std::cout << "near coincidences: " << (near.is_complete() ? "" : "at least ") << near.size() << '\n';
  return near.is_complete();
}

int main(int argc, char* argv[])
{
  try {
    std::vector<std::string> files, words(argv + 1, argv + argc);
    std::string output = "surface_intersection.svg";
    SC::Solver_options options{.tolerance = 1e-8};
    std::optional<double> healing_tolerance, near_distance;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--output" && i + 1 < words.size())
        output = words[++i];
      else if (words[i] == "--time-limit" && i + 1 < words.size())
        options.time_limit = number_of<double>(words[++i]);
      else if (words[i] == "--heal" && i + 1 < words.size())
        healing_tolerance = number_of<double>(words[++i]);
      else if (words[i] == "--near" && i + 1 < words.size())
        near_distance = number_of<double>(words[++i]);
      else
        files.push_back(words[i]);
    if (files.empty())
      files = {DATA_DIRECTORY "surfaces/waves.g2", DATA_DIRECTORY "surfaces/ring.g2"};
    if (files.size() != 2)
      throw SC::Invalid_input("usage: surface_intersection [A B] [--heal TOLERANCE] [--near DISTANCE] "
                              "[--time-limit S] [--output FILE.svg|FILE.vtp]");
    const Surface a = read_surface(files[0]), b = read_surface(files[1]);
    const Options_of_program remaining(options);
    const auto finish = [&](const auto& first, const auto& second, const Rounded_motion& moved) {
      const bool are_all_near = print_near_coincidences(first, second, near_distance, remaining());
      const auto set = SC::intersection_curves(first, second, remaining());
      write(output, a, b, curves_of(set, moved));
      std::cout << set << '\n';
      return set.is_complete() && are_all_near ? 0 : 3;
    };
    if (!healing_tolerance)
      return finish(a, b, Rounded_motion());
    const auto healed = SC::with_exact_primitives(std::array{a, b}, *healing_tolerance, options);
    print_healing(healed);
    const auto simple = healed.simple_splines();
    return finish(simple[0], simple[1], Rounded_motion(healed.frame));
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
