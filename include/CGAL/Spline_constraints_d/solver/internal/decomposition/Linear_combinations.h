// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_LINEAR_COMBINATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_LINEAR_COMBINATIONS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Echelon_form.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// How many coefficients a polynomial has as a `Spline_function`: the sum, over the groups of unknowns that occur
// together, of the products of degrees plus one.
inline double number_of_coefficients(const Power_polynomial& polynomial)
{
  const std::map<int, int> degrees = polynomial.degrees();
  std::map<int, int> parent;
  for (const auto& [unknown, degree] : degrees)
    parent[unknown] = unknown;
  const auto root = [&](int v) {
    while (parent[v] != v)
      v = parent[v];
    return v;
  };
  for (const auto& [monomial, coefficient] : polynomial.terms())
    for (std::size_t k = 1; k < monomial.powers.size(); ++k)
      parent[root(monomial.powers[k].first)] = root(monomial.powers[0].first);
  std::map<int, double> sizes;
  for (const auto& [unknown, degree] : degrees)
    sizes.try_emplace(root(unknown), 1.0).first->second *= degree + 1;
  double result = 0;
  for (const auto& [representative, size] : sizes)
    result += size;
  return result;
}

// What makes a polynomial difficult: its degree and the number of its unknowns.
struct Polynomial_shape
{
  int degree = 0;
  std::size_t unknowns = 0;

  void extend(const Polynomial_shape& other)
  {
    degree = (std::max)(degree, other.degree);
    unknowns = (std::max)(unknowns, other.unknowns);
  }

  // Worth being put in the place of the other one.
  bool is_simpler_than(const Polynomial_shape& other) const
  {
    return degree < other.degree || unknowns < other.unknowns;
  }
};

/*
Linear combinations of polynomials that span the same space, of as few coefficients in all as can be chosen from the
polynomials themselves, the rows of their reduced echelon form with the monomials of high degree first, which have the
lowest degrees that there are, and sums of two of them in which terms cancel. By the exchange property of bases, it is
the best choice to take the cheapest ones first and to leave out what depends on those before. Combinations that have
neither a lower degree nor fewer unknowns are not considered: the subdivision combines equations itself, and fewer
coefficients alone do not pay for the structure that is lost.
*/
class Linear_combinations
{
  using Weights = std::vector<Exact_rational>; // of the given polynomials

  struct Candidate
  {
    Power_polynomial polynomial;
    Weights weights;
    double cost;
    int degree;
  };

  static constexpr double most_products = 20000; // of numbers of some hundred bits: some ten milliseconds

  const std::vector<Power_polynomial>& m_given;
  const std::function<void()>& m_check;
  std::vector<Candidate> m_candidates;

public:
  // `check` as of decomposition_of(); it has a target.
  Linear_combinations(const std::vector<Power_polynomial>& given, const std::function<void()>& check)
    : m_given(given), m_check(check)
  {}

  // Nothing when no choice has fewer coefficients than the given ones, or these are linearly dependent.
  std::optional<std::vector<Power_polynomial>> cheapest()
  {
    const std::vector<Monomial> columns = shared_columns();
    if (columns.empty() || takes_too_long(columns.size()))
      return std::nullopt;
    double cost = 0;
    for (std::size_t i = 0; i < m_given.size(); ++i) {
      add_candidate(m_given[i], unit(i));
      cost += m_candidates.back().cost;
    }
    if (!add_echelon_form(columns))
      return std::nullopt;
    add_sums_of_two();
    std::vector<Power_polynomial> result;
    for (const Candidate& candidate : cheapest_basis()) {
      cost -= candidate.cost;
      result.push_back(candidate.polynomial);
    }
    return cost > 0 ? std::optional(std::move(result)) : std::nullopt;
  }

private:
  // In elimination numbers grow to as many times their digits as there are polynomials.
  bool takes_too_long(std::size_t columns) const
  {
    long bits = 0;
    for (const Power_polynomial& polynomial : m_given)
      for (const auto& [monomial, coefficient] : polynomial.terms())
        bits = (std::max)(bits, bit_length(numerator_of(coefficient)) + bit_length(denominator_of(coefficient)));
    const auto rows = static_cast<double>(m_given.size());
    const double growth = (std::max)(rows * static_cast<double>(bits) / 512, 1.0);
    return rows * rows * static_cast<double>(columns) * growth > most_products;
  }

