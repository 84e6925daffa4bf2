// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The curve in which a surface meets itself: it runs from one pinch point to another one. Drawn into
// self_intersection_curves.svg, thin where the surface hides it.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/surface_curves/self_intersection_curves.h>

#include <cmath>
#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

// The polynomial surface (v (u^2 + v^2 - 1), u, v^2) over the square of -w <= u, v <= w, by its control points.
SC::Bspline_surface_3<K> pocket()
{
  const double w = 1.3125, w2 = w * w, w3 = w2 * w;   // all exact, thirds too
  const double u[] = {-w, 0, w}, u_squared[] = {w2, -w2, w2}, v[] = {-w, -w / 3, w / 3, w},
               v_squared[] = {w2, -w2 / 3, -w2 / 3, w2}, v_cubed[] = {-w3, w3, -w3, w3};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(v_cubed[j] + (u_squared[i] - 1) * v[j], u[i], v_squared[j]);
  return {{2, 3}, {-w, -w, -w, w, w, w}, {-w, -w, -w, -w, w, w, w, w}, points};
}

double rounded(double x) { return std::round(1e9 * x) / 1e9 + 0.0; }   // not -0

int main()
{
  const auto surface = pocket();
  const auto set = SC::self_intersection_curves(surface);

  Scene scene;
  scene.add(surface, {190, 210, 235});
  for (const SC::Intersection_curve& curve : set.curves()) {
    const std::vector<K::Point_3> points = set.polyline(curve, 1e-3);
    scene.add(points, "#c00020", 3, true);
    std::cout << (curve.is_closed ? "closed, " : "open, ") << points.size() << " points\n";
    for (const int side : {0, 1})
      if (const auto end = set.end(curve, side); end.kind() == SC::Intersection_kind::TANGENT)
        std::cout << "  ends in a pinch point at u = " << rounded(end.parameter(0, 0))
                  << ", v = " << rounded(end.parameter(0, 1)) << '\n';
  }
  std::ofstream out("self_intersection_curves.svg");
  scene.write(out);
  std::cout << set << '\n';
  return set.is_complete() ? 0 : 3;
}
