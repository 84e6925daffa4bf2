// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/concepts.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <limits>

namespace Bspline_surface_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = Exact_rational;
using Surface = SC::Bspline_surface_3<Exact_cartesian>;
using Double_surface = SC::Bspline_surface_3<Double_cartesian>;
using Point = Exact_cartesian::Point_3;
using Vector = Exact_cartesian::Vector_3;

constexpr int rounds = 12;

Surface random_surface(Random_geometry& random)
{
  const std::array<int, 2> degrees{random.integer(1, 3), random.integer(1, 3)};
  const std::array<std::vector<FT>, 2> knots{random.knots(degrees[0], degrees[0]),
                                             random.knots(degrees[1], degrees[1])};
  const std::size_t count = (knots[0].size() - degrees[0] - 1) * (knots[1].size() - degrees[1] - 1);
  return Surface(degrees, knots[0], knots[1], random.points<Exact_cartesian, 3>(count),
                 random.integer(0, 1) == 1 ? random.weights(count) : std::vector<FT>());
}

// The least that models the concepts: lines and planes.
struct Line_2
{
  using Kernel = Exact_cartesian;
  static constexpr int number_of_parameters = 1;

  std::array<SC::Bspline_function<FT>, 2> homogeneous_coordinates() const
  {
    const SC::Bspline_function<FT> t({1}, {{0, 0, 1, 1}}, {0, 1});
    return {t, t + FT(1)};
  }
  SC::Bspline_function<FT> weight() const { return SC::Bspline_function<FT>({0}, {{0, 1}}, {1}); }
  bool is_rational() const { return false; }
  std::pair<FT, FT> domain(int) const { return {0, 1}; }
  Kernel::Point_2 operator()(const FT& t) const { return {t, t + 1}; }
};

struct Plane_3
{
  using Kernel = Exact_cartesian;
  static constexpr int number_of_parameters = 2;

  std::array<SC::Bspline_function<FT>, 3> homogeneous_coordinates() const
  {
    const SC::Bspline_function<FT> t({1}, {{0, 0, 1, 1}}, {0, 1});
    const SC::Bspline_function<FT> u = t.embedded({{0, 1}, {0, 1}}, {0}), v = t.embedded({{0, 1}, {0, 1}}, {1});
    return {u, v, u + v};
  }
  SC::Bspline_function<FT> weight() const { return SC::Bspline_function<FT>({0, 0}, {{0, 1}, {0, 1}}, {1}); }
  bool is_rational() const { return false; }
  std::pair<FT, FT> domain(int) const { return {0, 1}; }
  Kernel::Point_3 operator()(const FT& u, const FT& v) const { return {u, v, u + v}; }
};

static_assert(SC::ParametricCurve_2<Line_2>);
static_assert(!SC::ParametricCurve_3<Line_2>);
static_assert(!SC::ParametricSurface_3<Line_2>);
static_assert(SC::ParametricSurface_3<Plane_3>);
static_assert(!SC::ParametricCurve_3<Plane_3>);
static_assert(SC::ParametricCurve_2<SC::Bspline_curve<CGAL::Epeck, 2>>);
static_assert(SC::ParametricCurve_3<SC::Bspline_curve<CGAL::Epick, 3>>);
static_assert(!SC::ParametricCurve_2<SC::Bspline_curve<CGAL::Epick, 3>>);
static_assert(SC::ParametricSurface_3<SC::Bspline_surface_3<Double_cartesian>>);
static_assert(!SC::ParametricSurface_3<int>);
static_assert(SC::SplineKernel<CGAL::Simple_cartesian<float>>);
static_assert(SC::SplineKernel<CGAL::Simple_cartesian<CGAL::Gmpq>>);
static_assert(!SC::SplineKernel<CGAL::Simple_cartesian<CGAL::Interval_nt<false>>>);
static_assert(!SC::SplineKernel<CGAL::Simple_cartesian<int>>);
static_assert(!SC::SplineKernel<CGAL::Simple_cartesian<SC::Exact_integer>>);
static_assert(!SC::SplineKernel<int>);

