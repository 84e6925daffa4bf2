// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of intersection of two surfaces: known sections of quadrics and tori, height fields, contacts, seams, small
// loops, rigid motions, random height fields against an independent count.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace intersection_curves_test {

using Intersection = SC::Surface_intersection<K>;

static_assert(!SC::internal::Intersections::Surface_pair<K::Plane_3, K::Plane_3>);
static_assert(!SC::internal::Intersections::Surface_pair<K::Plane_3, CGAL::Simple_cartesian<double>::Sphere_3>);
static_assert(SC::internal::Intersections::Surface_pair<K::Plane_3, SC::Implicit_surface_3>);
static_assert(
    std::same_as<decltype(SC::intersection_curves(std::declval<SC::Implicit_surface_3>(), std::declval<K::Plane_3>())),
                 Intersection>);

namespace {

double distance(const Point& p, const Point& q) { return std::sqrt(CGAL::to_double(CGAL::squared_distance(p, q))); }

// How far a sample is from a surface: from the point with its parameters, or by the equation.
double error_on(const Surface& surface, const SC::Intersection_sample<K>& sample, std::size_t index)
{
  const auto& [u, v] = sample.parameters[index].value();
  const auto within = [&](double t, int axis) {
    return (std::min)((std::max)(Rational(t), surface.domain(axis).first), surface.domain(axis).second);
  };
  return distance(sample.point, surface(within(u, 0), within(v, 1)));
}

double error_on(const K::Plane_3& plane, const SC::Intersection_sample<K>& sample, std::size_t)
{
  return std::sqrt(CGAL::to_double(CGAL::squared_distance(plane, sample.point)));
}

double error_on(const K::Sphere_3& sphere, const SC::Intersection_sample<K>& sample, std::size_t)
{
  return std::abs(distance(sample.point, sphere.center()) - std::sqrt(CGAL::to_double(sphere.squared_radius())));
}

double error_on(const SC::Implicit_surface_3& surface, const SC::Intersection_sample<K>& sample, std::size_t)
{
  const Point& p = sample.point;
  return std::abs(CGAL::to_double(surface(std::array{p.x(), p.y(), p.z()})));
}

// What holds of every answer: samples are on both surfaces, arcs follow each other, closed curves return to their
// begin, open ones end at special points.
template <class A, class B>
void check_curves(const A& a, const B& b, const Intersection& set)
{
  constexpr double tiny = 1e-10;
  for (const SC::Intersection_curve& curve : set.curves()) {
    ASSERT_FALSE(curve.arcs.empty());
    std::vector<std::array<Point, 2>> ends;
    for (const SC::Intersection_arc& arc : curve.arcs) {
      const auto samples = set.samples(arc, 1e-2);
      ASSERT_GE(samples.size(), 2u);
      ends.push_back({samples.front().point, samples.back().point});
      for (std::size_t i = 0; i < samples.size(); i += 7) {
        EXPECT_LT(error_on(a, samples[i], 0), tiny);
        EXPECT_LT(error_on(b, samples[i], 1), tiny);
      }
    }
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      EXPECT_LT(distance(ends[i][1], ends[i + 1][0]), tiny);
    EXPECT_TRUE(!curve.is_closed || distance(ends.back()[1], ends.front()[0]) < tiny);
    for (const int side : {0, 1}) {
      const auto end = set.end(curve, side);
      EXPECT_EQ(end.kind() == SC::Intersection_kind::TRANSVERSAL, curve.is_closed);
      EXPECT_LT(distance(end.point(), side == 0 || curve.is_closed ? ends.front()[0] : ends.back()[1]), tiny);
    }
  }
}

template <class A, class B>
Intersection expect_curves(const A& a, const B& b, std::size_t closed, std::size_t open, std::size_t singular = 0,
                           const std::string& what = "", std::size_t points = 0)
{
  Intersection set = SC::intersection_curves(a, b);
  EXPECT_TRUE(set.is_complete()) << what;
  EXPECT_EQ(set.number_of_closed_curves(), closed) << what;
  EXPECT_EQ(set.number_of_open_curves(), open) << what;
  EXPECT_EQ(set.singular_points().size(), singular) << what;
  EXPECT_EQ(set.points().size(), points) << what;
  EXPECT_TRUE(set.undecided().empty()) << what;
  check_curves(a, b, set);
  return set;
}

double length(const std::vector<Point>& points)
{
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    sum += distance(points[i], points[i + 1]);
  return sum;
}

// A curve that is a circle of this radius: inscribed polygons are shorter, by less than the error allows.
void expect_circle(const Intersection& set, std::size_t curve, double radius)
{
  constexpr double error = 1e-4, pi = 3.14159265358979324;
  const std::vector<Point> points = set.polyline(set.curves()[curve], error);
  EXPECT_EQ(points.front(), points.back());
  EXPECT_LT(length(points), 2 * pi * radius * (1 + 1e-12));
  EXPECT_GT(length(points), 2 * pi * radius * (1 - error / radius));
}

Surface bezier_surface(int degree, const std::vector<Point>& points)
{
  std::vector<Rational> knots(static_cast<std::size_t>(degree) + 1, Rational(0));
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, Rational(1));
  return Surface({degree, degree}, knots, knots, points);
}

