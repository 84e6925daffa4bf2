// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_SHORT_INTEGER_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_SHORT_INTEGER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/two_words.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Integers of any size that take no memory while they fit into two machine words: on small systems nearly all do, and most
of the time would go into the memory of GMP's.

A number that has outgrown the words is GMP's until another value is assigned; its memory is kept for the next time.
*/
class Short_integer
{
  Two_words m_words = 0;      // the value, unless it is long
  bool m_is_long = false;
  bool m_has_memory = false;  // m_long is initialized
  mpz_t m_long{};

public:
  // The number as GMP sees it, without a copy; valid while the number lives and does not change.
  class View
  {
    mp_limb_t m_limbs[2];
    mpz_t m_own;
    mpz_srcptr m_value;

  public:
    explicit View(const Short_integer& number) : m_value(number.m_is_long ? number.m_long : m_own)
    {
      static_assert(sizeof(mp_limb_t) == 8);
      if (!number.m_is_long) {
        const Unsigned_two_words size = magnitude(number.m_words);
        m_limbs[0] = static_cast<mp_limb_t>(size);
        m_limbs[1] = static_cast<mp_limb_t>(size >> 64);
        const int count = m_limbs[1] != 0 ? 2 : m_limbs[0] != 0 ? 1 : 0;
        mpz_roinit_n(m_own, m_limbs, number.m_words < 0 ? -count : count);
      }
    }
    View(const View&) = delete;
    View& operator=(const View&) = delete;

    operator mpz_srcptr() const { return m_value; }
  };

  Short_integer() = default;

  template <std::integral T>
  Short_integer(T value) : m_words(value)
  {}

  explicit Short_integer(mpz_srcptr value) { assign(value); }
  explicit Short_integer(const Big_integer& value) : Short_integer(value.backend().data()) {}

  Short_integer(const Short_integer& other) { *this = other; }

  Short_integer(Short_integer&& other) noexcept
    : m_words(other.m_words), m_is_long(other.m_is_long), m_has_memory(std::exchange(other.m_has_memory, false))
  {
    if (m_has_memory)
      *m_long = *other.m_long;
    other.m_is_long = false;
  }

  Short_integer& operator=(const Short_integer& other)
  {
    if (other.m_is_long)
      mpz_set(memory(), other.m_long);
    m_is_long = other.m_is_long;
    m_words = other.m_words;
    return *this;
  }

  Short_integer& operator=(Short_integer&& other) noexcept
  {
    std::swap(m_words, other.m_words);
    std::swap(m_is_long, other.m_is_long);
    std::swap(m_has_memory, other.m_has_memory);
    std::swap(*m_long, *other.m_long);
    return *this;
  }

  ~Short_integer()
  {
    if (m_has_memory)
      mpz_clear(m_long);
  }

  Big_integer to_big_integer() const
  {
    Big_integer result;
    mpz_set(result.backend().data(), View(*this));
    return result;
  }

  int sign() const { return m_is_long ? mpz_sgn(m_long) : (m_words > 0) - (m_words < 0); }

  Short_integer& operator+=(const Short_integer& other)
  {
    Two_words result;
    if (!is_short_with(other) || __builtin_add_overflow(m_words, other.m_words, &result))
      return apply(mpz_add, other);
    m_words = result;
    return *this;
  }

  Short_integer& operator-=(const Short_integer& other)
  {
    Two_words result;
    if (!is_short_with(other) || __builtin_sub_overflow(m_words, other.m_words, &result))
      return apply(mpz_sub, other);
    m_words = result;
    return *this;
  }

  Short_integer& operator*=(const Short_integer& other)
  {
    Two_words result;
    if (!is_short_with(other) || !multiply(m_words, other.m_words, result))
      return apply(mpz_mul, other);
    m_words = result;
    return *this;
  }

  // Truncates. \pre other is not zero
  Short_integer& operator/=(const Short_integer& other)
  {
    if (!is_short_with(other) || other.m_words == -1)
      return apply(mpz_tdiv_q, other);
    m_words /= other.m_words;
    return *this;
  }

  Short_integer& operator%=(const Short_integer& other)
  {
    if (!is_short_with(other) || other.m_words == -1)
      return apply(mpz_tdiv_r, other);
    m_words %= other.m_words;
    return *this;
  }

  friend Short_integer operator+(Short_integer a, const Short_integer& b) { return std::move(a += b); }
  friend Short_integer operator-(Short_integer a, const Short_integer& b) { return std::move(a -= b); }
  friend Short_integer operator*(Short_integer a, const Short_integer& b) { return std::move(a *= b); }
  friend Short_integer operator/(Short_integer a, const Short_integer& b) { return std::move(a /= b); }
  friend Short_integer operator%(Short_integer a, const Short_integer& b) { return std::move(a %= b); }
  friend Short_integer operator-(const Short_integer& a) { return Short_integer(0) - a; }

