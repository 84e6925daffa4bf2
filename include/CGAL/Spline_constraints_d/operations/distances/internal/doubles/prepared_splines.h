// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINES_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Nearest_search.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Prepared_spline.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

template <class NT, int d>
std::shared_ptr<const Rounded_spline<d>> prepared(const Homogeneous_spline<NT, d>& spline)
{
  return std::make_shared<const Rounded_spline<d>>(spline);
}

template <class NT, int d>
std::optional<Nearest_location<d>> nearest_location(const std::array<NT, d>& point, const Rounded_spline<d>& spline)
{
  constexpr double rounding = 0x1p-44;   // of a distance that is known
  thread_local Nearest_search<d> search; // for its storage
  const Upward_rounding_guard guard;
  const Point_operand<d> operand(point);
  if (!operand.is_usable() || !spline.is_usable())
    return std::nullopt;
  search.find(operand, spline);
  const Interval squared_distance = search.squared_distance();
  const bool is_unique = search.is_decided() && search.candidates().size() == 1;
  if (!(squared_distance.sup() - squared_distance.inf() <= rounding * squared_distance.sup()) && !is_unique)
    return std::nullopt;
  const Nearest_candidate<d>& nearest = search.candidates().empty()
      ? search.best()
      : *std::min_element(search.candidates().begin(), search.candidates().end(), [](const auto& x, const auto& y) {
          return x.squared_distance.sup() < y.squared_distance.sup();
        });
  Nearest_location<d> result;
  result.squared_distance = {squared_distance.inf(), squared_distance.sup()};
  result.is_unique = is_unique;
  for (int axis = 0; axis < spline.number_of_axes(); ++axis) {
    const auto cell = static_cast<std::size_t>(nearest.cells[1][axis]);
    const double begin = spline.breaks(axis)[cell], end = spline.breaks(axis)[cell + 1];
    const auto placed = [&](double x) { return Interval(begin) + Interval(x) * (Interval(end) - Interval(begin)); };
    const Interval parameter = placed(nearest.parameters[axis]);
    result.parameters[axis] = nearest.parameters[axis] == 1 ? end : parameter.inf();
    result.ranges[axis] = is_unique
        ? std::pair(placed(nearest.ranges[axis].lower).inf(), placed(nearest.ranges[axis].upper).sup())
        : std::pair(begin, end);
  }
  const Piece_point<d> at(spline.piece(nearest.cells[1]), nearest.parameters);
  for (int i = 0; i < d; ++i)
    result.point[i] = at.point[i].inf() / 2 + at.point[i].sup() / 2;
  return result;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINES_H
