// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_HIT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_HIT_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/enum.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

Where a segment or a ray meets a smooth surface: a parameter \f$t\f$, with the point \f$p + t\,(q-p)\f$ for its first
point \f$p\f$ and its end, or second point, \f$q\f$.
*/
struct Smooth_surface_hit
{
  Exact_rational lower; ///< no more than the parameter
  Exact_rational upper; ///< no less; the range has one hit; both are equal where the parameter is known as a number

  //! the sign of the function just before, zero where nothing of the segment is before: outside it is positive.
  CGAL::Sign before;
  CGAL::Sign after; ///< the same just behind

  std::size_t patch; ///< a tetrahedron with the point

  bool is_overlap = false; ///< whether all of the range lies on the surface, as on a ruled one

  //! whether it is a crossing; if not, a contact, an end, or an overlap.
  bool is_crossing() const { return before * after < 0; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_HIT_H
