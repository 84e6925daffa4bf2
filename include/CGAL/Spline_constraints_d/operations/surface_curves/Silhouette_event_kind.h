// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTE_EVENT_KIND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTE_EVENT_KIND_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves
What becomes of the silhouettes of a surface while the eye moves.
*/
enum class Silhouette_event_kind
{
  BIRTH,        ///< a curve appears: a closed one, on an edge an open one
  DEATH,        ///< a curve shrinks to a point and is gone
  RECONNECTION, ///< two branches meet and part in another way; on an edge one branch is cut in two, or two become one
  PASSAGE,      ///< the end of a curve passes a corner, from one edge to the next one
  DEGENERATE    ///< something of a higher order, or several of the others, perhaps beside a break: not told
};

//! \ingroup PkgSplineConstraintsDSurfaceCurves
//! writes the name.
inline std::ostream& operator<<(std::ostream& out, Silhouette_event_kind kind)
{
  static const char* const names[] = {"birth", "death", "reconnection", "passage", "degenerate"};
  return out << names[static_cast<int>(kind)];
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTE_EVENT_KIND_H
