// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_ENVELOPE_ARC_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_ENVELOPE_ARC_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The end of an envelope arc of disks in the corner of a pocket, and the curvature of the disk at the other end.
struct Corner_end
{
  bool is_end;
  Interval curvature;
};

// An envelope arc of an element whose maximal disks touch the same thing elsewhere, and what happens at its ends, where
// the event is located by a range of the parameter.
struct Envelope_arc
{
  Disk_footpoint footpoint;
  Range range;
  std::array<Disk_event, 2> events{Disk_event::NONE, Disk_event::NONE};
  // ranges of the element in order, and where the footpoint is
  std::vector<std::pair<Range, Located_footpoint>> boxes{};
  // where disks are in a pocket, which is smaller than doubles can tell
  std::optional<Corner_end> corner{};
  bool holds_events = false;   // at its ends; they are not known any better

  const Located_footpoint& located(double u) const
  {
    return std::partition_point(boxes.begin(), boxes.end() - 1, [u](const auto& b) { return b.first.end < u; })->second;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_ENVELOPE_ARC_H
