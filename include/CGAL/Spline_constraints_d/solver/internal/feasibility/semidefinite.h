// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SEMIDEFINITE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SEMIDEFINITE_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Whether a symmetric matrix, given row by row, plus a diagonal is positive semidefinite, by a Cholesky factorisation in
doubles. The matrix that it factors is smaller by more than its rounding errors in any rounding mode, which are at most
(n + 1) units of the last place times the trace (S. M. Rump, Verification of positive definiteness, BIT 46 (2006)):
`true` is a proof. Rows that are zero do not matter.
*/
inline bool is_certainly_semidefinite(const std::vector<double>& matrix, const std::vector<double>& diagonal)
{
  const std::size_t all = diagonal.size();
  std::vector<std::size_t> rows;
  double trace = 0;
  for (std::size_t i = 0; i < all; ++i) {
    bool is_zero = diagonal[i] == 0;
    for (std::size_t j = 0; j < all; ++j)
      is_zero = is_zero && matrix[i * all + j] == 0;
    if (!is_zero)
      rows.push_back(i);
    trace += std::abs(matrix[i * all + i]) + std::abs(diagonal[i]);
  }
  const std::size_t n = rows.size();
  if (n == 0)
    return true;
  const double slack = 4 * (static_cast<double>(n) + 4) * 0x1p-52 * trace + 0x1p-960; // the second part: of underflow
  if (!(slack < HUGE_VAL))
    return false;
  std::vector<double> factor(n * n, 0.0);
  for (std::size_t j = 0; j < n; ++j) {
    double pivot = matrix[rows[j] * all + rows[j]] + diagonal[rows[j]] - slack;
    for (std::size_t k = 0; k < j; ++k)
      pivot -= factor[j * n + k] * factor[j * n + k];
    if (!(pivot > 0))
      return false;
    const double root = factor[j * n + j] = std::sqrt(pivot);
    for (std::size_t i = j + 1; i < n; ++i) {
      double sum = matrix[rows[i] * all + rows[j]];
      for (std::size_t k = 0; k < j; ++k)
        sum -= factor[i * n + k] * factor[j * n + k];
      factor[i * n + j] = sum / root;
    }
  }
  return true;
}

// A small number that makes a matrix plus a diagonal plus this multiple of the unit matrix certainly semidefinite;
// infinite where none is found.
inline double semidefinite_shift(const std::vector<double>& matrix, const std::vector<double>& diagonal)
{
  const std::size_t n = diagonal.size();
  double size = 0;
  for (std::size_t i = 0; i < n; ++i) {
    double row = std::abs(diagonal[i]);
    for (std::size_t j = 0; j < n; ++j)
      row += std::abs(matrix[i * n + j]);
    size = (std::max)(size, row);
  }
  if (!(size < HUGE_VAL))
    return HUGE_VAL;
  std::vector<double> shifted(n);
  const auto is_enough = [&](double shift) {
    for (std::size_t i = 0; i < n; ++i)
      shifted[i] = diagonal[i] + shift;
    return is_certainly_semidefinite(matrix, shifted);
  };
  for (const double little : {0.0, 0x1p-44 * size})
    if (is_enough(little))
      return little;
  double too_small = 0, enough = 2 * size; // by diagonal dominance
  if (!is_enough(enough))
    return HUGE_VAL;
  for (int step = 0; step < 12; ++step) {
    const double middle = 0.5 * (too_small + enough);
    (is_enough(middle) ? enough : too_small) = middle;
  }
  return enough;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SEMIDEFINITE_H
