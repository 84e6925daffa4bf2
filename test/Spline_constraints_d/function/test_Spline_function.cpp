// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Splines in power form against the Bernstein coefficients that they are made of.

#include <CGAL/Spline_constraints_d/function/Spline_function.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace Spline_function_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using Engine = std::mt19937_64;
using Tensor = SC::Bernstein_tensor<Exact_rational>;

// Of all sizes, so that common denominators are long.
std::vector<double> random_doubles(Engine& engine, std::size_t count)
{
  std::vector<double> result;
  while (result.size() < count)
    result.push_back(
        std::ldexp(static_cast<double>(engine() >> 11) * 0x1p-53 - 0.5, static_cast<int>(engine() % 80) - 40));
  return result;
}

Tensor exact(const SC::Bernstein_tensor<double>& tensor)
{
  return Tensor(tensor.degrees(), {tensor.coefficients().begin(), tensor.coefficients().end()});
}

TEST(Spline_function, TakesPolynomialsFromTheirBernsteinCoefficients)
{
  Engine engine(1);
  for (const std::vector<int>& degrees : {std::vector<int>{0}, {1}, {3}, {10}, {2, 3}, {0, 4}, {3, 1, 2}}) {
    const SC::Bernstein_tensor<double> tensor(degrees, random_doubles(engine, SC::internal::tensor_size(degrees)));
    std::vector<int> variables;
    std::vector<std::vector<Exact_rational>> unit_breaks;
    for (std::size_t j = 0; j < degrees.size(); ++j) {
      variables.push_back(2 * static_cast<int>(j));
      unit_breaks.push_back({0, 1});
    }
    const SC::Spline_function function = SC::Spline_function::from_bernstein(variables, tensor);
    ASSERT_EQ(function.terms().size(), 1u);
    const SC::Spline_term& term = function.terms().front();
    EXPECT_EQ(term.variables, variables);
    EXPECT_EQ(term.degrees, degrees);
    ASSERT_EQ(term.pieces.size(), 1u);
    EXPECT_EQ(term.pieces.front(), exact(tensor).power_coefficients());
    for (const auto& breaks : term.breaks)
      EXPECT_TRUE(breaks.empty());
    EXPECT_EQ(SC::Spline_function::from_bernstein(variables, exact(tensor)).terms(), function.terms());
    const SC::Spline_function piece = SC::Spline_function::from_bezier_pieces(
        variables, unit_breaks, std::vector<SC::Bernstein_tensor<double>>{tensor});
    EXPECT_EQ(piece.terms().front().pieces, term.pieces);
    EXPECT_EQ(piece.terms().front().breaks, unit_breaks);
  }
}

// Pieces of different degrees, in doubles and exactly.
TEST(Spline_function, RaisesPiecesToACommonDegree)
{
  Engine engine(2);
  const std::vector<std::vector<Exact_rational>> breaks{
      {Exact_rational(-1), Exact_rational(1) / Exact_rational(3), Exact_rational(2)}};
  const std::vector<SC::Bernstein_tensor<double>> pieces{{{2}, random_doubles(engine, 3)},
                                                         {{5}, random_doubles(engine, 6)}};
  const SC::Spline_function function = SC::Spline_function::from_bezier_pieces({1}, breaks, pieces);
  const SC::Spline_function same =
      SC::Spline_function::from_bezier_pieces({1}, breaks, std::vector<Tensor>{exact(pieces[0]), exact(pieces[1])});
  EXPECT_EQ(function.terms(), same.terms());
  const SC::Spline_term& term = function.terms().front();
  ASSERT_EQ(term.pieces.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c)
    for (int i = 0; i <= 4; ++i) {
      const Exact_rational t = Exact_rational(i) / Exact_rational(4),
                           x = breaks[0][c] + t * (breaks[0][c + 1] - breaks[0][c]);
      Exact_rational value(0);
      for (std::size_t k = term.pieces[c].size(); k-- > 0;)
        value = value * x + term.pieces[c][k];
      EXPECT_EQ(value, exact(pieces[c])(std::vector<Exact_rational>{t}));
    }
}

TEST(Spline_function, RefusesBadInput)
{
  const SC::Bernstein_tensor<double> line({1}, {0, 1});
  EXPECT_THROW(SC::Spline_function::from_bernstein({0, 1}, line), SC::Invalid_input);
  EXPECT_THROW(SC::Spline_function::from_bernstein({-1}, line), SC::Invalid_input);
  EXPECT_THROW(SC::Spline_function::from_bezier_pieces({0}, {{}}, std::vector<SC::Bernstein_tensor<double>>{line}),
               SC::Invalid_input);
  EXPECT_THROW(SC::Spline_function::from_bezier_pieces({0}, {{1, 0}}, std::vector<SC::Bernstein_tensor<double>>{line}),
               SC::Invalid_input);
  EXPECT_THROW(SC::Spline_function::from_bezier_pieces({0}, {{0, 1}}, std::vector<SC::Bernstein_tensor<double>>{}),
               SC::Invalid_input);
}

} // namespace

} // namespace Spline_function_test
