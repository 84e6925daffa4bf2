// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// verify() accepts what the solver certifies, and nothing that is not true.

#include "solver_test_checks.h"

#include <limits>
#include <random>

namespace verify_test {

using namespace solver_test;
using Answer = SC::Solution_d<double>;
using Exact_answer = SC::Solution_d<Rational>;

static Answer certified(const Answer::Box& box) { return Answer(Solution_kind::CERTIFIED, box, box, "double", {}, 1); }
static Exact_answer exactly_certified(const Exact_answer::Box& box)
{
  return Exact_answer(Solution_kind::CERTIFIED, box, box, "exact", {}, 1);
}
static Answer cluster(const Answer::Box& box) { return Answer(Solution_kind::CLUSTER, box, {}, "double"); }

static System line_system(const Polynomial& f, double lower = -4, double upper = 4)
{
  System system = System::on_box({{lower, upper}});
  system.add(f, Relation::EQUAL);
  return system;
}

static const Polynomial x = Polynomial::variable(0);
static const Polynomial y = Polynomial::variable(1);

TEST(Verify, AcceptsWhatTheSolverCertifies)
{
  std::size_t count = 0;
  for (const Problem& problem : {cyclic_chebyshev(2, 3), mixed_chebyshev(3, 2), circle_and_ellipse(), bezier_cubics(),
                                 curves_of_degree_six(), bitangents(), tritangent_planes(), lines_tangent_to_spheres(),
                                 katsura_2(), zigzag(), cyclic_chebyshev_in_pieces(3)})
    for (const auto& solution : solve(problem.system))
      if (solution.is_certified()) {
        ++count;
        EXPECT_TRUE(verify(problem.system, solution)) << problem.name;
      }
  EXPECT_GE(count, 70u);
}

TEST(Verify, AcceptsRationalCoordinates)
{
  for (const Problem& problem : {circle_and_ellipse(), zigzag()}) {
    const auto solutions = solve_with<SC::Exact_solver_traits>(problem.system);
    for (const auto& solution : solutions) {
      ASSERT_TRUE(solution.is_certified()) << problem.name;
      EXPECT_TRUE(verify(problem.system, solution)) << problem.name;
    }
    EXPECT_EQ(solutions.size(), problem.count);
  }
}

// One unknown is determined by a 10^18th part of the equations, far less than they are curved across a box of doubles.
TEST(Verify, EquationsThatNearlyCoincide)
{
  const Polynomial u = x + y - fraction(7, 3), common = pow(Polynomial(10), 18) * u * (u + 1),
                   difference = y - fraction(4, 3);
  const System system = with_equalities(cube(2, -1, 3), {common + difference, common - difference});
  const double third = 1.0 / 3, r = 1e-14;
  EXPECT_TRUE(verify(system, certified({{1 - r, 1 + r}, {1 + third - r, 1 + third + r}})));
  EXPECT_TRUE(verify(system, certified({{-r, r}, {1 + third - r, 1 + third + r}})));
  EXPECT_FALSE(verify(system, certified({{1 - r, 1 + r}, {1 + third + r, 1 + third + 3 * r}})));
}

TEST(Verify, OneUnknown)
{
  const System system = line_system(x * x - 2);
  EXPECT_TRUE(verify(system, certified({{1.25, 1.5}})));
  EXPECT_TRUE(verify(system, certified({{-1.5, -1.25}})));
  EXPECT_FALSE(verify(system, certified({{1.5, 1.75}})));     // shifted
  EXPECT_FALSE(verify(system, certified({{-2.0, 2.0}})));     // two solutions
  EXPECT_FALSE(verify(system, certified({{-0.25, 0.25}})));   // none
  EXPECT_FALSE(verify(system, certified({{5.0, 6.0}})));
}

TEST(Verify, Shifted)
{
  std::mt19937_64 random(7);
  for (const Problem& problem : {cyclic_chebyshev(2, 3), curves_of_degree_six(), bitangents()}) {
    const auto solutions = solve(problem.system);
    ASSERT_EQ(solutions.size(), problem.count);
    for (const auto& solution : solutions) {
      Answer::Box box = solution.box();
      auto& range = box[random() % box.size()];
      const double width = range.second - range.first;
      range.first += 2 * width;
      range.second += 2 * width;
      EXPECT_FALSE(verify(problem.system, certified(box)));
    }
  }
}

TEST(Verify, TooLarge)
{
  const Problem problem = cyclic_chebyshev(2, 3);
  const auto solutions = solve(problem.system);
  ASSERT_EQ(solutions.size(), 9u);
  for (const auto& a : solutions)
    for (const auto& b : solutions) {
      Answer::Box hull;
      for (int j = 0; j < 2; ++j)
        hull.emplace_back((std::min)(a[j].first, b[j].first) - 1e-3, (std::max)(a[j].second, b[j].second) + 1e-3);
      EXPECT_EQ(verify(problem.system, certified(hull)), &a == &b);
    }
}

TEST(Verify, DoubleRootsAreNotCertified)
{
  EXPECT_FALSE(verify(line_system(x * x), certified({{-1e-10, 1e-10}})));
  EXPECT_FALSE(verify(line_system(pow(x, 3)), certified({{-0.5, 0.25}})));
  const System tangent = with_equalities(cube(2, -3, 3), {x * x + y * y - 2, x * y - 1});
  EXPECT_FALSE(verify(tangent, certified({{1 - 1e-9, 1 + 2e-9}, {1 - 2e-9, 1 + 1e-9}})));
  // two solutions closer than doubles can tell
  const Rational tiny = Rational(1) / (Rational(1000000007) * Rational(1000000007));
  const System pair = line_system((x - 1) * (x - 1 - tiny));
  const double below = std::nextafter(1.0, 0.0), above = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(verify(pair, certified({{below, above}})));
  EXPECT_TRUE(verify(pair, exactly_certified({{Rational(1 - tiny / 4), Rational(1 + tiny / 3)}})));
}

TEST(Verify, Domain)
{
  const Polynomial f = x * x - 2;
  EXPECT_TRUE(verify(line_system(f, 1.4142135, 2), certified({{1.25, 1.5}})));
  EXPECT_FALSE(verify(line_system(f, 1.4142136, 2), certified({{1.25, 1.5}})));
  EXPECT_FALSE(verify(line_system(f, 0, 1.4142135), certified({{1.25, 1.5}})));
  // on the face, where only the exact solution decides
  const Polynomial g = (3 * x - 1) * (x + 7);
  System inside({{fraction(1, 3), 1}}), outside({{fraction(100000000, 299999999), 1}});
  inside.add(g, Relation::EQUAL);
  outside.add(g, Relation::EQUAL);
  EXPECT_TRUE(verify(inside, certified({{0.3, 0.35}})));
  EXPECT_FALSE(verify(outside, certified({{0.3, 0.35}})));
  // in the corner
  EXPECT_TRUE(verify(with_equalities(cube(2, 0, 1), {x * y - 1, x + 2 * y - 3}),
                     certified({{1 - 1e-12, 1 + 1e-12}, {1 - 1e-12, 1 + 1e-12}})));
}

TEST(Verify, IrrationalPointsOfFaces)
{
  const Polynomial parabola = (1 + y) * (x * x - 2) + y;
  const Answer::Box box{{1.25, 1.5}, {-0.125, 0.25}};
  const auto verifies = [&](const Polynomial& second, const Rational& lower, const Rational& upper) {
    return verify(with_equalities(System({{0, 2}, {lower, upper}}), {parabola, second}), certified(box));
  };
  for (const Polynomial& second : {y, Polynomial(y * (x + 3)), Polynomial(y * y - 2 * y)}) {
    EXPECT_TRUE(verifies(second, 0, 1));
    EXPECT_TRUE(verifies(second, -1, 0));
    EXPECT_FALSE(verifies(second, Rational(1e-300), 1));
    EXPECT_FALSE(verifies(second, -1, Rational(-1e-300)));
  }
  EXPECT_FALSE(verifies(y - Rational(1e-30), -1, 0));
  EXPECT_TRUE(verifies(y - Rational(1e-30), 0, 1));
  EXPECT_FALSE(verifies(y * y, 0, 1));

  // On the face, one equation is a multiple of the other.
  const System mixed = with_equalities(System({{0, 2}, {0, 1}}), {x * x - 2 + y, 2 * x * x - 4 - y});
  const auto solutions = solve(mixed);
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), 1u);
  EXPECT_TRUE(verify(mixed, solutions[0]));
  EXPECT_FALSE(verify(with_equalities(System({{0, 2}, {0, 1}}), {x * x - 2 + y, 2 * x * x - 5 - y}), solutions[0]));
}

