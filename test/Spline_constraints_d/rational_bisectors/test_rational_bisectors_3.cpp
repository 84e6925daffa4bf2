// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Rational bisectors in space: equal distances, feet and closed forms as identities of polynomials; lowest degrees;
// poles.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/dupin_cyclides.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/rational_offset.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace rational_bisectors_3_test {

namespace SC = CGAL::Spline_constraints;
using K = SC::Rational_bisector_3::Kernel;
using Number = SC::Exact_rational;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Curve = SC::Bspline_curve_3<K>;
using Surface = SC::Bspline_surface_3<K>;
using Piece = SC::Rational_bisector_piece_3;
using Tensor = SC::Bernstein_tensor<Number>;
using Degrees = std::pair<int, int>;

namespace {

bool is_zero(const Tensor& f) { return f == Tensor::constant(2, Number(0)); }

Tensor squared(const Tensor& f) { return f * f; }

// (P - A) times both weights.
std::array<Tensor, 3> difference(const Piece::Coordinates& p, const Piece::Coordinates& a)
{
  return {p[0] * a[3] - a[0] * p[3], p[1] * a[3] - a[1] * p[3], p[2] * a[3] - a[2] * p[3]};
}

Tensor squared_length(const std::array<Tensor, 3>& a) { return squared(a[0]) + squared(a[1]) + squared(a[2]); }

// As polynomials: both feet are at the same distance, and the vectors to them are normal to the operands.
void check_centers(const SC::Rational_bisector_3& bisector)
{
  ASSERT_TRUE(bisector.is_complete());
  ASSERT_FALSE(bisector.pieces().empty());
  for (const Piece& piece : bisector.pieces()) {
    EXPECT_FALSE(is_zero(piece.coordinates()[3]));
    const auto &first = piece.foot_coordinates(0), &second = piece.foot_coordinates(1);
    EXPECT_EQ(squared_length(difference(piece.coordinates(), first)) * squared(second[3]),
              squared_length(difference(piece.coordinates(), second)) * squared(first[3]));
    for (const int operand : {0, 1}) {
      const auto& foot = piece.foot_coordinates(operand);
      const auto radius = difference(piece.coordinates(), foot);
      for (const int axis : {0, 1}) {
        Tensor product = Tensor::constant(2, Number(0));
        for (std::size_t i = 0; i < 3; ++i)
          product += radius[i] * (foot[3] * foot[i].derivative(axis) - foot[3].derivative(axis) * foot[i]);
        EXPECT_TRUE(is_zero(product));
      }
    }
  }
}

Degrees degrees(const SC::Rational_bisector_3& bisector) { return {bisector.degree(0), bisector.degree(1)}; }

// Whether equation(x, y, z, w) is the polynomial zero on all pieces.
template <class Equation>
bool satisfies(const SC::Rational_bisector_3& bisector, const Equation& equation)
{
  bool result = !bisector.pieces().empty();
  for (const Piece& piece : bisector.pieces()) {
    const auto& [x, y, z, w] = piece.coordinates();
    result = result && is_zero(equation(x, y, z, w));
  }
  return result;
}

Surface bezier_surface(int p, int q, const std::vector<Point>& points)
{
  std::vector<Number> u(p + 1, Number(0)), v(q + 1, Number(0));
  u.resize(2 * p + 2, Number(1));
  v.resize(2 * q + 2, Number(1));
  return Surface({p, q}, u, v, points);
}

// The rotation of a quaternion of integers, and a translation.
K::Aff_transformation_3 rotation(int a, int b, int c, int d)
{
  return {a * a + b * b - c * c - d * d, 2 * (b * c - a * d),           2 * (b * d + a * c),           a,
          2 * (b * c + a * d),           a * a - b * b + c * c - d * d, 2 * (c * d - a * b),           1,
          2 * (b * d - a * c),           2 * (c * d + a * b),           a * a - b * b - c * c + d * d, 2,
          a * a + b * b + c * c + d * d};
}

template <class Function>
std::string message_of(const Function& function)
{
  try {
    function();
  } catch (const SC::Invalid_input& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST(Rational_bisectors_3, point_and_plane_have_a_paraboloid)
{
  const Surface plane = bezier_surface(1, 1, {{-1, -1, 0}, {-1, 2, 0}, {3, -1, 0}, {3, 2, 0}});
  const auto bisector = SC::point_surface_bisector(Point(0, 0, 1), plane);
  EXPECT_EQ(degrees(bisector), Degrees(2, 2));
  check_centers(bisector);
  EXPECT_TRUE(satisfies(bisector, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(2) * z * w - x * x - y * y - w * w;
  }));
  ASSERT_TRUE(bisector.is_free_of_poles());
  const Surface surface = bisector.pieces()[0].surface();
  EXPECT_EQ(surface(Number(1, 3), Number(1, 5)), bisector.point(Number(1, 3), Number(1, 5)));
  EXPECT_EQ(bisector.foot(0, Number(1, 3), Number(1, 5)), Point(0, 0, 1));
  EXPECT_EQ(bisector.foot(1, Number(1, 3), Number(1, 5)), plane(Number(1, 3), Number(1, 5)));
}

TEST(Rational_bisectors_3, point_and_sphere_have_an_ellipsoid_or_a_hyperboloid)
{
  const Surface sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  const auto ellipsoid = SC::point_surface_bisector(Point(Number(1, 2), 0, 0), sphere);
  EXPECT_EQ(degrees(ellipsoid), Degrees(2, 2));
  check_centers(ellipsoid);
  EXPECT_TRUE(ellipsoid.is_free_of_poles());
  EXPECT_TRUE(satisfies(ellipsoid, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(3) * squared(Number(4) * x - w) + Number(64) * (y * y + z * z) - Number(12) * w * w;
  }));

  const auto hyperboloid = SC::point_surface_bisector(Point(2, 0, 0), sphere);
  EXPECT_EQ(degrees(hyperboloid), Degrees(2, 2));
  check_centers(hyperboloid);
  EXPECT_FALSE(hyperboloid.is_free_of_poles());
  EXPECT_TRUE(satisfies(hyperboloid, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(12) * squared(x - w) - Number(4) * (y * y + z * z) - Number(3) * w * w;
  }));
}

