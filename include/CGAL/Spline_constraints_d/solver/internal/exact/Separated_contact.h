// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_SEPARATED_CONTACT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_SEPARATED_CONTACT_H

#include <CGAL/Spline_constraints_d/solver/internal/exact/Regular_pair.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Two surfaces f = g = 0 that touch along a curve p = q = 0 and have another one, r = s = 0, in common besides, as a cone
and a cylinder that touch along a line have. These identities of polynomials prove that both curves together are all
common zeros, and nothing else:

  f and g are combinations of p and q, and of r and s; of f and g, the squares of p r, p s, q r and q s are.

Let h be the factors of the product of the gradients, see Regular_pair, which vanish on both curves, to the first order.
Then p and q are among the polynomials c with c h = a f + b g, and r and s among f, g and the polynomials e with e c^2 =
a f + b g.

In a regular zero of p and q where r and s are not both zero, squares of p and q are combinations of f and g with
analytic factors. Where f is regular, g vanishes on f = 0 to the order m along the curve, so that m <= 2; and m >= 2 if
the determinant of the factors of p and q in f and g is itself a combination of p and q.
*/
class Separated_contact
{
  using Polynomials = std::array<Power_polynomial, 2>;
  using Zero = std::vector<std::pair<Exact_rational, Exact_rational>>;

  Polynomials m_given;
  std::array<Polynomials, 2> m_pairs;             // of the contact, and of the other curve
  std::array<Power_polynomial, 2> m_determinants;   // of the factors in f and g

public:
  // Nothing if none is found.
  static std::optional<Separated_contact> make(const Polynomials& fg)
  {
    const Polynomials given = Regular_pair::with_lower_degree(fg);
    for (int degree = 1; degree <= most_degree; ++degree)
      for (const Power_polynomial& h : Regular_pair::factors_of_gradients(given, degree))
        for (const Polynomials& contact : pairs_of(quotients(h, given)))
          if (std::optional<Separated_contact> result = with_contact(given, contact))
            return result;
    return std::nullopt;
  }

  const std::array<Polynomials, 2>& pairs() const { return m_pairs; }

  // How often the curve counts that a box has one regular zero of; 0 if this is not known.
  int multiplicity(std::size_t pair, const Zero& zero) const
  {
    const Mpfr_precision_scope precision(128);
    std::vector<Mpfr_interval> box;
    for (const auto& [lower, upper] : zero)
      box.emplace_back(lower, upper);
    const auto is_not_zero = [&](const Power_polynomial& f) {
      return CGAL::certainly(f.value(std::span<const Mpfr_interval>(box)).sign() != CGAL::ZERO);
    };
    const auto is_regular = [&](const Power_polynomial& f) {
      return is_not_zero(f.derivative(0)) || is_not_zero(f.derivative(1)) || is_not_zero(f.derivative(2));
    };
    if (is_not_zero(m_determinants[pair]))
      return 1;
    const bool is_on_one = is_not_zero(m_pairs[1 - pair][0]) || is_not_zero(m_pairs[1 - pair][1]);
    return pair == 0 && is_on_one && (is_regular(m_given[0]) || is_regular(m_given[1])) ? 2 : 0;
  }

private:
  static constexpr int most_degree = 2;   // of p, q, r, s and h

  Separated_contact(Polynomials given, std::array<Polynomials, 2> pairs)
    : m_given(std::move(given)), m_pairs(std::move(pairs))
  {}

  // The pairs of which only p and q are given.
  static std::optional<Separated_contact> with_contact(const Polynomials& given, const Polynomials& contact)
  {
    std::vector<Power_polynomial> others = quotients(pow(contact[0] + Power_polynomial(3) * contact[1], 2), given);
    others.insert(others.end(), given.begin(), given.end());
    for (const Polynomials& other : pairs_of(others))
      if (Separated_contact result(given, {contact, other}); result.has_same_zeros())
        return result;
    return std::nullopt;
  }

  static std::vector<Polynomials> pairs_of(const std::vector<Power_polynomial>& polynomials)
  {
    std::vector<Polynomials> result;
    for (std::size_t j = 1; j < polynomials.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        result.push_back({polynomials[i], polynomials[j]});
    return result;
  }

  // The polynomials c with c h = a f + b g, of the least degrees first, that are no combinations of f and g alone.
  static std::vector<Power_polynomial> quotients(const Power_polynomial& h, const Polynomials& fg)
  {
    std::vector<Power_polynomial> result;
    for (int degree = 1; degree <= most_degree; ++degree) {
      const int all = degree + h.total_degree();
      for (const auto& relation :
           polynomial_relations({h, fg[0], fg[1]}, {degree, all - fg[0].total_degree(), all - fg[1].total_degree()}))
        if (relation[0].total_degree() == degree &&
            !combination(relation[0], fg, (std::max)({degree, fg[0].total_degree(), fg[1].total_degree()})))
          result.push_back(relation[0]);
      if (result.size() > 1)
        break;
    }
    return result;
  }

  // Whether the identities are true.
  bool has_same_zeros()
  {
    for (const std::size_t pair : {0, 1}) {
      const int degree = (std::max)({m_given[0].total_degree(), m_given[1].total_degree(),
                                     m_pairs[pair][0].total_degree(), m_pairs[pair][1].total_degree()});
      const auto f = combination(m_given[0], m_pairs[pair], degree), g = combination(m_given[1], m_pairs[pair], degree);
      if (!f || !g)
        return false;
      m_determinants[pair] = (*f)[0] * (*g)[1] - (*f)[1] * (*g)[0];
    }
    const auto is_combination = [](const Power_polynomial& f, const Polynomials& pair) {
      return combination(f, pair, (std::max)({f.total_degree(), pair[0].total_degree(), pair[1].total_degree()}))
          .has_value();
    };
    if (!is_combination(m_determinants[0], m_pairs[0]))
      return false;
    for (const Power_polynomial& contact : m_pairs[0])
      for (const Power_polynomial& other : m_pairs[1])
        if (!is_combination(contact * other, m_given) && !is_combination(pow(contact * other, 2), m_given))
          return false;
    return true;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_SEPARATED_CONTACT_H
