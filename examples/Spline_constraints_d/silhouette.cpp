// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The silhouettes of a B-spline surface in a parallel view.
//
//   silhouette [SURFACE] [--heal TOLERANCE] [--time-limit S] [--output FILE.svg]
//
// SURFACE is a file of GoTools (.g2) or IRIT (.itd), its first surface counts; without it, a vase is taken. With
// --heal, a primitive is made exact, moved by no more than the tolerance, before. The silhouettes are drawn in red,
// thin where the surface hides them. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include "arguments.h"
#include "healing.h"
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/IO/read_IRIT.h>
#include <CGAL/Spline_constraints_d/IO/read_g2.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>

#include <array>
#include <fstream>
#include <iostream>
#include <optional>
#include <utility>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Exact_kernel = CGAL::Simple_cartesian<SC::Exact_rational>;

Surface read_surface(const std::string& path)
{
  const auto file = path.ends_with(".g2") ? SC::IO::read_g2<K>(path) : SC::IO::read_IRIT<K>(path);
  if (file.surfaces_3.empty())
    throw SC::Invalid_input(path + ": no surface");
  return file.surfaces_3.front().object;
}

Surface vase()
{
  const std::vector<K::Point_3> profile{{1, 0, 0},       {1.75, 0, 0.25}, {2.5, 0, 1.5},  {1.75, 0, 3},
                                        {0.25, 0, 3.25}, {0.5, 0, 4.5},   {1.75, 0, 4.75}};
  return SC::surface_of_revolution(SC::Bspline_curve_3<K>(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, profile),
                                   K::Point_3(0, 0, 0), K::Vector_3(0, 0, 1));
}

// Draws and prints silhouettes, moved to where the surface is.
template <class Silhouettes>
int show(const Surface& surface, const Silhouettes& set, const Rounded_motion& moved, const std::string& output)
{
  Scene scene;
  scene.add(surface, {190, 210, 235});
  for (const SC::Surface_curve& curve : set.curves()) {
    std::vector<K::Point_3> points;
    for (const auto& sample : set.polyline(curve, 1e-3))
      points.push_back(moved(sample.point));
    scene.add(points, "#c00020", 3, true);
    std::cout << (curve.is_closed ? "closed, " : "open, ") << points.size() << " points from (" << points.front()
              << ")\n";
  }
  for (const auto& [name, points] :
       {std::pair("point", &set.points()), std::pair("singular point", &set.singular_points())})
    for (const SC::Curve_vertex& vertex : *points) {
      const K::Point_3 point = moved(set.point(vertex.point()));
      scene.mark(point, "black");
      std::cout << name << " (" << point << ")\n";
    }
  std::ofstream out(output);
  scene.write(out);
  std::cout << set << '\n';
  return set.is_complete() ? 0 : 3;
}

int main(int argc, char* argv[])
{
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    std::string output = "silhouette.svg";
    SC::Solver_options options{.tolerance = 1e-8};
    std::optional<double> healing_tolerance;
    std::vector<std::string> files;
    for (std::size_t i = 0; i < words.size(); ++i)
      if (words[i] == "--output" && i + 1 < words.size())
        output = words[++i];
      else if (words[i] == "--time-limit" && i + 1 < words.size())
        options.time_limit = number_of<double>(words[++i]);
      else if (words[i] == "--heal" && i + 1 < words.size())
        healing_tolerance = number_of<double>(words[++i]);
      else
        files.push_back(words[i]);
    if (files.size() > 1)
      throw SC::Invalid_input("usage: silhouette [SURFACE] [--heal TOLERANCE] [--time-limit S] [--output FILE.svg]");
    const Surface surface = files.empty() ? vase() : read_surface(files[0]);
    const Options_of_program remaining(options);
    if (!healing_tolerance)
      return show(surface, SC::silhouettes(surface, Scene::direction(), options), Rounded_motion(), output);
    const auto healed = SC::with_exact_primitives(std::array{surface}, *healing_tolerance, options);
    print_healing(healed);
    const Exact_kernel::Vector_3 direction(Scene::direction().x(), Scene::direction().y(), Scene::direction().z());
    return show(
        surface,
        SC::silhouettes(healed.simple_splines().front(), healed.frame.inverse().transform(direction), remaining()),
        Rounded_motion(healed.frame), output);
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
