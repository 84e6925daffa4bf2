// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Newton improvement: full double precision on square systems, the closest point on others, and the mathematical test
// behind every status.

#include "solver_test_systems.h"

#include <CGAL/Spline_constraints_d/solver/newton_improvement.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>
#include <random>
#include <sstream>
#include <vector>

namespace newton_improvement_test {

using namespace solver_test;
using SC::improve_point;
using SC::Newton_result;
using SC::Newton_status;

static const Polynomial x = Polynomial::variable(0);
static const Polynomial y = Polynomial::variable(1);
static const Polynomial z = Polynomial::variable(2);

static double distance(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for (std::size_t j = 0; j < a.size(); ++j)
    sum += (a[j] - b[j]) * (a[j] - b[j]);
  return a.size() == b.size() ? std::sqrt(sum) : HUGE_VAL;
}

static Polynomial sum_of_squares(int dimension)
{
  Polynomial result;
  for (const Polynomial& v : variables(dimension))
    result += v * v;
  return result;
}

TEST(Newton_improvement, SquareRootToTheLastPlace)
{
  for (int a : {2, 3, 5, 7, 1000003}) {
    const System system = with_equalities(cube(1, 0, 2000), {x * x - a});
    const Newton_result result = improve_point(system, {1.25 * std::sqrt(a)});
    EXPECT_EQ(result.status, Newton_status::CONVERGED);
    EXPECT_EQ(result.point[0], std::sqrt(a));
    EXPECT_LE(result.iterations, 7);
    EXPECT_LE(result.residual, 3e-16 * a);
    EXPECT_GT(result.residual, 0);
  }
}

// With e_k the error after k steps, e_{k+1} / e_k^2 stays bounded: here it tends to 1 / (2 sqrt 2).
TEST(Newton_improvement, QuadraticConvergence)
{
  const System system = with_equalities(cube(2, 0, 4), {x * x + y * y - 4, x - y});
  double before = 0;
  int compared = 0;
  for (int steps = 0; steps <= 6; ++steps) {
    const Newton_result result = improve_point(system, {2, 2.5}, {.maximal_iterations = steps});
    EXPECT_LE(result.iterations, steps);
    const double error = distance(result.point, {std::sqrt(2.0), std::sqrt(2.0)});
    if (steps >= 2 && error > 1e-14) {
      EXPECT_LE(error, 0.5 * before * before);
      EXPECT_GE(error, 0.1 * before * before);
      ++compared;
    }
    EXPECT_EQ(result.status, steps < 6 && error > 1e-14 ? Newton_status::ITERATION_LIMIT : result.status);
    before = error;
  }
  EXPECT_GE(compared, 2);
  EXPECT_LE(before, 5e-16);
}

// Planted roots, regular by the dominance of the linear part, each reached exactly.
TEST(Newton_improvement, RandomSquareSystems)
{
  std::mt19937_64 random(20260101);
  std::uniform_int_distribution<int> small(-8, 8);
  for (int n = 1; n <= 5; ++n)
    for (int round = 0; round < 40; ++round) {
      const auto v = variables(n);
      std::vector<double> root;
      std::vector<Polynomial> shifted;
      for (int j = 0; j < n; ++j) {
        root.push_back(small(random) / 16.0);
        shifted.push_back(v[j] - Rational(root[j]));
      }
      std::vector<Polynomial> functions;
      for (int i = 0; i < n; ++i) {
        Polynomial f = 16 * n * shifted[i];
        for (int j = 0; j < n; ++j)
          f += fraction(small(random), 2) * shifted[j] + fraction(small(random), 4) * shifted[j] * shifted[(j + i) % n];
        functions.push_back(f);
      }
      std::vector<double> start = root;
      for (double& c : start)
        c += small(random) / 100.0;
      const Newton_result result = improve_point(with_equalities(cube(n, -1, 1), functions), start);
      EXPECT_EQ(result.status, Newton_status::CONVERGED);
      EXPECT_LE(result.iterations, 8);
      EXPECT_LE(distance(result.point, root), 1e-15);
      EXPECT_LE(result.residual, 1e-13);
    }
}

// The residual is exact: the cancellation of (x-1)^5 in power form costs no digits of the other root, and a cluster of
// five is approached from afar.
TEST(Newton_improvement, NoCancellation)
{
  const System system = with_equalities(cube(1, 0, 2), {pow(x - 1, 5) * (x - fraction(1001, 1000))});
  const Newton_result result = improve_point(system, {1.0012});
  EXPECT_EQ(result.status, Newton_status::CONVERGED);
  EXPECT_NEAR(result.point[0], 1.001, 2.3e-16);
}

TEST(Newton_improvement, DoubleRootLinearly)
{
  const System system = with_equalities(cube(1, -3, 3), {pow(x * x - 2, 2)});
  const Newton_result result = improve_point(system, {1.5});
  EXPECT_EQ(result.status, Newton_status::CONVERGED);
  EXPECT_NEAR(result.point[0], std::sqrt(2.0), 1e-15);
  EXPECT_GT(result.iterations, 30);
}

// The closest point of a line, to rounding.
TEST(Newton_improvement, LinesAreProjectedOnto)
{
  const auto v = variables(4);
  const System system = with_equalities(cube(4, -8, 8), {v[0] + v[1] + v[2] + v[3] - 2, v[0] - v[1] + 2 * v[2] - 1});
  // The step is A^T w with (A A^T) w = -r: (4 2; 2 6) (a,b) = (0,-3).
  const Newton_result result = improve_point(system, {2, 0, 1, -1});
  ASSERT_EQ(result.status, Newton_status::CONVERGED);
  EXPECT_LE(result.iterations, 2);
  const double a = 0.3, b = -0.6;
  EXPECT_LE(distance(result.point, {2 + a + b, a - b, 1 + a + 2 * b, -1 + a}), 2e-15);
}

// Newton's steps to a sphere are radial: the closest point exactly.
TEST(Newton_improvement, SpheresAreProjectedOnto)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (int n = 1; n <= 6; ++n)
    for (int round = 0; round < 10; ++round) {
      std::vector<double> start(n);
      double length = 0;
      while (length < 0.3) {
        for (double& c : start)
          c = coordinate(random);
        length = distance(start, std::vector<double>(n, 0));
      }
      const Newton_result result = improve_point(with_equalities(cube(n, -8, 8), {sum_of_squares(n) - 1}), start);
      EXPECT_EQ(result.status, Newton_status::CONVERGED);
      for (double& c : start)
        c /= length;
      EXPECT_LE(distance(result.point, start), 2e-15);
      EXPECT_LE(result.residual, 2e-15);
    }
}