// Heights over a square grid of control points, which are those of a polynomial with x and y as parameters.
template <class Height>
Surface height_field(int degree, const Height& height)
{
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      points.emplace_back(i, j, height(i, j));
  return bezier_surface(degree, points);
}

constexpr int humps[] = {-1, 5, -5, 1};
constexpr int rough[4][4] = {{1, 3, 9, -2}, {2, -1, -4, 8}, {-6, -9, 6, -7}, {4, -7, 4, 8}};

int hump(int i, int j) { return 10 * (humps[i] + humps[j]); }
int rough_hump(int i, int j) { return hump(i, j) + rough[i][j]; }
int rough_plane(int i, int j) { return 19 + rough[i][j]; }

// Rational rotations about two axes, and a translation.
K::Aff_transformation_3 motion(int k)
{
  const Rational m(k), n(k + 1), square(m * m + n * n), c((n * n - m * m) / square), s(2 * m * n / square);
  const K::Aff_transformation_3 about_z(c, -s, 0, 1, s, c, 0, -2, 0, 0, 1, Rational(1, 3)),
      about_x(1, 0, 0, 0, 0, c, -s, 0, 0, s, c, k);
  return about_x * about_z;
}

const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);

// Around the axis through (c, 0) along z; its seam is in no plane of symmetry.
Surface upright_cylinder(const Rational& c, const Rational& half_height = 3)
{
  return SC::cylinder_surface<K>(Point(c, 0, -half_height), Vector(0, 0, 2 * half_height),
                                 Point(c + Rational(3, 5), Rational(4, 5), -half_height));
}

} // namespace

TEST(Intersection_curves, plane_and_sphere)
{
  const K::Sphere_3 sphere(Point(0, 0, 0), 9);
  const K::Plane_3 plane(1, 2, 2, -5);
  const double radius = std::sqrt(9 - 25.0 / 9);
  const Intersection implicit = expect_curves(plane, sphere, 1, 0);
  expect_circle(implicit, 0, radius);
  EXPECT_FALSE(implicit.end(implicit.curves()[0], 0).has_parameters(0));
  const Surface surface = SC::sphere_surface<K>(Point(0, 0, 0), 3);
  expect_circle(expect_curves(plane, surface, 1, 0), 0, radius);
  expect_circle(expect_curves(surface, plane, 1, 0), 0, radius);
  expect_curves(K::Plane_3(1, 2, 2, -10), sphere, 0, 0);
  expect_curves(sphere, K::Sphere_3(Point(7, 0, 0), 9), 0, 0);
  // in the plane at distance 1
  expect_circle(expect_curves(sphere, K::Sphere_3(Point(1, 2, 2), 12), 1, 0), 0, std::sqrt(8.0));

  for (const K::Plane_3& touching : {K::Plane_3(2, 1, 2, -9), K::Plane_3(-2, 2, 1, -9)}) {
    const Intersection contact = expect_curves(surface, touching, 0, 0, 1);
    EXPECT_EQ(contact.singular_points()[0].kind(), SC::Intersection_kind::TANGENT);
    EXPECT_LT(distance(contact.singular_points()[0].point(), touching.projection(Point(0, 0, 0))), 1e-10);
  }
}

