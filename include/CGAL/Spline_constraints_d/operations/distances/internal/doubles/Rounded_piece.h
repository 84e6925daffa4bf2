// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_ROUNDED_PIECE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_ROUNDED_PIECE_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/bernstein_doubles.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Coefficients in doubles, with a bound of their errors, and of what they are.
struct Rounded_tensor
{
  const double* begin = nullptr;
  double error = 0, greatest = 0;
};

/*
A Bezier piece x/w of an operand in doubles, and what its squared distances from anything are made of: with a point r
next to it and z = x - r w, the forms |z|^2, z w and w^2, all in twice the degree. Those of a polynomial piece have w =
1, and no w^2.
*/
template <int d>
struct Rounded_piece
{
  Degrees degrees{0, 0}, form_degrees{0, 0};
  int axes = 0;
  std::array<Rounded_tensor, d> points; // the numerators
  Rounded_tensor weights;
  std::array<double, d> reference{};
  Rounded_tensor square, weight_square;
  std::array<Rounded_tensor, d> linear;

  bool is_rational() const { return weights.begin != nullptr; }
};

// That of a point.
template <int d>
class Rounded_point
{
  std::array<double, d> m_coordinates;
  double m_zero = 0;
  Rounded_piece<d> m_piece;

public:
  // With a bound of the errors of its coordinates.
  explicit Rounded_point(const std::array<double, d>& coordinates, double error = 0) : m_coordinates(coordinates)
  {
    for (int i = 0; i < d; ++i) {
      m_piece.points[i] = {&m_coordinates[i], error, std::abs(coordinates[i])};
      m_piece.linear[i] = {&m_zero, error, error};
    }
    m_piece.square = {&m_zero, d * error * error * 1.5, d * error * error * 1.5};
    m_piece.reference = coordinates;
  }
  Rounded_point(const Rounded_point&) = delete;
  Rounded_point& operator=(const Rounded_point&) = delete;

  const Rounded_piece<d>& piece() const { return m_piece; }
  const std::array<double, d>& coordinates() const { return m_coordinates; }
};

/*
The forms of pieces of one shape, and where they are stored. For each piece d + 1 or d + 2 tensors, of which the last
one is w^2.
*/
template <int d>
class Piece_forms
{
  Degrees m_degrees, m_form_degrees;
  bool m_is_rational;
  Scaled_products m_products;
  boost::container::small_vector<double, 64> m_shifted, m_ones;

public:
  Piece_forms(const Degrees& degrees, bool is_rational)
    : m_degrees(degrees), m_form_degrees{2 * degrees[0], 2 * degrees[1]}, m_is_rational(is_rational),
      m_products(degrees), m_shifted(size_of(degrees)), m_ones(size_of(degrees), 1.0)
  {}

  std::size_t size() const { return (d + (m_is_rational ? 2 : 1)) * size_of(m_form_degrees); }

  // Sets the reference and the forms of a piece, whose numerators and weights are known. \pre Storage is zero.
  void make(Rounded_piece<d>& piece, double* storage)
  {
    const std::size_t size = size_of(m_degrees), form_size = size_of(m_form_degrees);
    piece.form_degrees = m_form_degrees;
    const auto weight = [&](std::size_t k) { return m_is_rational ? piece.weights.begin[k] : 1.0; };
    const double greatest_weight = m_is_rational ? piece.weights.greatest : 1, own = m_products.relative_error();
    const double* weights = m_is_rational ? piece.weights.begin : m_ones.data();
    double *square = storage, square_error = 0, greatest_square = 0;
    for (int i = 0; i < d; ++i) {
      // In the middle, where the differences are smallest.
      const Rounded_tensor& x = piece.points[i];
      const double r = piece.reference[i] = x.begin[size / 2] / weight(size / 2);
      for (std::size_t k = 0; k < size; ++k)
        m_shifted[k] = x.begin[k] - r * weight(k);
      const double greatest = greatest_magnitude(m_shifted.data(), size),
                   rounding = m_is_rational
          ? std::abs(r) * piece.weights.error + 2 * unit * (std::abs(r) * greatest_weight + greatest)
          : unit * greatest,
                   error = x.error + rounding;
      m_products.add(m_shifted.data(), m_shifted.data(), square);
      square_error += 2 * greatest * error + error * error + own * greatest * greatest;
      greatest_square += greatest * greatest;
      double* linear = storage + (1 + static_cast<std::size_t>(i)) * form_size;
      m_products.add(m_shifted.data(), weights, linear);
      m_products.finish(linear);
      set(piece.linear[i], linear,
          error * greatest_weight + piece.weights.error * (greatest + error) + own * greatest * greatest_weight,
          greatest * greatest_weight);
    }
    m_products.finish(square);
    set(piece.square, square, square_error + d * unit * greatest_square, greatest_square);
    if (m_is_rational) {
      double* weight_square = storage + (1 + d) * form_size;
      m_products.add(weights, weights, weight_square);
      m_products.finish(weight_square);
      set(piece.weight_square, weight_square,
          piece.weights.error * (2 * greatest_weight + piece.weights.error) + own * greatest_weight * greatest_weight,
          greatest_weight * greatest_weight);
    }
  }

private:
  // Products may be rounded to zero; sums of errors are rounded, too.
  static void set(Rounded_tensor& tensor, const double* begin, double error, double greatest)
  {
    tensor = {begin, 1.001 * error + (std::numeric_limits<double>::min)(), 1.001 * greatest};
  }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_ROUNDED_PIECE_H
