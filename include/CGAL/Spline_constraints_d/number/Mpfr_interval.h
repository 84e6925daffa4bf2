// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_INTERVAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_INTERVAL_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_number.h>

#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <mpfr.h>

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <ostream>
#include <string>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

A closed interval whose two ends are MPFR numbers of a precision chosen at run time, lower ends rounded down and upper
ends up in every operation: the result of an operation on intervals contains the result of the operation on any numbers
the operands contain. The rounding mode of the thread plays no part.

Every object has its own precision (the same for both ends); the result of an operation has the larger one of its
operands, assignment takes over the precision of its source. Numbers that are converted get `default_precision()`, which
is per thread. `double` operands are exact and do not change the precision. An end that leaves MPFR's exponent range
becomes infinite. Neither end is ever NaN.

A moved-from object may only be assigned to or destroyed. Different threads may use different objects; MPFR must have
been built thread safe (`mpfr_buildopt_tls_p()`), as distributions do.

\cgalModels `SplineNumberType`
*/
class Mpfr_interval
{
public:
  //! every double is converted exactly at this precision, so there is no smaller one.
  static constexpr mpfr_prec_t minimum_precision = 53;

  //! larger precisions are taken for a mistake: GMP ends the program when it runs out of memory.
  static constexpr mpfr_prec_t maximum_precision = mpfr_prec_t(1) << 24;

  //! the precision in bits that conversions give in this thread; 128 at its start.
  static mpfr_prec_t default_precision() { return default_precision_of_thread(); }

  /*!
  sets the precision of conversions in this thread. `Mpfr_precision_scope` does so for a scope.

  \throws Invalid_input if `bits` is outside of `[minimum_precision, maximum_precision]`.
  */
  static void set_default_precision(mpfr_prec_t bits)
  {
    require_valid_precision(bits);
    default_precision_of_thread() = bits;
  }

  //! the number 0 at `default_precision()`.
  Mpfr_interval() : m_lower(default_precision()), m_upper(default_precision()) {}

  /*!
  the number `x`, exactly, at `default_precision()`.

  \throws Invalid_input if `x` is infinite or NaN.
  */
  Mpfr_interval(double x) : Mpfr_interval()
  {
    internal::require_finite(x);
    mpfr_set_d(lower_end(), x, MPFR_RNDD);
    mpfr_set_d(upper_end(), x, MPFR_RNDU);
  }

  // A long double may have more bits than a double, and would lose them without a word.
  Mpfr_interval(long double) = delete;

  //! the integer `x` at `default_precision()`, exactly if that many bits hold it.
  template <std::integral Integer>
  Mpfr_interval(Integer x) : Mpfr_interval()
  {
    // In two halves, each of which a double holds: MPFR's functions on `long` are no help where that has 32 bits.
    const double high = static_cast<double>(sizeof(Integer) > 4 ? x >> (sizeof(Integer) > 4 ? 32 : 0) : 0);
    const double low =
      sizeof(Integer) > 4 ? static_cast<double>(static_cast<std::uint32_t>(x)) : static_cast<double>(x);
    mpfr_set_d(lower_end(), high, MPFR_RNDD);
    mpfr_mul_2ui(lower_end(), lower_end(), 32, MPFR_RNDD);
    mpfr_set(upper_end(), lower_end(), MPFR_RNDU);
    mpfr_add_d(lower_end(), lower_end(), low, MPFR_RNDD);
    mpfr_add_d(upper_end(), upper_end(), low, MPFR_RNDU);
  }

  /*!
  the tightest enclosure of `x` with `precision` bits.

  \throws Invalid_input if `precision` is outside of `[minimum_precision, maximum_precision]`.
  */
  explicit Mpfr_interval(const Exact_rational& x, mpfr_prec_t precision = default_precision())
    : Mpfr_interval(x, x, precision)
  {}

  /*!
  the tightest interval with ends of `precision` bits that contains `lower` and `upper`.

  \throws Invalid_input if `lower > upper`, or `precision` is outside of `[minimum_precision, maximum_precision]`.
  */
  Mpfr_interval(const Exact_rational& lower, const Exact_rational& upper, mpfr_prec_t precision = default_precision())
    : m_lower(require_valid_precision(precision)), m_upper(precision)
  {
    if (CGAL::compare(lower, upper) == CGAL::LARGER)
      throw Invalid_input("Mpfr_interval: the lower end is larger than the upper end");
    internal::set_from_rational(lower_end(), lower, MPFR_RNDD);
    internal::set_from_rational(upper_end(), upper, MPFR_RNDU);
  }

