// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed bisectors of points and spheres with surfaces.

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/trimmed_bisectors_3.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Point = K::Point_3;
using Vector = K::Vector_3;

namespace {

// One bicubic piece over a square, with heights that are multiples of those given, and so much as they are to the side.
Surface bicubic(double height)
{
  const double heights[4][4] = {{0, 0.2, -0.3, 0}, {0.2, -0.6, 0.6, 0}, {0, 0.9, -0.6, 0}, {0.1, -0.1, 0.1, 0.2}};
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i - 1.5 + 0.25 * height * heights[j][i], j - 1.5 + 0.25 * height * heights[3 - i][j],
                          height * heights[i][j]);
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  return Surface({3, 3}, knots, knots, points);
}

K::Sphere_3 ball(double radius) { return {Point(0, 0, 0), radius * radius}; }

const Surface plane = SC::plane_patch<K>(Point(-1.5, -1.5, 0), Vector(3, 0, 0), Vector(0, 3, 0)),
              sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1),
              cylinder = SC::cylinder_surface<K>(Point(0, 0, 0), 1, 4);

// Of a point, or of a sphere if the radius is not zero.
void trimmed_bisector(benchmark::State& state, const Surface& surface, const Point& center, double radius, double reach)
{
  std::size_t kept = 0, dropped = 0, undecided = 0;
  for (auto _ : state) {
    const SC::Trimmed_bisector_3 bisector = radius == 0
        ? SC::trimmed_point_surface_bisector(center, surface, ball(reach))
        : SC::trimmed_sphere_surface_bisector(center, radius, surface, ball(reach));
    kept = bisector.number_of_regions(SC::NEAREST);
    dropped = bisector.number_of_regions(SC::NOT_NEAREST);
    undecided = bisector.undecided().size();
  }
  state.counters["kept"] = static_cast<double>(kept);
  state.counters["dropped"] = static_cast<double>(dropped);
  state.counters["undecided"] = static_cast<double>(undecided);
}

#define TRIMMED_BISECTOR(name, surface, center, radius, reach)                                                         \
  BENCHMARK_CAPTURE(trimmed_bisector, name, surface, center, radius, reach)->Unit(benchmark::kMillisecond)

TRIMMED_BISECTOR(point_plane, plane, Point(0, 0, 1), 0, 8);
TRIMMED_BISECTOR(point_outside_of_sphere, sphere, Point(0, 0.25, 2.5), 0, 8);
TRIMMED_BISECTOR(point_inside_of_sphere, sphere, Point(0.25, -0.25, 0.5), 0, 8);
TRIMMED_BISECTOR(point_outside_of_cylinder, cylinder, Point(2.5, 0, 2), 0, 20);
TRIMMED_BISECTOR(point_inside_of_cylinder, cylinder, Point(0.25, 0, 2), 0, 20);
TRIMMED_BISECTOR(point_flat_bicubic, bicubic(0.125), Point(0, 0, 2), 0, 8);
TRIMMED_BISECTOR(point_bicubic, bicubic(1), Point(0, 0, 2), 0, 8);
TRIMMED_BISECTOR(spheres, sphere, Point(0, 0, 4), 1, 20);
TRIMMED_BISECTOR(sphere_cylinder, cylinder, Point(4, 0, 2), 1, 20);

} // namespace
