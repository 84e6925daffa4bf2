// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_REGION_OF_A_DRAWING_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_REGION_OF_A_DRAWING_H

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <vector>

// What drawings contain: segments on one line, one of them tiny, arcs that join them tangentially, a concentric hole,
// and a slit that leads to it and back. All points at most 2 from the segment between (0, 2) and (6, 2), but for those
// less than 1 from its end.
template <class K>
CGAL::Spline_constraints::Planar_region_2<K> region_of_a_drawing()
{
  using P = typename K::Point_2;
  namespace SC = CGAL::Spline_constraints;
  const auto segment = [](const P& p, const P& q) { return SC::segment_curve<K>(p, q); };
  const auto arc = [](double x, const P& p, const P& q) { return SC::circular_arc_curve(P(x, 2), p, q); };
  const double next = 2 + 0x1p-30;
  return SC::planar_region(std::vector<SC::Bspline_curve_2<K>>{
      segment(P(0, 0), P(2, 0)), segment(P(2, 0), P(next, 0)), segment(P(next, 0), P(6, 0)), segment(P(6, 0), P(6, 1)),
      SC::circle_curve(P(6, 2), 1.0), segment(P(6, 1), P(6, 0)), arc(6, P(6, 0), P(8, 2)), arc(6, P(8, 2), P(6, 4)),
      segment(P(6, 4), P(0, 4)), arc(0, P(0, 4), P(-2, 2)), arc(0, P(-2, 2), P(0, 0))});
}

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_REGION_OF_A_DRAWING_H
