// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves along which two surfaces touch: planes, spheres, cylinders, cones and tori with known circles and lines, on
// pieces, breaks and seams, parametric and implicit; their kinds, also of curves that cross.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace contact_curves {

using Intersection = SC::Surface_intersection<K>;
using Polynomial = SC::Power_polynomial;

double number(const Rational& x) { return CGAL::to_double(x); }

template <class A, class B>
Intersection expect_curves(const A& a, const B& b, std::size_t closed, std::size_t open, std::size_t contacts,
                           std::size_t singular = 0)
{
  Intersection set = SC::intersection_curves(a, b);
  EXPECT_TRUE(set.is_complete()) << set;
  EXPECT_EQ(set.number_of_closed_curves(), closed);
  EXPECT_EQ(set.number_of_open_curves(), open);
  EXPECT_EQ(set.number_of_contact_curves(), contacts);
  EXPECT_EQ(set.singular_points().size(), singular);
  for (const SC::Intersection_curve& curve : set.curves())
    EXPECT_EQ(curve.kind(),
              curve.multiplicity == 1 ? SC::Intersection_kind::TRANSVERSAL : SC::Intersection_kind::TANGENT);
  return set;
}

// The one curve is a contact of the first order along the circle of this radius around the axis of z at this height.
void expect_circle(const Intersection& set, double radius, double height)
{
  ASSERT_EQ(set.curves().size(), 1u);
  const SC::Intersection_curve& curve = set.curves().front();
  EXPECT_TRUE(curve.is_closed);
  EXPECT_EQ(curve.multiplicity, 2);
  EXPECT_EQ(set.end(curve, 0).kind(), SC::Intersection_kind::TANGENT);
  const std::vector<Point> points = set.polyline(curve, 1e-2);
  ASSERT_GE(points.size(), 20u);
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(std::hypot(number(points[i].x()), number(points[i].y())), radius, 1e-10);
    EXPECT_NEAR(number(points[i].z()), height, 1e-10);
    length += i == 0 ? 0 : std::sqrt(number(CGAL::squared_distance(points[i - 1], points[i])));
  }
  const double pi = std::acos(-1.0);
  EXPECT_LT(length, 2 * pi * radius + 1e-9);
  EXPECT_GT(length, 2 * pi * radius * 0.98);
}

K::Aff_transformation_3 motion(int k)
{
  const Rational m(k), n(k + 1), square(m * m + n * n), c((n * n - m * m) / square), s(2 * m * n / square);
  const K::Aff_transformation_3 about_z(c, -s, 0, 1, s, c, 0, -2, 0, 0, 1, Rational(1, 3)),
      about_x(1, 0, 0, 0, 0, c, -s, 0, 0, s, c, k);
  return about_x * about_z;
}

const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);
const Surface cylinder =
    SC::cylinder_surface<K>(Point(0, 0, -3), Vector(0, 0, 6), Point(Rational(3, 5), Rational(4, 5), -3));
const Surface cone = SC::cone_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(4, 0, 3));

TEST(Contact_curves, circles_with_planes_and_spheres)
{
  expect_circle(expect_curves(torus, K::Plane_3(0, 0, 1, -1), 1, 0, 1), 3, 1);
  expect_circle(expect_curves(torus, K::Sphere_3(Point(0, 0, 0), 4), 1, 0, 1), 2, 0);    // from inside, along a break
  expect_circle(expect_curves(torus, K::Sphere_3(Point(0, 0, 0), 16), 1, 0, 1), 4, 0);   // around it, along the seam
  expect_circle(expect_curves(cylinder, K::Sphere_3(Point(0, 0, Rational(1, 3)), 1), 1, 0, 1), 1, 1.0 / 3);
  expect_circle(expect_curves(cone, K::Sphere_3(Point(0, 0, Rational(5, 2)), 4), 1, 0, 1), 1.2, 0.9);
  expect_curves(torus, K::Plane_3(0, 0, 1, Rational(-101, 100)), 0, 0, 0);
  expect_curves(torus, K::Plane_3(0, 0, 1, Rational(-99, 100)), 2, 0, 0);
}