  /*!
  the interval with given ends, which may be infinite, at the larger one of their precisions.

  \throws Invalid_input if an end is NaN, or `lower > upper`.
  */
  static Mpfr_interval of_ends(mpfr_srcptr lower, mpfr_srcptr upper)
  {
    if (!mpfr_lessequal_p(lower, upper))
      throw Invalid_input("Mpfr_interval: the lower end is not a number that is at most the upper end");
    Mpfr_interval result{Uninitialized(),
                         require_valid_precision((std::max)(mpfr_get_prec(lower), mpfr_get_prec(upper)))};
    mpfr_set(result.lower_end(), lower, MPFR_RNDD);   // exact
    mpfr_set(result.upper_end(), upper, MPFR_RNDU);
    return result;
  }

  //! the entire real line, at `precision` bits.
  static Mpfr_interval entire_line(mpfr_prec_t precision = default_precision())
  {
    Mpfr_interval result{Uninitialized(), require_valid_precision(precision)};
    mpfr_set_inf(result.lower_end(), -1);
    mpfr_set_inf(result.upper_end(), 1);
    return result;
  }

  //! the number of bits of both ends.
  mpfr_prec_t precision() const { return m_lower.precision(); }

  //! \name Ends
  //! @{

  //! the lower end, for MPFR's functions; belongs to this object.
  mpfr_srcptr lower_mpfr() const { return m_lower.get(); }

  //! the upper end, for MPFR's functions; belongs to this object.
  mpfr_srcptr upper_mpfr() const { return m_upper.get(); }

  //! returns whether both ends are finite.
  bool is_bounded() const { return mpfr_number_p(lower_mpfr()) && mpfr_number_p(upper_mpfr()); }

  //! returns whether the interval is one number.
  bool is_point() const { return is_bounded() && mpfr_equal_p(lower_mpfr(), upper_mpfr()); }

  //! the lower end, exactly. \throws Invalid_input if the interval is not bounded.
  Exact_rational lower() const { return end(lower_mpfr()); }

  //! the upper end, exactly. \throws Invalid_input if the interval is not bounded.
  Exact_rational upper() const { return end(upper_mpfr()); }

  //! half the sum of the ends, exactly. \throws Invalid_input if the interval is not bounded.
  Exact_rational midpoint() const
  {
    Exact_rational result = lower() + upper();
    internal::scale_rational(result, -1);
    return result;
  }

  //! the difference of the ends, rounded up to a double; infinite if the interval is not bounded.
  double width() const
  {
    internal::Mpfr_number difference(precision());
    mpfr_sub(difference.get(), upper_mpfr(), lower_mpfr(), MPFR_RNDU);
    return mpfr_get_d(difference.get(), MPFR_RNDU);
  }

  //! the tightest pair of doubles that encloses the interval, infinite where it leaves the range of doubles.
  std::pair<double, double> to_double_interval() const
  {
    return {mpfr_get_d(lower_mpfr(), MPFR_RNDD), mpfr_get_d(upper_mpfr(), MPFR_RNDU)};
  }
  //! @}

  //! \name Predicates
  //! @{

  //! the sign of the numbers in the interval, as far as they have it in common: `{ZERO, POSITIVE}` for `[0, 1]`.
  CGAL::Uncertain<CGAL::Sign> sign() const
  {
    return {sign_of(lower_mpfr()), sign_of(upper_mpfr())};
  }

  //! returns whether `x` lies in the interval.
  bool contains(const Exact_rational& x) const
  {
    return internal::compare_mpfr(lower_mpfr(), x) <= 0 && internal::compare_mpfr(upper_mpfr(), x) >= 0;
  }

  //! returns whether `other` is a subset.
  bool contains(const Mpfr_interval& other) const
  {
    return mpfr_lessequal_p(lower_mpfr(), other.lower_mpfr()) && mpfr_lessequal_p(other.upper_mpfr(), upper_mpfr());
  }

