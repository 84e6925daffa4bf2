// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rounded primitives are made exact: what they are, by which numbers, how far they are moved, and what pairs of them
// have in common then.

#include "pairs_of_primitives.h"
#include "surfaces_of_cad_programs.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/healing/exact_primitives.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace test_exact_primitives {

using namespace surfaces_of_cad_programs;
using SC::Primitive_kind;
using Rounded_curve_2 = SC::Bspline_curve_2<Rounded>;
using Rounded_curve_3 = SC::Bspline_curve_3<Rounded>;

constexpr double tolerance = 1e-9;

Rational q(int numerator, int denominator) { return Rational(numerator) / denominator; }

Motion random_motion(std::mt19937& generator)
{
  std::uniform_real_distribution<double> number(-1, 1);
  return Motion::turned({number(generator), number(generator), number(generator)}, 3 * number(generator),
                        {5 * number(generator), 5 * number(generator), 5 * number(generator)});
}

Point middle(const Point& p, const Point& r) { return CGAL::midpoint(p, r); }
Rational squared_distance(const Point& p, const Point& r) { return (p - r).squared_length(); }

// Parameters that are no breaks.
const std::vector<Rational> shares{0, q(2, 7), q(1, 2), q(5, 6), 1};

template <class Spline>
Rational parameter(const Spline& spline, int axis, const Rational& share)
{
  const auto [begin, end] = spline.domain(axis);
  return begin + (end - begin) * share;
}

template <class Test>
void for_samples(const Surface& surface, const Test& test)
{
  for (const Rational& u : shares)
    for (const Rational& v : shares)
      test(surface(parameter(surface, 0, u), parameter(surface, 1, v)));
}

// Two circles around the axis of what was turned once around along axis 0: their centers and squared radii.
struct Circle
{
  Point center;
  Rational squared_radius;
};

Circle circle_at(const Surface& surface, const Rational& share)
{
  const Rational v = parameter(surface, 1, share);
  const Point p = surface(parameter(surface, 0, 0), v), r = surface(parameter(surface, 0, q(1, 2)), v);
  return {middle(p, r), squared_distance(p, r) / 4};
}

SC::Exact_primitive<Surface> healed(const Rounded_surface& surface, double within = tolerance)
{
  return SC::with_exact_primitives(std::vector{surface}, within).primitives.front();
}

TEST(ExactPrimitives, SpheresHaveTheirRadius)
{
  std::mt19937 generator(1);
  for (int i = 0; i < 20; ++i) {
    const Rational radius = q(1 + i, 3 + i % 5);
    const Rounded_surface given = written(SC::sphere_surface<K>(Point(1, 2, 3), radius), random_motion(generator));
    const auto [sphere, kind, displacement] = healed(given);
    ASSERT_EQ(kind, Primitive_kind::SPHERE);
    EXPECT_LE(displacement, tolerance);
    EXPECT_GT(displacement, 0);
    const Point center = middle(sphere(0, 0), sphere(0, 2));
    for_samples(sphere, [&](const Point& p) { EXPECT_EQ(squared_distance(p, center), radius * radius); });
    EXPECT_TRUE(sphere.is_closed(0));
    EXPECT_EQ(sphere(0, 0), sphere(1, 0));
    EXPECT_EQ(sphere.domain(0), (std::pair<Rational, Rational>(0, 4)));
  }
}

TEST(ExactPrimitives, CylindersAndConesHaveTheirRadii)
{
  std::mt19937 generator(2);
  for (int i = 0; i < 20; ++i) {
    const Rational radius = q(2 + i, 3), height = q(7, 2 + i);
    const Rounded_surface tube = written(SC::cylinder_surface<K>(Point(1, 2, 3), radius, height),
                                         random_motion(generator)),
                          tip = written(
                              SC::cone_surface<K>(Point(1, 2, 3), Vector(0, 0, 1), Point(1 + radius, 2, 3 + height)),
                              random_motion(generator));
    const auto cylinder = healed(tube), cone = healed(tip);
    ASSERT_EQ(cylinder.kind, Primitive_kind::CYLINDER);
    ASSERT_EQ(cone.kind, Primitive_kind::CONE);
    for (const Rational& share : {Rational(0), Rational(q(1, 3)), Rational(1)}) {
      const Circle of_cylinder = circle_at(cylinder.spline, share), of_cone = circle_at(cone.spline, share);
      EXPECT_EQ(of_cylinder.squared_radius, radius * radius);
      EXPECT_EQ(of_cone.squared_radius, radius * radius * share * share);
      EXPECT_EQ(squared_distance(of_cone.center, cone.spline(0, 0)), height * height * share * share);
    }
    EXPECT_EQ(squared_distance(circle_at(cylinder.spline, 0).center, circle_at(cylinder.spline, 1).center),
              height * height);
    for_samples(cylinder.spline, [&](const Point& p) {
      const Point a = circle_at(cylinder.spline, 0).center, b = circle_at(cylinder.spline, 1).center;
      EXPECT_EQ(CGAL::cross_product(p - a, b - a).squared_length(), radius * radius * height * height);
    });
  }
}