Surface board(const Rational& y0, const Rational& y1, const Rational& height)
{
  return SC::bilinear_surface<K>(Point(-5, y0, height), Point(-5, y1, height), Point(6, y0, height),
                                 Point(6, y1, height));
}

// Neither is implicit: the equation of one of them is found.
TEST(Contact_curves, parametric_surfaces)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, Rational(1, 3)), 1);
  const Intersection ring = expect_curves(cylinder, sphere, 1, 0, 1);
  expect_circle(ring, 1, 1.0 / 3);
  for (const SC::Intersection_arc& arc : ring.curves()[0].arcs)
    for (const auto& sample : ring.samples(arc, 1e-1)) {
      const auto at = [](const Surface& surface, const std::array<double, 2>& uv) {
        return surface(Rational(uv[0]), Rational(uv[1]));
      };
      EXPECT_LT(number(CGAL::squared_distance(at(cylinder, sample.parameters[0].value()), sample.point)), 1e-20);
      EXPECT_LT(number(CGAL::squared_distance(at(sphere, sample.parameters[1].value()), sample.point)), 1e-20);
    }
  expect_circle(expect_curves(sphere, cylinder, 1, 0, 1), 1, 1.0 / 3);
  expect_circle(expect_curves(cone, SC::sphere_surface<K>(Point(0, 0, Rational(5, 2)), 2), 1, 0, 1), 1.2, 0.9);
  expect_circle(expect_curves(torus, board(-5, 5, 1), 1, 0, 1), 3, 1);
  const Surface wall = SC::bilinear_surface<K>(Point(-5, 1, -1), Point(5, 1, -1), Point(-5, 1, 2), Point(5, 1, 2));
  const Intersection line = expect_curves(cylinder, wall, 0, 1, 1);
  ASSERT_EQ(line.curves().size(), 1u);
  for (const Point& p : line.polyline(line.curves()[0], 1e-2)) {
    EXPECT_NEAR(number(p.x()), 0, 1e-10);
    EXPECT_NEAR(number(p.y()), 1, 1e-10);
  }
  const Intersection arc = expect_curves(torus, board(-1, 5, 1), 0, 1, 1);
  ASSERT_EQ(arc.curves().size(), 1u);
  for (const int side : {0, 1}) {
    const auto end = arc.end(arc.curves()[0], side);
    EXPECT_EQ(end.kind(), SC::Intersection_kind::END_POINT);
    EXPECT_NEAR(number(end.point().y()), -1, 1e-12);
    EXPECT_NEAR(std::abs(number(end.point().x())), std::sqrt(8.0), 1e-10);
  }
}

// Along seams and breaks of both surfaces, at the same places or others.
TEST(Contact_curves, of_parametric_surfaces_along_breaks)
{
  const auto turned = [](int k) {
    const Rational m(k), n(k + 1), square(m * m + n * n), c((n * n - m * m) / square), s(2 * m * n / square);
    return K::Aff_transformation_3(c, -s, 0, 0, s, c, 0, 0, 0, 0, 1, 0);
  };
  const Surface large = SC::torus_surface<K>(Point(0, 0, 0), 5, 1),
                tube = SC::cylinder_surface<K>(Point(0, 0, -3), Vector(0, 0, 6), Point(4, 0, -3));
  expect_circle(expect_curves(torus, large, 1, 0, 1), 4, 0);
  expect_circle(expect_curves(tube.transformed(turned(2)), torus, 1, 0, 1), 4, 0);
  // which has poles elsewhere
  expect_circle(expect_curves(torus, SC::sphere_surface<K>(Point(0, 0, 0), 4), 1, 0, 1), 4, 0);
}

