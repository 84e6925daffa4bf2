// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_PARTS_OF_BOUNDARIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_PARTS_OF_BOUNDARIES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Uncertain.h>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// Of a boundary that does not know its outer boundary.
inline constexpr std::size_t no_boundary = (std::numeric_limits<std::size_t>::max)();

/*
Finds the outer boundary of each hole, the innermost one around it. Those of the parts are their own ones already.
Returns the holes for which it is not certain; these have none.

`is_around(b, c)` tells whether an outer boundary is around another boundary, if that is certain.
*/
template <class Boundary, class Is_around>
std::vector<std::size_t> find_outer_boundaries(std::vector<Boundary>& boundaries, const Is_around& is_around)
{
  std::vector<std::size_t> outer, undecided;
  for (std::size_t b = 0; b < boundaries.size(); ++b)
    if (boundaries[b].outer == b)
      outer.push_back(b);
  for (std::size_t hole = 0; hole < boundaries.size(); ++hole)
    if (boundaries[hole].is_hole) {
      std::optional<std::size_t> innermost;
      bool is_certain = true;
      for (const std::size_t b : outer)
        if (const CGAL::Uncertain<bool> has_hole = is_around(b, hole); CGAL::possibly(has_hole)) {
          const CGAL::Uncertain<bool> is_inner =
              innermost ? CGAL::Uncertain<bool>(is_around(*innermost, b)) : CGAL::Uncertain<bool>(true);
          is_certain = is_certain && has_hole.is_certain() && is_inner.is_certain();
          if (CGAL::certainly(is_inner))
            innermost = b;
        }
      if (is_certain && innermost)
        boundaries[hole].outer = *innermost;
      else
        undecided.push_back(hole);
    }
  return undecided;
}

// The connected parts of a set: the index of the outer boundary of each, and behind it those of its holes. Boundaries
// that do not know their outer boundary are left out.
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
    if (const std::optional<std::size_t> outer = boundaries[b].outer;
        boundaries[b].is_hole && outer && *outer < boundaries.size())
      result[part_of[*outer]].push_back(b);
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

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_PARTS_OF_BOUNDARIES_H
