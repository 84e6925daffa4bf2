// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed bisectors of points and spheres with surfaces: whole faces, and faces that are kept in part; labels against
// distances from many points of the surface.

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/trimmed_bisectors_3.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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
  constexpr int steps = 40;
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
      // next to the foot, too
      for (const double size : {0.03, 0.002})
        for (int i = -6; i <= 6; ++i)
          for (int j = -6; j <= 6; ++j) {
            const auto at = [&](std::size_t axis, int k) {
              const auto [begin, end] = surface.domain(static_cast<int>(axis));
              return std::clamp(CGAL::to_double(face.sample[axis]) + 0.15 * k * size * (end - begin), begin, end);
            };
            least = std::min(least, CGAL::squared_distance(p, surface(at(0, i), at(1, j))));
          }
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

// The points of the border of what is kept: of edges of faces with another label beyond.
std::vector<std::array<double, 2>> border_of_what_is_kept(const SC::Trimmed_bisector_3& bisector)
{
  std::vector<std::array<double, 2>> result;
  for (const SC::Trimmed_surface_3& part : bisector.surfaces())
    for (const SC::Surface_face_3& face : part.faces())
      for (const auto& loop : face.loops)
        for (const SC::Surface_face_edge_3& edge : loop)
          if (face.label == SC::NEAREST && edge.neighbour && part.faces()[*edge.neighbour].label == SC::NOT_NEAREST)
            result.push_back({CGAL::to_double(edge.source.x()), CGAL::to_double(edge.source.y())});
  return result;
}

// A ball that touches a sphere from within is within it.
TEST(Trimmed_bisectors_3, all_is_kept_inside_of_a_sphere)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0.25, -0.25, 0.5), sphere, ball(Point(0, 0, 0), 8));
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
  EXPECT_EQ(bisector.number_of_regions(SC::NOT_NEAREST), 0u);
  check_labels(bisector, sphere);
}

// Inside of a cylinder of radius 1 a ball is kept up to this radius: then its center is on the axis, at a distance of 1
// from the point, so that z = 2 - sqrt(15)/4 or z = 2 + sqrt(15)/4 on all of the border.
TEST(Trimmed_bisectors_3, a_bisector_that_meets_itself_inside_of_a_cylinder)
{
  const Surface cylinder = SC::cylinder_surface<K>(Point(0, 0, 0), 1, 4);
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0.25, 0, 2), cylinder, ball(Point(0, 0, 0), 20));
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
  EXPECT_EQ(bisector.number_of_regions(SC::NOT_NEAREST), 2u);
  check_labels(bisector, cylinder);
  const auto border = border_of_what_is_kept(bisector);
  EXPECT_GE(border.size(), 16u);
  for (const auto& [u, v] : border) {
    const Point foot = cylinder(u, v);
    EXPECT_NEAR(std::abs(foot.z() - 2), std::sqrt(15.) / 4, 1e-6);
  }
}

// The tip of the cone is the end of lines that spheres touch it along.
TEST(Trimmed_bisectors_3, inside_of_a_cone)
{
  const Surface cone = SC::cone_surface(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4));
  const auto bisector = SC::trimmed_point_surface_bisector(Point(0.25, 0, 2), cone, ball(Point(0, 0, 0), 20));
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
  EXPECT_EQ(bisector.number_of_regions(SC::NOT_NEAREST), 2u);
  EXPECT_FALSE(border_of_what_is_kept(bisector).empty());
  check_labels(bisector, cone);
}

