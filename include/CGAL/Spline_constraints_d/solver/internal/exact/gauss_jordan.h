// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_GAUSS_JORDAN_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_GAUSS_JORDAN_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Gauss-Jordan elimination of a row-major matrix with `rank` pivots in its first `columns` columns, each the entry with
the largest `size(entry)` of the rows and columns that are left. The columns behind take part. The rows of the pivots
come first; the result tells for each of the first columns the row of its pivot, or -1. It is empty when all entries
that are left have the size zero before.
*/
template <class NT, class Size>
std::vector<int> gauss_jordan(std::vector<NT>& matrix, std::size_t length, std::size_t columns, std::size_t rank,
                              const Size& size)
{
  const std::size_t rows = matrix.size() / length;
  std::vector<int> row_of(columns, -1);
  for (std::size_t pivots = 0; pivots < rank; ++pivots) {
    std::size_t row = rows, column = columns;
    double largest = 0;
    for (std::size_t i = pivots; i < rows; ++i)
      for (std::size_t j = 0; j < columns; ++j)
        if (row_of[j] < 0)
          if (const double entry = size(matrix[i * length + j]); entry > largest) {
            largest = entry;
            row = i;
            column = j;
          }
    if (row == rows)
      return {};
    if (row != pivots)
      std::swap_ranges(matrix.begin() + pivots * length, matrix.begin() + (pivots + 1) * length,
                       matrix.begin() + row * length);
    row_of[column] = static_cast<int>(pivots);
    NT* const own = matrix.data() + pivots * length;
    const NT pivot = own[column];
    for (std::size_t k = 0; k < length; ++k)
      own[k] /= pivot;
    for (std::size_t i = 0; i < rows; ++i)
      if (i != pivots && size(matrix[i * length + column]) > 0) {
        const NT multiple = matrix[i * length + column];
        for (std::size_t k = 0; k < length; ++k)
          matrix[i * length + k] -= multiple * own[k];
      }
  }
  return row_of;
}

// The sign of the determinant of a square row-major matrix.
inline int sign_of_determinant(std::vector<Exact_rational> matrix, std::size_t size)
{
  int sign = 1;
  for (std::size_t k = 0; k < size; ++k) {
    std::size_t row = k;
    while (row < size && matrix[row * size + k] == 0)
      ++row;
    if (row == size)
      return 0;
    if (row != k) {
      std::swap_ranges(matrix.begin() + k * size, matrix.begin() + (k + 1) * size, matrix.begin() + row * size);
      sign = -sign;
    }
    const Exact_rational pivot = matrix[k * size + k];
    sign *= pivot < 0 ? -1 : 1;
    for (std::size_t i = k + 1; i < size; ++i) {
      const Exact_rational multiple = matrix[i * size + k] / pivot;
      for (std::size_t j = k; j < size; ++j)
        matrix[i * size + j] -= multiple * matrix[k * size + j];
    }
  }
  return sign;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_GAUSS_JORDAN_H