// One coordinate in a kink and on the face of the domain, one rational, one irrational.
TEST(Verify, KinksOnFaces)
{
  const std::vector<Rational> breaks{-1, fraction(3, 1000000007), 1};
  const SC::Spline_function kink = piecewise(2, breaks, {x - breaks[1], 7 * (x - breaks[1])});
  for (const bool is_inside : {true, false}) {
    System system({{0, 2}, {-1, 1}, {is_inside ? breaks[1] : Rational(breaks[1] + Rational(1e-200)), 1}});
    system.add(kink + SC::Spline_function(x * x - 2 + 7 * y - 1), Relation::EQUAL);
    system.add(SC::Spline_function((7 * y - 1) * (y + 8)) + kink + kink + kink, Relation::EQUAL);
    system.add(SC::Spline_function(7 * y - 1) - kink, Relation::EQUAL);
    EXPECT_EQ(verify(system, certified({{1.414213562, 1.414213563}, {0.142857142, 0.142857143}, {2.5e-9, 3.5e-9}})),
              is_inside);
  }
}

TEST(Verify, Inequalities)
{
  const auto verifies = [](const Polynomial& g, Relation relation) {
    System system = line_system((x - fraction(2, 3)) * (x + 9));
    system.add(g, relation);
    return verify(system, certified({{0.6, 0.7}}));
  };
  EXPECT_TRUE(verifies(x, Relation::GREATER));
  EXPECT_TRUE(verifies(x, Relation::GREATER_EQUAL));
  EXPECT_FALSE(verifies(x, Relation::LESS));
  EXPECT_FALSE(verifies(x, Relation::LESS_EQUAL));
  EXPECT_TRUE(verifies(x, Relation::NOT_EQUAL));
  EXPECT_TRUE(verifies(-x, Relation::NOT_EQUAL));
  for (const Polynomial& g : {Polynomial(3 * x - 2), Polynomial((3 * x - 2) * (x * x + 1))}) {   // on the boundary
    EXPECT_TRUE(verifies(g, Relation::LESS_EQUAL));
    EXPECT_TRUE(verifies(g, Relation::GREATER_EQUAL));
    EXPECT_FALSE(verifies(g, Relation::LESS));
    EXPECT_FALSE(verifies(g, Relation::GREATER));
    EXPECT_FALSE(verifies(g, Relation::NOT_EQUAL));
  }
  // next to the boundary
  EXPECT_TRUE(verifies(x - fraction(2, 3) + Rational(1e-18), Relation::NOT_EQUAL));
  EXPECT_TRUE(verifies(x - fraction(2, 3) + Rational(1e-18), Relation::GREATER));
  EXPECT_FALSE(verifies(x - fraction(2, 3) + Rational(1e-18), Relation::LESS_EQUAL));
  // an irrational root
  System system = line_system(x * x - 2);
  // the double lies below or above: sign by hand
  system.add(x - Rational(1.4142135623730950), Relation::GREATER_EQUAL);
  const Rational d(1.4142135623730950);
  EXPECT_EQ(verify(system, certified({{1.25, 1.5}})), d * d < Rational(2));
  // two unknowns, where the operator has to shrink the box until it lies beside the zeros of the inequality
  System plane({{-2, 2}, {-2, 2}});
  plane.add(x * x - 2, Relation::EQUAL);
  plane.add(y - x, Relation::EQUAL);
  plane.add(2 * y - 3, Relation::NOT_EQUAL);
  EXPECT_TRUE(verify(plane, certified({{1.25, 1.75}, {1.25, 1.75}})));
  plane.add(y * y - 2, Relation::NOT_EQUAL);
  EXPECT_FALSE(verify(plane, certified({{1.25, 1.75}, {1.25, 1.75}})));
}

