// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_IMPLICIT_CURVE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_IMPLICIT_CURVE_2_H

#include <CGAL/Spline_constraints_d/geometry/Implicit_hypersurface.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

An implicit algebraic curve in the plane; see `Implicit_hypersurface`.
*/
using Implicit_curve_2 = Implicit_hypersurface<2>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_IMPLICIT_CURVE_2_H
