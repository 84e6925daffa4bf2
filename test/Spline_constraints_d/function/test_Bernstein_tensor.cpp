// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_tensors.h"

#include <CGAL/Spline_constraints_d/function/bernstein_composition.h>
#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <limits>

namespace Bernstein_tensor_test {

namespace {

using CGAL::Spline_constraints::Invalid_input;
using FT = CGAL::Spline_constraints::Exact_rational;
using Tensor = CGAL::Spline_constraints::Bernstein_tensor<FT>;
using Double_tensor = CGAL::Spline_constraints::Bernstein_tensor<double>;
using Interval = CGAL::Interval_nt<false>;
using Interval_tensor = CGAL::Spline_constraints::Bernstein_tensor<Interval>;

FT binomial(int n, int k)
{
  FT result(1);
  for (int i = 0; i < k; ++i)
    result = result * FT(n - i) / FT(i + 1);
  return result;
}

FT power(const FT& x, int n)
{
  FT result(1);
  for (int i = 0; i < n; ++i)
    result *= x;
  return result;
}

// The definition, with none of the code under test: sum of coefficients times products of binomial terms.
FT by_definition(const Tensor& f, const std::vector<FT>& u)
{
  FT sum(0);
  for (std::size_t i = 0; i < f.coefficients().size(); ++i) {
    FT term = f.coefficients()[i];
    std::size_t rest = i;
    for (int j = f.dimension(); j-- > 0;) {
      const int d = f.degree(j), k = static_cast<int>(rest % (d + 1));
      rest /= d + 1;
      term *= binomial(d, k) * power(u[j], k) * power(FT(1) - u[j], d - k);
    }
    sum += term;
  }
  return sum;
}

constexpr int rounds = 12;

TEST(Bernstein_tensor, evaluates_its_definition_inside_and_outside_the_box)
{
  Random_source random(1);
  for (int n = 0; n <= 5; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n);
      std::vector<FT> u = random.point(n);
      EXPECT_EQ(f(u), by_definition(f, u));
      for (FT& x : u)
        x = random.rational();
      EXPECT_EQ(f(u), by_definition(f, u));
    }
}

TEST(Bernstein_tensor, sums_and_products_are_pointwise)
{
  Random_source random(2);
  for (int n = 0; n <= 5; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n), g = random.tensor(n);
      const std::vector<FT> u = random.point(n);
      const FT a = by_definition(f, u), b = by_definition(g, u), c = random.rational();
      EXPECT_EQ((f + g)(u), FT(a + b));
      EXPECT_EQ((f - g)(u), FT(a - b));
      EXPECT_EQ((f * g)(u), FT(a * b));
      EXPECT_EQ((f + c)(u), FT(a + c));
      EXPECT_EQ((c - f)(u), FT(c - a));
      EXPECT_EQ((c * f)(u), FT(c * a));
      EXPECT_EQ((-f)(u), FT(-a));
      EXPECT_EQ(f * g, g * f);
      EXPECT_EQ((f + g) * (f - g), f * f - g * g);
      for (int j = 0; j < n; ++j)
        EXPECT_EQ((f * g).degree(j), f.degree(j) + g.degree(j));
    }
}

// Small integers take the double path, wide ones the packed path, unrelated denominators the path without a common
// denominator.
TEST(Bernstein_tensor, products_agree_for_all_sizes_of_numbers)
{
  Random_source random(3);
  for (int bits : {0, 20, 60, 200, 600})
    for (int i = 0; i < 6; ++i) {
      const std::vector<int> df = random.degrees(3, 3), dg = random.degrees(3, 3);
      Tensor f = random.tensor(df), g = random.tensor(dg);
      std::vector<FT> wide = f.coefficients();
      for (FT& x : wide)
        x = x * power(FT(2), bits) + random.rational();
      f = Tensor(df, wide);
      const std::vector<FT> u = random.point(3);
      EXPECT_EQ((f * g)(u), FT(by_definition(f, u) * by_definition(g, u))) << bits;
    }
  std::vector<FT> a, b;
  const FT large = power(FT(2), 61);
  for (int i = 0; i < 30; ++i) {
    a.push_back(FT(i - 7) / FT(large + FT(2 * i + 1)));
    b.push_back(FT(5 - i) / FT(large - FT(2 * i + 3)));
  }
  const Tensor f({4, 5}, a), g({5, 4}, b);
  const std::vector<FT> u = random.point(2);
  EXPECT_EQ((f * g)(u), FT(by_definition(f, u) * by_definition(g, u)));
}

