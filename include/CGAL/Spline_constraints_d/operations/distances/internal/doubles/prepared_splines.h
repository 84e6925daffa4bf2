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
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Ray_search.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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
  const Upward_rounding_guard guard; // as for those that are not prepared, so that answers are the same
  const auto result = std::make_shared<Rounded_spline<d>>(spline);
  result->prepare();
  return result;
}

// Of a range in a piece. Rounding has to be upward.
template <int d>
std::pair<double, double> spline_range(const Rounded_spline<d>& spline, int axis, int cell, const Double_range& range)
{
  const Interval begin(spline.breaks(axis)[static_cast<std::size_t>(cell)]),
      width = Interval(spline.breaks(axis)[static_cast<std::size_t>(cell) + 1]) - begin;
  return {(begin + Interval(range.lower) * width).inf(), (begin + Interval(range.upper) * width).sup()};
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
    const int cell = nearest.cells[1][axis];
    const double x = nearest.parameters[axis], end = spline.breaks(axis)[static_cast<std::size_t>(cell) + 1];
    result.parameters[axis] = x == 1 ? end : spline_range(spline, axis, cell, {x, x}).first;
    result.ranges[axis] = spline_range(spline, axis, cell, is_unique ? nearest.ranges[axis] : Double_range{0, 1});
  }
  const Piece_point<d> at(spline.piece(nearest.cells[1]), nearest.parameters);
  for (int i = 0; i < d; ++i)
    result.point[i] = at.point[i].inf() / 2 + at.point[i].sup() / 2;
  return result;
}

template <class NT, int d>
First_hit<d> first_hit(const std::array<NT, d>& source, const std::array<NT, d>& second,
                       const Rounded_spline<d>& spline)
{
  thread_local Ray_search<d> search; // for its storage
  const Upward_rounding_guard guard;
  First_hit<d> result;
  std::array<double, d> from;
  std::array<Interval, d> direction;
  for (int i = 0; i < d; ++i) {
    from[i] = nearest_double(source[i]);
    const double to = nearest_double(second[i]);
    if (!is_double(source[i], from[i]) || !is_double(second[i], to) || !std::isfinite(from[i]) || !std::isfinite(to))
      return result;
    direction[i] = Interval(to) - Interval(from[i]);
  }
  if (!spline.is_usable() || spline.number_of_axes() != d - 1)
    return result;
  search.find_first(from, direction, spline);
  result.is_decided = search.is_decided() && search.hits().size() <= 1;
  result.is_found = result.is_decided && search.hits().size() == 1;
  if (!result.is_found)
    return result;
  const Ray_hit<d>& hit = search.hits().front();
  result.along = {hit.along.inf(), hit.along.sup()};
  for (int axis = 0; axis < d - 1; ++axis)
    result.ranges[axis] = spline_range(spline, axis, hit.cell[axis], hit.ranges[axis]);
  for (int i = 0; i < d; ++i)
    result.point[i] = hit.point[i].inf() / 2 + hit.point[i].sup() / 2;
  return result;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PREPARED_SPLINES_H
