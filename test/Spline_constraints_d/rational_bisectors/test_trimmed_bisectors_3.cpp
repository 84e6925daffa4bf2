// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed bisectors of points and spheres with surfaces: whole faces, and faces that are kept in part; labels against
// distances from many points of the surface.

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/trimmed_bisectors_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace trimmed_bisectors_3_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Surface = SC::Bspline_surface_3<K>;

namespace {

K::Sphere_3 ball(const Point& center, double radius) { return {center, radius * radius}; }

// At samples of all faces: whether a point of the surface is nearer than the foot. The number of faces with a label.
std::size_t check_labels(const SC::Trimmed_bisector_3& bisector, const Surface& surface, bool has_labels = true)
{
  constexpr int steps = 60;
  std::vector<Point> points;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const auto at = [&](int axis, int k) {
        return std::lerp(surface.domain(axis).first, surface.domain(axis).second, static_cast<double>(k) / steps);
      };
      points.push_back(surface(at(0, i), at(1, j)));
    }
  std::size_t number = 0;
  for (const SC::Trimmed_surface_3& part : bisector.surfaces())
    for (const SC::Surface_face_3& face : part.faces()) {
      if (face.label != SC::NEAREST && face.label != SC::NOT_NEAREST)
        continue;
      ++number;
      const auto exact = bisector.bisector().point(face.sample[0], face.sample[1]),
                 exact_foot = bisector.bisector().foot(1, face.sample[0], face.sample[1]);
      const auto rounded = [](const auto& p) {
        return Point(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
      };
      const Point p = rounded(exact);
      const double own = CGAL::squared_distance(p, rounded(exact_foot));
      double least = own;
      for (const Point& q : points)
        least = std::min(least, CGAL::squared_distance(p, q));
      if (face.label == SC::NEAREST)
        EXPECT_GE(least, own * (1 - 1e-12));
      else
        EXPECT_LT(least, own);
    }
  EXPECT_TRUE(number > 0 || !has_labels);
  return number;
}

} // namespace

TEST(Trimmed_bisectors_3, all_of_a_paraboloid_is_kept)
{
  const Surface plane = SC::plane_patch<K>(Point(-2, -2, 0), Vector(4, 0, 0), Vector(0, 4, 0));
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0.25, 0, 1), plane, ball(Point(0, 0, 0), 20));
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
  EXPECT_EQ(bisector.number_of_regions(SC::NOT_NEAREST), 0u);
  check_labels(bisector, plane);
}

// Of a hyperboloid, the sheet around the point is kept; the other one has the distance from the far side.
TEST(Trimmed_bisectors_3, one_of_two_sheets)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0, 0.25, 2.5), sphere, ball(Point(0, 0, 0), 20));
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
  EXPECT_EQ(bisector.number_of_regions(SC::NOT_NEAREST), 1u);
  check_labels(bisector, sphere);

  // The same for two spheres: between them, and farther from one of them than from the far side of the other.
  const auto of_spheres = SC::trimmed_sphere_surface_bisector(Point(0, 0, 4), 1, sphere, ball(Point(0, 0, 0), 20));
  EXPECT_TRUE(of_spheres.is_complete());
  EXPECT_EQ(of_spheres.number_of_regions(SC::NEAREST), 1u);
  EXPECT_EQ(of_spheres.number_of_regions(SC::NOT_NEAREST), 1u);
}

TEST(Trimmed_bisectors_3, outside_of_a_cylinder)
{
  const Surface cylinder = SC::cylinder_surface<K>(Point(0, 0, 0), 1, 4);
  const auto bisector = SC::trimmed_point_surface_bisector(Point(2.5, 0, 2), cylinder, ball(Point(0, 0, 0), 20));
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
  check_labels(bisector, cylinder);
}

// In a trough the bisector meets itself above the middle: what is beside that is labelled, cell by cell.
TEST(Trimmed_bisectors_3, a_face_that_is_kept_in_part)
{
  const Surface trough({2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1},
                       {{-1, 0, 1}, {-1, 1, 1}, {0, 0, -1}, {0, 1, -1}, {1, 0, 1}, {1, 1, 1}});
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0, 0.5, 0.875), trough, ball(Point(0, 0, 0), 6));
  EXPECT_FALSE(bisector.is_complete());
  EXPECT_FALSE(bisector.undecided().empty());
  EXPECT_GE(bisector.number_of_regions(SC::NEAREST), 1u);
  EXPECT_GE(bisector.number_of_regions(SC::NOT_NEAREST), 1u);
  check_labels(bisector, trough);
}

