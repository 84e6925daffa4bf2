// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CIRCLE_EMPTINESS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CIRCLE_EMPTINESS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// A circle that is known to touch a curve, by ranges.
struct Enclosed_circle
{
  std::array<Interval, 2> center;
  Interval squared_radius;
};

/*
Whether a circle that touches a curve at a parameter u has a point of the curve inside. With the curve (x,y)/w and the
center p, F(t) = |(x,y) - p w|^2 - r^2 w^2 is negative exactly at such points, and has a double zero at u: F = (t-u)^2
Q, where the coefficients of Q are those of F divided twice by t-u, by Horner's scheme, in intervals. The remainders are
known to be zero. So Q has no zero at the contact, and its Bernstein coefficients can prove that it is positive; on
pieces without a contact, those of F do.

Where the contact may lie on a break with a tangent, it may belong to either piece, and the zero of F in the range of u
on the other piece is replaced by a value and a slope at the break that lead away from zero (`leads_away`).
*/
class Circle_emptiness
{
  static constexpr int maximal_depth = 40;
  static constexpr int maximal_parts = 400;

  const std::vector<Homogeneous_piece>& m_pieces;
  const Enclosed_circle& m_circle;

public:
  // The rounding mode has to be upward.
  Circle_emptiness(const std::vector<Homogeneous_piece>& pieces, const Enclosed_circle& circle)
    : m_pieces(pieces), m_circle(circle)
  {}

  // `contact` is the range of u on the smooth part of the curve over `part`.
  CGAL::Uncertain<bool> operator()(const Parameter_range& contact, const Parameter_range& part) const;

private:
  Interval_tensor distance_function(const Homogeneous_piece& piece) const;

  // Divided by (t-u)^2, which leaves no remainder.
  static Interval_tensor divided(const Interval_tensor& function, const Interval& u);

  CGAL::Uncertain<bool> is_outside(std::size_t index, const Parameter_range& contact,
                                   const Parameter_range& part) const;

  // Where the contact may be on a piece, in its parameter on [0,1]; also just beyond an end where the next piece goes
  // on smoothly, across the seam of a closed curve too.
  std::vector<Parameter_range> local_ranges(const Homogeneous_piece& piece, const Parameter_range& contact,
                                            const Parameter_range& part) const;

  /*
  The squared distance less r^2 is D = (t-u)^2 g with g = Q/w^2. At an end e of the piece beyond u, D(e) = (e-u)^2 g is
  positive with g, and its slope is (e-u) (2 g + (e-u) g'), of which the second factor is shown to exceed g. On the next
  piece, l times as fast and with the weight v, F has the positive value v^2 D there, and a slope away from zero, v^2 l
  D' + 2 v v' D, if l exceeds 2 |v'/v| |e-u|. Then F = F(e) + F'(e)(t-e) + (t-e)^2 R is positive with R, which is the
  quotient there for a zero at e.
  */
  bool leads_away(std::size_t index, const Interval_tensor& quotient, const Parameter_range& u, int side) const;

  struct End
  {
    Exact_rational weight, weight_slope, squared_speed;
  };

  template <class NT>
  static NT value_at(const Bernstein_tensor<NT>& tensor, int side)
  {
    return side == 0 ? tensor.coefficients().front() : tensor.coefficients().back();
  }

  static End end_of(const Homogeneous_piece& piece, int side);

