// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_FACTORS_IN_SEVERAL_UNKNOWNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_FACTORS_IN_SEVERAL_UNKNOWNS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/rational_factors.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Polynomials in one unknown by their coefficients, the constant first; the last one is not zero.
using Coefficient_row = std::vector<Exact_rational>;

inline void drop_zeros(Coefficient_row& f)
{
  while (!f.empty() && CGAL::is_zero(f.back()))
    f.pop_back();
}

inline void subtract_product(Coefficient_row& f, const Coefficient_row& a, const Coefficient_row& b)
{
  if (a.empty() || b.empty())
    return;
  if (f.size() < a.size() + b.size() - 1)
    f.resize(a.size() + b.size() - 1, Exact_rational(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t k = 0; k < b.size(); ++k)
      f[i + k] -= a[i] * b[k];
  drop_zeros(f);
}

inline Coefficient_row product_of_rows(const Coefficient_row& a, const Coefficient_row& b)
{
  Coefficient_row result;
  subtract_product(result, a, b);
  for (Exact_rational& x : result)
    x = -x;
  return result;
}

// The quotient; `f` becomes the rest.
inline Coefficient_row divide_row(Coefficient_row& f, const Coefficient_row& divisor)
{
  Coefficient_row result(f.size() >= divisor.size() ? f.size() - divisor.size() + 1 : 0, Exact_rational(0));
  for (std::size_t k = result.size(); k-- > 0;) {
    result[k] = f[k + divisor.size() - 1] / divisor.back();
    for (std::size_t i = 0; i < divisor.size(); ++i)
      f[k + i] -= result[k] * divisor[i];
  }
  drop_zeros(f);
  return result;
}

// The inverse of f modulo another polynomial without a common factor.
inline Coefficient_row inverse_modulo(Coefficient_row f, const Coefficient_row& modulus)
{
  Coefficient_row other = modulus, own_factor{Exact_rational(1)}, other_factor;
  divide_row(f, modulus);
  while (f.size() > 1) {
    const Coefficient_row quotient = divide_row(other, f);
    subtract_product(other_factor, quotient, own_factor);
    std::swap(f, other);
    std::swap(own_factor, other_factor);
  }
  for (Exact_rational& x : own_factor)
    x /= f[0];
  divide_row(own_factor, modulus);
  return own_factor;
}

/*
A polynomial f(x, y) of total degree d in x and other unknowns y, monic in x of the same degree, with f(x, 0) = u v
where u and v have no common factor: the factors of f that continue these, if f has such. By Hensel's lemma u and v
continue in just one way as power series in y, whose terms of degree k are found one after the other. Those of factors
end, as their total degree is that in x.
*/
class Lifted_factors
{
  using Terms = std::map<Monomial, Coefficient_row>; // by the monomial in y
  std::vector<Terms> m_all, m_first, m_second;       // by the degree in y

public:
  Lifted_factors(const Power_polynomial& f, int x)
  {
    m_all.resize(static_cast<std::size_t>(f.total_degree()) + 1);
    for (const auto& [monomial, coefficient] : f.terms()) {
      const auto power = static_cast<std::size_t>(monomial.exponent(x));
      const Monomial rest = monomial.with_exponent(x, 0);
      Coefficient_row& row = m_all[static_cast<std::size_t>(rest.total_degree())][rest];
      if (row.size() <= power)
        row.resize(power + 1, Exact_rational(0));
      row[power] = coefficient;
    }
  }

  // Whether f has these factors.
  bool operator()(const Coefficient_row& u, const Coefficient_row& v)
  {
    const Coefficient_row inverse = inverse_modulo(v, u);
    m_first.assign(1, {{Monomial(), u}});
    m_second.assign(1, {{Monomial(), v}});
    for (std::size_t k = 1; k < m_all.size(); ++k) {
      Terms error = m_all[k], first, second;
      for (std::size_t i = 1; i < k; ++i)
        subtract(error, m_first[i], m_second[k - i]);
      for (auto& [monomial, row] : error) {
        drop_zeros(row);
        Coefficient_row own = product_of_rows(row, inverse);
        divide_row(own, u);
        subtract_product(row, own, v);
        Coefficient_row other = divide_row(row, u);
        if (!row.empty() || is_too_long(own, u, k) || is_too_long(other, v, k))
          return false;
        first.emplace(monomial, std::move(own));
        second.emplace(monomial, std::move(other));
      }
      m_first.push_back(std::move(first));
      m_second.push_back(std::move(second));
    }
    return true;
  }

  Power_polynomial first(int x) const { return polynomial(m_first, x); }
  Power_polynomial second(int x) const { return polynomial(m_second, x); }

private:
  // Whether a coefficient of degree k in y is none of a factor that begins with `first`.
  static bool is_too_long(const Coefficient_row& row, const Coefficient_row& first, std::size_t k)
  {
    return !row.empty() && row.size() + k > first.size();
  }

  static void subtract(Terms& result, const Terms& a, const Terms& b)
  {
    for (const auto& [m, row] : a)
      for (const auto& [n, other] : b) {
        Monomial product = m;
        for (const auto& [unknown, power] : n.powers)
          product = product.with_exponent(unknown, product.exponent(unknown) + power);
        subtract_product(result[product], row, other);
      }
  }

  static Power_polynomial polynomial(const std::vector<Terms>& terms, int x)
  {
    Power_polynomial result;
    for (const Terms& of_degree : terms)
      for (const auto& [monomial, row] : of_degree) {
        Power_polynomial others(Exact_rational(1)), sum;
        for (const auto& [unknown, power] : monomial.powers)
          others *= pow(Power_polynomial::variable(unknown), power);
        for (std::size_t k = row.size(); k-- > 0;)
          sum = sum * Power_polynomial::variable(x) + Power_polynomial(row[k]);
        result += sum * others;
      }
    return result;
  }
};

/*
The irreducible factors over the rational numbers of a polynomial without repeated ones. It is restricted to a line
that its part of highest degree is not zero along, and that it has no double zeros on; groups of the factors there are
continued. Most irreducible polynomials are irreducible on most lines (Hilbert), so that there is one group only.
*/
class Factors_in_several_unknowns
{
  std::vector<int> m_others;
  std::vector<Exact_rational> m_slopes, m_shifts; // of the line, for the others
  int m_unknown;

public:
  std::vector<Power_polynomial> operator()(const Power_polynomial& f)
  {
    m_others = f.variables();
    if (m_others.empty())
      return {};
    m_unknown = m_others.front();
    m_others.erase(m_others.begin());
    constexpr int most_lines = 20;
    for (int line = 0; line < most_lines; ++line)
      if (const auto factors = factors_by_line(f, line))
        return *factors;
    return {f};
  }

private:
  std::optional<std::vector<Power_polynomial>> factors_by_line(const Power_polynomial& f, int line)
  {
    m_slopes.clear();
    m_shifts.clear();
    for (std::size_t j = 0; j < m_others.size(); ++j) {
      const int k = static_cast<int>(j) + 1;
      m_slopes.emplace_back((line * (2 * k + 1) + k) % 7 - 3);
      m_shifts.emplace_back((line * (3 * k + 2) + 2 * k) % 11 - 5);
    }
    const Power_polynomial univariate = restricted_to_line(f);
    if (univariate.total_degree() < f.total_degree())
      return std::nullopt;
    std::vector<Coefficient_row> factors;
    for (const Rational_factors::Factor& factor : rational_factors(univariate).factors) {
      if (factor.multiplicity > 1)
        return std::nullopt;
      factors.push_back(monic_row(factor.polynomial));
    }
    constexpr std::size_t most_factors = 12;
    if (factors.size() == 1 || factors.size() > most_factors)
      return std::vector{f};
    Power_polynomial rest = moved(f, false);
    Exact_rational highest(0);
    for (const auto& [monomial, coefficient] : rest.terms())
      if (monomial.exponent(m_unknown) == f.total_degree())
        highest = coefficient;
    rest *= Power_polynomial(Exact_rational(1 / highest));
    std::vector<Power_polynomial> result;
    for (std::size_t size = 1; 2 * size <= factors.size();)
      if (!split_off(rest, factors, size, result))
        ++size;
    result.push_back(moved(rest, true));
    return result;
  }

  // Finds a factor that continues a group of so many.
  bool split_off(Power_polynomial& rest, std::vector<Coefficient_row>& factors, std::size_t size,
                 std::vector<Power_polynomial>& result) const
  {
    Lifted_factors lifted(rest, m_unknown);
    std::vector<bool> is_chosen(factors.size(), false);
    std::fill_n(is_chosen.begin(), size, true);
    do {
      Coefficient_row own{Exact_rational(1)}, others{Exact_rational(1)};
      for (std::size_t i = 0; i < factors.size(); ++i) {
        Coefficient_row& product = is_chosen[i] ? own : others;
        product = product_of_rows(product, factors[i]);
      }
      if (!lifted(own, others))
        continue;
      result.push_back(moved(lifted.first(m_unknown), true));
      rest = lifted.second(m_unknown);
      std::size_t i = 0;
      std::erase_if(factors, [&](const Coefficient_row&) { return is_chosen[i++]; });
      return true;
    } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
    return false;
  }

  // The line becomes an axis, or the axis the line again.
  Power_polynomial moved(Power_polynomial f, bool is_back) const
  {
    for (std::size_t j = 0; j < m_others.size(); ++j) {
      const Power_polynomial own = Power_polynomial::variable(m_others[j]);
      f = f.substituted(m_others[j], is_back ? own - on_line(j) : own + on_line(j));
    }
    return f;
  }

  Power_polynomial restricted_to_line(Power_polynomial f) const
  {
    for (std::size_t j = 0; j < m_others.size(); ++j)
      f = f.substituted(m_others[j], on_line(j));
    return f;
  }

  // Another unknown.
  Power_polynomial on_line(std::size_t j) const
  {
    return Power_polynomial::variable(m_unknown) * Power_polynomial(m_slopes[j]) + Power_polynomial(m_shifts[j]);
  }

  Coefficient_row monic_row(const Power_polynomial& f) const
  {
    Coefficient_row result(static_cast<std::size_t>(f.total_degree()) + 1, Exact_rational(0));
    for (const auto& [monomial, coefficient] : f.terms())
      result[static_cast<std::size_t>(monomial.exponent(m_unknown))] = coefficient;
    const Exact_rational highest = result.back();
    for (Exact_rational& x : result)
      x /= highest;
    return result;
  }
};

// The different irreducible factors of a polynomial, each once, with 1 as the coefficient of the last monomial.
inline std::vector<Power_polynomial> different_factors(const Power_polynomial& f)
{
  std::vector<Power_polynomial> result;
  for (const Power_polynomial& power : square_free_factors(f))
    if (!power.is_constant())
      for (const Power_polynomial& factor : Factors_in_several_unknowns()(power))
        result.push_back(factor * Power_polynomial(Exact_rational(1 / factor.terms().rbegin()->second)));
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_FACTORS_IN_SEVERAL_UNKNOWNS_H
