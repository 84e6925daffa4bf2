// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors and alpha-sectors of surfaces: planes, spheres and cylinders in closed form, random surfaces by distances
// and normals, rigid motions, bad input.

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_surface.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/alpha_sector_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/surface_bisector.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace surface_bisector_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;
using Point = K::Point_3;
using Surface = SC::Bspline_surface_3<K>;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Double_point = CGAL::Simple_cartesian<double>::Point_3;
using SC::Touched_side;

constexpr SC::Touched_sides outside{Touched_side::POSITIVE, Touched_side::POSITIVE};

namespace {

Rational ratio(int a, int b) { return Rational(a) / b; }

Surface plane(const Rational& z)
{
  return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{-2, -2, z}, {-2, 2, z}, {2, -2, z}, {2, 2, z}}).transposed();
}

// Turned, so that its cells are not symmetric to those of another one.
Surface sphere(const Rational& radius, const Rational& x, const Rational& z, bool is_turned)
{
  const Surface centered = SC::to_bspline_surface(CGAL::Sphere_3<K>(Point(0, 0, 0), radius * radius));
  return is_turned ? centered.transformed({ratio(2, 7), ratio(3, 7), ratio(6, 7), x, ratio(6, 7), ratio(2, 7),
                                           ratio(-3, 7), 0, ratio(-3, 7), ratio(6, 7), ratio(-2, 7), z})
                   : centered.transformed({1, 0, 0, x, 0, 1, 0, 0, 0, 0, 1, z});
}

Surface random_surface(int degree, const Rational& z, const Rational& height, std::mt19937& random)
{
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      points.emplace_back(ratio(i, degree) - ratio(1, 2), ratio(j, degree) - ratio(1, 2),
                          z + height * (static_cast<int>(random() % 201) - 100) / 100);
  std::vector<Rational> knots(static_cast<std::size_t>(degree) + 1, Rational(0));
  knots.resize(2 * knots.size(), Rational(1));
  return Surface({degree, degree}, knots, knots, points);
}

Vector to_vector(const K::Vector_3& v)
{
  return {CGAL::to_double(v.x()), CGAL::to_double(v.y()), CGAL::to_double(v.z())};
}

SC::Solution_surface_mesh checked_mesh(const SC::Envelope_surface_3& surface, double error = 0.05)
{
  EXPECT_TRUE(surface.is_complete()) << surface;
  SC::Solution_surface_mesh result = surface.mesh({.chord_error = error, .angle = 10});
  EXPECT_GT(result.mesh.number_of_faces(), 3u);
  return result;
}

// Each vertex is on normals of both surfaces, at distances of the ratio 1 : c.
void expect_feet(const SC::Solution_surface_mesh& mesh, const Surface& a, const Surface& b, double c)
{
  using Mesh = SC::Solution_surface_mesh::Mesh;
  Mesh copy = mesh.mesh; // with its property maps
  const auto distances = copy.add_property_map<Mesh::Vertex_index, std::vector<double>>("v:distances").first;
  for (const auto v : mesh.mesh.vertices()) {
    const std::vector<double>& x = mesh.unknowns[v];
    const auto step = [&](const Surface& surface, std::size_t place) {
      const Rational u(x[place]), w(x[place + 1]);
      const Point foot = surface(u, w);
      const Vector result = mesh.mesh.point(v) -
          Double_point(CGAL::to_double(foot.x()), CGAL::to_double(foot.y()), CGAL::to_double(foot.z()));
      for (const K::Vector_3& tangent : {surface.derivative(u, w, 1, 0), surface.derivative(u, w, 0, 1)})
        EXPECT_NEAR(result * to_vector(tangent), 0, 1e-11);
      return std::sqrt(result.squared_length());
    };
    const double first = step(a, 0), second = step(b, 2);
    EXPECT_NEAR(second, c * first, 1e-11);
    EXPECT_NEAR(distances[v].at(0), first, 1e-12);
    EXPECT_NEAR(distances[v].at(1), second, 1e-12);
  }
}