// A circle in space, and the parabola: the distance to the closest point shrinks like the square of the distance from
// the curve.
TEST(Newton_improvement, ClosestPointToSecondOrder)
{
  const System parabola = with_equalities(cube(2, -4, 4), {y - x * x});
  const System circle = with_equalities(cube(3, -4, 4), {sum_of_squares(3) - 4, x + y * y / 4 - 1});
  double before = 1;
  for (double offset : {0.2, 0.02, 0.002, 0.0002}) {
    const double length = std::sqrt(5.0);   // the normal at (1,1) is (2,-1)
    const Newton_result near = improve_point(parabola, {1 + offset * 2 / length, 1 - offset / length});
    ASSERT_EQ(near.status, Newton_status::CONVERGED);
    const double error = distance(near.point, {1, 1});
    EXPECT_LE(error, offset * offset);
    EXPECT_LT(error, before / 50);
    before = error;

    // At (1, 0, sqrt 3) the normal plane is spanned by (1, 0, sqrt 3) and (1, 0, 0).
    const Newton_result in_space = improve_point(circle, {1 + offset, 0, std::sqrt(3.0) - offset});
    ASSERT_EQ(in_space.status, Newton_status::CONVERGED);
    EXPECT_LE(distance(in_space.point, {1, 0, std::sqrt(3.0)}), 4e-15);
  }
}