TEST(Intersection_curves, curvature_in_space)
{
  const Surface surface = SC::sphere_surface<K>(Point(0, 0, 0), 3);
  const Intersection section = expect_curves(surface, K::Plane_3(1, 2, 2, -5), 1, 0);
  const SC::Spline_map<2, 3> map(surface);
  auto [u, v] = SC::unknowns({map.domain(0).first, map.domain(0).second}, {map.domain(1).first, map.domain(1).second});
  for (const SC::Curve_vertex& vertex : section.solutions().vertices()) {
    const auto at = SC::curve_differentials(section.system(), vertex);
    ASSERT_TRUE(at);
    const SC::Mpfr_interval curvature = at->image(map(u, v)).squared_curvature();
    EXPECT_LE(curvature.lower(), Rational(9, 56));   // of the circle with the radius sqrt(9 - 25/9)
    EXPECT_GE(curvature.upper(), Rational(9, 56));
    EXPECT_LT(Rational(curvature.upper() - curvature.lower()), Rational(1, 1000000));
  }
}

TEST(Intersection_curves, sphere_and_cylinder)
{
  const K::Sphere_3 sphere(Point(0, 0, 0), 4);
  expect_curves(sphere, upright_cylinder(Rational(1, 2)), 2, 0);
  expect_curves(sphere, upright_cylinder(2), 1, 0);
  expect_curves(sphere, upright_cylinder(4), 0, 0);
  const Intersection figure_eight = expect_curves(sphere, upright_cylinder(1), 0, 2, 1);   // Viviani's curve
  EXPECT_LT(distance(figure_eight.singular_points()[0].point(), Point(2, 0, 0)), 1e-10);
  for (const SC::Intersection_curve& loop : figure_eight.curves())
    for (const int side : {0, 1})
      EXPECT_EQ(figure_eight.end(loop, side).kind(), SC::Intersection_kind::TANGENT);

  // The upper rim cuts one loop into an arc.
  const Surface cut = upright_cylinder(2, 1);
  const Intersection arcs = expect_curves(cut, sphere, 0, 2);
  for (const SC::Intersection_curve& arc : arcs.curves())
    for (const int side : {0, 1}) {
      const auto end = arcs.end(arc, side);
      EXPECT_EQ(end.kind(), SC::Intersection_kind::END_POINT);
      EXPECT_TRUE(end.is_at_end(0, 1));
      EXPECT_FALSE(end.is_at_end(0, 0));
      EXPECT_EQ(CGAL::abs(end.point().z()), 1);
    }
}

TEST(Intersection_curves, two_cylinders)
{
  const Surface first = upright_cylinder(0, 2);
  const auto lying = [](const Point& source) {
    return SC::cylinder_surface<K>(Point(-2, 0, 0), Vector(4, 0, 0), source);
  };
  expect_curves(first, lying(Point(-2, Rational(3, 10), Rational(4, 10))), 2, 0);
  const Intersection ellipses = expect_curves(first, lying(Point(-2, Rational(5, 13), Rational(12, 13))), 0, 4, 2);
  for (const auto& crossing : ellipses.singular_points())
    EXPECT_LT(distance(crossing.point(), Point(0, crossing.point().y() > 0 ? 1 : -1, 0)), 1e-10);
}

TEST(Intersection_curves, sections_of_a_torus)
{
  expect_curves(torus, K::Plane_3(0, 0, 1, -2), 0, 0);
  const Intersection rings = expect_curves(torus, K::Plane_3(0, 0, 5, -3), 2, 0);   // height 3/5: radii 3 +- 4/5
  const std::size_t outer = distance(rings.end(rings.curves()[0], 0).point(), Point(0, 0, Rational(3, 5))) > 3 ? 0 : 1;
  expect_circle(rings, outer, 3.8);
  expect_circle(rings, 1 - outer, 2.2);
  expect_curves(torus, K::Plane_3(1, 2, 0, -1), 2, 0);
  expect_curves(torus, K::Plane_3(3, 4, 0, Rational(-25, 2)), 1, 0);
  // A plane that touches the torus twice cuts it in two circles of the radius 5, through each other (Villarceau).
  const Surface thick = SC::torus_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 4, 0), Rational(3, 5));
  const Intersection circles = expect_curves(thick, K::Plane_3(3, 0, -4, 0), 0, 4, 2);
  double total = 0;
  for (const SC::Intersection_curve& arc : circles.curves())
    total += length(circles.polyline(arc, 1e-4));
  EXPECT_NEAR(total, 2 * 2 * 3.14159265358979324 * 5, 2e-3);
}

TEST(Intersection_curves, rigid_motions_change_nothing)
{
  const K::Plane_3 plane(1, 2, 0, -1);
  const K::Sphere_3 sphere(Point(3, 0, Rational(1, 2)), 3);
  const std::size_t closed = expect_curves(torus, sphere, 2, 0).number_of_closed_curves();
  for (int k = 1; k <= 4; ++k) {
    const K::Aff_transformation_3 moved = motion(k);
    const Surface surface = torus.transformed(moved);
    expect_curves(surface, plane.transform(moved), 2, 0, 0, std::to_string(k));
    expect_curves(surface, sphere.orthogonal_transform(moved), closed, 0, 0, std::to_string(k));
  }
}

