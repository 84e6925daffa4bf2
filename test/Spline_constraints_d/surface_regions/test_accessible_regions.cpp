// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions that a tool reaches, and that are seen: counts and areas in closed form, random points against rays.

#include "../../../examples/Spline_constraints_d/rounded_cuboid.h"
#include "../random_own_shadows.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/accessible_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/connected_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/visible_regions.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace accessible_regions_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;
using Surface = SC::Bspline_surface_3<K>;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Sphere = K::Sphere_3;
using Spheres = std::vector<Sphere>;
using Axis = SC::Tool_axis<K>;
using random_own_shadows::label_at;

namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int free_label = static_cast<int>(SC::Access::FREE), obstructed = static_cast<int>(SC::Access::OBSTRUCTED),
              not_admitted = static_cast<int>(SC::Access::NOT_ADMITTED);

double area(const SC::Trimmed_surface_3& surface, int label, double error = 1e-3)
{
  const auto mesh = SC::to_surface_mesh(surface, label, error);
  EXPECT_TRUE(mesh.is_complete());
  return mesh.area();
}

Surface square(double half_size)
{
  const double a = half_size;
  return Surface({1, 1}, {-a, -a, a, a}, {-a, -a, a, a}, {{-a, -a, 0}, {-a, a, 0}, {a, -a, 0}, {a, a, 0}});
}

Surface random_surface(std::mt19937& random)
{
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i - 1.5, j - 1.5, 0.25 * std::uniform_int_distribution(-3, 3)(random));
  return Surface({2, 2}, {0, 0, 0, 0.5, 1, 1, 1}, {0, 0, 0, 0.5, 1, 1, 1}, points);
}

// Upward directions, bilinear, with a break where the surfaces have none.
Surface random_field(std::mt19937& random)
{
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i)
    points.emplace_back(0.125 * std::uniform_int_distribution(-3, 3)(random),
                        0.125 * std::uniform_int_distribution(-3, 3)(random), 1);
  return Surface({1, 1}, {0, 0, 0.25, 1, 1}, {0, 0, 1, 1}, points);
}

using Exact_surface = SC::Bspline_surface_3<Exact>;

Exact_surface hill_on_a_plane()
{
  std::vector<Exact::Point_3> points;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j)
      points.emplace_back(i - 2, j - 2, i == 2 && j == 2 ? SC::Exact_rational(5) / 2 : SC::Exact_rational(0));
  return Exact_surface({2, 2}, {0, 0, 0, 1, 2, 3, 3, 3}, {0, 0, 0, 1, 2, 3, 3, 3}, points);
}

// Labels are those of rays.
template <class Direction>
void expect_labels_of_rays(const SC::Trimmed_surface_3& regions, const Exact_surface& surface,
                           const std::vector<Exact_surface>& obstacles, const Direction& direction, int least)
{
  const auto counts = random_own_shadows::compare_with_rays(regions, surface, obstacles, direction, std::nullopt, 150);
  EXPECT_EQ(counts.wrong, 0);
  EXPECT_EQ(counts.undecided, 0);
  EXPECT_GT(counts.free, least);
  EXPECT_GT(counts.obstructed, least);
}

bool is_obstructed(const Spheres& spheres, const Point& p, const Vector& direction)
{
  for (const Sphere& sphere : spheres) {
    const Vector to_center = sphere.center() - p;
    const double ahead = (std::max)(0., to_center * direction / direction.squared_length());
    if ((to_center - ahead * direction).squared_length() < sphere.squared_radius())
      return true;
  }
  return false;
}

} // namespace

