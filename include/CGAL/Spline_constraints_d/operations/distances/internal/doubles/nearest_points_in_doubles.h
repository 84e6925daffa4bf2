// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_POINTS_IN_DOUBLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_POINTS_IN_DOUBLES_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Exact_candidates.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Whether all nearest points of two operands with two parameters at most are candidates of a search in doubles.
template <class NT, int d>
bool find_nearest(const std::array<Located_operand<NT, d>, 2>& operands, Nearest_search<d>& search)
{
  if (operands[0].number_of_axes() + operands[1].number_of_axes() > 2 || !operands[0].is_finite() ||
      !operands[1].is_finite())
    return false;
  const Upward_rounding_guard rounding;
  bool is_usable = false;
  operands[0].visit_prepared([&](const auto& a) {
    operands[1].visit_prepared([&](const auto& b) {
      is_usable = a.is_usable() && b.is_usable();
      if (is_usable)
        search.find(a, b);
    });
  });
  return is_usable && search.is_decided();
}

// The nearest points of two operands, or nothing where doubles do not decide.
template <class NT, int d>
std::optional<Found_distances<d>> nearest_points_in_doubles(const Distance_operand<NT, d>& first,
                                                            const Distance_operand<NT, d>& second)
{
  thread_local Nearest_search<d> search; // for its storage
  const std::array operands{Located_operand<NT, d>(first), Located_operand<NT, d>(second)};
  if (!find_nearest(operands, search))
    return std::nullopt;
  Found_distances<d> result;
  auto& [least, upper] = result.squared_distance;
  for (const Nearest_candidate<d>& candidate : search.candidates()) {
    result.pairs.push_back(Exact_candidates<NT, d>(operands)(candidate));
    const Rational_interval& range = result.pairs.back().distance.squared_distance;
    if (range.lower <= 0 && range.upper > 0)
      return std::nullopt; // they may meet there
    if (result.pairs.size() == 1 || range.upper < upper)
      upper = range.upper;
  }
  const auto lower_of = [](const Located_distance<d>& pair) { return pair.distance.squared_distance.lower; };
  std::erase_if(result.pairs, [&](const auto& pair) { return lower_of(pair) > upper; });
  std::stable_sort(result.pairs.begin(), result.pairs.end(),
                   [&](const auto& x, const auto& y) { return lower_of(x) < lower_of(y); });
  least = lower_of(result.pairs.front());
  result.summary.nodes = search.number_of_parts();
  return result;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_POINTS_IN_DOUBLES_H
