// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SITE_ARC_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SITE_ARC_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A closed range of the parameter of an arc, within [0,1].
struct Range
{
  double begin = 0, end = 1;

  double width() const { return end - begin; }
  double middle() const { return begin + (end - begin) / 2; }
  bool is_number() const { return begin == end; }
  Interval interval() const { return Interval(begin, end); }
  bool meets(const Range& other) const { return begin <= other.end && other.begin <= end; }
};

template <Enclosing_number Number>
Number interval_of(const Range& range)
{
  return Number(range.begin, range.end);
}

// From one end of an arc.
inline Range range_at(double end, double width) { return end == 1 ? Range{1 - width, 1} : Range{0, width}; }

inline Range united(const Range& a, const Range& b) { return {(std::min)(a.begin, b.begin), (std::max)(a.end, b.end)}; }

// Enclosures of the point of an arc and of its first derivatives over a range.
constexpr std::size_t jet_order = 4;
template <Enclosing_number Interval = Common::Interval>
using Curve_jet = std::array<std::array<Interval, 2>, jet_order + 1>;

// Whether the derivatives in any two points, or vectors in their directions, form an angle of less than 90 degrees: the
// curve goes away from each of its points.
template <Enclosing_number Interval>
bool turns_by_less_than_right_angle(const std::array<Interval, 2>& derivative)
{
  return dot(derivative, derivative).inf() > 0;
}

template <Enclosing_number Interval>
Curve_jet<Interval> hull(const Curve_jet<Interval>& a, const Curve_jet<Interval>& b)
{
  Curve_jet<Interval> result;
  for (std::size_t k = 0; k <= jet_order; ++k)
    result[k] = hull(a[k], b[k]);
  return result;
}

inline const Curve_jet<>& in_doubles(const Curve_jet<>& jet) { return jet; }

template <Enclosing_number Number>
Curve_jet<> in_doubles(const Curve_jet<Number>& jet)
{
  Curve_jet<> result;
  std::transform(jet.begin(), jet.end(), result.begin(), [](const auto& x) { return in_doubles(x); });
  return result;
}

// A polynomial on [0,1] and its derivatives up to an order, by enclosed Bernstein coefficients.
template <Enclosing_number Interval = Common::Interval>
class Polynomial_jet
{
  std::array<std::vector<Interval>, jet_order + 1> m_rows;

public:
  Polynomial_jet() = default;

  // Of any polynomial that is made of the given one when each end of [0,1] is moved by no more than an error, below
  // 2^-10, and the part between brought to [0,1].
  Polynomial_jet(Bernstein_tensor<Exact_rational> tensor, const Exact_rational& error, std::size_t order = jet_order)
  {
    const int degree = tensor.degree(0);
    // Coefficients are values of the blossom, which is affine in each of its arguments.
    Exact_rational change = 2 * degree * error * largest_difference(tensor.coefficients());
    for (std::size_t k = 0; k <= order; ++k, tensor = tensor.derivative(0), change *= 2 * degree)
      for (const Exact_rational& c : tensor.coefficients())
        m_rows[k].push_back(
            hull(interval_of<Interval>(Exact_rational(c - change)), interval_of<Interval>(Exact_rational(c + change))));
  }

  // Bounds of a derivative over a range: those of the Bernstein coefficients there.
  Interval operator()(std::size_t order, const Range& range) const
  {
    constexpr std::size_t most_in_place = 16;
    const std::vector<Interval>& row = m_rows[order];
    if (row.size() > most_in_place) {
      std::vector<Interval> b(row);
      return bounds(b.data(), b.size(), range);
    }
    std::array<Interval, most_in_place> b;
    std::copy(row.begin(), row.end(), b.begin());
    return bounds(b.data(), row.size(), range);
  }

private:
  static Exact_rational largest_difference(const std::vector<Exact_rational>& coefficients)
  {
    Exact_rational result(0);
    for (std::size_t i = 1; i < coefficients.size(); ++i)
      result = (std::max)(result, Exact_rational(CGAL::abs(Exact_rational(coefficients[i] - coefficients[i - 1]))));
    return result;
  }

  // A number, and its distance from the nearer one of 0 and 1: what lies between two others is computed from the nearer
  // of these, with less rounding.
  struct Ratio
  {
    Interval distance;
    bool is_nearer_to_one;

