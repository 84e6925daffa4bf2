// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closed forms beside the general way: both find the same common points of random operands, of the same kinds, with
// ranges that meet, and neither finds more.

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace elementary_intersections {

namespace SC = CGAL::Spline_constraints;
namespace Internal = SC::internal::Intersections;
using K = CGAL::Simple_cartesian<double>;
using Kind = SC::Intersection_kind;

// What was found in all comparisons of a test, so that none passes with empty answers, and how often by closed forms.
struct Tally
{
  std::size_t pairs = 0, decided = 0, points = 0, tangent = 0, at_end = 0;
};

// How far two answers are apart, in space and in the parameters.
template <class Answer>
double apart(const Answer& x, const Answer& y, const std::array<int, 2>& axes)
{
  double result = CGAL::squared_distance(x.point(), y.point());
  for (const std::size_t operand : {0, 1})
    for (std::size_t k = 0; k < static_cast<std::size_t>(axes[operand]); ++k)
      result += std::abs(x.parameter(operand, k) - y.parameter(operand, k));
  return result;
}

// Compares answers with those of the general way.
template <class A, class B, class Found>
void compare_answers(const A& a, const B& b, const Found& answers, Tally& tally)
{
  using Operand = SC::internal::Common::Intersection_operand<A>;
  constexpr int d = Operand::dimension;
  const auto expected =
      Internal::general_intersections<K, d>(a, b, Internal::Budgeted_solver(SC::Solver_options{}));
  ASSERT_TRUE(expected.is_complete());
  EXPECT_TRUE(answers.is_complete());
  ASSERT_EQ(answers.size(), expected.size());
  const std::array<int, 2> axes{Operand::number_of_parameters,
                                SC::internal::Common::Intersection_operand<B>::number_of_parameters};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    // where two have nearly the same first parameter, their order is not the same
    const auto& found = answers[i];
    const auto& other = *std::min_element(expected.begin(), expected.end(), [&](const auto& x, const auto& y) {
      return apart(found, x, axes) < apart(found, y, axes);
    });
    EXPECT_EQ(found.kind(), other.kind()) << found.kind() << " and " << other.kind();
    if (other.multiplicity() != 0) {
      EXPECT_EQ(found.multiplicity(), other.multiplicity());
    }
    EXPECT_EQ(found.passage(), other.passage());
    for (const std::size_t operand : {0, 1}) {
      EXPECT_EQ(found.is_at_end(operand), other.is_at_end(operand));
      for (int axis = 0; axis < axes[operand]; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        EXPECT_EQ(found.is_at_end(operand, k), other.is_at_end(operand, k));
        const auto x = found.parameter_range(operand, k), y = other.parameter_range(operand, k);
        EXPECT_LE(x.first, x.second);
        EXPECT_LE(x.first, y.second) << found.parameter(operand, k) << " and " << other.parameter(operand, k);
        EXPECT_LE(y.first, x.second) << found.parameter(operand, k) << " and " << other.parameter(operand, k);
        EXPECT_NEAR(found.parameter(operand, k), other.parameter(operand, k),
                    1e-6 * (1 + std::abs(other.parameter(operand, k))));
      }
    }
    EXPECT_LT(std::sqrt(CGAL::squared_distance(found.point(), other.point())), 1e-6);
    ++tally.points;
    tally.tangent += found.kind() == Kind::TANGENT;
    tally.at_end += found.is_at_end(0) || found.is_at_end(1);
  }
}

// The closed forms, if there are some.
template <class A, class B>
void compare(const A& a, const B& b, Tally& tally)
{
  constexpr int d = SC::internal::Common::Intersection_operand<A>::dimension;
  ++tally.pairs;
  const auto elementary = Internal::elementary_intersections<K>(
      Internal::elementary_operand<d>(a), Internal::elementary_operand<d>(b), SC::Solver_options{});
  if (!elementary)
    return;
  ++tally.decided;
  compare_answers(a, b, *elementary, tally);
}