TEST(Bernstein_tensor, products_of_disjoint_variables_are_outer_products)
{
  const Tensor f({2, 0}, {FT(1), FT(2), FT(5)}), g({0, 1}, {FT(3), FT(7)});
  const Tensor product = f * g;
  EXPECT_EQ(product.degrees(), (std::vector<int>{2, 1}));
  EXPECT_EQ(product.coefficients(), (std::vector<FT>{3, 7, 6, 14, 15, 35}));
  // No rounding but the multiplication's own.
  const Double_tensor x({2, 0}, {0.1, 0.2, 0.3}), y({0, 1}, {0.7, 1.1});
  EXPECT_EQ((x * y).coefficients(),
            (std::vector<double>{0.1 * 0.7, 0.1 * 1.1, 0.2 * 0.7, 0.2 * 1.1, 0.3 * 0.7, 0.3 * 1.1}));
}

TEST(Bernstein_tensor, derivatives_match_differences_and_the_gradient)
{
  Random_source random(4);
  for (int n = 1; n <= 5; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n);
      const std::vector<FT> u = random.point(n);
      const auto [value, gradient] = f.value_and_gradient(u);
      const std::vector<FT> hessian = f.hessian(u);
      EXPECT_EQ(value, by_definition(f, u));
      for (int j = 0; j < n; ++j) {
        const Tensor derivative = f.derivative(j);
        EXPECT_EQ(gradient[j], by_definition(derivative, u));
        for (int k = 0; k < n; ++k)
          EXPECT_EQ(hessian[j * n + k], by_definition(derivative.derivative(k), u));
        // Exactly, f(u + h) - f(u) is the sum of h^m / m! times the m-th derivatives.
        const FT h = random.rational();
        std::vector<FT> moved = u;
        moved[j] += h;
        FT taylor(0), factor(1);
        Tensor higher = f;
        for (int m = 1; m <= f.degree(j); ++m) {
          higher = higher.derivative(j);
          factor *= h / FT(m);
          taylor += factor * by_definition(higher, u);
        }
        EXPECT_EQ(FT(by_definition(f, moved) - by_definition(f, u)), taylor);
      }
    }
}

TEST(Bernstein_tensor, elevation_preserves_the_function)
{
  Random_source random(5);
  for (int n = 0; n <= 4; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n);
      std::vector<int> degrees = f.degrees();
      for (int& d : degrees)
        d += random.integer(0, 3);
      const Tensor g = f.elevated(degrees);
      const std::vector<FT> u = random.point(n);
      EXPECT_EQ(g.degrees(), degrees);
      EXPECT_EQ(by_definition(g, u), by_definition(f, u));
      EXPECT_EQ(f, g);
      if (n > 0) {
        EXPECT_FALSE(f == g + FT(1));
      }
    }
}

TEST(Bernstein_tensor, restriction_and_split_preserve_the_function)
{
  Random_source random(6);
  for (int n = 1; n <= 5; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n);
      const int axis = random.integer(0, n - 1);
      const std::vector<FT> u = random.point(n);
      // Also outside of [0,1], reversed, and of no length.
      for (const auto& [t0, t1] : {std::pair<FT, FT>(random.fraction(), random.fraction()),
                                   {FT(1), FT(2)},
                                   {FT(1), FT(0)},
                                   {FT(-3), random.rational()},
                                   {FT(1) / FT(3), FT(1) / FT(3)}}) {
        std::vector<FT> v = u;
        v[axis] = (FT(1) - u[axis]) * t0 + u[axis] * t1;
        EXPECT_EQ(by_definition(f.restricted(axis, t0, t1), u), by_definition(f, v));
      }
      EXPECT_EQ(f.substituted_affine(axis, FT(2), FT(-3)), f.restricted(axis, FT(2), FT(-1)));
      const FT t = random.fraction();
      const auto [before, after] = f.split(axis, t);
      EXPECT_EQ(before, f.restricted(axis, FT(0), t));
      EXPECT_EQ(after, f.restricted(axis, t, FT(1)));
      EXPECT_EQ(f.split(axis), f.split(axis, FT(1) / FT(2)));

      std::vector<std::pair<FT, FT>> box;
      std::vector<FT> v;
      for (int j = 0; j < n; ++j) {
        box.emplace_back(random.fraction(), random.rational());
        v.push_back((FT(1) - u[j]) * box[j].first + u[j] * box[j].second);
      }
      EXPECT_EQ(by_definition(f.restricted_to_box(box), u), by_definition(f, v));
    }
}

