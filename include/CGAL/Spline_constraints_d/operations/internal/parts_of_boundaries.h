// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_PARTS_OF_BOUNDARIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_PARTS_OF_BOUNDARIES_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The connected parts of a set: the index of the outer boundary of each, and behind it those of its holes. Boundaries that do not know their outer boundary, a number that is no index, are left out.
template <class Boundary>
std::vector<std::vector<std::size_t>> parts_of_boundaries(const std::vector<Boundary>& boundaries)
{
  std::vector<std::vector<std::size_t>> result;
  std::vector<std::size_t> part_of(boundaries.size());
  for (std::size_t b = 0; b < boundaries.size(); ++b)
    if (boundaries[b].outer == b) {
      part_of[b] = result.size();
      result.push_back({b});
    }
  for (std::size_t b = 0; b < boundaries.size(); ++b)
    if (boundaries[b].is_hole && boundaries[b].outer < boundaries.size())
      result[part_of[boundaries[b].outer]].push_back(b);
  return result;
}

// One polygon for each part; `polygon(b)` makes a boundary.
template <class Polygon_with_holes, class Boundary, class Polygon_of>
std::vector<Polygon_with_holes> polygons_of_parts(const std::vector<Boundary>& boundaries, const Polygon_of& polygon)
{
  std::vector<Polygon_with_holes> result;
  for (const std::vector<std::size_t>& part : parts_of_boundaries(boundaries)) {
    result.emplace_back(polygon(part.front()));
    for (std::size_t i = 1; i < part.size(); ++i)
      result.back().add_hole(polygon(part[i]));
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_PARTS_OF_BOUNDARIES_H
