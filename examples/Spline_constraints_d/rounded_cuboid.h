// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A cube with rounded edges, in exact numbers: 6 squares, 12 quarters of cylinders and 8 octants of spheres, with
// common parameters along common edges.
#ifndef ROUNDED_CUBOID_H
#define ROUNDED_CUBOID_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <vector>

namespace rounded_cuboid {

using Number = CGAL::Spline_constraints::Exact_rational;
using Kernel = CGAL::Simple_cartesian<Number>;
using Surface = CGAL::Spline_constraints::Bspline_surface_3<Kernel>;
using Function = CGAL::Spline_constraints::Bspline_function<Number>;

// Bernstein coefficients of homogeneous coordinates x, y, z, w.
using Net = std::vector<std::array<Number, 4>>;

inline Surface surface(int degree_u, int degree_v, const Net& net)
{
  const auto knots = [](int degree) {
    std::vector<Number> result(2 * static_cast<std::size_t>(degree) + 2, Number(0));
    for (std::size_t i = 0; i <= static_cast<std::size_t>(degree); ++i)
      result[i + static_cast<std::size_t>(degree) + 1] = 1;
    return result;
  };
  const auto function = [&](std::size_t coordinate) {
    std::vector<Number> coefficients;
    for (const auto& point : net)
      coefficients.push_back(point[coordinate]);
    return Function({degree_u, degree_v}, {knots(degree_u), knots(degree_v)}, coefficients);
  };
  return Surface::from_homogeneous_coordinates({function(0), function(1), function(2)}, function(3));
}

// With normals to the center, or from it.
inline Surface oriented(const Surface& surface, bool is_inward)
{
  const Number half = Number(1) / 2;
  const bool points_outward = surface.normal(half, half) * (surface(half, half) - CGAL::ORIGIN) > 0;
  return points_outward == is_inward ? surface.transposed() : surface;
}

// A quarter of the unit circle from one axis to the next: (1 - t^2, 2 t) / (1 + t^2).
constexpr int along_first[3] = {1, 1, 0}, along_second[3] = {0, 1, 2}, weight[3] = {1, 1, 2};

// The squares |x_i| = size + radius, |x_j|, |x_k| <= size, and what is between them.
inline std::vector<Surface> surfaces(const Number& size, const Number& radius, bool is_inward)
{
  std::vector<Surface> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    for (const int side : {-1, 1}) {
      Net square;
      for (const int i : {-1, 1})
        for (const int j : {-1, 1}) {
          auto& point = square.emplace_back();
          point[axis] = side * (size + radius);
          point[first] = i * size;
          point[second] = j * size;
          point[3] = 1;
        }
      result.push_back(oriented(surface(1, 1, square), is_inward));
    }
    for (const int i : {-1, 1})
      for (const int j : {-1, 1}) { // along the axis
        Net quarter;
        for (const int end : {-1, 1})
          for (std::size_t k = 0; k < 3; ++k) {
            auto& point = quarter.emplace_back();
            point[axis] = end * size * weight[k];
            point[first] = i * (size * weight[k] + radius * along_first[k]);
            point[second] = j * (size * weight[k] + radius * along_second[k]);
            point[3] = weight[k];
          }
        result.push_back(oriented(surface(1, 2, quarter), is_inward));
      }
  }
  for (const int x : {-1, 1})
    for (const int y : {-1, 1})
      for (const int z : {-1, 1}) {
        Net octant;
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j) {
            const Number w = weight[i] * weight[j];
            octant.push_back({x * (size * w + radius * along_first[i] * along_first[j]),
                              y * (size * w + radius * along_first[i] * along_second[j]),
                              z * (size * w + radius * along_second[i] * weight[j]), w});
          }
        result.push_back(oriented(surface(2, 2, octant), is_inward));
      }
  return result;
}

} // namespace rounded_cuboid

#endif // ROUNDED_CUBOID_H
