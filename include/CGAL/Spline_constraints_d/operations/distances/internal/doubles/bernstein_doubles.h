// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_BERNSTEIN_DOUBLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_BERNSTEIN_DOUBLES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
Bernstein coefficients of functions of at most two variables over the unit square, in doubles whose errors the caller
bounds. The second variable is fastest; an axis that is not there has degree 0.

Whatever the rounding mode, a rounded operation errs by `unit` times its result at most.
*/
constexpr double unit = 0x1p-52;

using Degrees = std::array<int, 2>;

inline std::size_t size_of(const Degrees& degrees)
{
  return static_cast<std::size_t>((degrees[0] + 1) * (degrees[1] + 1));
}

// Binomial coefficients are doubles up to here.
constexpr int greatest_product_degree = 52;

inline double binomial(int n, int k)
{
  static constexpr auto table = [] {
    std::array<std::array<double, greatest_product_degree + 1>, greatest_product_degree + 1> result{};
    for (int i = 0; i <= greatest_product_degree; ++i) {
      result[i][0] = result[i][i] = 1;
      for (int j = 1; j < i; ++j)
        result[i][j] = result[i - 1][j - 1] + result[i - 1][j];
    }
    return result;
  }();
  return table[n][k];
}

inline double greatest_magnitude(const double* begin, std::size_t size)
{
  double result = 0;
  for (std::size_t i = 0; i < size; ++i)
    result = (std::max)(result, std::abs(begin[i]));
  return result;
}

// The coefficients of functions of the same degrees times those of their monomials, which are multiplied like
// polynomials in powers.
class Scaled_products
{
  using Buffer = boost::container::small_vector<double, 64>;

  Degrees m_degrees;
  Buffer m_first, m_second;

public:
  explicit Scaled_products(const Degrees& degrees)
    : m_degrees(degrees), m_first(size_of(degrees)), m_second(size_of(degrees))
  {}

  // An error of a product of functions that are at most x and y, beside those of its factors, is at most this times xy.
  double relative_error() const { return unit * static_cast<double>(size_of(m_degrees) + 8); }

  // Adds the coefficients of a product times those of their monomials.
  void add(const double* f, const double* g, double* product)
  {
    scale(f, m_first);
    scale(g, m_second);
    const int rows = m_degrees[0], columns = m_degrees[1], width = 2 * columns + 1;
    for (int i = 0, k = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j, ++k) {
        const double factor = m_first[static_cast<std::size_t>(k)];
        const double* other = m_second.data();
        for (int r = 0; r <= rows; ++r) {
          double* out = product + (i + r) * width + j;
          for (int s = 0; s <= columns; ++s)
            out[s] += factor * *other++;
        }
      }
  }

  // Bernstein coefficients from what has been added.
  void finish(double* product) const
  {
    for (int i = 0, k = 0; i <= 2 * m_degrees[0]; ++i)
      for (int j = 0; j <= 2 * m_degrees[1]; ++j, ++k)
        product[k] /= binomial(2 * m_degrees[0], i) * binomial(2 * m_degrees[1], j);
  }

private:
  void scale(const double* f, Buffer& result) const
  {
    for (int i = 0, k = 0; i <= m_degrees[0]; ++i)
      for (int j = 0; j <= m_degrees[1]; ++j, ++k)
        result[static_cast<std::size_t>(k)] = f[k] * (binomial(m_degrees[0], i) * binomial(m_degrees[1], j));
  }
};

// Replaces coefficients by those of the part before a number along an axis, and writes those of the part behind it.
// Either has an error that is greater by `split_error()` times the greatest coefficient.
inline void split(const Degrees& degrees, int axis, double at, double* lower, double* upper)
{
  const int step = axis == 0 ? degrees[1] + 1 : 1, lines = degrees[1 - axis] + 1, skip = axis == 0 ? 1 : degrees[1] + 1;
  const int n = degrees[axis];
  const double before = 1 - at; // exact: both have few digits
  for (int line = 0; line < lines; ++line) {
    double *low = lower + line * skip, *high = upper + line * skip;
    for (int r = 0; r < n; ++r) {
      high[(n - r) * step] = low[n * step];
      for (int k = n; k > r; --k)
        low[k * step] = before * low[(k - 1) * step] + at * low[k * step];
    }
    high[0] = low[n * step];
  }
}

inline double split_error(const Degrees& degrees, int axis) { return 3 * unit * degrees[axis]; }

// Keeps the coefficients of the face at an end (0 or 1) of an axis, whose degree is 0 then.
inline void restrict_to_face(Degrees& degrees, int axis, int side, double* coefficients)
{
  const std::size_t columns = static_cast<std::size_t>(degrees[1] + 1);
  if (axis == 0)
    std::copy_n(coefficients + (side == 0 ? 0 : static_cast<std::size_t>(degrees[0]) * columns), columns, coefficients);
  else
    for (int i = 0; i <= degrees[0]; ++i)
      coefficients[i] = coefficients[static_cast<std::size_t>(i) * columns + (side == 0 ? 0 : columns - 1)];
  degrees[axis] = 0;
}

