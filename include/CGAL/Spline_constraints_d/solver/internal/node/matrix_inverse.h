// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_MATRIX_INVERSE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_MATRIX_INVERSE_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <boost/config.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// `size` is the number of rows when that is known to the compiler, else 0.
template <int size>
bool invert_fixed(int rows, double* work, double* inverse, double least_pivot)
{
  const int n = size > 0 ? size : rows;
  double largest = 0;
  for (int i = 0; i < n * n; ++i) {
    largest = std::abs(work[i]) > largest ? std::abs(work[i]) : largest;
    inverse[i] = i % (n + 1) == 0 ? 1 : 0;
  }
  for (int c = 0; c < n; ++c) {
    int pivot = c;
    for (int i = c + 1; i < n; ++i)
      if (std::abs(work[i * n + c]) > std::abs(work[pivot * n + c]))
        pivot = i;
    if (!(std::abs(work[pivot * n + c]) > least_pivot * largest))
      return false;
    for (int k = 0; pivot != c && k < n; ++k) {
      std::swap(work[c * n + k], work[pivot * n + k]);
      std::swap(inverse[c * n + k], inverse[pivot * n + k]);
    }
    const double factor = 1 / work[c * n + c];
    for (int k = 0; k < n; ++k) {
      work[c * n + k] *= factor;
      inverse[c * n + k] *= factor;
    }
    for (int i = 0; i < n; ++i)
      if (const double a = work[i * n + c]; i != c && a != 0)
        for (int k = 0; k < n; ++k) {
          work[i * n + k] -= a * work[c * n + k];
          inverse[i * n + k] -= a * inverse[c * n + k];
        }
  }
  return true;
}

// Two rows by Cramer's rule, with one division; the pivots are those of elimination.
bool invert_pair(const double* a, double* inverse, double least_pivot);

/*
The approximate inverse of a small row-major matrix by Gauss-Jordan elimination with row pivoting, without allocation
(Eigen's inverse makes a temporary); false when a pivot is smaller than `least_pivot` beside the largest entry. Whoever
uses it measures what it got wrong. `work` and `inverse` are two; the first is destroyed.
*/
bool invert(int size, std::vector<double>& work, std::vector<double>& inverse, double least_pivot = 1e-14);

// What a bound on products needs of the range of a derivative.
struct Derivative_range
{
  double middle, radius, size;

  Derivative_range() = default;
  Derivative_range(double lower, double upper)
    : middle(0.5 * (lower + upper)), radius(0.5 * (upper - lower)), size(std::abs(lower) + std::abs(upper))
  {}
};

/*
Row j of a bound on |I - C J|, for a row of C and the ranges `range(i, k)` of the derivatives of m functions by n
unknowns: fills n entries and returns their sum, in any rounding mode.
*/
template <class Range>
BOOST_FORCEINLINE double contraction_row(int n, int m, int j, const double* inverse, const Range& range,
                                         double* entries)
{
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    double middle = j == k ? 1 : 0, radius = 0, size = middle;
    for (int i = 0; i < m; ++i) {
      if (inverse[i] == 0)
        continue;
      const Derivative_range& derivative = range(i, k);
      middle -= inverse[i] * derivative.middle;
      radius += std::abs(inverse[i]) * derivative.radius;
      size += std::abs(inverse[i]) * derivative.size;
    }
    entries[k] = std::abs(middle) + radius + 0x1p-44 * size;   // also covers the additions below
    sum += entries[k];
  }
  return sum;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool invert_pair(const double* a, double* inverse, double least_pivot)
{
  const double first = greater(std::abs(a[0]), std::abs(a[2])),
               largest = greater(first, greater(std::abs(a[1]), std::abs(a[3])));
  const double determinant = a[0] * a[3] - a[1] * a[2], factor = 1 / determinant;
  inverse[0] = a[3] * factor;
  inverse[1] = -a[1] * factor;
  inverse[2] = -a[2] * factor;
  inverse[3] = a[0] * factor;
  return first > least_pivot * largest && std::abs(determinant) > least_pivot * largest * first;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool invert(int size, std::vector<double>& work, std::vector<double>& inverse,
                                           double least_pivot)
{
  if (size == 2)
    return invert_pair(work.data(), inverse.data(), least_pivot);
  bool is_regular = false;
  run_with_constant<4>(size, [&](auto constant) {
    is_regular = invert_fixed<constant>(size, work.data(), inverse.data(), least_pivot);
  });
  return is_regular;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_MATRIX_INVERSE_H
