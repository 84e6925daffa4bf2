// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The silhouettes of the tube that a ball sweeps along a cubic curve, while the eye moves: when they change, and a
// picture of each topology. Tube and silhouettes are drawn from one place, whichever way the eye looks: the silhouettes
// are red, thin where the ball hides them in one of some positions, with dots where the next events are, black ones
// where branches reconnect, blue ones where a curve is born or dies.
//
// Writes sweep_silhouette_events.svg. Exit status: 0 when nothing is undecided, else 3.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouette_events.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Curve = SC::Bspline_curve_3<K>;

int main()
{
  const Surface ball = SC::sphere_surface<K>(K::Point_3(0, 0, 0), 1);
  const SC::Affine_motion<K> motion{
      Curve(3, {0, 0, 0, 0, 1, 1, 1, 1}, {{-4, -2, 0}, {-1, 4, 1}, {1, -5, 2}, {4, 2, 0}}), {}};
  const Curve eye(1, {0, 0, 1, 1}, {{3, -9, 0.2}, {-9, -3, 0.3}});
  const auto events = SC::sweep_silhouette_events(ball, motion, eye);
  std::cout << events;

  const std::vector<SC::Exact_rational> times = events.times_between();
  std::vector<K::Point_3> eyes;
  for (const SC::Exact_rational& time : times)
    eyes.push_back(eye(CGAL::to_double(time)));
  const auto sets = SC::sweep_silhouettes(ball, motion, eyes);
  Scene scene;
  bool is_complete = events.is_complete();
  for (std::size_t i = 0; i < sets.size(); ++i) {
    std::cout << "at the time " << CGAL::to_double(times[i]) << ": " << sets[i] << '\n';
    is_complete = is_complete && sets[i].is_complete();
    const K::Vector_3 offset = 12 * static_cast<double>(i % 2) * Scene::to_the_right() -
        K::Vector_3(0, 0, 8 * std::floor(static_cast<double>(i) / 2));
    for (int position = 0; position <= 7; ++position)
      scene.add(ball.transformed(
                    K::Aff_transformation_3(CGAL::TRANSLATION, motion.path(position / 7.0) - CGAL::ORIGIN + offset)),
                {205, 218, 235}, 9);
    for (const SC::Surface_curve& curve : sets[i].curves()) {
      std::vector<K::Point_3> points;
      for (const auto& sample : sets[i].polyline(curve, 1e-2))
        points.push_back(sample.point + offset);
      scene.add(points, "#c00020", 3, true);
    }
    for (const auto& event : events.events())
      if (times[i] < event.time.first && (i + 1 == times.size() || event.time.first < times[i + 1]))
        scene.mark(event.point + offset, event.kind == SC::Silhouette_event_kind::RECONNECTION ? "black" : "#0050e0");
  }
  std::ofstream out("sweep_silhouette_events.svg");
  scene.write(out);
  return is_complete ? 0 : 3;
}