// What any model promises: points are quotients of the homogeneous coordinates.
template <class Map, class... Parameters>
void check_promises(const Map& map, const Parameters&... parameters)
{
  using SC::internal::converted_number;
  const std::vector<FT> u{converted_number<FT>(parameters)...};
  const auto p = map(parameters...);
  const auto numerators = map.homogeneous_coordinates();
  ASSERT_EQ(map.weight().dimension(), static_cast<int>(u.size()));
  for (std::size_t i = 0; i < numerators.size(); ++i)
    EXPECT_EQ(converted_number<FT>(p.cartesian(static_cast<int>(i))), FT(numerators[i](u) / map.weight()(u)));
  for (int axis = 0; axis < static_cast<int>(u.size()); ++axis)
    EXPECT_EQ(converted_number<FT>(map.domain(axis).second), map.weight().domain(axis).second);
}

TEST(Parametric_concepts, models_keep_their_promises)
{
  check_promises(Line_2(), FT(1) / FT(3));
  check_promises(Plane_3(), FT(1) / FT(3), FT(1) / FT(4));
  Random_geometry random(1);
  for (int i = 0; i < rounds; ++i) {
    check_promises(random_surface(random), random.fraction(), random.fraction());
    check_promises(random.curve<Exact_cartesian, 2>(), random.fraction());
    check_promises(random.curve<CGAL::Epeck, 3>(), CGAL::Epeck::FT(random.fraction()));
  }
}

template <class Kernel>
class Surface_in_kernel
  : public testing::Test
{
};

using Kernels =
    testing::Types<Double_cartesian, CGAL::Epick, CGAL::Epeck, Exact_cartesian, CGAL::Simple_cartesian<CGAL::Gmpq>>;
TYPED_TEST_SUITE(Surface_in_kernel, Kernels, );

// z = u v and short dyadic numbers: exact in every kernel.
TYPED_TEST(Surface_in_kernel, evaluates_and_operates)
{
  using Kernel = TypeParam;
  using FT = typename Kernel::FT;
  using P = typename Kernel::Point_3;
  using V = typename Kernel::Vector_3;
  const std::vector<FT> knots{0, 0, 2, 2};
  const SC::Bspline_surface_3<Kernel> saddle({1, 1}, knots, knots, {{0, 0, 0}, {0, 2, 0}, {2, 0, 0}, {2, 2, 4}});
  EXPECT_EQ(saddle(0.5, 1.5), P(0.5, 1.5, 0.75));
  EXPECT_EQ(saddle.derivative(0.5, 1.5, 1, 0), V(1, 0, 1.5));
  EXPECT_EQ(saddle.derivative(0.5, 1.5, 1, 1), V(0, 0, 1));
  EXPECT_EQ(saddle.derivative(0.5, 1.5, 0, 2), V(0, 0, 0));
  EXPECT_EQ(saddle.normal(0.5, 1.5), V(-1.5, -0.5, 1));
  EXPECT_EQ(saddle.gaussian_curvature(0, 0), -1);
  EXPECT_EQ(saddle.gaussian_curvature(1, 0), -0.25);
  EXPECT_EQ(saddle.mean_curvature(0, 0), 0);
  EXPECT_TRUE(saddle.transposed()(1.5, 0.5) == saddle(0.5, 1.5));
  EXPECT_EQ(saddle.iso_curve(0, 0.5)(1.5), saddle(0.5, 1.5));
  EXPECT_EQ(saddle.iso_curve(1, 2)(0.5), saddle(0.5, 2));
  EXPECT_EQ(saddle.bbox(), CGAL::Bbox_3(0, 0, 0, 2, 2, 4));
  EXPECT_EQ(saddle.reversed(1)(0.5, 0.5), saddle(0.5, 1.5));
  EXPECT_EQ(saddle.split(0, 1).first(0.5, 1.5), saddle(0.5, 1.5));
  EXPECT_TRUE(saddle.with_knot(0, 1) == saddle);
  EXPECT_TRUE(saddle.with_knot(0, 1).without_knot(0, 1));
  EXPECT_FALSE(saddle == saddle.reversed(0));
  const SC::Bspline_surface_3<Exact_cartesian> exact(saddle);
  EXPECT_TRUE(SC::Bspline_surface_3<Kernel>(exact) == saddle);
}

