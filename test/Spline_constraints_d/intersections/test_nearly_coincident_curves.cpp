// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves that nearly coincide: the answers are exact, and the work does not grow with their nearness. Corners.
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elimination/Eliminated_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Aff_transformation_3.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace nearly_coincident_curves_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Intersection_kind;
using SC::Passage;

using K = CGAL::Simple_cartesian<Exact_rational>;
using Curve_2 = SC::Bspline_curve_2<K>;
using Range = std::pair<Exact_rational, Exact_rational>;
using Coefficients = std::vector<Exact_rational>; // in powers, the constant one first

constexpr std::size_t few_nodes = 510;

Exact_rational power_of_ten(int exponent)
{
  Exact_rational result(1);
  for (int i = 0; i < -exponent; ++i)
    result /= 10;
  return result;
}

Range at(const Exact_rational& x) { return {x, x}; }

bool holds(const Range& range, const Exact_rational& x) { return range.first <= x && x <= range.second; }

// A parabola, and a part of it whose middle control point is moved up: they meet in the ends of the part alone.
TEST(Nearly_coincident_curves, PartOfAParabola)
{
  const Curve_2 parabola = SC::bezier_curve(std::vector<K::Point_2>{{48, 84}, {100, 187}, {166, 37}});
  const auto part = [](const Exact_rational& shift) {
    return SC::bezier_curve(std::vector<K::Point_2>{{Exact_rational(74.875), Exact_rational(119.6875)},
                                                    {Exact_rational(95.6875), Exact_rational(134.59375) + shift},
                                                    {Exact_rational(118.46875), Exact_rational(113.921875)}});
  };
  const Exact_rational quarter(0.25), end(0.625);
  for (const int exponent : {-3, -4, -6, -9, -12, -15, -16, -17, -30, -100, -300})
    for (const int sign : {1, -1}) {
      const auto found = SC::intersections(parabola, part(sign * power_of_ten(exponent)));
      ASSERT_TRUE(found.is_complete()) << exponent;
      ASSERT_EQ(found.size(), 2u) << exponent;
      EXPECT_LE(found.summary().nodes, few_nodes) << exponent;
      for (const std::size_t i : {0, 1}) {
        EXPECT_EQ(found[i].kind(), Intersection_kind::END_POINT);
        EXPECT_EQ(found[i].multiplicity(), 1);
        EXPECT_FALSE(found[i].is_at_end(0));
        EXPECT_TRUE(found[i].is_at_end(1));
        EXPECT_TRUE(holds(found[i].parameter_range(0), i == 0 ? quarter : end));
        EXPECT_EQ(found[i].parameter_range(1), at(static_cast<int>(i)));
        EXPECT_EQ(found[i].point(),
                  i == 0 ? K::Point_2(Exact_rational(74.875), Exact_rational(119.6875))
                         : K::Point_2(Exact_rational(118.46875), Exact_rational(113.921875)));
        EXPECT_FALSE(found[i].passage());
      }
    }
  const auto same = SC::intersections(parabola, part(0));
  EXPECT_TRUE(same.is_complete());
  ASSERT_EQ(same.size(), 1u);
  EXPECT_EQ(same[0].kind(), Intersection_kind::OVERLAP);
  EXPECT_EQ(same[0].parameter_range(0), Range(quarter, end));
  EXPECT_EQ(same[0].parameter_range(1), Range(0, 1));
}

