// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// SISL: s1858 (surface and curve), s1371 (curve and sphere), s1859 and s1310 (two surfaces, and marching along their
// curves), s1953 and s1954 (nearest points of curve and surface), s1955 (nearest points of two curves).
#include "operation_problems.h"

#include <sisl.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <vector>

namespace peers {
namespace {

constexpr double unused_tolerance = 1e-6, tolerance = 1e-6;   // the distance at which two points count as one
constexpr int polynomial_spline = 1, dimension = 3, copy = 1;

using Curve = std::unique_ptr<SISLCurve, decltype(&freeCurve)>;
using Surface = std::unique_ptr<SISLSurf, decltype(&freeSurf)>;

std::vector<double> knots(int order)
{
  std::vector<double> result(2 * order, 0.0);
  std::fill(result.begin() + order, result.end(), 1.0);
  return result;
}

Curve curve_of(const Bezier_net& net)
{
  const int order = net.degrees[0] + 1;
  std::vector<double> coefficients;
  for (const auto& p : net.points)
    coefficients.insert(coefficients.end(), p.begin(), p.end());
  return Curve(newCurve(order, order, knots(order).data(), coefficients.data(), polynomial_spline, dimension, copy),
               freeCurve);
}

// The first axis is the fastest.
Surface surface_of(const Bezier_net& net)
{
  const int rows = net.degrees[0] + 1, columns = net.degrees[1] + 1;
  std::vector<double> coefficients;
  for (int j = 0; j < columns; ++j)
    for (int i = 0; i < rows; ++i)
      coefficients.insert(coefficients.end(), net.points[i * columns + j].begin(), net.points[i * columns + j].end());
  return Surface(newSurf(rows, columns, rows, columns, knots(rows).data(), knots(columns).data(), coefficients.data(),
                         polynomial_spline, dimension, copy),
                 freeSurf);
}

using Point = std::array<double, 3>;

Point point_on(SISLCurve* curve, double parameter)
{
  Point result;
  int left = 0, status = 0;
  s1221(curve, 0, parameter, &left, result.data(), &status);
  return result;
}

Point point_on(SISLSurf* surface, double* parameters)
{
  Point result, normal;
  int left = 0, other_left = 0, status = 0;
  s1421(surface, 0, parameters, &left, &other_left, result.data(), normal.data(), &status);
  return result;
}

double distance(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

// What the functions return: parameters of points on the first operand and, of some, on the second one, and curves.
struct Result
{
  int points = 0, curves = 0, status = 0;
  double *first = nullptr, *second = nullptr;
  SISLIntcurve** overlaps = nullptr;

  ~Result()
  {
    std::free(first);
    std::free(second);
    if (overlaps != nullptr)
      freeIntcrvlist(overlaps, curves);
  }

  Run counted() const
  {
    return {.answer = {.points = points, .overlaps = curves, .has_failed = status < 0}, .phases = {}};
  }

  // The number of curves that marching has made points of.
  Run marched(SISLSurf* one, SISLSurf* other) const
  {
    constexpr int curves_in_space = 1, no_graphics = 0;
    constexpr double any_step = 0;
    int marched = 0;
    for (int i = 0; i < curves; ++i) {
      int own_status = 0;
      s1310(one, other, overlaps[i], curve_tolerance, any_step, curves_in_space, no_graphics, &own_status);
      marched += own_status >= 0 && overlaps[i]->pgeom != nullptr;
    }
    return {.answer = {.points = marched, .has_failed = status < 0}, .phases = {}};
  }

  // The least one of the points.
  template <class Distance>
  Run measured(const Distance& distance_of) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < points; ++i)
      least = std::fmin(least, distance_of(i));
    return {.answer = {.has_failed = status < 0 || points == 0, .distance = least}, .phases = {}};
  }
};

} // namespace

Run operate_with_sisl(const Operation_problem& problem)
{
  Point point = problem.first.points[0], center = problem.second.points[0];
  Result r;
  switch (problem.operation) {
  case Operation::CURVE_AND_SURFACE:
    s1858(surface_of(problem.second).get(), curve_of(problem.first).get(), unused_tolerance, tolerance, &r.points,
          &r.first, &r.second, &r.curves, &r.overlaps, &r.status);
    return r.counted();
  case Operation::LINE_AND_SPHERE:
    s1371(curve_of(problem.first).get(), center.data(), problem.radius, dimension, unused_tolerance, tolerance,
          &r.points, &r.first, &r.curves, &r.overlaps, &r.status);
    return r.counted();
  case Operation::SURFACES: {
    const Surface first = surface_of(problem.first), second = surface_of(problem.second);
    s1859(first.get(), second.get(), unused_tolerance, tolerance, &r.points, &r.first, &r.second, &r.curves,
          &r.overlaps, &r.status);
    return r.marched(first.get(), second.get());
  }
  case Operation::NEAREST_ON_CURVE: {
    const Curve curve = curve_of(problem.second);
    s1953(curve.get(), point.data(), dimension, unused_tolerance, tolerance, &r.points, &r.first, &r.curves,
          &r.overlaps, &r.status);
    return r.measured([&](int i) { return distance(point, point_on(curve.get(), r.first[i])); });
  }
  case Operation::NEAREST_ON_SURFACE: {
    const Surface surface = surface_of(problem.second);
    s1954(surface.get(), point.data(), dimension, unused_tolerance, tolerance, &r.points, &r.first, &r.curves,
          &r.overlaps, &r.status);
    return r.measured([&](int i) { return distance(point, point_on(surface.get(), r.first + 2 * i)); });
  }
  case Operation::NEAREST_OF_CURVES: break;
  }
  const Curve first = curve_of(problem.first), second = curve_of(problem.second);
  s1955(first.get(), second.get(), unused_tolerance, tolerance, &r.points, &r.first, &r.second, &r.curves, &r.overlaps,
        &r.status);
  return r.measured(
      [&](int i) { return distance(point_on(first.get(), r.first[i]), point_on(second.get(), r.second[i])); });
}

} // namespace peers
