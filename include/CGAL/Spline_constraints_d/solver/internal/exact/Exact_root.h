// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_EXACT_ROOT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_EXACT_ROOT_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The number of sign changes in a sequence, zeros left out.
inline int sign_variations(const std::vector<Big_integer>& values)
{
  int variations = 0, last = 0;
  for (const Big_integer& value : values)
    if (const int sign = value.sign(); sign != 0) {
      variations += last * sign < 0;
      last = sign;
    }
  return variations;
}

// A dyadic number in [lower, upper], lower < upper.
inline Exact_rational simple_dyadic_between(const Exact_rational& lower, const Exact_rational& upper)
{
  // The middle, rounded to a unit below half the width.
  const Exact_rational middle = (lower + upper) / Exact_rational(2), width = upper - lower;
  const long bits = bit_length(denominator_of(width)) - bit_length(numerator_of(width)) + 3;
  const Exact_rational scaled = middle * power_of_two(bits);
  Big_integer quotient;
  mpz_fdiv_q(quotient.backend().data(), numerator_of(scaled).backend().data(), denominator_of(scaled).backend().data());
  return scaled_rational(quotient, -bits);
}

/*
A real root of a polynomial, the only one in an open interval where it is simple, or exactly the point that the interval
is.
*/
class Exact_root
{
  std::shared_ptr<const Integer_polynomial> m_polynomial;
  Exact_rational m_lower, m_upper;
  CGAL::Sign m_lower_sign = CGAL::ZERO; // of the polynomial between the lower end and the root

public:
  Exact_root(std::shared_ptr<const Integer_polynomial> polynomial, Exact_rational lower, Exact_rational upper,
             CGAL::Sign lower_sign)
    : m_polynomial(std::move(polynomial)), m_lower(std::move(lower)), m_upper(std::move(upper)),
      m_lower_sign(lower_sign)
  {}

  explicit Exact_root(const Exact_rational& point) : m_lower(point), m_upper(point) {}

  const Exact_rational& lower() const { return m_lower; }
  const Exact_rational& upper() const { return m_upper; }
  Exact_rational width() const { return m_upper - m_lower; }
  bool is_point() const { return m_lower == m_upper; }

  // Cuts the interval at a point of it and keeps the part with the root.
  void cut(const Exact_rational& at)
  {
    const CGAL::Sign sign = m_polynomial->sign_at(at);
    if (sign == CGAL::ZERO)
      m_lower = m_upper = at;
    else
      (sign == m_lower_sign ? m_lower : m_upper) = at;
  }

  void halve()
  {
    if (!is_point())
      cut((m_lower + m_upper) / Exact_rational(2));
  }

  /*
  Until the interval is not wider than that: a part of 2^-2^j of it where the secant is zero is mostly the one with the
  root, and then j grows by one; if it is not, j falls, and at its lowest the interval is halved (Abbott 2006).
  */
  void narrow(const Exact_rational& width)
  {
    for (int j = 0; m_upper - m_lower > width;)
      if (j == 0) {
        halve();
        ++j;
      } else
        j = keeps_part_at_secant(1L << j) ? j + 1 : j - 1;
  }

  // Becomes the simplest rational of the interval, if that is the root.
  void settle_on_simplest_rational()
  {
    if (const Exact_rational x = simplest_rational_between(m_lower, m_upper);
        !is_point() && m_polynomial->sign_at(x) == CGAL::ZERO)
      m_lower = m_upper = x;
  }

  CGAL::Comparison_result compare(const Exact_rational& x)
  {
    if (m_lower < x && x < m_upper)
      cut(x);
    return m_upper < x || (m_upper == x && !is_point()) ? CGAL::SMALLER
        : m_lower == x && is_point()                    ? CGAL::EQUAL
                                                        : CGAL::LARGER;
  }

