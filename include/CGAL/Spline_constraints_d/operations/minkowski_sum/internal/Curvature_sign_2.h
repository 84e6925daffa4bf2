// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CURVATURE_SIGN_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CURVATURE_SIGN_2_H

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Convolution_piece_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
The sign of the sum of both curvatures along a piece of two arcs, of which the moving one turns to the right. Where the
derivatives over a range do not tell, its value in the middle and its derivative may, as near double zeros, where two
cusps are next to each other, or nearly arise. That value is known from doubles, and, where these do not tell it as well
as its difference from others, on the level above.

In drawings, round corners are polynomial arcs next to circles; with a disk of the same radius the sum is nearly zero
all along. Where the turning arc has the radius r, the sum has the sign of a polynomial,

  |D|^6 - r^2 (D x D')^2,

as long as the derivative D of the moving arc is a polynomial without zeros in the ends.

Polynomial arcs that are nearly straight, but not along an axis, leave both open; there the Bernstein coefficients of D
x D' of both arcs tell.
*/
class Curvature_sign_2
{
  using Polynomial = Polynomial_jet<Fine_interval>;

  static constexpr double most_width = 0x1p-4;
  static constexpr int most_failures = 128;

  const Convolution_piece_2& m_piece;
  mutable std::optional<Polynomial> m_polynomial;   // made when the derivatives do not tell
  // of the level above doubles: where the sum is zero all along, values do not tell
  mutable int m_failures = 0;

public:
  // A zero of the sum in a range, where it changes its sign.
  struct Cusp
  {
    Range range;
    int sign_before;
  };

  explicit Curvature_sign_2(const Convolution_piece_2& piece) : m_piece(piece) {}

  int operator()(const Range& range) const
  {
    if (const int sign = m_piece.sign_of_speed(range); sign != 0 || range.width() > most_width)
      return sign;
    if (has_polynomial())
      return sign_by_polynomial(range);
    const int sign = sign_by_mean_value(range);
    return sign != 0 ? sign : m_piece.sign_of_speed_by_turns(range);
  }

  // If the sum is proved to be monotone in a range, with different signs at its ends.
  std::optional<Cusp> only_cusp(const Range& range) const
  {
    if (certain_sign(m_piece.change_of_curvatures(range)) == 0)
      return std::nullopt;
    const int before = sign_at(range.begin), behind = sign_at(range.end);
    if (before * behind >= 0)
      return std::nullopt;
    Cusp result{range, before};
    for (double t = range.middle(); result.range.begin < t && t < result.range.end; t = result.range.middle())
      if (const int sign = certain_sign(m_piece.sum_of_curvatures<Interval>(t)); sign != 0)
        (sign == before ? result.range.begin : result.range.end) = t;
      else
        break;
    return result;
  }

private:
  int sign_by_polynomial(const Range& range) const
  {
    if (!m_polynomial)
      m_polynomial.emplace(exact_polynomial(), 0, 0);
    return certain_sign((*m_polynomial)(0, range));
  }

  int sign_by_mean_value(const Range& range) const
  {
    if (m_failures > most_failures)
      return 0;
    const Interval change = m_piece.change_of_curvatures(range) * (range.interval() - Interval(range.middle())),
                   middle = m_piece.sum_of_curvatures<Interval>(range.middle());
    const auto width = [](const Interval& x) { return x.sup() - x.inf(); };
    if (const int sign = certain_sign(middle + change); sign != 0 || !(width(change) < width(middle)))
      return sign;
    const int sign = certain_sign(in_doubles(m_piece.sum_of_curvatures<Fine_interval>(range.middle())) + change);
    m_failures += sign == 0;
    return sign;
  }

  int sign_at(double t) const
  {
    const int sign = certain_sign(m_piece.sum_of_curvatures<Interval>(t));
    return sign != 0 ? sign : certain_sign(m_piece.sum_of_curvatures<Fine_interval>(t));
  }

  bool has_polynomial() const
  {
    return m_piece.turning_arc().circle() && m_piece.moving_arc().is_polynomial() &&
        !m_piece.moving_arc().has_singular_end();
  }

  Exact_tensor exact_polynomial() const
  {
    const std::array<Exact_tensor, 2> d = m_piece.moving_arc().derivative_numerators();
    const Exact_tensor square = d[0] * d[0] + d[1] * d[1], sixth = square * square * square,
                       turn = d[0] * d[1].derivative(0) - d[1] * d[0].derivative(0);
    return sixth - (turn * turn * m_piece.turning_arc().circle()->second).elevated(sixth.degrees());
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CURVATURE_SIGN_2_H
