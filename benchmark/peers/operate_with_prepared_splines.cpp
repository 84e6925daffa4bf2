// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// This package with curves and surfaces that are prepared once: distances by locators.
#include "operation_problems.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>
#include <CGAL/Spline_constraints_d/operations/distances/Surface_locator_3.h>

#include <CGAL/Simple_cartesian.h>

#include <optional>

namespace peers {
namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

K::Point_3 point_of(const Bezier_net& net) { return {net.points[0][0], net.points[0][1], net.points[0][2]}; }

SC::Curve_locator_3<K> locator_of_curve(const Bezier_net& net)
{
  std::vector<K::Point_3> points;
  for (const auto& [x, y, z] : net.points)
    points.emplace_back(x, y, z);
  return SC::Curve_locator(SC::bezier_curve(points));
}

SC::Surface_locator_3<K> locator_of_surface(const Bezier_net& net)
{
  const auto knots = [&](int axis) {
    std::vector<double> result(net.degrees[axis] + 1, 0.0);
    result.insert(result.end(), net.degrees[axis] + 1, 1.0);
    return result;
  };
  std::vector<K::Point_3> points;
  for (const auto& [x, y, z] : net.points)
    points.emplace_back(x, y, z);
  return SC::Surface_locator_3(SC::Bspline_surface_3<K>(net.degrees, knots(0), knots(1), points));
}

// Of the problem that was asked for last.
struct Prepared
{
  const Operation_problem* problem = nullptr;
  std::optional<SC::Curve_locator_3<K>> first, second;
  std::optional<SC::Surface_locator_3<K>> surface;

  void prepare(const Operation_problem& next)
  {
    if (problem == &next)
      return;
    problem = &next;
    if (next.operation == Operation::NEAREST_ON_SURFACE)
      surface = locator_of_surface(next.second);
    else
      second = locator_of_curve(next.second);
    if (next.operation == Operation::NEAREST_OF_CURVES)
      first = locator_of_curve(next.first);
  }
};

Run measured(const std::pair<double, double>& range, bool is_complete = true)
{
  Run run;
  run.answer = {.undecided = is_complete ? 0 : 1, .distance = range.first / 2 + range.second / 2};
  return run;
}

} // namespace

Run operate_with_prepared_splines(const Operation_problem& problem)
{
  static Prepared prepared;
  switch (problem.operation) {
  case Operation::NEAREST_ON_CURVE:
    prepared.prepare(problem);
    return measured(prepared.second->closest_point(point_of(problem.first)).distance_range());
  case Operation::NEAREST_ON_SURFACE:
    prepared.prepare(problem);
    return measured(prepared.surface->closest_point(point_of(problem.first)).distance_range());
  case Operation::NEAREST_OF_CURVES: {
    prepared.prepare(problem);
    const auto closest = SC::closest_points(*prepared.first, *prepared.second);
    return measured(closest.distance_range(), closest.is_complete());
  }
  default:
    return operate_with_spline_constraints(problem); // nothing is prepared
  }
}

} // namespace peers
