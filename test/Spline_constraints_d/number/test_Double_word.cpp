// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Double words beside rational numbers: the range holds the number, and is as narrow as 100 bits are.

#include <CGAL/Spline_constraints_d/number/Double_word.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace double_word_test {

using CGAL::Spline_constraints::Exact_rational;
using CGAL::Spline_constraints::to_rational;
using CGAL::Spline_constraints::internal::Double_word;

void expect_enclosed(const Double_word& x, const Exact_rational& exact, const Exact_rational& tolerance)
{
  ASSERT_TRUE(x.is_finite());
  const auto range = x.range();
  const Exact_rational lower = range.first.exact(), upper = range.second.exact();
  EXPECT_LE(lower, exact);
  EXPECT_LE(exact, upper);
  EXPECT_LE(Exact_rational(upper - lower), tolerance);
  EXPECT_LE(CGAL::abs(exact), to_rational(x.greatest()));
}

TEST(Double_word, RandomExpressions)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<> digits(-1, 1);
  std::uniform_int_distribution<> exponents(-40, 40);
  const auto number = [&] { return std::ldexp(digits(random), exponents(random)); };
  const Exact_rational relative = to_rational(0x1p-95);
  for (int i = 0; i < 2000; ++i) {
    const double a = number(), b = number(), c = number(), d = number();
    const Exact_rational ra = to_rational(a), rb = to_rational(b), rc = to_rational(c), rd = to_rational(d);
    const Double_word x = Double_word(a) + Double_word(b) * Double_word(c), y = Double_word(d) - Double_word(b);
    const Exact_rational ex(ra + rb * rc), ey(rd - rb);
    const Exact_rational size(CGAL::abs(ra) + CGAL::abs(Exact_rational(rb * rc)) + CGAL::abs(rd) + CGAL::abs(rb));
    expect_enclosed(x, ex, Exact_rational(relative * size));
    expect_enclosed(x * y, Exact_rational(ex * ey), Exact_rational(relative * size * size));
    if (ey != 0 && CGAL::abs(ey) > size * to_rational(0x1p-20))
      expect_enclosed(x / y, Exact_rational(ex / ey),
                      Exact_rational(relative * size / ey * size / ey * to_rational(0x1p20) * (1 + CGAL::abs(ex))));
    const Double_word cancelled = (Double_word(a) * Double_word(b) + Double_word(c)) - Double_word(a) * Double_word(b);
    expect_enclosed(cancelled, rc,
                    Exact_rational(relative * (size + CGAL::abs(Exact_rational(ra * rb)) + CGAL::abs(rc))));
  }
}

TEST(Double_word, SmallNumbersAndZero)
{
  expect_enclosed(Double_word(0.0) * Double_word(3.0), Exact_rational(0), to_rational(1e-300));
  expect_enclosed(Double_word(1e-200) * Double_word(1e-200), to_rational(1e-200) * to_rational(1e-200),
                  to_rational(1e-300));
  expect_enclosed(Double_word(std::int64_t(9007199254740993)), Exact_rational(std::int64_t(9007199254740993)),
                  Exact_rational(0));
}

// What is too great, or not divisible for certain, is not finite.
TEST(Double_word, NothingIsKnown)
{
  EXPECT_FALSE((Double_word(1e200) * Double_word(1e200)).is_finite());
  EXPECT_FALSE((Double_word(1.0) / Double_word(0.0)).is_finite());
  const Double_word third = Double_word(1.0) / Double_word(3.0), zero = third + third + third - Double_word(1.0);
  EXPECT_FALSE((Double_word(1.0) / zero).is_finite());
}

} // namespace double_word_test
