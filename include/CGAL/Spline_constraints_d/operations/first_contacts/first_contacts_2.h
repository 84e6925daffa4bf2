// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACTS_2_H

#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/undecided_region.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contacts_of_regions.h>
#endif

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace First_contacts {

// What is undecided of regions of which one at least is not complete.
template <SplineKernel Kernel>
std::vector<Undecided_part> undecided_regions(const Planar_region_2<Kernel>& moving,
                                              const Planar_region_2<Kernel>& fixed)
{
  std::vector<Undecided_part> result;
  if (!moving.is_complete())
    result.push_back(undecided_region(moving, 0));
  if (!fixed.is_complete())
    result.push_back(undecided_region(fixed, moving.curves().size()));
  return result;
}

template <SplineKernel Kernel>
Summary summary_of_undecided(const Planar_region_2<Kernel>& moving, const Planar_region_2<Kernel>& fixed)
{
  return undecided_summary((moving.is_complete() ? fixed : moving).summary().why_not);
}

} // namespace First_contacts
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFirstContacts

when a moving region first meets one that does not move, and where; or a proof that they never meet.

How they lie to each other at the first time is decided exactly. If they are apart, they first meet where their
boundaries have a point in common: smooth ones with opposite tangents, or a vertex of one on the boundary of the other
one. Those are three equations for two parameters and the time, or two for one parameter and the time. Every solution
is a contact, so that the earliest one is the answer; before its enclosure it is proved that there is none. Times are
looked at in order, and only as far as a contact.

Where both regions move, one is seen from the other one: the motion is then `motion_of_fixed.inverse() *
motion_of_moving`, and the contacts are in the plane of the region that is taken as fixed.

\param moving the region that moves.
\param motion its motion, all of it; see `Rational_motion_2::restricted()`.
\param fixed the other region. Where a region is not complete, nothing is decided.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: \f$O(nm)\f$ tests of boxes for \f$n\f$ and \f$m\f$ pieces of boundaries and each of at most 256 parts of the
time, and four systems for those that meet. Sources: the equations of envelopes, \cgalCite{ek-gcs-01}.
*/
template <SplineKernel Kernel>
First_contact_2 first_contact(const Planar_region_2<Kernel>& moving, const Rational_motion_2& motion,
                              const Planar_region_2<Kernel>& fixed, const Solver_options& options = {})
{
  options.check();
  if (!moving.is_complete() || !fixed.is_complete())
    return {Contact_state::UNDECIDED,
            motion.domain(),
            false,
            {},
            internal::First_contacts::undecided_regions(moving, fixed),
            internal::First_contacts::summary_of_undecided(moving, fixed)};
  return internal::First_contacts::first_contact_of({moving.loops(), motion, fixed.loops(), moving.curves().size()},
                                                    options);
}

/*!
\ingroup PkgSplineConstraintsDFirstContacts

all times at which a moving region begins or ceases to meet one that does not move, in order, with how they lie to each
other between them. Solutions of all equations are found as by `first_contact()`; between two of these times nothing
changes, and one exact test decides. That regions which overlap before and after only touch for a single time is no
event.

\param moving,motion,fixed,options as of `first_contact()`.
\throws Invalid_input when an option makes no sense.

Complexity: as of `first_contact()`, and the common points of the boundaries at one time between any two solutions.
*/
template <SplineKernel Kernel>
Contact_events_2 contact_events(const Planar_region_2<Kernel>& moving, const Rational_motion_2& motion,
                                const Planar_region_2<Kernel>& fixed, const Solver_options& options = {})
{
  options.check();
  if (!moving.is_complete() || !fixed.is_complete())
    return {Contact_state::UNDECIDED,
            Contact_state::UNDECIDED,
            {},
            internal::First_contacts::undecided_regions(moving, fixed),
            internal::First_contacts::summary_of_undecided(moving, fixed)};
  return internal::First_contacts::contact_events_of({moving.loops(), motion, fixed.loops(), moving.curves().size()},
                                                     options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACTS_2_H
