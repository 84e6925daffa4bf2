// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAR_BOXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAR_BOXES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Errors of coordinates, relative to the greatest of them, that rounding and a few operations leave.
constexpr double rounding_of_coordinates = 0x1p-48;

// Ranges of coordinates, wider by a margin on both sides.
template <int d>
Indexed_box<d> widened_box(const std::array<std::pair<double, double>, d>& ranges, double margin, std::size_t index)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double wide = std::nextafter(margin, infinity);
  double lower[d], upper[d];
  for (int i = 0; i < d; ++i) {
    lower[i] = std::nextafter(ranges[i].first - wide, -infinity);
    upper[i] = std::nextafter(ranges[i].second + wide, infinity);
  }
  return Indexed_box<d>(lower, upper, index);
}

// The indices of all pairs of boxes that meet, the greater one first, in order.
template <int d>
std::vector<std::pair<std::size_t, std::size_t>> meeting_pairs(std::vector<Indexed_box<d>> boxes)
{
  std::vector<std::pair<std::size_t, std::size_t>> result;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Indexed_box<d>& a, const Indexed_box<d>& b) {
    result.emplace_back((std::max)(a.info(), b.info()), (std::min)(a.info(), b.info()));
  });
  std::sort(result.begin(), result.end());
  return result;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_NEAR_BOXES_H
