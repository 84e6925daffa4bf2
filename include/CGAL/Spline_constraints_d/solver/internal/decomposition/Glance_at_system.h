// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_GLANCE_AT_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_GLANCE_AT_SYSTEM_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Linear_combinations.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Prime_field_polynomial.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
What is seen of a system in some microseconds, with numbers modulo a prime. It may be wrong, and serves to save work
only: what is not promising is not decomposed.
*/
class Glance_at_system
{
  using Field = Prime_field_polynomial;
  using Number = Field::Number;
  using Key = std::uint64_t; // of a monomial: equal ones have equal keys, others hardly ever

  struct Coefficient
  {
    Key key;
    int degree;
    std::size_t equality, place; // in the piece of the term
    const Spline_term* term;

    const Exact_rational& value() const { return term->pieces[0][place]; }

    // Calls visit(unknown, exponent) for all unknowns of the monomial.
    template <class Visitor>
    void visit_powers(const Visitor& visit) const
    {
      for (std::size_t rest = place, j = term->degrees.size(); j-- > 0;) {
        const std::size_t length = static_cast<std::size_t>(term->degrees[j]) + 1;
        if (rest % length > 0)
          visit(term->variables[j], static_cast<int>(rest % length));
        rest /= length;
      }
    }
  };

  // Numbers of the coefficients of an equality, and where it is a combination of others, of these.
  struct Row
  {
    std::vector<Number> numbers, weights;
  };

  const Constraint_system_d& m_system;
  std::vector<int> m_parent;
  std::vector<Coefficient> m_coefficients; // of equalities without breaks; none of them is zero
  std::vector<int> m_degrees;              // of the equalities, -1 with breaks

public:
  explicit Glance_at_system(const Constraint_system_d& system)
    : m_system(system), m_parent(static_cast<std::size_t>(system.dimension()))
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
    for (const Spline_function& function : system.equalities()) {
      connect(function);
      collect_coefficients(function);
    }
    for (const auto& inequality : system.inequalities())
      connect(inequality.function);
  }

  // Whether unknowns are not connected by constraints, an equality of degree one seems to be worth eliminating an
  // unknown by, or combinations of equalities seem to be of lower degree or shorter.
  bool is_promising() { return number_of_groups() > 1 || has_promising_affine_equality() || has_better_combinations(); }

  // Whether an equality has degree one, or combinations seem to be worth looking at.
  bool may_eliminate() { return std::count(m_degrees.begin(), m_degrees.end(), 1) > 0 || has_better_combinations(); }