TEST(ExactPrimitives, ToriHaveTheirRadii)
{
  std::mt19937 generator(3);
  for (int i = 0; i < 10; ++i) {
    const Rational major = q(5 + i, 2), minor = q(4, 3 + i);
    const Rounded_surface given =
        written(SC::torus_surface<K>(Point(-1, 2, q(1, 3)), major, minor), random_motion(generator));
    const auto [torus, kind, displacement] = healed(given);
    ASSERT_EQ(kind, Primitive_kind::TORUS);
    EXPECT_LE(displacement, tolerance);
    const Circle outer = circle_at(torus, 0), inner = circle_at(torus, q(1, 2)), top = circle_at(torus, q(1, 4));
    EXPECT_EQ(outer.squared_radius, (major + minor) * (major + minor));
    EXPECT_EQ(inner.squared_radius, (major - minor) * (major - minor));
    EXPECT_EQ(outer.center, inner.center);
    EXPECT_EQ(top.squared_radius, major * major);
    EXPECT_EQ(squared_distance(top.center, outer.center), minor * minor);
    for_samples(torus, [&](const Point& p) {
      const Rational square = squared_distance(p, outer.center) + major * major - minor * minor,
                     along = (p - outer.center) * (top.center - outer.center);
      EXPECT_EQ(square * square,
                4 * major * major * (squared_distance(p, outer.center) - along * along / (minor * minor)));
    });
    EXPECT_TRUE(torus.is_closed(0) && torus.is_closed(1));
  }
}

// Parts, exchanged and reversed axes, higher degrees, other knots.
TEST(ExactPrimitives, AnyParametrisationOfThatKind)
{
  std::mt19937 generator(4);
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1), sphere = SC::sphere_surface<K>(Point(0, 0, 1), 2),
                tube = SC::cylinder_surface<K>(Point(0, 0, 1), 2, 3);
  const std::vector<Rounded_surface> surfaces{
      written(torus.restricted(0, 3, 4), random_motion(generator)),
      written(torus.restricted(0, 1, 3).restricted(1, 0, 2), random_motion(generator)).transposed(),
      written(torus, random_motion(generator)).reversed(1).elevated({3, 4}),
      written(torus, random_motion(generator)).with_domain(0, 0, 2 * CGAL_PI),
      Rounded_surface(torus.restricted(0, q(1, 3), q(15, 7)).restricted(1, q(1, 5), q(7, 5))),
      written(sphere.restricted(0, 0, 1).restricted(1, 1, 2), random_motion(generator)),
      written(sphere, random_motion(generator)).elevated({4, 3}).with_knot(0, 0.3),
      written(sphere, random_motion(generator)).reversed(0).transposed(),
      written(tube.restricted(0, 1, 2), random_motion(generator)).elevated({2, 2}),
      written(tube, random_motion(generator)).with_domain(1, -0.1, 0.7).transposed()};
  const std::vector<Primitive_kind> kinds{Primitive_kind::TORUS,   Primitive_kind::TORUS,  Primitive_kind::TORUS,
                                          Primitive_kind::TORUS,   Primitive_kind::TORUS,  Primitive_kind::SPHERE,
                                          Primitive_kind::SPHERE,  Primitive_kind::SPHERE, Primitive_kind::CYLINDER,
                                          Primitive_kind::CYLINDER};
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const auto [surface, kind, displacement] = healed(surfaces[i]);
    EXPECT_EQ(kind, kinds[i]) << i;
    EXPECT_LE(displacement, tolerance);
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_EQ(SC::to_nearest_double(surface.domain(axis).first), surfaces[i].domain(axis).first);
      EXPECT_EQ(SC::to_nearest_double(surface.domain(axis).second), surfaces[i].domain(axis).second);
    }
  }
}