// The oracle: a point on the axis of a surface of revolution has the bisector of a point and the profile, revolved. Of
// that, the part is kept where no point of the profile is nearer, on the side of the axis where the profile is.
TEST(Trimmed_bisectors_3, revolved_profiles)
{
  using Curve = SC::Bspline_curve_2<K>;
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> random(-1, 1);
  std::size_t kept = 0, not_kept = 0;
  for (int k = 0; k < 3; ++k) {
    std::vector<K::Point_2> profile;
    std::vector<Point> in_space;
    for (int i = 0; i < 3; ++i) {
      profile.emplace_back(1.5 + 0.5 * random(generator), 1.5 * i - 1.5);
      in_space.emplace_back(profile.back().x(), 0, profile.back().y());
    }
    const std::vector<double> knots{0, 0, 0, 1, 1, 1};
    const double height = random(generator);
    const Surface surface =
        SC::surface_of_revolution<K>(SC::Bspline_curve_3<K>(2, knots, in_space), Point(0, 0, 0), Vector(0, 0, 1));
    const auto bisector = SC::trimmed_point_surface_bisector(Point(0, 0, height), surface, ball(Point(0, 0, 0), 6));
    const auto planar = SC::trimmed_bisector(Curve(2, knots, profile), K::Point_2(0, height));
    EXPECT_TRUE(bisector.is_complete());
    ASSERT_TRUE(planar.is_complete());
    check_labels(bisector, surface);
    // where the foot of the planar one is on the curve
    std::vector<std::array<double, 2>> ranges;
    for (const auto& chain : planar.chains())
      for (const auto& polyline : planar.polylines(chain, 1e-4, 100))
        for (std::size_t i = 1; i < polyline.size(); ++i) {
          const auto &a = polyline[i - 1], &b = polyline[i];
          if (!a.parameters[0] || !b.parameters[0] || (a.point.x() <= 0 && b.point.x() <= 0))
            continue;
          // up to the axis
          double from = *a.parameters[0], to = *b.parameters[0];
          const double at = std::lerp(from, to, a.point.x() / (a.point.x() - b.point.x()));
          if (a.point.x() < 0)
            from = at;
          else if (b.point.x() < 0)
            to = at;
          ranges.push_back({std::min(from, to), std::max(from, to)});
        }
    const auto is_kept = [&](double v) {
      return std::ranges::any_of(ranges, [&](const auto& r) { return r[0] <= v && v <= r[1]; });
    };
    for (const SC::Trimmed_surface_3& part : bisector.surfaces())
      for (const SC::Surface_face_3& face : part.faces()) {
        if (face.label != SC::NEAREST && face.label != SC::NOT_NEAREST)
          continue;
        const double v = CGAL::to_double(face.sample[1]);
        EXPECT_EQ(face.label == SC::NEAREST, is_kept(v));
        ++(is_kept(v) ? kept : not_kept);
      }
    for (const auto& [u, v] : border_of_what_is_kept(bisector))
      EXPECT_NE(is_kept(v - 1e-3), is_kept(v + 1e-3));
  }
  EXPECT_GE(kept, 3u);
  EXPECT_GE(not_kept, 3u);
}

// Turned, and made larger by the squared length of a quaternion, so that doubles are exact.
TEST(Trimmed_bisectors_3, turned_surfaces)
{
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  const double heights[4][4] = {
      {0, 0.25, -0.375, 0}, {0.25, -0.75, 0.75, 0}, {0, 1, -0.75, 0}, {0.125, 0, 0.125, 0.25}};
  for (const auto& [a, b, c, d] : {std::array{1, 0, 0, 0}, {1, 2, -1, 3}, {2, 1, 1, -1}, {3, -2, 1, 1}}) {
    const auto turned = [&](double x, double y, double z) {
      return Point((a * a + b * b - c * c - d * d) * x + 2 * (b * c - a * d) * y + 2 * (b * d + a * c) * z,
                   2 * (b * c + a * d) * x + (a * a - b * b + c * c - d * d) * y + 2 * (c * d - a * b) * z,
                   2 * (b * d - a * c) * x + 2 * (c * d + a * b) * y + (a * a - b * b - c * c + d * d) * z);
    };
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points.push_back(turned(i - 1.5, j - 1.5, 0.0625 * heights[i][j]));
    const Surface surface({3, 3}, knots, knots, points);
    const auto bisector = SC::trimmed_point_surface_bisector(turned(0, 0, 2), surface,
                                                             ball(Point(0, 0, 0), 8 * (a * a + b * b + c * c + d * d)));
    EXPECT_TRUE(bisector.is_complete());
    EXPECT_EQ(bisector.number_of_regions(SC::NEAREST), 1u);
    EXPECT_EQ(bisector.number_of_regions(SC::NOT_NEAREST), 0u);
    check_labels(bisector, surface);
  }
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
                                               {.tolerance = 1e-8, .time_limit = radius == -1 ? 1. : 20.});
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
  for (int k = 0; k < 2; ++k) {
    const double size = k < 1 ? 0.1 : 0.5;
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
  EXPECT_GE(labelled, 2u);
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
