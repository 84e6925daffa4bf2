// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_STREAMS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_STREAMS_2_H

#include <CGAL/Spline_constraints_d/geometry/conversions/spline_streams.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>

#include <cstddef>
#include <istream>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRegions

writes a region: the number of its curves, and the curves in their order, as `operator<<` of curves does, one in a line;
so nothing is rounded.
*/
template <SplineKernel Kernel>
std::ostream& operator<<(std::ostream& out, const Planar_region_2<Kernel>& region)
{
  out << region.curves().size();
  for (const auto& curve : region.curves())
    out << '\n' << curve;
  return out;
}

/*!
\ingroup PkgSplineConstraintsDRegions

reads a region that was written in this way: the same curves, with the same boundaries. It is proved again that these
are closed and do not cross. If they do, or there is no valid region, the stream fails and the region remains as it was.
*/
template <SplineKernel Kernel>
std::istream& operator>>(std::istream& in, Planar_region_2<Kernel>& region)
{
  using Curve = Bspline_curve_2<Kernel>;
  std::size_t count = 0;
  in >> count;
  std::vector<Curve> curves;
  for (Curve curve = region.curves().front(); curves.size() < count && in >> curve;)
    curves.push_back(curve);
  if (!in)
    return in;
  try {
    region = Planar_region_2<Kernel>(curves);
  } catch (const Invalid_input&) {
    in.setstate(std::ios::failbit);
  }
  return in;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGION_STREAMS_2_H
