// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_REGION_CONTACTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_REGION_CONTACTS_H

#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
Candidates that may be the same contact. One in a vertex solves the equations of the pieces that end there, too, and is
in the enclosure of one of their solutions: where this one may be in the vertex, they are one contact.
*/
inline bool may_be_the_same(const Contact_search& search, const Contact_candidate& a, const Contact_candidate& b)
{
  if (!do_meet(a.time, b.time))
    return false;
  const auto is_in_vertex = [&](const Contact_candidate& c, std::size_t k, std::size_t vertex) {
    return (c.elements[k] == vertex && c.parameters[k].first <= 0) ||
        (!c.is_at_vertex[k] && search.element(k, c.elements[k]).next == vertex && c.parameters[k].second >= 1);
  };
  for (const std::size_t k : {0, 1}) {
    const bool are_equal = a.is_at_vertex[k] ? is_in_vertex(b, k, a.elements[k])
        : b.is_at_vertex[k]                  ? is_in_vertex(a, k, b.elements[k])
                            : a.elements[k] == b.elements[k] && do_meet(a.parameters[k], b.parameters[k]);
    if (!are_equal)
      return false;
  }
  return true;
}

inline int rank(const Contact_candidate& c) { return c.is_at_vertex[0] + c.is_at_vertex[1]; }

inline bool is_tiny(const Contact_search&, const Contact_candidate& c)
{
  return c.solution.reason() == Undecided_reason::TOLERANCE;
}

inline Undecided_part::Range curve_parameters(const Boundary_element& element, const Parameter_range& range)
{
  const auto& [begin, end] = element.piece->parameters;
  const Exact_rational length(end - begin), a(begin + range.first * length), b(begin + range.second * length);
  return to_double_range(Parameter_range((std::min)(a, b), (std::max)(a, b)));
}

// A box around a part of a piece.
inline std::array<Parameter_range, 2> box_of_part(const Boundary_piece& piece, const Parameter_range& range)
{
  std::array<Parameter_range, 2> result;
  if (range.first == range.second) {
    const Exact_pair point = piece.at(range.first);
    return {Parameter_range(point[0], point[0]), Parameter_range(point[1], point[1])};
  }
  const auto part = [&](std::size_t k) { return piece.coordinates[k].restricted(0, range.first, range.second); };
  const Rational_interval weight(part(2).bounds());
  if (!(weight.lower > 0)) { // of a continuum
    const auto box = piece.box();
    return {Parameter_range(box[0].first, box[0].second), Parameter_range(box[1].first, box[1].second)};
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const Rational_interval values = Rational_interval(part(k).bounds()) / weight;
    result[k] = {values.lower, values.upper};
  }
  return result;
}

inline Contact_2 contact_of(const Contact_search& search, const Contact_candidate& candidate)
{
  std::array<Contact_2::Place, 2> places;
  for (const std::size_t k : {0, 1}) {
    const Boundary_element& element = search.element(k, candidate.elements[k]);
    places[k] = {element.piece->curve, curve_parameters(element, candidate.parameters[k]),
                 candidate.is_at_vertex[k] && element.has_corner};
  }
  const Contact_kind kind = places[0].is_vertex
      ? (places[1].is_vertex ? Contact_kind::VERTICES : Contact_kind::MOVING_VERTEX)
      : (places[1].is_vertex ? Contact_kind::FIXED_VERTEX : Contact_kind::SMOOTH);
  return {kind, candidate.time, box_of_part(*search.element(1, candidate.elements[1]).piece, candidate.parameters[1]),
          places, candidate.solution};
}

inline Undecided_part undecided_contact(const Contact_search& search, const Contact_candidate& candidate)
{
  Undecided_part result = undecided_time(candidate.time, in_words(candidate.solution.reason()));
  for (const std::size_t k : {0, 1}) {
    const Boundary_element& element = search.element(k, candidate.elements[k]);
    result.parameters.push_back({element.piece->curve + (k == 0 ? 0 : search.number_of_moving_curves()),
                                 {curve_parameters(element, candidate.parameters[k])}});
  }
  return result;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_REGION_CONTACTS_H
