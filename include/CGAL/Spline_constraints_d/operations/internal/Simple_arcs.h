// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SIMPLE_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SIMPLE_ARCS_H

#include <CGAL/Spline_constraints_d/operations/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <int d>
using Exact_vector = std::array<Exact_rational, d>;

template <int d>
Exact_rational exact_product(const Exact_vector<d>& a, const Exact_vector<d>& b)
{
  Exact_rational result(0);
  for (int i = 0; i < d; ++i)
    result += Exact_rational(a[i] * b[i]);
  return result;
}

// Whether <C, direction> increases strictly along a curve of one piece: its derivative is nowhere negative, and not zero everywhere.
template <int d>
bool is_increasing(const Spline_patch<d>& arc, const Exact_vector<d>& direction)
{
  Exact_function height = arc.numerators()[0] * direction[0];
  for (int i = 1; i < d; ++i)
    if (direction[i] != 0)
      height = height + arc.numerators()[i] * direction[i];
  const Exact_function slope = arc.is_rational() ? height.derivative(0) * arc.weight() - height * arc.weight().derivative(0) : height.derivative(0);
  const auto [least, greatest] = slope.bounds();
  return least >= 0 && greatest > 0;
}

template <int d>
std::vector<Exact_vector<d>> axis_directions()
{
  std::vector<Exact_vector<d>> result;
  for (int i = 0; i < d; ++i)
    for (const int sign : {1, -1}) {
      result.emplace_back().fill(Exact_rational(0));
      result.back()[i] = Exact_rational(sign);
    }
  return result;
}

// From one end of a curve to the other, scaled so that the largest coordinate is 1.
template <int d>
Exact_vector<d> chord_of(const Spline_patch<d>& arc)
{
  const auto [begin, end] = arc.domain(0);
  const Exact_vector<d> from = arc(std::array{begin}), to = arc(std::array{end});
  Exact_vector<d> result;
  Exact_rational largest(0);
  for (int i = 0; i < d; ++i) {
    result[i] = Exact_rational(to[i] - from[i]);
    largest = (std::max)(largest, Exact_rational(CGAL::abs(result[i])));
  }
  if (largest > 0)
    for (Exact_rational& coordinate : result)
      coordinate /= largest;
  return result;
}

// A vector with positive inner products with both, unless they are opposite or zero.
template <int d>
Exact_vector<d> direction_between(const Exact_vector<d>& a, const Exact_vector<d>& b)
{
  const Exact_rational product = exact_product<d>(a, b), a_factor(exact_product<d>(b, b) - product), b_factor(exact_product<d>(a, a) - product);
  Exact_vector<d> result;
  for (int i = 0; i < d; ++i)
    result[i] = Exact_rational(a[i] * a_factor + b[i] * b_factor);
  return exact_product<d>(result, a) > 0 ? result : a;   // zero if they are parallel
}

/*
Whether C' = 0 somewhere on a polynomial curve, and det(C''(s), C'''(t)) has the same sign for all s and t, in the plane of two coordinates. Such a curve has one cusp C(c), and does not meet itself: by Taylor's
formula det(C''(c), C'(t)) is the integral of (t - r) det(C''(c), C'''(r)) from c to t, so that C moves strictly to one side of its tangent in the cusp.
*/
template <int d>
bool has_simple_cusp(const Spline_patch<d>& arc, Summing_solver& solve)
{
  if (arc.is_rational())
    return false;
  Vector_bounds<d> second, third;
  for (int i = 0; i < d; ++i) {
    const Exact_function derivative = arc.numerators()[i].derivative(0).derivative(0);
    second[i] = Rational_interval(derivative.bounds());
    third[i] = Rational_interval(derivative.derivative_bounds(0));
  }
  bool has_one_sign = false;
  for (int i = 0; i < d; ++i)
    for (int k = 0; k < i; ++k) {
      const Rational_interval determinant = second[i] * third[k] - second[k] * third[i];
      has_one_sign = has_one_sign || determinant.lower > 0 || determinant.upper < 0;
    }
  if (!has_one_sign)
    return false;
  const auto [begin, end] = arc.domain(0);
  const std::vector<Unknown> t = unknowns({std::array<Bound, 2>{Bound(begin), Bound(end)}});
  const Vector_expression<d> tangent = Parametric_vector<d>(arc).tangent(0)(t);
  std::vector<Constraint> constraints;
  for (int i = 0; i < d; ++i)
    if (const Constraint constraint = tangent[i] == 0; !constraint.function.is_zero())
      constraints.push_back(constraint);
  return solve(constraints).count(Solution_kind::CERTIFIED) == 1;
}

// A part of a curve, on one polynomial or rational piece.
template <int d>
struct Curve_arc
{
  Spline_patch<d> patch;
  std::size_t source;               // arcs that were cut out of the same one meet each other only where one goes over into the next
  bool is_apart_from_next = false;  // the next arc meets this one only in their common end
};

/*
A curve in parts that are simple: no part meets itself. Then each two parts can be intersected like different curves, but for successive ones, which have an end in common. They are cut again, so that two parts with
a common end that are left together are a simple arc, if there is a direction in which the curve goes on both sides of this end.
*/
template <int d>
class Simple_arcs
{
  static constexpr int most_cuts = 24, most_trials = 24;   // of parts that shrink by 29/64 or 35/64
  using Range = Parameter_range;

