// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Minkowski sums of regions with nearly straight arcs, turned so that both coordinates of all tangents vary much more
// than their direction.
#include "geometry_test_tools.h"
#include "polygon_area.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>

#include <gtest/gtest.h>

#include <vector>

namespace nearly_straight_sums {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;
using Region = SC::Planar_region_2<K>;

// Five times as large, with exact coordinates.
Region turned(const Region& region)
{
  Curves curves;
  for (const auto& curve : region.curves())
    curves.push_back(curve.transformed(CGAL::Aff_transformation_2<K>(3, -4, 4, 3)));
  return SC::planar_region(curves);
}

// What is above a curve and below y = 5.
Region above(const std::vector<Point>& curve)
{
  const Point first = curve.front(), last = curve.back();
  return SC::planar_region(
      Curves{SC::bezier_curve<K>(curve), SC::polyline_curve<K>({last, {last.x(), 5}, {first.x(), 5}, first})});
}

// The area of a sum of one part without holes, with a polygon 0.0001 away.
double area_of_one_part(const SC::Minkowski_sum_2<K>& sum)
{
  EXPECT_TRUE(sum.is_complete());
  EXPECT_EQ(sum.boundaries().size(), 1U);
  return total_area(sum.polygons_with_holes(1e-4));
}

// A region A above an arc with an inflection, added to itself: the area is between 4 |A| and four times that of its
// hull.
TEST(NearlyStraightSums, EqualInflections)
{
  for (const double e : {0x1p-4, 0x1p-10, 0x1p-14}) {
    const Region region = turned(above({{0, 0}, {1, e}, {3, -e}, {6, e / 2}}));
    // the error of polygons, along less than 300
    EXPECT_NEAR(area_of_one_part(SC::minkowski_sum(region, region)), 4 * 25 * 30, 4 * 25 * 6 * e + 0.03);
  }
}

// Of an arc that turns to both sides and a nearly straight one.
TEST(NearlyStraightSums, AlongAWave)
{
  const Region wave = above({{0, -1}, {1, 1}, {3, -1}, {6, 1}});
  for (const double e : {0x1p-4, 0x1p-14, 0x1p-20}) {
    const Region flat = above({{-2, 0}, {0, e}, {4, -e}});
    EXPECT_NEAR(area_of_one_part(SC::minkowski_sum(turned(wave), turned(flat))),
                25 * area_of_one_part(SC::minkowski_sum(wave, flat)), 25 * 0.01 + 0.03);
  }
}

} // namespace nearly_straight_sums
