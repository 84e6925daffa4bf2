// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_JOINT_PLACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_JOINT_PLACE_H

#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

// A point on the boundary of a part of the plane of two parameters, where the next part has the same solutions: ranges
// of both parameters, and two points of a line that it lies on.
struct Joint_place
{
  std::array<std::pair<Exact_rational, Exact_rational>, 2> ranges;
  std::array<Exact_vector<2>, 2> line;

  // Whether both may be the same point: on the same line, and within ranges that meet. All solutions on the line are
  // known on both of its sides, so if a place meets just one, they are the same.
  bool may_be(const Joint_place& other) const
  {
    for (const Exact_vector<2>& p : other.line)
      if ((line[1][0] - line[0][0]) * (p[1] - line[0][1]) != (line[1][1] - line[0][1]) * (p[0] - line[0][0]))
        return false;
    for (const std::size_t i : {0, 1})
      if (ranges[i].second < other.ranges[i].first || other.ranges[i].second < ranges[i].first)
        return false;
    return true;
  }
};

// A pair of parameters that are known exactly, as in a corner of several parts. Where the tangent jumps, what is a
// solution depends on the side that it is taken from: 1 after the parameter, -1 before it; 0 where it does not jump.
struct Joint_corner
{
  Exact_vector<2> pair;
  std::array<int, 2> sides{};

  friend bool operator==(const Joint_corner&, const Joint_corner&) = default;
};

} // namespace Loci
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_INTERNAL_JOINT_PLACE_H
