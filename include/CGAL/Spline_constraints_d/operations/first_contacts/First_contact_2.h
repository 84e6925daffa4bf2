// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_2_H

#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_d.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDFirstContacts
//! when two regions meet first.
using First_contact_2 = First_contact_d<Contact_2>;

//! \ingroup PkgSplineConstraintsDFirstContacts
//! a time at which what two regions have in common begins or ceases.
using Contact_event_2 = Contact_event_d<Contact_2>;

//! \ingroup PkgSplineConstraintsDFirstContacts
//! when two regions meet, and when they do not.
using Contact_events_2 = Contact_events_d<Contact_2>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_2_H