  friend bool operator==(const Short_integer& a, const Short_integer& b)
  {
    return a.is_short_with(b) ? a.m_words == b.m_words : mpz_cmp(View(a), View(b)) == 0;
  }

  friend bool operator<(const Short_integer& a, const Short_integer& b)
  {
    return a.is_short_with(b) ? a.m_words < b.m_words : mpz_cmp(View(a), View(b)) < 0;
  }

  // sum += a b
  friend void add_product(Short_integer& sum, const Short_integer& a, const Short_integer& b)
  {
    Two_words product, total;
    if (sum.is_short_with(a) && !b.m_is_long && multiply(a.m_words, b.m_words, product) &&
        !__builtin_add_overflow(sum.m_words, product, &total)) {
      sum.m_words = total;
      return;
    }
    sum.make_long();
    mpz_addmul(sum.m_long, View(a), View(b));
  }

  // target = value 2^bits
  friend void set_shifted(Short_integer& target, const Short_integer& value, unsigned long bits)
  {
    if (!value.m_is_long && bits + bit_length(value) < 127) {
      target.m_words = value.m_words << bits;
      target.m_is_long = false;
      return;
    }
    mpz_mul_2exp(target.memory(), View(value), bits);
    target.m_is_long = true;
  }

  // target = value 2^-bits, truncated
  friend void set_shifted_right(Short_integer& target, const Short_integer& value, unsigned long bits)
  {
    mpz_tdiv_q_2exp(target.memory(), View(value), bits);
    target.m_is_long = true;
  }

  friend void shift_left(Short_integer& value, unsigned long bits)
  {
    if (bits != 0)
      set_shifted(value, value, bits);
  }

  // Number of bits of the absolute value; 0 for 0.
  friend long bit_length(const Short_integer& value)
  {
    if (!value.m_is_long)
      return bit_length(magnitude(value.m_words));
    return mpz_sgn(value.m_long) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(value.m_long, 2));
  }

  friend bool is_power_of_two(const Short_integer& value)
  {
    return value.m_is_long ? mpz_popcount(value.m_long) == 1
                           : value.m_words > 0 && (value.m_words & (value.m_words - 1)) == 0;
  }

  // value 2^exponent, truncated: relative error below 2^-52, whatever the rounding mode.
  friend double to_scaled_double(const Short_integer& value, long exponent)
  {
    if (!value.m_is_long) {
      const int bits = bit_length(magnitude(value.m_words)), shift = (std::max)(bits - 53, 0);
      const double size = static_cast<double>(static_cast<std::int64_t>(magnitude(value.m_words) >> shift));
      return scaled_mantissa(times_power_of_two(value.m_words < 0 ? -size : size, shift - bits), bits + exponent);
    }
    long own_exponent = 0;
    const double mantissa = mpz_get_d_2exp(&own_exponent, value.m_long);
    return scaled_mantissa(mantissa, own_exponent + exponent);
  }

  // The quotient of the magnitudes, times 2^shift, truncated. \pre denominator > 0, and the quotient has at most 127
  // bits
  friend Unsigned_two_words scaled_quotient(const Short_integer& numerator, long shift,
                                            const Short_integer& denominator)
  {
    if (shift >= 0 && numerator.is_short_with(denominator) && bit_length(denominator) <= 64) {
      if (numerator.m_words == 0)
        return 0;
      const Unsigned_two_words divisor = magnitude(denominator.m_words);
      Unsigned_two_words quotient = magnitude(numerator.m_words) / divisor,
                         rest = magnitude(numerator.m_words) % divisor;
      while (shift > 0 && divisor > 1) {
        const int bits = static_cast<int>((std::min)(shift, 64L));
        rest <<= bits;
        quotient = quotient << bits | rest / divisor;
        rest %= divisor;
        shift -= bits;
      }
      return shift > 0 ? quotient << shift : quotient;
    }
    Short_integer result;
    if (shift >= 0)
      set_shifted(result, numerator, static_cast<unsigned long>(shift));
    else
      set_shifted_right(result, numerator, static_cast<unsigned long>(-shift));
    result.apply(mpz_tdiv_q, denominator);
    CGAL_assertion(bit_length(result) <= 128);
    return Unsigned_two_words(mpz_getlimbn(result.m_long, 0)) |
        Unsigned_two_words(mpz_getlimbn(result.m_long, 1)) << 64;
  }

  // The greatest common divisor, not negative.
  friend Short_integer gcd(const Short_integer& a, const Short_integer& b)
  {
    if (bit_length(a) <= 63 && bit_length(b) <= 63 && a.is_short_with(b))
      return std::gcd(static_cast<std::int64_t>(a.m_words), static_cast<std::int64_t>(b.m_words));
    Short_integer result;
    mpz_gcd(result.memory(), View(a), View(b));
    result.m_is_long = true;
    return result;
  }