  Summing_solver& m_solve;
  bool m_is_closed;
  std::vector<Curve_arc<d>> m_arcs;
  std::vector<Spline_patch<d>> m_others;

public:
  Simple_arcs(const Spline_patch<d>& curve, Summing_solver& solve) : m_solve(solve), m_is_closed(curve.is_closed(0))
  {
    add_pieces(curve, curve.breaks(0));
    cut_at_common_ends();
  }

  std::size_t size() const { return m_arcs.size(); }
  const Spline_patch<d>& operator[](std::size_t i) const { return m_arcs[i].patch; }

  // Parts that are not proved to be simple: points, what is close to a cusp, or what goes back on itself. Some of the arcs come from these.
  const std::vector<Spline_patch<d>>& others() const { return m_others; }

  // The number of the arc behind the end of an arc. On a closed curve the first one follows the last one.
  std::optional<std::size_t> next(std::size_t i) const
  {
    if (i + 1 < size())
      return i + 1;
    return m_is_closed && i > 0 ? std::optional<std::size_t>(0) : std::nullopt;
  }

  // The number of the arc before the begin of one.
  std::optional<std::size_t> previous(std::size_t i) const
  {
    if (i > 0)
      return i - 1;
    return next(size() - 1) ? std::optional(size() - 1) : std::nullopt;
  }

  // Whether two arcs have no common points but an end at which one goes over into the other.
  bool are_apart(std::size_t i, std::size_t j) const
  {
    return m_arcs[i].source == m_arcs[j].source || (next(i) == j && m_arcs[i].is_apart_from_next) || (next(j) == i && m_arcs[j].is_apart_from_next);
  }

private:
  // By halves, so that no spline of all breaks is cut again and again.
  void add_pieces(const Spline_patch<d>& curve, std::span<const Exact_rational> breaks)
  {
    if (breaks.size() == 2)
      return add_arcs(curve, most_cuts);
    const std::size_t middle = breaks.size() / 2;
    add_pieces(curve.part(0, {breaks.front(), breaks[middle]}), breaks.first(middle + 1));
    add_pieces(curve.part(0, {breaks[middle], breaks.back()}), breaks.subspan(middle));
  }

  // A piece in arcs along each of which a coordinate increases or decreases.
  void add_arcs(const Spline_patch<d>& piece, int cuts)
  {
    const auto directions = axis_directions<d>();
    const bool is_simple = std::any_of(directions.begin(), directions.end(), [&](const auto& direction) { return is_increasing<d>(piece, direction); }) || has_simple_cusp(piece, m_solve);
    if (!is_simple && cuts > 0 && !piece.is_one_point()) {
      const Range range = piece.domain(0);
      const Exact_rational cut(range.first + first_part(range));
      add_arcs(piece.part(0, {range.first, cut}), cuts - 1);
      add_arcs(piece.part(0, {cut, range.second}), cuts - 1);
      return;
    }
    m_arcs.push_back({piece, m_arcs.size()});
    if (!is_simple)
      m_others.push_back(piece);
  }

  // Somewhat less than half of a range: in the middle of symmetric curves there are points that would be cut.
  static Exact_rational first_part(const Range& range) { return Exact_rational((range.second - range.first) * 29 / 64); }

  void cut_at_common_ends()
  {
    std::vector<std::vector<Exact_rational>> cuts(size());
    for (std::size_t i = 0; i < size(); ++i)
      if (const auto other = next(i))
        if (const auto near = simple_neighbourhood(m_arcs[i].patch, m_arcs[*other].patch)) {
          m_arcs[i].is_apart_from_next = true;
          cuts[i].push_back((*near)[0]);
          cuts[*other].push_back((*near)[1]);
        }
    std::vector<Curve_arc<d>> result;
    for (std::size_t i = 0; i < size(); ++i)
      append_parts(result, m_arcs[i], std::move(cuts[i]));
    m_arcs = std::move(result);
  }

  // The parts between these parameters, those at the ends of the arc left out.
  static void append_parts(std::vector<Curve_arc<d>>& all, const Curve_arc<d>& arc, std::vector<Exact_rational> cuts)
  {
    const auto [begin, end] = arc.patch.domain(0);
    cuts.insert(cuts.end(), {begin, end});
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t k = 1; k < cuts.size(); ++k)
      all.push_back({arc.patch.part(0, {cuts[k - 1], cuts[k]}), arc.source});
    all.back().is_apart_from_next = arc.is_apart_from_next;
  }

  // Two successive arcs become a simple one in parts next to their common end, up to these parameters, if they go on along a common direction there. One of them may rest in the common end.
  static std::optional<std::array<Exact_rational, 2>> simple_neighbourhood(Spline_patch<d> before, Spline_patch<d> after)
  {
    const bool rests_before = before.is_one_point(), rests_after = after.is_one_point();
    if (rests_before && rests_after)
      return std::nullopt;
    for (int trial = 0; trial < most_trials; ++trial) {
      const Range first = before.domain(0), second = after.domain(0);
      auto directions = axis_directions<d>();
      directions.push_back(direction_between<d>(chord_of(before), chord_of(after)));
      for (const Exact_vector<d>& direction : directions)
        if ((rests_before || is_increasing<d>(before, direction)) && (rests_after || is_increasing<d>(after, direction)))
          return std::array{first.first, second.second};
      before = before.part(0, {Exact_rational(first.second - first_part(first)), first.second});
      after = after.part(0, {second.first, Exact_rational(second.first + first_part(second))});
    }
    return std::nullopt;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SIMPLE_ARCS_H
