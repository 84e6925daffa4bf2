// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bernstein forms on simplices of one to three dimensions, against exact polynomials: conversions, values, parts,
// derivatives, products, continuity across faces, zeros of edges.

#include "random_tensors.h"

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/simplex_conversion.h>
#include <CGAL/Spline_constraints_d/function/simplex_faces.h>

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace Bernstein_simplex_test {

namespace SC = CGAL::Spline_constraints;
using FT = SC::Exact_rational;
using SC::Power_polynomial;
template <int d>
using Simplex = SC::Bernstein_simplex<FT, d>;
template <int d>
using Point = std::array<FT, d>;
template <int d>
using Barycentric = std::array<FT, d + 1>;
template <int d>
using Vertices = SC::Simplex_vertices<d>;

namespace {

// Random data in d dimensions.
template <int d>
struct Data
{
  Random_source random;

  explicit Data(unsigned seed) : random(seed) {}

  Point<d> point()
  {
    Point<d> result;
    for (FT& x : result)
      x = random.rational();
    return result;
  }

  // Some of the coordinates are negative or larger than 1.
  Barycentric<d> barycentric()
  {
    Barycentric<d> result;
    result[d] = FT(1);
    for (int i = 0; i < d; ++i) {
      result[i] = random.fraction() - FT(1) / FT(4);
      result[d] -= result[i];
    }
    return result;
  }

  Barycentric<d> direction()
  {
    Barycentric<d> result = barycentric();
    result[0] -= FT(1);
    return result;
  }

  Vertices<d> vertices()
  {
    for (;;) {
      Vertices<d> result;
      for (auto& x : result)
        x = point();
      try {
        SC::barycentric_coordinates<d>(result, result[0]);
        return result;
      } catch (const SC::Invalid_input&) {
      }
    }
  }

  Simplex<d> simplex(int degree)
  {
    return Simplex<d>(degree, random.numbers(Simplex<d>::number_of_coefficients(degree)));
  }
};

template <int d>
Point<d> point_of(const Vertices<d>& vertices, const Barycentric<d>& tau)
{
  Point<d> result;
  for (int j = 0; j < d; ++j) {
    result[j] = FT(0);
    for (int i = 0; i <= d; ++i)
      result[j] += FT(tau[i] * vertices[i][j]);
  }
  return result;
}

template <int d>
FT value(const Power_polynomial& f, const Point<d>& x)
{
  return f(std::vector<FT>(x.begin(), x.end()));
}

template <int dimension>
struct Dimension
{
  static constexpr int value = dimension;
};

template <class D>
class Simplices : public testing::Test
{};

using Dimensions = testing::Types<Dimension<1>, Dimension<2>, Dimension<3>>;
TYPED_TEST_SUITE(Simplices, Dimensions);

TYPED_TEST(Simplices, ConvertToPolynomialsAndBack)
{
  constexpr int d = TypeParam::value;
  Data<d> data(1);
  for (int degree = 0; degree <= 5; ++degree) {
    const Vertices<d> vertices = data.vertices();
    const Simplex<d> f = data.simplex(degree);
    const Power_polynomial polynomial = SC::to_power_polynomial<d>(f, vertices);
    EXPECT_EQ(SC::to_bernstein_simplex<d>(polynomial, vertices), f);
    for (int sample = 0; sample < 5; ++sample) {
      const Barycentric<d> tau = data.barycentric();
      EXPECT_EQ(f(tau), (value<d>(polynomial, point_of<d>(vertices, tau))));
      EXPECT_EQ((SC::barycentric_coordinates<d>(vertices, point_of<d>(vertices, tau))), tau);
    }
  }
}

TYPED_TEST(Simplices, HaveCoefficientsOneForOneAndLinearPrecision)
{
  constexpr int d = TypeParam::value;
  Data<d> data(2);
  for (int degree = 1; degree <= 6; ++degree) {
    for (const FT& x : Simplex<d>::constant(FT(1)).elevated(degree).coefficients())
      EXPECT_EQ(x, FT(1));
    std::array<FT, d + 1> values;
    for (FT& x : values)
      x = data.random.rational();
    int count = 0;
    Simplex<d>::affine(values).elevated(degree).visit_coefficients([&](const auto& exponents, const FT& x) {
      FT expected(0);
      for (int i = 0; i <= d; ++i)
        expected += FT(values[i] * FT(exponents[i])) / FT(degree);
      EXPECT_EQ(x, expected);
      ++count;
    });
    EXPECT_EQ(static_cast<std::size_t>(count), Simplex<d>::number_of_coefficients(degree));
  }
}

TYPED_TEST(Simplices, AreThePolarFormAtTheirVertices)
{
  constexpr int d = TypeParam::value;
  Data<d> data(3);
  const int degree = 4;
  const Simplex<d> f = data.simplex(degree);
  std::array<Barycentric<d>, d + 1> units{};
  for (int i = 0; i <= d; ++i)
    for (int j = 0; j <= d; ++j)
      units[i][j] = FT(i == j ? 1 : 0);
  f.visit_coefficients([&](const auto& exponents, const FT& x) {
    std::vector<Barycentric<d>> arguments;
    for (int i = 0; i <= d; ++i)
      arguments.insert(arguments.end(), exponents[i], units[i]);
    EXPECT_EQ(f.blossom(arguments), x);
  });
  // symmetric, affine in an argument, and the function on the diagonal
  std::vector<Barycentric<d>> arguments;
  for (int i = 0; i < degree; ++i)
    arguments.push_back(data.barycentric());
  const FT before = f.blossom(arguments);
  std::swap(arguments[0], arguments[2]);
  EXPECT_EQ(f.blossom(arguments), before);
  const Barycentric<d> other = data.barycentric(), own = arguments[1];
  arguments[1] = other;
  const FT at_other = f.blossom(arguments);
  for (int i = 0; i <= d; ++i)
    arguments[1][i] = (FT(2) * own[i] + other[i]) / FT(3);
  EXPECT_EQ(f.blossom(arguments), FT((FT(2) * before + at_other) / FT(3)));
  EXPECT_EQ(f.blossom(std::vector<Barycentric<d>>(degree, other)), f(other));
}

TYPED_TEST(Simplices, SplitIntoPartsWithTheSameValues)
{
  constexpr int d = TypeParam::value;
  Data<d> data(4);
  for (int degree = 0; degree <= 5; ++degree) {
    const Simplex<d> f = data.simplex(degree);
    const Barycentric<d> point = data.barycentric();
    const auto parts = f.split(point);
    for (int part = 0; part <= d; ++part) {
      const Barycentric<d> tau = data.barycentric();
      Barycentric<d> image = tau;
      for (int i = 0; i <= d; ++i)
        image[i] = (i == part ? FT(0) : tau[i]) + FT(tau[part] * point[i]);
      EXPECT_EQ(parts[part](tau), f(image));
      EXPECT_EQ(f.replaced(part, point), parts[part]);
    }
    const FT t = data.random.fraction();
    const auto [at_0, at_d] = f.split(0, d, t);
    Barycentric<d> cut{};
    cut[0] = FT(1) - t;
    cut[d] = t;
    EXPECT_EQ(at_0, f.replaced(d, cut));
    EXPECT_EQ(at_d, f.replaced(0, cut));
    EXPECT_EQ(f.split(0, d).first, f.split(0, d, FT(1) / FT(2)).first);
  }
}

TYPED_TEST(Simplices, RestrictToOtherSimplicesAndFaces)
{
  constexpr int d = TypeParam::value;
  Data<d> data(5);
  for (int degree = 0; degree <= 4; ++degree) {
    const Vertices<d> vertices = data.vertices(), others = data.vertices();
    const Simplex<d> f = data.simplex(degree);
    const Power_polynomial polynomial = SC::to_power_polynomial<d>(f, vertices);
    EXPECT_EQ(f.restricted(SC::internal::barycentric_vertices<d>(vertices, others)),
              SC::to_bernstein_simplex<d>(polynomial, others));
    // an edge: the polynomial restricted to a line
    Power_polynomial on_line = polynomial;
    const Power_polynomial t = Power_polynomial::variable(d);
    for (int j = 0; j < d; ++j)
      on_line = on_line.substituted(
          j, Power_polynomial(vertices[d][j]) * (Power_polynomial(1) - t) + Power_polynomial(vertices[0][j]) * t);
    const Power_polynomial x = Power_polynomial::variable(0);
    EXPECT_EQ((f.template face<2>({d, 0})),
              SC::to_bernstein_simplex<1>(on_line.substituted(d, x), SC::internal::standard_simplex<1>()));
    std::array<Barycentric<d>, 2> ends{};
    ends[0][d] = ends[1][0] = FT(1);
    EXPECT_EQ(f.restricted(ends), (f.template face<2>({d, 0})));
    EXPECT_EQ(f.at_vertex(d), (value<d>(polynomial, vertices[d])));
  }
}

TYPED_TEST(Simplices, HaveTheDerivativesOfThePolynomial)
{
  constexpr int d = TypeParam::value;
  Data<d> data(6);
  for (int degree = 0; degree <= 4; ++degree) {
    const Vertices<d> vertices = data.vertices();
    const Simplex<d> f = data.simplex(degree), g = data.simplex(2);
    const Power_polynomial polynomial = SC::to_power_polynomial<d>(f, vertices);
    const auto along = [&](const Power_polynomial& p, const Barycentric<d>& direction) {
      Power_polynomial result;
      for (int j = 0; j < d; ++j) {
        FT x(0);
        for (int i = 0; i <= d; ++i)
          x += FT(direction[i] * vertices[i][j]);
        result += Power_polynomial(x) * p.derivative(j);
      }
      return result;
    };
    const Barycentric<d> u = data.direction(), v = data.direction();
    EXPECT_EQ(SC::to_power_polynomial<d>(f.derivative(u), vertices), along(polynomial, u));
    EXPECT_EQ(SC::to_power_polynomial<d>(f.derivative(u).derivative(v), vertices), along(along(polynomial, u), v));
    Simplex<d> second;
    for (int i = 0; i <= d; ++i)
      for (int j = 0; j <= d; ++j)
        second += FT(u[i] * v[j]) * f.partial_derivative(i).partial_derivative(j);
    EXPECT_EQ(second, f.derivative(u).derivative(v));
    EXPECT_EQ((f * g).derivative(u), f.derivative(u) * g + f * g.derivative(u));
    EXPECT_EQ(f.derivative_at_vertex(0, d), f.derivative(0, d).at_vertex(0));
  }
}

TYPED_TEST(Simplices, AddAndMultiplyAsPolynomialsDo)
{
  constexpr int d = TypeParam::value;
  Data<d> data(7);
  for (int degree = 0; degree <= 4; ++degree) {
    const Vertices<d> vertices = data.vertices();
    const Simplex<d> f = data.simplex(degree), g = data.simplex(3);
    const Power_polynomial p = SC::to_power_polynomial<d>(f, vertices), q = SC::to_power_polynomial<d>(g, vertices);
    EXPECT_EQ(SC::to_power_polynomial<d>(f * g, vertices), p * q);
    EXPECT_EQ(SC::to_power_polynomial<d>(f - g, vertices), p - q);
    EXPECT_EQ(SC::to_power_polynomial<d>(f + g, vertices), p + q);
    EXPECT_EQ(f.elevated(degree + 3), f);
    EXPECT_EQ(SC::to_power_polynomial<d>(f.elevated(degree + 3), vertices), p);
    EXPECT_FALSE(f == g + Simplex<d>::constant(FT(1000000)));
  }
}

TYPED_TEST(Simplices, AreBoundedByTheirCoefficients)
{
  constexpr int d = TypeParam::value;
  using Interval = CGAL::Interval_nt<false>;
  Data<d> data(8);
  const typename SC::Number_traits<Interval>::Rounding_guard guard;
  for (int degree = 1; degree <= 6; ++degree) {
    const Simplex<d> f = data.simplex(degree);
    const auto [least, greatest] = f.bounds();
    const auto enclosed = f.template converted<Interval>(SC::Number_traits<Interval>::from_rational);
    const auto rounded = f.template converted<double>(SC::Number_traits<double>::from_rational);
    double largest = 0;
    for (double x : rounded.coefficients())
      largest = std::max(largest, std::abs(x));
    for (int sample = 0; sample < 10; ++sample) {
      Barycentric<d> tau;
      FT sum(0);
      for (FT& x : tau)
        sum += x = data.random.fraction() + FT(1) / FT(100);
      std::array<Interval, d + 1> tau_enclosed;
      std::array<double, d + 1> tau_rounded;
      for (int i = 0; i <= d; ++i) {
        tau[i] = FT(tau[i]) / sum;
        tau_enclosed[i] = SC::Number_traits<Interval>::from_rational(tau[i]);
        tau_rounded[i] = SC::Number_traits<double>::from_rational(tau[i]);
      }
      const FT exact = f(tau);
      EXPECT_LE(least, exact);
      EXPECT_LE(exact, greatest);
      const Interval value = enclosed(tau_enclosed);
      EXPECT_LE(SC::to_rational(value.inf()), exact);
      EXPECT_LE(exact, SC::to_rational(value.sup()));
      EXPECT_NEAR(rounded(tau_rounded), SC::to_nearest_double(exact), (d + 6) * degree * 0x1p-52 * largest);
    }
  }
}

TYPED_TEST(Simplices, AgreeAcrossAFaceUpToTheirOrder)
{
  constexpr int d = TypeParam::value;
  Data<d> data(9);
  const int degree = 4;
  for (int opposite = 0; opposite <= d; ++opposite) {
    Barycentric<d> point = data.barycentric();
    point[opposite] -= FT(3);
    point[(opposite + 1) % (d + 1)] += FT(3);
    const Simplex<d> f = data.simplex(degree);
    std::array<FT, d + 1> values{};
    values[opposite] = FT(1);
    const Simplex<d> height = Simplex<d>::affine(values); // 0 on the common face
    EXPECT_EQ(order_of_continuity(f, f.replaced(opposite, point), opposite, point), degree);
    Simplex<d> power = data.simplex(0) + Simplex<d>::constant(FT(100));
    for (int order = -1; order < degree; ++order) {
      EXPECT_EQ(order_of_continuity(f, f.replaced(opposite, point) + power, opposite, point), order);
      power *= height;
    }
  }
}

// x^2 + y^2 + z^2 - 1/4 with x_3 the origin.
TEST(Bernstein_simplex, OfASphere)
{
  const auto x = [](int i) { return Power_polynomial::variable(i); };
  const Vertices<3> vertices{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
  const Simplex<3> f =
      SC::to_bernstein_simplex<3>(x(0) * x(0) + x(1) * x(1) + x(2) * x(2) - Power_polynomial(0.25), vertices);
  int count = 0;
  f.visit_coefficients([&](const auto& exponents, const FT& b) {
    const bool is_square = exponents[0] == 2 || exponents[1] == 2 || exponents[2] == 2;
    EXPECT_EQ(b, FT(is_square ? 3 : -1) / FT(4));
    ++count;
  });
  EXPECT_EQ(count, 10);
  EXPECT_FALSE(CGAL::is_certain(f.sign()));
  EXPECT_EQ(crossings_of_edge(f, 0, 3), 1);
  EXPECT_EQ(crossings_of_edge(f, 0, 1), 0); // at the distance 1/sqrt 2 from the origin; the coefficients do not tell
}

TEST(Bernstein_simplex, SignsButAtVertices)
{
  using Triangle = Simplex<2>;
  const auto signs = [](std::vector<int> numbers) { // (2,0,0) (1,1,0) (1,0,1) (0,2,0) (0,1,1) (0,0,2)
    std::vector<FT> coefficients(numbers.begin(), numbers.end());
    return Triangle(2, coefficients).sign_but_at_vertices();
  };
  const auto positive = signs({1, 1, 1, 1, 1, 1});
  EXPECT_TRUE(CGAL::certainly(positive.sign == CGAL::POSITIVE));
  EXPECT_EQ(positive.is_zero, (std::array<bool, 3>{false, false, false}));
  const auto zero_at_0 = signs({0, -1, -1, -1, 0, -1});
  EXPECT_TRUE(CGAL::certainly(zero_at_0.sign == CGAL::NEGATIVE));
  EXPECT_EQ(zero_at_0.is_zero, (std::array<bool, 3>{true, false, false}));
  EXPECT_FALSE(CGAL::is_certain(signs({0, 0, 1, 0, 1, 1}).sign)); // all of an edge
  EXPECT_FALSE(CGAL::is_certain(signs({1, 1, 1, 1, -1, 1}).sign));
  EXPECT_FALSE(CGAL::is_certain(signs({0, 0, 0, 0, 0, 0}).sign));
  EXPECT_TRUE(CGAL::certainly(Triangle(2, std::vector<FT>(6, FT(-2))).sign() == CGAL::NEGATIVE));
}

// Products of known linear factors on an edge: zeros within, at the ends and outside, and multiple ones.
TEST(Bernstein_simplex, CountsZerosOfEdges)
{
  Random_source random(10);
  for (int run = 0; run < 40; ++run) {
    Simplex<1> f = Simplex<1>::constant(FT(random.integer(0, 1) == 0 ? -2 : 3));
    int zeros = 0, crossings = 0;
    std::vector<FT> places;
    for (int factor = random.integer(0, 4); factor > 0; --factor) {
      const FT place = FT(random.integer(-2, 10)) / FT(8);
      if (std::find(places.begin(), places.end(), place) != places.end())
        continue;
      places.push_back(place);
      const int multiplicity = random.integer(1, 3);
      for (int i = 0; i < multiplicity; ++i)
        f *= Simplex<1>::affine({FT(-place), FT(1) - place});
      if (FT(0) < place && place < FT(1)) {
        ++zeros;
        crossings += multiplicity % 2;
      }
    }
    f *= Simplex<1>(2, {FT(1), FT(0), FT(1)}); // no real zero
    EXPECT_EQ(zeros_of_edge(f, 0, 1), zeros);
    EXPECT_EQ(crossings_of_edge(f, 1, 0), crossings);
    ASSERT_TRUE(sign_changes_of_edge(f, 0, 1).has_value());
    EXPECT_GE(*sign_changes_of_edge(f, 0, 1), crossings);
  }
  EXPECT_EQ(zeros_of_edge(Simplex<1>(2, std::vector<FT>(3, FT(0))), 0, 1), -1);
}

TEST(Bernstein_simplex, RefusesBadInput)
{
  const auto message_of = [](const auto& action) {
    try {
      action();
    } catch (const SC::Invalid_input& error) {
      return std::string(error.what());
    }
    return std::string("nothing thrown");
  };
  EXPECT_EQ(message_of([] { Simplex<3>(3, std::vector<FT>(19)); }),
            "Bernstein_simplex: number of coefficients: 19 where 20 are needed");
  EXPECT_EQ(message_of([] { Simplex<1>(31, std::vector<FT>(32)); }), "Bernstein_simplex: degree 31 is above 30");
  EXPECT_EQ(message_of([] { Simplex<1>(-1, {}); }), "Bernstein_simplex: negative degree -1");
  EXPECT_EQ(message_of([] {
              SC::Bernstein_simplex<double, 1>(1, {0, std::nan("")});
            }),
            "Bernstein_simplex: coefficient 1 is not a finite number");
  const Vertices<3> flat{{{0, 0, 0}, {1, 0, 2}, {0, 1, 3}, {1, 1, 5}}};
  EXPECT_EQ(message_of([&] { SC::to_bernstein_simplex<3>(Power_polynomial::variable(0), flat); }),
            "simplex: vertices 0..3 are coplanar");
  const Vertices<2> straight{{{0, 0}, {1, 2}, {2, 4}}};
  EXPECT_EQ(message_of([&] { SC::to_power_polynomial<2>(Simplex<2>(), straight); }),
            "simplex: vertices 0..2 are collinear");
  EXPECT_EQ(message_of([&] {
              SC::to_bernstein_simplex<1>(Power_polynomial::variable(1), SC::internal::standard_simplex<1>());
            }),
            "to_bernstein_simplex: unknown 1 in a polynomial of 1 coordinates");
  EXPECT_EQ(message_of([] { Simplex<1>(2, std::vector<FT>(3)).elevated(1); }),
            "Bernstein_simplex: degree 2 cannot be elevated to 1");
  const Simplex<1> high(30, std::vector<FT>(31, FT(1)));
  EXPECT_EQ(message_of([&] { high* high* high* high* high; }), "Bernstein_simplex: degree 150 is above 120");
}

} // namespace

} // namespace Bernstein_simplex_test