// A circle in three pieces of 120 degrees on periodic knots, as OpenCASCADE has it.
Rounded_curve_2 circle_of_three_pieces(double x, double y, double radius)
{
  const double step = 2 * CGAL_PI / 3;
  std::vector<Rounded::Point_2> points;
  std::vector<double> weights, knots{0, 0, step, step, 2 * step, 2 * step, 3 * step};
  for (int i = 0; i < 6; ++i) {
    const double angle = i * step / 2, r = i % 2 == 0 ? radius : 2 * radius;
    points.emplace_back(x + r * std::cos(angle), y + r * std::sin(angle));
    weights.push_back(i % 2 == 0 ? 1 : 0.5);
  }
  knots = {0, 0, 0, step, step, 2 * step, 2 * step, 3 * step, 3 * step, 3 * step};
  points.push_back(points.front());
  weights.push_back(1);
  return Rounded_curve_2(2, knots, points, weights);
}

TEST(ExactPrimitives, CirclesAndLinesInThePlane)
{
  const double side = 1 / std::sqrt(2.0);
  const Rounded_curve_2 arc(2, {0, 0, 0, 1, 1, 1}, {{3.1, 0.7}, {3.1, 2.7}, {1.1, 2.7}}, {1, side, 1}),
      line(1, {0, 0, 1, 1}, {{0.1, 2.7}, {7.3, 2.7}}), parabola(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 2}, {2, 0}});
  const auto result =
      SC::with_exact_primitives(std::vector{circle_of_three_pieces(1.1, 0.7, 0.3), arc, line, parabola}, tolerance);
  ASSERT_TRUE(result.is_complete());
  const std::vector<Primitive_kind> kinds{Primitive_kind::CIRCLE, Primitive_kind::CIRCLE, Primitive_kind::LINE,
                                          Primitive_kind::GENERAL};
  for (std::size_t i = 0; i < kinds.size(); ++i)
    EXPECT_EQ(result.primitives[i].kind, kinds[i]) << i;
  EXPECT_EQ(result.number_of_recognised(), 3);
  EXPECT_LE(result.displacement(), tolerance);
  const K::Point_2 center(q(11, 10), q(7, 10));
  const auto curves = result.splines();
  for (const Rational& share : shares) {
    EXPECT_EQ((curves[0](parameter(curves[0], 0, share)) - center).squared_length(), q(9, 100));
    EXPECT_EQ((curves[1](share) - center).squared_length(), 4);
    EXPECT_EQ(curves[2](share).y(), q(27, 10));
  }
  EXPECT_TRUE(curves[0].is_closed());
  EXPECT_EQ(curves[1].target(), K::Point_2(q(11, 10), q(27, 10)));
  // the end of the arc is on the line, which touches it there
  const auto contact = SC::intersections(curves[1], curves[2]);
  ASSERT_EQ(contact.size(), 1);
  EXPECT_TRUE(contact.is_complete());
}

// In the plane, too, what was rotated together is related again.
TEST(ExactPrimitives, RotatedDrawing)
{
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto moved = [&](const Rounded_curve_2& curve) {
    return curve.transformed(Rounded::Aff_transformation_2(c, -s, std::sqrt(3.0), s, c, -std::sqrt(5.0)));
  };
  const Rounded_curve_2 line(1, {0, 0, 1, 1}, {{-2, 0.5}, {2, 0.5}});
  const auto result = SC::with_exact_primitives(
      std::vector{moved(circle_of_three_pieces(0, 0, 0.5)), moved(circle_of_three_pieces(2, 0, 1.5)), moved(line)},
      tolerance);
  ASSERT_EQ(result.number_of_recognised(), 3);
  for (const auto& curves : {result.splines(), result.simple_splines()}) {
    for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2)}) {
      const auto points = SC::intersections(curves[static_cast<std::size_t>(i)], curves[static_cast<std::size_t>(j)]);
      ASSERT_EQ(points.size(), 1);
      EXPECT_EQ(points[0].kind(), SC::Intersection_kind::TANGENT);
      EXPECT_TRUE(points.is_complete());
    }
  }
  const auto back = result.simple_splines();
  for (std::size_t i = 0; i < back.size(); ++i)
    EXPECT_EQ(back[i].transformed(result.frame), result.primitives[i].spline);
}

