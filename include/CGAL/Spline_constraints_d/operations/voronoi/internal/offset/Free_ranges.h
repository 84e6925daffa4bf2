// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_RANGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_RANGES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Rational_disk.h>

#include <array>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A disk that touches an element in a point that is known exactly: its center, and the way there from that point.
struct Exact_disk : Rational_disk
{
  Exact_pair way;

  Exact_disk(const Exact_pair& point, const Exact_pair& to_center)
    : Rational_disk{{Exact_rational(point[0] + to_center[0]), Exact_rational(point[1] + to_center[1])},
                    exact_dot(to_center, to_center)},
      way(to_center)
  {}
};

// Where a range of an element ends in which disks are free: where the element ends; where it ends and disks shrink to
// the vertex there; where the disk has a second footpoint; where it has one that is known exactly, as is the center of
// the disk (see Opposite_sites, Touching_disk); or somewhere in a range that is not decided.
struct Free_end
{
  enum class Kind { FRONT_END, POINT, FOOTPOINT, TIE, UNDECIDED };

  Kind kind = Kind::FRONT_END;
  Range location{};             // holds the parameter
  Disk_footpoint footpoint{};       // the second one
  Range footpoint_location{};     // on an arc
  std::optional<Exact_disk> disk = std::nullopt;   // with an exact second footpoint
};

using Free_range = std::array<Free_end, 2>;   // begin, end

// The ranges of an element in which disks are free, in order, and those that are not decided.
struct Free_ranges
{
  std::vector<Free_range> free;
  std::vector<Range> undecided;
  bool is_point = false;   // the element is an arc of a circle, and all disks are the one in that
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_RANGES_H
