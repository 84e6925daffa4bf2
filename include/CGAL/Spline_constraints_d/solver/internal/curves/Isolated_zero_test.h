// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_ISOLATED_ZERO_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_ISOLATED_ZERO_TEST_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Proves that 0 is the only common zero of polynomials in boxes around it, whatever its multiplicity.

For each unknown x_j an element c x_j^k + r of their ideal is looked for, with c != 0, where r has no terms of a degree
below k. Let |x_i| <= h_i be the box, and |u| the largest of the |u_i| = |x_i| / h_i. If in the u_i the sum of the sizes
of the coefficients of r is smaller than that of u_j^k, then no zero has |u_j| = |u| > 0, as r is at most that sum times
|u|^k there. With such elements for all unknowns, there is no zero but 0.

The elements come from the products of the polynomials and monomials, in the order of the lowest degree of their terms,
by exact elimination of terms of low degree. If 0 is isolated among the complex zeros, then all monomials of some degree
are in the ideal up to terms of higher degree (Nakayama's lemma), so that small boxes pass.
*/
class Isolated_zero_test
{
  // columns and coefficients that are not zero, in order
  using Row = std::vector<std::pair<std::size_t, Exact_rational>>;

  static constexpr std::size_t most_monomials = 130;

  std::size_t m_dimension;
  std::vector<std::vector<int>> m_exponents;   // of the columns, by degree
  std::map<std::vector<int>, std::size_t> m_column;
  std::vector<std::optional<Row>> m_rows;      // per column of its first entry
  std::vector<std::vector<Row>> m_elements;    // per unknown: they begin with powers of it

public:
  Isolated_zero_test(std::span<const Power_polynomial> polynomials, std::size_t dimension)
    : m_dimension(dimension), m_elements(dimension)
  {
    constexpr int more_orders = 2;   // than small boxes need: they serve larger ones
    int last = 1, largest_degree = 0;
    while (exponents_up_to(dimension, last + 1).size() <= most_monomials)
      ++last;
    for (const Power_polynomial& polynomial : polynomials)
      largest_degree = (std::max)(largest_degree, polynomial.total_degree());
    m_exponents = exponents_up_to(dimension, last + largest_degree);
    for (std::size_t c = 0; c < m_exponents.size(); ++c)
      m_column[m_exponents[c]] = c;
    m_rows.resize(m_exponents.size());
    bool has_elements = false;
    for (int order = 1; order <= last; ++order) {
      for (const Power_polynomial& polynomial : polynomials)
        add_products(polynomial, order);
      if (!has_elements && has_all_powers(order)) {
        has_elements = true;
        last = (std::min)(last, order + more_orders);
      }
    }
    if (has_elements)
      keep_elements(last);
  }

  // Whether there is no other zero with |x_j| <= distances[j].
  bool is_alone_in(const std::vector<Exact_rational>& distances) const
  {
    const std::vector<Exact_rational> sizes = monomial_sizes(distances);
    return std::all_of(m_elements.begin(), m_elements.end(), [&](const std::vector<Row>& elements) {
      return std::any_of(elements.begin(), elements.end(),
                         [&](const Row& element) { return is_dominant(element, sizes); });
    });
  }

private:
  static int degree(const std::vector<int>& exponents)
  {
    return std::accumulate(exponents.begin(), exponents.end(), 0);
  }

  std::size_t column_of_power(std::size_t unknown, int exponent) const
  {
    std::vector<int> exponents(m_dimension, 0);
    exponents[unknown] = exponent;
    return m_column.at(exponents);
  }

  // Products whose terms begin with an order.
  void add_products(const Power_polynomial& polynomial, int order)
  {
    int lowest = polynomial.total_degree();
    for (const auto& [monomial, coefficient] : polynomial.terms())
      lowest = (std::min)(lowest, monomial.total_degree());
    for (const std::vector<int>& shift : m_exponents) {
      if (degree(shift) > order - lowest)
        return;
      if (degree(shift) < order - lowest)
        continue;
      Row row;
      for (const auto& [monomial, coefficient] : polynomial.terms()) {
        std::vector<int> exponents = shift;
        for (const auto& [v, e] : monomial.powers)
          exponents[v] += e;
        row.emplace_back(m_column.at(exponents), coefficient);
      }
      std::sort(row.begin(), row.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      insert(std::move(row));
    }
  }

  void insert(Row row)
  {
    while (!row.empty()) {
      std::optional<Row>& own = m_rows[row.front().first];
      if (!own) {
        own = std::move(row);
        return;
      }
      row = eliminated(row, 0, *own);
    }
  }

  // A row minus the multiple of another one, which begins with the column of one of its entries, that has not this
  // entry.
  static Row eliminated(const Row& row, std::size_t entry, const Row& other)
  {
    const Exact_rational factor = row[entry].second / other.front().second;
    Row result(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(entry));
    std::size_t i = entry + 1, k = 1;
    while (i < row.size() || k < other.size()) {
      const bool takes_own = k == other.size() || (i < row.size() && row[i].first <= other[k].first),
                 takes_other = i == row.size() || (k < other.size() && other[k].first <= row[i].first);
      const std::size_t column = takes_own ? row[i].first : other[k].first;
      Exact_rational coefficient = takes_own ? row[i++].second : Exact_rational(0);
      if (takes_other)
        coefficient -= factor * other[k++].second;
      if (!CGAL::is_zero(coefficient))
        result.emplace_back(column, std::move(coefficient));
    }
    return result;
  }

  // The row that begins with an entry, with those up to some degree eliminated that others begin with.
  Row reduced_row(std::size_t c, int largest_degree) const
  {
    Row row = *m_rows[c];
    for (std::size_t i = 1; i < row.size() && degree(m_exponents[row[i].first]) <= largest_degree;)
      if (const std::optional<Row>& other = m_rows[row[i].first])
        row = eliminated(row, i, *other);
      else
        ++i;
    return row;
  }

  // Whether small boxes pass: each unknown has a row that is a power of it, up to terms of higher degree.
  bool has_all_powers(int order) const
  {
    for (std::size_t j = 0; j < m_dimension; ++j) {
      bool has_power = false;
      for (int k = 1; k <= order && !has_power; ++k)
        if (const std::size_t c = column_of_power(j, k); m_rows[c]) {
          const Row row = reduced_row(c, k);
          has_power = row.size() == 1 || degree(m_exponents[row[1].first]) > k;
        }
      if (!has_power)
        return false;
    }
    return true;
  }

  void keep_elements(int order)
  {
    for (std::size_t j = 0; j < m_dimension; ++j)
      for (int k = 1; k <= order; ++k)
        if (const std::size_t c = column_of_power(j, k); m_rows[c])
          m_elements[j].push_back(reduced_row(c, order));
  }

  std::vector<Exact_rational> monomial_sizes(const std::vector<Exact_rational>& distances) const
  {
    std::vector<Exact_rational> result(m_exponents.size(), Exact_rational(1));
    for (std::size_t c = 1; c < m_exponents.size(); ++c) {
      std::vector<int> lower = m_exponents[c];
      const std::size_t j = static_cast<std::size_t>(
          std::find_if(lower.begin(), lower.end(), [](int e) { return e > 0; }) - lower.begin());
      --lower[j];
      result[c] = result[m_column.at(lower)] * distances[j];
    }
    return result;
  }

  static bool is_dominant(const Row& element, const std::vector<Exact_rational>& sizes)
  {
    const auto size = [&](const auto& entry) { return Exact_rational(CGAL::abs(entry.second) * sizes[entry.first]); };
    Exact_rational others(0);
    for (auto entry = element.begin() + 1; entry != element.end(); ++entry)
      others += size(*entry);
    return others < size(element.front());
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_ISOLATED_ZERO_TEST_H