// Edges of a cylinder and the line of its axis, together with it.
TEST(ExactPrimitives, CurvesAndSurfacesTogether)
{
  std::mt19937 generator(5);
  const Motion motion = random_motion(generator);
  const Rounded_surface tube = written(SC::cylinder_surface<K>(Point(1, 2, 3), 2, 5), motion);
  const std::vector<Rounded_curve_3> curves{tube.iso_curve(1, 0), tube.iso_curve(0, 1),
                                            Rounded_curve_3(1, {0, 0, 1, 1}, {motion({1, 2, 0}), motion({1, 2, 9})})};
  const auto [exact_curves, surfaces] = SC::with_exact_primitives(curves, std::vector{tube}, tolerance);
  EXPECT_EQ(exact_curves.primitives[0].kind, Primitive_kind::CIRCLE);
  EXPECT_EQ(exact_curves.primitives[1].kind, Primitive_kind::LINE);
  EXPECT_EQ(exact_curves.primitives[2].kind, Primitive_kind::LINE);
  const Surface& cylinder = surfaces.primitives[0].spline;
  EXPECT_EQ(exact_curves.primitives[0].spline, cylinder.iso_curve(1, 0));
  EXPECT_EQ(exact_curves.primitives[1].spline, cylinder.iso_curve(0, 1));
  const auto& axis = exact_curves.primitives[2].spline;
  const Point a = circle_at(cylinder, 0).center, b = circle_at(cylinder, 1).center;
  EXPECT_TRUE(CGAL::collinear(axis.source(), a, b) && CGAL::collinear(axis.target(), a, b));
}

TEST(ExactPrimitives, NearPrimitivesAreNoneWithinLess)
{
  const Rounded_surface sphere = written(SC::sphere_surface<K>(Point(0, 0, 0), 2)),
                        tube = written(SC::cylinder_surface<K>(Point(1, 2, 3), 2, 5)),
                        board = written(SC::plane_patch<K>(Point(0, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0)));
  const auto bent = [](const Rounded_surface& surface, std::size_t k) {
    auto points = surface.control_points();
    points[k] = points[k] + Rounded::Vector_3(1e-6, -2e-6, 2e-6);
    return Rounded_surface({surface.degree(0), surface.degree(1)}, surface.knots(0), surface.knots(1), points,
                           surface.control_weights());
  };
  EXPECT_EQ(healed(bent(sphere, 7)).kind, Primitive_kind::GENERAL);
  EXPECT_EQ(healed(bent(sphere, 7), 1e-4).kind, Primitive_kind::SPHERE);
  EXPECT_GE(healed(bent(sphere, 7), 1e-4).displacement, 1e-7);
  EXPECT_EQ(healed(bent(tube, 3)).kind, Primitive_kind::GENERAL);
  EXPECT_EQ(healed(bent(tube, 3), 1e-4).kind, Primitive_kind::CYLINDER);
  EXPECT_EQ(healed(bent(board, 3)).kind, Primitive_kind::GENERAL);
  EXPECT_EQ(healed(bent(board, 3), 1e-4).kind, Primitive_kind::PLANE);
  // an ellipsoid, an oblique elliptic cylinder
  EXPECT_EQ(healed(sphere.transformed({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1.1, 0})).kind, Primitive_kind::GENERAL);
  EXPECT_EQ(healed(tube.transformed({1, 0, 0.5, 0, 0, 1, 0, 0, 0, 0, 1, 0})).kind, Primitive_kind::GENERAL);
}

