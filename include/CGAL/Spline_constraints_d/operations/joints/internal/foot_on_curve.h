// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_INTERNAL_FOOT_ON_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_INTERNAL_FOOT_ON_CURVE_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_operand.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/near_boxes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Joints {

// The greatest absolute value of a coordinate.
template <class Point>
double magnitude_of(const Point& p)
{
  return (std::max)(std::abs(CGAL::to_double(p.x())), std::abs(CGAL::to_double(p.y())));
}

template <class FT>
FT simplest_number_between(const FT& lower, const FT& upper)
{
  return converted_number<FT>(
      simplest_rational_between(converted_number<Exact_rational>(lower), converted_number<Exact_rational>(upper)));
}

// Of the point of a curve that is nearest to another one, rounded.
template <class Kernel>
typename Kernel::FT nearest_parameter(const Bspline_curve_2<Kernel>& curve, const typename Kernel::Point_2& point)
{
  using FT = typename Kernel::FT;
  const auto [begin, end] = curve.domain();
  std::optional<std::pair<FT, FT>> nearest;
  Critical_distances<2> distances(Spline_operand<typename Kernel::Point_2>::patch(point), Spline_patch<2>(curve),
                                  least_distance, {});
  for (const Critical_distance& found : distances.nearest()) {
    const FT t = std::clamp(converted_number<FT>(to_nearest_double(found.sample[1][0])), begin, end);
    if (const FT distance = CGAL::squared_distance(point, curve(t)); !nearest || distance < nearest->first)
      nearest = {distance, t};
  }
  return nearest->second;
}

// Of the point that has the simplest parameter of those as near to the nearest one as that is to the given point, or
// as coordinates are rounded; none in the ends.
template <class Kernel>
std::optional<typename Kernel::FT> simplest_parameter(const Bspline_curve_2<Kernel>& curve,
                                                      const typename Kernel::Point_2& point,
                                                      const typename Kernel::FT& nearest, double most_distance)
{
  using FT = typename Kernel::FT;
  using Point = typename Kernel::Point_2;
  constexpr int most_halvings = 60;
  const auto [begin, end] = curve.domain();
  if (nearest == begin || nearest == end)
    return std::nullopt;
  const FT error = converted_number<FT>(0x1p-50 * CGAL::to_double(CGAL::abs(nearest)));
  if (const FT t = simplest_number_between(FT(nearest - error), FT(nearest + error));
      begin < t && t < end && curve(t) == point)
    return t;
  const Point foot = curve(nearest);
  double largest_coordinate = 0;
  for (const Point& p : curve.control_points())
    largest_coordinate = (std::max)(largest_coordinate, magnitude_of(p));
  const double distance = std::sqrt(CGAL::to_double(CGAL::squared_distance(point, foot))),
               way = (std::min)(most_distance, (std::max)(distance, rounding_of_coordinates * largest_coordinate)),
               speed = std::sqrt(CGAL::to_double(curve.tangent(nearest).squared_length()));
  FT width = (std::min)(FT(nearest - begin), FT(end - nearest)) / 2;
  if (speed > 0 && way / speed < CGAL::to_double(width))
    width = converted_number<FT>(way / speed);
  for (int i = 0; i < most_halvings && width > 0; ++i, width = width / 2) {
    const FT t = simplest_number_between(FT(nearest - width), FT(nearest + width));
    if (CGAL::to_double(CGAL::squared_distance(foot, curve(t))) <= way * way)
      return t;
  }
  return nearest;
}

} // namespace Joints
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_INTERNAL_FOOT_ON_CURVE_H
