// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SITE_ARC_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SITE_ARC_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Homogeneous_piece.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline Interval dot(const Interval_pair& a, const Interval_pair& b) { return a[0] * b[0] + a[1] * b[1]; }
inline Interval squared_norm(const Interval_pair& a) { return CGAL::square(a[0]) + CGAL::square(a[1]); }
inline Interval_pair turned_left(const Interval_pair& a) { return {-a[1], a[0]}; }
inline Interval_pair operator+(const Interval_pair& a, const Interval_pair& b) { return {a[0] + b[0], a[1] + b[1]}; }
inline Interval_pair operator-(const Interval_pair& a, const Interval_pair& b) { return {a[0] - b[0], a[1] - b[1]}; }
inline Interval_pair operator*(const Interval& s, const Interval_pair& a) { return {s * a[0], s * a[1]}; }

inline Interval hull(const Interval& a, const Interval& b) { return Interval((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup())); }
inline Interval_pair hull(const Interval_pair& a, const Interval_pair& b) { return {hull(a[0], b[0]), hull(a[1], b[1])}; }

inline Interval any_number() { return Interval(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()); }

// What two enclosures of the same number have in common; they always meet.
inline Interval common_part(const Interval& a, const Interval& b) { return Interval((std::max)(a.inf(), b.inf()), (std::min)(a.sup(), b.sup())); }

inline Interval_pair common_part(const Interval_pair& a, const Interval_pair& b) { return {common_part(a[0], b[0]), common_part(a[1], b[1])}; }

// The sign of all numbers of an interval, or 0 where they differ or are zero.
inline int certain_sign(const Interval& x) { return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0; }

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

// From one end of an arc.
inline Range range_at(double end, double width) { return end == 1 ? Range{1 - width, 1} : Range{0, width}; }

inline Range united(const Range& a, const Range& b) { return {(std::min)(a.begin, b.begin), (std::max)(a.end, b.end)}; }

// Enclosures of the point of an arc and of its first derivatives over a range.
constexpr std::size_t jet_order = 4;
using Curve_jet = std::array<Interval_pair, jet_order + 1>;

// Whether the derivatives in any two points form an angle of less than 90 degrees: the curve goes away from each of its points.
inline bool turns_by_less_than_right_angle(const Curve_jet& x) { return dot(x[1], x[1]).inf() > 0; }

inline Curve_jet hull(const Curve_jet& a, const Curve_jet& b)
{
  Curve_jet result;
  for (std::size_t k = 0; k <= jet_order; ++k)
    result[k] = hull(a[k], b[k]);
  return result;
}

// A polynomial on [0,1] and its derivatives up to an order, by enclosed Bernstein coefficients.
class Polynomial_jet
{
  std::array<std::vector<Interval>, jet_order + 1> m_rows;

public:
  Polynomial_jet() = default;

