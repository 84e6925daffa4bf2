// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACTS_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACTS_3_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/solid_contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/swept_volumes.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/solids/contacts_of_solids.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFirstContacts

when a moving solid first meets one that does not move, and where; or a proof that they never meet.

If they are apart at the first time, they first meet where their boundaries have a point in common: two faces with the
same tangent plane, an edge that touches a face, two edges, or a corner on a face. Points of a face have two parameters,
those of an edge one, and with the time there are as many equations as unknowns. Every solution is a common point, so
that the earliest one is the answer; before its enclosure it is proved that there is none. Contacts along lines and in
planes, as of a box that falls on a table, are found by their ends. Times are looked at in order, and only as far as a
contact.

\param moving a range of the surfaces that bound the solid that moves, as `swept_volume()` takes them; a sphere is a
range of one surface. Normals may point to either side.
\param motion its motion.
\param fixed the surfaces of the other solid.
\param options those of the solver; limits hold for the operation as a whole.
\return the first contact. If the solids overlap at the first time, it is this time. Not decided, and named, are solids
that touch at the first time; curved faces that graze each other; poles of the parameters of both that meet; contacts
that last; and those along curves that are no straight lines of a cylinder or a cone, and no edges of plane faces.
\throws Invalid_input when surfaces do not bound a solid, as `swept_volume()` does; it is not proved that the maps of
the motion are invertible at all times; a coordinate is not finite; or an option makes no sense.

Complexity: \f$O(nm)\f$ tests of boxes for \f$n\f$ and \f$m\f$ faces, edges and corners and each of at most 256 parts of
the time, and a system of up to five equations for each pair that meets. Sources: the equations of envelopes,
\cgalCite{ek-gcs-01}.
*/
template <internal::Swept_volumes::Range_of_surfaces Moving, internal::Swept_volumes::Range_of_surfaces Fixed>
First_contact_3 first_contact(const Moving& moving, const Rational_motion_3& motion, const Fixed& fixed,
                              const Solver_options& options = {})
{
  return internal::First_contacts::first_contact_of(internal::Swept_volumes::maps_of(moving), motion,
                                                    internal::Swept_volumes::maps_of(fixed), options);
}

/*!
\ingroup PkgSplineConstraintsDFirstContacts

all times at which a moving solid begins or ceases to meet one that does not move, in order, with how they lie to each
other between them. Solutions of all equations are found as by `first_contact()`; between two of these times nothing
changes, and one test decides, by proof: that a point of one boundary is inside of the other solid, or that the
boundaries do not meet.

\param moving,motion,fixed,options as of `first_contact()`.
\throws Invalid_input as `first_contact()` does.

Complexity: as of `first_contact()`, and the test between any two solutions.
*/
template <internal::Swept_volumes::Range_of_surfaces Moving, internal::Swept_volumes::Range_of_surfaces Fixed>
Contact_events_3 contact_events(const Moving& moving, const Rational_motion_3& motion, const Fixed& fixed,
                                const Solver_options& options = {})
{
  return internal::First_contacts::contact_events_of(internal::Swept_volumes::maps_of(moving), motion,
                                                     internal::Swept_volumes::maps_of(fixed), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACTS_3_H
