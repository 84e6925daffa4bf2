// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// This package: intersections() of two Bezier curves, with exact decisions.
#include "curve_intersection.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <vector>

namespace peers {
namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

SC::Bspline_curve_2<K> curve_of(const Bezier_curve& curve)
{
  std::vector<K::Point_2> points;
  points.reserve(curve.size());
  for (const Control_point& p : curve)
    points.emplace_back(p.x, p.y);
  return SC::bezier_curve(points);
}

} // namespace

Run intersect_with_spline_constraints(const Bezier_curve& a, const Bezier_curve& b)
{
  const auto start = std::chrono::steady_clock::now();
  const SC::Bspline_curve_2<K> first = curve_of(a), second = curve_of(b);
  const std::chrono::duration<double> building = std::chrono::steady_clock::now() - start;
  const auto found = SC::intersections(first, second);

  const auto count = [&](SC::Intersection_kind kind) { return static_cast<int>(found.count(kind)); };
  Run run;
  run.answer.overlaps = count(SC::Intersection_kind::OVERLAP);
  run.answer.undecided = count(SC::Intersection_kind::UNDECIDED);
  run.answer.points = static_cast<int>(found.size()) - run.answer.overlaps - run.answer.undecided;
  const SC::Summary& summary = found.summary();
  run.phases = {.building = building.count(),
                .setup = summary.setup_seconds,
                .rebuilding = summary.rebuild_seconds,
                .nodes = summary.nodes,
                .rebuilds = summary.restarts};
  return run;
}

} // namespace peers
