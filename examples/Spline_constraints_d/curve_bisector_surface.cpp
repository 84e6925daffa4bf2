// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of two curves in space, untrimmed.
//
//   curve_bisector_surface [A.g2 B.g2] [--reach R] [--error E] [--output FILE.off|.vtp|.svg] [--time-limit S]
//
// With two files, the first curve of each counts. The bisector within a ball around both is written as a mesh, or
// drawn. Without: two skew lines, whose bisector is a hyperbolic paraboloid, and a circle and its axis, in
// curve_bisector_surface.svg. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include "bisector_scene.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>

#include <chrono>

int of_files(const Bisector_arguments& arguments)
{
  const Curve first = read_curve(arguments.words[0]), second = read_curve(arguments.words[1]);
  std::vector<K::Point_3> points = points_of(first);
  for (const K::Point_3& point : points_of(second))
    points.push_back(point);
  const K::Sphere_3 reach = reach_around(points, arguments.reach);
  const auto begin = std::chrono::steady_clock::now();
  const auto bisector = SC::curve_bisector_surface(first, second, arguments.options);
  std::size_t parts = 0;
  bool is_complete = bisector.is_complete();
  if (is_complete)
    for (const SC::Trimmed_surface_3& part : SC::bisector_parts(bisector, arguments.options)) {
      parts += part.number_of_regions(SC::WITH_POSITIVE_WEIGHT) + part.number_of_regions(SC::WITH_NEGATIVE_WEIGHT);
      is_complete = is_complete && part.is_complete();
    }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  if (!arguments.output.empty() && bisector.is_complete()) {
    const double error = arguments.error > 0 ? arguments.error : 0.005 * std::sqrt(reach.squared_radius());
    const Mesh mesh =
        mesh_of(SC::bisector_parts(bisector, reach), {SC::WITH_POSITIVE_WEIGHT, SC::WITH_NEGATIVE_WEIGHT}, error);
    if (arguments.output.ends_with(".svg")) {
      Scene scene;
      Group group(scene, K::Vector_3(0, 0, 0));
      group.add(first);
      group.add(second);
      group.add(mesh);
      std::ofstream file(arguments.output);
      scene.write(file);
    } else
      SC::IO::write_surface_mesh(arguments.output, mesh);
  }
  const char* const least = is_complete ? "" : "at least ";
  std::cout << "bisector: degree (" << bisector.degree(0) << ',' << bisector.degree(1) << "), " << least << parts
            << " parts, not trimmed; complete: " << (is_complete ? "yes" : "no") << "; seconds " << seconds.count()
            << '\n';
  return is_complete ? 0 : 3;
}

void draw()
{
  Scene scene;
  const auto add = [&](const std::string& name, const Curve& first, const Curve& second, double reach, double x) {
    Group group(scene, Group::place(x, 0));
    group.add(first);
    group.add(second);
    group.add(show(name, SC::curve_bisector_surface(first, second), K::Sphere_3(K::Point_3(0, 0, 0), reach * reach)));
  };
  add("skew lines", SC::bezier_curve(std::vector<K::Point_3>{{-2, 0, -1}, {2, 0, -1}}),
      SC::bezier_curve(std::vector<K::Point_3>{{0, -2, 1}, {0, 2, 1}}), 4, 0);
  add("circle and its axis", SC::circle_curve(K::Point_3(0, 0, 0), K::Vector_3(0, 0, 1), K::Point_3(1.5, 0, 0)),
      SC::bezier_curve(std::vector<K::Point_3>{{0, 0, -2}, {0, 0, 2}}), 3, 6);
  std::ofstream file("curve_bisector_surface.svg");
  scene.write(file);
}

int main(int argc, char* argv[])
{
  try {
    const Bisector_arguments arguments(argc, argv);
    if (arguments.words.size() == 2)
      return of_files(arguments);
    if (!arguments.words.empty())
      throw SC::Invalid_input("usage: curve_bisector_surface [A.g2 B.g2] [--reach R] [--error E] [--output "
                              "FILE.off|.vtp|.svg] [--time-limit S]");
    draw();
    return 0;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
