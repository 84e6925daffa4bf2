// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/number/concepts.h>

#include <CGAL/Mpzf.h>

#include <gtest/gtest.h>

#include "test_number_utilities.h"

#include <string>
#include <type_traits>
#include <vector>

using namespace number_testing;
using CGAL::Spline_constraints::assert_spline_number_type;
using CGAL::Spline_constraints::Mpfr_interval;
using CGAL::Spline_constraints::Number_traits;
using CGAL::Spline_constraints::SplineNumberType;
using Interval = CGAL::Interval_nt<false>;

namespace stub {

// A user's number type with the least the concept asks for: a double that counts its operations. No conversions, no
// comparisons, no streams.
class Counting_number
{
public:
  Counting_number() = default;
  explicit Counting_number(double value) : m_value(value) {}

  double value() const { return m_value; }
  static int& operations()
  {
    static int count = 0;
    return count;
  }

  Counting_number& operator+=(const Counting_number& other) { return *this = *this + other; }
  Counting_number& operator-=(const Counting_number& other) { return *this = *this - other; }
  Counting_number& operator*=(const Counting_number& other) { return *this = *this * other; }

  friend Counting_number operator+(const Counting_number& a, const Counting_number& b)
  {
    return counted(a.m_value + b.m_value);
  }
  friend Counting_number operator-(const Counting_number& a, const Counting_number& b)
  {
    return counted(a.m_value - b.m_value);
  }
  friend Counting_number operator*(const Counting_number& a, const Counting_number& b)
  {
    return counted(a.m_value * b.m_value);
  }
  friend Counting_number operator/(const Counting_number& a, const Counting_number& b)
  {
    return counted(a.m_value / b.m_value);
  }
  friend Counting_number operator-(const Counting_number& a) { return counted(-a.m_value); }

private:
  static Counting_number counted(double value)
  {
    ++operations();
    return Counting_number(value);
  }

  double m_value = 0;
};

// A ring with everything else in place: only the category that CGAL knows of it tells that its `/` is no inverse of
// `*`.
struct Whole_number
{
  int value = 0;
  Whole_number& operator+=(const Whole_number& other)
  {
    value += other.value;
    return *this;
  }
  Whole_number& operator-=(const Whole_number& other)
  {
    value -= other.value;
    return *this;
  }
  Whole_number& operator*=(const Whole_number& other)
  {
    value *= other.value;
    return *this;
  }
  friend Whole_number operator+(Whole_number a, const Whole_number& b) { return a += b; }
  friend Whole_number operator-(Whole_number a, const Whole_number& b) { return a -= b; }
  friend Whole_number operator*(Whole_number a, const Whole_number& b) { return a *= b; }
  friend Whole_number operator/(const Whole_number& a, const Whole_number& b) { return {a.value / b.value}; }
  friend Whole_number operator-(const Whole_number& a) { return {-a.value}; }
};

// A number without traits.
struct Unknown_number : Counting_number
{
  using Counting_number::Counting_number;
  Unknown_number(const Counting_number& base) : Counting_number(base) {}
};

// Traits whose is_exact is missing, and traits without half_sum.
struct Nameless_number : Unknown_number
{
  using Unknown_number::Unknown_number;
};
struct Halfless_number : Unknown_number
{
  using Unknown_number::Unknown_number;
};

} // namespace stub