// x = t^3 - a t and z with the derivative (3 t^2 - a)^3, t = u - 1/2: the curve turns back at t^2 = a / 3 twice, but
// its normal does not. The factors make all coefficients doubles.
TEST(Trimmed_bisectors_3, a_parametrisation_that_turns_back)
{
  using Tensor = SC::Bernstein_tensor<SC::Exact_rational>;
  const auto number = [](const SC::Exact_rational& x) { return Tensor::constant(1, x); };
  const SC::Exact_rational a = SC::Exact_rational(1) / 8, half = SC::Exact_rational(1) / 2;
  const Tensor t = Tensor::coordinate(1, 0) - number(half), t2 = t * t, t3 = t2 * t;
  const auto part = [&](int numerator, int denominator, const SC::Exact_rational& power_of_a, const Tensor& power) {
    return power * SC::Exact_rational(SC::Exact_rational(numerator) / denominator * power_of_a);
  };
  const Tensor z = part(27, 7, 1, t3 * t3 * t) - part(27, 5, a, t3 * t2) + part(3, 1, a * a, t3) -
      part(1, 1, a * a * a, t),
               x = (t3 - t * a).elevated({7});
  std::vector<Point> points;
  for (std::size_t i = 0; i < 8; ++i)
    for (const double v : {0., 1.}) {
      const SC::Exact_rational own_x(x.coefficients()[i] * 105 / 64), own_z(z.coefficients()[i] * 3675 / 128);
      points.emplace_back(CGAL::to_double(own_x), v, CGAL::to_double(own_z));
      ASSERT_EQ(SC::Exact_rational(points.back().x()), own_x);
      ASSERT_EQ(SC::Exact_rational(points.back().z()), own_z);
    }
  const Surface surface({7, 1}, {0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1}, {0, 0, 1, 1}, points);
  check_labels(SC::trimmed_point_surface_bisector(Point(0, 0.5, 0.05), surface, ball(Point(0, 0.5, 0), 2)), surface);
}

// Where the sphere touches the torus along a curve, nothing is decided, and nothing is wrong.
TEST(Trimmed_bisectors_3, spheres_in_the_hole_of_a_torus)
{
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 2, 1).restricted(0, 0, 1);
  const auto bisector = [&](double radius) {
    return SC::trimmed_sphere_surface_bisector(Point(0, 0, 0), radius, torus, ball(Point(0, 0, 0), 6),
                                               {.tolerance = 1e-8, .time_limit = 4});
  };
  check_labels(bisector(-0.5), torus);
  const SC::Trimmed_bisector_3 touching = bisector(-1);
  check_labels(touching, torus, false);
  EXPECT_FALSE(touching.is_complete());
}

TEST(Trimmed_bisectors_3, random_bicubic_surfaces)
{
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> random(-1, 1);
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  std::size_t labelled = 0;
  for (int k = 0; k < 4; ++k) {
    const double size = k < 3 ? 0.1 : 0.5;
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points.emplace_back(i - 1.5 + size * random(generator), j - 1.5 + size * random(generator),
                            size * random(generator));
    const Surface surface({3, 3}, knots, knots, points);
    labelled +=
        check_labels(SC::trimmed_point_surface_bisector(Point(random(generator), random(generator), 2), surface,
                                                        ball(Point(0, 0, 0), 6), {.tolerance = 1e-8, .time_limit = 20}),
                     surface, false);
  }
  EXPECT_GE(labelled, 4u);
}

TEST(Trimmed_bisectors_3, limits)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0, 0, 2.5), sphere, ball(Point(0, 0, 0), 20),
                                                           {.tolerance = 1e-8, .time_limit = 0.02});
  EXPECT_FALSE(bisector.is_complete());
  EXPECT_THROW(SC::trimmed_point_surface_bisector(Point(0, 0, 2.5), sphere, K::Sphere_3(Point(0, 0, 0), 0)),
               SC::Invalid_input);
}

} // namespace trimmed_bisectors_3_test