  // The sign of another polynomial at the root. They have the root in common exactly if their greatest common divisor
  // changes its sign on the interval.
  CGAL::Sign sign_of_value(const Integer_polynomial& other)
  {
    if (other.is_zero() || is_point())
      return other.sign_at(m_lower);
    bool is_compared = false;
    for (long step = 0; !is_point(); ++step) {
      const std::vector<Big_integer> values = bernstein_on_dyadic_hull(other);
      if (std::all_of(values.begin(), values.end(),
                      [&](const Big_integer& v) { return v.sign() * values.front().sign() > 0; }))
        return sign_of(values.front());
      if (!is_compared && vanishes_with(other))
        return CGAL::ZERO;
      is_compared = true;
      constexpr long few = 8;
      if (step < few)
        halve();
      else // the value may be very small
        narrow(width() * power_of_two(-(1L << (std::min)(step, 30L) / 2)));
    }
    return other.sign_at(m_lower);
  }

private:
  // Whether the root is in one part of 2^bits, or is an end of it, which becomes the interval. If not, parts without it
  // are cut off.
  bool keeps_part_at_secant(long bits)
  {
    const Exact_rational part = (m_upper - m_lower) * power_of_two(-bits);
    const auto value = [&](const Exact_rational& x) { // of a dyadic number
      const long bits_of_denominator = bit_length(denominator_of(x)) - 1;
      return scaled_rational(m_polynomial->numerator_at(x), -m_polynomial->degree() * bits_of_denominator);
    };
    const Exact_rational at_lower = value(m_lower), slope(at_lower - value(m_upper));
    if (slope == 0)
      return false;
    const Exact_rational position = at_lower / slope * power_of_two(bits);
    Big_integer index;
    mpz_fdiv_q(index.backend().data(), numerator_of(position).backend().data(),
               denominator_of(position).backend().data());
    const Exact_rational lower = m_lower + part * scaled_rational(index, 0), upper = lower + part;
    for (const Exact_rational& x : {lower, upper})
      if (m_lower < x && x < m_upper)
        cut(x);
    return m_upper - m_lower <= part;
  }

  // Of an interval that is hardly larger.
  std::vector<Big_integer> bernstein_on_dyadic_hull(const Integer_polynomial& polynomial) const
  {
    const Exact_rational room = width() / Exact_rational(8);
    return polynomial
        .bernstein(simple_dyadic_between(m_lower - room, m_lower), simple_dyadic_between(m_upper, m_upper + room))
        .values;
  }

  bool vanishes_with(const Integer_polynomial& other)
  {
    const Integer_polynomial divisor = common_divisor(*m_polynomial, other);
    if (divisor.degree() < 1)
      return false;
    // An end may be another root of both: move it inwards.
    while (!is_point() && (divisor.sign_at(m_lower) == CGAL::ZERO || divisor.sign_at(m_upper) == CGAL::ZERO)) {
      cut((m_lower * Exact_rational(3) + m_upper) / Exact_rational(4));
      if (!is_point())
        cut((m_lower + m_upper * Exact_rational(3)) / Exact_rational(4));
    }
    return is_point() ? other.sign_at(m_lower) == CGAL::ZERO : divisor.sign_at(m_lower) != divisor.sign_at(m_upper);
  }
};

/*
Isolates the roots of a polynomial without multiple roots between two dyadic points by Descartes' rule: the sign
variations of the Bernstein coefficients on an interval are at least the number of roots in its interior, and equal to
it where they are none or one (Collins, Akritas 1976; in Bernstein form Rouillier, Zimmermann 2004). The interval is
halved until they are. Calls `is_stopped()` for every interval, and `left_open(lower, upper)` for those that are left
when it says so.
*/
template <class Predicate, class Visitor>
std::vector<Exact_root> isolate_roots(const std::shared_ptr<const Integer_polynomial>& polynomial,
                                      const Exact_rational& lower, const Exact_rational& upper,
                                      const Predicate& is_stopped, const Visitor& left_open)
{
  struct Node
  {
    Exact_rational lower, upper;
    std::vector<Big_integer> values;
  };
  std::vector<Exact_root> roots;
  std::vector<Node> stack;
  stack.push_back({lower, upper, polynomial->bernstein(lower, upper).values});
  while (!stack.empty()) {
    Node right = std::move(stack.back());
    stack.pop_back();
    if (is_stopped()) {
      left_open(right.lower, right.upper);
      continue;
    }
    const int variations = sign_variations(right.values);
    if (variations == 0)
      continue;
    if (variations == 1) {
      const auto first =
          std::find_if(right.values.begin(), right.values.end(), [](const Big_integer& v) { return v != 0; });
      roots.emplace_back(polynomial, right.lower, right.upper, sign_of(*first));
      continue;
    }
    // De Casteljau's scheme with sums in the place of means: what was added up r times is 2^r times too large.
    const std::size_t d = right.values.size() - 1;
    const Exact_rational middle = (right.lower + right.upper) / Exact_rational(2);
    Node left{right.lower, middle, {right.values.front()}};
    shift_left(left.values[0], d);
    for (std::size_t r = 1; r <= d; ++r) {
      for (std::size_t k = 0; k + r <= d; ++k)
        right.values[k] += right.values[k + 1];
      left.values.push_back(right.values[0]);
      shift_left(left.values[r], d - r);
    }
    for (std::size_t k = 0; k <= d; ++k)
      shift_left(right.values[k], k);
    if (right.values[0] == 0)
      roots.emplace_back(middle);
    right.lower = middle;
    stack.push_back(std::move(right));
    stack.push_back(std::move(left));
  }
  return roots;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_EXACT_ROOT_H
