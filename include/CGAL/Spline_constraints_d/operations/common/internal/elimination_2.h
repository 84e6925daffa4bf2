// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ELIMINATION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ELIMINATION_2_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// Homogeneous coordinates of the coefficients of a piece of a curve without breaks, in the powers of a parameter. The
// last one is not zero.
inline std::vector<std::array<Exact_rational, 3>> power_coefficients(const Spline_patch<2>& piece)
{
  std::vector<std::array<Exact_rational, 3>> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const Exact_function& f = i < 2 ? piece.numerators()[i] : piece.weight();
    const std::vector<Exact_rational> powers =
        Bernstein_tensor<Exact_rational>({f.degree(0)}, f.coefficients()).power_coefficients();
    result.resize((std::max)(result.size(), powers.size()), {Exact_rational(0), Exact_rational(0), Exact_rational(0)});
    for (std::size_t k = 0; k < powers.size(); ++k)
      result[k][i] = powers[k];
  }
  while (result.size() > 1 &&
         std::all_of(result.back().begin(), result.back().end(), [](const Exact_rational& x) { return x == 0; }))
    result.pop_back();
  return result;
}

using Function_matrix = std::vector<std::vector<Exact_function>>;

// By the first row.
inline Exact_function determinant(const Function_matrix& rows)
{
  if (rows.size() == 1)
    return rows[0][0];
  std::optional<Exact_function> result;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    Function_matrix minor(rows.begin() + 1, rows.end());
    for (std::vector<Exact_function>& row : minor)
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
    const Exact_function term = rows[0][j] * determinant(minor);
    result = !result ? term : j % 2 == 0 ? *result + term : *result - term;
  }
  return *result;
}

/*
For a point (X : Y : W) and a planar curve D(s) = (x : y : w), given by its coefficients in powers of s: the vectors
whose inner products with (X, Y, W) are the entries of the Bezout matrix of D at the point, in rows one after the other.

Where the point is D(s), the polynomials x(s) W - w(s) X and y(s) W - w(s) Y have the zero s in common, and so their
Bezout matrix is singular, and (1, s, s^2, ...) in its kernel. With the factor W taken out, its entries are the sums of
the determinants of (X, Y, W) and two coefficients of D.
*/
template <class Number>
std::vector<std::array<Number, 3>> bezout_vectors(const std::vector<std::array<Number, 3>>& c)
{
  const std::size_t n = c.size() - 1;
  std::vector<std::array<Number, 3>> result;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      std::array<Number, 3>& sum = result.emplace_back(std::array{Number(0), Number(0), Number(0)});
      for (std::size_t k = i + j + 1 < n ? 0 : i + j + 1 - n; k <= (std::min)(i, j); ++k) {
        const auto &a = c[i + j + 1 - k], &b = c[k];
        for (std::size_t m = 0; m < 3; ++m) {
          const std::size_t next = (m + 1) % 3, last = (m + 2) % 3;
          sum[m] += Number(a[next] * b[last] - a[last] * b[next]);
        }
      }
    }
  return result;
}

// Of a piece C of a planar curve and a piece D of another one, of degree four at most, both without breaks: a matrix of
// functions on C that is singular where C has a point on D, the Bezout matrix of D at C(t). None for other degrees.
inline Function_matrix bezout_matrix(const Spline_patch<2>& curve, const Spline_patch<2>& other)
{
  constexpr std::size_t most = 4;
  const std::vector<std::array<Exact_rational, 3>> c = power_coefficients(other);
  const std::size_t n = c.size() - 1;
  if (n > most)
    return {};
  const std::vector<std::array<Exact_rational, 3>> vectors = bezout_vectors(c);
  Function_matrix rows(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const std::array<Exact_rational, 3>& v = vectors[i * n + j];
      rows[i].push_back(curve.numerators()[0] * v[0] + curve.numerators()[1] * v[1] + curve.weight() * v[2]);
    }
  return rows;
}

// A polynomial that is zero where one piece has a point on another one. It is also zero for points of the curve that
// the other one is a part of, and everywhere if both are parts of this curve.
inline std::optional<Exact_function> eliminated(const Spline_patch<2>& curve, const Spline_patch<2>& other)
{
  const Function_matrix rows = bezout_matrix(curve, other);
  return rows.empty() ? std::nullopt : std::optional(determinant(rows));
}

/*
Pairs of functions on a piece: at a simple zero of the eliminated polynomial, their quotient, where it is defined, is
the parameter from 0 to 1 of the point on the other piece; outside of this interval, or if all divisors are zero, there
is none.

There, the Bezout matrix has corank one, as with a larger one its determinant had a multiple zero, and the cofactors of
each row are in the kernel. A line is linear in its parameter itself.
*/
inline std::vector<std::array<Exact_function, 2>> parameter_quotients(const Spline_patch<2>& curve,
                                                                      const Spline_patch<2>& other)
{
  const Function_matrix rows = bezout_matrix(curve, other);
  std::vector<std::array<Exact_function, 2>> result;
  if (rows.size() == 1) {
    const std::vector<std::array<Exact_rational, 3>> line = power_coefficients(other);
    for (const std::size_t i : {0, 1}) {
      const auto equation = [&](std::size_t k) {
        return curve.weight() * line[k][i] - curve.numerators()[i] * line[k][2];
      };
      result.push_back({equation(0) * Exact_rational(-1), equation(1)});
    }
    return result;
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto minor = [&](std::size_t j) {
      Function_matrix rest = rows;
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
      for (std::vector<Exact_function>& row : rest)
        row.erase(row.begin() + static_cast<std::ptrdiff_t>(j));
      return determinant(rest);
    };
    result.push_back({minor(1) * Exact_rational(-1), minor(0)});
  }
  return result;
}

// Where a polynomial may be zero.
struct Zero_places
{
  bool at_lower_end = false, at_upper_end = false, elsewhere = false;

  bool are_none() const { return !at_lower_end && !at_upper_end && !elsewhere; }
};

// Of a polynomial on its domain, by the signs of its coefficients: inside, it has none if these have one sign. \pre The
// function has no breaks.
inline Zero_places zero_places(const Exact_function& f, int depth = 12)
{
  const auto is_not_zero = [](const Exact_rational& x) { return x != 0; };
  const std::vector<Exact_rational>& values = f.coefficients();
  const auto first = std::find_if(values.begin(), values.end(), is_not_zero);
  if (first == values.end())
    return {true, true, true};
  if (std::none_of(first, values.end(), [&](const Exact_rational& x) { return CGAL::sign(x) == -CGAL::sign(*first); }))
    return {first != values.begin(), !is_not_zero(values.back()), false};
  if (depth == 0)
    return {true, true, true};
  const auto [begin, end] = f.domain(0);
  const auto [left, right] = f.split(0, middle_of({begin, end}));
  const Zero_places before = zero_places(left, depth - 1);
  if (before.elsewhere || before.at_upper_end)
    return {true, true, true};
  const Zero_places after = zero_places(right, depth - 1);
  return {before.at_lower_end, after.at_upper_end, after.elsewhere || after.at_lower_end};
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ELIMINATION_2_H
