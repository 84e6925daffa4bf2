// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_EXACT_ARC_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_EXACT_ARC_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

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

// What is known exactly of an arc, a polynomial or rational piece of a curve on [0,1].
class Exact_arc_2
{
  Homogeneous_piece m_piece;
  Exact_rational m_error;
  std::array<int, 2> m_zeros{};                                 // of the derivative in both ends, where these are exact
  // the derivative without these zeros, where there are any
  std::array<Bernstein_tensor<Exact_rational>, 2> m_tangent;
  bool m_is_polynomial = true;
  std::array<bool, 2> m_is_curvature_stationary{}, m_is_curvature_zero{};   // in both ends
  bool m_is_straight = true, m_is_segment = false, m_turns_back = false;
  std::optional<std::pair<Exact_pair, Exact_rational>> m_circle;   // center, squared radius

public:
  // With a bound of the distances of the ends, in the parameter of the piece.
  explicit Exact_arc_2(Homogeneous_piece piece, const Exact_rational& error = 0);

  const Homogeneous_piece& piece() const { return m_piece; }
  // The bound of the distances of its ends from those of the site.
  const Exact_rational& error() const { return m_error; }

  bool is_polynomial() const { return m_is_polynomial; }
  int degree() const { return m_piece.degree(); }
  bool is_straight() const { return m_is_straight; }

  // Whether the arc is straight, and its parameter a ratio of lengths, whatever its degree.
  bool is_segment() const { return m_is_segment; }

  // The circle the arc lies on.
  const std::optional<std::pair<Exact_pair, Exact_rational>>& circle() const { return m_circle; }

  bool is_on_line_or_circle() const { return m_is_straight || m_circle; }

  // Whether an arc on a line or circle may pass through a point more than once.
  bool turns_back() const { return m_turns_back; }

  // Whether a point is on the line of a straight arc, or on the circle of another one.
  bool is_on_line_or_circle(const Exact_pair& p) const;

  Exact_pair at(const Exact_rational& t) const;

  // Of a segment, the parameter of the foot of a point on its line.
  Exact_rational parameter_of_foot(const Exact_pair& p) const
  {
    const Exact_pair a = at(0), b = at(1), d{Exact_rational(b[0] - a[0]), Exact_rational(b[1] - a[1])};
    return exact_dot(d, Exact_pair{Exact_rational(p[0] - a[0]), Exact_rational(p[1] - a[1])}) / exact_dot(d, d);
  }

  // A vector in the direction of the derivative; its length is that times the square of the weight.
  Exact_pair direction_at(const Exact_rational& t) const;

  Exact_pair derivative_at(const Exact_rational& t) const;

  /*
  In drawings, the first two control points of a cubic often coincide, or the last two. There the derivative is zero,
  but the curve has a tangent: X' = t^i (1-t)^j D / w^2 with the weight w, where D is not zero in the ends. For other
  arcs D = X'.
  */
  bool has_singular_end() const { return m_zeros[0] + m_zeros[1] > 0; }

  // i or j.
  int zeros_of_derivative(bool end) const { return m_zeros[end]; }

  // Whether the arc ends exactly in a vertex of its curve, where the derivative of the curvature is zero, as half a
  // parabola does; not of segments and circular arcs, where it is zero everywhere.
  bool is_curvature_stationary(bool end) const { return m_is_curvature_stationary[end]; }

  // Whether the derivative of the curvature is zero in a point. With X' = D / w^2 the curvature is w^2 (D x D') /
  // |D|^3.
  bool is_curvature_stationary_at(const Exact_rational& t) const;

  // The square of the curvature in a point, with the sign of that.
  Exact_rational signed_square_of_curvature(const Exact_rational& t) const;

  // Whether the curvature is zero in an end, as in the first of three control points in a row; not of segments.
  bool is_curvature_zero(bool end) const { return m_is_curvature_zero[end]; }

