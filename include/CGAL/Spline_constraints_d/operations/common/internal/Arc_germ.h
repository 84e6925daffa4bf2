// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ARC_GERM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ARC_GERM_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// Whether the turn from the direction of one vector to that of another one is small: arcs join nearly smoothly then.
bool is_small_turn(const Exact_pair& p, const Exact_pair& q);

// The second one of two nearly equal directions, scaled to about the length of the first one, and any other one as it
// is. So the normals of a small fan have one length, and its disks of one size one curvature.
Exact_pair with_length_of(const Exact_pair& p, const Exact_pair& q);

// The outgoing direction of an end of an arc, also where its derivative is zero: the first derivative that is not zero,
// up to its length: from the end to the next control point that is another point, whatever the signs of their weights.
Exact_pair outgoing_direction(const Exact_arc_2& arc, bool is_end);

// 0 for directions in the upper half-plane with the positive x-axis, 1 for others
inline int half_of_directions(const Exact_pair& d)
{
  return sign_of(d[1]) < 0 || (sign_of(d[1]) == 0 && sign_of(d[0]) < 0);
}

inline bool are_same_directions(const Exact_pair& p, const Exact_pair& q)
{
  return sign_of(exact_cross(p, q)) == 0 && sign_of(exact_dot(p, q)) > 0;
}

// A direction between two that form an angle of 90 to 180 degrees, the second clockwise from the first: perpendicular
// to one of them, or near their bisector. It has short coordinates, so that it is that of a symmetric drawing, or not
// nearly.
Exact_pair direction_between(const Exact_pair& from, const Exact_pair& to);

/*
An arc next to one of its ends, as a function over its tangent there: the coefficients c of eta = sum_k c_k xi^k, k >=
2, with the coordinates xi along the outgoing direction and eta to the left of it. Of two arcs that leave a point in one
direction, that with the greater germ, in lexicographic order, is on the left. Where the derivative is zero, only the
first term is known: eta is nearly a multiple of a power of xi, with a quotient of two numbers as the exponent.
*/
class Arc_germ
{
  using Series = std::vector<Exact_rational>;   // truncated

  std::size_t m_size;
  Series m_coefficients;
  // xi and eta are nearly these multiples of these powers of the parameter; eta is zero everywhere if its factor is.
  int m_xi_power = 0, m_eta_power = 0;
  Exact_rational m_xi_factor = 0, m_eta_factor = 0;

public:
  Arc_germ(const Exact_arc_2& arc, bool is_end, std::size_t order);

  // Whether all coefficients up to the order are.
  bool is_known() const { return !m_coefficients.empty(); }

  // Of germs that are known.
  bool operator==(const Arc_germ& other) const { return m_coefficients == other.m_coefficients; }

  // Whether this arc is certainly on the right of the other one.
  bool operator<(const Arc_germ& other) const
  {
    return is_known() && other.is_known() ? m_coefficients < other.m_coefficients : has_lower_first_term(other);
  }

private:
  static std::pair<int, Exact_rational> first_term(const Series& series, const Exact_rational& weight);

  bool has_lower_first_term(const Arc_germ& other) const;

  // The absolute factor of eta as a multiple of a power of xi, to the power that xi is of the parameter.
  Exact_rational height_of_first_term() const
  {
    return power(Exact_rational(CGAL::abs(m_eta_factor)), m_xi_power) / power(m_xi_factor, m_eta_power);
  }

  static Exact_rational power(const Exact_rational& x, int exponent);

  Series series(const Bernstein_tensor<Exact_rational>& tensor, bool is_end) const;

  static Series difference(Series a, const Exact_rational& factor, const Series& b);

  static Series quotient(Series a, const Series& b);

