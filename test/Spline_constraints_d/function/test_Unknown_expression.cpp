// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>

#include <gtest/gtest.h>

#include <limits>
#include <sstream>

namespace Unknown_expression_test {

namespace SC = CGAL::Spline_constraints;
using SC::Constraint;
using SC::Exact_rational;
using SC::Expression;
using SC::Invalid_input;
using SC::Power_polynomial;
using SC::Relation;

namespace {

std::string written(const Constraint& constraint)
{
  std::ostringstream out;
  out << constraint;
  return out.str();
}

TEST(Unknown_expression, unknowns_know_index_and_range)
{
  auto [x, y, z] = SC::unknowns({-2, 2}, {0.5, 3}, {Exact_rational(1) / 3, 1});
  EXPECT_EQ(x.index(), 0);
  EXPECT_EQ(z.index(), 2);
  EXPECT_EQ(x.domain().first, Exact_rational(-2));
  EXPECT_EQ(y.domain().first, Exact_rational(1) / Exact_rational(2));
  EXPECT_EQ(y.domain().second, Exact_rational(3));
  EXPECT_EQ(z.domain().first, Exact_rational(1) / Exact_rational(3));
  ASSERT_EQ(x.domains()->size(), 3u);
  EXPECT_EQ(x.domains(), z.domains());
}

TEST(Unknown_expression, one_unknown_and_many_unknowns)
{
  auto [t] = SC::unknowns({-2, 2});
  EXPECT_EQ(written(t * t * t == 1), "-1 + x0^3 = 0");
  const auto x = SC::unknowns(10, {-1, 1});
  ASSERT_EQ(x.size(), 10u);
  Expression sum = 0;
  for (const auto& unknown : x)
    sum += unknown.index() * unknown;
  EXPECT_EQ(sum.polynomial().variables().size(), 9u);
  const auto y = SC::unknowns({{0, 1}, {2, 3.5}});
  ASSERT_EQ(y.size(), 2u);
  EXPECT_EQ(y[1].domain().second, Exact_rational(7) / Exact_rational(2));
}

TEST(Unknown_expression, comparisons_make_constraints)
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const Power_polynomial p = Power_polynomial::variable(0), q = Power_polynomial::variable(1);

  const Constraint circle = x*x + y*y == 2;
  EXPECT_EQ(circle.function, p * p + q * q - 2);
  EXPECT_EQ(circle.relation, Relation::EQUAL);
  EXPECT_EQ(circle.domains, x.domains());

  EXPECT_EQ((2 == x*y).function, 2 - p * q);
  EXPECT_EQ((x == y).function, p - q);
  EXPECT_EQ((x + y > 0).relation, Relation::GREATER);
  EXPECT_EQ((0 > x + y).relation, Relation::GREATER);
  EXPECT_EQ((0 > x + y).function, -p - q);
  EXPECT_EQ((x >= y).relation, Relation::GREATER_EQUAL);
  EXPECT_EQ((x < 0.5).relation, Relation::LESS);
  EXPECT_EQ((x < 0.5).function, p - Exact_rational(0.5));
  EXPECT_EQ((-x <= 3).relation, Relation::LESS_EQUAL);
  EXPECT_EQ((-x <= 3).function, -p - 3);
  EXPECT_EQ(written(x*x + y*y == 2), "-2 + x0^2 + x1^2 = 0");
}

TEST(Unknown_expression, arithmetic_is_exact)
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const Power_polynomial p = Power_polynomial::variable(0), q = Power_polynomial::variable(1);
  EXPECT_EQ((Exact_rational(1) / 3 * x).polynomial() * 3, p);
  EXPECT_EQ((0.1 * x).polynomial(), Power_polynomial(0.1) * p);
  EXPECT_NE((0.1 * x).polynomial() * 10, p);
  EXPECT_EQ((x / 3 - y / Exact_rational(7)).polynomial() * 21, 7 * p - 3 * q);
  EXPECT_EQ(pow(x + y, 3).polynomial(), pow(p + q, 3));
  EXPECT_EQ(square(x - 1).polynomial(), p * p - 2 * p + 1);
  EXPECT_EQ(pow(x, 0).polynomial(), Power_polynomial(1));
  Expression e = x;
  e -= 2 * y;
  e *= e;
  e /= 4;
  e += 1;
  EXPECT_EQ(e.polynomial(), pow(p - 2 * q, 2) / 4 + 1);
  EXPECT_EQ((x - x).polynomial(), Power_polynomial());
  EXPECT_EQ((x - x).domains(), x.domains());
}

TEST(Unknown_expression, formulas_remember_the_ranges)
{
  auto [x, y] = SC::unknowns({-2, 2}, {0, 1});
  const std::vector<Constraint> constraints{x * x == 2, Expression(1) > 0, y < 1};
  EXPECT_EQ(constraints[1].domains, nullptr);
  const SC::Unknown_domains& domains = SC::common_domains(constraints);
  ASSERT_EQ(domains.size(), 2u);
  EXPECT_EQ(domains[1].second, Exact_rational(1));
}

TEST(Unknown_expression, mixed_unknowns_are_refused)
{
  auto [x] = SC::unknowns({-2, 2});
  auto [y] = SC::unknowns({-2, 2});
  EXPECT_THROW(x + y, Invalid_input);
  EXPECT_THROW(static_cast<void>(x == y), Invalid_input);
  EXPECT_THROW(x * y, Invalid_input);
  EXPECT_THROW(SC::common_domains(std::vector<Constraint>{x == 1, y == 1}), Invalid_input);
  EXPECT_THROW(SC::common_domains(std::vector<Constraint>{Expression(1) == 1}), Invalid_input);
  EXPECT_THROW(SC::common_domains({}), Invalid_input);
}

TEST(Unknown_expression, bad_input_is_refused)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(SC::unknowns({1, -1}), Invalid_input);
  EXPECT_THROW(SC::unknowns({0, 1}, {nan, 1}), Invalid_input);
  EXPECT_THROW(SC::unknowns({0, infinity}), Invalid_input);
  EXPECT_THROW(SC::unknowns(0, {0, 1}), Invalid_input);
  EXPECT_NO_THROW(SC::unknowns({1, 1}));
  auto [x] = SC::unknowns({-2, 2});
  EXPECT_THROW(x * nan, Invalid_input);
  EXPECT_THROW(static_cast<void>(x == infinity), Invalid_input);
  EXPECT_THROW(x / 0, Invalid_input);
  EXPECT_THROW(1 / (x - x), Invalid_input);
  EXPECT_THROW(pow(x - x, -1), Invalid_input);
  EXPECT_EQ(pow(x + 1, -2)(std::vector<SC::Exact_rational>{2}), SC::Exact_rational(1, 9));
  EXPECT_THROW(SC::Unknown(x.symbols(), 1), Invalid_input);
}

} // namespace

} // namespace Unknown_expression_test