TEST(Bspline_surface_3, operations_keep_the_points)
{
  Random_geometry random(2);
  for (int i = 0; i < rounds; ++i) {
    const Surface surface = random_surface(random);
    const FT u = random.fraction(), v = random.fraction(), knot = FT(random.integer(1, 40)) / FT(41);
    const Point p = surface(u, v);
    const int axis = random.integer(0, 1);

    const Surface elevated = surface.elevated({surface.degree(0) + 1, surface.degree(1) + 2});
    EXPECT_EQ(elevated(u, v), p);
    EXPECT_TRUE(elevated == surface);
    const Surface finer = surface.with_knot(axis, knot);
    EXPECT_EQ(finer(u, v), p);
    ASSERT_TRUE(finer.without_knot(axis, knot));
    EXPECT_EQ(finer.without_knot(axis, knot)->control_points(), surface.control_points());
    const auto [before, after] = surface.split(axis, knot);
    EXPECT_EQ(((axis == 0 ? u : v) <= knot ? before : after)(u, v), p);
    EXPECT_EQ(surface.reversed(0)(FT(1) - u, v), p);
    EXPECT_EQ(surface.reversed(1)(u, FT(1) - v), p);
    EXPECT_EQ(surface.transposed()(v, u), p);
    EXPECT_TRUE(surface.transposed().transposed() == surface);
    EXPECT_EQ(surface.iso_curve(0, u)(v), p);
    EXPECT_EQ(surface.iso_curve(1, v)(u), p);
    const Exact_cartesian::Aff_transformation_3 map(1, 2, 0, 5, 0, FT(1) / FT(3), 1, 0, 4, 0, -1, 7);
    EXPECT_EQ(surface.transformed(map)(u, v), map.transform(p));

    const std::vector<Surface> pieces = surface.bezier_pieces();
    ASSERT_EQ(pieces.size(), (surface.breaks(0).size() - 1) * (surface.breaks(1).size() - 1));
    int holders = 0;
    for (const Surface& piece : pieces)
      if (piece.domain(0).first <= u && u <= piece.domain(0).second && piece.domain(1).first <= v &&
          v <= piece.domain(1).second) {
        EXPECT_EQ(piece(u, v), p);
        ++holders;
      }
    EXPECT_GE(holders, 1);

    const CGAL::Bbox_3 box = surface.bbox();
    for (int j = 0; j < 3; ++j) {
      EXPECT_LE(FT((box.min)(j)), p.cartesian(j));
      EXPECT_LE(p.cartesian(j), FT((box.max)(j)));
    }
  }
}

TEST(Bspline_surface_3, derivatives_are_those_of_iso_curves)
{
  Random_geometry random(3);
  for (int i = 0; i < rounds; ++i) {
    const Surface surface = random_surface(random);
    const FT u = random.fraction(), v = random.fraction();
    for (int r = 0; r <= 3; ++r) {
      EXPECT_EQ(surface.derivative(u, v, r, 0), surface.iso_curve(1, v).derivative(u, r));
      EXPECT_EQ(surface.derivative(u, v, 0, r), surface.iso_curve(0, u).derivative(v, r));
    }
    EXPECT_EQ(surface.normal(u, v),
              CGAL::cross_product(surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)));
    // w S_uv + w_u S_v + w_v S_u + w_uv S = n_uv.
    const auto numerators = surface.homogeneous_coordinates();
    const SC::Bspline_function<FT> one({0, 0}, {{0, 1}, {0, 1}}, {1});
    const Surface n = Surface::from_homogeneous_coordinates(numerators, one);
    const Surface w =
        Surface::from_homogeneous_coordinates({surface.weight(), surface.weight(), surface.weight()}, one);
    const Vector mixed = surface.derivative(u, v, 1, 1) * w(u, v).x() +
        surface.derivative(u, v, 0, 1) * w.derivative(u, v, 1, 0).x() +
        surface.derivative(u, v, 1, 0) * w.derivative(u, v, 0, 1).x() +
        (surface(u, v) - CGAL::ORIGIN) * w.derivative(u, v, 1, 1).x();
    EXPECT_EQ(mixed, n.derivative(u, v, 1, 1));
  }
}

