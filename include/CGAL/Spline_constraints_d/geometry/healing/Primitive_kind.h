// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_PRIMITIVE_KIND_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_PRIMITIVE_KIND_H

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDHealing

What `with_exact_primitives()` has recognised a curve or surface as.
*/
enum class Primitive_kind
{
  GENERAL,  ///< none of the others
  LINE,     ///< a part of a line
  CIRCLE,   ///< a circle or an arc of one
  PLANE,    ///< a part of a plane
  SPHERE,   ///< a sphere or a part of one
  CYLINDER, ///< a part of a circular cylinder
  CONE,     ///< a part of a circular cone
  TORUS,    ///< a torus or a part of one
  UNDECIDED ///< it was not looked at, since the run ended before
};

//! \ingroup PkgSplineConstraintsDHealing
//! writes the name in lower case.
inline std::ostream& operator<<(std::ostream& out, Primitive_kind kind)
{
  switch (kind) {
  case Primitive_kind::LINE:
    return out << "line";
  case Primitive_kind::CIRCLE:
    return out << "circle";
  case Primitive_kind::PLANE:
    return out << "plane";
  case Primitive_kind::SPHERE:
    return out << "sphere";
  case Primitive_kind::CYLINDER:
    return out << "cylinder";
  case Primitive_kind::CONE:
    return out << "cone";
  case Primitive_kind::TORUS:
    return out << "torus";
  case Primitive_kind::UNDECIDED:
    return out << "undecided";
  default:
    return out << "general";
  }
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_PRIMITIVE_KIND_H
