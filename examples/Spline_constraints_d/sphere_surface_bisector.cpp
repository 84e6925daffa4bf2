// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of a sphere and a surface that has a rational unit normal.
//
//   sphere_surface_bisector [SURFACE.g2 X Y Z R] [--reach R] [--error E] [--output FILE.off|.vtp|.svg]
//                           [--time-limit S]
//
// With a surface and a sphere: the sheet of the bisector on the side of the normal (on the other side for a negative
// radius), within a ball around both, trimmed; its mesh, or a picture, goes into a file. Without: that of a sphere and
// a pipe around a parabola, untrimmed, with level curves of the distance, and below the path between two spheres on a
// third one, are drawn into sphere_surface_bisector.svg. Exit status: 0 when nothing is undecided, 3 when something is,
// 2 for bad input.
#include "trimmed_bisector_program.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/canal_surfaces.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/curves_on_bisectors_3.h>

template <class Curves>
void add(Scene& scene, const std::vector<Curves>& parts, const K::Vector_3& place, const std::string& color)
{
  for (const Curves& part : parts)
    for (const auto& curve : part.curves()) {
      std::vector<K::Point_3> points;
      for (const auto& sample : part.polyline(curve, 1e-2))
        points.push_back(K::Point_3(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()),
                                    CGAL::to_double(sample.point.z())) +
                         place);
      scene.add(points, color, 2);
    }
}

void draw()
{
  Scene scene;
  const auto sphere = [](const K::Point_3& center, double radius) { return SC::sphere_surface<K>(center, radius); };

  // In exact numbers: rounded to doubles, the pipe would have no rational normal.
  using Exact = SC::Rational_bisector_3::Kernel;
  const auto parabola = SC::bezier_curve(std::vector<Exact::Point_3>{{-3, 0, 3}, {0, 0, -3}, {3, 0, 3}});
  const Exact::FT half = Exact::FT(1) / 2;
  const auto exact_pipe = SC::pipe_surface(parabola, Exact::Vector_3(0, half, 0));
  const auto bisector = SC::sphere_surface_bisector(Exact::Point_3(0, 0, 5 * half), half, exact_pipe);
  const Surface pipe(exact_pipe);
  const K::Point_3 center(0, 0, 2.5);
  Group first(scene, K::Vector_3(0, 0, 0));
  first.add(pipe, 24);
  first.add(sphere(center, 0.5), 12);
  first.add(show("sphere and pipe", bisector, K::Sphere_3(center, 4)));
  std::size_t levels = 0;
  for (const double distance : {0.75, 1.0, 1.25}) {
    const auto curves = SC::distance_curves(bisector, distance);
    for (const auto& part : curves)
      levels += part.curves().size();
    add(scene, curves, K::Vector_3(0, 0, 0), "#7a3c00");
  }
  std::cout << "level curves: " << levels << '\n';

  // Two radars, the bisector of their ranges, and where it meets a third sphere.
  const K::Vector_3 place = Group::place(8, 1);
  const K::Point_3 left(-2, 0, 0), right(2, 0, 0);
  const K::Sphere_3 third(K::Point_3(0, 0, 0), 6.25);
  Group second(scene, place);
  second.add(sphere(left, 1), 12);
  second.add(sphere(right, 1.5), 14);
  const auto between = SC::sphere_surface_bisector(right, 1.5, sphere(left, 1));
  second.add(show("two spheres", between, third));
  const auto path = SC::sphere_sections(between, third);
  add(scene, path, place, "#c00020");
  std::cout << "path: " << path.front().number_of_closed_curves() << " closed\n";
  std::ofstream file("sphere_surface_bisector.svg");
  scene.write(file);
}

int main(int argc, char* argv[])
{
  try {
    const Bisector_arguments arguments(argc, argv);
    if (arguments.words.empty()) {
      draw();
      return 0;
    }
    if (arguments.words.size() != 5)
      throw SC::Invalid_input("usage: sphere_surface_bisector [SURFACE.g2 X Y Z R] [--reach R] [--error E] [--output "
                              "FILE.off|.vtp|.svg] [--time-limit S]");
    const double radius = number_of<double>(arguments.words[4]);
    return of_file(arguments, [&](const K::Point_3& center, const Surface& surface, const K::Sphere_3& reach) {
      return SC::trimmed_sphere_surface_bisector(center, radius, surface, reach, arguments.options);
    });
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
