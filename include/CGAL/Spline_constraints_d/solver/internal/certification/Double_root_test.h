// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_DOUBLE_ROOT_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_DOUBLE_ROOT_TEST_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Proves that a rational solution p has multiplicity 2 and is alone in a box: Jacobian of rank n - 1 with kernels v and
lambda, and lambda D^2 f(v,v) not zero (simple double zeros: Dedieu, Shub, On simple double zeros and badly conditioned
zeros of analytic functions of n variables, Math. Comp. 70, 2001).

Gauss-Jordan elimination, exactly, makes the equations g = T f, with d = x - p, s the component of d along the free axis
k and w = d - s v:
  g_i = w_i + a_i(d), for all but the last, and g_n = b(d),
a_i and b without constant and linear terms. Where all are zero in the box |d| <= r:
1. |w| <= M |d|, M from the sizes of the coefficients of a and from r; so |w| <= L |s| for any L with M |v| + M L < L,
  by considering the largest ratio.
2. |d| <= D |s| with D = |v| + L; so |w| <= kappa s^2, from the coefficients of a once more.
3. |b - b_vv s^2| <= rho s^2, from those of b. If |b_vv| > rho then s = 0, and w = 0 by 1: p is the only solution in the
  box. The bounds are sums of products of positive doubles, with 1e-9 to spare.
*/
class Double_root_test
{
  using Exponents = std::vector<int>;
  struct Monomial_size
  {
    Exponents exponents;
    std::vector<double> sizes;   // of the coefficients in g_1, ..., g_n, rounded up
  };
  static constexpr double m_slack = 1 + 1e-9;

  int m_dimension, m_free = 0;
  std::vector<Monomial_size> m_terms;   // of degree 2 and more
  std::vector<double> m_kernel;         // |v|
  double m_curvature = 0;               // |b_vv|, rounded down
  std::vector<int> m_row;               // of g, per axis; -1: the free one
  bool m_is_double = false, m_has_corank_one = false;
  std::vector<Exact_rational> m_eliminated;   // (J | I)

public:
  // The polynomials of the equalities around the point, which is a solution and not on a break.
  Double_root_test(const Constraint_system_d& system, const std::vector<Exact_rational>& point)
    : m_dimension(system.dimension())
  {
    std::vector<Taylor_terms> terms;
    if (!expand(system, point, 1, terms) || !eliminate(terms))   // mostly this tells, at less cost
      return;
    int degree = 0;
    for (const Spline_function& equality : system.equalities())
      for (const Spline_term& term : equality.terms())
        degree = (std::max)(degree, std::accumulate(term.degrees.begin(), term.degrees.end(), 0));
    m_has_corank_one = expand(system, point, degree, terms);
    if (m_has_corank_one)
      combine(terms);
  }

  // Multiplicity 2, over the complex numbers too.
  bool is_double_root() const { return m_is_double; }

  // The Jacobian has rank n - 1, and its elimination.
  bool has_corank_one() const { return m_has_corank_one; }
  const std::vector<Exact_rational>& eliminated() const { return m_eliminated; }
  const std::vector<int>& row_of() const { return m_row; }

  // No other solution lies within the distances r of the point.
  bool is_alone(const std::vector<double>& r) const
  {
    const int n = m_dimension;
    if (!m_is_double || !std::all_of(r.begin(), r.end(), [](double x) { return x > 1e-100 && x < 1e100; }))
      return false;
    const double reach = r[m_free];
    std::vector<double> slope(n * n, 0.0), bound(n, 0.0), next(n), factor(n), kappa(n, 0.0);
    for (const Monomial_size& term : m_terms) {
      double size = 1;
      int first = -1;
      for (int j = 0; j < n; ++j)
        if (term.exponents[j] > 0) {
          // One factor is kept: that of an axis which is not the free one, where there is one.
          if (first < 0 || first == m_free)
            first = j;
          size *= std::pow(r[j], term.exponents[j]);
        }
      for (int i = 0; i + 1 < n; ++i)
        slope[i * n + first] += term.sizes[i] * size / r[first] * m_slack;
    }
    bool is_bounded = false;
    for (int round = 0; round < 12 && !is_bounded; ++round) {
      is_bounded = true;
      for (int j = 0; j < n; ++j) {
        next[j] = 0;
        if (j == m_free)
          continue;
        for (int l = 0; l < n; ++l)
          next[j] += slope[m_row[j] * n + l] * (m_kernel[l] + bound[l]) * m_slack;
        is_bounded = is_bounded && next[j] < bound[j];
      }
      if (!is_bounded)
        for (int j = 0; j < n; ++j)
          bound[j] = j == m_free ? 0 : 1.25 * next[j] + 1e-12;
      if (!std::all_of(bound.begin(), bound.end(), [](double x) { return x < 1e100; }))
        return false;
    }
    if (!is_bounded)
      return false;
    for (int j = 0; j < n; ++j)
      factor[j] = (m_kernel[j] + bound[j]) * m_slack;
    double rest = 0;
    std::vector<double> curvature(n, 0.0);   // kappa, per row
    for (const Monomial_size& term : m_terms) {
      const double size = power_product(factor, term.exponents) * std::pow(reach, degree(term) - 2) * m_slack;
      for (int i = 0; i + 1 < n; ++i)
        curvature[i] += term.sizes[i] * size * m_slack;
      if (degree(term) > 2)
        rest += term.sizes[n - 1] * size * m_slack;
    }
    for (int j = 0; j < n; ++j)
      kappa[j] = j == m_free ? 0 : curvature[m_row[j]];
    for (const Monomial_size& term : m_terms)
      if (degree(term) == 2) {
        const auto [j, l] = axes_of_square(term.exponents);
        rest += term.sizes[n - 1] *
            ((m_kernel[j] * kappa[l] + kappa[j] * m_kernel[l]) * reach + kappa[j] * kappa[l] * reach * reach) * m_slack;
      }
    return rest * m_slack < m_curvature;
  }

private:
  static int degree(const Monomial_size& term)
  {
    return std::accumulate(term.exponents.begin(), term.exponents.end(), 0);
  }

