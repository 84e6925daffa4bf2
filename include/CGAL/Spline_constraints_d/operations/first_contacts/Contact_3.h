// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_3_H

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
The part of the boundary of a solid that meets in a contact. Where surfaces join with one tangent plane there is no
edge, and where edges join smoothly there is no corner.
*/
enum class Solid_part
{
  FACE,  ///< a point with a tangent plane
  EDGE,  ///< a point of an edge
  CORNER ///< a corner, such as the tip of a cone
};

//! \ingroup PkgSplineConstraintsDFirstContacts
//! writes `face`, `edge` or `corner`.
inline std::ostream& operator<<(std::ostream& out, Solid_part part)
{
  static const char* const names[] = {"face", "edge", "corner"};
  return out << names[static_cast<int>(part)];
}

/*!
\ingroup PkgSplineConstraintsDFirstContacts

Where and when boundaries of two solids meet. Two faces have a common tangent plane there, an edge that meets a face has
its tangent in that of the face.
*/
struct Contact_3
{
  //! a closed range of numbers; both are the same where it is known exactly.
  using Range = std::pair<Exact_rational, Exact_rational>;

  //! A point of a boundary.
  struct Place
  {
    std::size_t surface;                             ///< the index of the surface
    std::array<Undecided_part::Range, 2> parameters; ///< enclose its parameters; on edges, those of one of its surfaces
    Solid_part part;                                 ///< what the point lies on
  };

  Range time;                  ///< encloses the time
  std::array<Range, 3> point;  ///< encloses the point, in the space of the fixed solid
  std::array<Place, 2> places; ///< on the moving solid, and on the fixed one

  //! what the solver has proved of the equations of this contact, as of `Contact_2`. The unknowns are the parameters of
  //! the moving surface or edge, those of the fixed one, each from 0 to 1 on a polynomial piece, and the time.
  Solution_d<double> certificate;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_CONTACT_3_H