// Inside of a cell, along a break and along the seam.
TEST(Contact_curves, lines_of_cylinders)
{
  for (const K::Plane_3& plane : {K::Plane_3(1, 0, 0, -1), K::Plane_3(3, 4, 0, 5), K::Plane_3(3, 4, 0, -5)}) {
    const Intersection set = expect_curves(cylinder, plane, 0, 1, 1);
    ASSERT_EQ(set.curves().size(), 1u);
    EXPECT_EQ(set.curves()[0].multiplicity, 2);
    for (const Point& p : set.polyline(set.curves()[0], 1e-3)) {
      EXPECT_NEAR(number(p.x() * p.x() + p.y() * p.y()), 1, 1e-10);
      EXPECT_NEAR(number(plane.a() * p.x() + plane.b() * p.y() + plane.d()), 0, 1e-10);
    }
    for (const int side : {0, 1})
      EXPECT_EQ(CGAL::abs(set.end(set.curves()[0], side).point().z()), 3);
  }
}

// y (y - x)^2 (x^2 + y^2 - 1)^3 as heights: lines and a circle of the contacts 1, 2 and 3 that cross.
TEST(Contact_curves, multiplicities)
{
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1), line = x - y - Polynomial(Rational(1, 7)),
                   circle = x * x + y * y - Polynomial(1);
  const auto factors =
      SC::square_free_factors((y - Polynomial(Rational(1, 3))) * line * line * circle * circle * circle);
  ASSERT_EQ(factors.size(), 3u);
  EXPECT_EQ(factors[0].total_degree(), 1);
  EXPECT_EQ(factors[1].total_degree(), 1);
  EXPECT_EQ(factors[2].total_degree(), 2);
  EXPECT_EQ(SC::square_free_factors(circle).size(), 1u);
  auto [u, v] = SC::unknowns({-2, Rational(33, 16)}, {-2, 2});
  const auto set = SC::solve_curves(square(u - v - Rational(1, 7)) * pow(u * u + v * v - 1, 3) == 0);
  EXPECT_TRUE(set.is_complete());
  std::array<int, 4> count{};
  for (const SC::Solution_curve& curve : set.curves()) {
    ASSERT_TRUE(curve.multiplicity() == 2 || curve.multiplicity() == 3);
    ++count[static_cast<std::size_t>(curve.multiplicity())];
  }
  EXPECT_EQ(count[2], 3);   // the line between and behind two nodes
  EXPECT_EQ(count[3], 2);
  EXPECT_EQ(SC::solve_curves(u * u + v * v == 1).curves()[0].multiplicity(), 1);
}

TEST(Contact_curves, motions_and_knots_change_nothing)
{
  const K::Plane_3 top(0, 0, 1, -1);
  for (int k = 1; k <= 3; ++k) {
    const K::Aff_transformation_3 moved = motion(k);
    const Intersection set = expect_curves(torus.transformed(moved), top.transform(moved), 1, 0, 1);
    ASSERT_EQ(set.curves().size(), 1u);
    for (const Point& p : set.polyline(set.curves()[0], 1e-1)) {
      const Point q = moved.inverse().transform(p);
      EXPECT_NEAR(std::hypot(number(q.x()), number(q.y())), 3, 1e-9);
      EXPECT_NEAR(number(q.z()), 1, 1e-9);
    }
    expect_curves(cylinder.transformed(moved), K::Sphere_3(Point(0, 0, 0), 1).orthogonal_transform(moved), 1, 0, 1);
  }
  expect_circle(expect_curves(torus.with_knot(0, Rational(1, 3)).with_knot(1, Rational(4, 3)), top, 1, 0, 1), 3, 1);
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, Rational(1, 3)), 1);
  for (int k = 1; k <= 3; ++k)
    expect_curves(cylinder.transformed(motion(k)), sphere.transformed(motion(k)), 1, 0, 1);
  expect_curves(torus.transformed(motion(2)), board(-1, 5, 1).transformed(motion(2)), 0, 1, 1);
}