namespace CGAL {

template <>
class Algebraic_structure_traits<stub::Whole_number>
    : public Algebraic_structure_traits_base<stub::Whole_number, Euclidean_ring_tag>
{};

namespace Spline_constraints {

template <>
struct Number_traits<stub::Counting_number>
{
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = false;
  static constexpr const char* name = "counting";
  static constexpr double unit_roundoff = 0x1p-52;
  using Coordinate = double;
  struct Rounding_guard
  {
    Rounding_guard() {}
  };
  static stub::Counting_number from_double(double x) { return stub::Counting_number(x); }
  static stub::Counting_number from_rational(const Exact_rational& x)
  {
    return stub::Counting_number(to_nearest_double(x));
  }
  static CGAL::Interval_nt<false> enclosure(const stub::Counting_number& x) { return {x.value(), x.value()}; }
  static CGAL::Uncertain<CGAL::Sign> sign(const stub::Counting_number& x)
  {
    return Number_traits<double>::sign(x.value());
  }
  static void scale_by_power_of_two(stub::Counting_number& x, int exponent)
  {
    double value = x.value();
    Number_traits<double>::scale_by_power_of_two(value, exponent);
    x = stub::Counting_number(value);
  }
  static stub::Counting_number half_sum(const stub::Counting_number& a, const stub::Counting_number& b)
  {
    return (a + b) * stub::Counting_number(0.5);
  }
};

template <>
struct Number_traits<stub::Whole_number>
{
  static constexpr bool is_exact = true;
  static constexpr bool is_enclosure = false;
  static constexpr const char* name = "whole";
  static constexpr double unit_roundoff = 0;
  using Coordinate = double;
  using Rounding_guard = Empty_rounding_guard;
  static stub::Whole_number from_double(double x) { return {static_cast<int>(x)}; }
  static stub::Whole_number from_rational(const Exact_rational&) { return {}; }
  static CGAL::Interval_nt<false> enclosure(const stub::Whole_number& x) { return x.value; }
  static CGAL::Uncertain<CGAL::Sign> sign(const stub::Whole_number& x) { return CGAL::sign(x.value); }
  static void scale_by_power_of_two(stub::Whole_number&, int) {}
  static stub::Whole_number half_sum(const stub::Whole_number& a, const stub::Whole_number&) { return a; }
};

template <>
struct Number_traits<stub::Nameless_number>
{
  using Coordinate = double;
  using Rounding_guard = Empty_rounding_guard;
};

template <>
struct Number_traits<stub::Halfless_number>
{
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = false;
  static constexpr const char* name = "halfless";
  static constexpr double unit_roundoff = 0x1p-52;
  using Coordinate = double;
  using Rounding_guard = Empty_rounding_guard;
};

} // namespace Spline_constraints
} // namespace CGAL

