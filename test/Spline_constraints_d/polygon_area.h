// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The area of polygons with holes.

#ifndef SPLINE_CONSTRAINTS_D_TEST_POLYGON_AREA_H
#define SPLINE_CONSTRAINTS_D_TEST_POLYGON_AREA_H

#include <CGAL/Polygon_with_holes_2.h>

#include <vector>

template <class Kernel>
double area(const CGAL::Polygon_with_holes_2<Kernel>& polygon)
{
  double result = CGAL::to_double(polygon.outer_boundary().area());
  for (const auto& hole : polygon.holes())
    result += CGAL::to_double(hole.area());
  return result;
}

template <class Kernel>
double total_area(const std::vector<CGAL::Polygon_with_holes_2<Kernel>>& polygons)
{
  double result = 0;
  for (const auto& polygon : polygons)
    result += area(polygon);
  return result;
}

#endif // SPLINE_CONSTRAINTS_D_TEST_POLYGON_AREA_H