// The coordinates in a frame that is turned.
std::array<SC::Expression, 3> turned_coordinates(int k)
{
  auto [x, y, z] = SC::unknowns({-5, Rational(41, 8)}, {-5, Rational(43, 8)}, {-5, Rational(47, 8)});
  const Rational m(k), n(k + 1), square(m * m + n * n), c((n * n - m * m) / square), s(2 * m * n / square);
  const SC::Expression u = c * x + s * y, v = c * y - s * x;
  return {u, c * v + s * z, c * z - s * v};
}

template <class A, class B>
void expect_implicit_contacts(const A& a, const B& b, std::size_t closed, std::size_t open, int multiplicity)
{
  const auto set = SC::intersection_curves(a, b);
  EXPECT_TRUE(set.is_complete()) << set;
  EXPECT_EQ(set.number_of_closed_curves(), closed);
  EXPECT_EQ(set.number_of_open_curves(), open);
  EXPECT_TRUE(set.singular_points().empty());
  for (const SC::Intersection_curve& curve : set.curves()) {
    EXPECT_EQ(curve.multiplicity, multiplicity);
    EXPECT_GT(set.polyline(curve, 1e-1).size(), 2u);
  }
}

TEST(Contact_curves, implicit_surfaces)
{
  for (const int k : {0, 2}) {
    const auto [x, y, z] = turned_coordinates(k);
    const SC::Expression q = x * x + y * y;
    const SC::Implicit_surface_3 sphere(q + z * z == 1), tube(q == 1), cone(z * z == 3 * q);
    expect_implicit_contacts(sphere, tube, 1, 0, 2);
    expect_implicit_contacts(tube, SC::Implicit_surface_3(q == z * z + 1), 1, 0, 2);
    expect_implicit_contacts(cone, SC::Implicit_surface_3(q + square(z - 2) == 1), 1, 0, 2);
    expect_implicit_contacts(SC::Implicit_surface_3(q == 2 * z), SC::Implicit_surface_3(q + square(z - 3) == 5), 1, 0,
                             2);
    expect_implicit_contacts(tube, SC::Implicit_surface_3(square(x - 2) + y * y == 1), 0, 1, 2);   // along a line
    expect_implicit_contacts(sphere, SC::Implicit_surface_3(q == Rational(99, 100)), 2, 0, 1);
    expect_implicit_contacts(sphere, SC::Implicit_surface_3(q == Rational(101, 100)), 0, 0, 0);
    const SC::Implicit_surface_3 ring(square(q + z * z + 8) == 36 * q);
    expect_implicit_contacts(ring, SC::Implicit_surface_3(z == 1), 1, 0, 2);
    expect_implicit_contacts(ring, SC::Implicit_surface_3(q + z * z == 16), 1, 0, 2);
    if (k == 0) {
      expect_implicit_contacts(ring, SC::Implicit_surface_3(q == 4), 1, 0, 2);
      expect_implicit_contacts(SC::Implicit_surface_3(z == pow(q - 1, 3)), SC::Implicit_surface_3(z == 0), 1, 0, 3);
    }
  }
}

