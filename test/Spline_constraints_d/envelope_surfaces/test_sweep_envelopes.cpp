// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Envelopes of moving surfaces against closed forms: canal surfaces of balls, cones of growing balls, ellipsoids along
// lines and circles; rational motions against the maps they are made of.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/sweep_envelope.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace sweep_envelope_test {

namespace SC = CGAL::Spline_constraints;
namespace PMP = CGAL::Polygon_mesh_processing;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Surface = SC::Bspline_surface_3<K>;
using Curve = SC::Bspline_curve_3<K>;
using Motion = SC::Rational_motion_3;
using Motion_function = Motion::Function;

namespace {

Curve segment(const Point& p, const Point& q) { return Curve(1, {0, 0, 1, 1}, {p, q}); }

// The unit circle; where it is cut into arcs, none is parallel to an axis.
Curve circle()
{
  return SC::circle_curve<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(Rational(3) / 5, Rational(4) / 5, 0));
}

using Distance = std::function<double(double, double, double)>;

// The mesh of a complete answer, the vertices of which are on a surface.
SC::Solution_surface_mesh checked_mesh(const SC::Envelope_surface_3& envelope, const Distance& distance)
{
  EXPECT_TRUE(envelope.is_complete()) << envelope;
  SC::Solution_surface_mesh result = envelope.mesh({.chord_error = 0.02});
  EXPECT_TRUE(result.is_complete());
  EXPECT_LE(result.error, 1.05 * 0.02);
  EXPECT_GT(result.mesh.number_of_faces(), 20u);
  EXPECT_TRUE(CGAL::is_valid_polygon_mesh(result.mesh));
  for (const auto v : result.mesh.vertices()) {
    const auto& p = result.mesh.point(v);
    EXPECT_NEAR(distance(p.x(), p.y(), p.z()), 0, 1e-12);
  }
  return result;
}

} // namespace

TEST(Sweep_envelope, ball_along_segment)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1) / 2);
  checked_mesh(SC::sweep_envelope(ball, Motion::along(segment(Point(0, 0, 0), Point(2, 1, 0)))),
               [](double x, double y, double z) { return std::hypot((x - 2 * y) / std::sqrt(5.0), z) - 0.5; });
}

TEST(Sweep_envelope, ball_on_circle)
{
  const Distance distance = [](double x, double y, double z) { return std::hypot(std::hypot(x, y) - 1, z) - 0.5; };
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1) / 2);
  const SC::Envelope_surface_3 translated = SC::sweep_envelope(ball, Motion::along(circle()));
  const SC::Solution_surface_mesh torus = checked_mesh(translated, distance);
  EXPECT_EQ(translated.euler_characteristic(), 0);
  EXPECT_TRUE(CGAL::is_closed(torus.mesh)); // joined across the seams of the ball and the circle, and at both poles
  EXPECT_NEAR(PMP::volume(torus.mesh), CGAL_PI * CGAL_PI / 2, 0.15);
  for (const auto& mesh = torus; const auto v : mesh.mesh.vertices()) {
    const auto& p = mesh.mesh.point(v);
    const double cosine = (std::hypot(p.x(), p.y()) - 1) / 0.5;
    EXPECT_NEAR(mesh.differentials[v].gaussian_curvature(), cosine / (0.5 * (1 + 0.5 * cosine)), 1e-7);
  }
  // turned about the axis of the torus the ball touches it along one circle all the time
  const Surface beside = SC::sphere_surface<K>(Point(1, 0, 0), Rational(1) / 2);
  const SC::Envelope_surface_3 turned = SC::sweep_envelope(beside, Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 1)));
  EXPECT_EQ(turned.euler_characteristic(), 0);
  const SC::Solution_surface_mesh halves = checked_mesh(turned, distance);
  EXPECT_TRUE(CGAL::is_closed(halves.mesh));
  EXPECT_NEAR(PMP::volume(halves.mesh), CGAL_PI * CGAL_PI / 2, 0.15);
  EXPECT_EQ(turned.parts().size(), 3u); // nothing, and what the two half circles sweep
}

TEST(Sweep_envelope, growing_ball)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1) / 2);
  const Motion growth = Motion::scaling(Point(0, 0, 0), Motion_function({1}, {{0, 0, 1, 1}}, {1, 2}));
  const SC::Envelope_surface_3 cone =
      SC::sweep_envelope(ball, Motion::along(segment(Point(0, 0, 0), Point(3, 0, 0))) * growth);
  checked_mesh(cone, [](double x, double y, double z) {
    const double sine = 0.5 / 3;
    return std::hypot(y, z) * std::sqrt(1 - sine * sine) - sine * (x + 3);
  });
}