// At breaks, where parameters are kept, and of any other point of what was given from the exact sphere.
TEST(ExactPrimitives, BoundHoldsAtExactSamples)
{
  std::mt19937 generator(6);
  for (int i = 0; i < 5; ++i) {
    const Rounded_surface given = written(SC::sphere_surface<K>(Point(1, 2, 3), q(7, 3)), random_motion(generator));
    const auto [sphere, kind, displacement] = healed(given, 1e-6);
    ASSERT_EQ(kind, Primitive_kind::SPHERE);
    const Surface exact(given);
    const Rational bound(displacement);
    for (const Rational& u : exact.breaks(0))
      for (const Rational& v : exact.breaks(1))
        EXPECT_LE(squared_distance(exact(u, v), sphere(u, v)), bound * bound);
    const Point center = middle(sphere(0, 0), sphere(0, 2));
    const Rational least = q(7, 3) - bound, greatest = q(7, 3) + bound;
    bool is_moved = false;
    for_samples(exact, [&](const Point& p) {
      EXPECT_LE(least * least, squared_distance(p, center));
      EXPECT_LE(squared_distance(p, center), greatest * greatest);
      is_moved = is_moved || squared_distance(p, center) != q(49, 9);
    });
    EXPECT_TRUE(is_moved);
  }
}

TEST(ExactPrimitives, ExactOnesStayAsTheyAre)
{
  for (const Surface& surface :
       {SC::sphere_surface<K>(Point(1, 2, 3), q(7, 3)), SC::torus_surface<K>(Point(0, 0, 0), 3, 1),
        SC::cone_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4)),
        SC::plane_patch<K>(Point(1, 0, 0), Vector(1, -1, 0), Vector(1, 0, -1))}) {
    const auto result = SC::with_exact_primitives(std::vector{surface}, tolerance);
    EXPECT_EQ(result.number_of_recognised(), 1);
    EXPECT_EQ(result.displacement(), 0);
    EXPECT_EQ(result.primitives[0].spline, surface);
  }
}

// Pairs that touch, cross at right angles or have an axis in common: rounded, rotated and moved, they are what they
// were.
TEST(ExactPrimitives, PairsAreDecided)
{
  const std::set<std::string> names{"plane touches sphere",
                                    "plane, sphere: equator",
                                    "plane touches cylinder",
                                    "spheres touch outside",
                                    "cylinder, sphere: Viviani",
                                    "ball in tube",
                                    "equal pipes",
                                    "parallel cylinders touch",
                                    "cylinders touch",
                                    "cylinder, cone: one axis",
                                    "elbow",
                                    "fillet of cone",
                                    "torus on plane",
                                    "tori touch at equators",
                                    "cones, one apex"};
  std::mt19937 generator(7);
  std::size_t count = 0;
  for (const pairs_of_primitives::Pair& pair : pairs_of_primitives::all_pairs()) {
    if (!names.contains(pair.name))
      continue;
    ++count;
    const Motion motion = random_motion(generator);
    const auto result =
        SC::with_exact_primitives(std::vector{written(pair.a.patch, motion), written(pair.b.patch, motion)}, tolerance);
    ASSERT_EQ(result.number_of_recognised(), 2) << pair.name;
    EXPECT_LE(result.displacement(), tolerance);
    const auto surfaces = result.simple_splines();
    const auto set = SC::intersection_curves(surfaces[0], surfaces[1], {.tolerance = 1e-8, .time_limit = 60});
    const auto expected = SC::intersection_curves(pair.a.patch, pair.b.patch, {.tolerance = 1e-8});
    EXPECT_TRUE(set.is_complete()) << pair.name;
    EXPECT_EQ(set.number_of_closed_curves(), expected.number_of_closed_curves()) << pair.name;
    EXPECT_EQ(set.number_of_open_curves(), expected.number_of_open_curves()) << pair.name;
    EXPECT_EQ(set.singular_points().size(), expected.singular_points().size()) << pair.name;
  }
  EXPECT_EQ(count, names.size());
}

// Not healed, most are undecided; then it is said where.
TEST(ExactPrimitives, RoundedPairsSayWhereTheyAreUndecided)
{
  std::mt19937 generator(7);
  std::size_t undecided = 0;
  for (const pairs_of_primitives::Pair& pair : pairs_of_primitives::all_pairs()) {
    const Motion motion = random_motion(generator);
    const auto set = SC::intersection_curves(written(pair.a.patch, motion), written(pair.b.patch, motion),
                                             {.tolerance = 1e-8, .time_limit = 0.1});
    const std::vector<SC::Undecided_part> parts = set.undecided();
    EXPECT_EQ(parts.empty(), set.is_complete()) << pair.name;
    undecided += parts.empty() ? 0 : 1;
    for (const SC::Undecided_part& part : parts)
      for (const auto& [lower, upper] : part.place)
        EXPECT_LE(lower, upper) << pair.name;
  }
  EXPECT_GT(undecided, 0u);
}

