// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CHAINS_OF_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CHAINS_OF_CURVES_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The first (0) or last (1) end of one of several curves.
struct Curve_end
{
  std::size_t curve;
  int side;

  friend bool operator==(const Curve_end&, const Curve_end&) = default;
};

// Joins curves where one goes on in another one: `next(end)` is the end that an end is the same point as, if there is
// one, and the other way round.
template <class Next>
std::vector<Intersection_curve> chains_of_curves(const std::vector<bool>& is_closed, const Next& next)
{
  std::vector<Intersection_curve> result;
  std::vector<bool> is_used(is_closed.size(), false);
  const auto chain = [&](const Curve_end& first) {
    Intersection_curve joined{{}, is_closed[first.curve]};
    for (Curve_end begin = first;;) {
      is_used[begin.curve] = true;
      joined.arcs.push_back({begin.curve, begin.side == 1});
      const std::optional<Curve_end> other =
          joined.is_closed ? std::nullopt : next(Curve_end{begin.curve, 1 - begin.side});
      joined.is_closed = joined.is_closed || other == first;
      if (!other || joined.is_closed)
        return joined;
      begin = *other;
    }
  };
  for (const bool must_end : {true, false})   // first those with ends
    for (std::size_t c = 0; c < is_closed.size(); ++c)
      for (const int side : {0, 1})
        if (const Curve_end begin{c, side}; !is_used[c] && (!must_end || (!is_closed[c] && !next(begin))))
          result.push_back(chain(begin));
  return result;
}

// For each end of some curves (by curve and side) the one that it is the same point as; and those of the given ends
// that do not have just one such partner.
struct Matched_ends
{
  std::vector<std::array<std::optional<Curve_end>, 2>> next;
  std::vector<Curve_end> unmatched;
};

// Matches ends, each with a place, by `may_be(place, other)`. The place where a curve goes on is known to be among the
// given ones, so if there is just one that may be it, and the other way round, they are the same point.
template <class Place, class May_be>
Matched_ends matched_ends(const std::vector<std::pair<Curve_end, Place>>& ends, std::size_t number_of_curves,
                          const May_be& may_be)
{
  std::vector<std::vector<std::size_t>> partners(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (may_be(ends[i].second, ends[j].second)) {
        partners[i].push_back(j);
        partners[j].push_back(i);
      }
  Matched_ends result{std::vector<std::array<std::optional<Curve_end>, 2>>(number_of_curves), {}};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Curve_end& end = ends[i].first;
    if (partners[i].size() == 1 && partners[partners[i][0]].size() == 1)
      result.next[end.curve][static_cast<std::size_t>(end.side)] = ends[partners[i][0]].first;
    else
      result.unmatched.push_back(end);
  }
  return result;
}

// Curves of arcs, joined where one goes on in another one.
template <class Curve>
std::vector<Curve> joined_curves(const std::vector<Curve>& curves, const Matched_ends& ends)
{
  std::vector<bool> is_closed;
  for (const Curve& curve : curves)
    is_closed.push_back(curve.is_closed);
  std::vector<Curve> result;
  for (const Intersection_curve& chain : chains_of_curves(
           is_closed, [&](const Curve_end& end) { return ends.next[end.curve][static_cast<std::size_t>(end.side)]; })) {
    result.push_back({{}, chain.is_closed});
    for (const Intersection_arc& link : chain.arcs) {
      auto arcs = curves[link.index].arcs;
      if (link.is_reversed) {
        std::reverse(arcs.begin(), arcs.end());
        for (auto& arc : arcs)
          arc.is_reversed = !arc.is_reversed;
      }
      result.back().arcs.insert(result.back().arcs.end(), arcs.begin(), arcs.end());
    }
  }
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_CHAINS_OF_CURVES_H
