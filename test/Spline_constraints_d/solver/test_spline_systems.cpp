// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems of B-splines: the certified solutions against de Boor's algorithm, and their number against counts that know
// nothing of breaks: piece by piece, or by Descartes' rule in exact arithmetic.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Rational_function.h>

#include <algorithm>
#include <array>
#include <random>
#include <utility>
#include <vector>

namespace spline_systems_test {

using namespace solver_test;

namespace {

using Spline = SC::Bspline_function<Rational>;
using Knots = std::vector<Rational>;

SC::Spline_function on_variables(const std::vector<int>& variables, const Spline& spline)
{
  std::vector<Knots> breaks;
  for (int j = 0; j < spline.dimension(); ++j)
    breaks.push_back(spline.breaks(j));
  return SC::Spline_function::from_bezier_pieces(variables, breaks, spline.bezier_pieces());
}

// De Boor's algorithm as it stands in the books.
Rational de_boor(const Spline& spline, const Rational& u)
{
  const int d = spline.degree(0);
  const Knots& t = spline.knots(0);
  std::size_t k = d;
  for (std::size_t i = d; i < spline.size(0); ++i)
    if (t[i] < t[i + 1] && t[i] <= u)
      k = i;
  std::vector<Rational> points(spline.coefficients().begin() + (k - d), spline.coefficients().begin() + (k + 1));
  for (int r = 1; r <= d; ++r)
    for (int j = d; j >= r; --j) {
      const Rational a = (u - t[j + k - d]) / (t[j + 1 + k - r] - t[j + k - d]);
      points[j] = (1 - a) * points[j - 1] + a * points[j];
    }
  return points[d];
}

Rational largest_slope(const Spline& spline)
{
  const auto [lower, upper] = spline.derivative_bounds(0);
  return (std::max)(Rational(CGAL::abs(lower)), Rational(CGAL::abs(upper)));
}

// The roots of a polynomial with simple roots in the open interval (0,1).
std::size_t descartes_count(const SC::Bernstein_tensor<Rational>& f, int depth = 0)
{
  std::size_t variations = 0;
  int before = 0;
  for (const Rational& b : f.coefficients())
    if (const int sign = CGAL::sign(b); sign != 0) {
      variations += sign * before < 0;
      before = sign;
    }
  if (variations < 2 || depth > 200) {
    EXPECT_LE(depth, 200) << "a multiple root";
    return variations;
  }
  const auto [left, right] = f.split(0);
  return descartes_count(left, depth + 1) + CGAL::is_zero(right.coefficients()[0]) + descartes_count(right, depth + 1);
}

std::size_t count_roots(const Spline& f)
{
  std::size_t count = CGAL::is_zero(de_boor(f, f.domain(0).second));
  for (const auto& piece : f.bezier_pieces())
    count += CGAL::is_zero(piece.coefficients()[0]) + descartes_count(piece);
  return count;
}

struct Curve
{
  Spline x, y;

