// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_CANDIDATE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_CANDIDATE_H

#include <CGAL/Spline_constraints_d/operations/internal/Curvature_bounds.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What maximal disks may touch: a node of the tree, a range of an arc, or an isolated vertex.
struct Disk_candidate
{
  enum class Kind { NODE, ARC, VERTEX };

  Kind kind;
  std::size_t index;
  Range range{};
  Curve_jet jet{};              // of an arc
  Curvature_bounds bounds{};    // over a part of a front and the range
  Interval at_middle = any_number();   // the curvature for the middles of both
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_DISK_CANDIDATE_H