  void expand(Series eta, const Series& xi);
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE bool is_small_turn(const Exact_pair& p, const Exact_pair& q)
{
  constexpr double most_turn = 0x1p-20;
  const Exact_rational most = Exact_rational(most_turn), sine = exact_cross(p, q),
                       square = exact_dot(p, p) * exact_dot(q, q);
  return sine * sine < most * most * square;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair with_length_of(const Exact_pair& p, const Exact_pair& q)
{
  if (!is_small_turn(p, q))
    return q;
  const Exact_rational scale(CGAL::to_double(Exact_rational(exact_dot(p, p) / exact_dot(p, q))));
  return {Exact_rational(scale * q[0]), Exact_rational(scale * q[1])};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair outgoing_direction(const Exact_arc_2& arc, bool is_end)
{
  const auto& [x, y, w] = arc.piece().coordinates;
  const auto elevated = [&x = x, &y = y, &w = w](const Bernstein_tensor<Exact_rational>& tensor) {
    return tensor.elevated({(std::max)({x.degree(0), y.degree(0), w.degree(0)})}).coefficients();
  };
  const auto xs = elevated(x), ys = elevated(y), ws = elevated(w);
  const std::size_t last = xs.size() - 1, end = is_end ? last : 0;
  for (std::size_t i = 1; i <= last; ++i) {
    const std::size_t k = is_end ? last - i : i;
    // over the square of the weight
    const Exact_pair d{Exact_rational(xs[k] * ws[end] - xs[end] * ws[k]),
                       Exact_rational(ys[k] * ws[end] - ys[end] * ws[k])};
    if (sign_of(d[0]) != 0 || sign_of(d[1]) != 0)
      return d;
  }
  return {};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_pair direction_between(const Exact_pair& from, const Exact_pair& to)
{
  const double a = std::atan2(CGAL::to_double(from[1]), CGAL::to_double(from[0])),
               b = std::atan2(CGAL::to_double(to[1]), CGAL::to_double(to[0]));
  const double angle = (a + (b < a ? b : b - 2 * CGAL_PI)) / 2;
  const auto rounded = [](double x) { return Exact_rational(std::round(64 * x) / 64); };
  const Exact_pair proposal{rounded(std::cos(angle)), rounded(std::sin(angle))};
  const auto is_clockwise = [](const Exact_pair& x, const Exact_pair& y) { return sign_of(exact_cross(x, y)) < 0; };
  return is_clockwise(from, proposal) && is_clockwise(proposal, to) ? proposal
                                                                    : Exact_pair{from[1], Exact_rational(-from[0])};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Arc_germ::Arc_germ(const Exact_arc_2& arc, bool is_end, std::size_t order)
  : m_size(order + 1)
{
  const Exact_pair d = outgoing_direction(arc, is_end), p = arc.at(is_end);
  // that of equal directions is the same
  const Exact_rational length = (std::max)(Exact_rational(CGAL::abs(d[0])), Exact_rational(CGAL::abs(d[1])));
  const auto& [x, y, w] = arc.piece().coordinates;
  const Series weight = series(w, is_end), a = difference(series(x, is_end), p[0], weight),
               b = difference(series(y, is_end), p[1], weight);
  Series along(m_size), left(m_size);
  for (std::size_t i = 0; i < m_size; ++i) {
    along[i] = (a[i] * d[0] + b[i] * d[1]) / length;
    left[i] = (b[i] * d[0] - a[i] * d[1]) / length;
  }
  std::tie(m_xi_power, m_xi_factor) = first_term(along, weight[0]);
  std::tie(m_eta_power, m_eta_factor) = first_term(left, weight[0]);
  if (along.size() > 1 && sign_of(along[1]) != 0)
    expand(quotient(left, weight), quotient(along, weight));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<int, Exact_rational> Arc_germ::first_term(const Series& series,
                                                                                   const Exact_rational& weight)
{
  const auto first =
      std::find_if(series.begin(), series.end(), [](const Exact_rational& c) { return sign_of(c) != 0; });
  return first == series.end() ? std::pair(0, Exact_rational(0))
                               : std::pair(static_cast<int>(first - series.begin()), Exact_rational(*first / weight));
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Arc_germ::has_lower_first_term(const Arc_germ& other) const
{
  const int side = sign_of(m_eta_factor), other_side = sign_of(other.m_eta_factor);
  if (side != other_side || side == 0)
    return side < other_side;
  const int exponent = m_eta_power * other.m_xi_power, other_exponent = other.m_eta_power * m_xi_power;
  if (exponent != other_exponent) // the lower power is farther away from the tangent
    return (exponent < other_exponent) == (side < 0);
  const Exact_rational height = power(height_of_first_term(), other.m_xi_power),
                       other_height = power(other.height_of_first_term(), m_xi_power);
  return side > 0 ? height < other_height : other_height < height;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Arc_germ::power(const Exact_rational& x, int exponent)
{
  Exact_rational result(1);
  for (int i = 0; i < exponent; ++i)
    result *= x;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Arc_germ::Series Arc_germ::series(const Bernstein_tensor<Exact_rational>& tensor,
                                                                 bool is_end) const
{
  Series result = (is_end ? reversed(tensor) : tensor).power_coefficients();
  result.resize(m_size, Exact_rational(0));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Arc_germ::Series Arc_germ::difference(Series a, const Exact_rational& factor,
                                                                     const Series& b)
{
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= factor * b[i];
  return a;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Arc_germ::Series Arc_germ::quotient(Series a, const Series& b)
{
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j)
      a[i] -= a[j] * b[i - j];
    a[i] /= b[0];
  }
  return a;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Arc_germ::expand(Series eta, const Series& xi)
{
  Series power = xi;
  for (std::size_t k = 2; k < m_size; ++k) {
    Series next(m_size, Exact_rational(0));
    for (std::size_t i = 1; i < m_size; ++i)
      for (std::size_t j = 1; i + j < m_size; ++j)
        next[i + j] += power[i] * xi[j];
    power = std::move(next);
    m_coefficients.push_back(Exact_rational(eta[k] / power[k]));
    eta = difference(std::move(eta), m_coefficients.back(), power);
  }
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_ARC_GERM_H
