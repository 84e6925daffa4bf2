// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CHAINS_OF_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CHAINS_OF_CURVES_H

#include <CGAL/Spline_constraints_d/operations/Intersection_curve.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The first (0) or last (1) end of one of several curves.
struct Curve_end
{
  std::size_t curve;
  int side;

  friend bool operator==(const Curve_end&, const Curve_end&) = default;
};

// Joins curves where one goes on in another one: `next(end)` is the end that an end is the same point as, if there is one, and the other way round.
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
      const std::optional<Curve_end> other = joined.is_closed ? std::nullopt : next(Curve_end{begin.curve, 1 - begin.side});
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

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CHAINS_OF_CURVES_H