TEST(Intersection_curves, height_fields)
{
  const Surface a = height_field(3, rough_hump), b = height_field(3, rough_plane);
  const Intersection set = expect_curves(a, b, 1, 3);
  EXPECT_EQ(set.solutions().vertices()[0].box.size(), 2u);
  expect_curves(height_field(3, hump), K::Plane_3(0, 0, 1, -19), 1, 3);
  // The second one with other parameters, beyond the first one, and in pieces.
  expect_curves(a, b.transposed().reversed(0), 1, 3);
  expect_curves(
      a, Surface({3, 3}, {2, 2, 2, 2, 6, 6, 6, 6}, {-1, -1, -1, -1, 0, 0, 0, 0}, b.control_points()).with_knot(0, 3), 1,
      3);
  const Surface plane = SC::bilinear_surface<K>(Point(-1, -2, 19), Point(-1, 5, 19), Point(4, -2, 19), Point(4, 5, 19));
  expect_curves(height_field(3, hump), plane, 1, 3);
  expect_curves(plane, height_field(3, hump), 1, 3);
  // Turned they are height fields no more: four unknowns.
  const Surface turned = a.transformed(motion(2));
  const Intersection general = expect_curves(turned, b.transformed(motion(2)), 1, 3);
  EXPECT_EQ(general.solutions().vertices()[0].box.size(), 4u);
}

TEST(Intersection_curves, cones_triangles_and_touching_spheres)
{
  const Surface cone = SC::cone_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(1, 0, 2));
  expect_curves(cone, K::Plane_3(1, 2, -1, 1), 0, 1);
  expect_curves(cone, K::Sphere_3(Point(0, 0, 1), Rational(1, 2)), 2, 0);
  const K::Triangle_3 first(Point(0, 0, 0), Point(4, 0, 1), Point(0, 4, 0)),
      second(Point(1, 1, -1), Point(1, 1, 3), Point(2, 3, 1));
  const Intersection segment = SC::intersection_curves(first, second);
  EXPECT_TRUE(segment.is_complete());
  ASSERT_EQ(segment.number_of_open_curves(), 1u);
  EXPECT_EQ(segment.number_of_closed_curves(), 0u);
  for (const int side : {0, 1})
    EXPECT_EQ(segment.end(segment.curves()[0], side).kind(), SC::Intersection_kind::END_POINT);
  const K::Sphere_3 sphere(Point(0, 0, 0), 9);
  // from outside, around it
  for (const K::Sphere_3& other : {K::Sphere_3(Point(4, 2, 4), 9), K::Sphere_3(Point(2, 1, 2), 36)})
    EXPECT_LT(distance(expect_curves(sphere, other, 0, 0, 1).singular_points()[0].point(), Point(0, 0, 0)), 3 + 1e-10);
}

// A cone, whose radius is 6 - z/3, and a wall x = 4 above z = 6: the branch of a hyperbola in which their planes meet
// ends there.
TEST(Intersection_curves, a_point_on_the_edge)
{
  const Surface cone = SC::cone_surface<K>(Point(0, 0, 18), Vector(0, 0, -1), Point(6, 0, 0));
  const Surface wall = SC::plane_patch<K>(Point(4, -5, 6), Vector(0, 10, 0), Vector(0, 0, 6));
  auto [x, y, z] = SC::unknowns({-6, 6}, {-6, 6}, {0, 17});
  const SC::Implicit_surface_3 quadric(9 * (x * x + y * y) == square(18 - z));
  const auto expect_point = [](const Intersection& set) {
    ASSERT_EQ(set.points().size(), 1u);
    EXPECT_EQ(set.points()[0].kind(), SC::Intersection_kind::END_POINT);
    EXPECT_LT(distance(set.points()[0].point(), Point(4, 0, 6)), 1e-12);
    std::ostringstream line;
    line << set;
    EXPECT_TRUE(
        line.str().starts_with("curves: 0 closed, 0 open, 1 points, 0 singular points, 0 undecided; complete: yes"))
        << line.str();
  };
  expect_point(expect_curves(cone, wall, 0, 0, 0, "cone and wall", 1));
  expect_point(expect_curves(wall, cone, 0, 0, 0, "wall and cone", 1));
  expect_point(expect_curves(quadric, wall, 0, 0, 0, "quadric and wall", 1));
}