TEST(Rational_bisectors_3, point_on_a_sphere_has_its_center)
{
  const auto bisector = SC::point_surface_bisector(Point(0, 1, 0), SC::sphere_surface(Point(0, 0, 0), Number(1)));
  EXPECT_EQ(degrees(bisector), Degrees(0, 0));
  check_centers(bisector);
  ASSERT_TRUE(bisector.is_free_of_poles());
  EXPECT_EQ(bisector.pieces()[0].surface()(Number(1, 2), Number(1, 3)), Point(0, 0, 0));
}

TEST(Rational_bisectors_3, point_on_the_axis_of_a_cylinder_a_cone_and_a_torus)
{
  const auto tube = SC::point_surface_bisector(Point(0, 0, 1), SC::cylinder_surface<K>(Point(0, 0, 0), 2, 5));
  EXPECT_EQ(degrees(tube), Degrees(2, 2));
  check_centers(tube);
  EXPECT_TRUE(satisfies(tube, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(16) * (x * x + y * y) * w * w - squared(Number(4) * w * w - squared(z - w));
  }));

  const auto of_cone =
      SC::point_surface_bisector(Point(0, 0, 2), SC::cone_surface(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4)));
  EXPECT_EQ(degrees(of_cone), Degrees(2, 2));
  check_centers(of_cone);
  EXPECT_TRUE(satisfies(of_cone, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    const Tensor square = x * x + y * y; // of the distance from the axis
    return squared(Number(9) * (z * z - square) - Number(25) * squared(z - Number(2) * w)) -
        Number(576) * z * z * square;
  }));

  const Number major(3), minor(1), difference(major * major - minor * minor);
  const auto of_torus = SC::point_surface_bisector(Point(0, 0, 0), SC::torus_surface(Point(0, 0, 0), major, minor));
  EXPECT_EQ(degrees(of_torus), Degrees(2, 2));
  check_centers(of_torus);
  EXPECT_FALSE(of_torus.is_free_of_poles());
  EXPECT_TRUE(satisfies(of_torus, [&](const auto& x, const auto& y, const auto& z, const auto& w) {
    const Tensor square = x * x + y * y;
    return squared(Number(difference * difference) * w * w + Number(4 * major * major) * square -
                   Number(4 * minor * minor) * (square + z * z)) -
        Number(16 * difference * difference * major * major) * square * w * w;
  }));
}

