// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_GRAPH_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_GRAPH_TEST_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Tells whether n - d combinations of at least as many equalities are zero, in a node, on at most a graph over d of the
unknowns: part of a curve for d = 1, of a surface for d = 2.

Gauss-Jordan elimination of the Jacobian at the middle makes g = T f, whose first n - d rows are solved for all unknowns
but d, the parameters. When their derivatives by these unknowns, bounded on all of the node, differ from the identity by
less than one in the row sums, then for each value of the parameters at most one point of the node makes these rows
zero: for two of them x and y the mean value theorem gives |g(x) - g(y) - (x - y)| < |x - y| in the maximum norm.
*/
class Graph_test
{
  int m_dimension, m_equalities, m_solved; // unknowns, equalities, rows that are solved
  std::vector<double> m_middle, m_radius, m_rows, m_transform;
  std::vector<int> m_row; // of g, per unknown; -1: a parameter

public:
  // `dimension`: number of unknowns; `parameters`: d.
  Graph_test(int dimension, int equalities, int parameters = 1)
    : m_dimension(dimension), m_equalities(equalities), m_solved(dimension - parameters)
  {}

  // Makes T; false where the Jacobian at the middle is singular.
  bool eliminate(Node_view& view)
  {
    m_middle.resize(m() * n());
    m_radius.resize(m() * n());
    for (int i = 0; i < m(); ++i)
      for (int j = 0; j < n(); ++j) {
        const double lower = view.derivative_lower(i)[j], upper = view.derivative_upper(i)[j];
        m_middle[i * n() + j] = 0.5 * (lower + upper);
        m_radius[i * n() + j] = 0.5 * (upper - lower);
      }
    const int length = n() + m();
    m_rows.assign(m() * length, 0.0); // (J | I)
    for (int i = 0; i < m(); ++i) {
      std::copy_n(m_middle.begin() + i * n(), n(), m_rows.begin() + i * length);
      m_rows[i * length + n() + i] = 1;
    }
    m_row = gauss_jordan(m_rows, length, n(), m_solved, [](double x) { return std::abs(x); });
    if (m_row.empty())
      return false;
    m_transform.resize(m() * m());
    for (int i = 0; i < m(); ++i)
      std::copy_n(m_rows.begin() + i * length + n(), m(), m_transform.begin() + i * m());
    return true;
  }

  // The rest asks about what was eliminated last.

  bool is_graph() const { return contraction() < 1; }

  // Bounds in the node on the row sums of what the derivatives of the solved rows, by all unknowns but the
  // parameters, differ from the identity by.
  double contraction() const
  {
    double result = 0;
    for (int i = 0; i < m_solved; ++i)
      if (const double own = spread(i); own > result || std::isnan(own))
        result = own;
    return result;
  }

  // One of these; for the other rows, of their derivatives themselves: for the same parameters they change by at most
  // this times the distance, in the maximum norm.
  double spread(int row) const
  {
    constexpr double rounding = 1e-9;
    double difference = 0, size = 0;
    for (int j = 0; j < n(); ++j) {
      if (m_row[j] < 0)
        continue;
      double sum = m_row[j] == row ? -1 : 0, radius = 0;
      for (int l = 0; l < m(); ++l) {
        const double factor = transform(row, l);
        sum += factor * m_middle[l * n() + j];
        radius += std::abs(factor) * m_radius[l * n() + j];
        size += std::abs(factor * m_middle[l * n() + j]);
      }
      difference += std::abs(sum) + radius;
    }
    return difference + rounding * size;
  }

  // Some of the solved rows has no zero in the node, by the linear parts of the equalities.
  bool is_empty(Node_view& view) const
  {
    for (int i = 0; i < m_solved; ++i) {
      double value = 0, reach = 0, size = 0;
      for (int l = 0; l < m(); ++l) {
        const double factor = transform(i, l), lower = view.rest_lower(l), upper = view.rest_upper(l);
        value += factor * 0.5 * (lower + upper);
        reach += std::abs(factor) * 0.5 * (upper - lower);
        size += std::abs(factor) * (std::max)(std::abs(lower), std::abs(upper));
      }
      for (int j = 0; j < n(); ++j) {
        double slope = 0;
        for (int l = 0; l < m(); ++l) {
          slope += transform(i, l) * view.slopes(l)[j];
          size += std::abs(transform(i, l) * view.slopes(l)[j]);
        }
        reach += 0.5 * std::abs(slope);
      }
      if (std::abs(value) > reach + analysis_error * size)
        return true;
    }
    return false;
  }

  // The unknown that the graph is over, the first one if there are several.
  int parameter() const { return static_cast<int>(std::find(m_row.begin(), m_row.end(), -1) - m_row.begin()); }

  // All of them.
  std::vector<int> parameters() const
  {
    std::vector<int> result;
    for (int j = 0; j < n(); ++j)
      if (m_row[j] < 0)
        result.push_back(j);
    return result;
  }

  // The sign of the determinant of the derivatives of the equalities by the unknowns that are solved for, the same in
  // all of the node where it is a graph: there T times this matrix is nearer to the identity than one in the row sums,
  // and so has a positive determinant. For as many equalities as rows that are solved.
  int sign_of_minor() const
  {
    std::vector<Exact_rational> rows;
    for (int j = 0; j < n(); ++j)
      for (int i = 0; i < m_solved && m_row[j] >= 0; ++i)
        rows.emplace_back(transform(m_row[j], i));
    return sign_of_determinant(std::move(rows), static_cast<std::size_t>(m_solved));
  }

  // The row that is solved for an unknown; -1 for a parameter.
  int row_of(int unknown) const { return m_row[unknown]; }

  // T, row by row.
  const std::vector<double>& transform() const { return m_transform; }
  double transform(int row, int equality) const { return m_transform[row * m() + equality]; }
  double middle(int equality, int unknown) const { return m_middle[equality * n() + unknown]; }
  double radius(int equality, int unknown) const { return m_radius[equality * n() + unknown]; }

  // The derivative of a row by an unknown, at the middle.
  double derivative(int row, int unknown) const { return m_rows[row * (n() + m()) + unknown]; }

private:
  int n() const { return m_dimension; }
  int m() const { return m_equalities; }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_GRAPH_TEST_H
