// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_KRAWCZYK_OPERATOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_KRAWCZYK_OPERATOR_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/exact_enclosures.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// How `verify` proves zeros: exact like all of it, and shared with nothing else.
namespace verification {

// Row-major.
struct Matrix
{
  std::size_t rows, columns;
  std::vector<Exact_rational> entries;

  Matrix(std::size_t rows, std::size_t columns)
    : rows(rows), columns(columns), entries(rows * columns, Exact_rational(0))
  {}
  Exact_rational& operator()(std::size_t i, std::size_t j) { return entries[i * columns + j]; }
  const Exact_rational& operator()(std::size_t i, std::size_t j) const { return entries[i * columns + j]; }
};

// Gauss-Jordan on (left | right): right becomes left^-1 right. False when left is singular.
inline bool solve_linear(Matrix& left, Matrix& right)
{
  for (std::size_t c = 0; c < left.columns; ++c) {
    std::size_t pivot = c;
    while (pivot < left.rows && is_zero(left(pivot, c)))
      ++pivot;
    if (pivot == left.rows)
      return false;
    const Exact_rational factor = Exact_rational(1) / left(pivot, c);
    for (Matrix* matrix : {&left, &right})
      for (std::size_t k = 0; k < matrix->columns; ++k) {
        std::swap((*matrix)(c, k), (*matrix)(pivot, k));
        (*matrix)(c, k) *= factor;
      }
    for (std::size_t i = 0; i < left.rows; ++i)
      if (const Exact_rational multiple = left(i, c); i != c && !is_zero(multiple))
        for (Matrix* matrix : {&left, &right})
          for (std::size_t k = 0; k < matrix->columns; ++k)
            if (!is_zero((*matrix)(c, k)))
              (*matrix)(i, k) -= multiple * (*matrix)(c, k);
  }
  return true;
}

// Any matrix near an inverse serves: digits beyond these only cost time. In a tiny box derivatives may nearly be
// dependent, up to about its width.
inline int digits_for(const Box& box)
{
  constexpr long digits = 128;
  long result = digits;
  for (const Range& range : box)
    if (const Exact_rational width = range.upper - range.lower; !is_zero(width))
      result = (std::max)(result, 2 * (bit_length(denominator_of(width)) - bit_length(numerator_of(width))));
  return static_cast<int>(result);
}

// A left inverse of a matrix, rounded; empty when it has none.
inline Matrix rounded_left_inverse(const Matrix& matrix, int digits)
{
  const std::size_t m = matrix.rows, n = matrix.columns;
  Matrix square(n, n), inverse(n, m);
  if (m == n) {
    square = matrix;
    for (std::size_t i = 0; i < n; ++i)
      inverse(i, i) = Exact_rational(1);
  } else   // least squares
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        inverse(j, i) = matrix(i, j);
        for (std::size_t k = 0; k < n; ++k)
          square(j, k) += matrix(i, j) * matrix(i, k);
      }
  if (!solve_linear(square, inverse))
    return Matrix(0, 0);
  for (Exact_rational& entry : inverse.entries)
    entry = round_to_dyadic(entry, digits);
  return inverse;
}

using Axes = std::vector<std::size_t>;

