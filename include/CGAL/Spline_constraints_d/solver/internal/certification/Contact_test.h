// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_CONTACT_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_CONTACT_TEST_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The order of contact of the equalities at a rational solution p whose Jacobian has rank n - 1, and a proof that the
solution is alone in a box.

With g = T f of the elimination, s and w as in `Double_root_test`, the power series w = W(s) that solves the first n - 1
rows is found term by term; each is substituted, w = W(s) + w', until the last row has a term c_k s^k: then k is the
multiplicity of p. Now, in the first rows, terms in s alone have order k and more, and in the last row no w' stands
alone. Where all rows are zero and |s| <= S, |w'| <= W':
1. |w'| <= C |s|^k + M |w'|, with C from the terms in s alone and M from all others; so |w'| <= kappa |s|^k for any
  kappa with C + M kappa < kappa, by considering the largest ratio.
2. The last row is c_k s^k up to rho |s|^k, with kappa for one factor w' of the mixed terms. If |c_k| > rho then s = 0,
  and w' = 0 by 1. The bounds are sums of products of positive doubles, with 1e-9 to spare.
*/
class Contact_test
{
  static constexpr int m_most_order = 8;
  static constexpr std::size_t m_most_terms = 3000;
  static constexpr double m_slack = 1 + 1e-9;

  struct Term
  {
    double size;   // of the coefficient, rounded up
    int order;     // in s
    std::vector<int> exponents;   // per unknown, 0 for the free one
  };

  std::size_t m_dimension, m_free;
  int m_order = 0;
  double m_leading = 0;   // |c_k|, rounded down
  std::vector<int> m_row;
  std::vector<std::vector<Term>> m_terms;       // per row, without w' alone in its own row, and without c_k s^k
  std::vector<std::vector<double>> m_series;    // per unknown, the sizes of v and of the coefficients of W

public:
  // `rows` is the eliminated (J | I), `row_of` the row of the pivot of each unknown, -1 for the free one.
  Contact_test(const Constraint_system_d& system, const std::vector<Exact_rational>& point,
               const std::vector<Exact_rational>& rows, const std::vector<int>& row_of)
    : m_dimension(point.size()),
      m_free(static_cast<std::size_t>(std::find(row_of.begin(), row_of.end(), -1) - row_of.begin())), m_row(row_of),
      m_series(point.size())
  {
    std::vector<Power_polynomial> g = combined(system, point, rows);
    for (std::size_t j = 0; j < m_dimension; ++j)
      if (j != m_free)
        add_to_series(g, j, Exact_rational(-rows[2 * m_dimension * m_row[j] + m_free]), 1);
    for (int order = 2; order <= m_most_order; ++order) {
      if (std::any_of(g.begin(), g.end(),
                      [](const Power_polynomial& row) { return row.terms().size() > m_most_terms; }))
        return;
      const Exact_rational leading = coefficient_in_s(g.back(), order);
      if (!CGAL::is_zero(leading)) {
        m_order = order;
        m_leading = std::abs(CGAL::to_double(leading)) / m_slack;
        collect(g);
        return;
      }
      for (std::size_t j = 0; j < m_dimension; ++j)
        if (j != m_free)
          add_to_series(g, j, Exact_rational(-coefficient_in_s(g[m_row[j]], order)), order);
    }
  }

  // The multiplicity of the solution; 0 when it was not found.
  int order() const { return m_order; }

  // No other solution lies within the distances r of the point.
  bool is_alone(const std::vector<double>& r) const
  {
    if (m_order == 0 || !std::all_of(r.begin(), r.end(), [](double x) { return x > 1e-30 && x < 1e30; }))
      return false;
    const std::size_t n = m_dimension;
    const double s = r[m_free], power = std::pow(s, m_order);
    std::vector<double> reach(n, 0.0), pure(n, 0.0), mixed(n * n, 0.0);   // W', C, M
    for (std::size_t j = 0; j < n; ++j)
      if (j != m_free) {
        reach[j] = r[j];
        for (std::size_t i = 0; i < m_series[j].size(); ++i)
          reach[j] += m_series[j][i] * std::pow(s, static_cast<double>(i + 1)) * m_slack;
      }
    for (std::size_t j = 0; j < n; ++j)
      if (j != m_free)
        for (const Term& term : m_terms[m_row[j]]) {
          const std::size_t first = first_of(term);
          if (first == n)
            pure[j] += term.size * std::pow(s, term.order - m_order) * m_slack;
          else
            mixed[j * n + first] += term.size * std::pow(s, term.order) * product_without(term, first, reach) * m_slack;
        }
    std::vector<double> kappa;
    if (!solve_bound(pure, mixed, kappa))
      return false;
    for (std::size_t j = 0; j < n; ++j)
      reach[j] = (std::min)(reach[j], kappa[j] * power * m_slack);
    double rest = 0;
    for (const Term& term : m_terms[n - 1]) {
      const std::size_t first = first_of(term);
      rest += (first == n ? term.size * std::pow(s, term.order - m_order)
                          : term.size * std::pow(s, term.order) * product_without(term, first, reach) * kappa[first]) *
          m_slack;
    }
    return rest * m_slack < m_leading;
  }

private:
  // T f, with the origin in the point.
  std::vector<Power_polynomial> combined(const Constraint_system_d& system, const std::vector<Exact_rational>& point,
                                         const std::vector<Exact_rational>& rows) const
  {
    std::vector<Power_polynomial> f, g(m_dimension);
    for (const Spline_function& function : system.equalities()) {
      f.push_back(polynomial_at(function, point));
      for (std::size_t j = 0; j < m_dimension; ++j)
        f.back() = f.back().substituted(static_cast<int>(j), variable(j) + Power_polynomial(point[j]));
    }
    for (std::size_t i = 0; i < m_dimension; ++i)
      for (std::size_t l = 0; l < m_dimension; ++l)
        g[i] += Power_polynomial(rows[2 * m_dimension * i + m_dimension + l]) * f[l];
    return g;
  }

