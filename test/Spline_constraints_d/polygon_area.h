// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The area of polygons with holes, to compare sums with those of CGAL.

#ifndef SPLINE_CONSTRAINTS_D_TEST_POLYGON_AREA_H
#define SPLINE_CONSTRAINTS_D_TEST_POLYGON_AREA_H

#include <CGAL/Polygon_with_holes_2.h>

template <class Kernel>
double area(const CGAL::Polygon_with_holes_2<Kernel>& polygon)
{
  double result = CGAL::to_double(polygon.outer_boundary().area());
  for (const auto& hole : polygon.holes())
    result += CGAL::to_double(hole.area());
  return result;
}

#endif // SPLINE_CONSTRAINTS_D_TEST_POLYGON_AREA_H
