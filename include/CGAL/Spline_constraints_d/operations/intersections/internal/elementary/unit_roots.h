// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_UNIT_ROOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_UNIT_ROOTS_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Coefficients of Bernstein polynomials over [0,1], enclosed. All that computes with them needs upward rounding.
using Bernstein_bounds = Scratch_vector<Interval>;

// A root that is the only one in its range, or twice one.
struct Unit_root
{
  Interval t;
  bool is_double = false;
};

inline Interval enclosure_of(const Interval& x) { return x; }
inline Interval enclosure_of(const Exact_rational& x) { return Interval(to_double_interval(x)); }

inline int known_sign(const Interval& x) { return certain_sign(x); }
inline int known_sign(const Exact_rational& x) { return static_cast<int>(CGAL::sign(x)); }

// Whether the sign is known: also where the enclosure is exact and zero.
inline bool is_certain(const Interval& x) { return known_sign(x) != 0 || x.is_same(Interval(0)); }

// Its value by de Casteljau's scheme.
inline Interval value_at(Bernstein_bounds f, const Interval& t)
{
  const Interval rest = Interval(1) - t;
  for (std::size_t size = f.size(); size-- > 1;)
    for (std::size_t i = 0; i < size; ++i)
      f[i] = rest * f[i] + t * f[i + 1];
  return f[0];
}

inline Bernstein_bounds derivative_of(const Bernstein_bounds& f)
{
  const Interval degree(static_cast<double>(f.size() - 1));
  Bernstein_bounds result;
  for (std::size_t i = 0; i + 1 < f.size(); ++i)
    result.push_back(degree * (f[i + 1] - f[i]));
  return result;
}

// Without a root at 0, where the first coefficient is zero, and without one at 1, where the last one is. Nothing is
// left where it has more roots than its degree.
template <class Number>
Scratch_vector<Number> without_roots_at_ends(Scratch_vector<Number> f, const std::array<bool, 2>& is_root)
{
  for (const std::size_t side : {0, 1}) {
    if (!is_root[side] || f.empty())
      continue;
    Scratch_vector<Number> quotient; // f / t, or f / (1 - t)
    const std::size_t degree = f.size() - 1;
    for (std::size_t i = 0; i < degree; ++i) {
      const std::size_t divisor = side == 0 ? i + 1 : degree - i;
      quotient.push_back(Number(f[i + 1 - side] * Number(static_cast<double>(degree)) /
                                Number(static_cast<double>(divisor))));
    }
    f = std::move(quotient);
  }
  return f;
}

/*
The roots in (0,1) of a quadratic polynomial whose first and last coefficients have signs. In x = t / (1 - t) it is f2
x^2 + 2 f1 x + f0, and with q = -f1 -+ sqrt(f1^2 - f0 f2), of the sign that lets nothing cancel, its roots are q / f2
and f0 / q. `exact()` returns the coefficients as rational numbers, which are asked for where the sign of the
discriminant is not certain.
*/
template <class Exact_coefficients>
Scratch_vector<Unit_root> roots_of_quadratic(Bernstein_bounds f, const Exact_coefficients& exact)
{
  Interval discriminant = CGAL::square(f[1]) - f[0] * f[2];
  int sign = known_sign(discriminant);
  if (!is_certain(discriminant)) {
    const Scratch_vector<Exact_rational> g = exact();
    const Exact_rational value(g[1] * g[1] - g[0] * g[2]);
    sign = known_sign(value);
    discriminant = enclosure_of(value);
    std::transform(g.begin(), g.end(), f.begin(), [](const Exact_rational& x) { return enclosure_of(x); });
  }
  const int first = known_sign(f[0]), middle = known_sign(f[1]), last = known_sign(f[2]);
  if (sign < 0 || (first == last && middle != -first))
    return {};
  if (sign == 0)
    return {{f[1] / (f[1] - f[2]), true}};
  const Interval root = CGAL::sqrt(discriminant), q = middle > 0 ? -f[1] - root : -f[1] + root;
  const Unit_root one{q / (q + f[2])}, other{f[0] / (f[0] + q)};
  if (first == last)
    return {one, other};
  // they have different signs in x; that of q is the one that is opposite to f1, or positive
  const int sign_of_q = middle > 0 ? -1 : 1;
  return {sign_of_q == last ? one : other};
}

// Isolates roots by the variation of signs on parts of parts, and narrows them by Newton's method in intervals.
class Root_isolation
{
  static constexpr int most_parts = 400;