  static Power_polynomial variable(std::size_t j) { return Power_polynomial::variable(static_cast<int>(j)); }

  Exact_rational coefficient_in_s(const Power_polynomial& row, int order) const
  {
    const auto place = row.terms().find(Monomial().with_exponent(static_cast<int>(m_free), order));
    return place == row.terms().end() ? Exact_rational(0) : place->second;
  }

  void add_to_series(std::vector<Power_polynomial>& g, std::size_t j, const Exact_rational& coefficient, int order)
  {
    m_series[j].push_back(std::abs(CGAL::to_double(coefficient)) * m_slack);
    if (!CGAL::is_zero(coefficient))
      for (Power_polynomial& row : g)
        row = row.substituted(static_cast<int>(j),
                              variable(j) + Power_polynomial(coefficient) * pow(variable(m_free), order));
  }

  void collect(const std::vector<Power_polynomial>& g)
  {
    m_terms.resize(m_dimension);
    for (std::size_t i = 0; i < m_dimension; ++i)
      for (const auto& [monomial, coefficient] : g[i].terms()) {
        Term term{std::abs(CGAL::to_double(coefficient)) * m_slack, monomial.exponent(static_cast<int>(m_free)),
                  std::vector<int>(m_dimension, 0)};
        for (const auto& [v, e] : monomial.powers)
          if (static_cast<std::size_t>(v) != m_free)
            term.exponents[v] = e;
        const std::size_t first = first_of(term);
        const bool is_own = monomial.total_degree() == 1 && first < m_dimension && m_row[first] == static_cast<int>(i);
        const bool is_leading = i + 1 == m_dimension && first == m_dimension && term.order == m_order;
        if (is_own || is_leading)
          continue;
        if (!(term.size > 1e-200 && term.size < 1e200))
          m_order = 0;   // out of the range of these bounds
        m_terms[i].push_back(std::move(term));
      }
    if (!(m_leading > 1e-200 && m_leading < 1e200))
      m_order = 0;
  }

  std::size_t first_of(const Term& term) const
  {
    return static_cast<std::size_t>(
        std::find_if(term.exponents.begin(), term.exponents.end(), [](int e) { return e > 0; }) -
        term.exponents.begin());
  }

  static double product_without(const Term& term, std::size_t first, const std::vector<double>& x)
  {
    double result = 1;
    for (std::size_t j = 0; j < x.size(); ++j)
      for (int e = j == first ? 1 : 0; e < term.exponents[j]; ++e)
        result *= x[j];
    return result;
  }

  // kappa with C + M kappa < kappa, where iteration finds one.
  bool solve_bound(const std::vector<double>& pure, const std::vector<double>& mixed, std::vector<double>& kappa) const
  {
    constexpr int most_rounds = 12;
    const std::size_t n = m_dimension;
    kappa.assign(n, 0.0);
    std::vector<double> next(n);
    for (int round = 0; round < most_rounds; ++round) {
      bool is_bounded = true;
      for (std::size_t j = 0; j < n; ++j) {
        next[j] = pure[j];
        for (std::size_t l = 0; l < n; ++l)
          next[j] += mixed[j * n + l] * kappa[l] * m_slack;
        is_bounded = is_bounded && (j == m_free || next[j] * m_slack < kappa[j]);
      }
      if (is_bounded)
        return true;
      for (std::size_t j = 0; j < n; ++j)
        kappa[j] = j == m_free ? 0 : 1.25 * next[j] + 1e-12;
      if (!std::all_of(kappa.begin(), kappa.end(), [](double x) { return x < 1e100; }))
        return false;
    }
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_CONTACT_TEST_H