private:
  std::size_t number_of_groups() const
  {
    std::size_t result = 0;
    for (std::size_t v = 0; v < m_parent.size(); ++v)
      result += m_parent[v] == static_cast<int>(v) ? 1 : 0;
    return result;
  }

  int root(int v) { return root_in(m_parent, v); }

  static int root_in(std::vector<int>& parent, int v)
  {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  }

  void connect(const Spline_function& function)
  {
    int first = -1;
    for (const Spline_term& term : function.terms())
      for (const int variable : term.variables)
        if (first < 0)
          first = variable;
        else
          m_parent[root(variable)] = root(first);
  }

  void collect_coefficients(const Spline_function& function)
  {
    const std::size_t equality = m_degrees.size();
    m_degrees.push_back(-1);
    if (std::any_of(function.terms().begin(), function.terms().end(),
                    [](const Spline_term& term) { return term.pieces.size() != 1; }))
      return;
    for (const Spline_term& term : function.terms())
      for (std::size_t i = 0; i < term.pieces[0].size(); ++i) {
        if (CGAL::is_zero(term.pieces[0][i]))
          continue;
        Coefficient coefficient{0, 0, equality, i, &term};
        coefficient.visit_powers([&](int unknown, int exponent) {
          coefficient.key += key_of(unknown) * static_cast<Key>(exponent);
          coefficient.degree += exponent;
        });
        m_degrees.back() = (std::max)(m_degrees.back(), coefficient.degree);
        m_coefficients.push_back(coefficient);
      }
  }

  static Key key_of(int unknown)
  {
    Key x = static_cast<Key>(unknown + 1) * 0x9e3779b97f4a7c15u; // mixes as the generator splitmix64 does
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    return (x ^ (x >> 27)) | 1;
  }

  // An unknown of degree d in another equality leaves a power d of a sum of the k - 1 others, (d + 1)^(k - 1)
  // coefficients.
  bool has_promising_affine_equality() const
  {
    for (std::size_t i = 0; i < m_degrees.size(); ++i)
      if (m_degrees[i] == 1) {
        std::vector<int> unknowns;
        for (const Spline_term& term : m_system.equalities()[i].terms())
          unknowns.insert(unknowns.end(), term.variables.begin(), term.variables.end());
        for (const int unknown : unknowns)
          if (growth(i, unknown, static_cast<double>(unknowns.size()) - 1) <=
              2.0 * static_cast<double>(unknowns.size()))
            return true;
      }
    return false;
  }

  double growth(std::size_t own, int unknown, double others) const
  {
    double result = 0;
    for (std::size_t i = 0; i < m_degrees.size(); ++i) {
      double size = 0, degree = 0;
      for (const Spline_term& term : m_system.equalities()[i].terms()) {
        size += static_cast<double>(term.piece_size());
        for (std::size_t j = 0; j < term.variables.size(); ++j)
          if (term.variables[j] == unknown)
            degree = (std::max)(degree, static_cast<double>(term.degrees[j]));
      }
      if (i != own && degree > 1)
        result += (std::max)(std::pow(degree + 1, others) - size, 0.0);
    }
    return result;
  }

  // Rows in reduced echelon form with high degrees first that are simpler than some of those that they combine, whose
  // place they can take.
  bool has_better_combinations()
  {
    std::sort(m_coefficients.begin(), m_coefficients.end(), [](const Coefficient& a, const Coefficient& b) {
      return a.degree != b.degree ? a.degree > b.degree : a.key < b.key;
    });
    if (!shares_monomials())
      return false;
    std::vector<Row> rows(m_degrees.size());
    std::vector<std::size_t> columns; // one of the coefficients of each
    for (std::size_t k = 0; k < m_coefficients.size(); ++k) {
      if (k == 0 || m_coefficients[k].key != m_coefficients[k - 1].key)
        columns.push_back(k);
      std::vector<Number>& numbers = rows[m_coefficients[k].equality].numbers;
      numbers.resize(columns.size());
      numbers.back() = residue(m_coefficients[k].value());
    }
    if (rows.size() * rows.size() * columns.size() > most_products)
      return false;
    std::vector<int> costs;
    std::vector<Polynomial_shape> shapes;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].numbers.resize(columns.size());
      rows[i].weights.resize(rows.size());
      rows[i].weights[i] = 1;
      costs.push_back(cost_of(rows[i], columns));
      shapes.push_back(shape_of(rows[i], columns));
    }
    eliminate(rows, columns.size());
    return std::any_of(rows.begin(), rows.end(), [&](const Row& row) {
      int largest = 0;
      Polynomial_shape largest_shape;
      for (std::size_t i = 0; i < row.weights.size(); ++i)
        if (row.weights[i] != 0) {
          largest = (std::max)(largest, costs[i]);
          largest_shape.extend(shapes[i]);
        }
      return cost_of(row, columns) < largest && shape_of(row, columns).is_simpler_than(largest_shape);
    });
  }

  Polynomial_shape shape_of(const Row& row, const std::vector<std::size_t>& columns) const
  {
    Polynomial_shape result;
    std::vector<bool> occurs(m_parent.size(), false);
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (row.numbers[k] != 0) {
        const Coefficient& coefficient = m_coefficients[columns[k]];
        result.degree = (std::max)(result.degree, coefficient.degree);
        coefficient.visit_powers([&](int unknown, int) { occurs[unknown] = true; });
      }
    result.unknowns = static_cast<std::size_t>(std::count(occurs.begin(), occurs.end(), true));
    return result;
  }

  // The coefficients that a row needs: see number_of_coefficients().
  int cost_of(const Row& row, const std::vector<std::size_t>& columns) const
  {
    std::vector<int> degrees(m_parent.size(), 0), parent(m_parent.size()), sizes(m_parent.size(), 1);
    std::iota(parent.begin(), parent.end(), 0);
    for (std::size_t k = 0; k < columns.size(); ++k)
      if (row.numbers[k] != 0) {
        int first = -1;
        m_coefficients[columns[k]].visit_powers([&](int unknown, int exponent) {
          degrees[unknown] = (std::max)(degrees[unknown], exponent);
          if (first < 0)
            first = unknown;
          parent[root_in(parent, unknown)] = root_in(parent, first);
        });
      }
    int result = 0;
    for (std::size_t v = 0; v < parent.size(); ++v)
      if (degrees[v] > 0)
        sizes[root_in(parent, static_cast<int>(v))] *= degrees[v] + 1;
    for (std::size_t v = 0; v < parent.size(); ++v)
      if (degrees[v] > 0 && parent[v] == static_cast<int>(v))
        result += sizes[v];
    return result;
  }

  static constexpr std::size_t most_products = 20000;

  // Some monomial of a higher degree occurs twice, or several equalities have degree one.
  bool shares_monomials() const
  {
    const auto are_equal = [](const Coefficient& a, const Coefficient& b) { return a.degree > 1 && a.key == b.key; };
    return std::count(m_degrees.begin(), m_degrees.end(), 1) > 1 ||
        std::adjacent_find(m_coefficients.begin(), m_coefficients.end(), are_equal) != m_coefficients.end();
  }

  static void eliminate(std::vector<Row>& rows, std::size_t columns)
  {
    for (std::size_t pivots = 0, column = 0; pivots < rows.size() && column < columns; ++column) {
      std::size_t i = pivots;
      while (i < rows.size() && rows[i].numbers[column] == 0)
        ++i;
      if (i == rows.size())
        continue;
      std::swap(rows[i], rows[pivots]);
      const Row& own = rows[pivots];
      const Number inverse = Field::inverse(own.numbers[column]);
      for (std::size_t k = 0; k < rows.size(); ++k)
        if (k != pivots && rows[k].numbers[column] != 0) {
          const Number factor = Field::difference(0, rows[k].numbers[column] * inverse % Field::prime);
          add_multiple(rows[k].numbers, factor, own.numbers);
          add_multiple(rows[k].weights, factor, own.weights);
        }
      ++pivots;
    }
  }

  static void add_multiple(std::vector<Number>& row, Number factor, const std::vector<Number>& other)
  {
    for (std::size_t j = 0; j < row.size(); ++j)
      if (other[j] != 0)
        row[j] = (row[j] + factor * other[j]) % Field::prime;
  }

  // Of doubles by their digits: modulo 2^31 - 1, the powers of two repeat after 31.
  static Number residue(const Exact_rational& x)
  {
    double value;
    if (!is_small_dyadic(x, value))
      return Field::residue(x);
    int exponent;
    const auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(std::abs(value), &exponent), 53));
    const Number size = static_cast<Number>(digits) % Field::prime;
    const int shift = ((exponent - 53) % 31 + 31) % 31;
    const Number result = (size << shift) % Field::prime;
    return value < 0 ? Field::difference(0, result) : result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_GLANCE_AT_SYSTEM_H
