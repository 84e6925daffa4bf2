// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_NUMBER_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_NUMBER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/mpq_access.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <mpfr.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Owns one MPFR number. That of up to 128 bits holds its digits itself (MPFR's custom interface), so that nothing is
// allocated for it. Moving steals the digits of others; what was moved from may only be assigned to or destroyed.
class Mpfr_number
{
  static constexpr mpfr_prec_t most_bits_inside = 128;

  mpfr_t m_value;
  std::array<mp_limb_t, (most_bits_inside + GMP_NUMB_BITS - 1) / GMP_NUMB_BITS> m_digits{};
  bool m_is_owner = true;

public:
  // The number 0 with room for `precision` bits.
  explicit Mpfr_number(mpfr_prec_t precision);

  Mpfr_number(const Mpfr_number& other);

  Mpfr_number(Mpfr_number&& other) noexcept;

  Mpfr_number& operator=(const Mpfr_number& other);

  Mpfr_number& operator=(Mpfr_number&& other) noexcept
  {
    swap(other);
    return *this;
  }

  ~Mpfr_number()
  {
    if (m_is_owner && !has_digits_inside())
      mpfr_clear(m_value);
  }

  void swap(Mpfr_number& other) noexcept;

  // Makes room for at least `precision` bits.
  void widen(mpfr_prec_t precision);

  mpfr_ptr get() { return m_value; }
  mpfr_srcptr get() const { return m_value; }
  mpfr_prec_t precision() const { return mpfr_get_prec(m_value); }

private:
  bool has_digits_inside() const { return precision() <= most_bits_inside; }

  void copy_with_digits(const Mpfr_number& other)
  {
    *m_value = *other.m_value;
    m_digits = other.m_digits;
    find_digits();
  }

  void find_digits()
  {
    if (has_digits_inside())
      mpfr_custom_move(m_value, m_digits.data());
  }
};

// The integer n >= 0 as an MPFR number, exactly. The way for integers that are not made of a GMP number.
Mpfr_number mpfr_of_integer(Exact_integer n);

// result = x, rounded once. The way for rationals of any type.
void set_from_parts(mpfr_ptr result, const Exact_rational& x, mpfr_rnd_t direction);

template <typename Rational>
void set_from_rational(mpfr_ptr result, const Rational& x, mpfr_rnd_t direction)
{
  if constexpr (Readable_as_mpq<Rational>)
    mpfr_set_q(result, mpq_of(x), direction);
  else
    set_from_parts(result, x, direction);
}

// The finite number x, exactly. The way for rationals of any type.
Exact_rational rational_from_digits(mpfr_srcptr x);

template <typename Rational>
Rational rational_of_mpfr(mpfr_srcptr x)
{
  CGAL_precondition(mpfr_number_p(x));
  if constexpr (Writable_as_mpq<Rational>) {
    Rational result(0);
    mpfr_get_q(writable_mpq_of(result), x);
    return result;
  } else {
    return rational_from_digits(x);
  }
}