  Scratch_vector<Unit_root> m_roots;
  int m_parts = 0;

public:
  // The roots in (0,1); nothing where one is not proved to be a simple one. \pre the first and the last coefficient
  // have signs
  std::optional<Scratch_vector<Unit_root>> operator()(const Bernstein_bounds& f)
  {
    if (!isolate(f, Interval(0), Interval(1)))
      return std::nullopt;
    return std::move(m_roots);
  }

private:
  bool isolate(const Bernstein_bounds& f, const Interval& begin, const Interval& width)
  {
    if (++m_parts > most_parts)
      return false;
    const auto [least, most] = numbers_of_variations(f);
    if (most == 0)
      return true;
    if (least == 1 && most == 1) {
      const std::optional<Interval> root = only_root(f);
      if (root)
        m_roots.push_back({begin + width * *root});
      return root.has_value();
    }
    for (const double part : {0.5, 0.4375}) {   // a root may be at one of them
      const auto [left, right] = halves(f, part);
      if (known_sign(left.back()) != 0)
        return isolate(left, begin, width * Interval(part)) &&
            isolate(right, begin + width * Interval(part), width * Interval(1 - part));
    }
    return false;
  }

  // By de Casteljau's scheme.
  static std::array<Bernstein_bounds, 2> halves(const Bernstein_bounds& f, double part)
  {
    const Interval t(part), rest(1 - part);
    Bernstein_bounds left, right(f);
    for (std::size_t size = f.size(); size > 0; --size) {
      left.push_back(right[0]);
      for (std::size_t i = 0; i + 1 < size; ++i)
        right[i] = rest * right[i] + t * right[i + 1];
    }
    return {left, right};
  }

  // Of the signs that are certain, and with the others as they may be.
  static std::pair<int, int> numbers_of_variations(const Bernstein_bounds& f)
  {
    int least = 0, uncertain = 0, last = known_sign(f[0]);
    for (const Interval& x : f) {
      const int sign = known_sign(x);
      if (sign == 0)
        ++uncertain;
      else if (sign != last) {
        ++least;
        last = sign;
      }
    }
    // one that lies between two of the same sign may add two, between two others none
    int most = least, before = known_sign(f[0]);
    for (std::size_t i = 1; uncertain > 0 && i < f.size(); ++i) {
      if (known_sign(f[i]) != 0) {
        before = known_sign(f[i]);
        continue;
      }
      std::size_t next = i;
      while (known_sign(f[next]) == 0)
        ++next;
      const int run = static_cast<int>(next - i);
      most += known_sign(f[next]) == before ? 2 * ((run + 1) / 2) : 2 * (run / 2);
      i = next;
      before = known_sign(f[next]);
    }
    return {least, most};
  }

  // The root of a polynomial whose coefficients change their sign once, in a narrow range, if that is found.
  static std::optional<Interval> only_root(const Bernstein_bounds& f)
  {
    constexpr double narrow = 1e-10;
    const Bernstein_bounds slope = derivative_of(f);
    Interval t(0, 1);
    for (;;) {
      const Interval derivative = value_at(slope, t);
      Interval next = t;
      for (const double part : {0.5, 0.4375}) {   // the root may be at one of them
        const double middle = t.inf() + (t.sup() - t.inf()) * part;
        const Interval value = value_at(f, Interval(middle));
        if (value.is_same(Interval(0)))
          return Interval(middle);
        if (const int sign = known_sign(value); sign != 0)
          next = common_part(next, sign == known_sign(f[0]) ? Interval(middle, t.sup()) : Interval(t.inf(), middle));
        if (known_sign(derivative) != 0)
          next = common_part(next, Interval(middle) - value / derivative);
        if (next.sup() - next.inf() < 0.75 * (t.sup() - t.inf()))
          break;
      }
      if (!(next.sup() - next.inf() < 0.75 * (t.sup() - t.inf())))
        return next.sup() - next.inf() < narrow ? std::optional(next) : std::nullopt;
      t = next;
    }
  }
};

// The roots in (0,1), as above.
template <class Exact_coefficients>
std::optional<Scratch_vector<Unit_root>> unit_roots(const Bernstein_bounds& f, const Exact_coefficients& exact)
{
  if (f.size() == 1)
    return Scratch_vector<Unit_root>();
  if (f.size() == 2)
    return known_sign(f[0]) == known_sign(f[1]) ? Scratch_vector<Unit_root>()
                                                : Scratch_vector<Unit_root>{{f[0] / (f[0] - f[1])}};
  if (f.size() == 3)
    return roots_of_quadratic(f, exact);
  return Root_isolation()(f);
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_UNIT_ROOTS_H