// The 26 regions of the figure: 6 circles, 12 curves on quarters of cylinders, 8 circles on octants.
TEST(AccessibleRegions, RoundedCuboidHasTwentySixRegions)
{
  using Number = SC::Exact_rational;
  const auto cuboid = rounded_cuboid::surfaces(1, Number(2) / 5, true);
  ASSERT_EQ(cuboid.size(), 26u);
  const Number radius = Number(11) / 20;
  const std::vector spheres{Exact::Sphere_3(Exact::Point_3(0, 0, 0), Number(radius * radius))};
  const auto regions = [&](const SC::Tool_axis<Exact>& axis) {
    std::vector<SC::Trimmed_surface_3> surfaces;
    for (const auto& surface : cuboid)
      surfaces.push_back(SC::accessible_regions(surface, spheres, axis));
    const auto result = SC::connected_regions(surfaces);
    EXPECT_TRUE(result.is_complete());
    return std::array{result.number_of_regions(free_label), result.number_of_regions(obstructed),
                      result.number_of_regions(not_admitted)};
  };
  EXPECT_EQ(regions({}), (std::array<std::size_t, 3>{1, 26, 0}));
  EXPECT_EQ(regions({.hemisphere = Exact::Vector_3(1, 1, 0)}), (std::array<std::size_t, 3>{1, 9 + 6, 1}));
  EXPECT_EQ(regions({.hemisphere = Exact::Vector_3(1, 1, 1)}), (std::array<std::size_t, 3>{1, 10 + 6, 1}));
  // Normals that point outwards meet nothing.
  std::size_t faces = 0;
  for (const auto& surface : rounded_cuboid::surfaces(1, Number(2) / 5, false)) {
    const auto outward = SC::accessible_regions(surface, spheres);
    EXPECT_TRUE(outward.is_complete());
    EXPECT_EQ(outward.number_of_regions(free_label), 1u);
    EXPECT_EQ(outward.number_of_regions(obstructed), 0u);
    faces += outward.faces().size();
  }
  EXPECT_EQ(faces, 52u); // curves behind the surface bound faces, but no regions
}

TEST(AccessibleRegions, BallOverAPlaneHidesADisk)
{
  for (const double radius : {0.5, 1.}) {
    const auto regions = SC::accessible_regions(square(2), Spheres{Sphere(Point(0.25, -0.5, 3), radius * radius)});
    ASSERT_TRUE(regions.is_complete());
    EXPECT_EQ(regions.number_of_regions(free_label), 1u);
    EXPECT_EQ(regions.number_of_regions(obstructed), 1u);
    EXPECT_NEAR(area(regions, obstructed), pi * radius * radius, 0.01);
    EXPECT_NEAR(area(regions, free_label), 16 - pi * radius * radius, 0.01);
  }
  // Along an oblique direction an ellipse: the disk, stretched by the reciprocal of the cosine, here 5/3.
  const auto oblique =
      SC::accessible_regions(square(4), Spheres{Sphere(Point(0, 0, 1.5), 1)}, Axis{.direction = Vector(4, 0, 3)});
  ASSERT_TRUE(oblique.is_complete());
  EXPECT_NEAR(area(oblique, obstructed), pi * 5 / 3, 0.03);
}

TEST(AccessibleRegions, BallThatCutsThePlane)
{
  const auto regions = SC::accessible_regions(square(2), Spheres{Sphere(Point(0, 0, -0.75), 1)});
  ASSERT_TRUE(regions.is_complete());
  EXPECT_EQ(regions.faces().size(), 3u);
  EXPECT_EQ(regions.number_of_regions(free_label), 1u);
  EXPECT_NEAR(area(regions, obstructed), pi * (1 - 0.5625), 0.01);
}

