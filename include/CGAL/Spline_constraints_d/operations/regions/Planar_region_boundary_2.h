// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_BOUNDARY_2_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRegions

A curve of a boundary of a region, or a part of one.
*/
struct Planar_region_arc_2
{
  std::size_t curve;                          ///< its index
  bool is_reversed;                           ///< whether the boundary runs along it backwards
  /// of the curve, where the part begins and ends, in increasing order: its domain, if it is not cut
  std::array<Exact_rational, 2> parameters;
};

/*!
\ingroup PkgSplineConstraintsDRegions

A closed boundary of a region, with the region on its left.
*/
struct Planar_region_boundary_2
{
  std::vector<Planar_region_arc_2> arcs;   ///< in order; each begins in the point where the one before ends
  bool is_hole;                            ///< whether it is that of a hole, and clockwise
  std::size_t outer;                       ///< the index of the outer boundary of the same part of the region
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_BOUNDARY_2_H
