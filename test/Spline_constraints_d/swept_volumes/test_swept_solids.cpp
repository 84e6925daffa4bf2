// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swept volumes of solids that several surfaces bound, with edges and corners, against closed forms and exact
// membership.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/swept_volumes.h>

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace swept_solid_test {

using Curve = SC::Bspline_curve_3<K>;
using Motion = SC::Rational_motion_3;
using Function = Motion::Function;

namespace {

constexpr double pi = std::numbers::pi;

// With normals that point outwards.
std::vector<Surface> box(const Rational& low, const Rational& high)
{
  std::vector<Surface> result;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1}) {
      const int u = (axis + (end == 1 ? 1 : 2)) % 3, v = 3 - axis - u;
      std::vector<Point> points;
      for (const int i : {0, 1})
        for (const int j : {0, 1}) {
          std::array<Rational, 3> x;
          x[static_cast<std::size_t>(axis)] = end == 1 ? high : low;
          x[static_cast<std::size_t>(u)] = i == 1 ? high : low;
          x[static_cast<std::size_t>(v)] = j == 1 ? high : low;
          points.emplace_back(x[0], x[1], x[2]);
        }
      result.push_back(Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, points));
    }
  return result;
}

// Around the vertical axis: a disk, the side, and another disk.
std::vector<Surface> cylinder(const Rational& radius, const Rational& height)
{
  std::vector<Surface> result;
  const std::vector<Point> profile{Point(0, 0, 0), Point(radius, 0, 0), Point(radius, 0, height), Point(0, 0, height)};
  for (std::size_t i = 1; i < profile.size(); ++i)
    result.push_back(SC::surface_of_revolution(Curve(1, {0, 0, 1, 1}, {profile[i - 1], profile[i]}), Point(0, 0, 0),
                                               Vector(0, 0, 1)));
  return result;
}

Motion along(const Vector& v) { return Motion::along(Curve(1, {0, 0, 1, 1}, {Point(0, 0, 0), Point(0, 0, 0) + v})); }

// By a third of a turn about the diagonal of the cube.
Motion third_of_a_turn()
{
  return Motion::rotation(Point(0, 0, 0), Vector(1, 1, 1), Function({0}, {{0, 1}}, {1}),
                          Function({1}, {{0, 0, 1, 1}}, {0, 1}));
}

SC::Swept_volume_3 checked(const std::vector<Surface>& solid, const Motion& motion, double chord_error,
                           std::size_t components = 1, int euler_characteristic = 2)
{
  SC::Swept_volume_3 result = SC::swept_volume(solid, motion, {.chord_error = chord_error});
  EXPECT_TRUE(result.is_complete()) << result;
  EXPECT_TRUE(CGAL::is_closed(result.mesh()));
  EXPECT_TRUE(result.mesh().is_valid());
  EXPECT_EQ(result.number_of_components(), components);
  EXPECT_EQ(result.euler_characteristic(), euler_characteristic);
  return result;
}

// The errors of inscribed triangles are of second order, as the chord error is.
void check_convergence(const std::vector<Surface>& solid, const Motion& motion, double chord_error, double volume)
{
  const double first = volume - checked(solid, motion, chord_error).volume(),
               last = volume - checked(solid, motion, chord_error / 4).volume();
  EXPECT_LT(std::abs(first), 10 * chord_error);
  EXPECT_LT(std::abs(last), 0.45 * std::abs(first) + 1e-12); // errors may cancel
}

std::string message_of(const std::vector<Surface>& solid)
{
  try {
    SC::swept_volume(solid, along(Vector(1, 0, 0)));
  } catch (const SC::Invalid_input& error) {
    return error.what();
  }
  return "";
}

} // namespace

// A prism over the shadow of the cube, exactly.
TEST(Swept_solid, cube_along_line)
{
  for (const Vector& v :
       {Vector(Rational(1) / 2, Rational(1) / 3, 1), Vector(0, 2, 3), Vector(0, 0, 3), Vector(-1, 2, -1)}) {
    const SC::Swept_volume_3 swept = checked(box(0, 1), along(v), 0.1);
    const double x = std::abs(CGAL::to_double(v.x())), y = std::abs(CGAL::to_double(v.y())),
                 z = std::abs(CGAL::to_double(v.z()));
    EXPECT_NEAR(swept.volume(), 1 + x + y + z, 1e-12);
    EXPECT_NEAR(swept.area(), 6 + 2 * (std::hypot(y, z) + std::hypot(x, z) + std::hypot(x, y)), 1e-12);
  }
}

// Its hole becomes smaller.
TEST(Swept_solid, cube_with_cavity)
{
  std::vector<Surface> solid = box(0, 4);
  for (const Surface& surface : box(1, 3))
    solid.push_back(surface.transposed());
  const SC::Swept_volume_3 swept = checked(solid, along(Vector(1, Rational(1) / 2, Rational(1) / 4)), 0.1, 2, 4);
  EXPECT_NEAR(swept.volume(), 64 + 16 * 1.75 - 1 * 1.5 * 1.75, 1e-11);
}

// A hyperboloid between two cones. The cube is the same after a third of a turn, so that this sweeps all.
TEST(Swept_solid, cube_about_its_diagonal)
{
  check_convergence(box(0, 1), third_of_a_turn(), 0.02, pi / std::sqrt(3.0));
}

