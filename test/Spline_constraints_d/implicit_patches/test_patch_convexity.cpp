// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Convexity of functions and of implicit patches: answers known exactly, witnesses checked exactly, convex answers
// checked along random tangents, invariance under affine maps and positive factors, limits and stops.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/simplex_conversion.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/nearby_convex_function.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/parabolic_curves.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/patch_convexity.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace patch_convexity_test {

namespace SC = CGAL::Spline_constraints;
using FT = SC::Exact_rational;
using Polynomial = SC::Power_polynomial;
using Function = SC::Simplex_function_3;
using K = Function::Kernel;
using Kind = SC::Convexity_kind;

namespace {

const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1), z = Polynomial::variable(2);

FT fraction(int numerator, int denominator) { return FT(numerator) / FT(denominator); }

// The unit vectors and the origin.
K::Tetrahedron_3 standard_tetrahedron() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}; }

Function on_standard(const Polynomial& f) { return Function(standard_tetrahedron(), f); }

FT second_derivative(const Polynomial& f, const K::Point_3& p, const K::Vector_3& v)
{
  const std::vector<FT> at{p.x(), p.y(), p.z()};
  FT result(0);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result += FT(v.cartesian(i) * v.cartesian(j)) * f.derivative(i).derivative(j)(at);
  return result;
}

FT value(const Polynomial& f, const K::Point_3& p) { return f(std::vector<FT>{p.x(), p.y(), p.z()}); }

K::Vector_3 gradient(const Polynomial& f, const K::Point_3& p)
{
  return {value(f.derivative(0), p), value(f.derivative(1), p), value(f.derivative(2), p)};
}

bool contains(const K::Tetrahedron_3& tetrahedron, const K::Point_3& p)
{
  return tetrahedron.has_on_boundary(p) || tetrahedron.has_on_bounded_side(p);
}

// f <= 0 <= f at the ends, and the second derivative along tangents of the level surfaces has this sign, at many points
// of the segment.
void check_witness(const Function& function, const SC::Curvature_witness& witness, CGAL::Sign sign)
{
  const Polynomial f = function.polynomial();
  EXPECT_LE(value(f, witness.first), FT(0));
  EXPECT_GE(value(f, witness.second), FT(0));
  const K::Tetrahedron_3 tetrahedron(function.vertex(0), function.vertex(1), function.vertex(2), function.vertex(3));
  EXPECT_TRUE(contains(tetrahedron, witness.first));
  EXPECT_TRUE(contains(tetrahedron, witness.second));
  for (int k = 0; k <= 16; ++k) {
    const K::Point_3 p = witness.first + fraction(k, 16) * (witness.second - witness.first);
    const K::Vector_3 tangent = CGAL::cross_product(gradient(f, p), witness.axis);
    EXPECT_EQ(CGAL::sign(second_derivative(f, p, tangent)), sign);
  }
}

void check_witnesses(const Function& function, const SC::Patch_shape& patch)
{
  const SC::Convexity& answer = patch.convexity();
  EXPECT_EQ(CGAL::certainly(!answer.is_convex), patch.witness_against_convexity().has_value());
  EXPECT_EQ(CGAL::certainly(!answer.is_concave), patch.witness_against_concavity().has_value());
  if (patch.witness_against_convexity())
    check_witness(function, *patch.witness_against_convexity(), CGAL::NEGATIVE);
  if (patch.witness_against_concavity())
    check_witness(function, *patch.witness_against_concavity(), CGAL::POSITIVE);
  if (patch.witness_against_strictness()) {
    const Polynomial f = function.polynomial();
    const K::Segment_3 segment = *patch.witness_against_strictness();
    EXPECT_LE(value(f, segment.source()) * value(f, segment.target()), FT(0));
  }
}

void expect_kind(const Function& function, Kind kind)
{
  const SC::Patch_shape patch = SC::patch_convexity(function);
  EXPECT_EQ(patch.kind(), kind) << patch;
  EXPECT_TRUE(patch.is_complete()) << patch;
  check_witnesses(function, patch);
}

