// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_3_H

#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_d.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDFirstContacts
//! when two solids meet first.
using First_contact_3 = First_contact_d<Contact_3>;

//! \ingroup PkgSplineConstraintsDFirstContacts
//! a time at which what two solids have in common begins or ceases.
using Contact_event_3 = Contact_event_d<Contact_3>;

//! \ingroup PkgSplineConstraintsDFirstContacts
//! when two solids meet, and when they do not.
using Contact_events_3 = Contact_events_d<Contact_3>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_3_H