  Weights unit(std::size_t i) const
  {
    Weights result(m_given.size(), Exact_rational(0));
    result[i] = 1;
    return result;
  }

  // All monomials, those of high degree first; none when combinations cannot help: no monomial that is not linear
  // occurs twice, and there are not even two polynomials that are linear.
  std::vector<Monomial> shared_columns() const
  {
    std::map<std::pair<int, Monomial>, int> count; // by the negative degree
    int linear = 0;
    for (const Power_polynomial& polynomial : m_given) {
      int degree = 0;
      for (const auto& [monomial, coefficient] : polynomial.terms()) {
        degree = (std::max)(degree, monomial.total_degree());
        ++count[{-monomial.total_degree(), monomial}];
      }
      linear += degree <= 1 ? 1 : 0;
    }
    if (linear < 2 && std::none_of(count.begin(), count.end(), [](const auto& entry) {
          return entry.first.first < -1 && entry.second > 1;
        }))
      return {};
    std::vector<Monomial> result;
    for (const auto& [key, number] : count)
      result.push_back(key.second);
    return result;
  }

  void add_candidate(Power_polynomial polynomial, Weights weights)
  {
    const double cost = number_of_coefficients(polynomial);
    const int degree = polynomial.total_degree();
    m_candidates.push_back({std::move(polynomial), std::move(weights), cost, degree});
  }

  // Eliminates on [coefficients | unit matrix]; false when the polynomials are linearly dependent.
  bool add_echelon_form(const std::vector<Monomial>& columns)
  {
    Echelon_form echelon;
    for (std::size_t i = 0; i < m_given.size(); ++i) {
      std::vector<Exact_rational> row;
      for (const Monomial& monomial : columns) {
        const auto term = m_given[i].terms().find(monomial);
        row.push_back(term == m_given[i].terms().end() ? Exact_rational(0) : term->second);
      }
      m_check();
      const Weights weights = unit(i);
      row.insert(row.end(), weights.begin(), weights.end());
      echelon.add(std::move(row));
    }
    for (const auto& [place, row] : echelon.rows()) {
      if (place >= columns.size())
        return false;
      const Weights weights(row.begin() + static_cast<std::ptrdiff_t>(columns.size()), row.end());
      if (std::count_if(weights.begin(), weights.end(), [](const auto& w) { return !CGAL::is_zero(w); }) > 1)
        add_combination(weights);
    }
    return true;
  }

  void add_combination(const Weights& weights)
  {
    m_check();
    Power_polynomial result;
    Polynomial_shape largest;
    for (std::size_t i = 0; i < weights.size(); ++i)
      if (!CGAL::is_zero(weights[i])) {
        result += Power_polynomial(weights[i]) * m_given[i];
        largest.extend(shape_of(m_given[i]));
      }
    if (shape_of(result).is_simpler_than(largest))
      add_candidate(std::move(result), weights);
  }

  static Polynomial_shape shape_of(const Power_polynomial& polynomial)
  {
    return {polynomial.total_degree(), polynomial.variables().size()};
  }

  // f - c g, where it has fewer terms than f.
  void add_sums_of_two()
  {
    for (std::size_t i = 0; i < m_given.size(); ++i)
      for (std::size_t k = 0; k < m_given.size(); ++k) {
        if (k == i)
          continue;
        std::map<Exact_rational, std::size_t> cancelled; // terms, by c
        std::size_t shared = 0;
        for (const auto& [monomial, coefficient] : m_given[i].terms())
          if (const auto term = m_given[k].terms().find(monomial); term != m_given[k].terms().end()) {
            ++cancelled[Exact_rational(coefficient / term->second)];
            ++shared;
          }
        for (const auto& [c, number] : cancelled)
          if (m_given[k].terms().size() < shared + number) {
            Weights weights = unit(i);
            weights[k] = -c;
            add_combination(weights);
          }
      }
  }

  std::vector<Candidate> cheapest_basis()
  {
    std::stable_sort(m_candidates.begin(), m_candidates.end(), [](const Candidate& a, const Candidate& b) {
      return std::tuple(a.cost, a.degree, a.polynomial.terms().size()) <
          std::tuple(b.cost, b.degree, b.polynomial.terms().size());
    });
    Echelon_form chosen;
    std::vector<Candidate> result;
    for (Candidate& candidate : m_candidates)
      if (result.size() < m_given.size() && chosen.add(candidate.weights))
        result.push_back(std::move(candidate));
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_LINEAR_COMBINATIONS_H