  //! returns whether both have the same ends (their precisions may differ).
  bool is_same(const Mpfr_interval& other) const
  {
    return mpfr_equal_p(lower_mpfr(), other.lower_mpfr()) && mpfr_equal_p(upper_mpfr(), other.upper_mpfr());
  }
  //! @}

  //! \name Arithmetic
  //! @{

  Mpfr_interval& operator+=(const Mpfr_interval& other)
  {
    widen_to(other.precision());
    mpfr_add(lower_end(), lower_mpfr(), other.lower_mpfr(), MPFR_RNDD);
    mpfr_add(upper_end(), upper_mpfr(), other.upper_mpfr(), MPFR_RNDU);
    return *this;
  }

  Mpfr_interval& operator-=(const Mpfr_interval& other)
  {
    // x - x would read an end that was just written.
    if (this == &other)
      return *this -= Mpfr_interval(other);
    widen_to(other.precision());
    mpfr_sub(lower_end(), lower_mpfr(), other.upper_mpfr(), MPFR_RNDD);
    mpfr_sub(upper_end(), upper_mpfr(), other.lower_mpfr(), MPFR_RNDU);
    return *this;
  }

  Mpfr_interval& operator*=(const Mpfr_interval& other);

  //! division; the entire line if `other` contains 0.
  Mpfr_interval& operator/=(const Mpfr_interval& other);

  //! exact operand, no temporary interval; keeps the precision. \throws Invalid_input if `x` is infinite or NaN.
  Mpfr_interval& operator+=(std::same_as<double> auto x)
  {
    internal::require_finite(x);
    mpfr_add_d(lower_end(), lower_mpfr(), x, MPFR_RNDD);
    mpfr_add_d(upper_end(), upper_mpfr(), x, MPFR_RNDU);
    return *this;
  }

  //! like `operator+=` with a double.
  Mpfr_interval& operator-=(std::same_as<double> auto x) { return *this += -x; }

  //! like `operator+=` with a double.
  Mpfr_interval& operator*=(std::same_as<double> auto x) { return multiply_by_double(x); }

  //! like `operator+=` with a double; the entire line if `x` is 0.
  Mpfr_interval& operator/=(std::same_as<double> auto x) { return divide_by_double(x); }

  //! multiplies by \f$ 2^e \f$, `e` = `exponent`, exactly.
  Mpfr_interval& scale_by_power_of_two(int exponent)
  {
    mpfr_mul_2si(lower_end(), lower_mpfr(), exponent, MPFR_RNDD);
    mpfr_mul_2si(upper_end(), upper_mpfr(), exponent, MPFR_RNDU);
    return *this;
  }

  //! turns the interval into that of the opposite numbers, exactly.
  Mpfr_interval& negate()
  {
    m_lower.swap(m_upper);
    mpfr_neg(lower_end(), lower_mpfr(), MPFR_RNDD);
    mpfr_neg(upper_end(), upper_mpfr(), MPFR_RNDU);
    return *this;
  }

  friend Mpfr_interval operator-(Mpfr_interval a) { a.negate(); return a; }
  friend Mpfr_interval operator+(Mpfr_interval a) { return a; }

  friend Mpfr_interval operator+(Mpfr_interval a, const Mpfr_interval& b) { a += b; return a; }
  friend Mpfr_interval operator-(Mpfr_interval a, const Mpfr_interval& b) { a -= b; return a; }
  friend Mpfr_interval operator*(Mpfr_interval a, const Mpfr_interval& b) { a *= b; return a; }
  friend Mpfr_interval operator/(Mpfr_interval a, const Mpfr_interval& b) { a /= b; return a; }

  // Constrained to what is a double already: a long would be rounded on its way.
  friend Mpfr_interval operator+(Mpfr_interval a, std::same_as<double> auto b) { a += b; return a; }
  friend Mpfr_interval operator-(Mpfr_interval a, std::same_as<double> auto b) { a -= b; return a; }
  friend Mpfr_interval operator*(Mpfr_interval a, std::same_as<double> auto b) { a *= b; return a; }
  friend Mpfr_interval operator/(Mpfr_interval a, std::same_as<double> auto b) { a /= b; return a; }