  Rational end(int side) const { return side == 0 ? x.domain(0).first : x.domain(0).second; }
  Curve moved(const Rational& a, const Rational& b) const { return {x + a, y + b}; }
};

Curve random_curve(int degree, const Knots& knots, std::mt19937_64& random)
{
  std::uniform_int_distribution<int> grid(-16, 16);
  std::array<std::vector<Rational>, 2> points;
  for (std::size_t i = 0; i + degree + 1 < knots.size(); ++i)
    for (auto& coordinates : points)
      coordinates.push_back(fraction(grid(random), 2));
  return {Spline({degree}, {knots}, points[0]), Spline({degree}, {knots}, points[1])};
}

System intersection(const Curve& a, const Curve& b)
{
  System system({{a.end(0), a.end(1)}, {b.end(0), b.end(1)}});
  system.add(on_variables({0}, a.x) - on_variables({1}, b.x), Relation::EQUAL);
  system.add(on_variables({0}, a.y) - on_variables({1}, b.y), Relation::EQUAL);
  return system;
}

Polynomial piece_polynomial(const Spline& spline, std::size_t piece, int variable)
{
  return bezier(spline.bezier_pieces()[piece].coefficients(), Polynomial::variable(variable));
}

using Box = std::vector<std::pair<Rational, Rational>>;

template <class Coordinate>
bool meet(const std::vector<std::pair<Coordinate, Coordinate>>& box, const Box& other)
{
  for (std::size_t j = 0; j < other.size(); ++j)
    if (Rational(box[j].second) < other[j].first || other[j].second < Rational(box[j].first))
      return false;
  return true;
}

// The intersections pair by pair of Bézier pieces, each as a polynomial system on the unit square: their boxes on the
// domains of the curves. A solution on a break comes from the pieces on both sides: boxes that meet are one.
std::vector<Box> intersections_by_pieces(const Curve& a, const Curve& b)
{
  std::vector<Box> result;
  const Knots breaks[2] = {a.x.breaks(0), b.x.breaks(0)};
  for (std::size_t i = 0; i + 1 < breaks[0].size(); ++i)
    for (std::size_t k = 0; k + 1 < breaks[1].size(); ++k) {
      const System system = with_equalities(cube(2, 0, 1), {piece_polynomial(a.x, i, 0) - piece_polynomial(b.x, k, 1),
                                                            piece_polynomial(a.y, i, 0) - piece_polynomial(b.y, k, 1)});
      const auto solutions = solve_with<SC::Certified_solver_traits>(system);
      EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
      EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), solutions.size());
      for (const auto& solution : solutions) {
        const std::size_t cell[2] = {i, k};
        Box box;
        for (int j = 0; j < 2; ++j) {
          const Rational &begin = breaks[j][cell[j]], width = breaks[j][cell[j] + 1] - begin;
          box.emplace_back(begin + width * Rational(solution[j].first), begin + width * Rational(solution[j].second));
        }
        if (std::none_of(result.begin(), result.end(), [&](const Box& other) { return meet(other, box); }))
          result.push_back(std::move(box));
      }
    }
  return result;
}

// |f(middle)| = |f(middle) - f(root)| is at most the slopes times half the widths of the box.
template <class Solution>
void expect_close_by_de_boor(const Curve& a, const Curve& b, const Solution& solution)
{
  std::vector<Rational> middle, radius;
  for (int j = 0; j < 2; ++j) {
    const Rational lower(solution[j].first), upper(solution[j].second);
    const Curve& curve = j == 0 ? a : b;
    EXPECT_LE(curve.end(0), upper);
    EXPECT_LE(lower, curve.end(1));
    middle.push_back((std::min)((std::max)(Rational((lower + upper) / 2), curve.end(0)), curve.end(1)));
    radius.push_back(upper - lower);
    EXPECT_LE(radius.back(), 1e-12);
  }
  for (const auto& [f, g] : {std::pair(a.x, b.x), std::pair(a.y, b.y)}) {
    const Rational value = de_boor(f, middle[0]) - de_boor(g, middle[1]);
    EXPECT_EQ(value, f(std::vector<Rational>{middle[0]}) - g(std::vector<Rational>{middle[1]}));
    EXPECT_LE(CGAL::abs(value), largest_slope(f) * radius[0] + largest_slope(g) * radius[1]);
  }
}

template <class Traits = SC::Certified_solver_traits>
std::size_t check_intersection(const Curve& a, const Curve& b, const std::vector<Point>& planted = {})
{
  const System system = intersection(a, b);
  const auto solutions = solve_with<Traits>(system);
  const auto expected = intersections_by_pieces(a, b);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), expected.size());
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), expected.size());
  for (const auto& box : expected)
    EXPECT_EQ(std::count_if(solutions.begin(), solutions.end(), [&](const auto& s) { return meet(s.box(), box); }), 1);
  for (const Point& point : planted)
    EXPECT_EQ(std::count_if(solutions.begin(), solutions.end(), [&](const auto& s) { return meets(s.box(), point); }),
              1)
        << text_of(point);
  for (const auto& solution : solutions) {
    expect_close_by_de_boor(a, b, solution);
    EXPECT_TRUE(verify(system, solution));
  }
  expect_consistent_regions(solutions);
  return solutions.size();
}

const Rational third = fraction(1, 3), sevenths = fraction(2, 7);

// Clamped with 1/3 and 2/7; a double and a triple (kink) knot; unclamped; quadratic with a kink; negative and wide.
const Knots cubic_knots{0, 0, 0, 0, sevenths, third, fraction(5, 6), 1, 1, 1, 1};
const Knots kinked_cubic_knots{0, 0, 0, 0, third, third, third, fraction(3, 5), fraction(3, 5), 1, 1, 1, 1};
const Knots uniform_knots{-3, -2, -1, 0, 1, 2, 3, 4, 5, 6};
const Knots quadratic_knots{-1, -1, -1, sevenths, sevenths, third, 2, 2, 2};

