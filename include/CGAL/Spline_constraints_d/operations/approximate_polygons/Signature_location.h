// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_SIGNATURE_LOCATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_SIGNATURE_LOCATION_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDApproximatePolygons

Where all points of one signature are, in all models of an approximate polygon.
*/
enum class Signature_location
{
  INSIDE,  ///< inside, in every model in which there are any
  OUTSIDE, ///< outside, in every model in which there are any
  NO_MODEL ///< no model has a point of this signature
};

//! \ingroup PkgSplineConstraintsDApproximatePolygons
//! writes `inside`, `outside` or `no model`.
inline std::ostream& operator<<(std::ostream& out, Signature_location location)
{
  static const char* const names[] = {"inside", "outside", "no model"};
  return out << names[static_cast<int>(location)];
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_SIGNATURE_LOCATION_H