// The parts of a box between the breaks of the functions, where each of them is one polynomial.
inline std::vector<Box> parts_between_breaks(const Functions& functions, const Box& box)
{
  std::vector<Box> parts{box};
  for (const Spline_function* function : functions)
    for (const Spline_term& term : function->terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        for (const Exact_rational& at : term.breaks[j]) {
          const std::size_t axis = term.variables[j];
          for (std::size_t i = parts.size(); i-- > 0;)
            if (parts[i][axis].lower < at && at < parts[i][axis].upper) {
              parts.push_back(parts[i]);
              parts[i][axis].upper = at;
              parts.back()[axis].lower = at;
            }
        }
  return parts;
}

// The functions on a part of a box: Taylor's polynomials about the middle of the part.
struct Part
{
  Point radius;
  Taylor_coefficients coefficients;

  Part(const Functions& functions, const Box& box)
    : radius(radius_of(box)), coefficients(taylor_coefficients(functions, middle_of(box)))
  {}

  // The derivatives in the middle, functions x axes.
  Matrix jacobian(std::size_t functions, const Axes& axes) const
  {
    Matrix result(functions, axes.size());
    for (std::size_t j = 0; j < axes.size(); ++j) {
      std::vector<int> exponents(radius.size(), 0);
      exponents[axes[j]] = 1;
      if (const auto linear = coefficients.find(exponents); linear != coefficients.end())
        for (std::size_t k = 0; k < functions; ++k)
          result(k, j) = linear->second[k];
    }
    return result;
  }

  // Bounds on the entries of |I - C J| for the derivatives J on the part. The coefficients of C F are formed before
  // they are bounded, since the rows of C J cancel there.
  Matrix distance_from_identity(const Matrix& inverse, const Axes& axes) const
  {
    const std::size_t n = axes.size();
    const Matrix middle = jacobian(inverse.columns, axes);
    Matrix result(n, n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) {
        Exact_rational entry(i == j ? 1 : 0);
        for (std::size_t k = 0; k < inverse.columns; ++k)
          entry -= inverse(i, k) * middle(k, j);
        result(i, j) = absolute(entry);
      }
    for (const auto& [exponents, values] : coefficients)
      if (std::accumulate(exponents.begin(), exponents.end(), 0) > 1)
        add_deviation(inverse, axes, exponents, values, result);
    return result;
  }

private:
  // The largest derivatives on the part of C c x^exponents.
  void add_deviation(const Matrix& inverse, const Axes& axes, const std::vector<int>& exponents, const Point& values,
                     Matrix& sum) const
  {
    Point combined(axes.size(), Exact_rational(0));
    for (std::size_t i = 0; i < axes.size(); ++i) {
      for (std::size_t k = 0; k < values.size(); ++k)
        combined[i] += inverse(i, k) * values[k];
      combined[i] = absolute(combined[i]);
    }
    for (std::size_t j = 0; j < axes.size(); ++j) {
      Exact_rational derivative(exponents[axes[j]]);
      for (std::size_t axis = 0; axis < exponents.size() && !is_zero(derivative); ++axis)
        for (int power = exponents[axis] - (axis == axes[j] ? 1 : 0); power > 0; --power)
          derivative *= radius[axis];
      if (!is_zero(derivative))
        for (std::size_t i = 0; i < axes.size(); ++i)
          sum(i, j) += combined[i] * derivative;
    }
  }
};

// The middles of the ranges that the entries of several matrices span, rounded.
inline Matrix middle_of(const std::vector<Matrix>& matrices, int digits)
{
  Matrix result = matrices.front();
  for (std::size_t e = 0; e < result.entries.size(); ++e) {
    Range range{result.entries[e], result.entries[e]};
    for (const Matrix& matrix : matrices)
      extend(range, matrix.entries[e], matrix.entries[e]);
    result.entries[e] = round_to_dyadic(Exact_rational((range.lower + range.upper) / Exact_rational(2)), digits);
  }
  return result;
}

// Krawczyk's operator K = y - C F(y) + (I - C J(B)) (B - y) with the middle y of the box B, for functions of the
// unknowns `axes`; the ranges of the others are single numbers. I - C J is bounded between the breaks first. Gives the
// ranges of these unknowns, or nothing when the middle of the derivatives has no inverse C.
inline Box krawczyk_image(const Functions& functions, const Axes& axes, const Box& box)
{
  const Point centre = middle_of(box), radius = radius_of(box);
  Box at_centre;
  for (const Exact_rational& x : centre)
    at_centre.push_back({x, x});
  Point value;   // any piece at the centre: the function is continuous
  for (const Spline_function* function : functions)
    value.push_back(values(*function, at_centre).lower);
  std::vector<Part> parts;
  std::vector<Matrix> jacobians, distances;
  for (const Box& part : parts_between_breaks(functions, box)) {
    parts.emplace_back(functions, part);
    jacobians.push_back(parts.back().jacobian(functions.size(), axes));
  }
  const int digits = digits_for(box);
  const Matrix inverse = rounded_left_inverse(middle_of(jacobians, digits), digits);
  for (std::size_t p = 0; p < parts.size() && inverse.rows > 0; ++p)
    distances.push_back(parts[p].distance_from_identity(inverse, axes));
  Box image;
  for (std::size_t i = 0; i < inverse.rows; ++i) {
    Exact_rational middle = centre[axes[i]], deviation(0);
    for (std::size_t k = 0; k < value.size(); ++k)
      middle -= inverse(i, k) * value[k];
    for (std::size_t j = 0; j < axes.size(); ++j) {
      Exact_rational largest(0);
      for (const Matrix& distance : distances)
        largest = (std::max)(largest, distance(i, j));
      deviation += largest * radius[axes[j]];
    }
    image.push_back({Exact_rational(middle - deviation), Exact_rational(middle + deviation)});
  }
  return image;
}

} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_KRAWCZYK_OPERATOR_H