TEST(Verify, SplinesAcrossBreaks)
{
  // f = x - 1 on [-4,0] and [0,1], slope 3 on [1,4]
  const std::vector<Rational> breaks{-4, 0, 1, 4};
  const auto linear = [](int a, int b) { return SC::Bernstein_tensor<Rational>({1}, {Rational(a), Rational(b)}); };
  System kink = System::on_box({{-4, 4}});
  kink.add(SC::Spline_function::from_bezier_pieces({0}, {breaks}, {linear(-5, -1), linear(-1, 0), linear(0, 9)}),
           Relation::EQUAL);
  EXPECT_TRUE(verify(kink, certified({{0.75, 1.125}})));
  EXPECT_TRUE(verify(kink, certified({{-0.25, 1.5}})));
  EXPECT_FALSE(verify(kink, certified({{0.0, 0.75}})));
  // a valley that touches zero has slopes of both signs
  System valley = System::on_box({{-4, 4}});
  valley.add(SC::Spline_function::from_bezier_pieces({0}, {breaks}, {linear(5, 1), linear(1, 0), linear(0, 9)}),
             Relation::EQUAL);
  EXPECT_FALSE(verify(valley, certified({{0.75, 1.25}})));
  // a jump over zero
  System jump = System::on_box({{-4, 4}});
  jump.add(SC::Spline_function::from_bezier_pieces({0}, {breaks}, {linear(-5, -1), linear(-1, -1), linear(1, 9)}),
           Relation::EQUAL);
  EXPECT_FALSE(verify(jump, certified({{0.75, 1.25}})));
  System steep = System::on_box({{-4, 4}});
  steep.add(SC::Spline_function::from_bezier_pieces({0}, {breaks}, {linear(-5, -2), linear(-2, -1), linear(1, 9)}),
            Relation::EQUAL);
  for (double width : {1e-3, 0.25, 2.0})
    EXPECT_FALSE(verify(steep, certified({{1 - width, 1 + width}})));
  // the extension of a piece has a root that the spline does not have
  System extension = System::on_box({{-4, 4}});
  extension.add(
      SC::Spline_function::from_bezier_pieces({0}, {breaks}, {linear(-5, -2), linear(-2, -1), linear(-1, -9)}),
      Relation::EQUAL);
  EXPECT_FALSE(verify(extension, certified({{1.75, 2.25}})));
  EXPECT_FALSE(verify(extension, certified({{0.5, 3.0}})));
}

