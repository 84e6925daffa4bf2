// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_PART_LABEL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_PART_LABEL_H

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

What the labels of regions of bisectors mean: those of `bisector_parts()`, and of trimmed bisectors.
*/
enum Bisector_part_label : int
{
  OUT_OF_REACH = 0,         ///< outside of the sphere that was given
  WITH_POSITIVE_WEIGHT = 1, ///< on one side of the poles
  WITH_NEGATIVE_WEIGHT = 2, ///< on the other side
  NEAREST = 3,              ///< the foot is the nearest point of the surface
  NOT_NEAREST = 4           ///< another point of the surface is nearer
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_PART_LABEL_H