  static double power_product(const std::vector<double>& x, const Exponents& exponents)
  {
    double result = 1;
    for (std::size_t j = 0; j < x.size(); ++j)
      for (int e = 0; e < exponents[j]; ++e)
        result *= x[j];
    return result;
  }

  static std::pair<int, int> axes_of_square(const Exponents& exponents)
  {
    std::pair<int, int> result(-1, -1);
    for (int j = 0; j < static_cast<int>(exponents.size()); ++j)
      for (int e = 0; e < exponents[j]; ++e)
        (result.first < 0 ? result.first : result.second) = j;
    return result;
  }

  static bool expand(const Constraint_system_d& system, const std::vector<Exact_rational>& point, int order,
                     std::vector<Taylor_terms>& terms)
  {
    terms.clear();
    return std::all_of(system.equalities().begin(), system.equalities().end(), [&](const Spline_function& equality) {
      return taylor_expansion(equality, point, order, terms.emplace_back());
    });
  }

  // Whether the Jacobian has rank n - 1. The size of pivots is for that of the bounds; any other would be as exact.
  bool eliminate(const std::vector<Taylor_terms>& terms)
  {
    const int n = m_dimension;
    std::vector<Exact_rational> rows(2 * n * n, Exact_rational(0));   // (J | I)
    for (int i = 0; i < n; ++i) {
      rows[2 * n * i + n + i] = Exact_rational(1);
      for (int j = 0; j < n; ++j) {
        Exponents exponents(n, 0);
        exponents[j] = 1;
        if (const auto place = terms[i].find(exponents); place != terms[i].end())
          rows[2 * n * i + j] = place->second;
      }
    }
    m_row = gauss_jordan(rows, 2 * n, n, n - 1, [](const Exact_rational& x) {
      return CGAL::is_zero(x) ? 0 : (std::max)(std::abs(CGAL::to_double(x)), 1e-300);
    });
    if (m_row.empty())
      return false;
    m_free = static_cast<int>(std::find(m_row.begin(), m_row.end(), -1) - m_row.begin());
    m_eliminated = std::move(rows);
    return CGAL::is_zero(m_eliminated[2 * n * (n - 1) + m_free]);
  }

  void combine(const std::vector<Taylor_terms>& terms)
  {
    const int n = m_dimension;
    const std::vector<Exact_rational>& rows = m_eliminated;
    std::vector<Exact_rational> kernel(n, Exact_rational(1));
    for (int j = 0; j < n; ++j)
      if (j != m_free)
        kernel[j] = -rows[2 * n * m_row[j] + m_free];
    for (const Exact_rational& entry : kernel)
      m_kernel.push_back(std::abs(CGAL::to_double(entry)) * m_slack);
    std::map<Exponents, std::vector<Exact_rational>> coefficients;   // of f_1, ..., f_n
    for (int i = 0; i < n; ++i)
      for (const auto& [exponents, coefficient] : terms[i])
        coefficients.try_emplace(exponents, n, Exact_rational(0)).first->second[i] = coefficient;
    Exact_rational curvature(0);
    bool is_in_range = true;
    for (const auto& [exponents, column] : coefficients) {
      const int degree = std::accumulate(exponents.begin(), exponents.end(), 0);
      if (degree < 2)
        continue;
      Monomial_size& term = m_terms.emplace_back(Monomial_size{exponents, {}});
      for (int i = 0; i < n; ++i) {
        Exact_rational sum(0);
        for (int l = 0; l < n; ++l)
          if (!CGAL::is_zero(column[l]))
            sum += rows[2 * n * i + n + l] * column[l];
        const double size = std::abs(CGAL::to_double(sum));
        is_in_range = is_in_range && (CGAL::is_zero(sum) || (size > 1e-200 && size < 1e200));
        term.sizes.push_back(size * m_slack);
        if (i == n - 1 && degree == 2) {
          const auto [j, l] = axes_of_square(exponents);
          curvature += sum * kernel[j] * kernel[l];
        }
      }
    }
    m_curvature = std::abs(CGAL::to_double(curvature)) / m_slack;
    m_is_double = is_in_range && m_curvature > 1e-200 && m_curvature < 1e200;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_DOUBLE_ROOT_TEST_H