double distance(const Double_point& p, double x, double y, double z)
{
  return std::hypot(p.x() - x, p.y() - y, p.z() - z);
}

} // namespace

TEST(Surface_bisector, parallel_planes)
{
  const SC::Envelope_surface_3 bisector = SC::surface_bisector(plane(0), plane(2), 3);
  EXPECT_EQ(bisector.euler_characteristic(), 1);
  const SC::Solution_surface_mesh mesh = checked_mesh(bisector);
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(p.z(), 1, 1e-14);
}

// They go through the common line of both planes.
TEST(Surface_bisector, crossing_planes)
{
  const Surface slope({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{-1, -1, -1}, {-1, 1, -1}, {1, -1, 1}, {1, 1, 1}});
  const SC::Envelope_surface_3 bisector = SC::surface_bisector(plane(0), slope, 1);
  EXPECT_EQ(bisector.euler_characteristic(), 2);
  bool is_left = false, is_right = false;
  const SC::Solution_surface_mesh mesh = checked_mesh(bisector);
  for (const auto& p : mesh.mesh.points()) {
    EXPECT_NEAR(std::abs(p.z()), std::abs(p.x() - p.z()) / std::sqrt(2.), 1e-13);
    EXPECT_LE(std::abs(p.z()), 1 + 1e-12);
    is_left = is_left || p.z() < -0.1;
    is_right = is_right || p.z() > 0.1;
  }
  EXPECT_TRUE(is_left && is_right);
}

// z = (x^2 + y^2 + c^2 - r^2) / (2 (c + r)), and with c - r inside of the sphere.
TEST(Surface_bisector, plane_and_sphere)
{
  for (const bool is_sphere_first : {false, true})
    for (const bool is_outside : {true, false}) {
      const Touched_side side = is_outside ? Touched_side::POSITIVE : Touched_side::NEGATIVE;
      const Surface ball = sphere(1, 0, 2, false);
      const SC::Envelope_surface_3 bisector = is_sphere_first
          ? SC::surface_bisector(ball, plane(0), 3, {side, Touched_side::NEGATIVE})
          : SC::surface_bisector(plane(0), ball, 3, {Touched_side::NEGATIVE, side});
      ASSERT_EQ(bisector.parts().size(), 1u);
      EXPECT_EQ(bisector.parts()[0].solutions.surfaces().size(), 1u);
      EXPECT_EQ(bisector.euler_characteristic(), 1);
      const SC::Solution_surface_mesh mesh = checked_mesh(bisector);
      for (const auto& p : mesh.mesh.points())
        EXPECT_NEAR(p.z(), (p.x() * p.x() + p.y() * p.y() + 3) / (is_outside ? 6 : 2), 1e-12);
    }
}

// z = (x^2 - y^2) / (4 h) between cylinders with the radius r and axes at z = -h and z = h, at right angles; the radius
// does not matter. At the origin it has the Gaussian curvature -1/(4 h^2).
TEST(Surface_bisector, perpendicular_cylinders)
{
  const Rational r = ratio(1, 2);
  // half of a cylinder along the first axis, above or below
  const auto half = [&](int side) {
    return Surface({1, 2}, {0, 0, 1, 1}, {0, 0, 0, 1, 1, 1},
                   {{-1, r * 3 / 5, side * r * 4 / 5},
                    {-1, 0, side * r * 5 / 4},
                    {-1, -r * 3 / 5, side * r * 4 / 5},
                    {1, r * 3 / 5, side * r * 4 / 5},
                    {1, 0, side * r * 5 / 4},
                    {1, -r * 3 / 5, side * r * 4 / 5}},
                   {1, ratio(4, 5), 1, 1, ratio(4, 5), 1});
  };
  const Surface low = half(1).transformed({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1}),
                high = half(-1).transformed({0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 1});
  const SC::Envelope_surface_3 bisector = SC::surface_bisector(low, high, 2);
  EXPECT_EQ(bisector.euler_characteristic(), 1);
  const SC::Solution_surface_mesh mesh = checked_mesh(bisector, 0.003);
  double nearest = 1;
  for (const auto v : mesh.mesh.vertices()) {
    const Double_point& p = mesh.mesh.point(v);
    EXPECT_NEAR(p.z(), (p.x() * p.x() - p.y() * p.y()) / 4, 1e-12);
    const double square = 1 + (p.x() * p.x() + p.y() * p.y()) / 4;
    EXPECT_NEAR(mesh.differentials[v].gaussian_curvature(), -1 / (4 * square * square), 1e-9);
    nearest = (std::min)(nearest, distance(p, 0, 0, 0));
  }
  EXPECT_LT(nearest, 0.5);
}