  // Of any polynomial that is made of the given one when each end of [0,1] is moved by no more than an error, below 2^-10, and the part between brought to [0,1].
  Polynomial_jet(Bernstein_tensor<Exact_rational> tensor, const Exact_rational& error, std::size_t order = jet_order)
  {
    const int degree = tensor.degree(0);
    // Coefficients are values of the blossom, which is affine in each of its arguments.
    Exact_rational change = 2 * degree * error * largest_difference(tensor.coefficients());
    for (std::size_t k = 0; k <= order; ++k, tensor = tensor.derivative(0), change *= 2 * degree)
      for (const Exact_rational& c : tensor.coefficients())
        m_rows[k].push_back(hull(interval_of(Exact_rational(c - change)), interval_of(Exact_rational(c + change))));
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

  // A number, and its distance from the nearer one of 0 and 1: what lies between two others is computed from the nearer of these, with less rounding.
  struct Ratio
  {
    Interval distance;
    bool is_nearer_to_one;

    explicit Ratio(const Interval& t) : distance(t.inf() > 0.5 ? Interval(1) - t : t), is_nearer_to_one(t.inf() > 0.5) {}

    Interval between(const Interval& a, const Interval& b) const { return is_nearer_to_one ? b + distance * (a - b) : a + distance * (b - a); }
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
A polynomial or rational piece of a curve that is a site, on [0,1], with enclosures of its derivatives up to the fourth. Where the ends of the site are not known exactly, the piece ends near them on the same curve, and enclosures are those of the site with the parameter that runs from 0 to 1 on it.
*/
class Site_arc_2
{
  Homogeneous_piece m_piece;
  std::array<Polynomial_jet, 3> m_coordinates;
  std::array<std::array<Polynomial_jet, 3>, 2> m_from_ends;   // ways from both ends, times the weight, and the weight, in the distance of the parameter
  std::array<int, 2> m_zeros{};                                    // of the derivative in both ends, where these are exact
  std::array<Bernstein_tensor<Exact_rational>, 2> m_tangent;       // the derivative without these zeros, where there are any
  std::array<Polynomial_jet, 2> m_tangent_jet;
  bool m_is_polynomial = true;
  bool m_is_straight = true, m_is_segment = false;
  std::optional<std::pair<Exact_pair, Exact_rational>> m_circle;   // center, squared radius
  Interval_pair m_center{};                                        // of the circle
  Interval m_squared_radius;

public:
  // With a bound of the distances of the ends, in the parameter of the piece.
  explicit Site_arc_2(Homogeneous_piece piece, const Exact_rational& error = 0) : m_piece(std::move(piece))
  {
    const std::vector<Exact_rational> weights = m_piece.coordinates[2].coefficients();
    m_is_polynomial = std::all_of(weights.begin(), weights.end(), [&](const Exact_rational& w) { return w == weights.front(); });
    if (m_is_polynomial)
      for (Bernstein_tensor<Exact_rational>& tensor : m_piece.coordinates)
        tensor = divided_by(tensor, weights.front());
    for (std::size_t k = 0; k < 3; ++k)
      m_coordinates[k] = Polynomial_jet(m_piece.coordinates[k], error);
    const Exact_pair a = at(0), b = at(1);
    for (const bool end : {false, true})
      for (std::size_t k = 0; k < 3; ++k) {
        const Bernstein_tensor<Exact_rational> way = k == 2 ? m_piece.coordinates[k] : m_piece.coordinates[k] - m_piece.coordinates[2] * (end ? b : a)[k];
        m_from_ends[end][k] = Polynomial_jet(end ? reversed(way) : way, error, 0);
      }
    if (sign_of(error) == 0)
      divide_derivative();
    m_is_straight = a != b && contains_zero_of([&](const Exact_pair& p) { return exact_cross(Exact_pair{b[0] - a[0], b[1] - a[1]}, Exact_pair{p[0] - a[0], p[1] - a[1]}); });
    m_is_segment = m_is_straight && m_is_polynomial && is_linear(m_piece.coordinates[0]) && is_linear(m_piece.coordinates[1]);
    if (!m_is_straight)
      m_circle = circle_through_all_points();
    if (m_circle) {
      m_center = {interval_of(m_circle->first[0]), interval_of(m_circle->first[1])};
      m_squared_radius = interval_of(m_circle->second);
    }
  }

  const Homogeneous_piece& piece() const { return m_piece; }
  int degree() const { return (std::max)({m_piece.coordinates[0].degree(0), m_piece.coordinates[1].degree(0), m_piece.coordinates[2].degree(0)}); }
  bool is_straight() const { return m_is_straight; }

  // Whether the arc is straight, and its parameter a ratio of lengths, whatever its degree.
  bool is_segment() const { return m_is_segment; }

  // The circle the arc lies on.
  const std::optional<std::pair<Exact_pair, Exact_rational>>& circle() const { return m_circle; }
  const Interval_pair& center() const { return m_center; }
  const Interval& squared_radius() const { return m_squared_radius; }

  // Whether a point is on the line of a straight arc, or on the circle of another one.
  bool is_on_line_or_circle(const Exact_pair& p) const
  {
    const auto from = [&p](const Exact_pair& q) { return Exact_pair{Exact_rational(p[0] - q[0]), Exact_rational(p[1] - q[1])}; };
    if (m_is_straight)
      return sign_of(exact_cross(from(at(0)), from(at(1)))) == 0;
    return m_circle && exact_dot(from(m_circle->first), from(m_circle->first)) == m_circle->second;
  }

  Exact_pair at(const Exact_rational& t) const
  {
    const std::array<Exact_rational, 1> u{t};
    const Exact_rational w = m_piece.coordinates[2](u);
    return {Exact_rational(m_piece.coordinates[0](u) / w), Exact_rational(m_piece.coordinates[1](u) / w)};
  }

  // A vector in the direction of the derivative; its length is that times the square of the weight.
  Exact_pair direction_at(const Exact_rational& t) const
  {
    const std::array<Exact_rational, 1> u{t};
    const auto& [x, y, w] = m_piece.coordinates;
    const Exact_rational w0 = w(u), w1 = w.derivative(0)(u);
    return {Exact_rational(x.derivative(0)(u) * w0 - x(u) * w1), Exact_rational(y.derivative(0)(u) * w0 - y(u) * w1)};
  }

  Exact_pair derivative_at(const Exact_rational& t) const
  {
    const Exact_pair d = direction_at(t);
    const Exact_rational w = m_piece.coordinates[2](std::array<Exact_rational, 1>{t}), square = w * w;
    return {Exact_rational(d[0] / square), Exact_rational(d[1] / square)};
  }

  /*
  In drawings, the first two control points of a cubic often coincide, or the last two. There the derivative is zero, but the curve has a tangent: X' = t^i (1-t)^j D / w^2 with the weight w, where D is not zero in the ends. For other arcs D = X'.
  */
  bool has_singular_end() const { return m_zeros[0] + m_zeros[1] > 0; }

  // i or j.
  int zeros_of_derivative(bool end) const { return m_zeros[end]; }

  // X' w^2; of a polynomial arc, X'.
  std::array<Bernstein_tensor<Exact_rational>, 2> derivative_numerators() const
  {
    const auto& [x, y, w] = m_piece.coordinates;
    if (m_is_polynomial)
      return {x.derivative(0), y.derivative(0)};
    return {x.derivative(0) * w - x * w.derivative(0), y.derivative(0) * w - y * w.derivative(0)};
  }

  // D, of an arc with such an end.
  const std::array<Bernstein_tensor<Exact_rational>, 2>& tangent() const { return m_tangent; }

  Exact_pair tangent_at(const Exact_rational& t) const
  {
    const std::array<Exact_rational, 1> u{t};
    return has_singular_end() ? Exact_pair{m_tangent[0](u), m_tangent[1](u)} : derivative_at(t);
  }

  // D and its derivative.
  std::array<Interval_pair, 2> tangent_jet(const Range& range) const
  {
    if (!has_singular_end()) {
      const Curve_jet x = jet(range, 2);
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
  Interval_pair second_derivative_of_tangent(const Range& range) const { return has_singular_end() ? Interval_pair{m_tangent_jet[0](2, range), m_tangent_jet[1](2, range)} : jet(range, 3)[3]; }

  // t^i (1-t)^j / w^2, with which X' is this times D, of an arc with such an end.
  Interval tangent_factor(const Range& range) const
  {
    Interval result = m_is_polynomial ? Interval(1) : Interval(1) / CGAL::square(m_coordinates[2](0, range));
    for (int i = 0; i < m_zeros[0]; ++i)
      result *= range.interval();
    for (int j = 0; j < m_zeros[1]; ++j)
      result *= Interval(1) - range.interval();
    return result;
  }

  // The derivative of that factor, divided by it; of polynomial arcs, where it is not zero.
  Interval relative_change_of_factor(const Range& range) const
  {
    if (!m_is_polynomial)
      return any_number();
    Interval result(0);
    if (m_zeros[0] > 0)
      result += Interval(m_zeros[0]) / range.interval();
    if (m_zeros[1] > 0)
      result -= Interval(m_zeros[1]) / (Interval(1) - range.interval());
    return result;
  }

  Interval_pair point(const Range& range) const { return jet(range, 0)[0]; }

  // The way from an end of the piece, with a small relative error near that.
  Interval_pair way_from_end(bool end, const Range& range) const
  {
    const Interval t = end ? Interval(1) - range.interval() : range.interval();
    const Range distance{(std::max)(t.inf(), 0.0), (std::min)(t.sup(), 1.0)};
    const auto& [x, y, w] = m_from_ends[end];
    if (m_is_polynomial)
      return {x(0, distance), y(0, distance)};
    const Interval weight = w(0, distance);
    return {x(0, distance) / weight, y(0, distance) / weight};
  }

  // The derivatives up to an order; others are zero.
  Curve_jet jet(const Range& range, std::size_t order = jet_order) const
  {
    Curve_jet result;
    for (std::size_t k = 0; k <= order; ++k)
      result[k] = {m_coordinates[0](k, range), m_coordinates[1](k, range)};
    if (!m_is_polynomial)
      divide_by_weight(result, range, order);
    return result;
  }

  /*
  Whether no circle touches the arc in two points of a range, other than its own: it is straight or circular, or certain to be a spiral, the curvature of which grows or falls all the way, and turns by less than 180 degrees. The chord of two points of a spiral forms
  different angles with it there (Vogt's theorem). The derivative of the curvature has the sign of (X' x X''') |X'|^2 - 3 (X' X'') (X' x X'').
  */
  bool is_spiral(const Range& range) const
  {
    if (m_is_straight || m_circle)
      return true;
    const Curve_jet x = jet(range, 3), middle = jet({range.middle(), range.middle()}, 1);
    const Interval_pair n = turned_left(x[1]);
    return dot(x[1], middle[1]).inf() > 0 && certain_sign(dot(n, x[3]) * squared_norm(x[1]) - Interval(3) * dot(x[1], x[2]) * dot(n, x[2])) != 0;
  }

private:
  static Bernstein_tensor<Exact_rational> divided_by(const Bernstein_tensor<Exact_rational>& tensor, const Exact_rational& number)
  {
    std::vector<Exact_rational> coefficients = tensor.coefficients();
    for (Exact_rational& c : coefficients)
      c /= number;
    return {tensor.degrees(), std::move(coefficients)};
  }

  static bool is_linear(const Bernstein_tensor<Exact_rational>& tensor)
  {
    const std::vector<Exact_rational> c = tensor.power_coefficients();
    return c.size() < 3 || std::all_of(c.begin() + 2, c.end(), [](const Exact_rational& x) { return sign_of(x) == 0; });
  }

  static Bernstein_tensor<Exact_rational> reversed(const Bernstein_tensor<Exact_rational>& tensor)
  {
    std::vector<Exact_rational> coefficients = tensor.coefficients();
    std::reverse(coefficients.begin(), coefficients.end());
    return {tensor.degrees(), std::move(coefficients)};
  }

  // Of X' w^2. With Bernstein coefficients b_i of degree n, those of the quotient by t are n b_(i+1) / (i+1), and by 1-t, n b_i / (n-i).
  void divide_derivative()
  {
    const auto is_zero = [](const Exact_pair& d) { return sign_of(d[0]) == 0 && sign_of(d[1]) == 0; };
    if (!is_zero(direction_at(0)) && !is_zero(direction_at(1)))
      return;
    const auto [x, y] = derivative_numerators();
    const std::vector<int> degree{(std::max)(x.degree(0), y.degree(0))};
    std::array<std::vector<Exact_rational>, 2> b{x.elevated(degree).coefficients(), y.elevated(degree).coefficients()};
    for (const std::size_t end : {0, 1})
      for (; b[0].size() > 1 && sign_of(end == 0 ? b[0].front() : b[0].back()) == 0 && sign_of(end == 0 ? b[1].front() : b[1].back()) == 0; ++m_zeros[end])
        for (std::vector<Exact_rational>& c : b) {
          const int degree = static_cast<int>(c.size()) - 1;
          c.erase(end == 0 ? c.begin() : c.end() - 1);
          for (int i = 0; i < degree; ++i)
            c[static_cast<std::size_t>(i)] *= Exact_rational(degree) / Exact_rational(end == 0 ? i + 1 : degree - i);
        }
    if (has_singular_end())
      for (const std::size_t k : {0, 1}) {
        m_tangent[k] = Bernstein_tensor<Exact_rational>({static_cast<int>(b[k].size()) - 1}, b[k]);
        m_tangent_jet[k] = Polynomial_jet(m_tangent[k], 0, 2);
      }
  }

  // Leibniz: (X w)^(k) = sum_i (k over i) X^(i) w^(k-i).
  void divide_by_weight(Curve_jet& jet, const Range& range, std::size_t order) const
  {
    static constexpr std::array<std::array<double, 5>, 5> binomials{{{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}}};
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

  std::optional<std::pair<Exact_pair, Exact_rational>> circle_through_all_points() const
  {
    const Exact_pair a = at(0), b = at(Exact_rational(1) / 2), c = at(1);
    const Exact_pair p{b[0] - a[0], b[1] - a[1]}, q = a == c ? Exact_pair{at(Exact_rational(1) / 4)[0] - a[0], at(Exact_rational(1) / 4)[1] - a[1]} : Exact_pair{c[0] - a[0], c[1] - a[1]};
    const Exact_rational twice_area = 2 * exact_cross(p, q), pp = exact_dot(p, p), qq = exact_dot(q, q);
    if (CGAL::sign(twice_area) == CGAL::ZERO)
      return std::nullopt;
    const Exact_pair offset{Exact_rational((q[1] * pp - p[1] * qq) / twice_area), Exact_rational((p[0] * qq - q[0] * pp) / twice_area)};
    const Exact_pair center{Exact_rational(a[0] + offset[0]), Exact_rational(a[1] + offset[1])};
    const Exact_rational square = exact_dot(offset, offset);
    if (!contains_zero_of([&](const Exact_pair& x) {
          const Exact_pair d{x[0] - center[0], x[1] - center[1]};
          return Exact_rational(exact_dot(d, d) - square);
        }))
      return std::nullopt;
    return std::make_pair(center, square);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SITE_ARC_2_H