Coefficients product(const Coefficients& a, const Coefficients& b)
{
  Coefficients result(a.size() + b.size() - 1, Exact_rational(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      result[i + j] += Exact_rational(a[i] * b[j]);
  return result;
}

void add_multiple(Coefficients& sum, const Coefficients& a, const Exact_rational& factor)
{
  sum.resize((std::max)(sum.size(), a.size()), Exact_rational(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    sum[i] += Exact_rational(factor * a[i]);
}

// The Bernstein coefficients over an interval.
Coefficients bernstein_coefficients(const Coefficients& polynomial, int degree, const Range& domain)
{
  Coefficients local(static_cast<std::size_t>(degree) + 1, Exact_rational(0));
  for (std::size_t i = polynomial.size(); i-- > 0;) { // Horner's scheme in the local parameter
    for (std::size_t j = local.size() - 1; j > 0; --j)
      local[j] = Exact_rational(local[j] * domain.first + local[j - 1] * (domain.second - domain.first));
    local[0] = Exact_rational(local[0] * domain.first + polynomial[i]);
  }
  Exact_rational binomial(1);
  for (int k = 1; k <= degree; ++k) {
    binomial *= Exact_rational(degree - k + 1, k);
    local[static_cast<std::size_t>(k)] /= binomial;
  }
  for (int round = 0; round < degree; ++round)
    for (int j = degree; j > round; --j)
      local[static_cast<std::size_t>(j)] += local[static_cast<std::size_t>(j) - 1];
  return local;
}

template <int d>
using Curve = std::conditional_t<d == 2, Curve_2, SC::Bspline_curve_3<K>>;

// The image of a curve with these coordinates by a projective map.
template <int d>
Curve<d> image(const std::vector<Coefficients>& coordinates, const std::vector<Coefficients>& map, int degree,
               const Range& domain)
{
  std::vector<Coefficients> homogeneous;
  for (const Coefficients& row : map) {
    Coefficients sum;
    for (int j = 0; j <= d; ++j)
      add_multiple(sum, j < d ? coordinates[j] : Coefficients{Exact_rational(1)}, row[j]);
    homogeneous.push_back(bernstein_coefficients(sum, degree, domain));
  }
  std::vector<typename Curve<d>::Point> points;
  for (int k = 0; k <= degree; ++k) {
    std::array<Exact_rational, d> x;
    for (int i = 0; i < d; ++i)
      x[i] = homogeneous[i][k] / homogeneous[d][k];
    points.push_back(std::apply([](const auto&... c) { return typename Curve<d>::Point(c...); }, x));
  }
  std::vector<Exact_rational> knots(static_cast<std::size_t>(degree) + 1, domain.first);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, domain.second);
  return Curve<d>(degree, knots, points, homogeneous[d]);
}

struct Planted_point
{
  Exact_rational parameter;
  int multiplicity;
};

/*
The graphs of p and p + e f, with the zeros of f known, some of them multiple, and some at the ends of the second one,
in other coordinates: in those of a projective map, pieces of conics and rational cubics and quartics.
*/
template <int d>
void expect_planted_points(int degree, bool is_rational, int exponent, int rounds)
{
  std::mt19937 random(static_cast<unsigned>(100 * degree + 10 * d + is_rational));
  const auto integer = [&](int lower, int upper) {
    return lower + static_cast<int>(random() % static_cast<unsigned>(upper - lower + 1));
  };
  for (int round = 0; round < rounds; ++round) {
    const Range first{-2, 2}, second{Exact_rational(integer(-9, -5), 10), Exact_rational(integer(5, 9), 10)};
    std::vector<Coefficients> x{{Exact_rational(0), Exact_rational(1)}};
    for (int i = 1; i < d; ++i) {
      x.emplace_back();
      for (int k = 0; k <= degree; ++k)
        x.back().push_back(Exact_rational(k == degree ? 1 + integer(0, 8) : integer(-9, 9), 3));
    }
    Coefficients f{Exact_rational(1)};
    std::vector<Planted_point> planted;
    const auto plant = [&](const Exact_rational& zero, int multiplicity) {
      for (int k = 0; k < multiplicity; ++k)
        f = product(f, {Exact_rational(-zero), Exact_rational(1)});
      if (holds(second, zero))
        planted.push_back({zero, multiplicity});
    };
    int rest = degree;
    for (const Exact_rational& end : {second.first, second.second})
      if (rest > 0 && integer(0, 1) == 0) {
        plant(end, 1);
        --rest;
      }
    for (int place = integer(-30, 0); rest > 0 && integer(0, 3) != 0; place += integer(3, 12)) {
      const int multiplicity = integer(1, rest);
      const Exact_rational zero(place, 13); // no end
      plant(zero, multiplicity);
      rest -= multiplicity;
    }
    std::vector<Coefficients> y = x, map;
    for (int i = 1; i < d; ++i)
      add_multiple(y[i], f, power_of_ten(exponent) * integer(1, 5));
    for (int i = 0; i <= d; ++i) {
      map.emplace_back();
      for (int j = 0; j <= d; ++j)
        map.back().push_back(i < d ? Exact_rational(integer(-3, 3) + (i == j ? 7 : 0))
                                   : Exact_rational(j == d                      ? 1
                                                        : j == 0 && is_rational ? Exact_rational(1, 5)
                                                                                : 0));
    }
    const Curve<d> a = image<d>(x, map, degree, first), b = image<d>(y, map, degree, second);
    const bool is_first = round % 2 == 0;
    const auto found = is_first ? SC::intersections(a, b) : SC::intersections(b, a);
    const std::size_t part = is_first ? 1 : 0;
    ASSERT_TRUE(found.is_complete()) << degree << ' ' << round << ' ' << found.summary();
    EXPECT_LE(found.summary().nodes, few_nodes);
    EXPECT_EQ(found.size(), planted.size()) << degree << ' ' << round;
    for (const Planted_point& point : planted) {
      const auto is_it = [&](const auto& x) {
        return holds(x.parameter_range(0), point.parameter) && holds(x.parameter_range(1), point.parameter);
      };
      ASSERT_EQ(std::count_if(found.begin(), found.end(), is_it), 1) << degree << ' ' << round;
      const auto& answer = *std::find_if(found.begin(), found.end(), is_it);
      const bool is_end = point.parameter == second.first || point.parameter == second.second;
      EXPECT_EQ(answer.multiplicity(), point.multiplicity) << degree << ' ' << round;
      EXPECT_EQ(answer.is_at_end(part), is_end);
      EXPECT_FALSE(answer.is_at_end(1 - part));
      EXPECT_EQ(answer.kind(),
                point.multiplicity > 1 ? Intersection_kind::TANGENT
                    : is_end           ? Intersection_kind::END_POINT
                                       : Intersection_kind::TRANSVERSAL);
      const std::optional<Passage> passage = point.multiplicity % 2 != 0 ? Passage::CROSSES : Passage::TOUCHES;
      EXPECT_EQ(answer.passage(), d == 2 && !is_end ? passage : std::nullopt);
      for (const std::size_t k : {0, 1})
        EXPECT_LT(answer.parameter_range(k).second - answer.parameter_range(k).first, Exact_rational(1e-9));
    }
  }
}

TEST(Nearly_coincident_curves, PlantedPointsInThePlane)
{
  for (const int degree : {2, 3, 4})
    for (const bool is_rational : {false, true})
      for (const int exponent : {-1, -3, -6, -9, -12, -15, -16, -17, -40, -300})
        expect_planted_points<2>(degree, is_rational, exponent, 6);
}

TEST(Nearly_coincident_curves, PlantedPointsInSpace)
{
  for (const int degree : {2, 3, 4})
    for (const bool is_rational : {false, true})
      for (const int exponent : {-1, -3, -9, -15, -40, -300})
        expect_planted_points<3>(degree, is_rational, exponent, degree == 4 ? 3 : 6);
}

// A closed cubic outline, and the same with each second control point moved by a little: they cross next to the knots.
TEST(Nearly_coincident_curves, OutlinesOfManyPieces)
{
  std::mt19937 random(3);
  std::vector<K::Point_2> points, moved;
  std::vector<Exact_rational> knots;
  constexpr int size = 12;
  for (int i = 0; i <= size; ++i)
    knots.push_back(i);
  const int xs[] = {10, 9, 5, 0, -5, -9, -10, -9, -5, 0, 5, 9}, ys[] = {0, 5, 9, 10, 9, 5, 0, -5, -9, -10, -9, -5};
  for (int i = 0; i < size; ++i)
    points.emplace_back(xs[i] + static_cast<int>(random() % 3), ys[i]);
  std::optional<std::size_t> number;
  for (const int exponent : {-4, -8, -16, -32, -100}) {
    moved = points;
    for (int i = 0; i < size; i += 3)
      moved[i] = moved[i] + K::Vector_2(power_of_ten(exponent) * (i % 2 == 0 ? 1 : -1), power_of_ten(exponent));
    const auto found =
        SC::intersections(Curve_2::from_periodic(3, knots, points), Curve_2::from_periodic(3, knots, moved));
    ASSERT_TRUE(found.is_complete()) << exponent << ' ' << found.summary();
    EXPECT_LE(found.summary().nodes, 50000u);
    EXPECT_EQ(found.size(), number.value_or(found.size())) << exponent;
    EXPECT_EQ(found.size() % 2, 0u); // all are crossings
    EXPECT_GT(found.size(), 0u);
    for (const auto& x : found)
      EXPECT_EQ(x.passage(), Passage::CROSSES);
    number = found.size();
  }
}

// Of the pieces of an outline, some are those of another one, and some nearly: the overlaps of neighbouring pieces are
// one, and their ends are no other answers.
TEST(Nearly_coincident_curves, SomePiecesOverlap)
{
  const std::vector<Exact_rational> knots{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 5};
  const std::vector<K::Point_2> points{{0, 0},   {2, 5},  {4, 4},  {8, 8},   {9, 3}, {14, 2},
                                       {12, -3}, {8, -7}, {3, -6}, {-2, -4}, {0, 0}};
  for (const int exponent : {-3, -6, -12, -20, -100}) {
    std::vector<K::Point_2> moved = points;
    moved[5] = moved[5] + K::Vector_2(power_of_ten(exponent), 0); // of the piece from 2 to 3
    moved[9] = moved[9] + K::Vector_2(0, power_of_ten(exponent)); // and from 4 to 5
    const auto found = SC::intersections(Curve_2(2, knots, points), Curve_2(2, knots, moved));
    ASSERT_TRUE(found.is_complete()) << exponent << ' ' << found.summary();
    EXPECT_LE(found.summary().nodes, 5000u) << exponent;
    ASSERT_EQ(found.size(), 3u) << exponent;
    EXPECT_EQ(found.count(Intersection_kind::OVERLAP), 2u);
    EXPECT_EQ(found[2].kind(), Intersection_kind::TRANSVERSAL); // near where the last piece goes upwards
    EXPECT_NEAR(found[2].parameter(0), 4.714, 1e-3);
    for (const std::size_t k : {0, 1}) {
      EXPECT_EQ(found[0].parameter_range(k), Range(0, 2));
      EXPECT_EQ(found[1].parameter_range(k), Range(3, 4));
    }
  }
}

// Splines with corners, with or without weights, closed or cut, beside copies with some control points moved by little:
// what they have in common does not depend on how little it is.
TEST(Nearly_coincident_curves, RandomSplines)
{
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::optional<std::array<std::size_t, 3>> expected;
    for (const int exponent : {-6, -12, -40}) {
      std::mt19937 random(seed);
      const auto integer = [&](int lower, int upper) {
        return lower + static_cast<int>(random() % static_cast<unsigned>(upper - lower + 1));
      };
      const int degree = integer(2, 3), pieces = integer(1, 5);
      std::vector<Exact_rational> knots(static_cast<std::size_t>(degree) + 1, Exact_rational(0)), weights;
      for (int i = 1; i < pieces; ++i)
        knots.insert(knots.end(), static_cast<std::size_t>(integer(1, degree)), Exact_rational(i));
      knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, Exact_rational(pieces));
      std::vector<K::Point_2> points;
      const bool is_rational = integer(0, 2) == 0;
      while (points.size() + static_cast<std::size_t>(degree) + 1 < knots.size()) {
        points.emplace_back(static_cast<int>(points.size()) * 10 + integer(0, 12), integer(0, 40));
        if (is_rational)
          weights.push_back(Exact_rational(integer(1, 3)));
      }
      if (integer(0, 3) == 0)
        points.back() = points.front();
      std::vector<K::Point_2> moved = points;
      for (int i = integer(1, 3); i > 0; --i) {
        K::Point_2& point = moved[static_cast<std::size_t>(integer(0, static_cast<int>(moved.size()) - 1))];
        const int x = integer(-3, 3), y = integer(-3, 3);
        point = point + power_of_ten(exponent) * K::Vector_2(x, y);
      }
      Curve_2 near(degree, knots, moved, weights);
      if (integer(0, 2) == 0) {
        const int begin = integer(1, 4), end = integer(5, 8);
        near = near.restricted(Exact_rational(begin * pieces, 9), Exact_rational(end * pieces, 9));
      }
      const auto found = SC::intersections(Curve_2(degree, knots, points, weights), near);
      EXPECT_TRUE(found.is_complete()) << seed << ' ' << exponent;
      EXPECT_LE(found.summary().nodes, 20000u) << seed << ' ' << exponent;
      const std::array counts{found.size(), found.count(Intersection_kind::OVERLAP),
                              found.count(Intersection_kind::TRANSVERSAL)};
      EXPECT_EQ(counts, expected.value_or(counts)) << seed << ' ' << exponent;
      expected = counts;
    }
  }
}

// y = x^2, z = x^4 touches a curve on the planes through its points and the direction (0, 1, 2) where x^2 = 2.
TEST(Nearly_coincident_curves, CurvesInSpaceThatTouchAtIrrationalParameters)
{
  const std::vector<Coefficients> identity{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  const Coefficients x{0, 1}, square{0, 0, 1}, quartic{0, 0, 0, 0, 1}, contact{4, 0, -4, 0, 1}; // (x^2 - 2)^2
  for (const int exponent : {0, -10}) {
    Coefficients y = square, z = quartic;
    add_multiple(y, contact, power_of_ten(exponent));
    add_multiple(z, contact, 2 * power_of_ten(exponent));
    const auto found = SC::intersections(image<3>({x, square, quartic}, identity, 4, {-2, 2}),
                                         image<3>({x, y, z}, identity, 4, {-2, 2}));
    EXPECT_TRUE(found.is_complete());
    ASSERT_EQ(found.size(), 2u);
    for (const auto& point : found) {
      EXPECT_EQ(point.kind(), Intersection_kind::TANGENT);
      EXPECT_EQ(point.multiplicity(), 2);
      EXPECT_NEAR(point.parameter(0) * point.parameter(0), 2, 1e-12);
    }
  }
}

// All points by elimination, where the solver finds them, too: curves with loops through the point at which the other
// one crosses itself included, straight ones, with breaks and with corners.
template <int d>
void expect_those_of_the_solver(int range, int rounds)
{
  namespace internal = SC::internal;
  std::mt19937 random(static_cast<unsigned>(17 * d + range));
  const auto integer = [&](int lower, int upper) {
    return lower + static_cast<int>(random() % static_cast<unsigned>(upper - lower + 1));
  };
  const auto curve = [&] {
    const int degree = integer(1, 3), pieces = integer(1, 3);
    std::vector<Exact_rational> knots(static_cast<std::size_t>(degree) + 1, Exact_rational(0)), weights;
    for (int i = 1; i < pieces; ++i)
      knots.insert(knots.end(), static_cast<std::size_t>(integer(1, degree)), Exact_rational(i));
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, Exact_rational(pieces));
    std::vector<typename Curve<d>::Point> points;
    const bool is_rational = integer(0, 2) == 0;
    while (points.size() + static_cast<std::size_t>(degree) + 1 < knots.size()) {
      std::array<Exact_rational, d> x;
      for (Exact_rational& c : x)
        c = integer(-range, range);
      points.push_back(std::apply([](const auto&... c) { return typename Curve<d>::Point(c...); }, x));
      if (is_rational)
        weights.push_back(Exact_rational(integer(1, 3)));
    }
    if (integer(0, 3) == 0)
      points.back() = points.front();
    return Curve<d>(degree, knots, points, weights);
  };
  std::size_t number = 0, points = 0;
  for (int round = 0; round < rounds; ++round) {
    const Curve<d> a = curve();
    Curve<d> b = curve();
    if constexpr (d == 3) // in a point
      b = b.transformed(CGAL::Aff_transformation_3<K>(
          CGAL::TRANSLATION, a(a.domain().second * integer(0, 4) / 4) - b(b.domain().second * integer(0, 4) / 4)));
    const internal::Common::Patch_pair<d> pair{internal::Common::Spline_patch<d>(a),
                                               internal::Common::Spline_patch<d>(b)};
    const auto eliminated = internal::Intersections::Eliminated_points<d>(pair, [] {})();
    const auto expected = SC::intersections(a, b);
    if (!eliminated || !expected.is_complete())
      continue;
    ++number;
    ASSERT_EQ(eliminated->size(), expected.size()) << d << ' ' << round;
    for (const auto& x : expected) {
      ++points;
      EXPECT_EQ(
          std::count_if(
              eliminated->begin(), eliminated->end(),
              [&](const auto& y) {
                return internal::Common::have_common_part(y.parameters, {x.parameter_range(0), x.parameter_range(1)});
              }),
          1)
          << d << ' ' << round;
      // one is that of a corner
      EXPECT_TRUE(d == 3 || x.kind() != Intersection_kind::TANGENT || x.multiplicity() != 1) << round;
    }
  }
  EXPECT_GT(number, static_cast<std::size_t>(rounds) / 2);
  EXPECT_GT(points, number / 4);
}

TEST(Nearly_coincident_curves, EliminationFindsWhatTheSolverFinds)
{
  for (const int range : {1, 2, 20})
    expect_those_of_the_solver<2>(range, 60);
  for (const int range : {1, 2})
    expect_those_of_the_solver<3>(range, 60);
}

// The cubic x^2 (x + 1) = y^2 passes through the origin twice. A curve through it meets it twice there, with different
// parameters; one that does not come near it again has no other points.
TEST(Nearly_coincident_curves, DoublePoints)
{
  namespace internal = SC::internal;
  // (t^2 - 1, t^3 - t) for t in [-2,2]
  const std::vector<Coefficients> identity{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Curve_2 loop = image<2>({{-1, 0, 1}, {0, -1, 0, 1}}, identity, 3, {-2, 2});
  const Curve_2 line = SC::segment_curve(K::Point_2(0, -1), K::Point_2(0, 2)),
                other = image<2>({{-1, 0, 1}, {0, -2, 0, 2}}, identity, 3, {-2, 2}), // its node is the same point
      half = loop.restricted(0, 2);
  const auto eliminated = [](const Curve_2& a, const Curve_2& b) {
    return internal::Intersections::Eliminated_points<2>(
        {internal::Common::Spline_patch<2>(a), internal::Common::Spline_patch<2>(b)}, [] {})();
  };
  for (const bool is_first : {true, false}) {
    const auto both = is_first ? eliminated(loop, line) : eliminated(line, loop);
    ASSERT_TRUE(both);
    EXPECT_EQ(both->size(), 2u);
    for (const auto& point : *both)
      EXPECT_EQ(point.kind, Intersection_kind::TRANSVERSAL);
    const auto one = is_first ? eliminated(half, line) : eliminated(line, half);
    ASSERT_TRUE(one);
    EXPECT_EQ(one->size(), 1u);
    EXPECT_FALSE(is_first ? eliminated(loop, other) : eliminated(other, loop)); // the solver decides
    const auto four = is_first ? SC::intersections(loop, other) : SC::intersections(other, loop);
    EXPECT_TRUE(four.is_complete());
    EXPECT_EQ(four.size(), 5u); // with the one at (-1, 0)
  }
}

// How outlines pass through a corner that both have.
TEST(Nearly_coincident_curves, CornersCrossOrTouch)
{
  using Points = std::vector<K::Point_2>;
  const auto path = [](const Points& points) { return SC::polyline_curve(points); };
  const Curve_2 corner = path({{4, 0}, {0, 0}, {0, 4}});
  const auto expect_passage = [&](const Curve_2& a, const Curve_2& b, Passage passage) {
    for (const bool is_swapped : {false, true}) {
      const auto found = is_swapped ? SC::intersections(b, a) : SC::intersections(a, b);
      EXPECT_TRUE(found.is_complete());
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].passage(), passage);
      EXPECT_EQ(found[0].kind(),
                passage == Passage::CROSSES ? Intersection_kind::TRANSVERSAL : Intersection_kind::TANGENT);
      for (const std::size_t k : {0, 1})
        EXPECT_TRUE(holds(found[0].parameter_range(k), Exact_rational(found[0].is_at_end(k) ? 0 : 1, 2)) ||
                    holds(found[0].parameter_range(k), 1));
    }
  };
  expect_passage(corner, path({{1, 2}, {0, 0}, {-2, 1}}), Passage::CROSSES);
  expect_passage(corner, path({{1, 2}, {0, 0}, {3, 1}}), Passage::TOUCHES);
  expect_passage(corner, path({{-1, 2}, {0, 0}, {-3, 1}}), Passage::TOUCHES);
  expect_passage(corner, path({{-1, -2}, {0, 0}, {1, -2}}), Passage::TOUCHES);
  expect_passage(corner, path({{-4, 0}, {0, 0}, {0, -4}}), Passage::TOUCHES); // on the same lines
  expect_passage(corner, path({{-4, 4}, {0, 0}, {4, 4}}), Passage::CROSSES);
}

