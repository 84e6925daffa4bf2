// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of rational bisectors between their poles and within spheres, and meshes of them with feet and distances.

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/bisector_parts_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace bisector_parts_3_test {

namespace SC = CGAL::Spline_constraints;
using K = SC::Rational_bisector_3::Kernel;
using Number = SC::Exact_rational;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Parts = std::vector<SC::Trimmed_surface_3>;

namespace {

// The number of parts on both sides of the poles.
std::pair<std::size_t, std::size_t> numbers(const Parts& parts)
{
  EXPECT_EQ(parts.size(), 1u);
  EXPECT_TRUE(parts.at(0).is_complete());
  return {parts.at(0).number_of_regions(SC::WITH_POSITIVE_WEIGHT),
          parts.at(0).number_of_regions(SC::WITH_NEGATIVE_WEIGHT)};
}

std::size_t number(const Parts& parts)
{
  const auto [positive, negative] = numbers(parts);
  return positive + negative;
}

} // namespace

TEST(Bisector_parts_3, poles_cut)
{
  const auto plane = SC::plane_patch<K>(Point(-2, -2, 0), Vector(4, 0, 0), Vector(0, 4, 0));
  EXPECT_EQ(number(SC::bisector_parts(SC::point_surface_bisector(Point(0, 0, 1), plane))), 1u);
  const auto sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  EXPECT_EQ(number(SC::bisector_parts(SC::point_surface_bisector(Point(Number(1) / 2, 0, 0), sphere))), 1u);
  // Both sheets of a hyperboloid, which the circle of poles separates; across the seam, too.
  const auto hyperboloid = SC::point_surface_bisector(Point(2, 1, Number(1) / 3), sphere);
  EXPECT_EQ(numbers(SC::bisector_parts(hyperboloid)), (std::pair<std::size_t, std::size_t>(1, 1)));
  const auto torus = SC::torus_surface(Point(0, 0, 0), Number(3), Number(1));
  EXPECT_EQ(number(SC::bisector_parts(SC::point_surface_bisector(Point(0, 0, 0), torus))), 2u);
  // Two skew lines have none, nor has the wall of a tube, seen from inside.
  const auto saddle = SC::curve_bisector_surface(SC::bezier_curve(std::vector<Point>{{-3, 0, -1}, {3, 0, -1}}),
                                                 SC::bezier_curve(std::vector<Point>{{0, -3, 1}, {0, 3, 1}}));
  EXPECT_EQ(number(SC::bisector_parts(saddle)), 1u);
  EXPECT_EQ(number(SC::bisector_parts(SC::point_surface_bisector(
                Point(Number(1) / 2, 0, 1), SC::cylinder_surface<K>(Point(0, 0, 0), Number(2), Number(5))))),
            1u);
}

TEST(Bisector_parts_3, spheres_cut)
{
  const auto sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  const auto hyperboloid = SC::point_surface_bisector(Point(2, 0, 0), sphere);
  // 4(x-1)^2 - (4/3)(y^2+z^2) = 1 has its vertices at x = 1/2 and 3/2.
  const auto within = [&](const Number& squared_radius) {
    return SC::bisector_parts(hyperboloid, K::Sphere_3(Point(2, 0, 0), squared_radius));
  };
  EXPECT_EQ(number(within(Number(1) / 5)), 0u);
  EXPECT_EQ(number(within(1)), 1u);
  EXPECT_EQ(number(within(4)), 2u);
  EXPECT_GE(within(1)[0].number_of_regions(SC::OUT_OF_REACH), 1u);
  EXPECT_THROW(within(0), SC::Invalid_input);
}

TEST(Bisector_parts_3, meshes)
{
  // z = (x^2 + y^2 + 1) / 2 where it is at most 1, a disk of radius 1 over the plane.
  const auto paraboloid = SC::point_surface_bisector(
      Point(0, 0, 1), SC::plane_patch<K>(Point(-2, -2, 0), Vector(4, 0, 0), Vector(0, 4, 0)));
  const Parts parts = SC::bisector_parts(paraboloid, K::Sphere_3(Point(0, 0, 1), 1));
  ASSERT_EQ(number(parts), 1u);
  const int label = numbers(parts).first == 1 ? SC::WITH_POSITIVE_WEIGHT : SC::WITH_NEGATIVE_WEIGHT;
  const auto mesh = SC::to_surface_mesh(paraboloid, parts[0], label, 1e-3);
  ASSERT_TRUE(mesh.triangles.is_complete());
  EXPECT_LE(mesh.triangles.error, 1e-3);
  EXPECT_GT(mesh.triangles.mesh.number_of_faces(), 50u);
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(mesh.triangles.area(), 2 * pi / 3 * (std::pow(2, 1.5) - 1), 0.02);
  for (const auto vertex : mesh.triangles.mesh.vertices()) {
    const auto& p = mesh.triangles.mesh.point(vertex);
    EXPECT_NEAR(p.z(), (p.x() * p.x() + p.y() * p.y() + 1) / 2, 1e-14);
    EXPECT_NEAR(mesh.distance[vertex], p.z(), 1e-12);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(p, mesh.feet[0][vertex])), p.z(), 1e-12);
    EXPECT_EQ(mesh.feet[1][vertex].z(), 0);
  }
  EXPECT_THROW(SC::to_surface_mesh(paraboloid, parts[0], label, 0), SC::Invalid_input);
}

TEST(Bisector_parts_3, limits_and_bad_input)
{
  const auto sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  const auto bisector = SC::point_surface_bisector(Point(2, 0, 0), sphere);
  const Parts stopped = SC::bisector_parts(bisector, {.node_limit = 1});
  ASSERT_EQ(stopped.size(), 1u);
  EXPECT_FALSE(stopped[0].is_complete());
  EXPECT_FALSE(stopped[0].undecided().empty());
  const auto partial = SC::point_surface_bisector(Point(2, 0, 0), sphere, {.node_limit = 1});
  EXPECT_THROW(SC::bisector_parts(partial), SC::Invalid_input);
}

} // namespace bisector_parts_3_test