// An arc whose image is a pole of the ball, or a tip of the apple, is one point but for rounding: it is not halved for
// ever, nor is what is beside it, and the limit of time holds.
TEST(Sweep_envelope, mesh_of_arcs_that_are_one_point)
{
  const SC::Envelope_surface_3 apple =
      SC::sweep_envelope(SC::sphere_surface<K>(Point(0, 0, 0), Rational(3) / 2), Motion::along(circle()));
  ASSERT_EQ(apple.parts().size(), 1u);
  const SC::Envelope_part_3& part = apple.parts().front();
  EXPECT_FALSE(
      SC::to_surface_mesh(part.solutions, part.image, {.chord_error = 0.01}, {.time_limit = 0.1}).is_complete());
  const SC::Solution_surface_mesh coarse =
      SC::to_surface_mesh(part.solutions, part.image, {.chord_error = 0.1, .is_remeshed = false});
  EXPECT_TRUE(coarse.is_complete());
  EXPECT_GT(coarse.mesh.number_of_vertices(), 100u);
  EXPECT_LT(coarse.mesh.number_of_vertices(), 2000u);
}

// A vertex of a solution that no patch has: z = x^2 + y^2 with the normals (-2 x, -2 y, 1) moves with the velocity
// (-1, -1, t), a tangent at a corner at first and nowhere else.
TEST(Sweep_envelope, mesh_without_patches)
{
  std::vector<Point> points;
  for (const int i : {0, 1, 2})
    for (const int j : {0, 1, 2})
      points.emplace_back(Rational(i) / 2, Rational(j) / 2, i / 2 + j / 2);
  const Surface bowl({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, points);
  const Rational half = Rational(1) / 2;
  const Curve path(2, {0, 0, 0, 1, 1, 1}, {Point(0, 0, 0), Point(-half, -half, 0), Point(-1, -1, half)});
  const SC::Envelope_surface_3 envelope = SC::sweep_envelope(bowl, Motion::along(path));
  ASSERT_EQ(envelope.parts().size(), 1u);
  const SC::Envelope_part_3& part = envelope.parts().front();
  EXPECT_TRUE(envelope.is_complete()) << envelope;
  ASSERT_TRUE(part.solutions.patches().empty());
  ASSERT_EQ(part.solutions.points().size(), 1u);
  const SC::Solution_surface_mesh mesh = SC::to_surface_mesh(part.solutions, part.image);
  EXPECT_EQ(mesh.mesh.number_of_faces(), 0u);
}

// With a horizontal velocity at the end of the path, for which whole edges of the domain, at the poles of the ball, are
// solutions: a strip of parameters all the same.
TEST(Sweep_envelope, edges_that_are_solutions)
{
  const Rational half = Rational(1) / 2;
  const Curve path(2, {0, 0, 0, 1, 1, 1}, {Point(0, 0, 0), Point(1, Rational(1) / 8, half), Point(3, 1, half)});
  const SC::Envelope_surface_3 tube =
      SC::sweep_envelope(SC::sphere_surface<K>(Point(0, 0, 0), half / 2), Motion::along(path));
  ASSERT_EQ(tube.parts().size(), 1u);
  const SC::Surface_solution_set_d& solutions = tube.parts()[0].solutions;
  EXPECT_TRUE(solutions.is_complete()) << solutions;
  EXPECT_EQ(solutions.euler_characteristic(), 1);
  EXPECT_EQ(solutions.number_of_boundary_loops(), 1u);
  const SC::Solution_surface_mesh mesh = tube.mesh({.chord_error = 0.05});
  EXPECT_GT(mesh.mesh.number_of_faces(), 10u);
  for (const auto v : mesh.mesh.vertices()) {
    const Point center = path(Rational(mesh.unknowns[v][2]));
    const auto& p = mesh.mesh.point(v);
    EXPECT_NEAR(std::hypot(p.x() - CGAL::to_double(center.x()), p.y() - CGAL::to_double(center.y()),
                           p.z() - CGAL::to_double(center.z())),
                0.25, 1e-12);
  }
}

// The points of an ellipsoid where the velocity d is a tangent: <x/a^2, d> = 0.
TEST(Sweep_envelope, ellipsoid)
{
  const Surface ellipsoid =
      SC::sphere_surface<K>(Point(0, 0, 0), Rational(1))
          .transformed(K::Aff_transformation_3(1, 0, 0, 0, Rational(1) / 2, 0, 0, 0, Rational(3) / 4));
  const Motion line = Motion::along(segment(Point(0, 0, 0), Point(1, 2, 2)));
  const SC::Envelope_surface_3 straight = SC::sweep_envelope(ellipsoid, line);
  const SC::Solution_surface_mesh mesh = checked_mesh(straight, [](double x, double y, double z) {
    // the distance of the line through a point from the center, after the ellipsoid was made a sphere
    const double p = x, q = 2 * y, r = z * 4 / 3, a = 1, b = 4, c = 8. / 3,
                 along = (p * a + q * b + r * c) / (a * a + b * b + c * c);
    return std::sqrt((p - along * a) * (p - along * a) + (q - along * b) * (q - along * b) +
                     (r - along * c) * (r - along * c)) -
        1;
  });
  EXPECT_EQ(straight.euler_characteristic(), 0);
  EXPECT_EQ(CGAL::num_vertices(mesh.mesh) + CGAL::num_faces(mesh.mesh), CGAL::num_edges(mesh.mesh)); // one tube
  for (const auto v : mesh.mesh.vertices())
    EXPECT_NEAR(mesh.differentials[v].gaussian_curvature(), 0, 1e-9);

  // radial half axis 1/2, vertical one 1/4: a ring whose section is an ellipse
  const Surface small = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1))
                            .transformed(K::Aff_transformation_3(Rational(1) / 2, 0, 0, 2, 0, Rational(1) / 3, 0, 0, 0,
                                                                 0, Rational(1) / 4, 0));
  checked_mesh(SC::sweep_envelope(small, Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 1))),
               [](double x, double y, double z) { return std::hypot((std::hypot(x, y) - 2) * 2, z * 4) - 1; });
}