    explicit Ratio(const Interval& t) : distance(t.inf() > 0.5 ? Interval(1) - t : t), is_nearer_to_one(t.inf() > 0.5)
    {}

    Interval between(const Interval& a, const Interval& b) const
    {
      return is_nearer_to_one ? b + distance * (a - b) : a + distance * (b - a);
    }
  };

  static Interval bounds(Interval* b, std::size_t size, const Range& range)
  {
    const Interval t(range.begin);
    const Ratio begin(t);
    for (std::size_t r = 1; r < size; ++r)
      for (std::size_t k = 0; k + r < size; ++k)
        b[k] = begin.between(b[k], b[k + 1]);
    if (range.is_number())
      return b[0];
    if (range.end != 1 || range.begin != 0) {   // the part after the begin, cut at the end
      const Ratio end(range.begin == 1 ? Interval(0) : (Interval(range.end) - t) / (Interval(1) - t));
      for (std::size_t r = 1; r < size; ++r)
        for (std::size_t k = size - 1; k >= r; --k)
          b[k] = end.between(b[k - 1], b[k]);
    }
    return std::accumulate(b + 1, b + size, b[0], [](const Interval& x, const Interval& y) { return hull(x, y); });
  }
};

/*
An arc that is a site, with enclosures of its derivatives up to the fourth. Where the ends of the site are not known
exactly, the piece ends near them on the same curve, and enclosures are those of the site with the parameter that runs
from 0 to 1 on it.
*/
template <Enclosing_number Interval = Common::Interval>
class Site_arc_2 : public Exact_arc_2
{
  using Interval_pair = std::array<Interval, 2>;

  // of a rational piece, relative to its begin: so bounds over a range do not depend on where it is
  std::array<Polynomial_jet<Interval>, 3> m_coordinates;
  Interval_pair m_begin{};
  // ways from both ends, times the weight, and the weight, in the distance of the parameter
  std::array<std::array<Polynomial_jet<Interval>, 3>, 2> m_from_ends;
  std::array<Polynomial_jet<Interval>, 2> m_tangent_jet;                // where the derivative is zero in an end
  Interval_pair m_center{};                                   // of the circle
  Interval m_squared_radius{};

public:
  // With a bound of the distances of the ends, in the parameter of the piece.
  explicit Site_arc_2(Homogeneous_piece piece, const Exact_rational& error = 0)
    : Site_arc_2(Exact_arc_2(std::move(piece), error))
  {}

  explicit Site_arc_2(Exact_arc_2 arc) : Exact_arc_2(std::move(arc))
  {
    const auto& coordinates = piece().coordinates;
    const std::array<Exact_pair, 2> ends{at(0), at(1)};
    for (std::size_t k = 0; k < 3; ++k)
      m_coordinates[k] = Polynomial_jet<Interval>(
          k == 2 || is_polynomial() ? coordinates[k] : coordinates[k] - coordinates[2] * ends[0][k], error());
    if (!is_polynomial())
      m_begin = {interval_of<Interval>(ends[0][0]), interval_of<Interval>(ends[0][1])};
    for (const bool end : {false, true})
      for (std::size_t k = 0; k < 3; ++k) {
        const Bernstein_tensor<Exact_rational> way =
            k == 2 ? coordinates[k] : coordinates[k] - coordinates[2] * ends[end][k];
        m_from_ends[end][k] = Polynomial_jet<Interval>(end ? reversed(way) : way, error(), 0);
      }
    if (has_singular_end())
      for (const std::size_t k : {0, 1})
        m_tangent_jet[k] = Polynomial_jet<Interval>(tangent()[k], 0, 2);
    if (circle()) {
      m_center = {interval_of<Interval>(circle()->first[0]), interval_of<Interval>(circle()->first[1])};
      m_squared_radius = interval_of<Interval>(circle()->second);
    }
  }

  const Interval_pair& center() const { return m_center; }
  const Interval& squared_radius() const { return m_squared_radius; }

  // D and its derivative.
  std::array<Interval_pair, 2> tangent_jet(const Range& range) const
  {
    if (!has_singular_end()) {
      const Curve_jet<Interval> x = jet(range, 2);
      return {x[1], x[2]};
    }
    const auto& [x, y] = m_tangent_jet;
    return {Interval_pair{x(0, range), y(0, range)}, Interval_pair{x(1, range), y(1, range)}};
  }