  friend Mpfr_interval operator+(std::same_as<double> auto a, Mpfr_interval b) { b += a; return b; }
  friend Mpfr_interval operator-(std::same_as<double> auto a, Mpfr_interval b) { b.negate(); b += a; return b; }
  friend Mpfr_interval operator*(std::same_as<double> auto a, Mpfr_interval b) { b *= a; return b; }
  friend Mpfr_interval operator/(std::same_as<double> auto a, const Mpfr_interval& b)
  {
    Mpfr_interval quotient(Exact_rational(a), b.precision());
    quotient /= b;
    return quotient;
  }

  //! \f$ (a + b) / 2 \f$; the halving is exact.
  static Mpfr_interval half_sum(Mpfr_interval a, const Mpfr_interval& b)
  {
    a += b;
    a.scale_by_power_of_two(-1);
    return a;
  }
  //! @}

  void swap(Mpfr_interval& other) noexcept
  {
    m_lower.swap(other.m_lower);
    m_upper.swap(other.m_upper);
  }

  friend void swap(Mpfr_interval& a, Mpfr_interval& b) noexcept { a.swap(b); }

  //! writes `[l;u]` in decimals, `os.precision()` of them after the point, rounded outward.
  friend std::ostream& operator<<(std::ostream& os, const Mpfr_interval& x)
  {
    const int digits = static_cast<int>(os.precision());
    char* text = nullptr;
    if (mpfr_asprintf(&text, "[%.*RDe;%.*RUe]", digits, x.lower_mpfr(), digits, x.upper_mpfr()) < 0) {
      os.setstate(std::ios_base::failbit);
      return os;
    }
    os << text;
    mpfr_free_str(text);
    return os;
  }

private:
  struct Uninitialized {};

  Mpfr_interval(Uninitialized, mpfr_prec_t precision) : m_lower(precision), m_upper(precision) {}

  // MPFR keeps a pool of numbers per thread, which nobody frees when the thread ends unless told to.
  struct Thread_state
  {
    mpfr_prec_t precision = 128;
    ~Thread_state() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
  };

  static mpfr_prec_t& default_precision_of_thread()
  {
    static thread_local Thread_state state;
    return state.precision;
  }

  static mpfr_prec_t require_valid_precision(mpfr_prec_t bits)
  {
    if (bits < minimum_precision || bits > maximum_precision)
      throw Invalid_input("Mpfr_interval: a precision of " + std::to_string(bits) + " bits is outside of [" +
                          std::to_string(minimum_precision) + ", " + std::to_string(maximum_precision) + "]");
    return bits;
  }

  static CGAL::Sign sign_of(mpfr_srcptr x)
  {
    const int sign = mpfr_sgn(x);
    return sign > 0 ? CGAL::POSITIVE : sign < 0 ? CGAL::NEGATIVE : CGAL::ZERO;
  }

  static Exact_rational end(mpfr_srcptr x)
  {
    if (!mpfr_number_p(x))
      throw Invalid_input("Mpfr_interval: the exact end of an interval that is not bounded was asked for");
    return internal::rational_of_mpfr<Exact_rational>(x);
  }

  // rop = x * y where 0 times infinity is 0: the infinite end stands for finite numbers.
  static void multiply(mpfr_ptr rop, mpfr_srcptr x, mpfr_srcptr y, mpfr_rnd_t direction)
  {
    if (mpfr_zero_p(x) || mpfr_zero_p(y))
      mpfr_set_zero(rop, 1);
    else
      mpfr_mul(rop, x, y, direction);
  }

  Mpfr_interval& multiply_by_double(double x);
  Mpfr_interval& divide_by_double(double x);

  mpfr_ptr lower_end() { return m_lower.get(); }
  mpfr_ptr upper_end() { return m_upper.get(); }

  void widen_to(mpfr_prec_t bits)
  {
    m_lower.widen(bits);
    m_upper.widen(bits);
  }

  internal::Mpfr_number m_lower;
  internal::Mpfr_number m_upper;
};

