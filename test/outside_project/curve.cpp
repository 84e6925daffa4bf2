// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <vector>

namespace SC = CGAL::Spline_constraints;

int main()
{
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto curve = SC::bezier_curve(std::vector<Point>{{0, 0}, {1, 2}, {2, 0}});
  return curve(0.5) == Point(1, 1) ? 0 : 1;
}
