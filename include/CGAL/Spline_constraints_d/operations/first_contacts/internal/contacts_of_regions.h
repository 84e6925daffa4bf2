// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACTS_OF_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACTS_OF_REGIONS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_timeline.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/States_of_regions.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/passages.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/region_contacts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// Of regions that meet at the first time: with the contacts then, if they touch.
inline First_contact_2 contact_at_begin(Contact_state state, const Moving_regions& regions, Budgeted_solver& solve)
{
  const Exact_rational begin = regions.motion.domain().first;
  std::vector<Contact_2> contacts;
  std::vector<Undecided_part> undecided;
  if (state == Contact_state::TOUCHING) {
    Contact_search search(regions, solve);
    std::vector<Contact_candidate> found;
    search([&](const Parameter_range&, std::vector<Contact_candidate> candidates) {
      std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(found),
                   [&](const Contact_candidate& c) { return c.time.first <= begin; });
      return false;
    });
    found = distinct_contacts(search, std::move(found));
    undecided = undecided_contacts(search, found, {begin, begin}, solve);
    contacts = proved_contacts<Contact_2>(search, found);
  }
  const bool is_complete = undecided.empty();
  return {state, First_contact_2::Range(begin, begin), true, std::move(contacts), std::move(undecided),
          summary_of(solve, is_complete)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE First_contact_2 first_contact_of(const Moving_regions& regions,
                                                                const Solver_options& options)
{
  Budgeted_solver solve(options);
  switch (const Contact_state state = States_of_regions(regions, solve).at(regions.motion.domain().first)) {
  case Contact_state::APART: {
    Contact_search search(regions, solve);
    return earliest_contact<Contact_2, Contact_search, Contact_candidate>(search, solve);
  }
  case Contact_state::UNDECIDED:
    return undecided_first_contact<Contact_2>(regions.motion.domain(), solve, States_of_regions::not_decided);
  default:
    return contact_at_begin(state, regions, solve);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Contact_events_2 contact_events_of(const Moving_regions& regions,
                                                                  const Solver_options& options)
{
  Budgeted_solver solve(options);
  Contact_search search(regions, solve);
  const auto found = distinct_contacts(search, all_candidates<Contact_candidate>(search));
  States_of_regions states(regions, solve);
  return Contact_timeline<Contact_2, Contact_search, Contact_candidate, States_of_regions>(states, search, solve)(
      without_passages(search, regions.motion, found));
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACTS_OF_REGIONS_H