TEST(Bspline_surface_3, curvature_of_a_paraboloid_follows_its_formula)
{
  // z = u^2 + v^2 at (u, v): K = 4 / (1 + 4 u^2 + 4 v^2)^2, H = (2 + 4 u^2 + 4 v^2) / (1 + 4 u^2 + 4 v^2)^(3/2).
  std::vector<Point> points;
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; j <= 2; ++j)
      points.emplace_back(FT(i) / FT(2), FT(j) / FT(2), FT((i == 2) + (j == 2)));
  const std::vector<FT> knots{0, 0, 0, 1, 1, 1};
  const Surface paraboloid({2, 2}, knots, knots, points);
  Random_geometry random(4);
  for (int i = 0; i < rounds; ++i) {
    const FT u = random.fraction(), v = random.fraction(), s = FT(4) * (u * u + v * v);
    ASSERT_EQ(paraboloid(u, v).z(), FT(u * u + v * v));
    EXPECT_EQ(paraboloid.gaussian_curvature(u, v), FT(4) / ((s + 1) * (s + 1)));
    EXPECT_EQ(paraboloid.squared_mean_curvature(u, v), (s + 2) * (s + 2) / ((s + 1) * (s + 1) * (s + 1)));
    EXPECT_GT(paraboloid.mean_curvature(u, v), 0);
    EXPECT_LT(paraboloid.transposed().mean_curvature(v, u), 0);
  }
}

TEST(Bspline_surface_3, periodic_axes_are_unwrapped)
{
  Random_geometry random(5);
  const std::vector<FT> period{0, 1, 3, 4}, clamped{0, 0, 0, 1, 1, 1};
  const std::vector<Point> points = random.points<Exact_cartesian, 3>(9);
  const std::vector<FT> weights = random.weights(9);
  const Surface tube = Surface::from_periodic({2, 2}, period, clamped, points, {true, false}, weights);
  EXPECT_TRUE(tube.is_closed(0));
  EXPECT_FALSE(tube.is_closed(1));
  EXPECT_EQ(tube.size(0), 5u);
  EXPECT_EQ(tube.size(1), 3u);
  EXPECT_EQ(tube.iso_curve(1, 0)(FT(1) / 2),
            (SC::Bspline_curve_3<Exact_cartesian>::from_periodic(2, period, {points[0], points[3], points[6]},
                                                                 {weights[0], weights[3], weights[6]})(FT(1) / 2)));
  const Surface torus = Surface::from_periodic({2, 2}, period, period, points, {true, true}, weights);
  EXPECT_TRUE(torus.is_closed(0) && torus.is_closed(1));
  EXPECT_EQ(torus.derivative(0, 1, 1, 0), torus.bezier_pieces()[6 + 1].derivative(4, 1, 1, 0));
}

TEST(Bspline_surface_3, rejects_bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using S = Double_surface;
  const std::vector<double> k{0, 0, 1, 1};
  const std::vector<Double_cartesian::Point_3> points{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}};
  expect_invalid([&] { S({1, 2}, k, k, points); }, "axis 1");
  expect_invalid([&] { S({1, 1}, k, {0, 0, 0.5, 1, 1}, points); }, "4 where 6");
  expect_invalid([&] { S({1, 1}, k, {0, 1, 0, 1}, points); }, "axis 1: knot 2");
  expect_invalid([&] { S({1, 1}, k, k, points, {1, 1, 1}); }, "weights: 3 where 4");
  expect_invalid([&] { S({1, 1}, k, k, points, {1, 1, 1, -2}); }, "control weight 3");
  expect_invalid([&] { S({1, 1}, k, k, points, {1, 0, 1, 1}); }, "weight 1 is zero");
  expect_invalid([&] { S({1, 1}, k, k, points, {1, nan, 1, 1}); }, "weight 1 is not");
  const S surface({1, 1}, k, k, points), flat({1, 1}, k, k, {points[0], points[0], points[2], points[2]});
  expect_invalid([&] { surface(0, 2); }, "parameter 1");
  expect_invalid([&] { surface(nan, 0); }, "parameter 0");
  expect_invalid([&] { surface.derivative(0, 0, -1, 1); }, "negative");
  expect_invalid([&] { flat.gaussian_curvature(0, 0); }, "singular");
  expect_invalid([&] { flat.mean_curvature(0, 0); }, "singular");
  expect_invalid([&] { surface.iso_curve(0, 2); }, "not within");
  expect_invalid([&] { S::from_periodic({1, 1}, k, k, points, {true, false}); }, "torn");
  expect_invalid([&] { S::from_periodic({1, 1}, {0, 1, 2}, {0, 1, 2}, {points[0]}, {true, true}); }, "1 where 4");
  expect_invalid([&] { S::from_periodic({1, 1}, {0, 1}, {0}, points, {true, false}); }, "too few knots");
}

} // namespace

} // namespace Bspline_surface_test
