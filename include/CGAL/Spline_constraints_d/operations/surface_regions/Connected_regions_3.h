// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_CONNECTED_REGIONS_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_CONNECTED_REGIONS_3_H

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

Regions of several surfaces with common edges, see `connected_regions()`.
*/
struct Connected_regions_3
{
  //! a region of one of the surfaces.
  struct Part
  {
    std::size_t surface; ///< the index of the surface
    std::size_t region;  ///< the index of its region
  };

  //! regions with the same label that are connected.
  struct Region
  {
    std::optional<int> label; ///< their label
    std::vector<Part> parts;  ///< what it consists of
  };

  std::vector<Region> regions; ///< the regions
  bool is_proved;              ///< see `is_complete()`

  //! whether the surfaces are complete, and it is known which of their regions are neighbours across common edges.
  bool is_complete() const { return is_proved; }

  //! the number of regions with this label.
  std::size_t number_of_regions(int label) const
  {
    return static_cast<std::size_t>(
        std::ranges::count_if(regions, [&](const Region& region) { return region.label == label; }));
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_CONNECTED_REGIONS_3_H
