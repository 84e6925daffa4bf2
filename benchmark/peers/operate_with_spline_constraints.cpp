// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// This package: intersections(), intersection_curves() with polylines, and closest_points(), with exact decisions.
#include "operation_problems.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Simple_cartesian.h>

namespace peers {
namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

std::vector<K::Point_3> points_of(const Bezier_net& net)
{
  std::vector<K::Point_3> result;
  for (const auto& [x, y, z] : net.points)
    result.emplace_back(x, y, z);
  return result;
}

K::Point_3 point_of(const Bezier_net& net) { return points_of(net).front(); }

SC::Bspline_curve_3<K> curve_of(const Bezier_net& net) { return SC::bezier_curve(points_of(net)); }

SC::Bspline_surface_3<K> surface_of(const Bezier_net& net)
{
  const auto knots = [&](int axis) {
    std::vector<double> result(net.degrees[axis] + 1, 0.0);
    result.insert(result.end(), net.degrees[axis] + 1, 1.0);
    return result;
  };
  return {net.degrees, knots(0), knots(1), points_of(net)};
}

Run counted(const auto& intersections)
{
  const int undecided = static_cast<int>(intersections.count(SC::Intersection_kind::UNDECIDED)),
            overlaps = static_cast<int>(intersections.count(SC::Intersection_kind::OVERLAP));
  Run run;
  run.answer = {.points = static_cast<int>(intersections.size()) - undecided - overlaps,
                .overlaps = overlaps,
                .undecided = undecided};
  return run;
}

// Curves count that have a polyline.
Run drawn(const auto& intersection)
{
  Run run;
  for (const auto& curve : intersection.curves())
    run.answer.points += intersection.polyline(curve, curve_tolerance).size() > 1;
  run.answer.undecided = intersection.is_complete() ? 0 : 1;
  return run;
}

Run measured(const auto& closest)
{
  Run run;
  const auto [lower, upper] = closest.distance_range();
  run.answer = {.undecided = closest.is_complete() ? 0 : 1, .distance = lower / 2 + upper / 2};
  return run;
}

} // namespace

Run operate_with_spline_constraints(const Operation_problem& problem)
{
  const Bezier_net &first = problem.first, &second = problem.second;
  switch (problem.operation) {
  case Operation::CURVE_AND_SURFACE: return counted(SC::intersections(curve_of(first), surface_of(second)));
  case Operation::LINE_AND_SPHERE:
    return counted(SC::intersections(K::Line_3(points_of(first)[0], points_of(first)[1]),
                                     K::Sphere_3(point_of(second), problem.radius * problem.radius)));
  case Operation::SURFACES: return drawn(SC::intersection_curves(surface_of(first), surface_of(second)));
  case Operation::NEAREST_ON_CURVE: return measured(SC::closest_points(point_of(first), curve_of(second)));
  case Operation::NEAREST_ON_SURFACE: return measured(SC::closest_points(point_of(first), surface_of(second)));
  case Operation::NEAREST_OF_CURVES: break;
  }
  return measured(SC::closest_points(curve_of(first), curve_of(second)));
}

} // namespace peers
