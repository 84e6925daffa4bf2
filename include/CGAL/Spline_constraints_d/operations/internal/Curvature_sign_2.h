// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVATURE_SIGN_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVATURE_SIGN_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Convolution_piece_2.h>

#include <array>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The sign of the sum of both curvatures along a piece of two arcs, of which the moving one turns to the right. In drawings, round corners are polynomial arcs next to circles; with a disk of the same radius the sum is nearly zero all along. Where the turning arc has the radius r, the sum has the sign of a polynomial,

  |D|^6 - r^2 (D x D')^2,

as long as the derivative D of the moving arc is a polynomial without zeros in the ends.
*/
class Curvature_sign_2
{
  using Polynomial = Basic_polynomial_jet<Fine_interval>;

  const Convolution_piece_2& m_piece;
  mutable std::optional<Polynomial> m_polynomial;   // made when the derivatives do not tell

public:
  explicit Curvature_sign_2(const Convolution_piece_2& piece) : m_piece(piece) {}

  int operator()(const Range& range) const
  {
    constexpr double most_width = 0x1p-4;
    const int sign = m_piece.sign_of_speed(range);
    if (sign != 0 || range.width() > most_width || !has_polynomial())
      return sign;
    if (!m_polynomial)
      m_polynomial.emplace(exact_polynomial(), 0, 0);
    return certain_sign((*m_polynomial)(0, range));
  }

private:
  bool has_polynomial() const { return m_piece.turning_arc().circle() && m_piece.moving_arc().is_polynomial() && !m_piece.moving_arc().has_singular_end(); }

  Exact_tensor exact_polynomial() const
  {
    const std::array<Exact_tensor, 2> d = m_piece.moving_arc().derivative_numerators();
    const Exact_tensor square = d[0] * d[0] + d[1] * d[1], sixth = square * square * square, turn = d[0] * d[1].derivative(0) - d[1] * d[0].derivative(0);
    return sixth - (turn * turn * m_piece.turning_arc().circle()->second).elevated(sixth.degrees());
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVATURE_SIGN_2_H
