// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_FINDERS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// Defined in contacts_of_solids.h; the compiled library has them.
First_contact_3 first_contact_of(const std::vector<Common::Exact_map<3>>& moving, const Rational_motion_3& motion,
                                 const std::vector<Common::Exact_map<3>>& fixed, const Solver_options& options);
Contact_events_3 contact_events_of(const std::vector<Common::Exact_map<3>>& moving, const Rational_motion_3& motion,
                                   const std::vector<Common::Exact_map<3>>& fixed, const Solver_options& options);

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_SOLIDS_SOLID_CONTACT_FINDERS_H
