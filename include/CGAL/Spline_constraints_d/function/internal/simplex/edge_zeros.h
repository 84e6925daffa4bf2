// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_EDGE_ZEROS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_EDGE_ZEROS_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Zeros do not count.
inline int number_of_sign_changes(const std::vector<CGAL::Sign>& signs)
{
  int result = 0;
  CGAL::Sign last = CGAL::ZERO;
  for (const CGAL::Sign sign : signs) {
    if (sign * last < 0)
      ++result;
    if (sign != CGAL::ZERO)
      last = sign;
  }
  return result;
}

// Polynomials in one parameter by powers, the highest one last and not zero; empty for zero.
template <class NT>
using Power_coefficients = std::vector<NT>;

template <class NT>
void drop_leading_zeros(Power_coefficients<NT>& f)
{
  while (!f.empty() && CGAL::is_zero(f.back()))
    f.pop_back();
}

// The remainder, or with `quotient` that too.
template <class NT>
Power_coefficients<NT> remainder(Power_coefficients<NT> f, const Power_coefficients<NT>& g,
                                 Power_coefficients<NT>* quotient = nullptr)
{
  if (quotient != nullptr)
    quotient->assign(f.size() < g.size() ? 0 : f.size() - g.size() + 1, NT(0));
  while (f.size() >= g.size()) {
    const NT factor = f.back() / g.back();
    const std::size_t shift = f.size() - g.size();
    if (quotient != nullptr)
      (*quotient)[shift] = factor;
    for (std::size_t i = 0; i < g.size(); ++i)
      f[shift + i] -= NT(factor * g[i]);
    f.pop_back();
    drop_leading_zeros(f);
  }
  return f;
}

template <class NT>
Power_coefficients<NT> derivative(const Power_coefficients<NT>& f)
{
  Power_coefficients<NT> result;
  for (std::size_t i = 1; i < f.size(); ++i)
    result.push_back(NT(static_cast<int>(i)) * f[i]);
  return result;
}

template <class NT>
NT value_at_one(const Power_coefficients<NT>& f)
{
  NT result(0);
  for (const NT& x : f)
    result += x;
  return result;
}

// Sturm's sequence of a polynomial that is not zero; the last one divides all.
template <class NT>
std::vector<Power_coefficients<NT>> sturm_sequence(const Power_coefficients<NT>& f)
{
  std::vector<Power_coefficients<NT>> result{f};
  for (Power_coefficients<NT> next = derivative(f); !next.empty();) {
    result.push_back(next);
    next = remainder(result[result.size() - 2], result.back());
    for (NT& x : next)
      x = -x;
  }
  return result;
}

// Different zeros between 0 and 1. \pre There is none at either.
template <class NT>
int number_of_zeros_by_sturm(const Power_coefficients<NT>& f)
{
  std::vector<CGAL::Sign> at_zero, at_one;
  for (const Power_coefficients<NT>& g : sturm_sequence(f)) {
    at_zero.push_back(CGAL::sign(g.front()));
    at_one.push_back(CGAL::sign(value_at_one(g)));
  }
  return number_of_sign_changes(at_zero) - number_of_sign_changes(at_one);
}

// Of Bernstein coefficients on [0,1].
template <class NT>
Power_coefficients<NT> power_coefficients(const std::vector<NT>& bernstein)
{
  const int degree = static_cast<int>(bernstein.size()) - 1;
  const Row_matrix<NT> matrix = to_power_matrix<NT>(degree);
  Power_coefficients<NT> f;
  for (int i = 0; i <= degree; ++i) {
    NT& x = f.emplace_back(0);
    for (int k = 0; k <= i; ++k)
      x += NT(matrix(i, k) * bernstein[k]);
  }
  drop_leading_zeros(f);
  return f;
}

// Of those that are not all 0, without the zeros at the ends.
template <class NT>
Power_coefficients<NT> without_zeros_at_ends(const std::vector<NT>& bernstein)
{
  Power_coefficients<NT> f = power_coefficients(bernstein);
  while (CGAL::is_zero(f.front()))
    f.erase(f.begin());
  while (CGAL::is_zero(value_at_one(f))) {
    Power_coefficients<NT> quotient;
    remainder(f, Power_coefficients<NT>{NT(-1), NT(1)}, &quotient);
    f = std::move(quotient);
  }
  return f;
}

// The number of sign changes of the Bernstein coefficients where it tells how many zeros there are, all simple; -1
// otherwise.
template <class NT>
int number_told_by_coefficients(const std::vector<NT>& bernstein)
{
  std::vector<CGAL::Sign> signs;
  for (const NT& x : bernstein)
    signs.push_back(CGAL::sign(x));
  const int changes = number_of_sign_changes(signs);
  return changes <= 1 ? changes : -1;
}

template <class NT>
bool is_zero_polynomial(const std::vector<NT>& coefficients)
{
  for (const NT& x : coefficients)
    if (!CGAL::is_zero(x))
      return false;
  return true;
}

// Different zeros between the ends; -1 for the zero polynomial.
template <class NT>
int number_of_zeros_within(const std::vector<NT>& bernstein)
{
  if (is_zero_polynomial(bernstein))
    return -1;
  const int told = number_told_by_coefficients(bernstein);
  return told >= 0 ? told : number_of_zeros_by_sturm(without_zeros_at_ends(bernstein));
}

// Those with a change of sign: the zeros of odd multiplicity. The common divisor of a polynomial and its derivative has
// all zeros with one multiplicity less. With Z(m) for the number of zeros of multiplicity m at least, the answer is
// Z(1) - Z(2) + Z(3) - ...
template <class NT>
int number_of_crossings_within(const std::vector<NT>& bernstein)
{
  if (is_zero_polynomial(bernstein))
    return 0;
  const int told = number_told_by_coefficients(bernstein);
  if (told >= 0)
    return told;
  int result = 0, sign = 1;
  for (Power_coefficients<NT> f = without_zeros_at_ends(bernstein); f.size() > 1; sign = -sign) {
    result += sign * number_of_zeros_by_sturm(f);
    f = sturm_sequence(f).back();
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_EDGE_ZEROS_H
