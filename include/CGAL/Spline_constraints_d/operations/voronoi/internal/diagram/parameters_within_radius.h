// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_PARAMETERS_WITHIN_RADIUS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_PARAMETERS_WITHIN_RADIUS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A parameter between two others where a radius is not too large: one of both, the middle, or one of others between;
// none if there is none among these.
template <class Radius_at>
std::optional<double> any_within(const std::array<double, 2>& ends, const Radius_at& radius_at, double most_radius)
{
  constexpr int parts = 32;
  const auto is_within = [&](double u) { return !(radius_at(u) > most_radius); };
  for (const double end : ends)
    if (is_within(end))
      return end;
  for (int step = parts / 2; step >= 1; step /= 2)
    for (int i = step; i < parts; i += 2 * step)
      if (const double u = ends[0] + (ends[1] - ends[0]) * i / parts; is_within(u))
        return u;
  return std::nullopt;
}

// The last parameter where a radius is not too large. Where it jumps from there to the next number, by more than
// rounding, that is told.
struct Last_within_radius
{
  double parameter;
  std::optional<double> jump{};
};

// On the way from a parameter where the radius is not too large to an end.
template <class Radius_at>
Last_within_radius last_within(double inner, double end, const Radius_at& radius_at, double most_radius)
{
  constexpr int steps = 40;              // more where the radius grows fast
  constexpr double least_share = 0.984375;   // of the most radius, that is reached
  if (!(radius_at(end) > most_radius))
    return {end};
  double greatest = radius_at(inner);
  for (int i = 0; i < steps || greatest < least_share * most_radius; ++i) {
    const double between = inner / 2 + end / 2;
    if (between == inner || between == end)
      break;
    const double radius = radius_at(between);
    if (radius > most_radius) {
      end = between;
    } else {
      inner = between;
      greatest = radius;
    }
  }
  return {inner, greatest < least_share * most_radius ? std::optional(end) : std::nullopt};
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_PARAMETERS_WITHIN_RADIUS_H