// 4 x^2 - (4/15) (y^2 + z^2) = 1, the sheet nearer to the smaller sphere.
TEST(Surface_bisector, spheres)
{
  const SC::Envelope_surface_3 bisector =
      SC::surface_bisector(sphere(1, -2, 0, true), sphere(2, 2, 0, false), ratio(23, 10), outside);
  EXPECT_EQ(bisector.euler_characteristic(), 1);
  const SC::Solution_surface_mesh mesh = checked_mesh(bisector);
  for (const auto& p : mesh.mesh.points()) {
    EXPECT_NEAR(4 * p.x() * p.x() - 4 * (p.y() * p.y() + p.z() * p.z()) / 15, 1, 1e-12);
    EXPECT_LT(p.x(), 0);
  }
}

TEST(Surface_bisector, random_surfaces)
{
  std::mt19937 random(71);
  for (int round = 0; round < 6; ++round) {
    const int degree = 1 + round % 3;
    const Rational height = ratio(1, degree == 3 ? 20 : 8);
    const Surface a = random_surface(degree, 0, height, random), b = random_surface(degree, 1, height, random);
    const SC::Envelope_surface_3 bisector = SC::surface_bisector(a, b, 1);
    EXPECT_EQ(bisector.euler_characteristic(), 1);
    const SC::Solution_surface_mesh mesh = checked_mesh(bisector, 0.01);
    expect_feet(mesh, a, b, 1);
    const SC::Envelope_surface_3 sector = SC::alpha_sector_surface(a, b, ratio(1, 3));
    expect_feet(checked_mesh(sector, 0.1), a, b, 2);
  }
}

// Nothing changes but the place.
TEST(Surface_bisector, rigid_motion)
{
  std::mt19937 random(72);
  const Surface a = random_surface(2, 0, ratio(1, 8), random), b = random_surface(2, 1, ratio(1, 8), random);
  const CGAL::Aff_transformation_3<K> motion(ratio(2, 7), ratio(3, 7), ratio(6, 7), 5, ratio(6, 7), ratio(2, 7),
                                             ratio(-3, 7), -1, ratio(-3, 7), ratio(6, 7), ratio(-2, 7), 3);
  const SC::Envelope_surface_3 bisector = SC::surface_bisector(a, b, 2),
                               moved = SC::surface_bisector(a.transformed(motion), b.transformed(motion), 2);
  ASSERT_TRUE(bisector.is_complete() && moved.is_complete());
  ASSERT_EQ(bisector.parts().size(), moved.parts().size());
  EXPECT_EQ(bisector.euler_characteristic(), moved.euler_characteristic());
  for (std::size_t k = 0; k < moved.parts().size(); ++k) {
    const auto &own = bisector.parts()[k].solutions, &other = moved.parts()[k].solutions;
    EXPECT_EQ(own.surfaces().size(), other.surfaces().size());
    EXPECT_EQ(own.number_of_boundary_loops(), other.number_of_boundary_loops());
  }
  const SC::Solution_surface_mesh mesh = moved.mesh({.chord_error = 0.01});
  EXPECT_GT(mesh.mesh.number_of_vertices(), 10u);
  expect_feet(mesh, a.transformed(motion), b.transformed(motion), 1);
}