TEST(Bernstein_tensor, faces_and_embeddings_preserve_the_function)
{
  Random_source random(7);
  for (int n = 1; n <= 4; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n);
      for (int axis = 0; axis < n; ++axis)
        for (int side : {0, 1}) {
          std::vector<FT> u = random.point(n);
          u[axis] = FT(side);
          std::vector<FT> v = u;
          v.erase(v.begin() + axis);
          EXPECT_EQ(f.face(axis, side).dimension(), n - 1);
          EXPECT_EQ(by_definition(f.face(axis, side), v), by_definition(f, u));
        }
      // Any order of the axes, among two more.
      std::vector<int> axes(n + 2);
      for (int j = 0; j < n + 2; ++j)
        axes[j] = j;
      std::shuffle(axes.begin(), axes.end(), random.engine);
      axes.resize(n);
      const Tensor g = f.embedded(n + 2, axes);
      const std::vector<FT> w = random.point(n + 2);
      std::vector<FT> u;
      for (int j = 0; j < n; ++j)
        u.push_back(w[axes[j]]);
      EXPECT_EQ(g.dimension(), n + 2);
      EXPECT_EQ(by_definition(g, w), by_definition(f, u));
    }
  const Tensor constant = Tensor({}, {FT(7)}).embedded(2, {});
  EXPECT_EQ(constant, Tensor::constant(2, FT(7)));
}

TEST(Bernstein_tensor, power_form_makes_a_round_trip)
{
  Random_source random(8);
  for (int n = 0; n <= 5; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(n);
      const std::vector<FT> coefficients = f.power_coefficients();
      EXPECT_EQ(Tensor::from_power(f.degrees(), coefficients).coefficients(), f.coefficients());
      // On a box: the same polynomial, reparametrised.
      std::vector<std::pair<FT, FT>> box;
      for (int j = 0; j < n; ++j)
        box.emplace_back(random.rational(), random.rational());
      EXPECT_EQ(Tensor::from_power_on_box(f.degrees(), coefficients, box), f.restricted_to_box(box));
    }
}

TEST(Bernstein_tensor, reproduces_the_chebyshev_coefficients)
{
  const std::vector<std::pair<FT, FT>> box{{FT(-1), FT(1)}};
  std::vector<Tensor> chebyshev{Tensor::constant(1, FT(1)), Tensor::from_power_on_box({1}, {FT(0), FT(1)}, box)};
  for (int d = 2; d <= 5; ++d)
    chebyshev.push_back(FT(2) * chebyshev[1] * chebyshev[d - 1] - chebyshev[d - 2]);
  EXPECT_EQ(chebyshev[2].coefficients(), (std::vector<FT>{1, -3, 1}));
  EXPECT_EQ(chebyshev[3].coefficients(), (std::vector<FT>{-1, 5, -5, 1}));
  EXPECT_EQ(chebyshev[4].coefficients(), (std::vector<FT>{1, -7, FT(35) / FT(3), -7, 1}));
  EXPECT_EQ(chebyshev[5].coefficients(), (std::vector<FT>{-1, 9, -21, 21, -9, 1}));
  EXPECT_EQ(Tensor::from_power_on_box({4}, {FT(1), FT(0), FT(-8), FT(0), FT(8)}, box), chebyshev[4]);
}

TEST(Bernstein_tensor, bernstein_polynomials_sum_to_one_and_coordinates_to_themselves)
{
  Random_source random(9);
  for (int d = 0; d <= 8; ++d) {
    const Tensor one = Tensor::constant(2, FT(1)).elevated({d, 3});
    for (const FT& c : one.coefficients())
      EXPECT_EQ(c, FT(1));
  }
  const std::vector<FT> u = random.point(3);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_EQ(Tensor::coordinate(3, axis)(u), u[axis]);
}

TEST(Bernstein_tensor, bounds_contain_the_values_and_meet_the_corners)
{
  Random_source random(10);
  for (int n = 0; n <= 4; ++n)
    for (int i = 0; i < 2 * rounds; ++i) {
      const Tensor f = random.tensor(n);
      const auto [low, high] = f.bounds();
      const FT value = f(random.point(n));
      EXPECT_LE(low, value);
      EXPECT_LE(value, high);
    }
  const Tensor bilinear({1, 1}, {FT(4), FT(-1), FT(9), FT(2)});
  EXPECT_EQ(bilinear.bounds(), (std::pair<FT, FT>(FT(-1), FT(9))));
  EXPECT_EQ(bilinear.derivative_bounds(0), (std::pair<FT, FT>(FT(3), FT(5))));
}

