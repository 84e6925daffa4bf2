// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_REGION_ELEMENTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_REGION_ELEMENTS_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Fine_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

template <Enclosing_number Number>
Number cross(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
  return dot(turned_left(a), b);
}

// What moves an arc to another one, possibly with the opposite direction.
inline std::optional<Exact_pair> translation(const Site_arc_2<>& a, const Site_arc_2<>& b, bool are_opposite)
{
  const Exact_pair result = exact_difference(b.at(are_opposite ? 1 : 0), a.at(0));
  const auto &f = a.piece().coordinates, &g = b.piece().coordinates;
  if (f[0].degrees() != g[0].degrees() || f[2].degrees() != g[2].degrees() || f[0].degrees() != f[2].degrees())
    return std::nullopt;
  const auto &w = f[2].coefficients(), &v = g[2].coefficients();
  const std::size_t n = w.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t l = are_opposite ? n - 1 - k : k;
    if (w[k] != v[l])
      return std::nullopt;
    for (std::size_t c = 0; c < 2; ++c)
      if (f[c].coefficients()[k] + result[c] * w[k] != g[c].coefficients()[l])
        return std::nullopt;
  }
  return result;
}

// Whether an arc is another one with the opposite direction, reflected in a point: a(t) + b(1 - t) is one point.
inline bool are_reflected(const Site_arc_2<>& a, const Site_arc_2<>& b)
{
  const Exact_pair p = a.at(0), q = b.at(1), sum{Exact_rational(p[0] + q[0]), Exact_rational(p[1] + q[1])};
  const auto &f = a.piece().coordinates, &g = b.piece().coordinates;
  if (f[0].degrees() != g[0].degrees() || f[2].degrees() != g[2].degrees() || f[0].degrees() != f[2].degrees())
    return false;
  const auto &w = f[2].coefficients(), &v = g[2].coefficients();
  const std::size_t n = w.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t c = 0; c < 2; ++c)
      if (w[k] != v[n - 1 - k] || f[c].coefficients()[k] + g[c].coefficients()[n - 1 - k] != sum[c] * w[k])
        return false;
  return true;
}

// The point of an arc, a tangent D with its derivative, and the factor m >= 0 of X' = m D, over a range: D is the
// derivative itself, or what it is without its zeros in the ends. The arc turns as D does, X' x X'' = m^2 (D x D').
template <Enclosing_number Number = Interval>
struct Tangent_jet
{
  std::array<Number, 2> point, tangent, change;
  Number speed;

  Number turn() const { return cross(tangent, change); }
  Number squared_length() const { return squared_norm(tangent); }
};

// Without the derivative of the tangent, where this is not needed.
template <Enclosing_number Number>
Tangent_jet<Number> tangent_jet(const Site_arc_2<Number>& arc, const Range& range, bool has_change = true)
{
  if (arc.has_singular_end()) {
    const auto [tangent, change] = arc.tangent_jet(range);
    return {arc.point(range), tangent, change, arc.tangent_factor(range)};
  }
  const auto x = arc.jet(range, has_change ? 2 : 1);
  return {x[0], x[1], x[2], Number(1)};
}

// How the direction of a boundary changes along a part of it.
enum class Turn { LEFT, RIGHT, STRAIGHT, UNKNOWN };

// A part of a boundary along which its direction changes monotonically, by at most 45 degrees if to the left: a part of
// an arc, or the directions between the two arcs of a corner.
struct Region_element
{
  Turn turn;
  bool is_corner;
  std::size_t arc;                               // that of a part; or that which ends in the corner
  Range range;                                   // of the parameter of the arc
  std::array<Exact_pair, 2> exact_directions;    // at the begin and the end
  std::array<Interval_pair, 2> directions;
  // the element before; the joint of two elements has the number of the one that ends there
  std::size_t previous = 0;
};

/*
The boundaries of a region as cycles of elements. Where the boundary turns to the left, the region is locally convex.
*/
class Region_elements_2
{
  using Fine_arc = Site_arc_2<Fine_interval>;

