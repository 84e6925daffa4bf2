// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_PASSAGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_PASSAGES_H

#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_cone.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_search.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// In the plane of the region; nothing where the contact may be in a corner, but is not known to be.
inline std::optional<Contact_cone> cone_of(const Contact_search& search, const Contact_candidate& contact,
                                           std::size_t region)
{
  const Boundary_element& element = search.element(region, contact.elements[region]);
  if (contact.is_at_vertex[region])
    return element.cone_in_vertex;
  const Parameter_range& range = contact.parameters[region];
  if ((range.first <= 0 && element.has_corner) ||
      (range.second >= 1 && search.element(region, element.next).has_corner))
    return std::nullopt;
  return cone_on_piece(*element.piece, range);
}

inline Linear_bounds linear_bounds(const Rational_motion_2& motion, const Parameter_range& time)
{
  Linear_bounds result;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 2; ++i)
      result[k][i] = Rational_interval(part_of(motion.columns()[k][i], 0, time).bounds());
  return result;
}

inline bool is_passage(const Contact_search& search, const Rational_motion_2& motion, const Contact_candidate& contact)
{
  const auto own = cone_of(search, contact, 0), fixed = cone_of(search, contact, 1);
  return own && fixed &&
      pass_each_other(moved(*own, linear_bounds(motion, contact.time), motion.keeps_orientation()), *fixed);
}

// Without the contacts at which the regions overlap: the state does not change there, since they do so a little before
// and after, too.
inline std::vector<Contact_candidate> without_passages(const Contact_search& search, const Rational_motion_2& motion,
                                                       std::vector<Contact_candidate> contacts)
{
  std::erase_if(contacts, [&](const Contact_candidate& c) {
    return c.is_proved() && c.is_alone && is_passage(search, motion, c);
  });
  return contacts;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_PASSAGES_H
