// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_FINDERS_H

#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// The boundaries of a region that moves and of one that does not, without a kernel.
struct Moving_regions
{
  const std::vector<Boundary_loop_2>& moving;
  const Rational_motion_2& motion;
  const std::vector<Boundary_loop_2>& fixed;
  std::size_t number_of_moving_curves; // those of the fixed region are counted behind them
};

// Defined in contacts_of_regions.h; the compiled library has them.
First_contact_2 first_contact_of(const Moving_regions& regions, const Solver_options& options);
Contact_events_2 contact_events_of(const Moving_regions& regions, const Solver_options& options);

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_FINDERS_H
