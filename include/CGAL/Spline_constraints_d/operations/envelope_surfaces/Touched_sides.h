// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TOUCHED_SIDES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TOUCHED_SIDES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

The side on which spheres touch a surface; the positive one is that of \f$S_u \times S_v\f$.
*/
enum class Touched_side
{
  ANY,
  POSITIVE,
  NEGATIVE
};

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

The sides on which spheres touch two surfaces. Between two solids whose normals point outside both are positive.
*/
struct Touched_sides
{
  Touched_side first = Touched_side::ANY;  ///< of the first surface
  Touched_side second = Touched_side::ANY; ///< of the second surface
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TOUCHED_SIDES_H