private:
  bool is_short_with(const Short_integer& other) const { return !m_is_long && !other.m_is_long; }

  void assign(mpz_srcptr value)
  {
    if (mpz_sizeinbase(value, 2) <= 126) {
      const Unsigned_two_words size =
          Unsigned_two_words(mpz_getlimbn(value, 0)) | Unsigned_two_words(mpz_getlimbn(value, 1)) << 64;
      m_words = mpz_sgn(value) < 0 ? -static_cast<Two_words>(size) : static_cast<Two_words>(size);
      m_is_long = false;
    } else {
      mpz_set(memory(), value);
      m_is_long = true;
    }
  }

  mpz_ptr memory()
  {
    if (!m_has_memory)
      mpz_init(m_long);
    m_has_memory = true;
    return m_long;
  }

  void make_long()
  {
    if (m_is_long)
      return;
    const View view(*this);
    mpz_set(memory(), view);
    m_is_long = true;
  }

  template <class Operation>
  Short_integer& apply(const Operation& operation, const Short_integer& other)
  {
    make_long();
    operation(m_long, m_long, View(other));
    return *this;
  }
};

// Numerator and denominator of a rational.
template <class Rational>
std::pair<Short_integer, Short_integer> parts_of_rational(const Rational& value)
{
  if constexpr (Readable_as_mpq<Rational>)
    return {Short_integer(mpq_numref(mpq_of(value))), Short_integer(mpq_denref(mpq_of(value)))};
  else
    return {Short_integer(numerator_of_rational(value)), Short_integer(denominator_of_rational(value))};
}

// The least common multiple of `common` and the denominator of a rational takes the place of `common`.
inline void extend_common_denominator(Short_integer& common, const Exact_rational& value)
{
  const Short_integer denominator = parts_of_rational(value).second;
  if (common != denominator && common % denominator != 0)
    common *= denominator / gcd(common, denominator);
}

// value * common, an integer. \pre the denominator of the rational divides `common`
inline Short_integer numerator_over(const Exact_rational& value, const Short_integer& common)
{
  auto [numerator, denominator] = parts_of_rational(value);
  if (common != denominator)
    numerator *= common / denominator;
  return numerator;
}

// Numbers over their common denominator, which is returned.
Short_integer over_common_denominator(const std::vector<Exact_rational>& numbers,
                                      std::vector<Short_integer>& numerators);

Short_integer over_common_denominator(const std::vector<double>& numbers, std::vector<Short_integer>& numerators);

// target = numerator / denominator, exactly. \pre denominator > 0
void set_quotient(Exact_rational& target, const Short_integer& numerator, const Short_integer& denominator);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Short_integer over_common_denominator(const std::vector<Exact_rational>& numbers,
                                                                     std::vector<Short_integer>& numerators)
{
  Short_integer denominator(1);
  for (const Exact_rational& number : numbers)
    extend_common_denominator(denominator, number);
  numerators.clear();
  for (const Exact_rational& number : numbers)
    numerators.push_back(numerator_over(number, denominator));
  return denominator;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Short_integer over_common_denominator(const std::vector<double>& numbers,
                                                                     std::vector<Short_integer>& numerators)
{
  long finest = 0;
  for (double number : numbers)
    finest = (std::min)(finest, to_dyadic<Short_integer>(number).second);
  numerators.clear();
  numerators.reserve(numbers.size());
  for (double number : numbers) {
    auto [mantissa, exponent] = to_dyadic<Short_integer>(number);
    shift_left(mantissa, static_cast<unsigned long>(exponent - finest));
    numerators.push_back(std::move(mantissa));
  }
  Short_integer denominator(1);
  shift_left(denominator, static_cast<unsigned long>(-finest));
  return denominator;
}

// A template, as not all rational numbers have what is asked of some.
template <class Rational>
void set_quotient_of(Rational& target, const Short_integer& numerator, const Short_integer& denominator)
{
  if constexpr (Writable_as_mpq<Rational>) {
    mpq_ptr value = writable_mpq_of(target);
    mpz_set(mpq_numref(value), Short_integer::View(numerator));
    if (is_power_of_two(denominator)) {
      mpz_set_ui(mpq_denref(value), 1);
      mpq_div_2exp(value, value, static_cast<unsigned long>(bit_length(denominator) - 1));
    } else {
      mpz_set(mpq_denref(value), Short_integer::View(denominator));
      mpq_canonicalize(value);
    }
  } else
    target = quotient(numerator.to_big_integer(), denominator.to_big_integer());
}

CGAL_SPLINE_CONSTRAINTS_INLINE void set_quotient(Exact_rational& target, const Short_integer& numerator,
                                                 const Short_integer& denominator)
{
  set_quotient_of(target, numerator, denominator);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_SHORT_INTEGER_H
