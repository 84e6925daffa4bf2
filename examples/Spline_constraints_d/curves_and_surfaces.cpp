// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves and surfaces over a kernel of CGAL: an exact circle, a spline through points, and the torus that a circle
// sweeps.
#include <CGAL/Spline_constraints_d/geometry/curves/cubic_interpolation.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;

int main()
{
  // A rational quadratic B-spline. Numbers of this kernel are exact, so all of its points lie on the circle, not near
  // it.
  const auto circle = SC::to_bspline_curve(K::Circle_2({0, 0}, 4));
  const K::Point_2 p = circle(K::FT(1) / 3);
  std::cout << "At 1/3 the circle is at (" << p.x().exact() << ", " << p.y().exact() << "), with the curvature "
            << circle.curvature(K::FT(1) / 3) << ".\n";
  bool is_exact = p.x() * p.x() + p.y() * p.y() == 4;

  // A cubic spline; a knot more does not change it, and can be taken away again.
  const std::vector<K::Point_2> points{{0, 0}, {1, 2}, {3, 3}, {4, 0}};
  const auto spline = SC::cubic_interpolation_curve(points);
  const auto finer = spline.with_knot(1.5);
  std::cout << "The spline has " << spline.size() << " control points, or " << finer.size() << ", and lies in the box "
            << spline.bbox() << ".\n";
  is_exact = is_exact && spline(2) == points[2] && finer == spline && finer.without_knot(1.5).has_value();

  // The circle with center (3,0,0) and radius 1 in the plane y = 0, turned about the z-axis.
  const auto profile = SC::circle_curve(K::Point_3(3, 0, 0), K::Vector_3(0, -1, 0), K::Point_3(4, 0, 0));
  const auto torus = SC::surface_of_revolution(profile, K::Point_3(0, 0, 0), K::Vector_3(0, 0, 1));
  std::cout << "The torus has Gaussian curvature " << torus.gaussian_curvature(0, 0) << " outside and "
            << torus.gaussian_curvature(0, 2) << " inside.\n";
  is_exact = is_exact && torus.is_closed(0) && torus.is_closed(1);

  // To a kernel of doubles, the numbers are rounded.
  const SC::Bspline_curve_2<CGAL::Simple_cartesian<double>> rounded(circle);
  std::cout << "In doubles, the circle at 1/3 is at (" << rounded(1.0 / 3) << ").\n";

  return is_exact ? 0 : 1;
}