  // The curvature times |X'|, where X' = D / w^2 is not zero: (D x D') / |D|^2.
  Exact_rational curvature_at(const Exact_rational& t) const
  {
    const Numerators x = numerators_at(t);
    return Exact_rational(exact_cross(x.d0, x.d1) / exact_dot(x.d0, x.d0));
  }

  // X' w^2; of a polynomial arc, X'.
  std::array<Bernstein_tensor<Exact_rational>, 2> derivative_numerators() const;

  // D, of an arc with such an end.
  const std::array<Bernstein_tensor<Exact_rational>, 2>& tangent() const { return m_tangent; }

  Exact_pair tangent_at(const Exact_rational& t) const
  {
    const std::array<Exact_rational, 1> u{t};
    return has_singular_end() ? Exact_pair{m_tangent[0](u), m_tangent[1](u)} : derivative_at(t);
  }

private:
  static Bernstein_tensor<Exact_rational> divided_by(const Bernstein_tensor<Exact_rational>& tensor,
                                                     const Exact_rational& number);

  static bool is_linear(const Bernstein_tensor<Exact_rational>& tensor)
  {
    const std::vector<Exact_rational> c = tensor.power_coefficients();
    return c.size() < 3 || std::all_of(c.begin() + 2, c.end(), [](const Exact_rational& x) { return sign_of(x) == 0; });
  }

  // D and its derivatives, and the weight and its derivative.
  struct Numerators
  {
    Exact_pair d0, d1, d2;
    Exact_rational w0, w1;
  };

  Numerators numerators_at(const Exact_rational& t) const;

  bool is_curvature_zero_at(const Exact_rational& t) const
  {
    const Numerators x = numerators_at(t);
    return sign_of(exact_cross(x.d0, x.d1)) == 0;
  }

  // By the signs of the Bernstein coefficients of <X', B - A>, or X' x (X - C), of an arc from A to B, or around C.
  bool goes_one_way() const;

  // Of X' w^2. With Bernstein coefficients b_i of degree n, those of the quotient by t are n b_(i+1) / (i+1), and by
  // 1-t, n b_i / (n-i).
  void divide_derivative();

  // Whether a quadratic function is zero on the whole arc: it has more zeros than its degree allows otherwise.
  template <class Function>
  bool contains_zero_of(const Function& function) const
  {
    const int most = 2 * degree();
    for (int i = 0; i <= most; ++i)
      if (CGAL::sign(function(at(Exact_rational(i) / Exact_rational(most)))) != CGAL::ZERO)
        return false;
    return true;
  }

