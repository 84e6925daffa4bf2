// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_ROW_ELIMINATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_ROW_ELIMINATION_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>

#include <boost/config.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Gauss-Jordan with full pivoting of rows with interval right-hand sides, weighed by what they can still contract: a row
whose interval part is larger than half its pivot bounds nothing and would only blur the others, so elimination stops
there (in a huge box the linear equations are solved and the rest waits). In place: the column of a pivot then holds
that of its row in the inverse.

`size` is the number of rows and of columns if that is known to the compiler, else 0. Rows and columns change places
until each pivot has a place that is known, too, and everything stays in registers.
*/
template <int size>
class Row_elimination
{
  template <class T, int count>
  using Numbers = std::conditional_t<(size > 0), std::array<T, count>, std::vector<T>>;

  int m_rows, m_columns, m_rank = 0;
  Numbers<double, size * size> m_entries;
  Numbers<double, size> m_radius, m_scale;   // of the right-hand side; one over what a row weighs
  Numbers<int, size> m_equation, m_unknown;  // of a row, of a column

public:
  Row_elimination(int rows, int columns)
    : m_rows(rows), m_columns(columns)
  {
    if constexpr (size == 0) {
      m_entries.resize(static_cast<std::size_t>(rows) * columns);
      m_radius.resize(rows);
      m_scale.resize(rows);
      m_equation.resize(rows);
      m_unknown.resize(columns);
    }
  }

  // For fewer rows and columns than at first, or as many; only where their numbers are not known to the compiler.
  void resize(int rows, int columns)
  {
    static_assert(size == 0);
    m_rows = rows;
    m_columns = columns;
  }

  int rows() const { return size > 0 ? size : m_rows; }
  int columns() const { return size > 0 ? size : m_columns; }

  int rank() const { return m_rank; }
  // Of a row, those with a pivot first.
  int equation(int row) const { return m_equation[row]; }
  // That a row with a pivot was solved for.
  int unknown(int row) const { return m_unknown[row]; }
  // Of the inverse: the part that a row takes of the equation of another one.
  double part(int row, int of) const { return of < m_rank ? m_entries[row * columns() + of] : row == of ? 1 : 0; }

  // row_size: the sum of the absolute values of the row.
  void set_row(int i, const double* row, double row_size, double radius)
  {
    for (int k = 0; k < columns(); ++k)
      m_entries[i * columns() + k] = row[k];
    m_radius[i] = radius;
    const double total = row_size + 2 * radius;
    m_scale[i] = total > 0 ? 1 / total : 0;
  }

  void run()
  {
    for (int i = 0; i < rows(); ++i)
      m_equation[i] = i;
    for (int k = 0; k < columns(); ++k)
      m_unknown[k] = k;
    m_rank = 0;
    const auto step = [&](auto place) {
      if (m_rank == place && bring_pivot_to(place)) {
        eliminate(place);
        m_rank = place + 1;
      }
    };
    if constexpr (size > 0)
      unroll<size>(step);
    else
      for (int place = 0; place < (std::min)(m_rows, m_columns); ++place)
        step(place);
  }

private:
  double& entry(int i, int k) { return m_entries[i * columns() + k]; }

  // Looks for the largest weight of the rows and columns from a place on; false when there is none.
  template <class Place>
  BOOST_FORCEINLINE bool bring_pivot_to(Place place)
  {
    int row = -1;
    double best = 1e-16;
    for (int i = place; i < rows(); ++i) {
      double largest = 0;
      for (int k = place; k < columns(); ++k)
        largest = greater(largest, std::abs(entry(i, k)));
      if (const double weight = largest * m_scale[i]; weight > best && 2 * m_radius[i] < largest) {
        best = weight;
        row = i;
      }
    }
    if (row < 0)
      return false;
    for (int i = place + 1; i < rows(); ++i)
      if (i == row)
        swap_rows(place, i);
    for (int k = place + 1; k < columns(); ++k)
      if (std::abs(entry(place, k)) > std::abs(entry(place, place)))
        swap_columns(place, k);
    return true;
  }

  BOOST_FORCEINLINE void swap_rows(int i, int other)
  {
    std::swap(m_equation[i], m_equation[other]);
    std::swap(m_radius[i], m_radius[other]);
    std::swap(m_scale[i], m_scale[other]);
    for (int k = 0; k < columns(); ++k)
      std::swap(entry(i, k), entry(other, k));
  }

  BOOST_FORCEINLINE void swap_columns(int k, int other)
  {
    std::swap(m_unknown[k], m_unknown[other]);
    for (int i = 0; i < rows(); ++i)
      std::swap(entry(i, k), entry(i, other));
  }

  // Solves the row of a pivot for its unknown, which leaves the other rows.
  template <class Place>
  BOOST_FORCEINLINE void eliminate(Place place)
  {
    const double factor = 1 / entry(place, place);
    entry(place, place) = 1;
    for (int k = 0; k < columns(); ++k)
      entry(place, k) *= factor;
    m_radius[place] *= std::abs(factor);
    for (int i = 0; i < rows(); ++i) {
      if (i == place || (size == 0 && entry(i, place) == 0))
        continue;
      const double a = std::exchange(entry(i, place), 0.0);
      for (int k = 0; k < columns(); ++k)
        entry(i, k) -= a * entry(place, k);
      m_radius[i] += std::abs(a) * m_radius[place];
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_ROW_ELIMINATION_H
