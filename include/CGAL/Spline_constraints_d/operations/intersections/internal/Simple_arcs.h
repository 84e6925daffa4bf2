// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SIMPLE_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SIMPLE_ARCS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/arc_directions.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

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
namespace Intersections {

// A part of a curve, on one polynomial or rational piece.
template <int d>
struct Curve_arc
{
  Spline_patch<d> patch;
  // arcs that were cut out of the same one meet each other only where one goes over into the next
  std::size_t source;
  bool is_apart_from_next = false;  // the next arc meets this one only in their common end
};

/*
A curve in parts that are simple: no part meets itself. Then each two parts can be intersected like different curves,
but for successive ones, which have an end in common. They are cut again, so that two parts with a common end that are
left together are a simple arc, if there is a direction in which the curve goes on both sides of this end.
*/
template <int d>
class Simple_arcs
{
  // of parts that shrink by 29/64 or 35/64
  static constexpr int most_cuts = 20, most_regular_cuts = 6, most_trials = 20;
  using Range = Parameter_range;

  Budgeted_solver& m_solve;
  bool m_is_closed;
  std::vector<Curve_arc<d>> m_arcs;
  std::vector<Spline_patch<d>> m_others;

public:
  Simple_arcs(const Spline_patch<d>& curve, Budgeted_solver& solve) : m_solve(solve), m_is_closed(curve.is_closed(0))
  {
    add_pieces(curve, curve.breaks(0));
    cut_at_common_ends();
  }

  std::size_t size() const { return m_arcs.size(); }
  const Spline_patch<d>& operator[](std::size_t i) const { return m_arcs[i].patch; }

  // Parts that are not proved to be simple: points, what is close to a cusp, or what goes back on itself. Some of the
  // arcs come from these.
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
    return m_arcs[i].source == m_arcs[j].source || (next(i) == j && m_arcs[i].is_apart_from_next) ||
        (next(j) == i && m_arcs[j].is_apart_from_next);
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
    m_solve.budget().check();
    const auto directions = axis_directions<d>();
    const bool is_simple = std::any_of(directions.begin(), directions.end(),
                                       [&](const auto& direction) { return is_increasing<d>(piece, direction); }) ||
        has_simple_cusp(piece, m_solve);
    if (!is_simple && cuts > 0 && !piece.is_one_point()) {
      const Range range = piece.domain(0);
      const auto stop = cuts + most_regular_cuts == most_cuts ? place_of_stop(piece) : std::nullopt;
      const Exact_rational cut = stop ? *stop : Exact_rational(range.first + first_part(range));
      add_arcs(piece.part(0, {range.first, cut}), cuts - 1);
      add_arcs(piece.part(0, {cut, range.second}), cuts - 1);
      return;
    }
    m_arcs.push_back({piece, m_arcs.size()});
    if (!is_simple)
      m_others.push_back(piece);
  }

  // Where the curve stops, such as in a cusp, or to turn back, if that is inside of a piece. Rounded to the simplest
  // number, which is the place itself where it is rational.
  std::optional<Exact_rational> place_of_stop(const Spline_patch<d>& piece)
  {
    const auto zeros = zeros_of_derivative<d>(piece, m_solve);
    if (zeros.size() != 1)
      return std::nullopt;
    const Range zero = zeros[0].exact_box()[0], range = piece.domain(0);
    const Exact_rational place = simplest_rational_between(zero.first, zero.second);
    return range.first < place && place < range.second ? std::optional(place) : std::nullopt;
  }

  // Somewhat less than half of a range: in the middle of symmetric curves there are points that would be cut.
  static Exact_rational first_part(const Range& range)
  {
    return Exact_rational((range.second - range.first) * 29 / 64);
  }

  void cut_at_common_ends()
  {
    std::vector<std::vector<Exact_rational>> cuts(size());
    for (std::size_t i = 0; i < size(); ++i) {
      m_solve.budget().check();
      if (const auto other = next(i))
        if (const auto near = simple_neighbourhood(m_arcs[i].patch, m_arcs[*other].patch)) {
          m_arcs[i].is_apart_from_next = true;
          cuts[i].push_back((*near)[0]);
          cuts[*other].push_back((*near)[1]);
        }
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

  // Two successive arcs become a simple one in parts next to their common end, up to these parameters, if they go on
  // along a common direction there. One of them may rest in the common end.
  static std::optional<std::array<Exact_rational, 2>> simple_neighbourhood(Spline_patch<d> before,
                                                                           Spline_patch<d> after)
  {
    const bool rests_before = before.is_one_point(), rests_after = after.is_one_point();
    if (rests_before && rests_after)
      return std::nullopt;
    for (int trial = 0; trial < most_trials; ++trial) {
      const Range first = before.domain(0), second = after.domain(0);
      auto directions = axis_directions<d>();
      directions.push_back(direction_between<d>(chord_of(before), chord_of(after)));
      for (const Exact_vector<d>& direction : directions)
        if ((rests_before || is_increasing<d>(before, direction)) &&
            (rests_after || is_increasing<d>(after, direction)))
          return std::array{first.first, second.second};
      before = before.part(0, {Exact_rational(first.second - first_part(first)), first.second});
      after = after.part(0, {second.first, Exact_rational(second.first + first_part(second))});
    }
    return std::nullopt;
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SIMPLE_ARCS_H
