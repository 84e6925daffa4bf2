// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_OVERLAP_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_OVERLAP_3_H

#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

Whether a region of a surface lies on another one; the labels of `surface_overlap()`.
*/
enum class Overlap
{
  OWN,   //!< points of the other surface are on curves at most
  COMMON //!< all of it is on the other surface
};

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

The regions that two surfaces have in common, in the parameters of both.
*/
class Surface_overlap_3
{
  std::array<Trimmed_surface_3, 2> m_surfaces;

public:
  //! what `surface_overlap()` has found.
  explicit Surface_overlap_3(std::array<Trimmed_surface_3, 2> surfaces) : m_surfaces(std::move(surfaces)) {}

  //! the first (0) or second (1) surface, whose labels are values of `Overlap` as numbers.
  const Trimmed_surface_3& surface(std::size_t i) const { return m_surfaces[i]; }

  //! the number of regions of a surface that lie on the other one, by proof.
  std::size_t number_of_common_regions(std::size_t i) const
  {
    return m_surfaces[i].number_of_regions(static_cast<int>(Overlap::COMMON));
  }

  //! whether these are all, and all of each region is found, on both surfaces; by proof.
  bool is_complete() const
  {
    return std::ranges::all_of(m_surfaces, [](const Trimmed_surface_3& surface) { return surface.is_complete(); });
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_SURFACE_OVERLAP_3_H