// The breaks where the spline is zero and does not cross zero with slopes of one sign on both sides: double roots and
// touching kinks.
std::size_t count_irregular_breaks(const Spline& f)
{
  const auto pieces = f.bezier_pieces();
  std::size_t count = 0;
  for (std::size_t i = 0; i <= pieces.size(); ++i) {
    const auto* before = i == 0 ? nullptr : &pieces[i - 1].coefficients();
    const auto* behind = i == pieces.size() ? nullptr : &pieces[i].coefficients();
    if (!CGAL::is_zero(behind != nullptr ? behind->front() : before->back()))
      continue;
    const int left = before != nullptr ? -CGAL::sign((*before)[before->size() - 2]) : CGAL::sign((*behind)[1]);
    const int right = behind != nullptr ? CGAL::sign((*behind)[1]) : left;
    count += left * right <= 0;
  }
  return count;
}

// One equation in one unknown against Descartes. Returns the number of roots.
std::size_t check_univariate(const Spline& f, const std::vector<Rational>& planted)
{
  System system({f.domain(0)});
  system.add(on_variables({0}, f), Relation::EQUAL);
  std::vector<Point> known;
  for (const Rational& root : planted) {
    EXPECT_EQ(de_boor(f, root), 0);
    known.push_back({root});
  }
  const std::size_t count = count_roots(f), irregular = count_irregular_breaks(f);
  const auto solutions = solve_with<SC::Certified_solver_traits>(system);
  if (irregular == 0)
    expect_solved({"spline in one unknown", system, count, known}, solutions);
  expect_nothing_lost(known, solutions);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), count);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), count - irregular);
  EXPECT_EQ(solutions.count(Solution_kind::CLUSTER), irregular);
  return count;
}

// The spline minus its value at a point: zero there.
Spline vanishing_at(const Spline& f, const Rational& u) { return f - de_boor(f, u); }

} // namespace

TEST(Spline_systems, RandomCurves)
{
  std::mt19937_64 random(1);
  std::size_t total = 0;
  for (int round = 0; round < 6; ++round) {
    total += check_intersection(random_curve(3, cubic_knots, random), random_curve(2, quadratic_knots, random));
    total += check_intersection(random_curve(3, kinked_cubic_knots, random), random_curve(3, uniform_knots, random));
    total += check_intersection(random_curve(2, quadratic_knots, random), random_curve(3, kinked_cubic_knots, random));
    total += check_intersection(random_curve(3, uniform_knots, random), random_curve(3, cubic_knots, random));
  }
  EXPECT_GE(total, 50u);
}

// Curves moved so that they meet at given parameters: at breaks of one or both, and at ends of one or both.
TEST(Spline_systems, CrossingsOnBreaksAndEnds)
{
  std::mt19937_64 random(2);
  const auto check_planted = [&](const Knots& a_knots, const Rational& t, const Knots& b_knots, const Rational& s) {
    const Curve a = random_curve(3, a_knots, random), b = random_curve(3, b_knots, random);
    check_intersection(a, b.moved(de_boor(a.x, t) - de_boor(b.x, s), de_boor(a.y, t) - de_boor(b.y, s)), {{t, s}});
  };
  for (int round = 0; round < 4; ++round) {
    check_planted(cubic_knots, sevenths, uniform_knots, fraction(1, 7));   // break and inside
    check_planted(cubic_knots, third, cubic_knots, sevenths);              // breaks of both
    check_planted(uniform_knots, 1, cubic_knots, fraction(5, 6));
    check_planted(cubic_knots, 0, uniform_knots, 3);                       // ends of both
    check_planted(cubic_knots, 1, cubic_knots, third);                     // end and break
    check_planted(uniform_knots, 0, kinked_cubic_knots, fraction(1, 2));   // end and inside
  }
}