void expect_function_kind(const Function& function, Kind kind)
{
  const SC::Function_shape answer = SC::function_convexity(function);
  EXPECT_EQ(answer.kind(), kind) << answer;
  EXPECT_TRUE(answer.is_complete()) << answer;
  const Polynomial f = function.polynomial();
  EXPECT_EQ(CGAL::certainly(!answer.convexity().is_convex), answer.witness_against_convexity().has_value());
  if (const auto& witness = answer.witness_against_convexity()) {
    EXPECT_LT(second_derivative(f, witness->point, witness->direction), FT(0));
  }
  if (const auto& witness = answer.witness_against_concavity()) {
    EXPECT_GT(second_derivative(f, witness->point, witness->direction), FT(0));
  }
}

const Polynomial sphere = x * x + y * y + z * z - Polynomial(fraction(1, 4));
const Polynomial two_sheets = x * x + y * y - z * z + Polynomial(fraction(1, 16));
const Polynomial cubic = x * x * x + y * y * y + z * z * z - Polynomial(fraction(1, 8));
const Polynomial saddle = z - x * y - Polynomial(fraction(1, 8));
const Polynomial cylinder = x * x - z;

TEST(patch_convexity, OfKnownPatches)
{
  expect_kind(on_standard(sphere), Kind::STRICTLY_CONVEX);
  expect_kind(on_standard(two_sheets), Kind::STRICTLY_CONVEX);
  expect_kind(on_standard(cubic), Kind::CONVEX);
  expect_kind(on_standard(sphere * (Polynomial(1) + Polynomial(4) * x)), Kind::STRICTLY_CONVEX);
  expect_kind(on_standard(saddle), Kind::NEITHER);
  expect_kind(on_standard(-saddle), Kind::NEITHER);
  expect_kind(on_standard(cylinder), Kind::CONVEX);
  expect_kind(on_standard(-cylinder), Kind::CONCAVE);
  expect_kind(on_standard(-sphere), Kind::STRICTLY_CONCAVE);
  expect_kind(on_standard(x + y + z - Polynomial(fraction(1, 3))), Kind::BOTH);
  expect_kind(on_standard(sphere + Polynomial(1)), Kind::EMPTY);
  EXPECT_TRUE(CGAL::certainly(!SC::patch_convexity(on_standard(cubic)).convexity().is_strict));
  EXPECT_TRUE(CGAL::certainly(SC::patch_convexity(on_standard(cubic)).is_regular()));
  EXPECT_TRUE(CGAL::certainly(SC::patch_convexity(on_standard(sphere)).is_regular()));
}

TEST(patch_convexity, OfFunctions)
{
  expect_function_kind(on_standard(sphere), Kind::STRICTLY_CONVEX);
  expect_function_kind(on_standard(two_sheets), Kind::NEITHER);
  expect_function_kind(on_standard(cubic), Kind::CONVEX);
  expect_function_kind(on_standard(sphere * (Polynomial(1) + Polynomial(4) * x)), Kind::NEITHER);
  expect_function_kind(on_standard(saddle), Kind::NEITHER);
  expect_function_kind(on_standard(cylinder), Kind::CONVEX);
  expect_function_kind(on_standard(-sphere), Kind::STRICTLY_CONCAVE);
  expect_function_kind(on_standard(x + y), Kind::BOTH);
  expect_function_kind(on_standard(Polynomial(3)), Kind::BOTH);
  expect_function_kind(on_standard(pow(x, 4) + pow(y, 4) + pow(z, 4)), Kind::CONVEX);
  expect_function_kind(on_standard(pow(sphere + Polynomial(1), 3)), Kind::STRICTLY_CONVEX);
  // convex next to all vertices and all edges, not in the middle
  expect_function_kind(on_standard(Polynomial(10) * (sphere + Polynomial(1)) +
                                   Polynomial(6000) * x * y * z * (Polynomial(1) - x - y - z)),
                       Kind::NEITHER);
}

