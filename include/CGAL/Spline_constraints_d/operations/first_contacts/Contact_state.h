// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_STATE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_STATE_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFirstContacts
How two regions, or solids, lie to each other at a time, with their boundaries.
*/
enum class Contact_state
{
  APART,       ///< they have no point in common
  TOUCHING,    ///< their boundaries have common points, their interiors have none
  OVERLAPPING, ///< their interiors have a common point
  UNDECIDED    ///< none of these is proved
};

//! \ingroup PkgSplineConstraintsDFirstContacts
//! writes `apart`, `touching`, `overlapping` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Contact_state state)
{
  static const char* const names[] = {"apart", "touching", "overlapping", "undecided"};
  return out << names[static_cast<int>(state)];
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_STATE_H