TEST(Bernstein_tensor, composition_substitutes)
{
  Random_source random(11);
  for (int n = 1; n <= 3; ++n)
    for (int i = 0; i < rounds; ++i) {
      const Tensor f = random.tensor(random.degrees(n, 3));
      const int m = random.integer(0, 2);
      std::vector<Tensor> inner;
      std::vector<FT> images;
      const std::vector<FT> v = random.point(m);
      for (int j = 0; j < n; ++j) {
        inner.push_back(random.tensor(random.degrees(m, 2)));
        images.push_back(by_definition(inner[j], v));
      }
      EXPECT_EQ(by_definition(compose(f, inner), v), by_definition(f, images));
    }
}

// gamma_m: what m roundings in any mode can do to a relative error.
double rounding_bound(int m)
{
  const double epsilon = std::numeric_limits<double>::epsilon();
  return m * epsilon / (1 - m * epsilon);
}

FT exact_difference(double a, const FT& b)
{
  const FT difference = FT(a) - b;
  return difference < FT(0) ? FT(-difference) : difference;
}

TEST(Bernstein_tensor, double_errors_stay_below_the_documented_bounds_in_every_rounding_mode)
{
  Random_source random(12);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto to_exact = [](double x) { return FT(x); };
  for (int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
    for (int n = 1; n <= 3; ++n)
      for (int i = 0; i < 4; ++i) {
        const auto tensor = [&](const std::vector<int>& degrees) {
          std::vector<double> numbers(CGAL::Spline_constraints::internal::tensor_size(degrees));
          for (double& x : numbers)
            x = uniform(random.engine);
          return Double_tensor(degrees, numbers);
        };
        const Double_tensor f = tensor(random.degrees(n, 6)), g = tensor(random.degrees(n, 6));
        const Tensor exact_f = f.converted<FT>(to_exact), exact_g = g.converted<FT>(to_exact);
        std::vector<double> u;
        std::vector<FT> exact_u;
        int evaluation = 0, terms = 1, shared = 0;
        for (int j = 0; j < n; ++j) {
          u.push_back(std::fabs(uniform(random.engine)));
          exact_u.emplace_back(u[j]);
          evaluation += 5 * f.degree(j) + 2;
          terms *= (std::min)(f.degree(j), g.degree(j)) + 1;
          shared += f.degree(j) > 0 && g.degree(j) > 0;
        }
        const double t = std::fabs(uniform(random.engine));
        std::fesetround(mode);
        const double value = f(u);
        const Double_tensor product = f * g, part = f.split(0, t).first;
        std::fesetround(FE_TONEAREST);
        EXPECT_LE(exact_difference(value, exact_f(exact_u)), FT(rounding_bound(evaluation)));
        const Tensor exact_product = exact_f * exact_g, exact_part = exact_f.split(0, FT(t)).first;
        for (std::size_t k = 0; k < product.coefficients().size(); ++k)
          EXPECT_LE(exact_difference(product.coefficients()[k], exact_product.coefficients()[k]),
                    FT(rounding_bound(terms + 6 * shared)));
        for (std::size_t k = 0; k < part.coefficients().size(); ++k)
          EXPECT_LE(exact_difference(part.coefficients()[k], exact_part.coefficients()[k]),
                    FT(rounding_bound(4 * f.degree(0))));
      }
}

TEST(Bernstein_tensor, intervals_enclose_the_exact_results)
{
  Random_source random(13);
  const auto to_interval = [](const FT& x) { return Interval(CGAL::to_interval(x)); };
  const auto encloses = [](const Interval_tensor& enclosure, const Tensor& exact) {
    if (enclosure.degrees() != exact.degrees())
      return false;
    for (std::size_t k = 0; k < exact.coefficients().size(); ++k)
      if (exact.coefficients()[k] < FT(enclosure.coefficients()[k].inf()) ||
          FT(enclosure.coefficients()[k].sup()) < exact.coefficients()[k])
        return false;
    return true;
  };
  for (int n = 1; n <= 3; ++n)
    for (int i = 0; i < 4; ++i) {
      const Tensor f = random.tensor(n), g = random.tensor(n);
      const Interval_tensor enclosed_f = f.converted<Interval>(to_interval),
                            enclosed_g = g.converted<Interval>(to_interval);
      std::vector<int> degrees = f.degrees();
      ++degrees[0];
      const FT t = random.fraction();
      std::vector<Interval_tensor> results;
      std::vector<Interval> bounds;
      {
        CGAL::Interval_nt<false>::Protector protector;
        results = {enclosed_f * enclosed_g,
                   enclosed_f - enclosed_g,
                   enclosed_f.derivative(0),
                   enclosed_f.elevated(degrees),
                   enclosed_f.split(n - 1, to_interval(t)).second,
                   enclosed_f.restricted(0, Interval(-2), to_interval(t))};
        bounds = {enclosed_f.bounds().first, enclosed_f.bounds().second};
      }
      const std::vector<Tensor> exact{
          f * g, f - g, f.derivative(0), f.elevated(degrees), f.split(n - 1, t).second, f.restricted(0, FT(-2), t)};
      for (std::size_t k = 0; k < exact.size(); ++k)
        EXPECT_TRUE(encloses(results[k], exact[k])) << k;
      EXPECT_TRUE(FT(bounds[0].inf()) <= f.bounds().first && f.bounds().first <= FT(bounds[0].sup()));
      EXPECT_TRUE(FT(bounds[1].inf()) <= f.bounds().second && f.bounds().second <= FT(bounds[1].sup()));
    }
}

// The message names what is wrong and where.
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

TEST(Bernstein_tensor, rejects_bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const Double_tensor f({1, 1}, {1, 2, 3, 4});
  const std::vector<double> short_point{0.5};
  expect_invalid([] { Double_tensor({1, -2}, {1}); }, "axis 1");
  expect_invalid([] { Double_tensor({1, 1}, {1, 2, 3}); }, "3 where 4");
  expect_invalid([] { Double_tensor({}, {}); }, "0 where 1");
  expect_invalid([&] { Double_tensor({1, 1}, {1, 2, nan, 4}); }, "coefficient 2");
  expect_invalid([&] { Double_tensor({1}, {infinity, 4}); }, "coefficient 0");
  expect_invalid([] { Double_tensor({2147483647, 2147483647, 2147483647}, {1}); }, "overflow at axis 1");
  expect_invalid([] { Double_tensor::constant(-1, 0); }, "negative dimension");
  expect_invalid([] { Double_tensor::coordinate(2, 2); }, "no axis 2");
  expect_invalid([&] { f.elevated({2, 0}); }, "axis 1");
  expect_invalid([&] { f.elevated({2}); }, "1 where 2");
  expect_invalid([&] { f(short_point); }, "1 where 2");
  expect_invalid([&] { f + Double_tensor({1}, {1, 2}); }, "dimension");
  expect_invalid([&] { f * Double_tensor({1}, {1, 2}); }, "dimension");
  expect_invalid([&] { f.restricted(0, nan, 1); }, "not finite");
  expect_invalid([&] { f.split(0, infinity); }, "not finite");
  expect_invalid([&] { f.embedded(3, {0}); }, "axes to embed");
  expect_invalid([&] { f.embedded(3, {0, 0}); }, "entry 1");
  expect_invalid([&] { f.embedded(1, {0, 1}); }, "entry 1");
  expect_invalid([&] { compose(f, {f}); }, "1 where 2");
  expect_invalid([&] { compose(f, {f, Double_tensor({1}, {1, 2})}); }, "inner function 1");
  const std::vector<std::pair<double, double>> box{{0, infinity}};
  expect_invalid([&] { Double_tensor::from_power_on_box({1}, {1, 2}, box); }, "range 0");
  const Double_tensor high({600}, std::vector<double>(601, 1));
  expect_invalid([&] { high * high; }, "1200");
}

TEST(Bernstein_tensor, operations_on_itself_are_safe)
{
  Tensor f({1}, {FT(2), FT(3)});
  f *= f;
  EXPECT_EQ(f.coefficients(), (std::vector<FT>{4, 6, 9}));
  f *= f.coefficients()[0];
  EXPECT_EQ(f.coefficients(), (std::vector<FT>{16, 24, 36}));
  f -= f.coefficients()[0];
  EXPECT_EQ(f.coefficients(), (std::vector<FT>{0, 8, 20}));
  f += f;
  EXPECT_EQ(std::move(f).coefficients(), (std::vector<FT>{0, 16, 40}));
}

} // namespace

} // namespace Bernstein_tensor_test