  static constexpr double least_width = 0x1p-40;   // of a part that may contain an inflection

  // An arc on the level above doubles: made when it is needed for the first time.
  struct Arc_on_demand
  {
    std::once_flag is_made;
    std::optional<Fine_arc> arc;
    std::optional<Polynomial_jet<Fine_interval>> turn;
  };

  const std::vector<Boundary_loop_2>& m_loops;
  std::vector<Site_arc_2<>> m_arcs;
  // the curve that an arc is a piece of, and the parameters at its ends
  std::vector<std::pair<std::size_t, std::array<double, 2>>> m_origins;
  std::vector<std::size_t> m_previous_arcs, m_next_arcs;                  // along the boundaries
  std::vector<Region_element> m_elements;
  std::vector<std::unique_ptr<Arc_on_demand>> m_fine_arcs;

public:
  //! \throws Invalid_input when a derivative is zero, or the boundary turns back, other than on itself.
  // \throws Run_stopped
  Region_elements_2(const std::vector<Boundary_loop_2>& loops, Run_of_steps& control) : m_loops(loops)
  {
    for (const Boundary_loop_2& loop : loops)
      add_loop(loop, control);
  }

  const std::vector<Boundary_loop_2>& loops() const { return m_loops; }
  const std::vector<Site_arc_2<>>& arcs() const { return m_arcs; }
  const std::vector<Region_element>& elements() const { return m_elements; }

  // Along the boundary.
  std::size_t previous_arc(std::size_t arc) const { return m_previous_arcs[arc]; }
  std::size_t next_arc(std::size_t arc) const { return m_next_arcs[arc]; }

  const Fine_arc& fine_arc(std::size_t index) const
  {
    Arc_on_demand& result = *m_fine_arcs[index];
    std::call_once(result.is_made, [&] { result.arc.emplace(static_cast<const Exact_arc_2&>(m_arcs[index])); });
    return *result.arc;
  }

  // On the level of a number type.
  template <Enclosing_number Number>
  const Site_arc_2<Number>& arc(std::size_t index) const
  {
    if constexpr (std::same_as<Number, Interval>)
      return m_arcs[index];
    else
      return fine_arc(index);
  }

  // D x D' of an arc, up to a positive factor, by its Bernstein coefficients: with its sign also where the arc is small
  // or nearly straight. For one thread.
  const Polynomial_jet<Fine_interval>& turn_polynomial(std::size_t arc) const
  {
    Arc_on_demand& result = *m_fine_arcs[arc];
    if (!result.turn)
      result.turn.emplace(exact_turn(m_arcs[arc]), 0, 0);
    return *result.turn;
  }

  // The joint at the begin (0) or end (1) of an element.
  std::size_t joint(std::size_t element, int side) const { return side == 1 ? element : m_elements[element].previous; }

  // A number for the point of a joint: that of the first joint there.
  std::size_t place_of_joint(std::size_t joint) const
  {
    while (m_elements[joint].is_corner)
      joint = m_elements[joint].previous;
    return joint;
  }

  // The curve that an arc is a piece of, and the parameter there, rounded.
  std::pair<std::size_t, double> origin(std::size_t arc, double t) const
  {
    const auto& [curve, ends] = m_origins[arc];
    return {curve,
            t == 1 ? ends[1]
                   : std::clamp(ends[0] + t * (ends[1] - ends[0]), (std::min)(ends[0], ends[1]),
                                (std::max)(ends[0], ends[1]))};
  }