  // Whether a function is positive on [0,1]; false where the distance is shown to be negative.
  static CGAL::Uncertain<bool> is_positive(const Interval_tensor& function, const Interval_tensor& distance);
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<bool> Circle_emptiness::operator()(const Parameter_range& contact,
                                                                                  const Parameter_range& part) const
{
  CGAL::Uncertain<bool> result = true;
  for (std::size_t i = 0; i < m_pieces.size(); ++i) {
    const CGAL::Uncertain<bool> is_empty = is_outside(i, contact, part);
    if (CGAL::certainly_not(is_empty))
      return false;
    result = result & is_empty;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Interval_tensor Circle_emptiness::distance_function(const Homogeneous_piece& piece) const
{
  const Exact_rational p[] = {to_rational(CGAL::to_double(m_circle.center[0])),
                              to_rational(CGAL::to_double(m_circle.center[1]))};
  const auto& [x, y, w] = piece.coordinates;
  const Bernstein_tensor<Exact_rational> dx = x - w * p[0], dy = y - w * p[1]; // about the middle of the center
  const Interval ex = m_circle.center[0] - interval_of(p[0]), ey = m_circle.center[1] - interval_of(p[1]);
  const auto in_intervals = [](const Bernstein_tensor<Exact_rational>& tensor) {
    return tensor.converted<Interval>([](const Exact_rational& c) { return interval_of(c); });
  };
  return in_intervals(dx * dx + dy * dy) - in_intervals(dx * w) * (Interval(2) * ex) -
      in_intervals(dy * w) * (Interval(2) * ey) +
      in_intervals(w * w) * (CGAL::square(ex) + CGAL::square(ey) - m_circle.squared_radius);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Interval_tensor Circle_emptiness::divided(const Interval_tensor& function,
                                                                         const Interval& u)
{
  std::vector<Interval> coefficients = function.power_coefficients();
  for (int times = 0; times < 2; ++times) {
    for (std::size_t k = coefficients.size() - 1; k > 0; --k)
      coefficients[k - 1] += u * coefficients[k];
    coefficients.erase(coefficients.begin());
  }
  const int degree = static_cast<int>(coefficients.size()) - 1;
  return Interval_tensor::from_power({degree}, std::move(coefficients));
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<bool>
Circle_emptiness::is_outside(std::size_t index, const Parameter_range& contact, const Parameter_range& part) const
{
  const Homogeneous_piece& piece = m_pieces[index];
  const Interval_tensor distance = distance_function(piece);
  const std::vector<Parameter_range> ranges = local_ranges(piece, contact, part);
  if (ranges.empty())
    return is_positive(distance, distance);
  if (ranges.size() > 1 || distance.degree(0) < 2)
    return CGAL::Uncertain<bool>::indeterminate();
  const Parameter_range& u = ranges[0];
  const Interval_tensor quotient = divided(distance, interval_of(u));
  CGAL::Uncertain<bool> result = is_positive(quotient, distance);
  for (const int side : {0, 1})
    if ((side == 0 ? piece.is_smooth_at_begin : piece.is_smooth_at_end) && u.first <= side && side <= u.second &&
        !leads_away(index, quotient, u, side))
      result = result & CGAL::Uncertain<bool>::indeterminate();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Parameter_range>
Circle_emptiness::local_ranges(const Homogeneous_piece& piece, const Parameter_range& contact,
                               const Parameter_range& part) const
{
  const bool is_within = part.first <= piece.domain.first && piece.domain.second <= part.second;
  const Exact_rational period(m_pieces.back().domain.second - m_pieces.front().domain.first);
  std::vector<Parameter_range> result;
  for (const int turn : {-1, 0, 1}) {
    const Parameter_range u{piece.local(Exact_rational(contact.first + turn * period)),
                            piece.local(Exact_rational(contact.second + turn * period))};
    const bool is_at_begin = u.first <= 0 && 0 <= u.second, is_at_end = u.first <= 1 && 1 <= u.second;
    const bool is_inside = turn == 0 && is_within && 0 <= u.second && u.first <= 1;
    if (is_inside || (is_at_begin && piece.is_smooth_at_begin) || (is_at_end && piece.is_smooth_at_end))
      result.push_back(u);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Circle_emptiness::leads_away(std::size_t index, const Interval_tensor& quotient,
                                                                 const Parameter_range& u, int side) const
{
  const End own = end_of(m_pieces[index], side),
            next = end_of(m_pieces[(index + m_pieces.size() + (side == 0 ? -1 : 1)) % m_pieces.size()], 1 - side);
  const Interval q = value_at(quotient, side), slope_of_q = value_at(quotient.derivative(0), side),
                 way = Interval(side) - interval_of(u);
  const Interval w = interval_of(own.weight),
                 excess = q * w + way * (slope_of_q * w - Interval(2) * q * interval_of(own.weight_slope));
  const Exact_rational longest =
      (std::max)(CGAL::abs(Exact_rational(side - u.first)), CGAL::abs(Exact_rational(side - u.second)));
  const Exact_rational turn(2 * longest * next.weight_slope);
  const bool has_slope = own.weight > 0 ? excess.inf() > 0 : excess.sup() < 0;
  return has_slope &&
      Exact_rational(turn * turn * own.squared_speed) < Exact_rational(next.weight * next.weight * next.squared_speed);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Circle_emptiness::End Circle_emptiness::end_of(const Homogeneous_piece& piece, int side)
{
  End end{value_at(piece.coordinates[2], side), value_at(piece.coordinates[2].derivative(0), side), Exact_rational(0)};
  for (std::size_t k = 0; k < 2; ++k) {
    const Exact_rational numerator(value_at(piece.coordinates[k].derivative(0), side) * end.weight -
                                   value_at(piece.coordinates[k], side) * end.weight_slope);
    end.squared_speed += Exact_rational(numerator * numerator);
  }
  end.squared_speed /= Exact_rational(end.weight * end.weight * end.weight * end.weight);
  return end;
}

CGAL_SPLINE_CONSTRAINTS_INLINE CGAL::Uncertain<bool> Circle_emptiness::is_positive(const Interval_tensor& function,
                                                                                   const Interval_tensor& distance)
{
  struct Part
  {
    Interval_tensor function, distance;
    int depth;
  };
  std::vector<Part> open{{function, distance, 0}};
  CGAL::Uncertain<bool> result = true;
  for (int count = 0; !open.empty(); ++count) {
    const Part part = std::move(open.back());
    open.pop_back();
    if (part.distance.coefficients().front().sup() < 0 || part.distance.coefficients().back().sup() < 0)
      return false;
    const auto& coefficients = part.function.coefficients();
    if (std::all_of(coefficients.begin(), coefficients.end(), [](const Interval& c) { return c.inf() > 0; }))
      continue;
    if (part.depth == maximal_depth || count >= maximal_parts || part.function.degree(0) == 0) {
      result = CGAL::Uncertain<bool>::indeterminate();
      continue;
    }
    auto [first, second] = part.function.split(0);
    auto [first_distance, second_distance] = part.distance.split(0);
    open.push_back({std::move(second), std::move(second_distance), part.depth + 1});
    open.push_back({std::move(first), std::move(first_distance), part.depth + 1});
  }
  return result;
}
#endif

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CIRCLE_EMPTINESS_H