TEST(Verify, SplineOfTwoAxes)
{
  // |x| + |y| on [-1,1]^2 in four pieces
  const auto corner = [](int a, int b, int c, int d) {
    return SC::Bernstein_tensor<Rational>({1, 1}, {Rational(a), Rational(b), Rational(c), Rational(d)});
  };
  const std::vector<Rational> breaks{-1, 0, 1};
  const SC::Spline_function norm = SC::Spline_function::from_bezier_pieces(
    {0, 1}, {breaks, breaks}, {corner(2, 1, 1, 0), corner(1, 2, 0, 1), corner(1, 0, 2, 1), corner(0, 1, 1, 2)});
  System system = cube(2, -1, 1);
  system.add(norm - SC::Spline_function(Polynomial(fraction(1, 2))), Relation::EQUAL);
  system.add(x - 3 * y - fraction(1, 2), Relation::EQUAL);   // (1/2, 0) in a kink, and (-1/4, -1/4)
  EXPECT_TRUE(verify(system, certified({{0.49, 0.52}, {-0.01, 0.02}})));
  EXPECT_TRUE(verify(system, certified({{-0.26, -0.23}, {-0.26, -0.23}})));
  EXPECT_FALSE(verify(system, certified({{-0.3, 0.6}, {-0.3, 0.1}})));
  EXPECT_FALSE(verify(system, certified({{0.1, 0.2}, {-0.2, 0.1}})));
  const auto solutions = solve(system);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 2u);
  for (const auto& solution : solutions)
    EXPECT_TRUE(verify(system, solution));
}

