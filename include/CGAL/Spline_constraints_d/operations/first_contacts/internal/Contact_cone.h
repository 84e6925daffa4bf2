// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_CONE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_CONE_H

#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_search.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

inline Rational_interval cross_product(const Vector_bounds<2>& a, const Vector_bounds<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// The directions that point into a region from a point of its boundary: from that in which the boundary goes on,
// counterclockwise to that from which it comes.
struct Contact_cone
{
  Vector_bounds<2> on, back;
  bool is_half_plane;

  // Whether a direction points inside for certain.
  bool contains(const Vector_bounds<2>& direction) const
  {
    const bool is_left_of_on = cross_product(on, direction).lower > 0,
               is_right_of_back = cross_product(direction, back).lower > 0;
    if (is_half_plane)
      return is_left_of_on;
    const Rational_interval turn = cross_product(on, back);
    return turn.lower > 0 ? is_left_of_on && is_right_of_back : turn.upper < 0 && (is_left_of_on || is_right_of_back);
  }
};

inline Vector_bounds<2> bounds_of(const Exact_pair& vector)
{
  return {Rational_interval(vector[0]), Rational_interval(vector[1])};
}

inline Vector_bounds<2> opposite(const Vector_bounds<2>& v)
{
  return {Rational_interval(Exact_rational(-v[0].upper), Exact_rational(-v[0].lower)),
          Rational_interval(Exact_rational(-v[1].upper), Exact_rational(-v[1].lower))};
}

// Of the derivative of a piece in a range of its parameter, up to a positive factor.
inline Vector_bounds<2> bounds_of_tangent(const Boundary_piece& piece, const Parameter_range& range)
{
  const auto& [x, y, w] = piece.coordinates;
  const auto bounds = [&, &w = w](const Exact_tensor& f) {
    const Exact_tensor numerator = f.derivative(0) * w - f * w.derivative(0);
    return range.first < range.second
        ? Rational_interval(numerator.restricted(0, range.first, range.second).bounds())
        : Rational_interval(Exact_rational(numerator(std::array<Exact_rational, 1>{range.first})));
  };
  return {bounds(x), bounds(y)};
}

// In the plane of the region; nothing where the contact may be in a corner, but is not known to be.
inline std::optional<Contact_cone> cone_of(const Contact_search& search, const Contact_candidate& contact,
                                           std::size_t region)
{
  const Boundary_element& element = search.element(region, contact.elements[region]);
  if (contact.is_at_vertex[region]) {
    const Boundary_element& before = search.element(region, element.previous);
    return Contact_cone{bounds_of(tangent_at_end(*element.piece, false)),
                        opposite(bounds_of(tangent_at_end(*before.piece, true))), !element.has_corner};
  }
  const Parameter_range& range = contact.parameters[region];
  if ((range.first <= 0 && element.has_corner) ||
      (range.second >= 1 && search.element(region, element.next).has_corner))
    return std::nullopt;
  const Vector_bounds<2> tangent = bounds_of_tangent(*element.piece, range);
  return Contact_cone{tangent, opposite(tangent), true};
}

// The image of a cone in a part of the time.
inline Contact_cone moved(const Contact_cone& cone, const Rational_motion_2& motion, const Parameter_range& time)
{
  std::array<std::array<Rational_interval, 2>, 2> columns;
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t i = 0; i < 2; ++i)
      columns[k][i] = Rational_interval(part_of(motion.columns()[k][i], 0, time).bounds());
  const auto image = [&](const Vector_bounds<2>& v) {
    return Vector_bounds<2>{columns[0][0] * v[0] + columns[1][0] * v[1], columns[0][1] * v[0] + columns[1][1] * v[1]};
  };
  return motion.keeps_orientation() ? Contact_cone{image(cone.on), image(cone.back), cone.is_half_plane}
                                    : Contact_cone{image(cone.back), image(cone.on), cone.is_half_plane};
}

// Whether a boundary goes on into the other region, so that the regions overlap at that time.
inline bool is_passage(const Contact_search& search, const Rational_motion_2& motion, const Contact_candidate& contact)
{
  const auto own = cone_of(search, contact, 0), fixed = cone_of(search, contact, 1);
  if (!own || !fixed)
    return false;
  const Contact_cone moving = moved(*own, motion, contact.time);
  return fixed->contains(moving.on) || fixed->contains(moving.back) || moving.contains(fixed->on) ||
      moving.contains(fixed->back);
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

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_CONE_H
