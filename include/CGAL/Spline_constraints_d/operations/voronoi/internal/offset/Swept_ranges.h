// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_SWEPT_RANGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_SWEPT_RANGES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_ranges.h>

#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The ranges of an element in which disks are free, as they are found by a sweep from its begin to its end: what is
appended follows what has been.
*/
class Swept_ranges
{
  Free_ranges m_ranges;
  Free_end m_boundary{Free_end::Kind::FRONT_END, {0, 0}};   // the last one
  bool m_is_free = false;                                    // behind it

public:
  const Free_ranges& ranges() const { return m_ranges; }
  Free_ranges take() { return std::move(m_ranges); }

  void append_free(const Range& range)
  {
    if (!m_is_free)
      m_ranges.free.push_back({m_boundary, {}});
    m_is_free = true;
    m_ranges.free.back()[1] = {Free_end::Kind::FRONT_END, {range.end, range.end}};
  }

  // A range of disks that touch something all along, which is cut out in the end.
  void append_tie(const Range& range)
  {
    append_boundary({Free_end::Kind::TIE, {range.begin, range.begin}});
    m_boundary.location = {range.end, range.end};
  }

  void append_covered() { m_boundary = {Free_end::Kind::UNDECIDED}; }   // the next boundary tells what follows

  void append_boundary(const Free_end& boundary)
  {
    if (m_is_free)
      m_ranges.free.back()[1] = boundary;
    m_is_free = false;
    m_boundary = boundary;
  }

  // A range of which nothing is known, or where disks are covered, if not by bounds.
  void append_undecided(const Range& range, bool is_covered = false)
  {
    append_boundary({Free_end::Kind::UNDECIDED, range});
    if (!is_covered)
      m_ranges.undecided.push_back(range);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_SWEPT_RANGES_H
