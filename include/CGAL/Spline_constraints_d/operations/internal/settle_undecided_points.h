// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SETTLE_UNDECIDED_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SETTLE_UNDECIDED_POINTS_H

#include <CGAL/Spline_constraints_d/operations/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/internal/Curve_parts.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A common point of two curves at breaks of both, which is not proved to count once; none where it is found elsewhere.
template <int d>
std::optional<Common_point> point_at_breaks(const Patch_pair<d>& pair, const Exact_parameters& parameters)
{
  Common_point result{Intersection_kind::TANGENT, {}, {}, std::nullopt, false};
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const auto [begin, end] = pair[j].domain(0);
    if (parameters[j] == end && pair.is_repeated_at_end(j))
      return std::nullopt;
    result.parameters.emplace_back(parameters[j], parameters[j]);
    result.is_at_end.push_back(parameters[j] == begin || parameters[j] == end);
  }
  return result;
}

/*
Boxes of parameters of two planar curves that the solver could not decide, but elimination does: curves that are nearly the same between breaks, touch each other there, or end next to each other. Those without common points go, those with common points at
breaks of both alone become these points, once.
*/
template <int d>
void settle_undecided_points(const Patch_pair<d>& pair, std::vector<Common_point>& points)
{
  const auto is_undecided = [](const Common_point& point) { return point.kind == Intersection_kind::UNDECIDED; };
  if (d != 2 || pair.number_of_parameters() != 2 || pair.first_parameter(1) != 1 || std::none_of(points.begin(), points.end(), is_undecided))
    return;
  Curve_parts<d> parts(pair);
  std::vector<Exact_parameters> settled;
  std::erase_if(points, [&](const Common_point& point) {
    if (!is_undecided(point))
      return false;
    const std::vector<Exact_parameters> known = parts.common_breaks(point.parameters);
    if (!parts.holds_only(point.parameters, known))
      return false;
    settled.insert(settled.end(), known.begin(), known.end());
    return true;
  });
  for (const Exact_parameters& parameters : settled)
    if (std::optional<Common_point> point = point_at_breaks(pair, parameters))
      if (std::none_of(points.begin(), points.end(), [&](const Common_point& other) { return other.kind != Intersection_kind::OVERLAP && is_part_of(point->parameters, other.parameters); }))
        points.push_back(std::move(*point));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_SETTLE_UNDECIDED_POINTS_H