// Crossings in the kinks of one and of both curves, which turn by little.
TEST(Spline_systems, CrossingsInKinks)
{
  const Knots knots{0, 0, 0, third, third, 1, 1, 1};   // quadratic, a kink at 1/3
  const Curve rising{Spline({2}, {knots}, {-4, -2, 0, 2, 5}), Spline({2}, {knots}, {-4, -1, 0, 1, 5})};
  const Curve falling{Spline({2}, {knots}, {-4, -2, 0, 1, 6}), Spline({2}, {knots}, {4, 1, 0, -1, -3})};
  EXPECT_EQ(check_intersection(rising, falling, {{third, third}}), 1u);
  const Curve smooth{Spline({3}, {uniform_knots}, {-6, -4, -2, 0, 2, 4}),
                     Spline({3}, {uniform_knots}, {5, 3, 1, -1, -3, -5})};
  check_intersection(rising, smooth.moved(-de_boor(smooth.x, 2), -de_boor(smooth.y, 2)), {{third, 2}});
}

TEST(Spline_systems, OneUnknown)
{
  std::mt19937_64 random(3);
  std::uniform_int_distribution<int> grid(-20, 20);
  std::size_t total = 0;
  const auto values = [&](std::size_t count) {
    std::vector<Rational> result;
    while (result.size() < count)
      result.push_back(fraction(grid(random), 3));
    return result;
  };
  for (int round = 0; round < 40; ++round) {
    const Spline f({3}, {cubic_knots}, values(cubic_knots.size() - 4)),
        g({2}, {quadratic_knots}, values(quadratic_knots.size() - 3));
    const Spline h({3}, {uniform_knots}, values(uniform_knots.size() - 4));
    for (const Rational& u : {Rational(0), sevenths, third, fraction(5, 6), Rational(1), fraction(1, 2)})
      total += check_univariate(vanishing_at(f, u), {u});
    for (const Rational& u : {Rational(-1), sevenths, third, Rational(2)})
      total += check_univariate(vanishing_at(g, u), {u});
    total += check_univariate(vanishing_at(h, 2), {2}) + check_univariate(f, {});
  }
  EXPECT_GE(total, 700u);
  // Kinks at 2/7 with slopes of one sign, however different.
  for (int slope : {1, 5, 1000, 1000000})
    EXPECT_EQ(check_univariate(Spline({2}, {quadratic_knots}, {-3, -1, 0, slope, slope + 2, slope + 3}), {sevenths}),
              1u);
}

// Differences of polygons on non-dyadic breaks: every break is a kink, and many of them are zero.
TEST(Spline_systems, Polygons)
{
  std::mt19937_64 random(4);
  std::uniform_int_distribution<int> height(-3, 3);
  const Knots first{0, 0, sevenths, third, fraction(3, 5), 1, 1},
      second{0, 0, fraction(1, 7), third, fraction(2, 3), 1, 1};
  std::size_t on_breaks = 0, irregular = 0;
  for (int round = 0; round < 400; ++round) {
    std::vector<Rational> a, b;
    for (int i = 0; i < 5; ++i) {
      a.push_back(height(random));
      b.push_back(height(random));
    }
    const Spline f = Spline({1}, {first}, a) - Spline({1}, {second}, b);
    std::vector<Rational> zeros;
    bool vanishes_between = false;
    for (const auto& piece : f.bezier_pieces())
      vanishes_between =
          vanishes_between || (CGAL::is_zero(piece.coefficients()[0]) && CGAL::is_zero(piece.coefficients()[1]));
    if (vanishes_between)
      continue;
    for (const Rational& u : f.breaks(0))
      if (CGAL::is_zero(de_boor(f, u)))
        zeros.push_back(u);
    check_univariate(f, zeros);
    on_breaks += zeros.size();
    irregular += count_irregular_breaks(f);
  }
  EXPECT_GE(on_breaks, 150u);
  EXPECT_GE(irregular, 20u);
}