// Many starts around a curve on a torus: always on it to full precision, and moved by not much more than the distance
// to it.
TEST(Newton_improvement, RandomUnderdeterminedSystems)
{
  std::mt19937_64 random(99);
  std::uniform_real_distribution<double> angle(0, 6.28), noise(-0.02, 0.02);
  const auto v = variables(4);
  const System system = with_equalities(
      cube(4, -2, 2), {v[0] * v[0] + v[1] * v[1] - 1, v[2] * v[2] + v[3] * v[3] - 1, v[0] * v[3] - v[1] * v[2]});
  for (int round = 0; round < 100; ++round) {
    const double t = angle(random);
    const std::vector<double> on_curve{std::cos(t), std::sin(t), std::cos(t), std::sin(t)};
    std::vector<double> start = on_curve;
    for (double& c : start)
      c += noise(random);
    const Newton_result result = improve_point(system, start);
    EXPECT_EQ(result.status, Newton_status::CONVERGED);
    EXPECT_LE(result.residual, 1e-15);
    EXPECT_LE(distance(result.point, start), 1.05 * distance(on_curve, start));
  }
}

TEST(Newton_improvement, SingularJacobian)
{
  // The derivative vanishes at the start; and parallel gradients, consistent or not.
  EXPECT_EQ(improve_point(with_equalities(cube(1, -2, 2), {x * x - 1}), {0}).status, Newton_status::SINGULAR);
  EXPECT_EQ(improve_point(with_equalities(cube(2, -2, 2), {x + y - 1, 2 * x + 2 * y - 1}), {0, 0}).status,
            Newton_status::SINGULAR);
  EXPECT_EQ(improve_point(with_equalities(cube(3, -2, 2), {x + y - 1, 2 * x + 2 * y - 2}), {0, 0, 0}).status,
            Newton_status::SINGULAR);
  EXPECT_EQ(improve_point(with_equalities(cube(2, -2, 2), {Polynomial(1)}), {0, 0}).status, Newton_status::SINGULAR);
  // A root is a root, singular or not.
  const Newton_result cusp = improve_point(with_equalities(cube(2, -2, 2), {pow(x, 3) - y * y}), {0, 0});
  EXPECT_EQ(cusp.status, Newton_status::CONVERGED);
  EXPECT_EQ(cusp.iterations, 0);
  EXPECT_EQ(cusp.residual, 0);
}

TEST(Newton_improvement, WithoutSolution)
{
  const Newton_result result = improve_point(with_equalities(cube(1, -4, 4), {x * x + 1}), {3});
  EXPECT_EQ(result.status, Newton_status::STAGNATED);
  EXPECT_GE(result.residual, 1);
  EXPECT_LT(result.residual, 1.5);
}

TEST(Newton_improvement, Domain)
{
  // The root 2 is outside, the root -2 is not reached from the start.
  const Newton_result outside = improve_point(with_equalities(cube(1, -3, 1), {x * x - 4}), {0.5});
  EXPECT_EQ(outside.status, Newton_status::LEFT_DOMAIN);
  EXPECT_EQ(outside.point[0], 1);
  // A start outside is moved to the domain.
  EXPECT_EQ(improve_point(with_equalities(cube(1, 0, 1), {2 * x - 1}), {7}).point[0], 0.5);
  // The closest point of the line is (2,-1): along the face y = 0 it is (1,0).
  const Newton_result held = improve_point(with_equalities(cube(2, 0, 4), {x + y - 1}), {3, 0});
  EXPECT_EQ(held.status, Newton_status::CONVERGED);
  EXPECT_EQ(held.point, (std::vector<double>{1, 0}));
  // Roots in the corner and on a face, from inside; 1/3 is no double, and stays inside.
  const Newton_result corner = improve_point(with_equalities(cube(2, 0, 1), {x * x + y * y - 2, x - y}), {0.8, 0.7});
  EXPECT_EQ(corner.status, Newton_status::CONVERGED);
  EXPECT_EQ(corner.point, (std::vector<double>{1, 1}));
  const Newton_result third =
      improve_point(with_equalities(cube(1, 0, fraction(1, 3)), {3 * x * x + 8 * x - 3}), {0.1});
  EXPECT_EQ(third.status, Newton_status::CONVERGED);
  EXPECT_LE(Rational(third.point[0]), fraction(1, 3));
  EXPECT_NEAR(third.point[0], 1.0 / 3, 1e-16);
}

