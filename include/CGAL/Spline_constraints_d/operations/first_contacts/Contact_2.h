// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_2_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_state.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFirstContacts
What meets in a contact. A vertex is a corner of a boundary; where smooth pieces join smoothly there is none.
*/
enum class Contact_kind
{
  SMOOTH,        ///< two points where boundaries are smooth: the tangents are parallel
  MOVING_VERTEX, ///< a vertex of the moving region, and a smooth point of the fixed one
  FIXED_VERTEX,  ///< a smooth point of the moving region, and a vertex of the fixed one
  VERTICES       ///< a vertex of both
};

//! \ingroup PkgSplineConstraintsDFirstContacts
//! writes `smooth`, `moving vertex`, `fixed vertex` or `vertices`.
inline std::ostream& operator<<(std::ostream& out, Contact_kind kind)
{
  static const char* const names[] = {"smooth", "moving vertex", "fixed vertex", "vertices"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDFirstContacts

Where and when boundaries of two regions meet.
*/
struct Contact_2
{
  //! a closed range of numbers; both are the same where it is known exactly.
  using Range = std::pair<Exact_rational, Exact_rational>;

  //! A point of a boundary.
  struct Place
  {
    std::size_t curve;               ///< the index of the curve
    Undecided_part::Range parameter; ///< encloses its parameter
    bool is_vertex;                  ///< whether it is a corner
  };

  Contact_kind kind;           ///< what meets
  Range time;                  ///< encloses the time
  std::array<Range, 2> point;  ///< encloses the point, in the plane of the fixed region
  std::array<Place, 2> places; ///< on the moving region, and on the fixed one

  //! what the solver has proved of the equations of this contact: one solution, if it is `CERTIFIED`; a `CLUSTER` where
  //! boundaries graze each other or meet with the same curvature, or contacts are not told apart; or a `CONTINUUM`. The
  //! unknowns are the parameters of those places that are no ends of pieces, from 0 to 1 on a piece, and the time.
  Solution_d<double> certificate;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_2_H