// A circle of radius 5 as a rational quadratic spline with double knots, met by cubic splines: as often as these have
// x^2 + y^2 = 25.
TEST(Spline_systems, RationalCircle)
{
  using Quotient = SC::Rational_function<Spline>;
  std::vector<Rational> x, y, w;
  const int turn[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  // weights 1, 1, 2 of a quarter, times those of the arcs before
  for (int arc = 0, scale = 1; arc < 4; ++arc, scale *= 2) {
    const auto [c, s] = turn[arc];
    const int local[3][3] = {{1, 0, 1}, {1, 1, 1}, {0, 2, 2}};
    for (int i = arc == 0 ? 0 : 1; i < 3; ++i) {
      x.push_back(5 * scale * (c * local[i][0] - s * local[i][1]));
      y.push_back(5 * scale * (s * local[i][0] + c * local[i][1]));
      w.push_back(scale * local[i][2]);
    }
  }
  const Knots knots{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  std::mt19937_64 random(5);
  std::size_t total = 0;
  for (int round = 0; round < 6; ++round) {
    const Curve curve = random_curve(3, cubic_knots, random);
    const std::size_t count = count_roots(curve.x * curve.x + curve.y * curve.y - Rational(25));
    const std::vector<std::pair<Rational, Rational>> domain{{0, 4}, {0, 1}};
    System system(domain);
    const Spline weight = Spline({2}, {knots}, w).embedded(domain, {0});
    const Spline one = Spline({0}, {{0, 1}}, {1}).embedded(domain, {1});
    for (const auto& [numerator, other] : {std::pair(x, curve.x), std::pair(y, curve.y)}) {
      const Quotient difference = Quotient(Spline({2}, {knots}, numerator).embedded(domain, {0}), weight) -
          Quotient(other.embedded(domain, {1}), one);
      system.add(on_variables({0, 1}, difference.numerator()), Relation::EQUAL);
    }
    const auto solutions = solve_with<SC::Certified_solver_traits>(system);
    expect_solved({"rational circle", system, count, {}}, solutions);
    for (const auto& solution : solutions) {
      const Rational s = Rational(solution.point()[1]);
      const double distance =
          CGAL::to_double(de_boor(curve.x, s) * de_boor(curve.x, s) + de_boor(curve.y, s) * de_boor(curve.y, s) - 25);
      EXPECT_NEAR(distance, 0, 1e-10);
    }
    total += count;
  }
  EXPECT_GE(total, 6u);
}

// A piecewise inequality takes away exactly the solutions where it does not hold.
TEST(Spline_systems, PiecewiseInequality)
{
  std::mt19937_64 random(6);
  const Spline gate({1}, {{0, 0, sevenths, third, fraction(3, 4), 1, 1}}, {1, -1, 2, -2, fraction(1, 3)});
  std::size_t kept = 0, dropped = 0;
  for (int round = 0; round < 12; ++round) {
    const Curve a = random_curve(3, cubic_knots, random), b = random_curve(2, quadratic_knots, random);
    System system = intersection(a, b);
    const auto all = solve_with<SC::Certified_solver_traits>(system);
    system.add(on_variables({0}, gate), Relation::GREATER);
    const auto some = solve_with<SC::Certified_solver_traits>(system);
    EXPECT_TRUE(some.is_complete()) << some.summary();
    std::size_t expected = 0;
    for (const auto& solution : all) {
      const int sign = CGAL::sign(de_boor(gate, Rational(solution.point()[0])));
      expected += sign > 0;
      EXPECT_EQ(std::count_if(some.begin(), some.end(),
                              [&](const auto& s) { return contains(s.uniqueness_region(), solution.box()); }),
                sign > 0);
    }
    EXPECT_EQ(some.count(Solution_kind::CERTIFIED), expected);
    EXPECT_EQ(some.size(), expected);
    for (const auto& solution : some)
      EXPECT_TRUE(verify(system, solution));
    kept += expected;
    dropped += all.size() - expected;
  }
  EXPECT_GE(kept, 5u);
  EXPECT_GE(dropped, 5u);
}

template <class Traits>
class Spline_systems_of : public testing::Test
{};

using All_traits = testing::Types<SC::Fast_solver_traits, SC::Certified_solver_traits, SC::Interval_solver_traits,
                                  SC::Multiprecision_solver_traits, SC::Exact_solver_traits>;
TYPED_TEST_SUITE(Spline_systems_of, All_traits);

TYPED_TEST(Spline_systems_of, BreaksOfBoth)
{
  const Knots knots{0, 0, 0, third, 1, 1, 1}, others{0, 0, 0, sevenths, sevenths, 1, 1, 1};
  const Curve a{Spline({2}, {knots}, {-4, -1, 2, 4}), Spline({2}, {knots}, {-3, 1, -2, 3})};
  const Curve b{Spline({2}, {others}, {-3, 0, 1, 2, 0}), Spline({2}, {others}, {-4, -2, -1, 1, 4})};
  const std::size_t count = check_intersection<TypeParam>(
      a, b.moved(de_boor(a.x, third) - de_boor(b.x, sevenths), de_boor(a.y, third) - de_boor(b.y, sevenths)),
      {{third, sevenths}});
  EXPECT_GE(count, 1u);
}

} // namespace spline_systems_test
