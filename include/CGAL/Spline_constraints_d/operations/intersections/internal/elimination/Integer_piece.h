// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_INTEGER_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_INTEGER_PIECE_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
A piece of a curve without breaks, on [0,1]: homogeneous coordinates and, last, the weight, as polynomials with integer
coefficients, all times one positive number.
*/
template <int d>
class Integer_piece
{
  std::array<Integer_coefficients, d + 1> m_coordinates;

public:
  explicit Integer_piece(std::array<Integer_coefficients, d + 1> coordinates) : m_coordinates(std::move(coordinates)) {}

  // The part of a curve between two neighbouring breaks.
  Integer_piece(const Spline_patch<d>& curve, const Parameter_range& cell)
  {
    std::array<std::vector<Exact_rational>, d + 1> powers;
    Big_integer denominator(1);
    for (std::size_t i = 0; i <= d; ++i) {
      const Exact_function f = (i < d ? curve.numerators()[i] : curve.weight()).restricted(0, cell.first, cell.second);
      powers[i] = Bernstein_tensor<Exact_rational>({f.degree(0)}, f.coefficients()).power_coefficients();
      for (const Exact_rational& c : powers[i])
        extend_common_denominator(denominator, c);
    }
    Big_integer content(0);
    for (std::size_t i = 0; i <= d; ++i)
      for (const Exact_rational& c : powers[i]) {
        m_coordinates[i].push_back(numerator_over(c, denominator));
        content = gcd(content, m_coordinates[i].back());
      }
    for (Integer_coefficients& coordinate : m_coordinates) {
      for (Big_integer& c : coordinate)
        c /= content;
      remove_zeros(coordinate);
    }
  }

  const Integer_coefficients& operator[](std::size_t coordinate) const { return m_coordinates[coordinate]; }
  const Integer_coefficients& weight() const { return m_coordinates[d]; }

  std::size_t degree() const
  {
    std::size_t size = 1;
    for (const Integer_coefficients& coordinate : m_coordinates)
      size = (std::max)(size, coordinate.size());
    return size - 1;
  }

  // The homogeneous vectors of the coefficients.
  std::vector<std::array<Big_integer, d + 1>> vectors() const
  {
    std::vector<std::array<Big_integer, d + 1>> result(degree() + 1);
    for (std::size_t i = 0; i <= d; ++i)
      for (std::size_t k = 0; k < m_coordinates[i].size(); ++k)
        result[k][i] = m_coordinates[i][k];
    return result;
  }

  // With two linear forms of the coordinates.
  Integer_piece<2> projected(const std::array<std::array<int, d>, 2>& forms) const
  {
    std::array<Integer_coefficients, 3> result;
    for (std::size_t k = 0; k < 2; ++k)
      for (std::size_t i = 0; i < d; ++i)
        add_multiple(result[k], m_coordinates[i], Big_integer(forms[k][i]));
    result[2] = weight();
    for (Integer_coefficients& coordinate : result)
      remove_zeros(coordinate);
    return Integer_piece<2>(std::move(result));
  }

  // The derivative, times the square of the weight: x' w - x w'.
  std::array<Integer_coefficients, d> tangent() const
  {
    const Integer_coefficients w_slope = derivative(weight());
    std::array<Integer_coefficients, d> result;
    for (std::size_t i = 0; i < d; ++i) {
      add_signed_product(result[i], derivative(m_coordinates[i]), weight(), 1);
      add_signed_product(result[i], m_coordinates[i], w_slope, -1);
    }
    return result;
  }

  bool is_point() const
  {
    const std::array<Integer_coefficients, d> all = tangent();
    return std::all_of(all.begin(), all.end(), [](const Integer_coefficients& f) {
      return std::all_of(f.begin(), f.end(), [](const Big_integer& x) { return x == 0; });
    });
  }

  // The derivative in an end, times the square of the weight.
  std::array<Big_integer, d> end_tangent(bool end) const
  {
    const std::array<Integer_coefficients, d> all = tangent();
    std::array<Big_integer, d> result;
    for (std::size_t i = 0; i < d; ++i)
      result[i] = end_value(all[i], end);
    return result;
  }

  // The coordinates of an end, and the weight there, which is positive.
  std::array<Big_integer, d + 1> end_point(bool end) const
  {
    std::array<Big_integer, d + 1> result;
    for (std::size_t i = 0; i <= d; ++i)
      result[i] = end_value(m_coordinates[i], end);
    return result;
  }

private:
  static void remove_zeros(Integer_coefficients& f)
  {
    while (f.size() > 1 && f.back() == 0)
      f.pop_back();
  }

  static Big_integer end_value(const Integer_coefficients& f, bool end)
  {
    Big_integer result(0);
    for (std::size_t k = 0; k < (end ? f.size() : (std::min)(f.size(), std::size_t(1))); ++k)
      result += f[k];
    return result;
  }

  static Integer_coefficients derivative(const Integer_coefficients& f)
  {
    Integer_coefficients result;
    for (std::size_t k = 1; k < f.size(); ++k)
      result.push_back(Big_integer(f[k] * k));
    return result;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELIMINATION_INTEGER_PIECE_H
