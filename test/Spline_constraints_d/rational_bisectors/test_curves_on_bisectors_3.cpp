// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Level curves of the distance on bisectors, and their sections with spheres: counts and closed forms.

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/curves_on_bisectors_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace curves_on_bisectors_3_test {

namespace SC = CGAL::Spline_constraints;
using K = SC::Rational_bisector_3::Kernel;
using Number = SC::Exact_rational;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Curves = SC::Surface_curves_3<K>;

namespace {

// All points of a continuous bisector's curves satisfy check(x, y, z).
template <class Check>
void check_curves(const std::vector<Curves>& parts, std::size_t closed, std::size_t open, const Check& check)
{
  ASSERT_EQ(parts.size(), 1u);
  const Curves& curves = parts[0];
  EXPECT_TRUE(curves.is_complete());
  EXPECT_EQ(curves.number_of_closed_curves(), closed);
  EXPECT_EQ(curves.number_of_open_curves(), open);
  EXPECT_TRUE(curves.singular_points().empty() && curves.points().empty());
  for (const auto& curve : curves.curves())
    for (const auto& sample : curves.polyline(curve, 1e-2))
      check(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()), CGAL::to_double(sample.point.z()));
}

} // namespace

TEST(Curves_on_bisectors_3, levels_on_a_paraboloid)
{
  // z = (x^2 + y^2 + 1) / 2 above the square [-2,2]^2: its points are at the distance z from the plane.
  const auto paraboloid = SC::point_surface_bisector(
      Point(0, 0, 1), SC::plane_patch<K>(Point(-2, -2, 0), Vector(4, 0, 0), Vector(0, 4, 0)));
  const auto at_height = [](double height) {
    return [height](double x, double y, double z) {
      EXPECT_NEAR(z, height, 1e-12);
      EXPECT_NEAR(x * x + y * y, 2 * height - 1, 1e-11);
    };
  };
  check_curves(SC::distance_curves(paraboloid, 1), 1, 0, at_height(1));
  check_curves(SC::distance_curves(paraboloid, Number(5) / 2 + Number(1) / 8), 0, 4, at_height(2.625));
  check_curves(SC::distance_curves(paraboloid, Number(1) / 3), 0, 0, at_height(0));
  EXPECT_THROW(SC::distance_curves(paraboloid, 0), SC::Invalid_input);
}

TEST(Curves_on_bisectors_3, levels_across_seams_and_poles)
{
  // The plane x = 0 between two unit spheres, over one of them: distances from 1 on; infinite where x = -2 on it.
  const auto sphere = SC::sphere_surface(Point(-2, 0, 0), Number(1));
  const auto plane = SC::sphere_surface_bisector(Point(2, 0, 0), Number(1), sphere);
  EXPECT_FALSE(plane.is_free_of_poles());
  check_curves(SC::distance_curves(plane, 2), 1, 0, [](double x, double y, double z) {
    EXPECT_NEAR(x, 0, 1e-11);
    EXPECT_NEAR(std::hypot(y, z), std::sqrt(5), 1e-10);
  });
  check_curves(SC::distance_curves(plane, Number(9) / 10), 0, 0, [](double, double, double) {});
}

TEST(Curves_on_bisectors_3, path_between_two_radars)
{
  // 4x^2 - (4/15)(y^2 + z^2) = 1 around the smaller sphere, and a sphere around the origin: a circle x = constant on
  // either sheet.
  const auto bisector =
      SC::sphere_surface_bisector(Point(2, 0, 0), Number(2), SC::sphere_surface(Point(-2, 0, 0), Number(1)));
  const K::Sphere_3 reach(Point(0, 0, 0), 9);
  const double x_of_path = std::sqrt(51.0 / 64);
  check_curves(SC::sphere_sections(bisector, reach), 2, 0, [&](double x, double y, double z) {
    EXPECT_NEAR(std::abs(x), x_of_path, 1e-11);
    EXPECT_NEAR(x * x + y * y + z * z, 9, 1e-10);
  });
  EXPECT_THROW(SC::sphere_sections(bisector, K::Sphere_3(Point(0, 0, 0), 0)), SC::Invalid_input);
  const auto partial = SC::sphere_surface_bisector(Point(2, 0, 0), Number(2),
                                                   SC::sphere_surface(Point(-2, 0, 0), Number(1)), {.node_limit = 1});
  EXPECT_THROW(SC::sphere_sections(partial, reach), SC::Invalid_input);
}

TEST(Curves_on_bisectors_3, skew_lines)
{
  // z = (x^2 - y^2) / 4 and the distance from the line y = 0, z = -1.
  const auto saddle = SC::curve_bisector_surface(SC::bezier_curve(std::vector<Point>{{-3, 0, -1}, {3, 0, -1}}),
                                                 SC::bezier_curve(std::vector<Point>{{0, -3, 1}, {0, 3, 1}}));
  check_curves(SC::distance_curves(saddle, 2), 1, 0, [](double x, double y, double z) {
    EXPECT_NEAR(z, (x * x - y * y) / 4, 1e-11);
    EXPECT_NEAR(y * y + (z + 1) * (z + 1), 4, 1e-10);
  });
}

} // namespace curves_on_bisectors_3_test
