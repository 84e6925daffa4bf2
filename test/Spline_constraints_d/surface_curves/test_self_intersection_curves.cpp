// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a surface meets itself: curves and pinch points known by formula, in one piece and in several ones, images of
// random surfaces under maps that change nothing, surfaces that do not meet themselves.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/self_intersection_curves.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace self_intersection_curves_test {

namespace {

using SC::Intersection_kind;
using Function = SC::Bspline_function<Rational>;
using Intersection = SC::Surface_intersection<K>;

// A polynomial surface over [-width, width]^2.
Surface polynomial_surface(const Rational& width,
                           const std::function<std::array<Function, 3>(const Function&, const Function&)>& coordinates)
{
  const std::vector<Rational> knots{Rational(-width), Rational(-width), width, width};
  const Function u({1, 1}, {knots, knots}, {Rational(-width), Rational(-width), width, width}),
      v({1, 1}, {knots, knots}, {Rational(-width), width, Rational(-width), width});
  return Surface::from_homogeneous_coordinates(coordinates(u, v), u * Rational(0) + Rational(1));
}

// Counts, and what holds of all samples: two different pairs of parameters with the same point, on which a condition is
// checked.
void expect_curves(const Surface& surface, const Intersection& set, std::size_t closed, std::size_t open,
                   std::size_t pinch_points, const std::function<void(const Point&)>& check = {})
{
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_closed_curves(), closed);
  EXPECT_EQ(set.number_of_open_curves(), open);
  EXPECT_EQ(set.singular_points().size(), pinch_points);
  std::size_t distant = 0;
  for (const SC::Intersection_curve& curve : set.curves())
    for (const SC::Intersection_arc& arc : curve.arcs)
      for (const auto& sample : set.samples(arc, 1e-2)) {
        std::array<Point, 2> points;
        for (std::size_t k = 0; k < 2; ++k)
          points[k] = surface(
              std::clamp(Rational(sample.parameters[k].value()[0]), surface.domain(0).first, surface.domain(0).second),
              std::clamp(Rational(sample.parameters[k].value()[1]), surface.domain(1).first, surface.domain(1).second));
        EXPECT_LE(length(points[1] - points[0]), 1e-9);
        distant += std::abs(sample.parameters[0].value()[0] - sample.parameters[1].value()[0]) +
                std::abs(sample.parameters[0].value()[1] - sample.parameters[1].value()[1]) >
            1e-6;
        if (check)
          check(sample.point);
      }
  EXPECT_GE(distant, set.curves().size());
}

} // namespace

TEST(Self_intersection_curves, pinch_points)
{
  // Whitney's umbrella: the half-line x = y = 0, z >= 0.
  const Surface umbrella = polynomial_surface(2, [](const Function& u, const Function& v) {
    return std::array{u * v, u, v * v};
  });
  const Intersection set = SC::self_intersection_curves(umbrella);
  expect_curves(umbrella, set, 0, 1, 1, [](const Point& p) {
    EXPECT_NEAR(CGAL::to_double(p.x()), 0, 1e-9);
    EXPECT_NEAR(CGAL::to_double(p.y()), 0, 1e-9);
    EXPECT_TRUE(-1e-9 < p.z() && p.z() < 4 + 1e-9);
  });
  const std::array ends{set.end(set.curves()[0], 0), set.end(set.curves()[0], 1)};
  const std::size_t pinch = ends[0].kind() == Intersection_kind::TANGENT ? 0 : 1;
  EXPECT_EQ(ends[pinch].kind(), Intersection_kind::TANGENT);
  EXPECT_EQ(ends[1 - pinch].kind(), Intersection_kind::END_POINT);
  for (const std::size_t k : {0, 1}) {
    EXPECT_NEAR(ends[pinch].parameter(k, 0), 0, 1e-9);
    EXPECT_NEAR(ends[pinch].parameter(k, 1), 0, 1e-9);
    EXPECT_NEAR(std::abs(ends[1 - pinch].parameter(k, 1)), 2, 1e-9);
    EXPECT_TRUE(ends[1 - pinch].is_at_end(k, 1));
  }

  // v and -v have the same point where v^2 = 1 - u^2: a curve from one pinch point to another one.
  const Surface pocket = polynomial_surface(Rational(3, 2), [](const Function& u, const Function& v) {
    return std::array{u, v * (u * u + v * v - Rational(1)), v * v};
  });
  const Intersection arc = SC::self_intersection_curves(pocket);
  expect_curves(pocket, arc, 0, 1, 2, [](const Point& p) {
    EXPECT_NEAR(CGAL::to_double(p.y()), 0, 1e-9);
    EXPECT_NEAR(CGAL::to_double(p.z() + p.x() * p.x()), 1, 1e-9);
  });
  std::vector<double> places;
  for (const auto& point : arc.singular_points()) {
    EXPECT_EQ(point.kind(), Intersection_kind::TANGENT);
    EXPECT_NEAR(CGAL::to_double(point.point().z()), 0, 1e-9);
    places.push_back(CGAL::to_double(point.point().x()));
  }
  EXPECT_NEAR((std::min)(places[0], places[1]), -1, 1e-9);
  EXPECT_NEAR((std::max)(places[0], places[1]), 1, 1e-9);
}

