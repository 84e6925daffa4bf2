// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Deferred rational numbers beside the exact ones: order, intervals and roundings are the same, in every rounding mode.

#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace deferred_rational_test {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::to_rational;
using SC::internal::Deferred_rational;

// Sums whose terms are of all sizes, nearly cancel, or end next to a double or in the middle of two, and places.
std::vector<Deferred_rational> numbers(int count)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<> digits(-1, 1);
  std::uniform_int_distribution<> exponents(-120, 20), small(-3, 3);
  std::vector<Deferred_rational> result;
  for (int i = 0; i < count; ++i) {
    const double a = i % 2 == 0 ? digits(random) : small(random), b = std::ldexp(digits(random), exponents(random)),
                 c = i % 3 == 0 ? -b : std::ldexp(small(random), exponents(random)),
                 half = std::ldexp(1.0, std::ilogb(a) - 53);
    result.push_back(Deferred_rational::sum(a, b, c));
    result.push_back(Deferred_rational::sum(a, a == 0 ? 0 : half, i % 5 == 0 ? 0 : c * 0x1p-100));
    result.push_back(Deferred_rational::sum(a, -a, c));
    result.push_back(Deferred_rational::between(a, a + 1, std::abs(b), i % 4 == 0 ? 3 : 1));
    result.push_back(Deferred_rational(Exact_rational(to_rational(a) / 3)));
    result.push_back(Deferred_rational(b));
  }
  return result;
}

void compare_with_exact(const std::vector<Deferred_rational>& all)
{
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Exact_rational x = all[i].exact();
    EXPECT_EQ(all[i].double_interval(), SC::to_double_interval(x));
    EXPECT_EQ(all[i].nearest(), SC::to_nearest_double(x));
    for (const std::size_t j : {i, (i + 1) % all.size(), (i + 2) % all.size(), (7 * i + 5) % all.size()})
      EXPECT_EQ(all[i] < all[j], x < all[j].exact());
  }
}

TEST(Deferred_rational, IsTheExactNumber)
{
  const std::vector<Deferred_rational> all = numbers(1000);
  compare_with_exact(all);
  const SC::Upward_rounding_guard rounding;
  compare_with_exact(all);
}

TEST(Deferred_rational, Ends)
{
  const double least = std::numeric_limits<double>::denorm_min(), greatest = (std::numeric_limits<double>::max)();
  std::vector<Deferred_rational> all{Deferred_rational(), Deferred_rational(-0.0), Deferred_rational(least),
                                     Deferred_rational(-greatest)};
  for (const double x : {0.0, 1.0, least, greatest})
    for (const double y : {0.0, least, -least, greatest, -greatest})
      all.push_back(Deferred_rational::sum(x, y, -least));
  compare_with_exact(all);
  EXPECT_FALSE(std::signbit(Deferred_rational(-0.0).nearest()));
}

TEST(Deferred_rational, Between)
{
  EXPECT_EQ(Deferred_rational::between(0, 1, 1, 3).exact(), Exact_rational(Exact_rational(1) / 3));
  EXPECT_EQ(Deferred_rational::between(-2, 4, 1, 3).exact(), Exact_rational(0));
  EXPECT_EQ(Deferred_rational::between(0.1, 0.7, 0, 1).exact(), to_rational(0.1));
  EXPECT_EQ(Deferred_rational::between(0.1, 0.7, 1, 1).exact(), to_rational(0.7));
  EXPECT_EQ(Deferred_rational::between(1, 3, 0.25, 1).exact(), to_rational(1.5));
}

} // namespace deferred_rational_test