// The contact along a line, and the transversal curves through one of its points.
TEST(Contact_curves, of_quadrics_along_a_line)
{
  for (const int k : {0, 2}) {
    const auto [x, y, z] = turned_coordinates(k);
    const auto expect = [&, turned = k != 0](const SC::Constraint& a, const SC::Constraint& b, std::size_t curves,
                                             std::size_t contacts, double height) {
      const auto set = SC::intersection_curves(SC::Implicit_surface_3(a), SC::Implicit_surface_3(b));
      EXPECT_TRUE(set.is_complete()) << set;
      EXPECT_EQ(set.curves().size(), curves);
      EXPECT_EQ(set.number_of_closed_curves(), 0u);
      EXPECT_EQ(set.number_of_contact_curves(), contacts);
      ASSERT_EQ(set.singular_points().size(), 1u);
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(set.singular_points()[0].point(),
                                                   CGAL::Point_3<CGAL::Simple_cartesian<double>>(0, 0, 0))),
                  std::abs(height), 1e-10);
      for (const SC::Intersection_curve& curve : set.curves())
        for (const auto& p : set.polyline(curve, 1e-1)) {
          EXPECT_TRUE(turned || curve.multiplicity == 1 || std::hypot(p.x(), p.y()) < 1e-10) << p;
          EXPECT_TRUE(turned || curve.multiplicity == 2 || p.z() <= height + 1e-10 || height > -1) << p;
        }
    };
    const SC::Constraint cylinder = square(x - 1) + y * y == 1, cone = x * (z + 4) == y * y;
    expect(cylinder, 2 * x * (z + 4) == y * y, 3, 2, -3);            // and a conic
    expect(cone, 2 * x * (3 - z) == y * y, 4, 2, 2.0 / 3);           // a parabola
    expect(x * z == y * y, 4 * x * z + x * (x - z) == 4 * y * y, 6, 2, 0);   // two lines, through the vertex of both
    expect(cylinder, x * (y + z) == 0, 3, 2, 0);                     // two planes
  }
}

// A contact along a circle, which a transversal line crosses: two arcs, and three parts of the line.
TEST(Contact_curves, of_implicit_surfaces_that_cross_as_well)
{
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, Rational(33, 16)}, {-2, 2});
  const SC::Expression circle = x * x + y * y - 1;
  const auto set = SC::intersection_curves(SC::Implicit_surface_3(z == 0),
                                           SC::Implicit_surface_3(z == circle * circle * (x - Rational(3, 5))));
  EXPECT_TRUE(set.is_complete()) << set;
  EXPECT_EQ(set.singular_points().size(), 2u);
  EXPECT_EQ(set.curves().size(), 5u);
  EXPECT_EQ(set.number_of_contact_curves(), 2u);
}

// A plane that touches a parabolic cylinder of random pieces in its vertex line, and crosses it elsewhere.
TEST(Contact_curves, random_cubic_cylinders)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> place(1, 9);
  for (int round = 0; round < 8; ++round) {
    const Rational a(place(random), 10), b(place(random), 7);   // z = (x - a)^2 (x - b - 1/70)
    const auto height = [&](const Rational& x) { return Rational((x - a) * (x - a) * (x - b - Rational(1, 70))); };
    const Polynomial x = Polynomial::variable(0);
    const Polynomial z = pow(x - Polynomial(a), 2) * (x - Polynomial(Rational(b + Rational(1, 70))));
    std::vector<Point> points;
    for (int i = 0; i <= 3; ++i)   // blossoms of z
      for (const int y : {0, 1}) {
        const Rational z0 = height(0), z1 = height(Rational(1)), d0 = z.derivative(0)(std::array{Rational(0)}),
                       d1 = z.derivative(0)(std::array{Rational(1)});
        points.emplace_back(Rational(i, 3), y,
                            i == 0       ? z0
                                : i == 1 ? Rational(z0 + d0 / 3)
                                : i == 2 ? Rational(z1 - d1 / 3)
                                         : z1);
      }
    const Surface surface =
        Surface({3, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 1, 1}, points).with_knot(0, Rational(1, 2));
    const bool crosses = b + Rational(1, 70) < 1;
    const Intersection set = expect_curves(surface, K::Plane_3(0, 0, 1, 0), 0, crosses ? 2 : 1, 1);
    for (const SC::Intersection_curve& curve : set.curves())
      for (const Point& p : set.polyline(curve, 1e-2))
        EXPECT_NEAR(number(p.x()), number(curve.multiplicity == 2 ? a : Rational(b + Rational(1, 70))), 1e-10);
  }
}

} // namespace contact_curves