// On the zeros of f they are those of the formulas; the numbers are those of exact computations by hand.
TEST(patch_convexity, CurvaturePolynomials)
{
  const auto of_sheets = SC::curvature_polynomials(two_sheets);
  EXPECT_EQ(of_sheets.gaussian, Polynomial(-16) * (x * x + y * y - z * z));
  EXPECT_EQ(of_sheets.gaussian + Polynomial(16) * two_sheets, Polynomial(1));
  EXPECT_EQ(of_sheets.mean - Polynomial(16) * z * z, Polynomial());
  EXPECT_EQ(SC::curvature_polynomials(cubic).gaussian,
            Polynomial(324) * x * y * z * (x * x * x + y * y * y + z * z * z));
  EXPECT_EQ(SC::curvature_polynomials(saddle).gaussian, Polynomial(-1));
  EXPECT_EQ(SC::curvature_polynomials(cylinder).gaussian, Polynomial());
  EXPECT_EQ(SC::curvature_polynomials(cylinder).mean, Polynomial(2));
}

TEST(patch_convexity, OfPatchesInOtherTetrahedra)
{
  // two sheets, one of them convex, one concave: seen from the solid between them
  const K::Tetrahedron_3 around({-4, -4, -3}, {4, -4, -3}, {0, 6, -3}, {0, 0, 5});
  expect_kind(Function(around, -two_sheets), Kind::STRICTLY_CONCAVE);
  // both sheets are convex
  expect_kind(Function(around, two_sheets), Kind::STRICTLY_CONVEX);
  // a sphere within
  expect_kind(Function(around, sphere), Kind::STRICTLY_CONVEX);
  // a torus
  const Polynomial ring = x * x + y * y;
  const Polynomial torus =
      (ring + z * z + Polynomial(fraction(3, 4))) * (ring + z * z + Polynomial(fraction(3, 4))) - Polynomial(4) * ring;
  expect_kind(Function(around, torus), Kind::NEITHER);
  // its outer side
  const K::Tetrahedron_3 outside({2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {fraction(5, 4), 0, 0});
  expect_kind(Function(outside, torus), Kind::STRICTLY_CONVEX);
}

// Cylinders and cones, also as factors of others whose zeros are elsewhere, and the apex of a cone.
TEST(patch_convexity, OfParabolicPatches)
{
  const Polynomial cone = x * x + y * y - z * z;
  const K::Tetrahedron_3 above({-1, -1, 1}, {1, -1, 1}, {0, 1, 1}, {0, 0, 3});
  expect_kind(Function(above, cone), Kind::CONVEX);
  expect_kind(Function(above, -cone), Kind::CONCAVE);
  expect_kind(Function(above, cone * (Polynomial(5) + x * y)), Kind::CONVEX);
  expect_kind(on_standard(cylinder * (Polynomial(2) + x - y * z)), Kind::CONVEX);
  expect_kind(on_standard((x - Polynomial(fraction(1, 3))) * (Polynomial(2) + y)), Kind::BOTH);
  const SC::Patch_shape patch = SC::patch_convexity(Function(above, cone));
  EXPECT_TRUE(CGAL::certainly(patch.is_regular()));
  EXPECT_TRUE(CGAL::certainly(!patch.convexity().is_strict));
}

TEST(patch_convexity, FindsSingularPoints)
{
  const K::Tetrahedron_3 around({-4, -4, -3}, {4, -4, -3}, {0, 6, -3}, {0, 0, 5});
  const auto apex_of = [&](const K::Point_3& apex, const Polynomial& f) {
    const Polynomial u = x - Polynomial(apex.x()), v = y - Polynomial(apex.y()), w = z - Polynomial(apex.z());
    Polynomial moved = f.substituted(0, u);
    moved = moved.substituted(1, v).substituted(2, w);
    const SC::Patch_shape patch = SC::patch_convexity(Function(around, moved));
    EXPECT_EQ(patch.kind(), Kind::NOT_REGULAR) << patch;
    ASSERT_TRUE(patch.singular_point().has_value());
    EXPECT_EQ(*patch.singular_point(), apex);
    EXPECT_TRUE(CGAL::certainly(!patch.is_regular()));
  };
  const Polynomial cone = x * x + y * y - z * z;
  apex_of({0, 0, 0}, cone);
  apex_of({fraction(1, 3), fraction(-2, 7), fraction(1, 5)}, cone);
  apex_of({fraction(1, 3), 0, 0}, x * x + y * y + z * z * z - z * z);
}

// At rational points of the patch, along random tangents, no second derivative contradicts the answer; a no has a
// witness. All of it exactly.
TEST(patch_convexity, OfRandomQuadrics)
{
  std::mt19937 random(1);
  const auto integer = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  std::array<int, 3> counts{};
  for (int run = 0; run < 60; ++run) {
    Polynomial f(fraction(integer(-8, 8), 8));
    for (const Polynomial& u : {x, y, z}) {
      f += Polynomial(fraction(integer(-4, 4), 4)) * u;
      for (const Polynomial& v : {x, y, z})
        f += Polynomial(fraction(integer(-4, 4), 4)) * u * v;
    }
    if (f.is_constant())
      continue;
    const Function function = on_standard(f);
    const SC::Patch_shape patch = SC::patch_convexity(function);
    EXPECT_TRUE(patch.convexity().is_decided()) << f << ": " << patch;
    check_witnesses(function, patch);
    ++counts[patch.kind() == Kind::NEITHER ? 0 : patch.kind() == Kind::EMPTY ? 1 : 2];
    const auto [gaussian, mean] = SC::curvature_polynomials(f);
    int points = 0;
    // rational points of the patch: of quadrics, along lines through two points of which f is zero at one
    for (int sample = 0; sample < 400; ++sample) {
      const K::Point_3 p(fraction(integer(0, 16), 16), fraction(integer(0, 16), 16), fraction(integer(0, 16), 16));
      if (p.x() + p.y() + p.z() > FT(1) || value(f, p) != FT(0))
        continue;
      ++points;
      EXPECT_NE(patch.kind(), Kind::EMPTY);
      const K::Vector_3 g = gradient(f, p);
      for (int direction = 0; direction < 8; ++direction) {
        const K::Vector_3 tangent = CGAL::cross_product(g, K::Vector_3(integer(-9, 9), integer(-9, 9), integer(-9, 9)));
        if (CGAL::certainly(patch.convexity().is_convex)) {
          EXPECT_GE(second_derivative(f, p, tangent), FT(0));
        }
        if (CGAL::certainly(patch.convexity().is_concave)) {
          EXPECT_LE(second_derivative(f, p, tangent), FT(0));
        }
      }
    }
  }
  EXPECT_GT(counts[0], 5);
  EXPECT_GT(counts[1], 5);
  EXPECT_GT(counts[2], 5);
}

// Convex graphs z = h(x,y), where each point of a grid gives a rational point of the patch.
TEST(patch_convexity, OfRandomGraphs)
{
  std::mt19937 random(2);
  const auto integer = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  int convex = 0, neither = 0;
  for (int run = 0; run < 24; ++run) {
    const int factor = run % 2 == 0 ? 1 : 6;
    Polynomial h = Polynomial(fraction(1, 2)) * (x * x + y * y) + Polynomial(fraction(1, 8));
    for (const Polynomial& monomial : {x * x * x, x * x * y, x * y * y, y * y * y, x * x, x * y, y * y})
      h += Polynomial(fraction(factor * integer(-4, 4), 32)) * monomial;
    const Polynomial f = h - z;
    const Function function = on_standard(f);
    const SC::Patch_shape patch = SC::patch_convexity(function);
    EXPECT_TRUE(patch.convexity().is_decided()) << f << ": " << patch;
    check_witnesses(function, patch);
    convex += patch.kind() == Kind::STRICTLY_CONVEX;
    neither += patch.kind() == Kind::NEITHER;
    int points = 0;
    for (int i = 0; i <= 12; ++i)
      for (int j = 0; i + j <= 12; ++j) {
        const K::Point_3 below(fraction(i, 12), fraction(j, 12), 0);
        const K::Point_3 p(below.x(), below.y(), value(h, below));
        if (p.z() < FT(0) || p.x() + p.y() + p.z() > FT(1))
          continue;
        ++points;
        for (int direction = 0; direction < 6; ++direction) {
          const K::Vector_3 axis(integer(-9, 9), integer(-9, 9), integer(-9, 9));
          const FT second = second_derivative(f, p, CGAL::cross_product(gradient(f, p), axis));
          if (CGAL::certainly(patch.convexity().is_convex)) {
            EXPECT_GE(second, FT(0));
          }
          if (CGAL::certainly(patch.convexity().is_concave)) {
            EXPECT_LE(second, FT(0));
          }
        }
      }
    EXPECT_GT(points, 5);
  }
  EXPECT_GT(convex, 3);
  EXPECT_GT(neither, 3);
}

// Positive factors and affine maps change nothing.
TEST(patch_convexity, IsInvariant)
{
  std::mt19937 random(3);
  const auto integer = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
  for (const Polynomial& f : {sphere, two_sheets, cubic, saddle, cylinder, -sphere}) {
    const Kind kind = SC::patch_convexity(on_standard(f)).kind();
    const Polynomial factor = Polynomial(9) + Polynomial(integer(-4, 4)) * x + Polynomial(integer(-4, 4)) * y * z;
    if (f != cubic) // its curvature is zero on edges of the patch, that of the product at these zeros of f only
      expect_kind(on_standard(f * factor), kind);
    const Function function = on_standard(f);
    for (int run = 0; run < 3;) {
      const auto point = [&] { return K::Point_3(integer(-9, 9), integer(-9, 9), integer(-9, 9)); };
      const K::Tetrahedron_3 image(point(), point(), point(), point());
      if (image.is_degenerate())
        continue;
      ++run;
      expect_kind(Function(image, function.form()), kind);
    }
  }
}

// Of a cubic whose Gaussian curvature has the sign of x; of quadrics there is none.
TEST(patch_convexity, ParabolicCurves)
{
  const K::Tetrahedron_3 around({-1, fraction(-3, 4), 0}, {1, fraction(-3, 4), 0}, {0, 1, 0}, {0, 0, fraction(3, 2)});
  const Function function(around,
                          z + x * x * x + Polynomial(fraction(1, 2)) * y * y - Polynomial(fraction(1, 4)) * x -
                              Polynomial(fraction(1, 2)));
  const SC::Curve_solution_set_d curves = SC::parabolic_curves(function);
  EXPECT_TRUE(curves.is_complete()) << curves;
  EXPECT_EQ(curves.number_of_open_curves(), 1u);
  EXPECT_EQ(curves.curves().size(), 1u);
  ASSERT_GE(curves.vertices().size(), 2u);
  for (const auto& vertex : curves.vertices()) {
    EXPECT_NEAR(vertex.point()[0], 0, 1e-12);
    EXPECT_NEAR(vertex.point()[2], 0.5 - vertex.point()[1] * vertex.point()[1] / 2, 1e-12);
  }
  const SC::Curve_solution_set_d none = SC::parabolic_curves(on_standard(sphere));
  EXPECT_TRUE(none.is_complete());
  EXPECT_TRUE(none.curves().empty());
}

// Beyond the range of doubles.
TEST(patch_convexity, OfLargeAndSmallCoefficients)
{
  FT large(1);
  SC::Number_traits<FT>::scale_by_power_of_two(large, 1500);
  for (const FT& factor : {large, FT(FT(1) / large)}) {
    expect_kind(on_standard(Polynomial(factor) * two_sheets), Kind::STRICTLY_CONVEX);
    expect_kind(on_standard(Polynomial(factor) * saddle), Kind::NEITHER);
    const K::Tetrahedron_3 around({-4, -4, -3}, {4, -4, -3}, {0, 6, -3}, {0, 0, 5});
    expect_kind(Function(around, Polynomial(factor) * (x * x + y * y - z * z)), Kind::NOT_REGULAR);
  }
}

TEST(patch_convexity, OfValuesAndGradients)
{
  const K::Tetrahedron_3 tetrahedron({1, 2, 0}, {-1, 1, 0}, {0, 0, 3}, {2, -1, 1});
  const Polynomial f = cubic * x + sphere;
  const Function function(tetrahedron, f);
  EXPECT_EQ(function.polynomial(), f);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(function.gradient_at_vertex(i), gradient(f, function.vertex(i)));
    EXPECT_EQ(function.gradient(function.vertex(i)), gradient(f, function.vertex(i)));
  }
  const K::Point_3 p(fraction(1, 3), 4, fraction(-2, 5));
  EXPECT_EQ(function(p), value(f, p));
  EXPECT_EQ(function.sign_at(p), CGAL::sign(value(f, p)));
  const SC::Implicit_surface_3 surface(f, {{{-3, 3}, {-3, 3}, {-3, 3}}});
  const CGAL::Simple_cartesian<double>::Point_3 a(1, 2, 0), b(-1, 1, 0), c(0, 0, 3), d(2, -1, 1);
  EXPECT_EQ(Function(CGAL::Tetrahedron_3<CGAL::Simple_cartesian<double>>(a, b, c, d), surface).form(), function.form());
}