// v and -v have the same point where u^2 + (v^2 - 1)^2 = 1/4: a circle in space.
TEST(Self_intersection_curves, closed_curve)
{
  const Surface surface = polynomial_surface(2, [](const Function& u, const Function& v) {
    const Function height = v * v - Rational(1);
    return std::array{u, v * (u * u + height * height - Rational(1, 4)), v * v};
  });
  expect_curves(surface, SC::self_intersection_curves(surface), 1, 0, 0, [](const Point& p) {
    EXPECT_NEAR(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.z()) - 1), 0.5, 1e-9);
    EXPECT_NEAR(CGAL::to_double(p.y()), 0, 1e-9);
  });
}

// Its two curves lie in its planes of symmetry; they end on two edges at once, at irrational parameters.
TEST(Self_intersection_curves, Enneper)
{
  const Surface surface = polynomial_surface(2, [](const Function& u, const Function& v) {
    const Rational third(1, 3);
    return std::array{u - u * u * u * third + u * v * v, v - v * v * v * third + v * u * u, u * u - v * v};
  });
  expect_curves(surface, SC::self_intersection_curves(surface), 0, 2, 0, [](const Point& p) {
    EXPECT_NEAR((std::min)(std::abs(CGAL::to_double(p.x())), std::abs(CGAL::to_double(p.y()))), 0, 1e-9);
  });
}

TEST(Self_intersection_curves, cylinder_over_a_loop)
{
  const Surface surface = polynomial_surface(2, [](const Function& u, const Function& v) {
    return std::array{u * u, u * u * u - u, v};
  });
  expect_curves(surface, SC::self_intersection_curves(surface), 0, 1, 0, [](const Point& p) {
    EXPECT_NEAR(CGAL::to_double(p.x()), 1, 1e-9);
    EXPECT_NEAR(CGAL::to_double(p.y()), 0, 1e-9);
  });
  // The same with weights: a projective image.
  const auto [x, y, z] = surface.homogeneous_coordinates();
  const Surface image =
      Surface::from_homogeneous_coordinates({x, y, z}, x * Rational(1, 10) + z * Rational(1, 5) + Rational(3));
  expect_curves(image, SC::self_intersection_curves(image), 0, 1, 0);
}

// Reversed and exchanged parameters, and affine maps change nothing.
TEST(Self_intersection_curves, random_surfaces)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> coordinate(-8, 8);
  std::size_t curves = 0;
  for (int round = 0; round < 3; ++round) {
    std::vector<Point> points, mirrored;
    for (int i = 0; i < 9; ++i)
      points.emplace_back(coordinate(generator), coordinate(generator), coordinate(generator));
    for (std::size_t i = 0; i < 9; ++i) {   // the parameters exchanged, one of them reversed
      const Point& p = points[3 * (2 - i % 3) + i / 3];
      mirrored.emplace_back(p.x() + 2 * p.y(), p.y() - p.z(), 3 * p.z() + p.x());
    }
    const std::vector<Rational> knots{0, 0, 0, 1, 1, 1};
    const Surface surface({2, 2}, knots, knots, points), image({2, 2}, knots, knots, mirrored);
    const Intersection set = SC::self_intersection_curves(surface);
    expect_curves(surface, set, set.number_of_closed_curves(), set.number_of_open_curves(),
                  set.singular_points().size());
    expect_curves(image, SC::self_intersection_curves(image), set.number_of_closed_curves(),
                  set.number_of_open_curves(), set.singular_points().size());
    curves += set.curves().size();
  }
  EXPECT_GE(curves, 3u);
}

