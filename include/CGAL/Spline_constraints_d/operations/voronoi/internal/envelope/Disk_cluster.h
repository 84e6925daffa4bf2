// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_CLUSTER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_CLUSTER_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A range of an arc that disks may touch over a part of an element, and what is known of the maximum of their
// curvature.
template <Enclosing_number Interval = Common::Interval>
struct Disk_cluster
{
  // of an arc's end: k_v leads from it into the arc; to it; does not matter; or is not known
  enum class End_state
  {
    NOT_A_MAXIMUM,
    MAXIMUM,
    TOO_LOW,
    UNKNOWN
  };

  std::size_t arc;
  Range range;
  Curvature_bounds<Interval> bounds{};
  bool is_known = false;   // to have one maximum inside
  bool is_too_low = false;
  double least = -std::numeric_limits<double>::infinity();   // other maxima are less than that
  Corner_of_disks corner{};
  std::array<End_state, 2> ends{End_state::NOT_A_MAXIMUM, End_state::NOT_A_MAXIMUM};
  bool touches(bool end) const { return end ? range.end == 1 : range.begin == 0; }
  bool has_inner_maximum() const { return ends[0] != End_state::MAXIMUM && ends[1] != End_state::MAXIMUM; }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_CLUSTER_H
