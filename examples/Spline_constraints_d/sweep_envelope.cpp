// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The envelope of a surface that is translated along a curve: sweep_envelope SURFACE PATH [--output FILE], files of .g2
// or .itd. Without arguments that of a ball on a parabola, of which the lower half is drawn to show the cuspidal edges,
// and of an ellipsoid that turns about an axis, both into sweep_envelope.svg; those of an ellipsoid along a line and a
// circle into ellipsoid_envelopes.svg. Exit status: 0, or 3 when something is undecided.
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/sweep_envelope.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <exception>
#include <fstream>

namespace SC = CGAL::Spline_constraints;
using Point = Kernel_of_operands::Point_3;

// The triangles whose second unknown is not beyond a value.
SC::Solution_surface_mesh lower_part(SC::Solution_surface_mesh mesh, double last)
{
  for (const auto f : mesh.mesh.faces()) {
    const auto around = mesh.mesh.vertices_around_face(mesh.mesh.halfedge(f));
    if (std::any_of(around.begin(), around.end(), [&](const auto v) { return mesh.unknowns[v][1] > last; }))
      CGAL::Euler::remove_face(mesh.mesh.halfedge(f), mesh.mesh);
  }
  mesh.mesh.collect_garbage();
  return mesh;
}

// Without turning, as in figure 5 of Elber and Kim (2001). Exit status: 0, or 3.
int draw_ellipsoid_envelopes()
{
  const auto ellipsoid =
      SC::sphere_surface<Kernel_of_operands>(Point(0, 0, 0), 1).transformed({0.5, 0, 0, 0, 0, 0.8, 0, 0, 0, 0, 1, 0});
  const Curve_operand line(1, {0, 0, 1, 1}, {{-4.6, -2.5, -0.3}, {-3.4, 2.5, 0.3}});
  using Vector = Kernel_of_operands::Vector_3;
  const Curve_operand circle = SC::ellipse_curve(Point(1, 0, 0), Vector(1.5, -2, 0), Vector(2, 1.5, 0));
  SC::Scene_3 scene({.to_viewer = {0.15, -0.7, 0.75}, .most_splits = 20000});
  int status = 0;
  for (const Curve_operand* path : {&line, &circle}) {
    const auto envelope = SC::sweep_envelope(ellipsoid, SC::Rational_motion_3::along(*path));
    status = (std::max)(status, print_envelope(envelope));
    add_envelope(scene, envelope.mesh({.chord_error = 0.03}));
  }
  scene.add(grid_on(ellipsoid.transformed({CGAL::TRANSLATION, line(0) - CGAL::ORIGIN})),
            {.color = CGAL::IO::Color(230, 120, 110)});
  std::ofstream picture("ellipsoid_envelopes.svg");
  scene.write(picture);
  return status;
}

int own_example()
{
  const Curve_operand parabola(2, {0, 0, 0, 1, 1, 1}, {{-1.8, 4, 0}, {0, -4, 0}, {1.8, 4, 0}});
  const auto ball = SC::sphere_surface<Kernel_of_operands>(Point(0, 0, 0), 1);
  const auto tube = SC::sweep_envelope(ball, SC::Rational_motion_3::along(parabola));
  const auto ellipsoid = ball.transformed({1, 0, 0, 8, 0, 0.5, 0, 0, 0, 0, 0.6, 0});
  const SC::Rational_motion_3 turn =
      SC::Rational_motion_3::full_turn(Point(6, 0, 0), Kernel_of_operands::Vector_3(0, 0, 1));
  const auto ring = SC::sweep_envelope(ellipsoid, turn);
  SC::Scene_3 scene({.to_viewer = {0.05, -0.55, 0.9}, .most_splits = 20000});
  add_envelope(scene, lower_part(tube.mesh({.chord_error = 0.03}), 1));
  add_envelope(scene, ring.mesh({.chord_error = 0.03}));
  scene.add(grid_on(ellipsoid.transformed({1, 0, 0, 2.5, 0, 1, 0, 0, 0, 0, 1, 0})),
            {.color = CGAL::IO::Color(230, 120, 110)});
  std::ofstream picture("sweep_envelope.svg");
  scene.write(picture);
  return (std::max)({draw_ellipsoid_envelopes(), print_envelope(tube), print_envelope(ring)});
}

int main(int argc, char** argv)
try {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty())
    return own_example();
  if (arguments.size() != 2 && !(arguments.size() == 4 && arguments[2] == "--output"))
    throw SC::Invalid_input("usage: sweep_envelope SURFACE PATH [--output FILE]");
  const auto envelope =
      SC::sweep_envelope(surface_in(arguments[0]), SC::Rational_motion_3::along(curve_in(arguments[1])));
  if (arguments.size() == 4)
    SC::IO::write_surface_mesh(arguments[3], envelope.mesh());
  return print_envelope(envelope);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