namespace {

namespace internal = CGAL::Spline_constraints::internal;

static_assert(SplineNumberType<double>);
static_assert(SplineNumberType<Interval>);
static_assert(SplineNumberType<Mpfr_interval>);
static_assert(SplineNumberType<Exact_rational>);
static_assert(SplineNumberType<stub::Counting_number>);
static_assert(assert_spline_number_type<double>() && assert_spline_number_type<Interval>() &&
              assert_spline_number_type<Mpfr_interval>() && assert_spline_number_type<Exact_rational>() &&
              assert_spline_number_type<stub::Counting_number>());

static_assert(!SplineNumberType<int>);
static_assert(!SplineNumberType<long>);
static_assert(!SplineNumberType<bool>);
static_assert(!SplineNumberType<float>);
static_assert(!SplineNumberType<long double>);
static_assert(!SplineNumberType<Exact_integer>);
static_assert(!SplineNumberType<CGAL::Interval_nt<true>>);
static_assert(!SplineNumberType<std::string>);
static_assert(!SplineNumberType<void*>);
static_assert(!SplineNumberType<const double>);
static_assert(!SplineNumberType<double&>);
static_assert(!SplineNumberType<stub::Whole_number>);
static_assert(!SplineNumberType<stub::Unknown_number>);
static_assert(!SplineNumberType<stub::Nameless_number>);
static_assert(!SplineNumberType<stub::Halfless_number>);

// Each is turned down for the reason that assert_spline_number_type() gives for it.
static_assert(internal::Has_ring_operators<int> && !internal::Has_field_division<int>);
static_assert(internal::Has_ring_operators<stub::Whole_number> && !internal::Has_field_division<stub::Whole_number> &&
              internal::Has_number_traits_functions<stub::Whole_number>);
static_assert(!internal::Has_ring_operators<std::string>);
static_assert(internal::Has_field_division<float> && !internal::Has_number_traits_types<float>);
static_assert(internal::Has_field_division<stub::Unknown_number> &&
              !internal::Has_number_traits_types<stub::Unknown_number>);
static_assert(internal::Has_number_traits_types<stub::Nameless_number> &&
              !internal::Has_number_traits_constants<stub::Nameless_number>);
static_assert(internal::Has_number_traits_constants<stub::Halfless_number> &&
              !internal::Has_number_traits_functions<stub::Halfless_number>);

#ifdef CGAL_HAS_MPZF
static_assert(!SplineNumberType<CGAL::Mpzf>);
static_assert(internal::Has_ring_operators<CGAL::Mpzf> && !internal::Has_field_division<CGAL::Mpzf>);
#endif

// The value at 1/2 of a polynomial in Bernstein form, by the concept alone: every step of a subdivision solver in
// small.
template <SplineNumberType NT>
NT value_at_half(std::vector<NT> coefficients)
{
  using Traits = Number_traits<NT>;
  [[maybe_unused]] const typename Traits::Rounding_guard guard;
  for (std::size_t level = coefficients.size() - 1; level > 0; --level)
    for (std::size_t i = 0; i < level; ++i)
      coefficients[i] = Traits::half_sum(coefficients[i], coefficients[i + 1]);
  NT result = Traits::from_double(0);
  result += coefficients.front();
  result -= Traits::from_double(1);
  result *= -Traits::from_double(2);
  result = -result / Traits::from_double(2) + Traits::from_double(1);
  Traits::scale_by_power_of_two(result, 3);
  Traits::scale_by_power_of_two(result, -3);
  return result;
}

template <SplineNumberType NT>
void expect_value(const std::vector<Exact_rational>& coefficients, const Exact_rational& exact)
{
  using Traits = Number_traits<NT>;
  std::vector<NT> converted;
  for (const Exact_rational& c : coefficients)
    converted.push_back(Traits::from_rational(c));
  const NT value = value_at_half(converted);
  const Interval enclosure = Traits::enclosure(value);
  const Exact_rational slack = Traits::is_exact || Traits::is_enclosure ? Exact_rational(0) : ratio(1, 1LL << 30);
  EXPECT_TRUE(CGAL::Spline_constraints::to_rational(enclosure.inf()) <= exact + slack) << Traits::name;
  EXPECT_TRUE(exact - slack <= CGAL::Spline_constraints::to_rational(enclosure.sup())) << Traits::name;
  EXPECT_LE(enclosure.sup() - enclosure.inf(), 1e-9) << Traits::name;
  if (Traits::is_exact) {
    EXPECT_EQ(Traits::sign(value).make_certain(), CGAL::sign(exact));
  }
}

TEST(concepts, generic_algorithm_runs_with_every_model)
{
  Random random(401);
  stub::Counting_number::operations() = 0;
  for (int i = 0; i < 50; ++i) {
    std::vector<Exact_rational> coefficients;
    const int degree = static_cast<int>(uniform(random, 0, 8));
    for (int k = 0; k <= degree; ++k)
      coefficients.push_back(ratio(uniform(random, -1000, 1000), uniform(random, 1, 100)));
    // sum of binomial(degree, k) b_k / 2^degree
    Exact_rational exact(0);
    long long binomial = 1;
    for (int k = 0; k <= degree; ++k) {
      exact += coefficients[k] * ratio(binomial, 1LL << degree);
      binomial = binomial * (degree - k) / (k + 1);
    }
    expect_value<double>(coefficients, exact);
    expect_value<Interval>(coefficients, exact);
    expect_value<Mpfr_interval>(coefficients, exact);
    expect_value<Exact_rational>(coefficients, exact);
    expect_value<stub::Counting_number>(coefficients, exact);
  }
  EXPECT_GT(stub::Counting_number::operations(), 250);
}

} // namespace