TEST(Rational_bisectors_3, two_spheres)
{
  const Surface first = SC::sphere_surface(Point(-2, 0, 0), Number(1));
  const Point center(2, 0, 0);
  const auto one_sheet = SC::sphere_surface_bisector(center, Number(2), first);
  EXPECT_EQ(degrees(one_sheet), Degrees(2, 2));
  check_centers(one_sheet);
  EXPECT_TRUE(satisfies(one_sheet, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(60) * x * x - Number(4) * (y * y + z * z) - Number(15) * w * w;
  }));
  // Between the spheres, outside of both.
  EXPECT_EQ(one_sheet.point(3, 1), Point(Number(-1, 2), 0, 0));
  EXPECT_EQ(one_sheet.foot(0, 3, 1), Point(0, 0, 0));
  EXPECT_EQ(one_sheet.foot(1, 3, 1), Point(-1, 0, 0));

  const auto other_sheet = SC::sphere_surface_bisector(center, Number(-2), first);
  check_centers(other_sheet);
  EXPECT_TRUE(satisfies(other_sheet, [](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(28) * x * x - Number(36) * (y * y + z * z) - Number(63) * w * w;
  }));

  const auto plane = SC::sphere_surface_bisector(center, Number(1), first);
  check_centers(plane);
  EXPECT_TRUE(satisfies(plane, [](const auto& x, const auto&, const auto&, const auto&) { return x; }));
}

TEST(Rational_bisectors_3, spheres_and_surfaces_with_rational_normals)
{
  std::mt19937 random(17);
  std::uniform_int_distribution<int> integer(-4, 4);
  const Point q(Number(1, 3), Number(-2, 5), Number(7, 4));
  for (int k = 0; k < 2; ++k) {
    const K::Aff_transformation_3 motion = rotation(1 + k, integer(random), integer(random), integer(random));
    for (const Surface& surface :
         {SC::plane_patch<K>(Point(0, 0, 0), Vector(1, 0, 0), Vector(0, 2, 0)),
          SC::sphere_surface(Point(0, 0, 0), Number(3, 2)), SC::cylinder_surface<K>(Point(0, 0, 0), 2, 5),
          SC::cone_surface(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4)), SC::torus_surface<K>(Point(0, 0, 0), 3, 1),
          SC::dupin_cyclide_surface<K>(5, 4, 3, 4)})
      for (const Number& radius : {Number(1, 2), Number(-3, 4)}) {
        const Surface moved = surface.transformed(motion);
        const auto bisector = SC::sphere_surface_bisector(q, radius, moved);
        EXPECT_EQ(degrees(bisector), Degrees(2, 2));
        check_centers(bisector);
        // Of the center and the offset.
        const auto offset = SC::rational_offset(moved, Number(-radius));
        ASSERT_TRUE(offset);
        const auto of_offset = SC::point_surface_bisector(q, *offset);
        for (const Piece& piece : bisector.pieces()) {
          const Number u = (piece.domain()[0].first * 3 + piece.domain()[0].second) / 4,
                       v = (piece.domain()[1].first * 2 + piece.domain()[1].second) / 3;
          EXPECT_EQ(bisector.point(u, v), of_offset.point(u, v));
          EXPECT_EQ((bisector.foot(0, u, v) - q).squared_length(), Number(radius * radius));
        }
      }
  }
  EXPECT_NE(message_of([&] {
              SC::sphere_surface_bisector(Point(0, 0, 5), Number(1),
                                          bezier_surface(1, 1, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}));
            }).find("the piece [0, 1] x [0, 1] has no rational unit normal"),
            std::string::npos);
  // A sphere that touches a cylinder from inside: the offset is its axis.
  EXPECT_NE(message_of([&] {
              SC::sphere_surface_bisector(Point(0, 0, 1), Number(2), SC::cylinder_surface<K>(Point(0, 0, 0), 2, 5));
            }).find("pass through the point"),
            std::string::npos);
}