TEST(Self_intersection_curves, none)
{
  const Surface wave = polynomial_surface(1, [](const Function& u, const Function& v) {
    return std::array{u, v, u * u * v};
  });
  const Intersection set = SC::self_intersection_curves(wave);
  EXPECT_TRUE(set.is_complete() && set.curves().empty());
  // Nearly a loop: x = u^2, y = u^3 + u / 1000 comes back without meeting itself.
  const Surface bend = polynomial_surface(1, [](const Function& u, const Function& v) {
    return std::array{u * u, u * u * u + u * Rational(1, 1000), v};
  });
  expect_curves(bend, SC::self_intersection_curves(bend), 0, 0, 0);
}

// The same surfaces cut into pieces: the curves go on across breaks, in one point or in both.
TEST(Self_intersection_curves, several_pieces)
{
  const auto with_knots = [](const Surface& surface, const Rational& u, const Rational& v) {
    return surface.with_knot(0, u).with_knot(1, v);
  };

  const Surface umbrella = with_knots(polynomial_surface(2,
                                                         [](const Function& u, const Function& v) {
                                                           return std::array{u * v, u, v * v};
                                                         }),
                                      Rational(1, 3), Rational(1, 2));
  const Intersection half_line = SC::self_intersection_curves(umbrella);
  expect_curves(umbrella, half_line, 0, 1, 1);
  EXPECT_GE(half_line.curves()[0].arcs.size(), 2u);   // v passes 1/2
  EXPECT_TRUE(half_line.points().empty());
  const std::array ends{half_line.end(half_line.curves()[0], 0), half_line.end(half_line.curves()[0], 1)};
  const std::size_t pinch = ends[0].kind() == Intersection_kind::TANGENT ? 0 : 1;
  EXPECT_EQ(ends[pinch].kind(), Intersection_kind::TANGENT);
  EXPECT_EQ(ends[1 - pinch].kind(), Intersection_kind::END_POINT);
  EXPECT_TRUE(ends[1 - pinch].is_at_end(0, 1) && ends[1 - pinch].is_at_end(1, 1));
  EXPECT_LE(length(half_line.polyline(half_line.curves()[0], 1e-2).front() - ends[0].point()), 1e-9);

  // Both points pass a break at once; the point is on the boundary of four parts, and on the curve in two of them.
  const Surface loop = polynomial_surface(2, [](const Function& u, const Function& v) {
    return std::array{u * u, u * u * u - u, v};
  });
  for (const Rational& u : {Rational(1, 3), Rational(0)}) {
    const Intersection line = SC::self_intersection_curves(with_knots(loop, u, Rational(1, 2)));
    expect_curves(loop, line, 0, 1, 0, [](const Point& p) { EXPECT_NEAR(CGAL::to_double(p.x()), 1, 1e-9); });
    EXPECT_GE(line.curves()[0].arcs.size(), 2u);
    EXPECT_TRUE(line.points().empty());
    for (const int side : {0, 1})
      EXPECT_NEAR(std::abs(CGAL::to_double(line.end(line.curves()[0], side).point().z())), 2, 1e-9);
  }

  const Surface circle = with_knots(polynomial_surface(2, [](const Function& u, const Function& v) {
    const Function height = v * v - Rational(1);
    return std::array{u, v * (u * u + height * height - Rational(1, 4)), v * v};
  }), Rational(1, 8), Rational(1, 2));
  const Intersection closed = SC::self_intersection_curves(circle);
  expect_curves(circle, closed, 1, 0, 0, [](const Point& p) {
    EXPECT_NEAR(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.z()) - 1), 0.5, 1e-9);
  });
  EXPECT_GE(closed.curves()[0].arcs.size(), 2u);
}