TEST(Intersection_curves, small_loops)
{
  // z = (u - 1/3)^2 + (v - 2/7)^2 as a biquadratic patch, and a plane just above its lowest point.
  const auto part = [](const Rational& c, int i) {
    return i == 0 ? Rational(c * c) : i == 1 ? Rational(c * c - c) : Rational((1 - c) * (1 - c));
  };
  const Surface bowl =
      height_field(2, [&](int i, int j) { return Rational(part(Rational(1, 3), i) + part(Rational(2, 7), j)); });
  for (const Rational& radius : {Rational(1, 200), Rational(1, 2000)})
    expect_curves(bowl, K::Plane_3(0, 0, 1, -radius * radius), 1, 0);
}

TEST(Intersection_curves, random_height_fields)
{
  std::mt19937 generator(17);
  std::uniform_int_distribution<int> height(-100, 100);
  for (int round = 0; round < 40; ++round) {
    std::array<std::array<int, 4>, 4> first, second;
    for (int i = 0; i < 16; ++i) {
      first[i / 4][i % 4] = height(generator);
      second[i / 4][i % 4] = height(generator);
    }
    const Surface a = height_field(3, [&](int i, int j) { return first[i][j]; }),
                  b = height_field(3, [&](int i, int j) { return second[i][j]; });
    const Intersection set = SC::intersection_curves(a, b);
    ASSERT_TRUE(set.is_complete());
    check_curves(a, b, set);
    // Each curve divides the square, so there is one curve less than regions of one sign. These are counted on a grid.
    constexpr int n = 192;
    std::vector<int> sign, region;
    const auto bernstein = [](int i, double t) {
      return (i % 3 == 0 ? 1 : 3) * std::pow(t, i) * std::pow(1 - t, 3 - i);
    };
    for (int k = 0; k < n * n; ++k) {
      double sum = 0;
      for (int i = 0; i < 16; ++i)
        sum += (first[i / 4][i % 4] - second[i / 4][i % 4]) * bernstein(i / 4, (k / n) / (n - 1.0)) *
            bernstein(i % 4, (k % n) / (n - 1.0));
      sign.push_back(sum > 0 ? 1 : -1);
    }
    region.assign(n * n, -1);
    std::size_t regions = 0;
    for (int start = 0; start < n * n; ++start) {
      if (region[start] >= 0)
        continue;
      std::vector<int> front{start};
      region[start] = static_cast<int>(regions++);
      while (!front.empty()) {
        const int k = front.back();
        front.pop_back();
        for (const auto& [next, is_inside] : {std::pair(k - n, k >= n), std::pair(k + n, k + n < n * n),
                                              std::pair(k - 1, k % n > 0), std::pair(k + 1, k % n < n - 1)})
          if (is_inside && region[next] < 0 && sign[next] == sign[start]) {
            region[next] = region[start];
            front.push_back(next);
          }
      }
    }
    EXPECT_EQ(set.curves().size() + 1, regions) << round;
    int ends = 0;
    for (int k = 0; k + 1 < n; ++k)
      for (const auto& [i, j] : {std::pair(k, k + 1), std::pair((n - 1) * n + k, (n - 1) * n + k + 1),
                                 std::pair(k * n, (k + 1) * n), std::pair(k * n + n - 1, (k + 1) * n + n - 1)})
        ends += sign[i] != sign[j];
    EXPECT_EQ(2 * set.number_of_open_curves(), static_cast<std::size_t>(ends)) << round;
  }
}

TEST(Intersection_curves, implicit_surfaces)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {0, 3});
  const SC::Implicit_surface_3 dome(x * x + y * y + z * z == 4);   // ends at z = 0
  expect_curves(dome, K::Plane_3(1, 0, 0, -1), 0, 1);
  expect_curves(dome, K::Sphere_3(Point(0, 0, 3), 4), 1, 0);
  expect_curves(dome, upright_cylinder(2), 0, 1);
  const Intersection both = expect_curves(upright_cylinder(Rational(1, 2)), dome, 1, 0);
  EXPECT_EQ(both.solutions().vertices()[0].box.size(), 5u);
  auto [u, v, w] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto implicit = SC::intersection_curves(SC::Implicit_surface_3(u * u + v * v + w * w == 4),
                                                SC::Implicit_surface_3(square(u - 1) + v * v == 1));
  EXPECT_TRUE(implicit.is_complete());
  EXPECT_EQ(implicit.singular_points().size(), 1u);
  EXPECT_EQ(implicit.curves().size(), 2u);
}

