// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The curve in which a surface meets itself: it runs from one pinch point to another one. Drawn into self_intersection_curves.svg, thin where the surface hides it.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/self_intersection_curves.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

// The polynomial surface (v (u^2 + v^2 - 1), u, v^2) over the square of -1.5 <= u, v <= 1.5, by its control points.
SC::Bspline_surface_3<K> pocket()
{
  const double u[] = {-1.5, 0, 1.5}, u_squared[] = {2.25, -2.25, 2.25}, v[] = {-1.5, -0.5, 0.5, 1.5}, v_squared[] = {2.25, -0.75, -0.75, 2.25}, v_cubed[] = {-3.375, 3.375, -3.375, 3.375};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(v_cubed[j] + (u_squared[i] - 1) * v[j], u[i], v_squared[j]);
  return {{2, 3}, {-1.5, -1.5, -1.5, 1.5, 1.5, 1.5}, {-1.5, -1.5, -1.5, -1.5, 1.5, 1.5, 1.5, 1.5}, points};
}

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
    for (const int side : {0, 1}) {
      const auto end = set.end(curve, side);
      std::cout << "  end (" << end.point() << "), (u, v) = (" << end.parameter(0, 0) << ", " << end.parameter(0, 1) << ") and (" << end.parameter(1, 0) << ", " << end.parameter(1, 1) << ")"
                << (end.kind() == SC::Intersection_kind::TANGENT ? ", a pinch point\n" : "\n");
    }
  }
  std::ofstream out("self_intersection_curves.svg");
  scene.write(out);
  std::cout << set << '\n';
  return set.is_complete() ? 0 : 3;
}
