// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_FINE_INTERVAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_FINE_INTERVAL_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Algebraic_structure_traits.h>

#include <mpfr.h>

#include <limits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

/*
Intervals for the level above doubles, where these cannot decide: of 128 bits, whatever the precision of the thread,
with the interface of CGAL's intervals. The ends are known as doubles, rounded outward: signs are those of the numbers,
as a double is 0 only if they are very small.
*/
class Fine_interval
{
  static constexpr mpfr_prec_t precision = 128;

  Mpfr_interval m_value;

  explicit Fine_interval(Mpfr_interval value) : m_value(std::move(value)) {}

public:
  Fine_interval() : Fine_interval(0.0) {}
  Fine_interval(double x) : Fine_interval(x, x) {}
  Fine_interval(int x) : Fine_interval(static_cast<double>(x)) {}
  Fine_interval(double lower, double upper)
    : m_value(holds_numbers(lower, upper) ? Mpfr_interval::of_ends(number(lower).get(), number(upper).get())
                                          : Mpfr_interval::entire_line(precision))
  {}
  Fine_interval(const Interval& x) : Fine_interval(x.inf(), x.sup()) {}
  explicit Fine_interval(const Exact_rational& x) : m_value(x, precision) {}

  double inf() const { return mpfr_get_d(m_value.lower_mpfr(), MPFR_RNDD); }
  double sup() const { return mpfr_get_d(m_value.upper_mpfr(), MPFR_RNDU); }

  Fine_interval& operator+=(const Fine_interval& other) { m_value += other.m_value; return *this; }
  Fine_interval& operator-=(const Fine_interval& other) { m_value -= other.m_value; return *this; }
  Fine_interval& operator*=(const Fine_interval& other) { m_value *= other.m_value; return *this; }
  Fine_interval& operator/=(const Fine_interval& other) { m_value /= other.m_value; return *this; }

  friend Fine_interval operator-(Fine_interval a) { a.m_value.negate(); return a; }
  friend Fine_interval operator+(Fine_interval a, const Fine_interval& b) { a += b; return a; }
  friend Fine_interval operator-(Fine_interval a, const Fine_interval& b) { a -= b; return a; }
  friend Fine_interval operator*(Fine_interval a, const Fine_interval& b) { a *= b; return a; }
  friend Fine_interval operator/(Fine_interval a, const Fine_interval& b) { a /= b; return a; }

  friend Fine_interval hull(const Fine_interval& a, const Fine_interval& b)
  {
    return of_ends(mpfr_lessequal_p(a.lower(), b.lower()) ? a.lower() : b.lower(),
                   mpfr_greaterequal_p(a.upper(), b.upper()) ? a.upper() : b.upper());
  }

  // Of enclosures of one number.
  friend Fine_interval common_part(const Fine_interval& a, const Fine_interval& b)
  {
    const mpfr_srcptr lower = mpfr_greaterequal_p(a.lower(), b.lower()) ? a.lower() : b.lower(),
                      upper = mpfr_lessequal_p(a.upper(), b.upper()) ? a.upper() : b.upper();
    return mpfr_lessequal_p(lower, upper) ? of_ends(lower, upper) : hull(a, b);
  }

  // Of the numbers that have one, if there are any.
  friend Fine_interval square_root(const Fine_interval& a)
  {
    Mpfr_number lower(precision), upper(precision);
    if (mpfr_sgn(a.lower()) > 0)
      mpfr_sqrt(lower.get(), a.lower(), MPFR_RNDD);
    if (mpfr_sgn(a.upper()) > 0)
      mpfr_sqrt(upper.get(), a.upper(), MPFR_RNDU);
    return of_ends(lower.get(), upper.get());
  }

  friend Fine_interval square(const Fine_interval& a)
  {
    Fine_interval result = a * a;
    return mpfr_sgn(result.lower()) < 0 ? of_ends(Mpfr_number(precision).get(), result.upper()) : result;
  }

private:
  mpfr_srcptr lower() const { return m_value.lower_mpfr(); }
  mpfr_srcptr upper() const { return m_value.upper_mpfr(); }

  static Fine_interval of_ends(mpfr_srcptr lower, mpfr_srcptr upper)
  {
    return Fine_interval(Mpfr_interval::of_ends(lower, upper));
  }

  static bool holds_numbers(double lower, double upper)
  {
    return lower <= upper && lower < std::numeric_limits<double>::infinity() &&
        upper > -std::numeric_limits<double>::infinity();
  }

  static Mpfr_number number(double x)
  {
    Mpfr_number result(precision);
    mpfr_set_d(result.get(), x, MPFR_RNDN);   // exact
    return result;
  }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints

template <>
class Algebraic_structure_traits<Spline_constraints::internal::Common::Fine_interval>
  : public Algebraic_structure_traits_base<Spline_constraints::internal::Common::Fine_interval, Field_with_sqrt_tag>
{
  using Number = Spline_constraints::internal::Common::Fine_interval;

public:
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  struct Square
  {
    using argument_type = Number;
    using result_type = Number;
    Number operator()(const Number& x) const { return square(x); }
  };

  struct Sqrt
  {
    using argument_type = Number;
    using result_type = Number;
    Number operator()(const Number& x) const { return square_root(x); }
  };
};

} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_FINE_INTERVAL_H