  std::optional<std::pair<Exact_pair, Exact_rational>> circle_through_all_points() const;
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_arc_2::Exact_arc_2(Homogeneous_piece piece, const Exact_rational& error)
  : m_piece(std::move(piece)), m_error(error)
{
  const std::vector<Exact_rational> weights = m_piece.coordinates[2].coefficients();
  m_is_polynomial =
      std::all_of(weights.begin(), weights.end(), [&](const Exact_rational& w) { return w == weights.front(); });
  if (m_is_polynomial)
    for (Bernstein_tensor<Exact_rational>& tensor : m_piece.coordinates)
      tensor = divided_by(tensor, weights.front());
  if (sign_of(error) == 0)
    divide_derivative();
  const Exact_pair a = at(0), b = at(1);
  m_is_straight = a != b && contains_zero_of([&](const Exact_pair& p) {
                    return exact_cross(Exact_pair{b[0] - a[0], b[1] - a[1]}, Exact_pair{p[0] - a[0], p[1] - a[1]});
                  });
  m_is_segment =
      m_is_straight && m_is_polynomial && is_linear(m_piece.coordinates[0]) && is_linear(m_piece.coordinates[1]);
  if (!m_is_straight)
    m_circle = circle_through_all_points();
  m_turns_back = is_on_line_or_circle() && !goes_one_way();
  if (!m_is_straight && !m_circle && sign_of(error) == 0)
    for (const bool end : {false, true})
      if (m_zeros[end] == 0) {
        m_is_curvature_stationary[end] = is_curvature_stationary_at(Exact_rational(end ? 1 : 0));
        m_is_curvature_zero[end] = is_curvature_zero_at(Exact_rational(end ? 1 : 0));
      }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Exact_arc_2::is_on_line_or_circle(const Exact_pair& p) const
{
  const auto from = [&p](const Exact_pair& q) {
    return Exact_pair{Exact_rational(p[0] - q[0]), Exact_rational(p[1] - q[1])};
  };
  if (m_is_straight)
    return sign_of(exact_cross(from(at(0)), from(at(1)))) == 0;
  return m_circle && exact_dot(from(m_circle->first), from(m_circle->first)) == m_circle->second;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair Exact_arc_2::at(const Exact_rational& t) const
{
  const std::array<Exact_rational, 1> u{t};
  const Exact_rational w = m_piece.coordinates[2](u);
  return {Exact_rational(m_piece.coordinates[0](u) / w), Exact_rational(m_piece.coordinates[1](u) / w)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair Exact_arc_2::direction_at(const Exact_rational& t) const
{
  const std::array<Exact_rational, 1> u{t};
  const auto& [x, y, w] = m_piece.coordinates;
  const Exact_rational w0 = w(u), w1 = w.derivative(0)(u);
  return {Exact_rational(x.derivative(0)(u) * w0 - x(u) * w1), Exact_rational(y.derivative(0)(u) * w0 - y(u) * w1)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair Exact_arc_2::derivative_at(const Exact_rational& t) const
{
  const Exact_pair d = direction_at(t);
  const Exact_rational w = m_piece.coordinates[2](std::array<Exact_rational, 1>{t}), square = w * w;
  return {Exact_rational(d[0] / square), Exact_rational(d[1] / square)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Exact_arc_2::is_curvature_stationary_at(const Exact_rational& t) const
{
  const auto& [d0, d1, d2, w0, w1] = numerators_at(t);
  const Exact_rational turn = exact_cross(d0, d1), square = exact_dot(d0, d0);
  return sign_of(Exact_rational(w0 * exact_cross(d0, d2) * square + 2 * w1 * turn * square -
                                3 * w0 * exact_dot(d0, d1) * turn)) == 0;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Exact_arc_2::signed_square_of_curvature(const Exact_rational& t) const
{
  const auto& [d0, d1, d2, w0, w1] = numerators_at(t);
  const Exact_rational turn = exact_cross(d0, d1), square = exact_dot(d0, d0);
  return w0 * w0 * w0 * w0 * turn * CGAL::abs(turn) / (square * square * square);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::array<Bernstein_tensor<Exact_rational>, 2>
Exact_arc_2::derivative_numerators() const
{
  const auto& [x, y, w] = m_piece.coordinates;
  if (m_is_polynomial)
    return {x.derivative(0), y.derivative(0)};
  return {x.derivative(0) * w - x * w.derivative(0), y.derivative(0) * w - y * w.derivative(0)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Bernstein_tensor<Exact_rational>
Exact_arc_2::divided_by(const Bernstein_tensor<Exact_rational>& tensor, const Exact_rational& number)
{
  std::vector<Exact_rational> coefficients = tensor.coefficients();
  for (Exact_rational& c : coefficients)
    c /= number;
  return {tensor.degrees(), std::move(coefficients)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_arc_2::Numerators Exact_arc_2::numerators_at(const Exact_rational& t) const
{
  const std::array<Exact_rational, 1> u{t};
  const auto d = derivative_numerators();
  const auto at = [&](std::size_t order) {
    auto [x, y] = d;
    for (std::size_t i = 0; i < order; ++i) {
      x = x.derivative(0);
      y = y.derivative(0);
    }
    return Exact_pair{x(u), y(u)};
  };
  return {at(0), at(1), at(2), m_is_polynomial ? Exact_rational(1) : m_piece.coordinates[2](u),
          m_is_polynomial ? Exact_rational(0) : m_piece.coordinates[2].derivative(0)(u)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Exact_arc_2::goes_one_way() const
{
  const auto d = derivative_numerators();
  const auto& [x, y, w] = m_piece.coordinates;
  const Exact_pair a = at(0), b = at(1);
  const Bernstein_tensor<Exact_rational> way = m_is_straight
      ? d[0] * Exact_rational(b[0] - a[0]) + d[1] * Exact_rational(b[1] - a[1])
      : d[0] * (y - w * m_circle->first[1]) - d[1] * (x - w * m_circle->first[0]);
  const auto have_sign = [&](int sign) {
    return std::ranges::all_of(way.coefficients(), [&](const Exact_rational& c) { return sign_of(c) * sign >= 0; });
  };
  return have_sign(1) || have_sign(-1);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Exact_arc_2::divide_derivative()
{
  const auto is_zero = [](const Exact_pair& d) { return sign_of(d[0]) == 0 && sign_of(d[1]) == 0; };
  if (!is_zero(direction_at(0)) && !is_zero(direction_at(1)))
    return;
  const auto [x, y] = derivative_numerators();
  const std::vector<int> degree{(std::max)(x.degree(0), y.degree(0))};
  std::array<std::vector<Exact_rational>, 2> b{x.elevated(degree).coefficients(), y.elevated(degree).coefficients()};
  for (const std::size_t end : {0, 1})
    for (; b[0].size() > 1 && sign_of(end == 0 ? b[0].front() : b[0].back()) == 0 &&
         sign_of(end == 0 ? b[1].front() : b[1].back()) == 0;
         ++m_zeros[end])
      for (std::vector<Exact_rational>& c : b) {
        const int degree = static_cast<int>(c.size()) - 1;
        c.erase(end == 0 ? c.begin() : c.end() - 1);
        for (int i = 0; i < degree; ++i)
          c[static_cast<std::size_t>(i)] *= Exact_rational(degree) / Exact_rational(end == 0 ? i + 1 : degree - i);
      }
  if (has_singular_end())
    for (const std::size_t k : {0, 1})
      m_tangent[k] = Bernstein_tensor<Exact_rational>({static_cast<int>(b[k].size()) - 1}, b[k]);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::pair<Exact_pair, Exact_rational>>
Exact_arc_2::circle_through_all_points() const
{
  const Exact_pair a = at(0), b = at(Exact_rational(1) / 2), c = at(1);
  const Exact_pair p{b[0] - a[0], b[1] - a[1]},
      q = a == c ? Exact_pair{at(Exact_rational(1) / 4)[0] - a[0], at(Exact_rational(1) / 4)[1] - a[1]}
                 : Exact_pair{c[0] - a[0], c[1] - a[1]};
  const Exact_rational twice_area = 2 * exact_cross(p, q), pp = exact_dot(p, p), qq = exact_dot(q, q);
  if (CGAL::sign(twice_area) == CGAL::ZERO)
    return std::nullopt;
  const Exact_pair offset{Exact_rational((q[1] * pp - p[1] * qq) / twice_area),
                          Exact_rational((p[0] * qq - q[0] * pp) / twice_area)};
  const Exact_pair center{Exact_rational(a[0] + offset[0]), Exact_rational(a[1] + offset[1])};
  const Exact_rational square = exact_dot(offset, offset);
  if (!contains_zero_of([&](const Exact_pair& x) {
        const Exact_pair d{x[0] - center[0], x[1] - center[1]};
        return Exact_rational(exact_dot(d, d) - square);
      }))
    return std::nullopt;
  return std::make_pair(center, square);
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_EXACT_ARC_2_H