inline Mpfr_interval& Mpfr_interval::operator*=(const Mpfr_interval& other)
{
  Mpfr_interval product{Uninitialized(), (std::max)(precision(), other.precision())};
  const mpfr_srcptr a = lower_mpfr(), b = upper_mpfr(), c = other.lower_mpfr(), d = other.upper_mpfr();
  const bool is_nonnegative = mpfr_sgn(a) >= 0;
  const bool is_nonpositive = mpfr_sgn(b) <= 0;
  const bool is_other_nonnegative = mpfr_sgn(c) >= 0;
  const bool is_other_nonpositive = mpfr_sgn(d) <= 0;

  if (is_nonnegative || is_nonpositive || is_other_nonnegative || is_other_nonpositive) {
    // Which ends make the extreme products follows from the signs alone.
    mpfr_srcptr low_left, low_right, high_left, high_right;
    if (is_nonnegative) {
      low_left = is_other_nonnegative ? a : b;
      low_right = c;
      high_left = is_other_nonpositive ? a : b;
      high_right = d;
    } else if (is_nonpositive) {
      low_left = is_other_nonpositive ? b : a;
      low_right = d;
      high_left = is_other_nonnegative ? b : a;
      high_right = c;
    } else {
      low_left = is_other_nonnegative ? a : b;
      low_right = is_other_nonnegative ? d : c;
      high_left = is_other_nonnegative ? b : a;
      high_right = is_other_nonnegative ? d : c;
    }
    multiply(product.lower_end(), low_left, low_right, MPFR_RNDD);
    multiply(product.upper_end(), high_left, high_right, MPFR_RNDU);
  } else {
    internal::Mpfr_number second(product.precision());
    multiply(product.lower_end(), a, d, MPFR_RNDD);
    multiply(second.get(), b, c, MPFR_RNDD);
    mpfr_min(product.lower_end(), product.lower_mpfr(), second.get(), MPFR_RNDD);
    multiply(product.upper_end(), a, c, MPFR_RNDU);
    multiply(second.get(), b, d, MPFR_RNDU);
    mpfr_max(product.upper_end(), product.upper_mpfr(), second.get(), MPFR_RNDU);
  }
  swap(product);
  return *this;
}

inline Mpfr_interval& Mpfr_interval::operator/=(const Mpfr_interval& other)
{
  const mpfr_prec_t bits = (std::max)(precision(), other.precision());
  const mpfr_srcptr a = lower_mpfr(), b = upper_mpfr(), c = other.lower_mpfr(), d = other.upper_mpfr();
  if (mpfr_sgn(c) <= 0 && mpfr_sgn(d) >= 0)
    return *this = entire_line(bits);

  // Neither quotient is infinity by infinity: an unbounded end of `other` only meets an end that is finite.
  Mpfr_interval quotient{Uninitialized(), bits};
  const bool is_other_positive = mpfr_sgn(c) > 0;
  const mpfr_srcptr low = is_other_positive ? a : b;
  const mpfr_srcptr high = is_other_positive ? b : a;
  mpfr_div(quotient.lower_end(), low, mpfr_sgn(low) >= 0 ? d : c, MPFR_RNDD);
  mpfr_div(quotient.upper_end(), high, mpfr_sgn(high) >= 0 ? c : d, MPFR_RNDU);
  swap(quotient);
  return *this;
}

inline Mpfr_interval& Mpfr_interval::multiply_by_double(double x)
{
  internal::require_finite(x);
  if (x == 0) {
    mpfr_set_zero(lower_end(), 1);
    mpfr_set_zero(upper_end(), 1);
    return *this;
  }
  mpfr_mul_d(lower_end(), lower_mpfr(), x, x > 0 ? MPFR_RNDD : MPFR_RNDU);
  mpfr_mul_d(upper_end(), upper_mpfr(), x, x > 0 ? MPFR_RNDU : MPFR_RNDD);
  if (x < 0)
    m_lower.swap(m_upper);
  return *this;
}

inline Mpfr_interval& Mpfr_interval::divide_by_double(double x)
{
  internal::require_finite(x);
  if (x == 0)
    return *this = entire_line(precision());
  mpfr_div_d(lower_end(), lower_mpfr(), x, x > 0 ? MPFR_RNDD : MPFR_RNDU);
  mpfr_div_d(upper_end(), upper_mpfr(), x, x > 0 ? MPFR_RNDU : MPFR_RNDD);
  if (x < 0)
    m_lower.swap(m_upper);
  return *this;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_INTERVAL_H