TEST(Swept_solid, cube_along_quarter_circle)
{
  const double radius = 3;
  const Function x({2}, {{0, 0, 0, 1, 1, 1}}, {3, 3, 0}), y({2}, {{0, 0, 0, 1, 1, 1}}, {0, 3, 6}),
      w({2}, {{0, 0, 0, 1, 1, 1}}, {1, 1, 2}), zero = w * Rational(0);
  const Motion motion({{{w, zero, zero}, {zero, w, zero}, {zero, zero, w}}}, {x, y, zero}, w);
  check_convergence(box(0, 1), motion, 0.04, 1 + 2 * radius);
}

TEST(Swept_solid, cylinder_along_line)
{
  const double radius = 0.5, height = 2, length = std::sqrt(1.25), rise = 0.5, aside = 1;
  const double volume = pi * radius * radius * (height + rise) + 2 * radius * height * aside;
  const std::vector<Surface> solid = cylinder(Rational(1) / 2, 2);
  const Motion motion = along(Vector(1, 0, Rational(1) / 2));
  check_convergence(solid, motion, 0.02, volume);

  // vertices lie on the cylinders and planes but for those where triangles cross
  const SC::Swept_volume_3 swept = checked(solid, motion, 0.01);
  std::size_t near = 0;
  for (const auto vertex : swept.mesh().vertices()) {
    const auto p = swept.mesh().point(vertex);
    const double t = std::clamp((p.x() + 0.5 * p.z()) / (length * length), 0.0, 1.0);
    double least = 1;
    for (const double step : {0.0, 1.0, t})
      least = std::min({least, std::abs(std::hypot(p.x() - step, p.y()) - radius), std::abs(std::abs(p.y()) - radius),
                        std::abs(p.z() - rise * step), std::abs(p.z() - height - rise * step),
                        std::abs(std::hypot(p.x() - p.z() / rise, p.y()) - radius),
                        std::abs(std::hypot(p.x() - (p.z() - height) / rise, p.y()) - radius)});
    EXPECT_LT(least, 0.01);
    near += least < 1e-12;
  }
  EXPECT_GT(near, swept.mesh().number_of_vertices() * 9 / 10);
}

// Where edges are smooth, they sweep nothing: two halves of a ball are as good as all of it.
TEST(Swept_solid, smooth_edges)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1) / 2);
  const auto [begin, end] = ball.domain(1);
  const Rational middle = (begin + end) / 2;
  const std::vector<Surface> halves{ball.restricted(1, begin, middle), ball.restricted(1, middle, end)};
  const double r = 0.5, length = std::sqrt(5.0);
  check_convergence(halves, along(Vector(2, 1, 0)), 0.02, pi * r * r * length + 4 * pi * r * r * r / 3);
  check_convergence(halves, along(Vector(0, 0, 2)), 0.02, pi * r * r * 2 + 4 * pi * r * r * r / 3);
}

// Against the times at which a point lies between the planes of the moving cube; also where its path goes through edges
// and corners of the cube.
TEST(Swept_solid, intervals)
{
  const std::array<Rational, 3> v{2, 2, Rational(1) / 2};
  const Motion motion = along(Vector(v[0], v[1], v[2]));
  std::mt19937 random(1);
  std::uniform_int_distribution<int> x(-8, 56);
  int inside = 0, decided = 0;
  constexpr int count = 100;
  for (int i = 0; i < count; ++i) {
    const std::array<Rational, 3> p{Rational(x(random)) / 16, Rational(x(random)) / 16,
                                    Rational(2 * x(random) + 1) / 64};
    const auto intervals = SC::sweep_intervals(box(0, 1), motion, Point(p[0], p[1], p[2]));
    Rational begin = 0, end = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      begin = std::max(begin, Rational((p[k] - 1) / v[k]));
      end = std::min(end, Rational(p[k] / v[k]));
    }
    if (!intervals)
      continue;
    ++decided;
    ASSERT_EQ(!intervals->empty(), begin <= end) << i;
    if (intervals->empty())
      continue;
    ++inside;
    ASSERT_EQ(intervals->size(), 1u);
    EXPECT_NEAR(CGAL::to_double(intervals->front().first), CGAL::to_double(begin), 1e-7);
    EXPECT_NEAR(CGAL::to_double(intervals->front().second), CGAL::to_double(end), 1e-7);
  }
  EXPECT_GT(inside, count / 10);
  EXPECT_GT(decided, count * 3 / 4) << decided;
}

TEST(Swept_solid, bad_input)
{
  std::vector<Surface> open = box(0, 1);
  open.pop_back();
  EXPECT_NE(message_of(open).find("the solid is not closed: the edge of surface"), std::string::npos)
      << message_of(open);

  std::vector<Surface> turned = box(0, 1);
  turned[2] = turned[2].transposed();
  EXPECT_NE(message_of(turned).find("normals point to different sides of the solid"), std::string::npos)
      << message_of(turned);
  EXPECT_NE(message_of(turned).find("the edge of surface 2 at"), std::string::npos) << message_of(turned);

  // two cubes with a common edge
  std::vector<Surface> two = box(0, 1);
  for (const Surface& surface : box(0, 1))
    two.push_back(surface.transformed(K::Aff_transformation_3(CGAL::TRANSLATION, Vector(1, 1, 0))));
  EXPECT_NE(message_of(two).find("more than two surfaces meet in one edge"), std::string::npos) << message_of(two);

  EXPECT_NE(message_of({}).find("no surface"), std::string::npos);
}

} // namespace swept_solid_test
