// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_tensors.h"

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Bspline_function_test {

namespace {

using CGAL::Spline_constraints::Invalid_input;
using FT = CGAL::Spline_constraints::Exact_rational;
using Tensor = CGAL::Spline_constraints::Bernstein_tensor<FT>;
using Spline = CGAL::Spline_constraints::Bspline_function<FT>;
using Double_spline = CGAL::Spline_constraints::Bspline_function<double>;

// The recursive definition of the B-spline N_{i,d}, right-continuous and, at the end of the domain, left-continuous.
FT basis(const std::vector<FT>& t, std::size_t i, int d, const FT& u, const FT& domain_end)
{
  if (d == 0) {
    const bool is_last = u == domain_end;
    return (is_last ? t[i] < u && u <= t[i + 1] : t[i] <= u && u < t[i + 1]) ? FT(1) : FT(0);
  }
  FT value(0);
  if (t[i] < t[i + d])
    value += (u - t[i]) / (t[i + d] - t[i]) * basis(t, i, d - 1, u, domain_end);
  if (t[i + 1] < t[i + d + 1])
    value += (t[i + d + 1] - u) / (t[i + d + 1] - t[i + 1]) * basis(t, i + 1, d - 1, u, domain_end);
  return value;
}

FT by_definition(const Spline& f, const std::vector<FT>& u)
{
  FT sum(0);
  for (std::size_t i = 0; i < f.coefficients().size(); ++i) {
    FT term = f.coefficients()[i];
    std::size_t rest = i;
    for (int j = f.dimension(); j-- > 0;) {
      term *= basis(f.knots(j), rest % f.size(j), f.degree(j), u[j], f.domain(j).second);
      rest /= f.size(j);
    }
    sum += term;
  }
  return sum;
}

struct Random_splines
  : Random_source
{
  using Random_source::Random_source;

  // Knots from 0 to 1 with inner ones of multiplicity up to `highest`, clamped or floating at either end.
  std::vector<FT> knots(int degree, int highest)
  {
    std::vector<FT> result;
    std::vector<FT> inner;
    for (int k = integer(0, 3); k > 0 && highest > 0; --k) {
      const FT knot = FT(integer(1, 11)) / FT(12);
      if (std::find(inner.begin(), inner.end(), knot) == inner.end())
        inner.insert(inner.end(), integer(1, highest), knot);
    }
    std::sort(inner.begin(), inner.end());
    const bool begins_floating = integer(0, 1) == 1, ends_floating = integer(0, 1) == 1;
    for (int i = 0; i < degree; ++i)
      result.push_back(begins_floating ? FT(-degree + i + integer(0, 1)) / FT(7) : FT(0));
    std::sort(result.begin(), result.end());
    result.push_back(FT(0));
    result.insert(result.end(), inner.begin(), inner.end());
    for (int i = 0; i <= degree; ++i)
      result.push_back(ends_floating && i > 0 ? FT(1) + FT(i) / FT(5) : FT(1));
    return result;
  }

  // At every inner knot at least as many continuous derivatives as `lowest_smoothness`.
  Spline spline(int dimension, int highest_degree = 4, int lowest_smoothness = 0)
  {
    std::vector<int> degrees;
    std::vector<std::vector<FT>> all;
    std::size_t size = 1;
    for (int j = 0; j < dimension; ++j) {
      degrees.push_back(integer(0, highest_degree));
      all.push_back(knots(degrees[j], (std::max)(0, degrees[j] - lowest_smoothness)));
      size *= all[j].size() - degrees[j] - 1;
    }
    return Spline(degrees, all, numbers(size));
  }

  std::vector<FT> domain_point(int dimension)
  {
    std::vector<FT> u = point(dimension);
    for (FT& x : u)
      if (integer(0, 3) == 0)   // on a possible knot
        x = FT(integer(0, 12)) / FT(12);
    return u;
  }
};

constexpr int rounds = 30;

TEST(Bspline_function, evaluates_its_recursive_definition)
{
  Random_splines random(1);
  for (int n = 0; n <= 3; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Spline f = random.spline(n, n < 3 ? 4 : 2);
      const std::vector<FT> u = random.domain_point(n);
      EXPECT_EQ(f(u), by_definition(f, u));
    }
}

TEST(Bspline_function, pieces_equal_the_spline_on_every_cell)
{
  Random_splines random(2);
  std::size_t cells_seen = 0;
  for (int n = 0; n <= 3; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Spline f = random.spline(n, n < 3 ? 4 : 2);
      const std::vector<Tensor> pieces = f.bezier_pieces();
      std::size_t cells = 1;
      for (int j = 0; j < n; ++j)
        cells *= f.breaks(j).size() - 1;
      ASSERT_EQ(pieces.size(), cells);
      cells_seen += cells;
      for (std::size_t c = 0; c < cells; ++c) {
        std::vector<FT> u(n), local = random.point(n);
        std::size_t rest = c;
        for (int j = n; j-- > 0;) {
          const std::vector<FT> breaks = f.breaks(j);
          const std::size_t k = rest % (breaks.size() - 1);
          rest /= breaks.size() - 1;
          u[j] = (FT(1) - local[j]) * breaks[k] + local[j] * breaks[k + 1];
        }
        EXPECT_EQ(pieces[c](local), by_definition(f, u));
        EXPECT_EQ(pieces[c].degrees(), f.degrees());
      }
    }
  EXPECT_GT(cells_seen, 300u);
}

TEST(Bspline_function, breaks_of_known_knots)
{
  const Spline clamped({2}, {{0, 0, 0, 1, 1, 3, 3, 3}}, {1, 2, 3, 4, 5});
  EXPECT_EQ(clamped.breaks(0), (std::vector<FT>{0, 1, 3}));
  const Spline floating({2}, {{0, 1, 2, 3, 4, 5}}, {0, 0, 1});
  EXPECT_EQ(floating.breaks(0), (std::vector<FT>{2, 3}));
  EXPECT_EQ(floating.domain(0), (std::pair<FT, FT>(FT(2), FT(3))));
  // The uniform quadratic B-spline rises as x^2 / 2.
  EXPECT_EQ(floating.bezier_pieces()[0].coefficients(), (std::vector<FT>{0, 0, FT(1) / FT(2)}));
}

TEST(Bspline_function, constant_control_points_give_a_constant)
{
  Random_splines random(3);
  for (int i = 0; i < rounds; ++i) {
    const Spline f = random.spline(2);
    std::vector<std::vector<FT>> knots{f.knots(0), f.knots(1)};
    const Spline constant(f.degrees(), knots, std::vector<FT>(f.coefficients().size(), FT(7)));
    EXPECT_EQ(constant(random.domain_point(2)), FT(7));
    for (const Tensor& piece : constant.bezier_pieces())
      EXPECT_EQ(piece.bounds(), (std::pair<FT, FT>(FT(7), FT(7))));
  }
}

TEST(Bspline_function, derivatives_are_those_of_the_pieces)
{
  Random_splines random(4);
  int with_knots = 0;
  for (int n = 1; n <= 2; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Spline f = random.spline(n, 4, 1);
      const std::vector<Tensor> pieces = f.bezier_pieces();
      with_knots += pieces.size() > 1;
      for (int axis = 0; axis < n; ++axis) {
        const Spline derivative = f.derivative(axis);
        const std::vector<Tensor> derivative_pieces = derivative.bezier_pieces();
        ASSERT_EQ(pieces.size(), derivative_pieces.size());
        for (std::size_t c = 0; c < pieces.size(); ++c) {
          std::size_t cell = c;
          for (int j = n; --j > axis;)
            cell /= f.breaks(j).size() - 1;
          cell %= f.breaks(axis).size() - 1;
          const FT width = f.breaks(axis)[cell + 1] - f.breaks(axis)[cell];
          EXPECT_EQ(derivative_pieces[c] * width, pieces[c].derivative(axis));
        }
        const std::vector<FT> u = random.domain_point(n);
        const auto [value, gradient] = f.value_and_gradient(u);
        EXPECT_EQ(value, f(u));
        EXPECT_EQ(gradient[axis], derivative(u));
        const auto [low, high] = f.derivative_bounds(axis);
        EXPECT_TRUE(low <= derivative(u) && derivative(u) <= high);
      }
    }
  EXPECT_GT(with_knots, rounds / 2);
  const Spline g({3, 2}, {{0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 1, 1, 1}}, random.numbers(12));
  const std::vector<FT> u = random.point(2);
  EXPECT_EQ(g.hessian(u), g.bezier_pieces()[0].hessian(u));
}

TEST(Bspline_function, knot_insertion_elevation_restriction_and_split_preserve_the_function)
{
  Random_splines random(5);
  for (int n = 1; n <= 2; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Spline f = random.spline(n);
      const int axis = random.integer(0, n - 1);
      std::vector<FT> u = random.domain_point(n);

      std::vector<int> degrees = f.degrees();
      for (int& d : degrees)
        d += random.integer(0, 2);
      const Spline elevated = f.elevated(degrees);
      EXPECT_EQ(elevated.degrees(), degrees);
      EXPECT_EQ(by_definition(elevated, u), by_definition(f, u));
      EXPECT_EQ(elevated, f);

      const FT knot = FT(random.integer(1, 40)) / FT(41);
      if (f.degree(axis) > 0) {
        const Spline finer = f.with_knot(axis, knot);
        EXPECT_EQ(finer.size(axis), f.size(axis) + 1);
        EXPECT_EQ(by_definition(finer, u), by_definition(f, u));
        EXPECT_EQ(finer, f);
      }

      const auto [before, after] = f.split(axis, knot);
      EXPECT_EQ(before.domain(axis), (std::pair<FT, FT>(FT(0), knot)));
      EXPECT_EQ(after.domain(axis), (std::pair<FT, FT>(knot, FT(1))));
      EXPECT_EQ(by_definition(u[axis] <= knot ? before : after, u), by_definition(f, u));

      for (int side : {0, 1}) {
        u[axis] = FT(side);
        std::vector<FT> v = u;
        v.erase(v.begin() + axis);
        EXPECT_EQ(f.face(axis, side)(v), by_definition(f, u));
      }
    }
}

TEST(Bspline_function, sums_and_products_are_pointwise_and_as_smooth_as_their_operands)
{
  Random_splines random(6);
  for (int n = 0; n <= 2; ++n)
    for (int i = 0; i < rounds; ++i) {
      const int smoothness = random.integer(0, 1);
      const Spline f = random.spline(n, 3, smoothness), g = random.spline(n, 3, smoothness);
      const std::vector<FT> u = random.domain_point(n);
      const FT a = by_definition(f, u), b = by_definition(g, u), c = random.rational();
      EXPECT_EQ(by_definition(f + g, u), FT(a + b));
      EXPECT_EQ(by_definition(f - g, u), FT(a - b));
      EXPECT_EQ(by_definition(f * g, u), FT(a * b));
      EXPECT_EQ((c * f + c)(u), FT(c * a + c));
      EXPECT_EQ((c - f)(u), FT(c - a));
      EXPECT_EQ((f + g) * (f - g), f * f - g * g);
      EXPECT_FALSE(f == f + FT(1));
      // Smooth operands have a smooth product: its derivative exists and follows the rule.
      for (int axis = 0; smoothness == 1 && axis < n; ++axis) {
        EXPECT_EQ((f * g).derivative(axis), f.derivative(axis) * g + f * g.derivative(axis));
      }
    }
}

// On the same knots, and with constants, there is a shorter way. It gives what the long one does, which other knots
// take.
TEST(Bspline_function, operands_on_the_same_knots)
{
  Random_splines random(14);
  for (int round = 0; round < 40; ++round) {
    const Spline any = random.spline(2);
    if (any.degree(0) == 0)
      continue;   // no knot can be inserted
    const Spline f = any.elevated(any.degrees());   // clamped
    const Spline g = f * f.coefficients()[0] - FT(3);
    const FT inside = FT(random.integer(1, 96)) / FT(97);
    const Spline refined = f.with_knot(0, inside), one = Spline({0, 0}, {{0, 1}, {0, 1}}, {FT(5)});
    const std::vector<FT> u = random.domain_point(2);
    EXPECT_EQ((f + g)(u), f(u) + g(u));
    EXPECT_EQ((f - g)(u), f(u) - g(u));
    EXPECT_EQ((f * one)(u), 5 * f(u));
    EXPECT_EQ((one * any)(u), 5 * any(u));
    EXPECT_TRUE(f + g == refined + g && f - g == refined - g && f * one == refined * one);
    EXPECT_TRUE(f == refined && !(f == f + FT(1)) && !(refined == f + FT(1)) && any == f);
    const Spline sum = f + g;
    for (int axis : {0, 1})
      EXPECT_TRUE(sum.knots(axis) == f.knots(axis) && (f * one).knots(axis) == f.knots(axis));
  }
}

TEST(Bspline_function, bounds_contain_the_values)
{
  Random_splines random(7);
  for (int i = 0; i < 3 * rounds; ++i) {
    const Spline f = random.spline(2);
    const FT value = f(random.domain_point(2));
    EXPECT_TRUE(f.bounds().first <= value && value <= f.bounds().second);
  }
}

TEST(Bspline_function, embeds_and_converts_from_tensors)
{
  Random_splines random(8);
  for (int i = 0; i < rounds; ++i) {
    const Spline f = random.spline(2);
    const Spline g = f.embedded({{FT(9), FT(9)}, {FT(2), FT(3)}, {FT(9), FT(9)}}, {2, 0});
    std::vector<FT> u = random.domain_point(2);
    EXPECT_EQ(by_definition(g, {u[1], FT(5) / FT(2), u[0]}), by_definition(f, u));

    const Tensor tensor = random.tensor(2);
    const Spline single = Spline::from_tensor(tensor, {{FT(-1), FT(1)}, {FT(0), FT(3)}});
    EXPECT_EQ(single({{FT(2) * u[0] - FT(1), FT(3) * u[1]}}), tensor(u));
    EXPECT_EQ(single.bezier_pieces(), std::vector<Tensor>{tensor});
  }
}

TEST(Bspline_function, double_evaluation_stays_close_to_the_exact_one)
{
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> uniform(-1, 1);
  // Cubic: three levels of at most 6 roundings of non-negative weights each, then 4 products and sums, per axis;
  // control points below 1.
  const double bound = 2 * (3 * 6 + 5) * std::numeric_limits<double>::epsilon() * 1.01;
  for (int i = 0; i < 50; ++i) {
    std::vector<std::vector<double>> knots(2);
    for (std::vector<double>& axis : knots) {
      for (int k = 0; k < 12; ++k)
        axis.push_back(uniform(engine));
      std::sort(axis.begin(), axis.end());
    }
    std::vector<double> numbers(64);
    for (double& x : numbers)
      x = uniform(engine);
    const Double_spline f({3, 3}, knots, numbers);
    const Spline exact = f.converted<FT>([](double x) { return FT(x); });
    std::vector<double> u;
    for (int j = 0; j < 2; ++j)
      u.push_back(std::uniform_real_distribution<double>(f.domain(j).first, f.domain(j).second)(engine));
    const FT error = FT(f(u)) - exact(std::vector<FT>{FT(u[0]), FT(u[1])});
    EXPECT_LE(error, FT(bound));
    EXPECT_GE(error, FT(-bound));
  }
}

template <class Call>
void expect_invalid(const Call& call, const std::string& fragment)
{
  try {
    call();
    ADD_FAILURE() << "no exception; expected one naming: " << fragment;
  } catch (const Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
  }
}

TEST(Bspline_function, rejects_bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_invalid([] { Double_spline({2}, {{0, 0, 0, 2, 1, 1, 1}}, {1, 2, 3, 4}); }, "knot 4 is smaller");
  expect_invalid([] { Double_spline({2}, {{0, 0, 0, 1, 1}}, {1, 2}); }, "5 knots, at least 6");
  expect_invalid([] { Double_spline({2}, {{}}, {1, 2}); }, "0 knots");
  expect_invalid([] { Double_spline({2}, {{0, 0, 0, 1, 1, 1}}, {1, 2}); }, "2 where 3");
  expect_invalid([&] { Double_spline({1}, {{0, 0, nan, 1}}, {1, 2}); }, "knot 2 is not a finite number");
  expect_invalid([&] { Double_spline({1}, {{0, 0, 1, 1}}, {1, nan}); }, "control point 1");
  expect_invalid(
      [] {
        Double_spline({2}, {{0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1}}, {1, 2, 3, 4, 5, 6});
      },
      "knot 3 occurs 3 times");
  expect_invalid([] { Double_spline({1}, {{0, 0, 0, 1, 1}}, {1, 2, 3}); }, "knot 0 occurs 3 times");
  expect_invalid([] { Double_spline({0}, {{0, 0.5, 1}}, {1, 2}); }, "not continuous");
  expect_invalid([] { Double_spline({1}, {{0, 1, 1, 2}}, {1, 2}); }, "domain is empty");
  expect_invalid([] { Double_spline({-1}, {{0, 1}}, {1}); }, "negative");
  expect_invalid([] { Double_spline({1, 1}, {{0, 0, 1, 1}}, {1, 2}); }, "knot vectors: 1 where 2");
  const Double_spline f({1}, {{0, 0, 1, 2, 2}}, {1, 3, 2}), g({1}, {{0, 0, 1, 1}}, {1, 2});
  expect_invalid([&] { f.derivative(0); }, "not continuous");
  expect_invalid([&] { f + g; }, "different domains on axis 0");
  expect_invalid([&] { f * g; }, "different domains on axis 0");
  expect_invalid([&] { f + Double_spline(); }, "dimension");
  expect_invalid([&] { f.with_knot(0, 2); }, "not inside");
  expect_invalid([&] { f.with_knot(0, nan); }, "not inside");
  expect_invalid([&] { f.with_knot(0, 1); }, "occurs 2 times");
  expect_invalid([&] { f.restricted(0, 1, 3); }, "not within");
  expect_invalid([&] { f.restricted(0, 1, 1); }, "empty");
  expect_invalid([&] { f.elevated({0}); }, "cannot be elevated");
  const std::vector<double> outside{2.5}, unknown{nan};
  expect_invalid([&] { f(outside); }, "parameter 0");
  expect_invalid([&] { f(unknown); }, "parameter 0");
  expect_invalid([&] { f.embedded({{0, 1}, {1, 1}}, {0}); }, "axis 1");
  // A kink is still bounded on both sides.
  EXPECT_EQ(f.derivative_bounds(0), (std::pair<double, double>(-1, 2)));
}

} // namespace

} // namespace Bspline_function_test