// Zeros of the Gaussian curvature without a change of sign, on an inclined plane: strictness is not decided, convexity
// is not either there, and it is said where.
TEST(patch_convexity, SaysWhereItIsUndecided)
{
  const Polynomial u = x - Polynomial(fraction(1, 3)) * y - Polynomial(fraction(1, 7)), v = y;
  const Function function = on_standard(pow(u, 4) + v * v + Polynomial(fraction(1, 8)) - z);
  const SC::Patch_shape patch = SC::patch_convexity(function, {.tolerance = 0x1p-3});
  EXPECT_FALSE(patch.is_complete());
  ASSERT_FALSE(patch.undecided().empty());
  EXPECT_EQ(patch.undecided().size(), patch.undecided_tetrahedra().size());
  EXPECT_TRUE(CGAL::certainly(!patch.convexity().is_concave));
  EXPECT_FALSE(CGAL::is_certain(patch.convexity().is_strict));
  for (const auto& part : patch.undecided_tetrahedra()) {
    // next to the curve
    const K::Point_3 center = CGAL::centroid(part);
    EXPECT_LT(CGAL::abs(value(u, center)), fraction(1, 4));
  }
}

struct Stopping_visitor
{
  int questions = 0;
  void on_progress(double) {}
  bool stop() { return ++questions > 20; }
};