TEST(Verify, Overdetermined)
{
  const System system = with_equalities(cube(2, -3, 3), {x * x + y * y - 5, x * y - 2, x + y - 3});   // (1,2) and (2,1)
  EXPECT_TRUE(verify(system, certified({{0.99, 1.02}, {1.98, 2.01}})));
  EXPECT_FALSE(verify(system, certified({{0.5, 2.5}, {0.5, 2.5}})));
  EXPECT_FALSE(verify(system, certified({{-1.02, -0.99}, {-2.01, -1.98}})));   // satisfies only the first two
  const System none = with_equalities(cube(2, -3, 3), {x * x + y * y - 5, x * y - 2, x + y - Rational(3.0000000001)});
  EXPECT_FALSE(verify(none, certified({{0.99, 1.02}, {1.98, 2.01}})));
  const System underdetermined = with_equalities(cube(2, -3, 3), {x + y});
  EXPECT_FALSE(verify(underdetermined, certified({{-0.5, 0.25}, {-0.25, 0.5}})));
}

TEST(Verify, ThinBoxes)
{
  const System system = with_equalities(cube(2, -3, 3), {x * x + y - 2, y * (1 + x * x)});   // (sqrt 2, 0)
  const double tiny = std::numeric_limits<double>::denorm_min();
  EXPECT_TRUE(verify(system, certified({{1.41, 1.42}, {-1e-3, 1e-3}})));
  EXPECT_FALSE(verify(system, certified({{1.41, 1.42}, {tiny, 1e-3}})));
  EXPECT_TRUE(verify(line_system(x), certified({{0.0, 0.0}})));
  EXPECT_TRUE(verify(line_system(x), certified({{0.0, 1.0}})));
  EXPECT_FALSE(verify(line_system(x), certified({{tiny, 1.0}})));
  EXPECT_TRUE(verify(with_equalities(cube(2, -3, 3), {x * x - 4 + y, y - x * y}),
                     certified({{2 - 1e-15, 2 + 1e-15}, {-tiny, tiny}})));
}

TEST(Verify, Clusters)
{
  const System tangent = with_equalities(cube(2, -3, 3), {x * x + y * y - 2, x * y - 1});
  EXPECT_TRUE(verify(tangent, cluster({{0.9999, 1.0001}, {0.9999, 1.0001}})));
  EXPECT_FALSE(verify(tangent, cluster({{1.0001, 1.0002}, {0.9999, 1.0001}})));
  EXPECT_FALSE(verify(line_system(x * x), cluster({{1e-9, 1e-8}})));
  EXPECT_TRUE(verify(line_system(x * x, 0, 1), cluster({{-1e-8, 1e-8}})));
  EXPECT_FALSE(verify(line_system(x * x, 1e-9, 1), cluster({{-1e-8, 1e-8}})));    // out of the domain
  EXPECT_FALSE(verify(line_system(x * x, 1e-7, 1), cluster({{-1e-8, 1e-8}})));
  System positive = line_system(x * x);
  positive.add(x, Relation::GREATER);
  EXPECT_FALSE(verify(positive, cluster({{-1e-8, 1e-8}})));
  const auto solutions = solve(tangent);
  EXPECT_EQ(solutions.count(Solution_kind::CLUSTER), 2u);
  for (const auto& solution : solutions)
    EXPECT_TRUE(verify(tangent, solution));
}