TEST(Self_intersection_curves, closed_surfaces)
{
  // A profile with a loop, (1 + v^2, v^3 - v), goes around the axis: a circle of radius 2, which crosses the breaks and
  // the seam in both points at once.
  const SC::Bspline_curve_3<K> profile(
      3,
      {Rational(-3, 2), Rational(-3, 2), Rational(-3, 2), Rational(-3, 2), Rational(3, 2), Rational(3, 2),
       Rational(3, 2), Rational(3, 2)},
      {Point(Rational(13, 4), 0, Rational(-15, 8)), Point(Rational(1, 4), 0, Rational(31, 8)),
       Point(Rational(1, 4), 0, Rational(-31, 8)), Point(Rational(13, 4), 0, Rational(15, 8))});
  const Surface turned = SC::surface_of_revolution<K>(profile, Point(0, 0, 0), Vector(0, 0, 1));
  const Intersection circle = SC::self_intersection_curves(turned);
  expect_curves(turned, circle, 1, 0, 0, [](const Point& p) {
    EXPECT_NEAR(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.y())), 2, 1e-9);
    EXPECT_NEAR(CGAL::to_double(p.z()), 0, 1e-9);
  });
  EXPECT_EQ(circle.curves()[0].arcs.size(), 4u);
  EXPECT_TRUE(circle.points().empty());

  // A bow tie of four pieces, moved up: one straight line.
  const std::vector<Point> points{{-1, -1, 0}, {-1, -1, 1}, {1, 1, 0},  {1, 1, 1},
                                  {1, -1, 0},  {1, -1, 1},  {-1, 2, 0}, {-1, 2, 1}};
  const Surface tie = Surface::from_periodic({2, 1}, {0, 1, 2, 3, 4}, {0, 0, 1, 1}, points, {true, false});
  const Intersection line = SC::self_intersection_curves(tie);
  expect_curves(tie, line, 0, 1, 0);
  for (const std::size_t k : {0, 1})
    EXPECT_TRUE(line.end(line.curves()[0], 0).is_at_end(k, 1) && line.end(line.curves()[0], 1).is_at_end(k, 1));

  // Closed surfaces that do not meet themselves; a corner along the seam.
  const Surface cylinder = SC::cylinder_surface<K>(Point(0, 0, 0), 3, 1);
  expect_curves(cylinder, SC::self_intersection_curves(cylinder), 0, 0, 0);
  const Surface drop = polynomial_surface(1, [](const Function& u, const Function& v) {
    return std::array{u * u, u * u * u - u, v};
  });
  expect_curves(drop, SC::self_intersection_curves(drop), 0, 0, 0);
}

TEST(Self_intersection_curves, undecided)
{
  // A sheet that lies on itself, an edge that is one point, and a cuspidal edge.
  const Surface fold = polynomial_surface(1, [](const Function& u, const Function& v) {
    return std::array{u * u, v, u * Rational(0)};
  });
  EXPECT_FALSE(SC::self_intersection_curves(fold).is_complete());
  const Surface cone = polynomial_surface(1, [](const Function& u, const Function& v) {
    const Function height = v + Rational(1);
    return std::array{height * u, height, height * u * u};
  });
  EXPECT_FALSE(SC::self_intersection_curves(cone, {.tolerance = 1e-2}).is_complete());
  const Surface cusp = polynomial_surface(1, [](const Function& u, const Function& v) {
    return std::array{u * u, u * u * u, v};
  });
  const Intersection set = SC::self_intersection_curves(cusp);
  EXPECT_FALSE(set.is_complete());
  EXPECT_TRUE(set.curves().empty());
  EXPECT_FALSE(set.undecided().empty());
}

// A pinch point on a break, and a curve along one: what is near is undecided, the rest is found.
TEST(Self_intersection_curves, undecided_at_breaks)
{
  const Surface umbrella = polynomial_surface(2, [](const Function& u, const Function& v) {
    return std::array{u * v, u, v * v};
  });
  const Intersection cut = SC::self_intersection_curves(umbrella.with_knot(1, 0), {.tolerance = 1e-3});
  EXPECT_FALSE(cut.is_complete());
  EXPECT_EQ(cut.number_of_open_curves(), 1u);
  const auto has_pinch_point = [](const auto& region) {
    for (const std::size_t k : {0, 1})
      for (const std::size_t axis : {0, 1})
        if (region.parameter_range(k, axis).first > 0 || region.parameter_range(k, axis).second < 0)
          return false;
    return true;
  };
  const auto undecided = cut.undecided_points();
  EXPECT_TRUE(std::any_of(undecided.begin(), undecided.end(), has_pinch_point));

  const Surface loop = polynomial_surface(2, [](const Function& u, const Function& v) {
    return std::array{u * u, u * u * u - u, v};
  });
  EXPECT_FALSE(SC::self_intersection_curves(loop.with_knot(0, 1), {.tolerance = 1e-2}).is_complete());
}

TEST(Self_intersection_curves, bad_input)
{
  const Surface wave = polynomial_surface(1, [](const Function& u, const Function& v) {
    return std::array{u, v, u * v};
  });
  EXPECT_THROW(SC::self_intersection_curves(wave, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace self_intersection_curves_test
