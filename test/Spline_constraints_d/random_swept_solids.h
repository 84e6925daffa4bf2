// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random solids between two bicubic surfaces with a common boundary, which move along cubic curves and turn; and their
// swept volumes beside random points, of which it is proved whether they are swept.
#ifndef RANDOM_SWEPT_SOLIDS_H
#define RANDOM_SWEPT_SOLIDS_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/internal/aabb_trees.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/swept_volumes.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace random_swept_solids {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;
using Point = K::Point_3;
using Surface = SC::Bspline_surface_3<K>;
using Motion = SC::Rational_motion_3;

struct Random_sweep
{
  std::vector<Surface> solid;
  Motion motion;
};

inline Random_sweep random_sweep(unsigned seed)
{
  std::mt19937 random(seed);
  const auto number = [&](int low, int high) -> Rational { // in hundredths
    return Rational(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1))) / 100;
  };
  std::array<std::vector<Point>, 2> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Rational x = Rational(i) / 3 + number(-8, 8), y = Rational(j) / 3 + number(-8, 8), z = number(-10, 10);
      const bool is_inner = i % 3 != 0 && j % 3 != 0;
      points[0].emplace_back(x, y, is_inner ? z + number(20, 90) : z);
      points[1].emplace_back(x, y, is_inner ? z - number(20, 90) : z);
    }
  const auto surface = [](const std::vector<Point>& net) {
    return Surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, net);
  };
  std::vector<Point> path;
  for (int k = 0; k < 4; ++k)
    path.emplace_back(number(-150, 150), number(-150, 150), number(-150, 150));
  const auto linear = [&](const Rational& begin, const Rational& end) {
    return Motion::Function({1}, {{0, 0, 1, 1}}, {begin, end});
  };
  const Motion turn = Motion::rotation(
      {linear(1, 1), linear(0, number(-60, 60)), linear(0, number(-60, 60)), linear(0, number(-60, 60))});
  return {{surface(points[0]), surface(points[1]).transposed()},
          Motion::along(SC::Bspline_curve_3<K>(3, {0, 0, 0, 0, 1, 1, 1, 1}, path)) * turn};
}

struct Comparison
{
  std::size_t points = 0; // that were decided
  std::size_t wrong = 0;  // of these, on the wrong side of the mesh, and farther from it than its error
  double volume = 0;      // by the points that are swept
  double deviation = 0;   // of this volume
};

inline Comparison compare(const Random_sweep& sweep, const SC::Swept_volume_3& swept, std::size_t count, unsigned seed)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
  using Primitive = CGAL::AABB_face_graph_triangle_primitive<Mesh>;
  using Tree = SC::internal::Aabb_tree_3<Kernel, Primitive>;
  Mesh mesh;
  CGAL::copy_face_graph(swept.mesh(), mesh);
  const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(mesh);
  Tree tree(faces(mesh).first, faces(mesh).second, mesh);
  tree.accelerate_distance_queries();
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  std::mt19937 random(seed);
  const auto between = [&](double low, double high) {
    return std::ldexp(std::floor(std::ldexp(low + (high - low) * (random() % 4096) / 4096, 20)), -20);
  };
  Comparison result;
  std::size_t inside = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Kernel::Point_3 p(between(box.xmin(), box.xmax()), between(box.ymin(), box.ymax()),
                            between(box.zmin(), box.zmax()));
    const auto intervals = SC::sweep_intervals(sweep.solid, sweep.motion, Point(p.x(), p.y(), p.z()));
    if (!intervals)
      continue;
    ++result.points;
    inside += !intervals->empty();
    if (intervals->empty() == (side(p) != CGAL::ON_UNBOUNDED_SIDE) &&
        tree.squared_distance(p) > swept.error() * swept.error())
      ++result.wrong;
  }
  const double all = box.x_span() * box.y_span() * box.z_span(), expected = swept.volume() / all;
  result.volume = all * static_cast<double>(inside) / static_cast<double>(result.points);
  result.deviation = all * std::sqrt(expected * (1 - expected) / static_cast<double>(result.points));
  return result;
}

} // namespace random_swept_solids

#endif // RANDOM_SWEPT_SOLIDS_H
