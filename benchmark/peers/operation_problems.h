// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_OPERATION_PROBLEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_OPERATION_PROBLEMS_H

#include "curve_intersection.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

// Operations in space on Bezier curves and surfaces, with answers that are known.
namespace peers {

// A point (both degrees are 0), a Bezier curve (the second one is) or surface: control points row by row, the second
// axis fastest.
struct Bezier_net
{
  std::array<int, 2> degrees;
  std::vector<std::array<double, 3>> points;
};

enum class Operation
{
  CURVE_AND_SURFACE,
  LINE_AND_SPHERE,
  SURFACES,
  NEAREST_ON_CURVE,
  NEAREST_ON_SURFACE,
  NEAREST_OF_CURVES
};

// Curves that two surfaces have in common are handed over as polylines or splines at this distance at most.
constexpr double curve_tolerance = 1e-3;

struct Operation_problem
{
  std::string name;
  std::string description;
  Operation operation;
  // a line is a segment of it; a sphere its center; the point whose nearest one is wanted comes first
  Bezier_net first, second;
  double radius;              // of the sphere
  Intersections truth;
};

// A surface over [x0,x1]^2 of the plane, with these heights of its control points.
template <class Height>
Bezier_net height_field(int degree, double x0, double x1, const Height& height)
{
  Bezier_net result{{degree, degree}, {}};
  const auto place = [&](int i) { return x0 + (x1 - x0) * i / degree; };
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      result.points.push_back({place(i), place(j), height(i, j)});
  return result;
}

// Pairs of surfaces with closed curves, and open ones, in common.
inline std::vector<Operation_problem> surface_problems()
{
  const auto curves = [](int count) { return Intersections{.points = count}; };
  const double a[] = {-1, 5, -5, 1}, h[] = {1, 3, 9, -2, 2, -1, -4, 8, -6, -9, 6, -7, 4, -7, 4, 8};
  const auto waves = [&](int i, int j) { return 10 * (a[i] + a[j]); };
  const auto plane = [](double x0, double x1, double z) {
    return height_field(1, x0, x1, [z](int, int) { return z; });
  };
  // z = (x - 0.37)^2 + (y - 0.61)^2 above the unit square
  const auto bowl = height_field(2, 0, 1, [](int i, int j) {
    const auto squared = [](double c, int k) { return k == 0 ? c * c : k == 1 ? c * c - c : (1 - c) * (1 - c); };
    return squared(0.37, i) + squared(0.61, j);
  });
  using enum Operation;
  return {
      {"d1", "two bicubic surfaces: 1 loop, 3 arcs (quoted, other machine: GoTools 580)", SURFACES,
       height_field(3, 0, 3, [&](int i, int j) { return waves(i, j) + h[4 * i + j]; }),
       height_field(3, 0, 3, [&](int i, int j) { return 19 + h[4 * i + j]; }), 0, curves(4)},
      {"d5", "bicubic surface and plane: 1 loop, 3 arcs (quoted, other machine: GoTools 116)", SURFACES,
       height_field(3, 0, 3, waves), plane(-1, 4, 19), 0, curves(4)},
      {"l1", "bowl and plane: a loop of radius 0.005", SURFACES, bowl, plane(0, 1, 0.005 * 0.005), 0, curves(1)},
      {"l2", "bowl and plane: a loop of radius 0.0005", SURFACES, bowl, plane(0, 1, 0.0005 * 0.0005), 0, curves(1)}};
}

inline std::vector<Operation_problem> operation_problems()
{
  const auto curve = [](std::vector<std::array<double, 3>> points) {
    return Bezier_net{{static_cast<int>(points.size()) - 1, 0}, points};
  };
  const auto points = [](int count) { return Intersections{.points = count}; };
  const auto distance = [](double d) { return Intersections{.distance = d}; };
  Bezier_net hill{{3, 3}, {}}, paraboloid{{2, 2}, {}};   // z = x^2 + 2 y^2 on [-1,1]^2
  const int heights[] = {0, 1, 1, 0, 1, 3, 2, 1, 1, 2, 3, 1, 0, 1, 1, 0}, squares[] = {1, -1, 1};
  for (int i = 0; i < 16; ++i)
    hill.points.push_back({2.0 * (i / 4), 2.0 * (i % 4), 1.0 * heights[i]});
  for (int i = 0; i < 9; ++i)
    paraboloid.points.push_back({i / 3 - 1.0, i % 3 - 1.0, squares[i / 3] + 2.0 * squares[i % 3]});
  const Bezier_net weave =
      curve({{0.5, 5, 2.5}, {1.5, 5, -10.5}, {2.5, 4, 26}, {3.5, 2, -21}, {4.5, 1, 12.5}, {5.5, 1, -1.5}});
  const Bezier_net parabola = curve({{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}),
                   cubic = curve({{0, 0, 0}, {1, 1, 0}, {2, -1, 0}, {3, 0, 0}});
  // Of the tangent of the sphere around the origin with radius 3 in (2,1,2), moved outwards by a factor.
  const auto tangent = [&](double factor) {
    return curve({{6 * factor, -7 * factor, 2 * factor}, {-2 * factor, 9 * factor, 2 * factor}});
  };
  const Bezier_net origin = curve({{0, 0, 0}});
  using enum Operation;
  return {
      {"c1", "curve of degree 5 through a bicubic surface", CURVE_AND_SURFACE, weave, hill, 0, points(5)},
      {"c2", "line through a sphere", LINE_AND_SPHERE, curve({{-3, -1.5, -6}, {3.5, 2.25, 6}}), origin, 3, points(2)},
      {"c3", "line that touches a sphere", LINE_AND_SPHERE, tangent(1), origin, 3, points(1)},
      {"c4", "the same 3e-10 beside it", LINE_AND_SPHERE, tangent(1 + 1e-10), origin, 3, points(0)},
      {"n1", "point and parabola, 2 nearest points", NEAREST_ON_CURVE, curve({{0, 1, 0}}), parabola, 0,
       distance(std::sqrt(3.0) / 2)},
      {"n2", "point and cubic, the nearest point is an end", NEAREST_ON_CURVE, curve({{4, 1, 1}}), cubic, 0,
       distance(std::sqrt(3.0))},
      {"n3", "point and paraboloid, 2 nearest points", NEAREST_ON_SURFACE, curve({{0, 0, 1}}), paraboloid, 0,
       distance(std::sqrt(7.0) / 4)},
      {"n4", "two parabolas, 2 nearest pairs", NEAREST_OF_CURVES, curve({{-2, 4, 0}, {0, -4, 0}, {2, 4, 0}}),
       curve({{-2, -2, 1}, {0, 6, 1}, {2, -2, 1}}), 0, distance(1)},
      {"n5", "two cubics, nearest at ends", NEAREST_OF_CURVES, cubic,
       curve({{4, 1, 1}, {5, 2, 1}, {6, 0, 1}, {7, 1, 1}}), 0, distance(std::sqrt(3.0))}};
}

// One run of an operation, from the control points to the answer. The caller fills `phases.total`.
Run operate_with_spline_constraints(const Operation_problem& problem);
// The same, where curves and surfaces have been prepared before the run.
Run operate_with_prepared_splines(const Operation_problem& problem);
Run operate_with_sisl(const Operation_problem& problem);
Run operate_with_open_cascade(const Operation_problem& problem);

} // namespace peers

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_OPERATION_PROBLEMS_H