// In the same directions, the curvatures tell, or what comes after them.
TEST(Nearly_coincident_curves, CornersWithCommonTangents)
{
  using Point = K::Point_2;
  const auto joined = [](const Point& p, const Point& q, const Point& r, const Point& s) { // with a corner at 0
    return Curve_2(2, {0, 0, 0, 1, 1, 2, 2, 2}, {p, q, Point(0, 0), r, s});
  };
  // comes from the left on the x-axis, and leaves upwards
  const Curve_2 a = joined({-4, 1}, {-2, 0}, {0, 2}, {-1, 4});
  const auto found = [&](const Point& p, const Point& s) {
    return SC::intersections(a, joined(p, {-2, 0}, {0, 2}, s));
  };
  for (const auto& [p, s, passage] : {std::tuple(Point(-4, 2), Point(-2, 4), Passage::TOUCHES),
                                      std::tuple(Point(-4, 2), Point(1, 4), Passage::CROSSES),
                                      std::tuple(Point(-4, -1), Point(1, 4), Passage::TOUCHES),
                                      std::tuple(Point(-4, -1), Point(-2, 4), Passage::CROSSES)}) {
    const auto result = found(p, s);
    EXPECT_TRUE(result.is_complete());
    ASSERT_EQ(result.size(), 1u);
    EXPECT_EQ(result[0].kind(), Intersection_kind::TANGENT);
    EXPECT_NE(result[0].multiplicity(), 1);
    EXPECT_EQ(result[0].passage(), passage);
  }
}