// Each as the first operand.
template <class A, class B>
void compare_both(const A& a, const B& b, Tally& tally)
{
  compare(a, b, tally);
  compare(b, a, tally);
}

class Random
{
  std::mt19937 m_engine;

public:
  explicit Random(unsigned seed) : m_engine(seed) {}

  double integer(int least, int greatest) { return std::uniform_int_distribution<int>(least, greatest)(m_engine); }
  double number(double least, double greatest)
  {
    return std::uniform_real_distribution<double>(least, greatest)(m_engine);
  }
  K::Point_2 point_2(int size) { return {integer(-size, size), integer(-size, size)}; }
  K::Point_3 point_3(int size) { return {integer(-size, size), integer(-size, size), integer(-size, size)}; }

  // A sphere that is an exact surface in doubles, too: its radius is an integer.
  K::Sphere_3 sphere(int size, CGAL::Orientation orientation = CGAL::COUNTERCLOCKWISE)
  {
    const double radius = integer(1, size);
    return {point_3(size), radius * radius, orientation};
  }
  K::Circle_2 circle(int size)
  {
    const double radius = integer(1, size);
    return {point_2(size), radius * radius, integer(0, 1) == 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE};
  }
};

TEST(Elementary_intersections, lines_and_spheres)
{
  Random random(1);
  Tally tally;
  for (int i = 0; i < 100; ++i) {
    const auto sphere = random.sphere(3, i % 2 == 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
    const K::Point_3 p = random.point_3(4);
    K::Point_3 q = random.point_3(4);
    if (p == q)
      q = q + K::Vector_3(1, 2, 3);
    if (p.z() == q.z() && CGAL::square(p.z() - sphere.center().z()) == sphere.squared_radius())
      continue;   // in the tangent plane of a pole: the general way reports a contact there several times
    compare_both(K::Line_3(p, q), sphere, tally);
    compare(K::Ray_3(p, q), sphere, tally);
    compare(K::Segment_3(p, q), sphere, tally);
  }
  EXPECT_GT(tally.decided, 380u);
  EXPECT_GT(tally.points, 100u);
  EXPECT_GT(tally.at_end, 3u);
}

TEST(Elementary_intersections, lines_that_touch_spheres)
{
  // by points of them with integer coordinates, and nearly
  const std::vector<std::array<double, 3>> arms{{1, 2, 2}, {2, -1, 2}, {-2, -2, -1}, {0, -3, 0}, {3, 0, 0}};
  Tally tally;
  for (const auto& [x, y, z] : arms)
    for (const K::Vector_3& v : {K::Vector_3(-y, x, 0), K::Vector_3(y * z + 1, -x * z, 0)}) {
      const K::Vector_3 arm(x, y, z), tangent = v - arm * ((v * arm) / 9) * 9 / 9;
      const K::Vector_3 direction = CGAL::cross_product(arm, v);
      if (direction == CGAL::NULL_VECTOR || tangent == CGAL::NULL_VECTOR)
        continue;
      const K::Point_3 center(1, -2, 3);
      const K::Sphere_3 sphere(center, 9);
      for (const double factor : {1.0, 1 + 0x1p-40, 1 - 0x1p-40}) {
        const K::Point_3 p = center + factor * arm - direction, q = center + factor * arm + 2 * direction;
        compare_both(K::Line_3(p, q), sphere, tally);
        compare(K::Segment_3(p, q), sphere, tally);
      }
    }
  EXPECT_EQ(tally.decided, tally.pairs);
  EXPECT_GT(tally.tangent, 15u);
}

TEST(Elementary_intersections, lines_through_poles_and_seams)
{
  const K::Point_3 center(1, 2, -1);
  Tally tally;
  for (const CGAL::Orientation orientation : {CGAL::COUNTERCLOCKWISE, CGAL::CLOCKWISE}) {
    const K::Sphere_3 sphere(center, 25, orientation);
    for (const K::Vector_3& arm : {K::Vector_3(0, 0, 5), K::Vector_3(0, 0, -5), K::Vector_3(0, 3, 4),
                                   K::Vector_3(0, 4, -3), K::Vector_3(0, 5, 0), K::Vector_3(0, -3, 4)})
      for (const K::Vector_3& v : {K::Vector_3(1, 2, 3), K::Vector_3(-2, 1, 1), K::Vector_3(0, 1, -1)}) {
        const K::Point_3 p = center + arm;
        compare_both(K::Line_3(p - v, p + 2 * v), sphere, tally);
        compare(K::Segment_3(p, p + v), sphere, tally);
      }
  }
  EXPECT_EQ(tally.decided, tally.pairs);
  EXPECT_GT(tally.at_end, 100u);
}

TEST(Elementary_intersections, points)
{
  Random random(3);
  Tally tally;
  const K::Sphere_3 sphere({0, 0, 0}, 25), small({0, 0, 0}, 9);
  for (const K::Point_3& p : {K::Point_3(0, 0, 5), K::Point_3(0, 3, 4), K::Point_3(1, 2, 2.5)})
    compare_both(p, sphere, tally);
  compare_both(K::Point_3(1, 2, 2), small, tally);
  for (int i = 0; i < 20; ++i) {
    const K::Point_2 p = random.point_2(2), q = p + K::Vector_2(random.integer(1, 3), random.integer(-2, 2));
    compare_both(random.point_2(2), K::Segment_2(p, q), tally);
    compare_both(CGAL::midpoint(p, q), K::Segment_2(p, q), tally);
    compare_both(q, K::Segment_2(p, q), tally);
    compare_both(random.point_2(3), K::Circle_2(p, 25), tally);
    compare_both(p + K::Vector_2(3, -4), K::Circle_2(p, 25), tally);
    compare_both(p, K::Line_2(p, q), tally);
  }
  EXPECT_EQ(tally.decided, tally.pairs);
  EXPECT_GT(tally.points, 100u);
}

TEST(Elementary_intersections, lines_of_the_plane)
{
  Random random(4);
  Tally tally;
  for (int i = 0; i < 150; ++i) {
    const K::Point_2 p = random.point_2(3), q = p + K::Vector_2(random.integer(1, 3), random.integer(-2, 2)),
                     r = random.point_2(3), s = r + K::Vector_2(random.integer(-2, 2), random.integer(1, 3));
    compare_both(K::Segment_2(p, q), K::Segment_2(r, s), tally);
    compare_both(K::Line_2(p, q), K::Segment_2(r, s), tally);
    compare_both(K::Ray_2(p, q), K::Segment_2(r, s), tally);
  }
  EXPECT_GT(tally.decided, 850u);
  EXPECT_GT(tally.points, 150u);
  EXPECT_GT(tally.at_end, 60u);
}

TEST(Elementary_intersections, lines_of_space)
{
  Random random(8);
  Tally tally;
  for (int i = 0; i < 150; ++i) {
    const K::Point_3 p = random.point_3(1), q = p + K::Vector_3(random.integer(1, 2), random.integer(-1, 1), 0),
                     r = random.point_3(1), s = r + K::Vector_3(random.integer(-1, 1), 1, random.integer(0, 1));
    compare_both(K::Segment_3(p, q), K::Segment_3(r, s), tally);
    compare_both(K::Line_3(p, q), K::Segment_3(r, s), tally);
    compare_both(K::Ray_3(p, q), K::Segment_3(r, s), tally);
  }
  EXPECT_GT(tally.decided, 850u);
  EXPECT_GT(tally.points, 60u);
  EXPECT_GT(tally.at_end, 30u);
}

TEST(Elementary_intersections, triangles)
{
  Random random(9);
  Tally tally;
  for (int i = 0; i < 100; ++i) {
    const K::Triangle_3 triangle(random.point_3(2), random.point_3(2) + K::Vector_3(5, 0, 0),
                                 random.point_3(2) + K::Vector_3(0, 5, 0));
    const K::Point_3 p = random.point_3(2) + K::Vector_3(1, 1, 0), q = p + K::Vector_3(random.integer(-1, 1), 0, 1);
    const K::Point_3 corner = triangle.vertex(i % 3),
                     middle = CGAL::midpoint(triangle.vertex(i % 3), triangle.vertex((i + 1) % 3));
    compare_both(K::Line_3(p, q), triangle, tally);
    compare(K::Segment_3(p, q), triangle, tally);
    compare(K::Segment_3(corner, q + K::Vector_3(0, 0, 5)), triangle, tally);
    compare(K::Ray_3(q + K::Vector_3(0, 0, 5), middle), triangle, tally);
  }
  EXPECT_GT(tally.decided, 490u);
  EXPECT_GT(tally.points, 200u);
  EXPECT_GT(tally.at_end, 150u);
}

TEST(Elementary_intersections, cylinders_and_cones)
{
  Random random(10);
  Tally tally;
  std::vector<SC::Bspline_surface_3<K>> surfaces{
      SC::cylinder_surface<K>({1, 0, -1}, 2, 3), SC::cylinder_surface<K>({0, 0, 0}, {0, 4, 0}, {2, 1, 0}),
      SC::cone_surface<K>({0, 0, 4}, {0, 0, -1}, {2, 0, 0}), SC::cone_surface<K>({0, -1, 0}, {0, 2, 0}, {0, 2, 2})};
  surfaces.push_back(surfaces[2].restricted(1, 0.25, 0.75).with_domain(1, 0, 1));   // a frustum
  for (int i = 0; i < 150; ++i) {
    const auto& surface = surfaces[static_cast<std::size_t>(i) % surfaces.size()];
    const K::Point_3 p = random.point_3(2), q = p + K::Vector_3(random.integer(-2, 2), random.integer(-2, 2), 3);
    compare_both(K::Line_3(p, q), surface, tally);
    compare(K::Segment_3(p, q), surface, tally);
    const K::Point_3 r(random.number(-3, 3), random.number(-3, 3), random.number(-3, 3));
    compare(K::Line_3(r, p), surface, tally);
    compare(SC::bezier_curve(std::vector<K::Point_3>{r, p + K::Vector_3(1, 0, 0), q}), surface, tally);
  }
  for (const double x : {-2.0, -2 + 0x1p-40, -2 - 0x1p-40})   // on a cylinder, through it and beside it
    compare_both(K::Line_3(K::Point_3(x, -1, 2), K::Point_3(x, 3, 1)), SC::cylinder_surface<K>({0, 0, 0}, 2, 3), tally);
  EXPECT_GT(tally.decided, 600u);
  EXPECT_GT(tally.points, 250u);
  EXPECT_GT(tally.tangent, 1u);
}

TEST(Elementary_intersections, circles)
{
  Random random(5);
  Tally tally;
  for (int i = 0; i < 60; ++i) {
    const auto circle = random.circle(3);
    const K::Point_2 p = random.point_2(4), q = p + K::Vector_2(random.integer(1, 4), random.integer(-2, 2));
    compare_both(K::Line_2(p, q), circle, tally);
    compare(K::Ray_2(p, q), circle, tally);
    compare(K::Segment_2(p, q), circle, tally);
    compare(circle, random.circle(4), tally);
  }
  for (const double x : {2.0, -2.0})   // on the seam and opposite to it
    compare_both(K::Circle_2({0, 0}, 1), K::Circle_2({x, 0}, 1), tally);
  EXPECT_GT(tally.decided, 280u);
  EXPECT_GT(tally.points, 150u);
  EXPECT_GT(tally.tangent, 10u);
  EXPECT_GT(tally.at_end, 10u);
}

TEST(Elementary_intersections, planar_curves)
{
  Random random(6);
  Tally tally;
  for (int i = 0; i < 40; ++i) {
    std::vector<K::Point_2> points;
    const int degree = 2 + i % 4;
    for (int k = 0; k <= degree; ++k)
      points.push_back(K::Point_2(2 * k - degree, random.integer(-3, 3)));
    const auto curve = SC::bezier_curve(points);
    const K::Point_2 p = random.point_2(3), q = p + K::Vector_2(random.integer(1, 4), random.integer(-2, 2));
    compare_both(K::Line_2(p, q), curve, tally);
    compare(curve, K::Segment_2(p, q), tally);
    compare(curve, K::Ray_2(q, p), tally);
    compare(curve, SC::segment_curve<K>(q, p), tally);
    compare(curve, random.circle(3), tally);
    compare(curve, K::Segment_2(points.back(), points.back() + K::Vector_2(1, 2)), tally);
  }
  const auto parabola = SC::bezier_curve(std::vector<K::Point_2>{{-1, 1}, {0, -1}, {1, 1}});
  for (const double height : {0.0, 0x1p-60, -0x1p-60, 1.0})
    compare_both(parabola, SC::segment_curve<K>({-1.5, height}, {1.25, height}), tally);
  EXPECT_GT(tally.decided, 250u);
  EXPECT_GT(tally.points, 100u);
  EXPECT_GT(tally.tangent, 1u);
  EXPECT_GT(tally.at_end, 30u);
}

TEST(Elementary_intersections, curves_of_several_pieces)
{
  Random random(11);
  Tally tally;
  for (int i = 0; i < 30; ++i) {
    const int degree = 1 + i % 4, size = degree + 5;
    std::vector<double> knots;
    for (int k = 0; k <= size + degree; ++k)   // not clamped every other time
      knots.push_back(i % 2 == 0 ? k : (std::min)((std::max)(k, degree), size));
    std::vector<K::Point_2> points;
    for (int k = 0; k < size; ++k)
      points.push_back(K::Point_2(k - 4, random.number(-3, 3)));
    const SC::Bspline_curve_2<K> curve(degree, knots, points);
    const K::Point_2 p = random.point_2(3), q = p + K::Vector_2(random.integer(1, 4), random.integer(-2, 2));
    compare_both(K::Line_2(p, q), curve, tally);
    compare_both(K::Segment_2(p, q), curve, tally);
    compare(curve, random.circle(3), tally);
  }
  EXPECT_GT(tally.decided, 140u);
  EXPECT_GT(tally.points, 80u);
}

TEST(Elementary_intersections, curves_in_space)
{
  Random random(7);
  Tally tally;
  for (int i = 0; i < 25; ++i) {
    std::vector<K::Point_3> points;
    const int degree = 2 + i % 3;
    for (int k = 0; k <= degree; ++k)
      points.push_back(random.point_3(3) + K::Vector_3(2 * k, 0, 0));
    const auto curve = SC::bezier_curve(points);
    const K::Plane_3 plane(random.integer(1, 3), random.integer(-3, 3), random.integer(-3, 3), random.integer(-4, 4));
    compare_both(plane, curve, tally);
    compare(K::Segment_3(points[0], points[1]), plane, tally);
    compare(curve, random.sphere(3), tally);
  }
  EXPECT_GT(tally.decided, 75u);
  EXPECT_GT(tally.points, 30u);
}

TEST(Elementary_intersections, overlaps)
{
  Random random(12);
  Tally tally;
  for (int i = 0; i < 12; ++i) {
    std::vector<K::Point_2> points;
    const int degree = 2 + i % 3;
    for (int k = 0; k <= degree; ++k)
      points.push_back(K::Point_2(k, random.integer(-3, 3)));
    points[1] = points[1] + K::Vector_2(0, 8);   // not of a lower degree
    const auto curve = SC::bezier_curve(points);
    const auto first = curve.restricted(0, 0.75), last = curve.restricted(0.25, 1);
    for (const auto& other : {last, last.reversed(), last.with_domain(0, 1)}) {
      const std::size_t decided = tally.decided;
      compare_both(first, other, tally);
      EXPECT_EQ(tally.decided, decided + 2);
      const auto found = SC::intersections(first, other);
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].kind(), Kind::OVERLAP);
      EXPECT_EQ(found[0].parameter_range(0), (std::pair(SC::Exact_rational(0.25), SC::Exact_rational(0.75))));
    }
    compare(first, curve.restricted(0.75, 1), tally);   // with a common end
  }
  const auto cubic = SC::bezier_curve(std::vector<K::Point_3>{{0, 0, 0}, {1, 2, 3}, {2, -2, 5}, {3, 0, 1}});
  const auto found = SC::intersections(cubic.restricted(0, 0.75), cubic.restricted(0.25, 1).with_domain(0, 1));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind(), Kind::OVERLAP);
  EXPECT_EQ(found[0].parameter_range(1),
            (std::pair(SC::Exact_rational(0), SC::Exact_rational(SC::Exact_rational(2) / 3))));
}