  // Whether an arc is another one in the opposite direction.
  bool is_other_side(std::size_t arc, std::size_t other) const
  {
    const auto& [curve, ends] = m_origins[arc];
    const auto& [other_curve, other_ends] = m_origins[other];
    return curve == other_curve && ends[0] == other_ends[1] && ends[1] == other_ends[0];
  }

private:
  void add_loop(const Boundary_loop_2& loop, Run_of_steps& control)
  {
    const std::size_t first_arc = m_arcs.size(), first_element = m_elements.size();
    for (const Boundary_piece& piece : loop.pieces()) {
      m_arcs.emplace_back(Homogeneous_piece{{0, 1}, piece.coordinates});
      m_fine_arcs.push_back(std::make_unique<Arc_on_demand>());
      m_origins.push_back(
          {piece.curve, {to_nearest_double(piece.parameters[0]), to_nearest_double(piece.parameters[1])}});
    }
    for (std::size_t i = first_arc; i < m_arcs.size(); ++i) {
      control.check();
      m_previous_arcs.push_back(i > first_arc ? i - 1 : m_arcs.size() - 1);
      m_next_arcs.push_back(i + 1 < m_arcs.size() ? i + 1 : first_arc);
      add_parts(i, {0, 1});
      add_corner(i, m_next_arcs[i]);
    }
    for (std::size_t i = first_element; i < m_elements.size(); ++i)
      m_elements[i].previous = i > first_element ? i - 1 : m_elements.size() - 1;
  }

  // Whether the angle between two directions is at most 45 degrees.
  static bool is_narrow(const Exact_pair& a, const Exact_pair& b)
  {
    return exact_dot(a, b) >= CGAL::abs(exact_cross(a, b));
  }

  void add_parts(std::size_t arc, const Range& range)
  {
    const Site_arc_2<>& a = m_arcs[arc];
    const Exact_pair d0 = direction(arc, range.begin), d1 = direction(arc, range.end);
    const Tangent_jet<> jet = tangent_jet(a, range);
    const bool is_regular = certain_sign(squared_norm_of(jet.tangent)) > 0;
    if (a.is_straight() && is_regular)
      return add({Turn::STRAIGHT, false, arc, range, {d0, d1}, {}});
    const int turn = a.is_straight() ? 0 : certain_turn(arc, jet, range);
    if (turn != 0 && is_regular && is_narrow(d0, d1))
      return add({turn > 0 ? Turn::LEFT : Turn::RIGHT, false, arc, range, {d0, d1}, {}});
    if (range.width() > least_width) {
      add_parts(arc, {range.begin, range.middle()});
      add_parts(arc, {range.middle(), range.end});
      return;
    }
    if (!is_regular)
      throw Invalid_input("the derivative of curve " + std::to_string(origin(arc, range.begin).first) +
                          " is zero, or nearly so, at parameter " + shortest_text(origin(arc, range.begin).second));
    add({Turn::UNKNOWN, false, arc, range, {d0, d1}, {}});
  }

  // Where the derivatives do not tell, by the Bernstein coefficients of D x D', above doubles: of an arc that is small
  // or nearly straight the derivatives do not tell over many parts of the least width.
  int certain_turn(std::size_t arc, const Tangent_jet<>& jet, const Range& range) const
  {
    constexpr double most_width = 0x1p-4;
    int sign = certain_sign(jet.turn());
    if (sign == 0 && range.width() <= most_width)
      sign = certain_sign(turn_polynomial(arc)(0, range));
    return sign == 0 && range.width() <= most_width && (range.begin == 0 || range.end == 1)
        ? turn_at_end(m_arcs[arc], range)
        : sign;
  }

  // D x D', up to a positive factor.
  static Exact_tensor exact_turn(const Site_arc_2<>& arc)
  {
    const std::array<Exact_tensor, 2> d = arc.has_singular_end() ? arc.tangent() : arc.derivative_numerators();
    return d[0] * d[1].derivative(0) - d[1] * d[0].derivative(0);
  }

  // In drawings, the first three control points of a cubic are often on a line. There the curvature is zero in the end
  // of the arc; next to it, it has one sign if the Bernstein coefficients of D x D' have.
  static int turn_at_end(const Site_arc_2<>& arc, const Range& range)
  {
    const std::vector<Exact_rational> c =
        exact_turn(arc).restricted(0, to_rational(range.begin), to_rational(range.end)).coefficients();
    const int inner = sign_of(range.begin == 0 ? c.back() : c.front());
    return std::any_of(c.begin(), c.end(), [&](const Exact_rational& x) { return sign_of(x) == -inner; }) ? 0 : inner;
  }