TEST(Rational_bisectors_3, quadrics_and_tori_keep_the_lowest_degree_in_general_position)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> integer(-4, 4);
  for (int k = 0; k < 20; ++k) {
    const K::Aff_transformation_3 motion = rotation(1 + k, integer(random), integer(random), integer(random));
    const Point q(Number(1, 3), Number(-2, 5), Number(Number(7 + k) / 4));
    for (const Surface& surface :
         {SC::sphere_surface(Point(0, 0, 0), Number(3, 2)), SC::cylinder_surface<K>(Point(0, 0, 0), 2, 5),
          SC::cone_surface(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4)), SC::torus_surface<K>(Point(0, 0, 0), 3, 1),
          SC::dupin_cyclide_surface<K>(5, 4, 3, 4)}) {
      const auto bisector = SC::point_surface_bisector(q, surface.transformed(motion));
      EXPECT_EQ(degrees(bisector), Degrees(2, 2));
      check_centers(bisector);
    }
  }
}

TEST(Rational_bisectors_3, polynomial_surfaces)
{
  // z = u^2 + v^2.
  const Number half(1, 2);
  const Surface bowl = bezier_surface(2, 2,
                                      {{0, 0, 0},
                                       {0, half, 0},
                                       {0, 1, 1},
                                       {half, 0, 0},
                                       {half, half, 0},
                                       {half, 1, 1},
                                       {1, 0, 1},
                                       {1, half, 1},
                                       {1, 1, 2}});
  const auto of_bowl = SC::point_surface_bisector(Point(0, 0, 1), bowl);
  EXPECT_EQ(degrees(of_bowl), Degrees(5, 5));
  check_centers(of_bowl);

  std::mt19937 random(11);
  std::uniform_int_distribution<int> integer(-99, 99);
  std::vector<Point> points;
  for (int i = 0; i < 16; ++i)
    points.emplace_back(integer(random), integer(random), integer(random));
  const auto of_bicubic = SC::point_surface_bisector(Point(5, -7, 300), bezier_surface(3, 3, points));
  EXPECT_EQ(degrees(of_bicubic), Degrees(11, 11));
  check_centers(of_bicubic);

  // Turned, it is the same one, turned.
  std::uniform_int_distribution<int> small(-3, 3);
  const Number u(1, 3), v(2, 7);
  for (int k = 0; k < 20; ++k) {
    const K::Aff_transformation_3 motion = rotation(1 + k, small(random), small(random), small(random));
    const auto turned = SC::point_surface_bisector(motion.transform(Point(5, -7, 300)),
                                                   bezier_surface(3, 3, points).transformed(motion));
    EXPECT_EQ(degrees(turned), Degrees(11, 11));
    EXPECT_EQ(turned.point(u, v), motion.transform(of_bicubic.point(u, v)));
  }
}

TEST(Rational_bisectors_3, the_kernel_of_doubles_and_several_pieces)
{
  using D = CGAL::Simple_cartesian<double>;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 0.25);
  std::vector<D::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      points.emplace_back(i + number(random), j + number(random), number(random));
  const SC::Bspline_surface_3<D> surface({2, 2}, {0, 0, 0, 1, 2, 2, 2}, {0, 0, 0, 1, 1, 1}, points);
  const auto bisector = SC::point_surface_bisector(D::Point_3(1, 1, 50), surface);
  ASSERT_EQ(bisector.pieces().size(), 2u);
  EXPECT_EQ(degrees(bisector), Degrees(7, 7));
  check_centers(bisector);
  ASSERT_TRUE(bisector.is_free_of_poles());
  // The surface is smooth at the break, so the bisector is continuous.
  EXPECT_EQ(bisector.pieces()[0].point(1, Number(2, 3)), bisector.pieces()[1].point(1, Number(2, 3)));
}