// The sign of x - q; x may be infinite.
template <typename Rational>
int compare_mpfr(mpfr_srcptr x, const Rational& q)
{
  if (mpfr_inf_p(x))
    return mpfr_sgn(x);
  if constexpr (Readable_as_mpq<Rational>)
    return mpfr_cmp_q(x, mpq_of(q));
  else
    return static_cast<int>(CGAL::compare(rational_of_mpfr<Rational>(x), q));
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Mpfr_number::Mpfr_number(mpfr_prec_t precision)
{
  if (precision <= most_bits_inside) {
    mpfr_custom_init(m_digits.data(), precision);
    mpfr_custom_init_set(m_value, MPFR_ZERO_KIND, 0, precision, m_digits.data());
  } else {
    mpfr_init2(m_value, precision);
    mpfr_set_zero(m_value, 1);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Mpfr_number::Mpfr_number(const Mpfr_number& other)
{
  CGAL_precondition(other.m_is_owner);
  if (other.has_digits_inside())
    copy_with_digits(other);
  else {
    mpfr_init2(m_value, mpfr_get_prec(other.m_value));
    mpfr_set(m_value, other.m_value, MPFR_RNDN); // same precision: exact
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Mpfr_number::Mpfr_number(Mpfr_number&& other) noexcept
{
  if (other.has_digits_inside())
    copy_with_digits(other);
  else {
    *m_value = *other.m_value;
    m_is_owner = std::exchange(other.m_is_owner, false);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Mpfr_number& Mpfr_number::operator=(const Mpfr_number& other)
{
  if (this == &other)
    return *this;
  if (m_is_owner && mpfr_get_prec(m_value) == mpfr_get_prec(other.m_value)) {
    mpfr_set(m_value, other.m_value, MPFR_RNDN); // no allocation when the precision stays
    return *this;
  }
  Mpfr_number copy(other);
  swap(copy);
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Mpfr_number::swap(Mpfr_number& other) noexcept
{
  std::swap(*m_value, *other.m_value);
  std::swap(m_digits, other.m_digits);
  std::swap(m_is_owner, other.m_is_owner);
  find_digits();
  other.find_digits();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Mpfr_number::widen(mpfr_prec_t precision)
{
  if (precision <= this->precision())
    return;
  Mpfr_number wide(precision);
  mpfr_set(wide.m_value, m_value, MPFR_RNDN); // exact: there is only more room
  swap(wide);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Mpfr_number mpfr_of_integer(Exact_integer n)
{
  const Exact_integer base = integer_power_of_two(32);
  std::vector<double> digits; // the last one is the leading one
  while (CGAL::sign(n) == CGAL::POSITIVE) {
    const Exact_integer quotient = CGAL::div(n, base);
    const Exact_integer digit = n - quotient * base;
    digits.push_back(CGAL::to_double(digit));
    n = quotient;
  }
  Mpfr_number result(static_cast<mpfr_prec_t>(32 * digits.size() + 64));
  for (std::size_t i = digits.size(); i-- > 0;) {
    mpfr_mul_2ui(result.get(), result.get(), 32, MPFR_RNDN);
    mpfr_add_d(result.get(), result.get(), digits[i], MPFR_RNDN); // exact: the precision was chosen so
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void set_from_parts(mpfr_ptr result, const Exact_rational& x, mpfr_rnd_t direction)
{
  Rational_parts parts = parts_of(x);
  const bool is_negative = CGAL::sign(parts.numerator) == CGAL::NEGATIVE;
  if (is_negative)
    parts.numerator = -parts.numerator;
  Mpfr_number numerator = mpfr_of_integer(parts.numerator);
  const Mpfr_number denominator = mpfr_of_integer(parts.denominator);
  if (is_negative)
    mpfr_neg(numerator.get(), numerator.get(), MPFR_RNDN);
  mpfr_div(result, numerator.get(), denominator.get(), direction);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational rational_from_digits(mpfr_srcptr x)
{
  struct Owned_integer // the vector below may throw
  {
    mpz_t value;
    Owned_integer() { mpz_init(value); }
    ~Owned_integer() { mpz_clear(value); }
  } owned;
  mpz_ptr mantissa = owned.value;
  const mpfr_exp_t exponent = mpfr_get_z_2exp(mantissa, x);
  const bool is_negative = mpz_sgn(mantissa) < 0;
  std::vector<std::uint32_t> digits(mpz_sizeinbase(mantissa, 2) / 32 + 1);
  std::size_t count = 0;
  mpz_export(digits.data(), &count, 1, sizeof(std::uint32_t), 0, 0, mantissa);

  const Exact_integer base = integer_power_of_two(32);
  Exact_integer n(0);
  for (std::size_t i = 0; i < count; ++i) {
    n *= base;
    n += Exact_integer(static_cast<double>(digits[i]));
  }
  if (is_negative)
    n = -n;
  Exact_rational result = compose(n, Exact_integer(1));
  if (count != 0) // the exponent of zero means nothing
    scale_rational(result, static_cast<int>(exponent));
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_NUMBER_H
