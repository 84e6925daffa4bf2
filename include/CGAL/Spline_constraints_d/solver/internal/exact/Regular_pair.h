// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_REGULAR_PAIR_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_REGULAR_PAIR_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Echelon_form.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_rows.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The monomials of three unknowns up to a degree.
inline std::vector<Power_polynomial> monomials_in_space(int degree)
{
  const auto power = [](int unknown, int exponent) { return pow(Power_polynomial::variable(unknown), exponent); };
  std::vector<Power_polynomial> result;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; i + j <= degree; ++j)
      for (int k = 0; i + j + k <= degree; ++k)
        result.push_back(power(0, i) * power(1, j) * power(2, k));
  return result;
}

// A monomial times one of some polynomials.
struct Polynomial_multiple
{
  std::size_t index;   // of the polynomial
  Power_polynomial multiplier, product;
};

// Whether a multiple of the first polynomial seems to be a sum of others and of the last ones, modulo a prime: this
// takes no time, and serves to save work only.
inline bool seem_to_be_dependent(const std::vector<Polynomial_multiple>& multiples,
                                 const std::map<Monomial, std::size_t>& place)
{
  Prime_field_rows rows;
  for (auto multiple = multiples.rbegin(); multiple != multiples.rend(); ++multiple) {
    std::vector<Prime_field_polynomial::Number> row(place.size(), 0);
    for (const auto& [monomial, coefficient] : multiple->product.terms())
      row[place.at(monomial)] = Prime_field_polynomial::residue(coefficient);
    if (!rows.add(std::move(row)) && multiple->index == 0)
      return true;
  }
  return false;
}

/*
The polynomials c_i with c_0 f_0 + c_1 f_1 + ... = 0, up to some degrees: a basis, by linear algebra in their
coefficients, in echelon form. If c_0 has the degree zero and is not zero in one of them, it is so in the first, where
it is 1. None if these are more than `most` coefficients, or c_0 seems to be zero in all of them.
*/
inline std::vector<std::vector<Power_polynomial>>
polynomial_relations(const std::vector<Power_polynomial>& f, const std::vector<int>& degrees, std::size_t most = 130)
{
  std::vector<Polynomial_multiple> products;
  std::map<Monomial, std::size_t> place;
  for (std::size_t i = 0; i < f.size(); ++i)
    for (const Power_polynomial& monomial : monomials_in_space(degrees[i])) {
      products.push_back({i, monomial, monomial * f[i]});
      for (const auto& [own, coefficient] : products.back().product.terms())
        place.try_emplace(own, place.size());
    }
  if (products.size() > most || !seem_to_be_dependent(products, place))
    return {};
  Echelon_form rows;   // each has the coefficients of a sum, and behind them those of the monomials that it is made of
  for (std::size_t k = 0; k < products.size(); ++k) {
    std::vector<Exact_rational> row(place.size() + products.size(), Exact_rational(0));
    for (const auto& [own, coefficient] : products[k].product.terms())
      row[place.at(own)] = coefficient;
    row[place.size() + k] = 1;
    rows.add(std::move(row));
  }
  std::map<std::size_t, std::vector<Power_polynomial>> result;   // by the place of the one
  for (const auto& [one, row] : rows.rows())
    if (one >= place.size()) {
      std::vector<Power_polynomial>& sum = result.try_emplace(one, f.size()).first->second;
      for (std::size_t k = 0; k < products.size(); ++k)
        sum[products[k].index] += Power_polynomial(row[place.size() + k]) * products[k].multiplier;
    }
  std::vector<std::vector<Power_polynomial>> relations;
  for (auto& [one, sum] : result)
    relations.push_back(std::move(sum));
  return relations;
}

// Polynomials a and b with c = a f + b g, where all products have a degree at most.
inline std::optional<std::array<Power_polynomial, 2>> combination(const Power_polynomial& c,
                                                                  const std::array<Power_polynomial, 2>& fg, int degree)
{
  const auto relations =
      polynomial_relations({c, fg[0], fg[1]}, {0, degree - fg[0].total_degree(), degree - fg[1].total_degree()});
  if (relations.empty() || relations.front()[0].is_zero())
    return std::nullopt;
  return std::array{-relations.front()[1], -relations.front()[2]};
}

/*
Two surfaces f = g = 0 may touch along a curve, where their gradients are parallel. This is a pair of polynomials p and
q with the same common zeros, which are regular there:

  f = a_00 p + a_01 q, g = a_10 p + a_11 q, and p^k = b_00 f + b_01 g, q^k = b_10 f + b_11 g, as polynomials.

They are looked for among f, g and the polynomials h with h <w, grad f x grad g> = a f + b g, for a vector w. On a curve
that counts m times in f = g = 0 the gradients' product vanishes to the order m - 1, so that h vanishes to the first
order, and on all other curves as well.

In a regular zero of p and q, f and g are regular if det(a_ij) is not zero: m = 1. Otherwise let f be regular there. On
the surface f = 0, g vanishes to the order m along the curve, and p or q to the first order: so m <= k; and m is a
multiple of k, if b_01 or b_11 is not zero. As both pairs have the same complex zeros, m is the same all along a curve
of regular zeros.
*/
class Regular_pair
{
  using Polynomials = std::array<Power_polynomial, 2>;