struct Double_range
{
  double lower, upper;

  void add(double x)
  {
    lower = (std::min)(lower, x);
    upper = (std::max)(upper, x);
  }
  Interval widened(double error, double factor) const
  {
    return Interval(lower - error, upper + error) * Interval(factor); // rounded outward: the error is an upper bound
  }
};

// Ranges of Bernstein coefficients, and of those of derivatives. With `error` of the coefficients themselves, which is
// at least eight units of the greatest one.
class Coefficient_ranges
{
  const Degrees& m_degrees;
  const double* m_begin;
  double m_error;

public:
  Coefficient_ranges(const Degrees& degrees, const double* begin, double error)
    : m_degrees(degrees), m_begin(begin), m_error(error)
  {}

  Interval first(int axis) const
  {
    return over(axis, 1, [](const double* p, int step) { return p[step] - p[0]; })
        .widened(3 * m_error, m_degrees[axis]);
  }

  Interval second(int axis) const
  {
    if (m_degrees[axis] < 2)
      return Interval(0);
    return over(axis, 2, [](const double* p, int step) { return p[2 * step] - 2 * p[step] + p[0]; })
        .widened(6 * m_error, m_degrees[axis] * (m_degrees[axis] - 1));
  }

  // The mixed derivative.
  Interval mixed() const
  {
    if (m_degrees[0] < 1 || m_degrees[1] < 1)
      return Interval(0);
    const int width = m_degrees[1] + 1;
    const auto difference = [&](int i, int j) {
      const double* p = m_begin + i * width + j;
      return (p[width + 1] - p[width]) - (p[1] - p[0]);
    };
    Double_range result{difference(0, 0), difference(0, 0)};
    for (int i = 0; i < m_degrees[0]; ++i)
      for (int j = 0; j < m_degrees[1]; ++j)
        result.add(difference(i, j));
    return result.widened(6 * m_error, m_degrees[0] * m_degrees[1]);
  }

private:
  template <class Difference>
  Double_range over(int axis, int order, const Difference& difference) const
  {
    const int width = m_degrees[1] + 1, step = axis == 0 ? width : 1;
    const int rows = m_degrees[0] - (axis == 0 ? order : 0), columns = m_degrees[1] - (axis == 1 ? order : 0);
    Double_range result{difference(m_begin, step), difference(m_begin, step)};
    for (int i = 0; i <= rows; ++i)
      for (int j = 0; j <= columns; ++j)
        result.add(difference(m_begin + i * width + j, step));
    return result;
  }
};

// A function with its derivatives, by the orders along both axes.
template <class Number>
struct Second_jet
{
  Number value, first[2], second[2], mixed;
};

// By de Casteljau's algorithm: value, first and second derivative of a polynomial of degree n at x, from coefficients
// that are overwritten. Errors of coefficients do not grow, as their weights are positive.
template <class Number, class Parameter>
std::array<Number, 3> univariate_jet(Number* c, int n, const Parameter& x)
{
  const Number before = Number(1) - Number(x);
  Number second(0), first(0);
  for (int r = n; r > 0; --r) {
    if (r == 2)
      second = Number(n * (n - 1)) * (c[2] - c[1] - (c[1] - c[0]));
    if (r == 1)
      first = Number(n) * (c[1] - c[0]);
    for (int k = 0; k < r; ++k)
      c[k] = before * c[k] + x * c[k + 1];
  }
  return {c[0], first, second};
}

// Coefficients are read by coefficient(i).
template <class Number, class Coefficient, class Parameter>
Second_jet<Number> jet_at(const Degrees& degrees, const Coefficient& coefficient, const std::array<Parameter, 2>& x)
{
  using Buffer = boost::container::small_vector<Number, 16>;
  const std::size_t columns = static_cast<std::size_t>(degrees[1] + 1), rows = static_cast<std::size_t>(degrees[0] + 1);
  Buffer value(rows, boost::container::default_init);
  if (columns == 1) {
    for (std::size_t i = 0; i < rows; ++i)
      value[i] = coefficient(i);
    const auto jet = univariate_jet(value.data(), degrees[0], x[0]);
    return {jet[0], {jet[1], Number(0)}, {jet[2], Number(0)}, Number(0)};
  }
  Buffer row(columns, boost::container::default_init), first(rows, boost::container::default_init),
      second(rows, boost::container::default_init);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j)
      row[j] = coefficient(i * columns + j);
    const auto jet = univariate_jet(row.data(), degrees[1], x[1]);
    value[i] = jet[0];
    first[i] = jet[1];
    second[i] = jet[2];
  }
  const std::array<Number, 3> zero{Number(0), Number(0), Number(0)};
  const auto of_value = univariate_jet(value.data(), degrees[0], x[0]),
             of_first = degrees[1] > 0 ? univariate_jet(first.data(), degrees[0], x[0]) : zero,
             of_second = degrees[1] > 1 ? univariate_jet(second.data(), degrees[0], x[0]) : zero;
  return {of_value[0], {of_value[1], of_first[0]}, {of_value[2], of_second[0]}, of_first[1]};
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_BERNSTEIN_DOUBLES_H
