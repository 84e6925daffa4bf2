// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_CANDIDATE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_CANDIDATE_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A node of the tree, a range of an arc, or an isolated vertex.
enum class Candidate_kind { NODE, ARC, VERTEX };

// What maximal disks may touch.
template <Enclosing_number Interval = Common::Interval>
struct Disk_candidate
{
  using Kind = Candidate_kind;

  Kind kind;
  std::size_t index;
  Range range{};
  Curve_jet<Interval> jet{};              // of an arc
  Curvature_bounds<Interval> bounds{};    // over a part of an element and the range
  Interval at_middle = any_number<Interval>();   // the curvature for the middles of both
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_DISK_CANDIDATE_H