TEST(Newton_improvement, Splines)
{
  const Newton_result kink = improve_point(zigzag().system, {1.9, 1.1});
  EXPECT_EQ(kink.status, Newton_status::CONVERGED);
  EXPECT_EQ(kink.point, (std::vector<double>{2, 1}));
  const Newton_result on_third_piece = improve_point(zigzag().system, {4.1, 2});
  EXPECT_EQ(on_third_piece.status, Newton_status::CONVERGED);
  EXPECT_LE(distance(on_third_piece.point, {4.4, 2.2}), 1e-15);
  // The last value belongs to the last piece.
  System polygon_system(std::vector<System::Domain>{{0, 2}});
  polygon_system.add(polygon(0, {4, 1, 0}), Relation::EQUAL);
  EXPECT_EQ(improve_point(polygon_system, {0.5}).point[0], 2);
}

TEST(Newton_improvement, HugeAndTinyCoefficients)
{
  Rational huge(1);
  for (int i = 0; i < 500; ++i)
    huge *= 10;
  for (const Rational& factor : {huge, Rational(Rational(1) / huge)}) {
    const Newton_result result = improve_point(with_equalities(cube(2, -4, 4), {factor * (x * x - 2), x - y}), {1, 1});
    EXPECT_EQ(result.status, Newton_status::CONVERGED);
    EXPECT_EQ(result.point, (std::vector<double>{std::sqrt(2.0), std::sqrt(2.0)}));
  }
}

TEST(Newton_improvement, AnyRoundingMode)
{
  const System system = with_equalities(cube(2, -4, 4), {x * x + y * y - 4, x - y});
  const Newton_result nearest = improve_point(system, {1, 2});
  for (int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    const Newton_result result = improve_point(system, {1, 2});
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(result.point, nearest.point);
    EXPECT_EQ(result.status, Newton_status::CONVERGED);
  }
}

TEST(Newton_improvement, NothingToDo)
{
  const Newton_result result = improve_point(cube(2, 0, 1), {0.25, 3});
  EXPECT_EQ(result.status, Newton_status::CONVERGED);
  EXPECT_EQ(result.point, (std::vector<double>{0.25, 1}));
  EXPECT_EQ(result.iterations, 0);
  const Newton_result limited =
      improve_point(with_equalities(cube(1, 0, 2), {x * x - 2}), {1}, {.maximal_iterations = 0});
  EXPECT_EQ(limited.status, Newton_status::ITERATION_LIMIT);
  EXPECT_EQ(limited.point[0], 1);
  EXPECT_EQ(limited.residual, 1);
}

TEST(Newton_improvement, BadInput)
{
  const System system = with_equalities(cube(2, 0, 1), {x - y});
  EXPECT_THROW(improve_point(system, {0.5}), SC::Invalid_input);
  EXPECT_THROW(improve_point(system, {0.5, 0.5, 0.5}), SC::Invalid_input);
  EXPECT_THROW(improve_point(system, {0.5, std::numeric_limits<double>::quiet_NaN()}), SC::Invalid_input);
  EXPECT_THROW(improve_point(system, {HUGE_VAL, 0.5}), SC::Invalid_input);
  EXPECT_THROW(improve_point(system, {0.5, 0.5}, {.maximal_iterations = -1}), SC::Invalid_input);
  for (double tolerance : {0.0, 1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(improve_point(system, {0.5, 0.5}, {.rank_tolerance = tolerance}), SC::Invalid_input);
  EXPECT_THROW(improve_point(with_equalities(cube(1, 0, 1), {x, x - 1}), {0.5}), SC::Invalid_input);
  EXPECT_THROW(improve_point(with_equalities(cube(1, fraction(1, 3), fraction(1, 3)), {x}), {0.5}), SC::Invalid_input);
}

TEST(Newton_improvement, Names)
{
  std::ostringstream out;
  out << Newton_status::CONVERGED << ',' << Newton_status::STAGNATED << ',' << Newton_status::SINGULAR << ','
      << Newton_status::LEFT_DOMAIN << ',' << Newton_status::ITERATION_LIMIT;
  EXPECT_EQ(out.str(), "converged,stagnated,singular,left the domain,iteration limit");
}

} // namespace newton_improvement_test
