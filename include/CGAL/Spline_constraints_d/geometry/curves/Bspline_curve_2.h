// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_BSPLINE_CURVE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_BSPLINE_CURVE_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A B-spline curve in the plane; see `Bspline_curve`.
*/
template <SplineKernel Kernel>
using Bspline_curve_2 = Bspline_curve<Kernel, 2>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_BSPLINE_CURVE_2_H
