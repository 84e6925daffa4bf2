// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SETTLE_UNDECIDED_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SETTLE_UNDECIDED_POINTS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Curve_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A common point of two curves at a break of one or both, which is not proved to count once; none where it is found
// elsewhere.
template <int d>
std::optional<Common_point> point_at_break(const Patch_pair<d>& pair, const Parameter_box& parameters)
{
  Common_point result{Intersection_kind::TANGENT, parameters, {}, std::nullopt, false};
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    const auto [begin, end] = pair[j].domain(0);
    if (parameters[j].first == end && pair.is_repeated_at_end(j))
      return std::nullopt;
    result.is_at_end.push_back(parameters[j].second == begin || parameters[j].first == end);
  }
  return result;
}

/*
Boxes of parameters of two planar curves that the solver could not decide, but elimination does: curves that are nearly
the same between breaks, touch each other there, end next to each other, or cross at a very small angle. Those without
common points go, those with common points at breaks of both alone become these points, once, and those with points at
breaks of one or with crossings, too, if no other answer may be the same one.
*/
template <int d>
void settle_undecided_points(const Patch_pair<d>& pair, std::vector<Common_point>& points)
{
  const auto is_undecided = [](const Common_point& point) { return point.kind == Intersection_kind::UNDECIDED; };
  if constexpr (d == 2) {
    if (pair.number_of_parameters() != 2 || pair.first_parameter(1) != 1 ||
        std::none_of(points.begin(), points.end(), is_undecided))
      return;
    Curve_parts<d> parts(pair, points);
    const std::vector<Common_point> all = points;
    std::vector<Parameter_box> at_breaks, crossings;
    const auto meet = [&](const Parameter_box& box) {
      return std::count_if(all.begin(), all.end(), [&](const Common_point& other) {
        return other.kind != Intersection_kind::OVERLAP && have_common_part(box, other.parameters);
      });
    };
    std::erase_if(points, [&](const Common_point& point) {
      if (!is_undecided(point))
        return false;
      const std::vector<Exact_parameters> at_both = parts.common_breaks(point.parameters);
      std::vector<Parameter_box> known = parts.points_at_one_break(point.parameters);
      std::vector<Parameter_box> found = known, crossed;
      for (Settled_part& part : parts.parts_at_simple_zeros(point.parameters)) {
        if (part.crossing)
          crossed.push_back(std::move(*part.crossing));
        known.push_back(std::move(part.box));
      }
      const auto may_be_others = [&](const Parameter_box& box) { return meet(box) > 1; };
      if (!parts.holds_only(point.parameters, at_both, nullptr, known) ||
          std::any_of(found.begin(), found.end(), may_be_others) ||
          std::any_of(crossed.begin(), crossed.end(), may_be_others))
        return false;
      for (const Exact_parameters& parameters : at_both)
        found.push_back({{parameters[0], parameters[0]}, {parameters[1], parameters[1]}});
      at_breaks.insert(at_breaks.end(), found.begin(), found.end());
      crossings.insert(crossings.end(), crossed.begin(), crossed.end());
      return true;
    });
    for (const Parameter_box& parameters : crossings)
      points.push_back({Intersection_kind::TRANSVERSAL, parameters, {false, false}, std::nullopt, false});
    for (const Parameter_box& parameters : at_breaks)
      if (std::optional<Common_point> point = point_at_break(pair, parameters))
        if (std::none_of(points.begin(), points.end(), [&](const Common_point& other) {
              return other.kind != Intersection_kind::OVERLAP && is_part_of(parameters, other.parameters);
            }))
          points.push_back(std::move(*point));
  }
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SETTLE_UNDECIDED_POINTS_H