TEST(patch_convexity, KeepsLimits)
{
  const Polynomial u = x - Polynomial(fraction(1, 3)) * y - Polynomial(fraction(1, 7)), v = y;
  const Function function = on_standard(pow(u, 4) + v * v + Polynomial(fraction(1, 8)) - z);
  const auto by_nodes = SC::patch_convexity(function, {.tolerance = 1e-6, .node_limit = 50});
  EXPECT_FALSE(by_nodes.is_complete());
  EXPECT_EQ(by_nodes.summary().why_not, SC::Undecided_reason::NODES);
  EXPECT_LE(by_nodes.summary().nodes, 52u);
  Stopping_visitor visitor;
  const auto stopped = SC::patch_convexity(function, {.tolerance = 1e-6, .visitor = visitor});
  EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
  EXPECT_FALSE(stopped.undecided().empty());
  const auto start = std::chrono::steady_clock::now();
  const auto in_time = SC::patch_convexity(function, {.tolerance = 1e-6, .time_limit = 0.1});
  EXPECT_EQ(in_time.summary().why_not, SC::Undecided_reason::TIME);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 0.5);
}

FT squared_distance(const Function::Form& a, const Function::Form& b)
{
  FT result(0);
  for (std::size_t i = 0; i < a.coefficients().size(); ++i) {
    const FT difference = a.coefficients()[i] - b.coefficients()[i];
    result += difference * difference;
  }
  return result;
}