TEST(AccessibleRegions, LabelsAreThoseOfRandomRays)
{
  std::mt19937 random(1);
  const auto number = [&](double lower, double upper) { return std::uniform_real_distribution(lower, upper)(random); };
  int free_count = 0, obstructed_count = 0, count = 0;
  for (int repetition = 0; repetition < 4; ++repetition) {
    const Surface surface = random_surface(random);
    Spheres spheres;
    for (int i = 0; i < 2; ++i)
      spheres.emplace_back(Point(number(-1, 1), number(-1, 1), number(1.5, 2.5)), number(0.1, 0.3));
    const Surface field = random_field(random);
    for (const Axis& axis : {Axis{}, Axis{.direction = Vector(0.25, 0.5, 1)}, Axis{.field = field}}) {
      const auto regions = SC::accessible_regions(surface, spheres, axis);
      EXPECT_TRUE(regions.is_complete());
      for (int i = 0; i < 200; ++i) {
        const double u = number(0, 1), v = number(0, 1);
        const auto label = label_at(regions, u, v);
        if (!label)
          continue;
        const Vector direction = axis.direction ? *axis.direction
            : axis.field                        ? field(u, v) - CGAL::ORIGIN
                                                : surface.normal(u, v);
        const bool is_hit = is_obstructed(spheres, surface(u, v), direction);
        EXPECT_EQ(label, is_hit ? obstructed : free_label) << u << ' ' << v;
        ++(is_hit ? obstructed_count : free_count);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 1000);
  EXPECT_GT(free_count, 100);
  EXPECT_GT(obstructed_count, 100);
}

// The shadow of a triangle grows by the radius of the tool, in all directions; also past a ball with an irrational
// radius.
TEST(AccessibleRegions, ThickTools)
{
  using Triangle = K::Triangle_3;
  const auto covered = [](const std::vector<Triangle>& triangles, const Axis& axis) {
    const auto regions = SC::accessible_regions(square(4), SC::Tool_obstacles_3<K>{.triangles = triangles}, axis);
    EXPECT_TRUE(regions.is_complete());
    EXPECT_EQ(regions.number_of_regions(free_label), 1u);
    return area(regions, obstructed);
  };
  const Triangle triangle(Point(0, 0, 1), Point(2, 0, 1.25), Point(0.5, 2, 1.5));
  const double sides = 2 + 2.5 + std::hypot(0.5, 2.); // of the shadow
  EXPECT_NEAR(covered({triangle}, {}), 2, 1e-9);
  for (const double radius : {0.25, 0.5}) {
    const double expected = 2 + radius * sides + pi * radius * radius, thicker = radius * (1 + 2. / 256);
    const double found = covered({triangle}, {.radius = radius});
    EXPECT_GT(found, expected - 0.01);
    EXPECT_LT(found, 2 + thicker * sides + pi * thicker * thicker + 0.01);
  }
  // two faces of a roof, along an oblique direction, without the vertices on the floor
  const std::vector<Triangle> roof{Triangle(Point(-1, 0, 1), Point(1, 0, 1), Point(0, 1, 0.5)),
                                   Triangle(Point(1, 0, 1), Point(-1, 0, 1), Point(0, -1, 0.5))};
  const double thin = covered(roof, {.direction = Vector(1, 0, 2)});
  EXPECT_NEAR(thin, 2, 1e-9);
  EXPECT_GT(covered(roof, {.direction = Vector(1, 0, 2), .radius = 0.25}), thin + 0.25 * 4);
  const auto ball = SC::accessible_regions(square(4), Spheres{Sphere(Point(0, 0, 3), 2)}, Axis{.radius = 0.5});
  ASSERT_TRUE(ball.is_complete());
  EXPECT_NEAR(area(ball, obstructed), pi * (std::sqrt(2.) + 0.5) * (std::sqrt(2.) + 0.5), 0.02);
}

// What is free has the distance of the radius from the triangles at least, what is not has it at most, but for 1/128.
TEST(AccessibleRegions, ThickToolsAtRandomPoints)
{
  std::mt19937 random(4);
  const auto number = [&](double lower, double upper) { return std::uniform_real_distribution(lower, upper)(random); };
  int free_count = 0, obstructed_count = 0;
  constexpr double radius = 0.25;
  for (int repetition = 0; repetition < 1; ++repetition) {
    const Surface surface = random_surface(random);
    std::vector<K::Triangle_3> triangles;
    for (int i = 0; i <= repetition; ++i)
      triangles.emplace_back(Point(number(-1, 1), number(-1, 1), number(1, 2)),
                             Point(number(-1, 1), number(-1, 1), number(1, 2)),
                             Point(number(-1, 1), number(-1, 1), number(1, 2)));
    const Axis axis{.direction = Vector(0.25, 0, 1), .radius = radius};
    const auto regions = SC::accessible_regions(surface, SC::Tool_obstacles_3<K>{.triangles = triangles}, axis);
    for (int i = 0; i < 400; ++i) {
      const double u = number(0, 1), v = number(0, 1);
      const auto label = label_at(regions, u, v);
      if (!label)
        continue;
      double least = 1e9; // by samples of the triangle and of the ray
      for (const auto& triangle : triangles)
        for (int j = 0; j <= 40; ++j)
          for (int k = 0; j + k <= 40; ++k) {
            const Vector p = surface(u, v) - triangle[0], w = triangle[1] - triangle[0], x = triangle[2] - triangle[0];
            const Vector offset = w * (j / 40.) + x * (k / 40.) - p;
            const double ahead = std::max(0., offset * *axis.direction / axis.direction->squared_length());
            least = std::min(least, (offset - ahead * *axis.direction).squared_length());
          }
      const bool is_free = label == free_label;
      if (is_free)
        EXPECT_GT(std::sqrt(least), radius - 1e-9);
      else
        EXPECT_LT(std::sqrt(least), radius * (1 + 1. / 128) + 0.02);
      ++(is_free ? free_count : obstructed_count);
    }
  }
  EXPECT_GT(free_count, 50);
  EXPECT_GT(obstructed_count, 50);
}

TEST(AccessibleRegions, BadInputAndLimits)
{
  EXPECT_THROW(SC::accessible_regions(square(1), Spheres(), Axis{.radius = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::accessible_regions(square(1),
                                      SC::Tool_obstacles_3<K>{.triangles = {K::Triangle_3(
                                                                  Point(0, 0, 1), Point(1, 1, 1), Point(2, 2, 1))}}),
               SC::Invalid_input);
  const Spheres ball{Sphere(Point(0, 0, 3), 1)};
  EXPECT_THROW(SC::accessible_regions(square(1), Spheres{Sphere(Point(0, 0, 3), 0)}), SC::Invalid_input);
  EXPECT_THROW(SC::accessible_regions(square(1), ball, Axis{.direction = Vector(0, 0, 0)}), SC::Invalid_input);
  EXPECT_THROW(SC::accessible_regions(square(1), ball, Axis{.field = square(2)}), SC::Invalid_input);
  EXPECT_THROW(SC::accessible_regions(square(1), ball, {}, {.time_limit = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::visible_regions(square(1), Vector(0, 0, 0)), SC::Invalid_input);
  const Surface line({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
  const auto without_normals = SC::accessible_regions(line, ball);
  EXPECT_FALSE(without_normals.is_complete());
  EXPECT_TRUE(without_normals.faces().empty());
  const auto ended = SC::accessible_regions(square(2), ball, {}, {.tolerance = 1e-8, .time_limit = 1e-9});
  EXPECT_FALSE(ended.is_complete());
  EXPECT_TRUE(ended.faces().empty());
  ASSERT_EQ(ended.undecided().size(), 1u);
  EXPECT_EQ(ended.undecided()[0].parameters[0].ranges[0].second, 2);
}

// From the distance D of the center, a cap of the area 2 pi r^2 (1 - r/D) is seen; from far away, a half.
TEST(VisibleRegions, CapOfASphere)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  const auto from_point = SC::visible_regions(sphere, Point(1, 2, 2));
  ASSERT_TRUE(from_point.is_complete());
  EXPECT_EQ(from_point.number_of_regions(free_label), 1u);
  EXPECT_EQ(from_point.number_of_regions(obstructed), 1u);
  EXPECT_NEAR(area(from_point, free_label), 2 * pi * (1 - 1. / 3), 0.02);
  EXPECT_NEAR(area(from_point, obstructed), 2 * pi * (1 + 1. / 3), 0.02);
  const auto from_direction = SC::visible_regions(sphere, Vector(1, 2, 2));
  ASSERT_TRUE(from_direction.is_complete());
  EXPECT_NEAR(area(from_direction, free_label), 2 * pi, 0.02);
  const auto from_inside = SC::visible_regions(sphere, Point(0.25, 0.5, 0));
  ASSERT_TRUE(from_inside.is_complete());
  EXPECT_EQ(from_inside.number_of_regions(free_label), 1u);
  EXPECT_EQ(from_inside.number_of_regions(obstructed), 0u);
}

// Of a sphere behind a ball of the same size in line, seen from a point between two tangents, a ring is seen.
TEST(VisibleRegions, BallsInLine)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  // From the eye at distance 5 the ball at 3 of radius 1/4 hides a cone with sine 1/8.
  const auto regions = SC::visible_regions(sphere, Point(5, 0, 0), Spheres{Sphere(Point(3, 0, 0), 0.0625)});
  ASSERT_TRUE(regions.is_complete());
  EXPECT_EQ(regions.number_of_regions(free_label), 1u);
  EXPECT_EQ(regions.number_of_regions(obstructed), 2u);
  // Where the cone meets the sphere: |5 - t c| ... with the cosine c: t = 5 c - sqrt(1 - 25 s^2).
  const double s = 0.125, c = std::sqrt(1 - s * s), t = 5 * c - std::sqrt(1 - 25 * s * s), x = 5 - t * c;
  const double seen = 2 * pi * (x - 1. / 5);
  EXPECT_NEAR(area(regions, free_label), seen, 0.02);
  // A ball behind the eye hides nothing.
  const auto all = SC::visible_regions(sphere, Point(5, 0, 0), Spheres{Sphere(Point(8, 0, 0), 1)});
  EXPECT_NEAR(area(all, free_label), 2 * pi * (1 - 1. / 5), 0.02);
}

// A tube without caps, seen from one side: the wall behind is seen past the rim.
TEST(VisibleRegions, TubeHidesPartsOfItself)
{
  const Surface tube = SC::cylinder_surface<K>(Point(0, 0, 0), 1., 2.);
  const Vector direction(2, 1, 3);
  const auto regions = SC::visible_regions(tube, direction);
  std::mt19937 random(2);
  int free_count = 0, obstructed_count = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto parameter = [&](int axis) {
      const auto [begin, end] = tube.domain(axis);
      return std::uniform_real_distribution(begin, end)(random);
    };
    const double u = parameter(0), v = parameter(1);
    const auto label = label_at(regions, u, v);
    if (!label)
      continue;
    const Point p = tube(u, v);
    // |p + t d| = 1 in the plane at t > 0, and between the rims there
    const double place = -2 * (p.x() * direction.x() + p.y() * direction.y()) /
        (direction.x() * direction.x() + direction.y() * direction.y());
    double least = 1e9, greatest = -1e9;
    for (const int a : {0, 1})
      for (const int b : {0, 1}) {
        const auto end = [&](int axis, int side) {
          return side == 0 ? tube.domain(axis).first : tube.domain(axis).second;
        };
        least = (std::min)(least, tube(end(0, a), end(1, b)).z());
        greatest = (std::max)(greatest, tube(end(0, a), end(1, b)).z());
      }
    const double z = p.z() + place * direction.z();
    const bool is_hit = place > 0 && least <= z && z <= greatest;
    EXPECT_EQ(label, is_hit ? obstructed : free_label) << u << ' ' << v;
    ++(is_hit ? obstructed_count : free_count);
  }
  EXPECT_GT(free_count, 200);
  EXPECT_GT(obstructed_count, 200);
}

// A hill on a plane, with a closed rim: what is behind it is in its shadow, which begins at two points of the rim.
TEST(VisibleRegions, HillHidesAPartOfItself)
{
  const Exact_surface hill = hill_on_a_plane();
  const Exact::Vector_3 direction(8, 1, 4);
  const auto regions = SC::visible_regions(hill, direction);
  EXPECT_TRUE(regions.is_complete());
  EXPECT_EQ(regions.number_of_regions(free_label), 1u);
  expect_labels_of_rays(
      regions, hill, {hill}, [&](const auto&) { return direction; }, 15);
}

// Silhouettes end at edges, where an edge casts its shadow from the same point; and they have cusps.
TEST(VisibleRegions, RandomSurfacesHidePartsOfThemselves)
{
  for (const unsigned number : {9u}) {
    const random_own_shadows::Scene scene = random_own_shadows::scene(number);
    const auto regions = scene.visible_regions();
    EXPECT_TRUE(regions.is_complete());
    const auto counts = random_own_shadows::compare_with_rays(regions, scene, 200);
    EXPECT_EQ(counts.wrong, 0);
    EXPECT_EQ(counts.undecided, 0);
    EXPECT_GT(counts.free, 100);
    EXPECT_GT(counts.obstructed, 1);
    EXPECT_TRUE(std::ranges::any_of(regions.cells(), [&](const auto& cell) {
      const auto index = static_cast<std::size_t>(&cell - regions.cells().data());
      return std::ranges::count(regions.faces(), index, &SC::Surface_face_3::cell) == 3;
    }));
  }
}

// What is found by then is kept; the rest is undecided.
TEST(VisibleRegions, LimitsPastCurvedSurfaces)
{
  const auto limited = SC::visible_regions(hill_on_a_plane(), Exact::Vector_3(8, 1, 4), {}, {.time_limit = 0.1});
  EXPECT_FALSE(limited.is_complete());
  EXPECT_FALSE(limited.undecided().empty());
  EXPECT_FALSE(limited.faces().empty());
  EXPECT_LT(limited.summary().seconds, 5);
  const auto few = SC::visible_regions(hill_on_a_plane(), Exact::Vector_3(8, 1, 4), {}, {.node_limit = 50});
  EXPECT_FALSE(few.is_complete());
  EXPECT_LE(few.summary().nodes, 500u);
  const Surface ground = square(1),
                roof({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 2}});
  const K::Triangle_3 triangle(Point(0, 0, 1), Point(1, 0, 1), Point(0, 1, 1));
  EXPECT_FALSE(SC::accessible_regions(ground, SC::Tool_obstacles_3<K>{.triangles = {triangle}, .surfaces = {roof}})
                   .is_complete());
}

// Of a height field nothing is hidden from above.
TEST(VisibleRegions, HeightFieldIsSeenFromAbove)
{
  std::mt19937 random(3);
  const auto regions = SC::visible_regions(random_surface(random), Vector(0, 0, 1));
  EXPECT_TRUE(regions.is_complete());
  EXPECT_EQ(regions.number_of_regions(free_label), 1u);
  EXPECT_EQ(regions.number_of_regions(obstructed), 0u);
}

TEST(VisibleRegions, BallsBesideACurvedSurface)
{
  std::mt19937 random(4);
  const Surface surface = random_surface(random);
  const auto past_ball = SC::visible_regions(surface, Vector(0, 0, 1), {Sphere(Point(8, 0, 4), 0.25)});
  EXPECT_TRUE(past_ball.is_complete());
  EXPECT_EQ(past_ball.number_of_regions(free_label), 1u);
  EXPECT_FALSE(SC::visible_regions(surface, Vector(0, 0, 1), {Sphere(Point(0, 0, 4), 0.5)}).is_complete());
  EXPECT_FALSE(SC::visible_regions(surface, Point(0, 0, 4), {Sphere(Point(0, 0, 4), 0.25)}).is_complete());
}

// The shadows of a patch over a floor, a square, and of a ball that is given as a surface; and of both in a field of
// directions.
TEST(AccessibleRegions, PastCurvedSurfaces)
{
  using Number = SC::Exact_rational;
  const Number a(2);
  const Exact_surface floor({1, 1}, {-a, -a, a, a}, {-a, -a, a, a}, {{-a, -a, 0}, {-a, a, 0}, {a, -a, 0}, {a, a, 0}});
  std::vector<Exact::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i - Number(3) / 2, j - Number(3) / 2, i % 3 != 0 && j % 3 != 0 ? 5 : 2);
  const Exact_surface patch({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
  const Number part = Number(1) / 15;
  const Exact_surface ball =
      SC::sphere_surface<Exact>({Number(1) / 4, 0, 3}, {Number(1) / 4 + 2 * part, 10 * part, 3 + 11 * part});
  const auto below_patch = SC::accessible_regions(floor, SC::Tool_obstacles_3<Exact>{.surfaces = {patch}});
  EXPECT_TRUE(below_patch.is_complete());
  EXPECT_EQ(below_patch.number_of_regions(free_label), 1u);
  EXPECT_EQ(below_patch.number_of_regions(obstructed), 1u);
  EXPECT_NEAR(area(below_patch, obstructed), 9, 0.01);
  const auto below_ball = SC::accessible_regions(floor, SC::Tool_obstacles_3<Exact>{.surfaces = {ball}});
  EXPECT_TRUE(below_ball.is_complete());
  EXPECT_NEAR(area(below_ball, obstructed), pi, 0.01);
  EXPECT_NEAR(area(below_ball, free_label), 16 - pi, 0.01);
  std::vector<Exact::Point_3> directions;
  for (int i = 0; i < 4; ++i)
    directions.emplace_back(Number(i / 2 - 1) / 8, Number(i % 2) / 8, 1);
  const Exact_surface field({1, 1}, {-a, -a, a, a}, {-a, -a, a, a}, directions);
  const auto in_field =
      SC::accessible_regions(floor, SC::Tool_obstacles_3<Exact>{.surfaces = {patch, ball}}, {.field = field});
  EXPECT_TRUE(in_field.is_complete());
  expect_labels_of_rays(
      in_field, floor, {patch, ball}, [&](const auto& p) { return field(p[0], p[1]) - Exact::Point_3(0, 0, 0); }, 15);
  EXPECT_FALSE(
      SC::accessible_regions(floor, SC::Tool_obstacles_3<Exact>{.surfaces = {patch}}, {.radius = 1}).is_complete());
}

} // namespace accessible_regions_test
