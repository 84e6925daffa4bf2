// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The silhouettes of all that an ellipsoid sweeps when it moves along a cubic curve and turns over, from far away and
// from near. Writes sweep_silhouette.svg, seen from far away. Exit status: 0 when nothing is undecided, 3 when
// something is.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Curve = SC::Bspline_curve_3<K>;

Curve bezier(const std::vector<K::Point_3>& points)
{
  std::vector<double> knots(points.size(), 0);
  knots.insert(knots.end(), points.size(), 1);
  return Curve(static_cast<int>(points.size()) - 1, knots, points);
}

int main()
{
  const Surface ellipsoid = SC::sphere_surface<K>(K::Point_3(0, 0, 0), 1)
                                .transformed(K::Aff_transformation_3(1, 0, 0, 0, 0.5, 0, 0, 0, 0.75));
  // The first axis turns to the second one, the second one to minus the first.
  const SC::Affine_motion<K> motion{bezier({{-4, -2, 0}, {-1, 4, 1}, {1, -5, 2}, {4, 2, 0}}),
                                    {bezier({{1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
                                     bezier({{0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}}), bezier({{0, 0, 1}, {0, 0, 1}})}};
  std::vector<K::Point_3> eyes;
  for (const double distance : {1e4, 5.})
    eyes.push_back(CGAL::ORIGIN + distance * Scene::direction());
  const auto sets = SC::sweep_silhouettes(ellipsoid, motion, eyes);
  for (const auto& set : sets)
    std::cout << set << '\n';

  Scene scene;
  for (const double t : {0., 0.5, 1.}) {
    const auto column = [&](std::size_t i) { return motion.axes[i](t) - CGAL::ORIGIN; };
    const auto [a, b, c, o] = std::array{column(0), column(1), column(2), motion.path(t) - CGAL::ORIGIN};
    scene.add(ellipsoid.transformed(K::Aff_transformation_3(a.x(), b.x(), c.x(), o.x(), a.y(), b.y(), c.y(), o.y(),
                                                            a.z(), b.z(), c.z(), o.z())),
              {200, 215, 235});
  }
  for (const SC::Surface_curve& curve : sets[0].curves()) {
    std::vector<K::Point_3> points;
    for (const auto& sample : sets[0].polyline(curve, 1e-3))
      points.push_back(sample.point);
    scene.add(points, "#c00020", 3, true);
  }
  std::ofstream out("sweep_silhouette.svg");
  scene.write(out);
  return std::all_of(sets.begin(), sets.end(), [](const auto& set) { return set.is_complete(); }) ? 0 : 3;
}
