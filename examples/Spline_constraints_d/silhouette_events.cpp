// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The silhouettes of a surface while the direction of a parallel view rises from the horizontal plane: when they change
// their topology, and a picture of each topology.
//
//   silhouette_events [--time-limit S] [--output FILE.svg]
//
// The surface has two hills. Four frames show it with its silhouettes in red at the first times between events, with
// dots where the next events are: blue ones where a curve dies or is born, black ones where branches reconnect. Exit
// status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include "arguments.h"
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouette_events.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>

#include <CGAL/number_utils.h>

#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Path = SC::Bspline_curve_3<K>;

Surface two_hills()
{
  constexpr int n = 8;
  const double height[n][n] = {{0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 1, 1, 0, 0, 0}, {0, 0, 1, 5, 5, 1, 0, 0},
                               {0, 0, 1, 2, 2, 1, 0, 0}, {0, 0, 0, 1, 1, 0, 0, 0}, {0, 0, 3, 3, 1, 0, 0, 0},
                               {0, 0, 2, 3, 1, 0, 0, 0}, {0, 0, 0, 0, 0, 0, 0, 0}};
  std::vector<K::Point_3> points;
  std::vector<double> knots{0, 0, 0};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.emplace_back(i, j, height[i][j]);
  for (int i = 0; i <= n - 3; ++i)
    knots.push_back(i);
  knots.insert(knots.end(), 3, n - 3);
  return Surface({3, 3}, knots, knots, points);
}

// One frame: the surface moved aside, its silhouettes, and dots for events.
void draw(Scene& scene, const Surface& surface, const SC::Surface_curves_3<K>& set, const K::Vector_3& offset,
          const std::vector<SC::Silhouette_event<K>>& events)
{
  scene.add(surface.transformed(K::Aff_transformation_3(CGAL::TRANSLATION, offset)), {190, 210, 235}, 18);
  for (const SC::Surface_curve& curve : set.curves()) {
    std::vector<K::Point_3> points;
    for (const auto& sample : set.polyline(curve, 1e-3))
      points.push_back(sample.point + offset);
    scene.add(points, "#c00020", 3, true);
  }
  for (const auto& event : events)
    scene.mark(event.point + offset, event.kind == SC::Silhouette_event_kind::RECONNECTION ? "black" : "#0050e0");
}

int main(int argc, char* argv[])
{
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    std::string output = "silhouette_events.svg";
    SC::Solver_options options;
    for (std::size_t i = 0; i < words.size(); i += 2)
      if (i + 1 < words.size() && words[i] == "--output")
        output = words[i + 1];
      else if (i + 1 < words.size() && words[i] == "--time-limit")
        options.time_limit = number_of<double>(words[i + 1]);
      else
        throw SC::Invalid_input("usage: silhouette_events [--time-limit S] [--output FILE.svg]");
    const Surface surface = two_hills();
    const Path directions(2, {0, 0, 0, 1, 1, 1}, {K::Point_3(1, 8, 0.5), K::Point_3(1, 8, 6), K::Point_3(1, 8, 50)});
    const Options_of_program remaining(options);
    const auto events = SC::parallel_silhouette_events(surface, directions, options);
    std::cout << events;

    constexpr std::size_t frames = 4;
    Scene scene;
    const std::vector<SC::Exact_rational> times = events.times_between();
    bool is_complete = events.is_complete();
    for (std::size_t i = 0; i < times.size(); ++i) {
      const auto set = SC::silhouettes(surface, directions(CGAL::to_double(times[i])) - CGAL::ORIGIN, remaining());
      std::cout << "at the time " << CGAL::to_double(times[i]) << ": " << set << '\n';
      is_complete = is_complete && set.is_complete();
      if (i >= frames)
        continue;
      std::vector<SC::Silhouette_event<K>> next;
      for (const auto& event : events.events())
        if (times[i] < event.time.first && (i + 1 == times.size() || event.time.first < times[i + 1]))
          next.push_back(event);
      const double right = 9.5 * static_cast<double>(i % 2), down = 7.5 * std::floor(static_cast<double>(i) / 2);
      draw(scene, surface, set, right * Scene::to_the_right() - K::Vector_3(0, 0, down), next);
    }
    std::ofstream out(output);
    scene.write(out);
    return is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
