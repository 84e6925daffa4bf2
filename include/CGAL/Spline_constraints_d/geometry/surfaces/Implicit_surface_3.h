// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_IMPLICIT_SURFACE_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_IMPLICIT_SURFACE_3_H

#include <CGAL/Spline_constraints_d/geometry/Implicit_hypersurface.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

An implicit algebraic surface in space; see `Implicit_hypersurface`.
*/
using Implicit_surface_3 = Implicit_hypersurface<3>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_IMPLICIT_SURFACE_3_H