  // A vector in the direction of the derivative, or of D.
  Interval_pair direction_over(const Range& range) const
  {
    if (!has_singular_end())
      return jet(range, 1)[1];
    return {m_tangent_jet[0](0, range), m_tangent_jet[1](0, range)};
  }

  // D''.
  Interval_pair second_derivative_of_tangent(const Range& range) const
  {
    return has_singular_end() ? Interval_pair{m_tangent_jet[0](2, range), m_tangent_jet[1](2, range)}
                              : jet(range, 3)[3];
  }

  // t^i (1-t)^j / w^2, with which X' is this times D, of an arc with such an end.
  Interval tangent_factor(const Range& range) const
  {
    Interval result = is_polynomial() ? Interval(1) : Interval(1) / CGAL::square(m_coordinates[2](0, range));
    for (int i = 0; i < zeros_of_derivative(false); ++i)
      result *= interval_of<Interval>(range);
    for (int j = 0; j < zeros_of_derivative(true); ++j)
      result *= Interval(1) - interval_of<Interval>(range);
    return result;
  }

  // The derivative of that factor, divided by it; of polynomial arcs, where it is not zero.
  Interval relative_change_of_factor(const Range& range) const
  {
    if (!is_polynomial())
      return any_number<Interval>();
    Interval result(0);
    if (zeros_of_derivative(false) > 0)
      result += Interval(zeros_of_derivative(false)) / interval_of<Interval>(range);
    if (zeros_of_derivative(true) > 0)
      result -= Interval(zeros_of_derivative(true)) / (Interval(1) - interval_of<Interval>(range));
    return result;
  }

  Interval_pair point(const Range& range) const { return jet(range, 0)[0]; }

  // The way from an end of the piece, with a small relative error near that.
  Interval_pair way_from_end(bool end, const Range& range) const
  {
    const Interval t = end ? Interval(1) - interval_of<Interval>(range) : interval_of<Interval>(range);
    const Range distance{(std::max)(t.inf(), 0.0), (std::min)(t.sup(), 1.0)};
    const auto& [x, y, w] = m_from_ends[end];
    if (is_polynomial())
      return {x(0, distance), y(0, distance)};
    const Interval weight = w(0, distance);
    return {x(0, distance) / weight, y(0, distance) / weight};
  }

  // The derivatives up to an order; others are zero.
  Curve_jet<Interval> jet(const Range& range, std::size_t order = jet_order) const
  {
    Curve_jet<Interval> result;
    for (std::size_t k = 0; k <= order; ++k)
      result[k] = {m_coordinates[0](k, range), m_coordinates[1](k, range)};
    if (!is_polynomial()) {
      divide_by_weight(result, range, order);
      result[0] = result[0] + m_begin;
    }
    return result;
  }

  /*
  Whether no circle touches the arc in two points of a range, other than its own: it is straight or circular, or certain
  to be a spiral, the curvature of which grows or falls all the way, and turns by less than 180 degrees. The chord of
  two points of a spiral forms different angles with it there (Vogt's theorem). The derivative of the curvature has the
  sign of (X' x X''') |X'|^2 - 3 (X' X'') (X' x X'').
  */
  bool is_spiral(const Range& range) const
  {
    if (is_straight() || circle())
      return true;
    const Curve_jet<Interval> x = jet(range, 3), middle = jet({range.middle(), range.middle()}, 1);
    const Interval_pair n = turned_left(x[1]);
    return dot(x[1], middle[1]).inf() > 0 &&
        certain_sign(dot(n, x[3]) * squared_norm(x[1]) - Interval(3) * dot(x[1], x[2]) * dot(n, x[2])) != 0;
  }

private:
  // Leibniz: (X w)^(k) = sum_i (k over i) X^(i) w^(k-i).
  void divide_by_weight(Curve_jet<Interval>& jet, const Range& range, std::size_t order) const
  {
    static constexpr std::array<std::array<double, 5>, 5> binomials{
        {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}}};
    std::array<Interval, jet_order + 1> w;
    for (std::size_t k = 0; k <= order; ++k)
      w[k] = m_coordinates[2](k, range);
    for (std::size_t k = 0; k <= order; ++k)
      for (std::size_t c = 0; c < 2; ++c) {
        for (std::size_t i = 0; i < k; ++i)
          jet[k][c] -= Interval(binomials[k][i]) * jet[i][c] * w[k - i];
        jet[k][c] /= w[0];
      }
  }

};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SITE_ARC_2_H