  // The inner product of each two vectors within these bounds: positive if they are all within 90 degrees of each
  // other.
  static Interval squared_norm_of(const Interval_pair& v) { return dot(v, v); }

  // Up to its length.
  Exact_pair direction(std::size_t arc, double t) const
  {
    const Exact_pair d = m_arcs[arc].tangent_at(to_rational(t));
    if (sign_of(d[0]) == 0 && sign_of(d[1]) == 0)
      throw Invalid_input("the derivative of curve " + std::to_string(origin(arc, t).first) + " is zero at parameter " +
                          shortest_text(origin(arc, t).second));
    return d;
  }

  // In an end of a curve of which both sides are boundaries, the directions are those of a half-turn to the left. A
  // cusp of a region may turn to either side.
  void add_corner(std::size_t before, std::size_t after)
  {
    const Exact_pair d0 = direction(before, 1), d1 = direction(after, 0);
    const int turn = sign_of(exact_cross(d0, d1));
    const bool turns_back = turn == 0 && sign_of(exact_dot(d0, d1)) < 0;
    if (turns_back && !is_other_side(before, after))
      throw Invalid_input("the boundary turns back on curve " + std::to_string(origin(before, 1).first) +
                          " at parameter " + shortest_text(origin(before, 1).second));
    if (turn > 0 || turns_back)
      add_normal_cone(before, d0, d1);
    else if (turn < 0)
      add({Turn::RIGHT, true, before, {1, 1}, {d0, d1}, {}});
  }

  static bool goes_on_as(const Region_element& a, const Region_element& b)
  {
    const bool is_same = !a.is_corner && !b.is_corner && a.arc == b.arc && a.turn == b.turn;
    return is_same && (a.turn == Turn::UNKNOWN || is_narrow(a.exact_directions[0], b.exact_directions[1]));
  }

  void add_normal_cone(std::size_t arc, const Exact_pair& d0, const Exact_pair& d1)
  {
    if (is_narrow(d0, d1))
      return add({Turn::LEFT, true, arc, {1, 1}, {d0, d1}, {}});
    const Exact_pair between = direction_between(d0, d1);
    add_normal_cone(arc, d0, between);
    add_normal_cone(arc, between, d1);
  }

  // A direction near the bisector of an angle above 45 degrees, and up to 180 degrees, to the left. It has short
  // coordinates, so that it is exactly that of another joint, or not nearly.
  static Exact_pair direction_between(const Exact_pair& d0, const Exact_pair& d1)
  {
    const auto unit = [](const Exact_pair& d) {
      const double x = to_nearest_double(d[0]), y = to_nearest_double(d[1]), length = std::hypot(x, y);
      return std::array<double, 2>{x / length, y / length};
    };
    const auto a = unit(d0), b = unit(d1);
    const auto rounded = [](double x) { return to_rational(std::round(64 * x)); };
    const Exact_pair sum{rounded(a[0] + b[0]), rounded(a[1] + b[1])};
    return sign_of(exact_cross(d0, sum)) > 0 && sign_of(exact_cross(sum, d1)) > 0
        ? sum
        : Exact_pair{Exact_rational(-d0[1]), d0[0]};
  }

  // Adds an element, or puts it together with the last one.
  void add(Region_element element)
  {
    if (!m_elements.empty() && goes_on_as(m_elements.back(), element)) {
      element.range.begin = m_elements.back().range.begin;
      element.exact_directions[0] = m_elements.back().exact_directions[0];
      m_elements.pop_back();
    }
    for (std::size_t k = 0; k < 2; ++k)
      element.directions[k] = {interval_of(element.exact_directions[k][0]),
                               interval_of(element.exact_directions[k][1])};
    m_elements.push_back(std::move(element));
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_REGION_ELEMENTS_2_H
