// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_BRANCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_BRANCH_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// What happens between two envelope arcs of an element.
enum class Disk_event { NONE, CROSSING, JOINT, TIP, UNRESOLVED };

// A point that disks may touch, as a function of the parameter of the element.
struct Disk_branch : Located_footpoint
{
  // Where k_v at a point of the arc, or at the point of the element itself, may change its sign over the part: the
  // footpoint where it is positive, and where it is negative.
  struct Move
  {
    Disk_event event;
    std::size_t arc;
    double parameter;   // not used at tips
    Located_footpoint positive, negative;
    // Where two arcs join nearly smoothly: their ends, that of the negative footpoint first; k_v has the same sign at
    // both of them, up to a small range, in which disks may touch the vertex.
    std::optional<std::array<Arc_end, 2>> joined_ends{};
    std::optional<Located_footpoint> between{};
  };
  std::optional<Move> move{};
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_BRANCH_H