TEST(Rational_bisectors_3, parts_without_poles)
{
  const Surface sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  const auto bisector = SC::point_surface_bisector(Point(0, 2, 0), sphere);
  std::size_t with_poles = 0;
  for (const Piece& piece : bisector.pieces())
    if (!piece.is_free_of_poles()) {
      ++with_poles;
      EXPECT_THROW(piece.surface(), SC::Invalid_input);
    }
  EXPECT_GT(with_poles, 0u);
  // Around the foot next to the point.
  const auto box = [](const Number& u, const Number& v, const Number& size) {
    return std::array{SC::Rational_bisector_3::Range(u, Number(u + size)),
                      SC::Rational_bisector_3::Range(v, Number(v + size))};
  };
  const Surface part = bisector.part(box(0, 1, Number(1, 8)));
  EXPECT_EQ(part(0, 1), Point(0, Number(3, 2), 0));
  EXPECT_EQ(part(Number(1, 16), Number(17, 16)), bisector.point(Number(1, 16), Number(17, 16)));
  EXPECT_THROW(bisector.part(box(0, 1, Number(0))), SC::Invalid_input);
  EXPECT_THROW(bisector.part(box(0, 1, Number(100))), SC::Invalid_input);
  EXPECT_THROW(bisector.point(-1, 1), SC::Invalid_input);
}

TEST(Rational_bisectors_3, point_and_curves)
{
  const Number h(2);
  const std::pair<Number, Number> range(-1, 1);
  const Curve line = SC::bezier_curve(std::vector<Point>{{0, 0, 0}, {1, 0, 0}});
  const auto parabolic_cylinder = SC::point_curve_bisector_surface(Point(0, 0, h), line, range);
  EXPECT_EQ(degrees(parabolic_cylinder), Degrees(2, 1));
  check_centers(parabolic_cylinder);
  EXPECT_TRUE(parabolic_cylinder.is_free_of_poles());
  EXPECT_TRUE(satisfies(parabolic_cylinder, [&](const auto& x, const auto&, const auto& z, const auto& w) {
    return Number(2 * h) * z * w - x * x - Number(h * h) * w * w;
  }));
  EXPECT_NE(parabolic_cylinder.point(0, -1), parabolic_cylinder.point(0, 1));

  const Curve parabola = SC::bezier_curve(std::vector<Point>{{0, 0, 0}, {1, 2, 0}, {3, 1, 4}});
  const auto of_parabola = SC::point_curve_bisector_surface(Point(5, -7, 3), parabola, range);
  EXPECT_EQ(degrees(of_parabola), Degrees(7, 1));
  check_centers(of_parabola);

  const Curve cubic = SC::bezier_curve(std::vector<Point>{{0, 0, 0}, {1, 2, 0}, {3, 1, 4}, {-2, 3, 5}});
  const auto of_cubic = SC::point_curve_bisector_surface(Point(5, -7, 3), cubic, range);
  EXPECT_EQ(degrees(of_cubic), Degrees(12, 1));
  check_centers(of_cubic);

  // A circle and a point on its axis: the cone rho = h z + (1 - h^2) / 2.
  const Curve circle = SC::circle_curve(Point(0, 0, 0), Vector(0, 0, 1), Point(1, 0, 0));
  const auto cone = SC::point_curve_bisector_surface(Point(0, 0, h), circle, range);
  check_centers(cone);
  EXPECT_TRUE(cone.is_free_of_poles());
  EXPECT_TRUE(satisfies(cone, [&](const auto& x, const auto& y, const auto& z, const auto& w) {
    return x * x + y * y - squared(h * z + Number((1 - h * h) / 2) * w);
  }));
}

TEST(Rational_bisectors_3, two_curves)
{
  const Number h(3, 2);
  const Curve first = SC::bezier_curve(std::vector<Point>{{-1, 0, -h}, {2, 0, -h}}),
              second = SC::bezier_curve(std::vector<Point>{{0, -1, h}, {0, 3, h}});
  const auto paraboloid = SC::curve_bisector_surface(first, second);
  EXPECT_EQ(degrees(paraboloid), Degrees(2, 2));
  check_centers(paraboloid);
  EXPECT_TRUE(paraboloid.is_free_of_poles());
  EXPECT_TRUE(satisfies(paraboloid, [&](const auto& x, const auto& y, const auto& z, const auto& w) {
    return Number(4 * h) * z * w - x * x + y * y;
  }));
  EXPECT_EQ(paraboloid.foot(0, Number(1, 3), 0), first(Number(1, 3)));
  EXPECT_EQ(paraboloid.foot(1, Number(1, 3), 0), second(0));

  const auto of_parabolas =
      SC::curve_bisector_surface(SC::bezier_curve(std::vector<Point>{{0, 0, 0}, {1, 2, 0}, {3, 1, 4}}),
                                 SC::bezier_curve(std::vector<Point>{{5, 1, 7}, {-3, 2, 9}, {2, -8, 3}}));
  EXPECT_EQ(degrees(of_parabolas), Degrees(5, 5));
  check_centers(of_parabolas);

  // An axis and a circle around it, of radius 1: rho = (z^2 + 1) / 2.
  const Curve axis = SC::bezier_curve(std::vector<Point>{{0, 0, -1}, {0, 0, 3}}),
              circle = SC::circle_curve(Point(0, 0, 0), Vector(0, 0, 1), Point(1, 0, 0)),
              other = SC::circle_curve(Point(5, 1, 2), Vector(1, 2, 2), Point(7, 0, 2));
  EXPECT_EQ(degrees(SC::curve_bisector_surface(axis, circle)), Degrees(2, 2));
  check_centers(SC::curve_bisector_surface(axis, circle));
  const auto of_circles = SC::curve_bisector_surface(circle, other);
  EXPECT_EQ(degrees(of_circles), Degrees(2, 2));
  check_centers(of_circles);
}

