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
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Foot_search.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <algorithm>
#include <array>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Calls a function with both operands in a form that can be searched; returns whether there is one.
template <class NT, int d, class Function>
bool visit_prepared(const std::array<Located_operand<NT, d>, 2>& operands, const Function& function)
{
  if (operands[0].number_of_axes() + operands[1].number_of_axes() > 2 || !operands[0].is_finite() ||
      !operands[1].is_finite())
    return false;
  const Upward_rounding_guard rounding;
  bool result = false;
  operands[0].visit_prepared([&](const auto& a) {
    operands[1].visit_prepared([&](const auto& b) {
      result = a.is_usable() && b.is_usable();
      if (result)
        function(a, b);
    });
  });
  return result;
}

// The candidates of a search, by increasing distance; nothing if the points of one may be the same.
template <class NT, int d, class Search>
std::optional<Found_distances<d>> found_distances(const std::array<Located_operand<NT, d>, 2>& operands,
                                                  const Search& search)
{
  Found_distances<d> result;
  result.pairs.reserve(search.candidates().size());
  auto& [least, upper] = result.squared_distance;
  const auto is_nearer = [](const Located_distance<d>& x, const Located_distance<d>& y) {
    return x.squared_distance.first < y.squared_distance.first;
  };
  for (const Nearest_candidate<d>& candidate : search.candidates()) {
    Located_distance<d> pair = Exact_candidates<NT, d>(operands)(candidate);
    const auto& [own_least, own_upper] = pair.squared_distance;
    if (const Deferred_rational zero; !(zero < own_least) && zero < own_upper)
      return std::nullopt;
    if (result.pairs.empty() || own_upper < upper)
      upper = own_upper;
    // there are few, and sorting them by parts would take memory
    const auto place = std::upper_bound(result.pairs.begin(), result.pairs.end(), pair, is_nearer);
    result.pairs.insert(place, std::move(pair));
  }
  if (!result.pairs.empty())
    least = result.pairs.front().squared_distance.first;
  result.summary.nodes = search.number_of_parts();
  return result;
}

// The nearest points of two operands, or nothing where doubles do not decide or the run ends before.
template <class NT, int d>
std::optional<Found_distances<d>> nearest_points_in_doubles(const Distance_operand<NT, d>& first,
                                                            const Distance_operand<NT, d>& second,
                                                            const Solver_options& options)
{
  if (Run_control(options).must_stop(true))
    return std::nullopt;
  thread_local Nearest_search<d> search; // for its storage
  const std::array operands{Located_operand<NT, d>(first), Located_operand<NT, d>(second)};
  if (!visit_prepared(operands, [&](const auto& a, const auto& b) { search.find(a, b); }) || !search.is_decided())
    return std::nullopt;
  std::optional<Found_distances<d>> result = found_distances(operands, search);
  if (result)
    std::erase_if(result->pairs, [&](const Located_distance<d>& pair) {
      return result->squared_distance.second < pair.squared_distance.first;
    });
  return result;
}

// The feet of all perpendiculars from a point, or nothing where doubles do not decide.
template <class NT, int d>
std::optional<Found_distances<d>> projections_in_doubles(const Distance_operand<NT, d>& point,
                                                         const Distance_operand<NT, d>& object,
                                                         const Solver_options& options)
{
  if (Run_control(options).must_stop(true))
    return std::nullopt;
  thread_local Foot_search<d> search; // for its storage
  const std::array operands{Located_operand<NT, d>(point), Located_operand<NT, d>(object)};
  const auto find = [&](const auto& p, const auto& spline) {
    if constexpr (requires { search.find(p, spline); })
      search.find(p, spline);
  };
  if (operands[1].number_of_axes() == 0 || !visit_prepared(operands, find) || !search.is_decided())
    return std::nullopt;
  return found_distances(operands, search);
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEAREST_POINTS_IN_DOUBLES_H
