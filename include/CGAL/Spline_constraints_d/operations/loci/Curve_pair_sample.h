// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_SAMPLE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_SAMPLE_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

A point that belongs to one point on each of two curves.
*/
template <SplineKernel Kernel>
struct Curve_pair_sample
{
  //! the point.
  typename Kernel::Point_2 point;

  //! the parameters of the two points.
  std::array<double, 2> parameters;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_SAMPLE_H