TEST(Alpha_sector_surface, parallel_planes)
{
  const SC::Envelope_surface_3 sector = SC::alpha_sector_surface(plane(0), plane(3), ratio(1, 3));
  // one plane between both, and one below
  EXPECT_EQ(sector.euler_characteristic(), 2);
  const SC::Solution_surface_mesh mesh = checked_mesh(sector);
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(std::abs(p.z() + 1), 2, 1e-14);
}

// Spheres with the radius (1 - a) r + a R, and, across the center, with r + (r + R) / (c - 1), c = (1 - a) / a.
TEST(Alpha_sector_surface, concentric_spheres)
{
  const SC::Envelope_surface_3 sector = SC::alpha_sector_surface(
      sphere(1, 0, 0, true), sphere(2, 0, 0, false), ratio(1, 4), {Touched_side::POSITIVE, Touched_side::NEGATIVE});
  EXPECT_EQ(sector.euler_characteristic(), 4);
  const SC::Solution_surface_mesh mesh = checked_mesh(sector);
  EXPECT_TRUE(CGAL::is_closed(mesh.mesh));
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(std::abs(distance(p, 0, 0, 0) - 1.875), 0.625, 1e-12);
}

// (1 - a) (|P - O| - r) = a (|P - Q| - R): a Cartesian oval, revolved.
TEST(Alpha_sector_surface, oval)
{
  const SC::Envelope_surface_3 sector =
      SC::alpha_sector_surface(sphere(1, 0, 0, true), sphere(2, 5, 0, false), ratio(1, 3), outside);
  EXPECT_EQ(sector.euler_characteristic(), 2);
  const SC::Solution_surface_mesh mesh = checked_mesh(sector);
  EXPECT_TRUE(CGAL::is_closed(mesh.mesh));
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(2 * (distance(p, 0, 0, 0) - 1), distance(p, 5, 0, 0) - 2, 1e-12);
}

TEST(Surface_bisector, bad_input_and_limits)
{
  EXPECT_THROW(SC::surface_bisector(plane(0), plane(2), 0), SC::Invalid_input);
  EXPECT_THROW(SC::surface_bisector(plane(0), plane(0), 1), SC::Invalid_input);
  const Surface part({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {1, 0, 0}});
  EXPECT_THROW(SC::surface_bisector(plane(0), part, 1), SC::Invalid_input);
  EXPECT_THROW(SC::surface_bisector(sphere(1, 0, 0, true), sphere(1, 0, 0, false), 1), SC::Invalid_input);
  for (const Rational& alpha : {Rational(0), Rational(1), Rational(-1), ratio(1, 2)})
    EXPECT_THROW(SC::alpha_sector_surface(plane(0), plane(2), alpha), SC::Invalid_input);
  const Surface point({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Point>(4, Point(1, 2, 3)));
  EXPECT_THROW(SC::surface_bisector(plane(0), point, 1), SC::Invalid_input);
  EXPECT_THROW(SC::surface_bisector(point, plane(0), 1), SC::Invalid_input);
  // (u^2, v^2, 2 + u v) has no normal at the origin
  const Surface corner({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1},
                       {{0, 0, 2},
                        {0, 0, 2},
                        {0, 1, 2},
                        {0, 0, 2},
                        {0, 0, ratio(9, 4)},
                        {0, 1, ratio(5, 2)},
                        {1, 0, 2},
                        {1, 0, ratio(5, 2)},
                        {1, 1, 3}});
  const SC::Envelope_surface_3 undecided = SC::surface_bisector(plane(0), corner, 1);
  ASSERT_EQ(undecided.undecided().size(), 1u);
  EXPECT_EQ(undecided.undecided()[0].reason, "whether normals are zero");
  EXPECT_FALSE(SC::surface_bisector(plane(0), plane(2), 3, {}, {.time_limit = 1e-9}).is_complete());
}

} // namespace surface_bisector_test