// A parabolic cylinder touches a plane along a line.
TEST(Intersection_curves, contact_along_a_curve)
{
  const Surface cylinder = height_field(2, [](int i, int) { return i == 1 ? -1 : 1; });   // 4 (u - 1/2)^2
  const Intersection set = SC::intersection_curves(cylinder, K::Plane_3(0, 0, 1, 0));
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_open_curves(), 1u);
  ASSERT_EQ(set.curves().size(), 1u);
  const auto points = set.polyline(set.curves()[0], 1e-3);
  EXPECT_GE(points.size(), 3u);
  for (const Point& p : points)
    EXPECT_NEAR(CGAL::to_double(p.x()), 0.5 * CGAL::to_double(points.front().x() + points.back().x()), 1e-12);
}

// z = x y meets the plane z = 0 in two edges, and the plane x = 0 in one.
TEST(Intersection_curves, curves_along_edges)
{
  const Surface saddle({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                       std::vector<Point>{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}});
  const Intersection axes = SC::intersection_curves(saddle, K::Plane_3(0, 0, 1, 0));
  EXPECT_TRUE(axes.is_complete());
  EXPECT_EQ(axes.number_of_open_curves(), 2u);
  EXPECT_EQ(axes.curves().size(), 2u);
  EXPECT_EQ(axes.singular_points().size(), 1u);
  for (const SC::Intersection_curve& curve : axes.curves())
    for (const Point& p : axes.polyline(curve, 1e-3))
      EXPECT_TRUE(p.z() == 0 && p.x() * p.y() == 0);
  const Intersection side = SC::intersection_curves(saddle, K::Plane_3(1, 0, 0, 0));
  EXPECT_TRUE(side.is_complete());
  EXPECT_EQ(side.number_of_open_curves(), 1u);
}

TEST(Intersection_curves, what_is_not_proved_is_undecided)
{
  const Surface a = height_field(3, rough_hump);
  const Intersection same = SC::intersection_curves(a, a, {.tolerance = 1e-2});
  EXPECT_FALSE(same.is_complete());
  ASSERT_FALSE(same.undecided().empty());
  EXPECT_EQ(same.undecided_points()[0].kind(), SC::Intersection_kind::UNDECIDED);
  const SC::Undecided_part part = same.undecided()[0];
  ASSERT_EQ(part.place.size(), 3u);
  ASSERT_EQ(part.parameters.size(), 2u);
  for (const std::size_t operand : {0, 1}) {
    EXPECT_EQ(part.parameters[operand].operand, operand);
    EXPECT_EQ(part.parameters[operand].ranges.size(), 2u);
  }
  EXPECT_FALSE(part.reason.empty());
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  // they touch along the axis of y, and have a hyperbola in common, one branch of which crosses it
  const SC::Implicit_surface_3 cone(z * z == x * y), other(z * z == x * x + x);
  const auto along_line = SC::intersection_curves(cone, other);
  EXPECT_TRUE(along_line.is_complete());
  EXPECT_EQ(along_line.number_of_contact_curves(), 2u);
  EXPECT_EQ(along_line.number_of_open_curves(), 5u);
  ASSERT_EQ(along_line.singular_points().size(), 1u);
  EXPECT_NEAR(along_line.singular_points()[0].point().y(), 1, 1e-12);
  const auto along_circle =
      SC::intersection_curves(SC::Implicit_surface_3(x * x + y * y == 1), K::Sphere_3(Point(0, 0, 0), 1));
  EXPECT_TRUE(along_circle.is_complete());
  EXPECT_EQ(along_circle.number_of_contact_curves(), 1u);
}

TEST(Intersection_curves, bad_input)
{
  const Surface a = height_field(3, hump);
  EXPECT_THROW(SC::intersection_curves(a, K::Plane_3(0, 0, 0, 1)), SC::Invalid_input);
  EXPECT_THROW(SC::intersection_curves(a, K::Sphere_3(Point(0, 0, 0), 0)), SC::Invalid_input);
  EXPECT_THROW(SC::intersection_curves(a, a, {.tolerance = -1}), SC::Invalid_input);
  const Intersection set = SC::intersection_curves(a, K::Plane_3(0, 0, 1, -19));
  EXPECT_THROW(set.polyline(set.curves()[0], 0), SC::Invalid_input);
}

} // namespace intersection_curves_test