// (sqrt 2, 1/3), where the curves touch.
TEST(Verify, ClustersWithIrrationalCoordinates)
{
  const System tangent = with_equalities(cube(2, -3, 3), {square(3 * y - 1), x * x - 2 + (3 * y - 1) * (x + 5)});
  const double root = std::sqrt(2.0), width = 1e-10;
  EXPECT_TRUE(verify(tangent, cluster({{root - width, root + 2 * width}, {1 / 3.0 - 2 * width, 1 / 3.0 + width}})));
  EXPECT_FALSE(verify(tangent, cluster({{root + width, root + 2 * width}, {1 / 3.0 - 2 * width, 1 / 3.0 + width}})));
  EXPECT_FALSE(verify(tangent, cluster({{root - width, root + 2 * width}, {1 / 3.0 - 2 * width, 1 / 3.0 - width}})));
  EXPECT_FALSE(verify(tangent, certified({{root - width, root + 2 * width}, {1 / 3.0 - 2 * width, 1 / 3.0 + width}})));
  for (const auto& solution : solve(tangent))
    EXPECT_TRUE(solution.kind() != Solution_kind::CLUSTER || verify(tangent, solution));
}

TEST(Verify, OtherAnswersProveNothing)
{
  const System system = line_system(x);
  const Answer::Box box{{-0.5, 0.25}};
  ASSERT_TRUE(verify(system, certified(box)));
  EXPECT_FALSE(verify(system, Answer(Solution_kind::UNDECIDED, box, box, "double", SC::Undecided_reason::TOLERANCE)));
  EXPECT_FALSE(verify(system, Answer(Solution_kind::CONTINUUM, box, box, "double")));
  EXPECT_FALSE(verify(system, Answer()));
  EXPECT_FALSE(verify(system, certified(Answer::Box{})));
  EXPECT_FALSE(verify(system, certified({{-1.0, 1.0}, {-1.0, 1.0}})));
  EXPECT_FALSE(verify(system, certified({{0.5, -0.5}})));
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(verify(system, certified({{-infinity, infinity}})));
  EXPECT_FALSE(verify(system, certified({{nan, 0.5}})));
  EXPECT_FALSE(verify(system, cluster({{-0.5, nan}})));
}

// Random quadratic systems with a planted solution, its box falsified at random: verify() agrees with what is known.
TEST(Verify, NeverTrueWhereNothingIs)
{
  std::mt19937_64 random(2026);
  const auto number = [&](int size) { return static_cast<int>(random() % (2 * size + 1)) - size; };
  std::size_t accepted = 0;
  for (int test = 0; test < 200; ++test) {
    const int n = 1 + test % 3;
    std::vector<Rational> root;
    for (int j = 0; j < n; ++j)
      root.push_back(fraction(number(30), 1 + static_cast<int>(random() % 9)));
    System system = cube(n, -40, 40);
    for (int i = 0; i < n; ++i) {
      Polynomial f;
      for (int j = 0; j < n; ++j) {
        const Polynomial h = Polynomial::variable(j) - root[j];
        f += Polynomial(number(9) + (i == j ? 20 : 0)) * h +
            Polynomial(number(5)) * h * Polynomial::variable((i + j) % n);
      }
      system.add(f, Relation::EQUAL);
    }
    const Rational width(std::ldexp(1.0, -static_cast<int>(random() % 50)));
    Exact_answer::Box box;
    for (int j = 0; j < n; ++j) {
      const Rational middle = root[j] + fraction(number(1), 3) * width;
      box.emplace_back(Rational(middle - width), Rational(middle + width));
    }
    accepted += verify(system, exactly_certified(box));
    box[test % n].first += width * fraction(3, 2);   // the planted solution is left out
    box[test % n].second += width * fraction(3, 2);
    EXPECT_FALSE(width < Rational(1e-6) && verify(system, exactly_certified(box))) << test;
  }
  EXPECT_GT(accepted, 100u);
}

} // namespace verify_test
