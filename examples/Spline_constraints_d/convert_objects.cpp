// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Objects of CGAL as splines, and splines as objects of CGAL, without rounding.
#include <CGAL/Spline_constraints_d/geometry/curves/clipped_lines.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Epeck;

int main()
{
  // The circle of radius sqrt(6) around the diagonal: no rational radius, and no rational length of the axis.
  const K::Circle_3 circle(K::Point_3(1, 2, 3), 6, K::Vector_3(1, 1, 1));
  const auto curve = SC::to_bspline_curve(circle);
  std::cout << "The circle is a curve of degree " << curve.degree() << " that begins at " << curve.source().exact()
            << ".\n";

  // Which circle is a part of it on, after its degree is raised?
  const auto back = SC::to_circle(curve.restricted(1, 2.5).elevated(4));
  const bool is_same = back && back->center() == circle.center() && back->squared_radius() == circle.squared_radius();
  std::cout << "A part of it is on " << (is_same ? "the same circle" : "another curve") << ".\n";

  // A ray through a corner of the unit square, and one past it.
  const K::Iso_rectangle_2 square(K::Point_2(0, 0), K::Point_2(1, 1));
  const auto touching = SC::to_bspline_curve(K::Ray_2(K::Point_2(2, 0), K::Point_2(1, 1)), square);
  const auto missing = SC::to_bspline_curve(K::Ray_2(K::Point_2(2, 0), K::Point_2(1, 1 + 0x1p-40)), square);
  std::cout << "One ray meets the square" << (touching ? "" : " not") << ", the other does" << (missing ? "" : " not")
            << ".\n";

  const bool is_right = is_same && touching && touching->source() == K::Point_2(1, 1) && !missing;
  return is_right ? 0 : 1;
}