// Those of two curves of higher degree: regular solutions, common ends, and others.
TEST(Elementary_intersections, two_curves)
{
  Random random(13);
  Tally tally;
  for (int i = 0; i < 80; ++i) {
    std::vector<K::Point_2> points, others;
    for (int k = 0; k <= 2 + i % 3; ++k) {
      points.push_back(random.point_2(3));
      others.push_back(random.point_2(3));
    }
    if (i % 2 == 0)
      others.back() = points.front();
    if (points.front() == points.back() || others.front() == others.back())
      continue;
    const auto first = SC::bezier_curve(points), second = SC::bezier_curve(others);
    const auto found = SC::intersections(first, second);
    if (found.is_complete())
      compare_answers(first, second, found, tally);
  }
  EXPECT_GT(tally.points, 60u);
  EXPECT_GT(tally.at_end, 15u);
}

// A root in the middle of a piece is found in a narrow range; a segment in a plane is left to the general way.
TEST(Elementary_intersections, special_positions)
{
  const auto cubic = SC::bezier_curve(std::vector<K::Point_2>{{-3, -3}, {-1, 15}, {1, -15}, {3, 3}});
  Tally tally;
  compare_both(cubic, K::Line_2(0, 1, 0), tally);
  EXPECT_EQ(tally.points, 6u);
  const auto found = SC::intersections(cubic, K::Line_2(0, 1, 0));
  ASSERT_EQ(found.size(), 3u);
  for (const auto& point : found)
    EXPECT_LT(CGAL::to_double(SC::Exact_rational(point.parameter_range(0).second - point.parameter_range(0).first)),
              1e-12);
  EXPECT_EQ(found[1].parameter(0), 0.5);
  const K::Segment_3 segment(K::Point_3(0, 0, 1), K::Point_3(1, 2, 1));
  const auto inside = SC::intersections(segment, K::Plane_3(0, 0, 1, -1));
  ASSERT_EQ(inside.size(), 1u);
  EXPECT_EQ(inside[0].kind(), Kind::OVERLAP);
}

// A stop is honoured, and options are checked.
TEST(Elementary_intersections, options)
{
  struct
  {
    void on_progress(double) {}
    bool stop() { return true; }
  } visitor;
  const K::Line_3 line(K::Point_3(-3, 1, 0), K::Point_3(3, 0, 1));
  const K::Sphere_3 sphere(K::Point_3(0, 0, 0), 4);
  EXPECT_EQ(SC::intersections(line, sphere).size(), 2u);
  EXPECT_FALSE(SC::intersections(line, sphere, {.visitor = visitor}).is_complete());
  EXPECT_THROW(SC::intersections(line, sphere, {.tolerance = 0}), SC::Invalid_input);
  EXPECT_THROW(SC::intersections(K::Line_3(K::Point_3(0, 0, 0), K::Point_3(0, 0, 0)), sphere), SC::Invalid_input);
  EXPECT_THROW(SC::intersections(line, K::Sphere_3(K::Point_3(0, 0, 0), 0)), SC::Invalid_input);
  EXPECT_THROW(SC::intersections(K::Point_3(0, 0, HUGE_VAL), sphere), SC::Invalid_input);
}

} // namespace elementary_intersections