// The same motion, given as a path with axes of its own weights.
TEST(Sweep_envelope, affine_motion)
{
  const Curve path = segment(Point(0, 0, 0), Point(4, 0, 0));
  const SC::Affine_motion<K> motion{path,
                                    {segment(Point(1, 0, 0), Point(1, 0, 0)), segment(Point(0, 1, 0), Point(0, 1, 0)),
                                     segment(Point(0, 0, 1), Point(0, 0, 1))}};
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1));
  checked_mesh(SC::sweep_envelope(ball, motion), [](double, double y, double z) { return std::hypot(y, z) - 1; });
}

TEST(Sweep_envelope, surfaces_that_move_along_themselves_are_told)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1));
  for (const Motion& motion :
       {Motion::full_turn(Point(0, 0, 0), Vector(1, 2, 3)), Motion::along(segment(Point(1, 1, 1), Point(1, 1, 1)))}) {
    const SC::Envelope_surface_3 nothing = SC::sweep_envelope(ball, motion);
    EXPECT_FALSE(nothing.is_complete());
    ASSERT_EQ(nothing.undecided().size(), 1u);
    EXPECT_EQ(nothing.undecided()[0].reason, "the surface moves along itself");
    EXPECT_TRUE(nothing.parts().empty());
  }
}

TEST(Sweep_envelope, rational_motions)
{
  std::mt19937 random(54);
  std::uniform_int_distribution<int> any(-5, 5);
  const auto function = [&] {
    return Motion_function({2}, {{0, 0, 0, 1, 1, 1}}, {any(random), any(random), any(random)});
  };
  for (int round = 0; round < 5; ++round) {
    const Motion turn = Motion::rotation({function() + Rational(11), function(), function(), function()});
    const Motion moved = Motion::along(segment(Point(1, 2, 3), Point(any(random), 1, 0))) * turn;
    for (const Rational& t : std::vector<Rational>{0, Rational(1) / 3, 1}) {
      const auto map = turn(t);
      for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) // columns are orthonormal
          EXPECT_EQ(map.m(0, i) * map.m(0, k) + map.m(1, i) * map.m(1, k) + map.m(2, i) * map.m(2, k), i == k ? 1 : 0);
      const Point p(any(random), any(random), any(random));
      EXPECT_EQ(moved.inverse(t).transform(moved(t).transform(p)), p);
    }
  }
  const Motion full = Motion::full_turn(Point(1, 0, 0), Vector(0, 0, 2));
  EXPECT_EQ(full(0).transform(Point(3, 0, 1)), Point(3, 0, 1));
  EXPECT_EQ(full(1).transform(Point(3, 0, 1)), Point(-1, 0, 1));
  EXPECT_EQ(full(2).transform(Point(3, 0, 1)), Point(3, 0, 1));
}

TEST(Sweep_envelope, bad_input_and_limits)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1));
  const Curve path = segment(Point(0, 0, 0), Point(4, 0, 0));
  EXPECT_THROW(SC::sweep_envelope(ball, SC::Affine_motion<K>{path, {path}}), SC::Invalid_input);
  EXPECT_THROW(Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 0)), SC::Invalid_input);
  const Motion_function zero({0}, {{0, 1}}, {0});
  EXPECT_THROW(Motion::rotation({zero, zero, zero, zero}), SC::Invalid_input);
  EXPECT_THROW(Motion::scaling(Point(0, 0, 0), Motion_function({1}, {{0, 0, 1, 1}}, {1, -1})), SC::Invalid_input);
  EXPECT_THROW(Motion::along(path) * Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 1)), SC::Invalid_input);
  const SC::Envelope_surface_3 stopped = SC::sweep_envelope(ball, Motion::along(path), {.time_limit = 1e-9});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
  const SC::Envelope_surface_3 whole = SC::sweep_envelope(ball, Motion::along(path));
  EXPECT_FALSE(whole.mesh({.chord_error = 1e-4}, {.time_limit = 1e-9}).is_complete());
  EXPECT_THROW(whole.mesh({.chord_error = 0}), SC::Invalid_input);
}

} // namespace sweep_envelope_test