// Squares that have a corner in common, which is the begin of one or of both: reported once.
TEST(Nearly_coincident_curves, CornersOnSeams)
{
  using Points = std::vector<K::Point_2>;
  const auto path = [](const Points& points) { return SC::polyline_curve(points); };
  const Curve_2 square = path({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}}),
                next = path({{4, 4}, {8, 4}, {8, 8}, {4, 8}, {4, 4}}), across = path({{0, 0}, {-2, 1}, {1, 1}, {0, 0}});
  const auto touching = SC::intersections(square, next);
  EXPECT_TRUE(touching.is_complete());
  ASSERT_EQ(touching.size(), 1u);
  EXPECT_EQ(touching[0].kind(), Intersection_kind::TANGENT);
  EXPECT_EQ(touching[0].passage(), Passage::TOUCHES);
  EXPECT_EQ(touching[0].point(), K::Point_2(4, 4));
  const auto crossing = SC::intersections(square, across);
  EXPECT_TRUE(crossing.is_complete());
  ASSERT_EQ(crossing.size(), 2u);
  EXPECT_EQ(crossing[0].kind(), Intersection_kind::END_POINT);
  EXPECT_EQ(crossing[0].passage(), Passage::CROSSES);
  EXPECT_EQ(crossing[1].kind(), Intersection_kind::TRANSVERSAL);
}

// With a limit or a visitor that stops, the answer is incomplete.
TEST(Nearly_coincident_curves, Limits)
{
  struct Stopping_visitor : SC::Default_solver_visitor
  {
    bool stop() const { return true; }
  };
  Stopping_visitor visitor;
  const Curve_2 parabola = SC::bezier_curve(std::vector<K::Point_2>{{0, 0}, {1, 2}, {2, 0}});
  const Curve_2 near = SC::bezier_curve(std::vector<K::Point_2>{{0, 0}, {1, 2 + power_of_ten(-20)}, {2, 0}});
  const auto stopped = SC::intersections(parabola, near, {.visitor = visitor});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
  const auto limited = SC::intersections(parabola, near, {.node_limit = 10});
  EXPECT_TRUE(limited.is_complete());
  EXPECT_EQ(limited.count(Intersection_kind::END_POINT), 2u);
  EXPECT_EQ(limited.size(), 2u);
}

} // namespace

} // namespace nearly_coincident_curves_test