  Polynomials m_given, m_regular;
  Power_polynomial m_determinant;
  int m_exponent = 1;
  std::array<Polynomials, 2> m_cofactors;   // of p^k and of q^k

public:
  // Nothing if none is found. If all common zeros are regular, this is known at once.
  static std::optional<Regular_pair> make(const Polynomials& fg)
  {
    if (!seem_to_touch_along_curves(fg))
      return std::nullopt;
    const Polynomials given = with_lower_degree(fg);
    const int most = (std::max)(given[0].total_degree(), given[1].total_degree());
    for (int degree = 1; degree < most; ++degree) {
      std::vector<Power_polynomial> candidates{given[0], given[1]};
      for (Power_polynomial& h : factors_of_gradients(given, degree))
        candidates.push_back(std::move(h));
      for (std::size_t j = 2; j < candidates.size(); ++j)
        for (std::size_t i = 0; i < j; ++i)
          if (Regular_pair result(given, {candidates[i], candidates[j]}); result.has_same_zeros())
            return result;
    }
    return std::nullopt;
  }

  const Polynomials& polynomials() const { return m_regular; }

  // How often the curve counts that a box has one regular zero of; 0 if this is not known.
  int multiplicity(const std::vector<std::pair<Exact_rational, Exact_rational>>& zero) const
  {
    const Mpfr_precision_scope precision(128);
    std::vector<Mpfr_interval> box;
    for (const auto& [lower, upper] : zero)
      box.emplace_back(lower, upper);
    const auto is_not_zero = [&](const Power_polynomial& f) {
      return CGAL::certainly(f.value(std::span<const Mpfr_interval>(box)).sign() != CGAL::ZERO);
    };
    if (is_not_zero(m_determinant))
      return 1;
    for (const int i : {0, 1}) {
      const auto is_regular = [&](int unknown) { return is_not_zero(m_given[i].derivative(unknown)); };
      const auto has_cofactor = [&](int k) { return is_not_zero(m_cofactors[k][1 - i]); };
      if ((is_regular(0) || is_regular(1) || is_regular(2)) && (has_cofactor(0) || has_cofactor(1)))
        return m_exponent;
    }
    return 0;
  }

  // The same pair, or with the difference of multiples in the place of one, where the terms of the highest degree are
  // multiples of each other.
  static Polynomials with_lower_degree(const Polynomials& fg)
  {
    const int degree = fg[0].total_degree();
    const auto is_leading = [&](const auto& term) { return term.first.total_degree() == degree; };
    const auto term = std::find_if(fg[0].terms().begin(), fg[0].terms().end(), is_leading);
    const auto other = fg[1].terms().find(term->first);
    if (fg[1].total_degree() != degree || other == fg[1].terms().end())
      return fg;
    const Power_polynomial difference = fg[1] - Power_polynomial(Exact_rational(other->second / term->second)) * fg[0];
    return difference.is_constant() || difference.total_degree() == degree ? fg : Polynomials{fg[0], difference};
  }

  // The polynomials h of a degree that are no combinations of f and g.
  static std::vector<Power_polynomial> factors_of_gradients(const Polynomials& fg, int degree)
  {
    const std::array<int, 3> w{1, 3, -2};
    Power_polynomial product;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      product += Power_polynomial(w[i]) *
          (fg[0].derivative(j) * fg[1].derivative(k) - fg[0].derivative(k) * fg[1].derivative(j));
    }
    const int f = fg[0].total_degree(), g = fg[1].total_degree(), all = degree + f + g - 2;
    std::vector<Power_polynomial> result;
    if (!product.is_zero())
      for (const auto& relation : polynomial_relations({product, fg[0], fg[1]}, {degree, all - f, all - g}))
        if (!relation[0].is_zero() && !combination(relation[0], fg, (std::max)({degree, f, g})))
          result.push_back(relation[0]);
    return result;
  }

private:
  Regular_pair(Polynomials given, Polynomials regular) : m_given(std::move(given)), m_regular(std::move(regular)) {}

  // Whether the equations above are true for some k.
  bool has_same_zeros()
  {
    const int given = (std::max)(m_given[0].total_degree(), m_given[1].total_degree()),
              regular = (std::max)(m_regular[0].total_degree(), m_regular[1].total_degree());
    const auto f = combination(m_given[0], m_regular, (std::max)(given, regular)),
               g = combination(m_given[1], m_regular, (std::max)(given, regular));
    if (!f || !g)
      return false;
    m_determinant = (*f)[0] * (*g)[1] - (*f)[1] * (*g)[0];
    constexpr int most = 4;
    for (m_exponent = 2; m_exponent <= most; ++m_exponent) {
      bool is_combination = true;
      for (const int i : {0, 1})
        if (const auto cofactors = is_combination
                ? combination(pow(m_regular[i], m_exponent), m_given,
                              (std::max)(given, m_exponent * m_regular[i].total_degree()))
                : std::nullopt)
          m_cofactors[i] = *cofactors;
        else
          is_combination = false;
      if (is_combination)
        return true;
    }
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_REGULAR_PAIR_H