// A surface of no kind: its seam, its pole and the corner that it has in common with another one.
TEST(ExactPrimitives, GeneralSurfacesAreClosed)
{
  std::mt19937 generator(8);
  std::uniform_real_distribution<double> noise(-1e-12, 1e-12), coordinate(-1, 1);
  const auto near = [&](const Rounded::Point_3& p) {
    return Rounded::Point_3(p.x() + noise(generator), p.y() + noise(generator), p.z() + noise(generator));
  };
  const auto anywhere = [&] {
    return Rounded::Point_3(coordinate(generator), coordinate(generator), coordinate(generator));
  };
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1}, line{0, 0, 1, 1};
  const Rounded::Point_3 pole = anywhere();
  std::vector<Rounded::Point_3> points;
  std::vector<double> weights;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      points.push_back(j == 0 ? near(pole) : i == 3 ? near(points[static_cast<std::size_t>(j)]) : anywhere());
      weights.push_back(1 + 0.1 * j + (i % 3 == 0 ? 0 : 0.3) + noise(generator) / 100);
    }
  const Rounded_surface closed({3, 3}, knots, knots, points, weights);
  const Rounded_surface other(
      {1, 3}, line, knots,
      {near(pole), anywhere(), anywhere(), anywhere(), anywhere(), anywhere(), anywhere(), anywhere()});
  const auto result = SC::with_exact_primitives(std::vector{closed, other}, tolerance);
  EXPECT_EQ(result.number_of_recognised(), 0);
  const Surface surface = result.primitives[0].spline;
  EXPECT_FALSE(closed.is_closed(0));
  EXPECT_TRUE(surface.is_closed(0));
  EXPECT_EQ(surface(0, 0), surface(q(1, 3), 0));
  EXPECT_EQ(surface(0, 0), result.primitives[1].spline(0, 0));
  EXPECT_GT(result.displacement(), 0);
  EXPECT_LE(result.displacement(), 1e-10);
  const Surface exact(closed);
  for (const Rational& u : shares)
    for (const Rational& v : shares)
      EXPECT_LE(squared_distance(exact(u, v), surface(u, v)),
                Rational(result.displacement()) * Rational(result.displacement()));
}

TEST(ExactPrimitives, LimitsAndErrors)
{
  const std::vector<Rounded_surface> surfaces{written(SC::sphere_surface<K>(Point(0, 0, 0), 2)),
                                              written(SC::torus_surface<K>(Point(0, 0, 0), 3, 1))};
  const auto stopped = SC::with_exact_primitives(surfaces, tolerance, {.time_limit = 1e-9});
  EXPECT_FALSE(stopped.is_complete());
  ASSERT_EQ(stopped.undecided().size(), 2);
  EXPECT_EQ(stopped.undecided()[1].place.size(), 3);
  EXPECT_EQ(stopped.undecided()[1].parameters[0].operand, 1);
  EXPECT_EQ(stopped.primitives[0].kind, Primitive_kind::UNDECIDED);
  EXPECT_EQ(stopped.primitives[1].spline, Surface(surfaces[1]));
  const auto complete = SC::with_exact_primitives(surfaces, tolerance, {.time_limit = 1000});
  EXPECT_TRUE(complete.is_complete() && complete.undecided().empty());
  EXPECT_EQ(complete.number_of_recognised(), 2);
  EXPECT_THROW(SC::with_exact_primitives(surfaces, 0), SC::Invalid_input);
  EXPECT_THROW(SC::with_exact_primitives(surfaces, std::nan("")), SC::Invalid_input);
  EXPECT_THROW(SC::with_exact_primitives(surfaces, tolerance, {.time_limit = -1}), SC::Invalid_input);
  EXPECT_TRUE(SC::with_exact_primitives(std::vector<Rounded_surface>(), tolerance).is_complete());
}

} // namespace test_exact_primitives