TEST(Rational_bisectors_3, what_has_no_bisector_surface_is_refused)
{
  const Curve line = SC::bezier_curve(std::vector<Point>{{0, 0, 0}, {1, 1, 1}}),
              parallel = SC::bezier_curve(std::vector<Point>{{0, 0, 1}, {1, 1, 2}});
  EXPECT_NE(message_of([&] { SC::curve_bisector_surface(line, parallel); }).find("bisector_curves()"),
            std::string::npos);
  const std::pair<Number, Number> range(0, 1);
  EXPECT_NE(message_of([&] {
              SC::point_curve_bisector_surface(Point(3, 3, 3), line, range);
            }).find("on a line through the point"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              SC::point_curve_bisector_surface(Point(3, 3, 4), line, {1, 1});
            }).find("empty"),
            std::string::npos);
  const Surface plane = bezier_surface(1, 1, {{-1, -1, 0}, {-1, 2, 0}, {3, -1, 0}, {3, 2, 0}});
  EXPECT_NE(message_of([&] { SC::point_surface_bisector(Point(7, 8, 0), plane); }).find("pass through the point"),
            std::string::npos);
  const Surface cone = SC::cone_surface(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4));
  EXPECT_NE(message_of([&] { SC::point_surface_bisector(Point(0, 0, 0), cone); }).find("pass through the point"),
            std::string::npos);
  const Surface segment = bezier_surface(1, 1, {{0, 0, 0}, {0, 0, 0}, {3, 2, 0}, {3, 2, 0}});
  EXPECT_NE(message_of([&] { SC::point_surface_bisector(Point(0, 0, 1), segment); }).find("is a curve or a point"),
            std::string::npos);
}

TEST(Rational_bisectors_3, limits_end_with_the_pieces_that_were_found)
{
  const Surface sphere = SC::sphere_surface(Point(0, 0, 0), Number(1));
  const Point q(Number(1, 2), 0, 0);
  const auto whole = SC::point_surface_bisector(q, sphere, {.time_limit = 1000, .node_limit = 1000});
  check_centers(whole);
  EXPECT_EQ(whole.summary().nodes, whole.pieces().size());

  const auto partial = SC::point_surface_bisector(q, sphere, {.node_limit = 3});
  EXPECT_FALSE(partial.is_complete());
  EXPECT_FALSE(partial.is_free_of_poles());
  EXPECT_EQ(partial.pieces().size(), 3u);
  EXPECT_EQ(partial.summary().why_not, SC::Undecided_reason::NODES);
  ASSERT_EQ(partial.undecided().size(), whole.pieces().size() - 3);
  const auto& part = partial.undecided().front();
  ASSERT_EQ(part.parameters.size(), 1u);
  EXPECT_EQ(part.parameters[0].operand, 1u);
  EXPECT_EQ(part.parameters[0].ranges.size(), 2u);
  EXPECT_FALSE(part.reason.empty());
  const auto& missing = whole.pieces()[3].domain();
  EXPECT_THROW(partial.part(missing), SC::Invalid_input);

  EXPECT_TRUE(SC::point_surface_bisector(q, sphere, {.time_limit = 1e-9}).pieces().empty());
}

} // namespace rational_bisectors_3_test