TEST(patch_convexity, NearbyConvexFunctions)
{
  // one that has the property is its own answer
  EXPECT_EQ(SC::nearby_convex_function(on_standard(sphere))->form(), on_standard(sphere).form());
  EXPECT_EQ(SC::nearby_convex_function(on_standard(x + y))->form(), on_standard(x + y).form());
  std::mt19937 random(4);
  for (const int degree : {2, 3}) {
    std::vector<FT> coefficients;
    for (std::size_t i = 0; i < Function::Form::number_of_coefficients(degree); ++i)
      coefficients.push_back(fraction(std::uniform_int_distribution<int>(-20, 20)(random), 7));
    const Function function(standard_tetrahedron(), Function::Form(degree, coefficients));
    const std::vector<Function::Form::Exponents> fixed{{degree, 0, 0, 0}, {0, 1, 0, degree - 1}};
    const auto nearby = SC::nearby_convex_function(function, fixed);
    ASSERT_TRUE(nearby.has_value());
    EXPECT_TRUE(CGAL::certainly(SC::function_convexity(*nearby).convexity().is_convex));
    for (const auto& exponents : fixed)
      EXPECT_EQ(nearby->form().coefficient(exponents), function.form().coefficient(exponents));
    const FT distance = squared_distance(nearby->form(), function.form());
    EXPECT_GT(distance, FT(0));
    // the nearest one: the set is a convex cone, so the vector to the point is orthogonal to the ray through it, and it
    // is no farther than the feasible point that is affine with the two fixed values
    const auto all = SC::nearby_convex_function(function);
    FT product(0);
    for (std::size_t i = 0; i < coefficients.size(); ++i)
      product +=
          FT((function.form().coefficients()[i] - all->form().coefficients()[i]) * all->form().coefficients()[i]);
    EXPECT_EQ(product, FT(0));
    EXPECT_LE(squared_distance(all->form(), function.form()), distance);
  }
  std::vector<Function::Form::Exponents> all;
  on_standard(saddle).form().visit_coefficients([&](const auto& exponents, const FT&) { all.push_back(exponents); });
  EXPECT_FALSE(SC::nearby_convex_function(on_standard(saddle), all).has_value());
  EXPECT_THROW(SC::nearby_convex_function(on_standard(saddle), {{1, 0, 0, 0}}), SC::Invalid_input);
  EXPECT_THROW(SC::nearby_convex_function(on_standard(sphere * sphere)), SC::Invalid_input);
}

TEST(patch_convexity, RefusesBadInput)
{
  const auto message_of = [](const auto& action) {
    try {
      action();
    } catch (const SC::Invalid_input& error) {
      return std::string(error.what());
    }
    return std::string("nothing thrown");
  };
  EXPECT_EQ(message_of([] { SC::patch_convexity(on_standard(Polynomial(2))); }),
            "patch_convexity: the function is constant");
  EXPECT_EQ(message_of([] { SC::patch_convexity(on_standard(pow(x, 9) - y)); }),
            "patch_convexity: degree 9 is above 8");
  EXPECT_EQ(message_of([] {
              Function(K::Tetrahedron_3({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), sphere);
            }),
            "simplex: vertices 0..3 are coplanar");
  EXPECT_EQ(message_of([] { SC::patch_convexity(on_standard(sphere), {.tolerance = -1}); }),
            "Solver_options: the tolerance must be positive and finite");
}

} // namespace

} // namespace patch_convexity_test
