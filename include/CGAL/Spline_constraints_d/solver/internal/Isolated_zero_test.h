// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_ISOLATED_ZERO_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_ISOLATED_ZERO_TEST_H

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

For each unknown x_j an element c x_j^k + r of their ideal is looked for, with c != 0, where r has no terms of a degree below k. Let |x_i| <= h_i be the box, and |u| the largest of the |u_i| = |x_i| / h_i. If
in the u_i the sum of the sizes of the coefficients of r is smaller than that of u_j^k, then no zero has |u_j| = |u| > 0, as r is at most that sum times |u|^k there. With such elements for all unknowns, there is
no zero but 0.

The elements come from the products of the polynomials and monomials, in the order of the lowest degree of their terms, by exact elimination of terms of low degree. If 0 is isolated among the complex zeros, then all
monomials of some degree are in the ideal up to terms of higher degree (Nakayama's lemma), so that small boxes pass.
*/
class Isolated_zero_test
{
  using Row = std::vector<Exact_rational>;   // coefficients
  using Element = std::pair<std::size_t, Row>;   // the column of the power

  static constexpr std::size_t most_monomials = 130;

  std::size_t m_dimension;
  std::vector<std::vector<int>> m_exponents;   // of the columns, by degree
  std::map<std::vector<int>, std::size_t> m_column;
  std::vector<std::optional<Row>> m_rows;      // per column of its first entry
  std::vector<std::vector<Element>> m_elements;   // per unknown

public:
  Isolated_zero_test(std::span<const Power_polynomial> polynomials, std::size_t dimension) : m_dimension(dimension), m_elements(dimension)
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
    return std::all_of(m_elements.begin(), m_elements.end(), [&](const std::vector<Element>& elements) {
      return std::any_of(elements.begin(), elements.end(), [&](const Element& element) { return is_dominant(element, sizes); });
    });
  }

private:
  static int degree(const std::vector<int>& exponents) { return std::accumulate(exponents.begin(), exponents.end(), 0); }

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
      Row row(m_exponents.size(), Exact_rational(0));
      for (const auto& [monomial, coefficient] : polynomial.terms()) {
        std::vector<int> exponents = shift;
        for (const auto& [v, e] : monomial.powers)
          exponents[v] += e;
        row[m_column.at(exponents)] = coefficient;
      }
      insert(std::move(row));
    }
  }

  void insert(Row row)
  {
    for (std::size_t c = 0; c < row.size(); ++c)
      if (!CGAL::is_zero(row[c])) {
        if (!m_rows[c]) {
          m_rows[c] = std::move(row);
          return;
        }
        eliminate(c, row);
      }
  }

  void eliminate(std::size_t c, Row& row) const
  {
    const Row& other = *m_rows[c];
    const Exact_rational factor = row[c] / other[c];
    for (std::size_t k = c; k < row.size(); ++k)
      if (!CGAL::is_zero(other[k]))
        row[k] -= factor * other[k];
  }

  // The row that begins with an entry, with those up to some degree eliminated that others begin with.
  Row reduced_row(std::size_t c, int largest_degree) const
  {
    Row row = *m_rows[c];
    for (std::size_t k = c + 1; k < row.size() && degree(m_exponents[k]) <= largest_degree; ++k)
      if (!CGAL::is_zero(row[k]) && m_rows[k])
        eliminate(k, row);
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
          has_power = true;
          for (std::size_t i = c + 1; i < row.size() && degree(m_exponents[i]) == k; ++i)
            has_power = has_power && CGAL::is_zero(row[i]);
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
          m_elements[j].emplace_back(c, reduced_row(c, order));
  }

  std::vector<Exact_rational> monomial_sizes(const std::vector<Exact_rational>& distances) const
  {
    std::vector<Exact_rational> result(m_exponents.size(), Exact_rational(1));
    for (std::size_t c = 1; c < m_exponents.size(); ++c) {
      std::vector<int> lower = m_exponents[c];
      const std::size_t j = static_cast<std::size_t>(std::find_if(lower.begin(), lower.end(), [](int e) { return e > 0; }) - lower.begin());
      --lower[j];
      result[c] = result[m_column.at(lower)] * distances[j];
    }
    return result;
  }

  static bool is_dominant(const Element& element, const std::vector<Exact_rational>& sizes)
  {
    const auto& [c, row] = element;
    Exact_rational others(0);
    for (std::size_t k = c + 1; k < row.size(); ++k)
      if (!CGAL::is_zero(row[k]))
        others += CGAL::abs(row[k]) * sizes[k];
    return others < Exact_rational(CGAL::abs(row[c]) * sizes[c]);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_ISOLATED_ZERO_TEST_H
