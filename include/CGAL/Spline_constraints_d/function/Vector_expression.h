// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_VECTOR_EXPRESSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_VECTOR_EXPRESSION_H

#include <CGAL/Spline_constraints_d/function/Expression.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <ostream>
#include <span>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A point or vector whose coordinates are formulas. The functions below work on the coordinates; they throw what the
operations of `Expression` throw.

\tparam dimension_ the number of coordinates, 2 or 3.
*/
template <int dimension_>
  requires (dimension_ == 2 || dimension_ == 3)
class Vector_expression
{
  std::array<Expression, dimension_> m_coordinates;

public:
  //! number of coordinates.
  static constexpr int dimension = dimension_;

  //! the vector with the given coordinates: numbers or formulas.
  template <class... Coordinates>
    requires (sizeof...(Coordinates) == dimension_) && (std::convertible_to<const Coordinates&, Expression> && ...)
  Vector_expression(const Coordinates&... coordinates) : m_coordinates{Expression(coordinates)...} {}

  //! the vector with the given coordinates.
  explicit Vector_expression(std::array<Expression, dimension_> coordinates) : m_coordinates(std::move(coordinates)) {}

  //! a coordinate.
  const Expression& operator[](std::size_t i) const { return m_coordinates[i]; }

  //! @{ the coordinates by name.
  const Expression& x() const { return m_coordinates[0]; }
  const Expression& y() const { return m_coordinates[1]; }
  const Expression& z() const requires (dimension_ == 3) { return m_coordinates[2]; }
  //! @}

  //! the exact value at a point of the domain. \throws Invalid_input as the evaluation of an `Expression`.
  std::array<Exact_rational, dimension_> operator()(std::span<const Exact_rational> point) const
  {
    std::array<Exact_rational, dimension_> result;
    for (int i = 0; i < dimension_; ++i)
      result[i] = m_coordinates[i](point);
    return result;
  }

  Vector_expression& operator+=(const Vector_expression& other)
  {
    return combine(other, [](Expression& a, const Expression& b) { a += b; });
  }
  Vector_expression& operator-=(const Vector_expression& other)
  {
    return combine(other, [](Expression& a, const Expression& b) { a -= b; });
  }

  Vector_expression& operator*=(const Expression& factor)
  {
    for (Expression& coordinate : m_coordinates)
      coordinate *= factor;
    return *this;
  }

  //! division. \throws Invalid_input when the divisor is zero.
  Vector_expression& operator/=(const Expression& divisor)
  {
    for (Expression& coordinate : m_coordinates)
      coordinate /= divisor;
    return *this;
  }

  friend Vector_expression operator+(Vector_expression a, const Vector_expression& b) { return std::move(a += b); }
  friend Vector_expression operator-(Vector_expression a, const Vector_expression& b) { return std::move(a -= b); }
  friend Vector_expression operator*(Vector_expression a, const Expression& factor) { return std::move(a *= factor); }
  friend Vector_expression operator*(const Expression& factor, Vector_expression a) { return std::move(a *= factor); }
  friend Vector_expression operator/(Vector_expression a, const Expression& divisor) { return std::move(a /= divisor); }
  friend Vector_expression operator-(Vector_expression a) { return std::move(a *= -1); }

  //! writes `(x, y)` or `(x, y, z)`.
  friend std::ostream& operator<<(std::ostream& out, const Vector_expression& a)
  {
    for (int i = 0; i < dimension_; ++i)
      out << (i == 0 ? "(" : ", ") << a[i];
    return out << ')';
  }

private:
  template <class Operation>
  Vector_expression& combine(const Vector_expression& other, const Operation& operation)
  {
    for (int i = 0; i < dimension_; ++i)
      operation(m_coordinates[i], other.m_coordinates[i]);
    return *this;
  }
};

template <class... Coordinates>
Vector_expression(const Coordinates&...) -> Vector_expression<sizeof...(Coordinates)>;

namespace internal {

// The vector with the coordinates coordinate(0), coordinate(1), ...
template <int d, class Coordinate>
Vector_expression<d> vector_of(const Coordinate& coordinate)
{
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Vector_expression<d>(std::array<Expression, d>{coordinate(I)...});
  }(std::make_index_sequence<d>());
}

} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDFunctions
@{
*/

//! the inner product.
template <int d>
Expression dot(const Vector_expression<d>& a, const Vector_expression<d>& b)
{
  Expression sum = a[0] * b[0];
  for (int i = 1; i < d; ++i)
    sum += a[i] * b[i];
  return sum;
}

//! the inner product of a vector with itself.
template <int d>
Expression squared_norm(const Vector_expression<d>& a)
{
  return dot(a, a);
}

//! the point halfway between two points.
template <int d>
Vector_expression<d> midpoint(const Vector_expression<d>& a, const Vector_expression<d>& b)
{
  return (a + b) / 2;
}

//! the determinant of the matrix with these columns, \f$a_x b_y - a_y b_x\f$.
inline Expression determinant(const Vector_expression<2>& a, const Vector_expression<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

//! the third coordinate of the cross product of two vectors in the plane: their determinant.
inline Expression cross(const Vector_expression<2>& a, const Vector_expression<2>& b) { return determinant(a, b); }

//! the cross product.
inline Vector_expression<3> cross(const Vector_expression<3>& a, const Vector_expression<3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

//! the determinant of the matrix with these columns.
inline Expression determinant(const Vector_expression<3>& a, const Vector_expression<3>& b,
                              const Vector_expression<3>& c)
{
  return dot(a, cross(b, c));
}

//! a vector turned to the left by a right angle, \f$(-y, x)\f$.
inline Vector_expression<2> perpendicular(const Vector_expression<2>& a) { return {-a[1], a[0]}; }

/*!
@}
*/

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_VECTOR_EXPRESSION_H
