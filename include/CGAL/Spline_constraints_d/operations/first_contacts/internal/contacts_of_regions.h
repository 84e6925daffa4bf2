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
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/State_of_regions.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/distinct_contacts.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/passages.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

inline Summary summary_of(Budgeted_solver& solve, bool is_complete)
{
  Summary result = solve.total();
  result.seconds = solve.budget().seconds();
  result.is_complete = is_complete;
  result.why_not = is_complete ? Undecided_reason::NONE
      : solve.has_ended()      ? solve.reason()
                               : Undecided_reason::TOLERANCE;
  return result;
}

// What of the contacts in a range of times is not proved, or was not looked for.
inline std::vector<Undecided_part> undecided_contacts(const Contact_search& search,
                                                      const std::vector<Contact_candidate>& found,
                                                      const Moving_regions& regions, const First_contact_2::Range& time,
                                                      Budgeted_solver& solve)
{
  std::vector<Undecided_part> result;
  for (const Contact_candidate& c : found)
    if (!c.is_proved())
      result.push_back(undecided_contact(search, c, regions.number_of_moving_curves));
  if (search.stop() && *search.stop() <= time.second)
    result.push_back(undecided_time({*search.stop(), time.second}, in_words(solve.reason())));
  return result;
}

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
    undecided = undecided_contacts(search, found, regions, {begin, begin}, solve);
    contacts = proved_contacts(search, found);
  }
  const bool is_complete = undecided.empty();
  return {state, First_contact_2::Range(begin, begin), true, std::move(contacts), std::move(undecided),
          summary_of(solve, is_complete)};
}

// The earliest candidates, of regions that are apart at first.
inline First_contact_2 earliest_contact(const Moving_regions& regions, Budgeted_solver& solve)
{
  Contact_search search(regions, solve);
  std::vector<Contact_candidate> found;
  search([&](const Parameter_range&, std::vector<Contact_candidate> candidates) {
    found.insert(found.end(), candidates.begin(), candidates.end());
    return std::none_of(candidates.begin(), candidates.end(), [](const auto& c) { return c.is_proved(); });
  });
  std::optional<Exact_rational> first = search.stop(), last;
  for (const Contact_candidate& c : found) {
    first = first ? (std::min)(*first, c.time.first) : c.time.first;
    if (c.is_proved())
      last = last ? (std::min)(*last, c.time.second) : c.time.second;
  }
  if (!first)
    return {Contact_state::APART, std::nullopt, false, {}, {}, summary_of(solve, true)};
  const First_contact_2::Range time(*first, last ? *last : regions.motion.domain().second);
  std::erase_if(found, [&](const Contact_candidate& c) { return c.time.first > time.second; });
  found = distinct_contacts(search, std::move(found));
  std::vector<Undecided_part> undecided = undecided_contacts(search, found, regions, time, solve);
  const bool is_complete = undecided.empty();
  return {Contact_state::APART,          time, last.has_value(), proved_contacts(search, found), std::move(undecided),
          summary_of(solve, is_complete)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE First_contact_2 first_contact_of(const Moving_regions& regions,
                                                                const Solver_options& options)
{
  Budgeted_solver solve(options);
  const auto [begin, end] = regions.motion.domain();
  const auto moving = moved(regions.moving, regions.motion, begin);
  switch (const Contact_state state = State_of_regions(moving, regions.fixed, solve)()) {
  case Contact_state::APART:
    return earliest_contact(regions, solve);
  case Contact_state::UNDECIDED:
    return {state,
            First_contact_2::Range(begin, end),
            false,
            {},
            {undecided_time({begin, begin}, solve.has_ended() ? in_words(solve.reason()) : state_not_decided)},
            summary_of(solve, false)};
  default:
    return contact_at_begin(state, regions, solve);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Contact_events_2 contact_events_of(const Moving_regions& regions,
                                                                  const Solver_options& options)
{
  Budgeted_solver solve(options);
  Contact_search search(regions, solve);
  std::vector<Contact_candidate> found;
  search([&](const Parameter_range&, std::vector<Contact_candidate> candidates) {
    found.insert(found.end(), candidates.begin(), candidates.end());
    return true;
  });
  Contact_timeline timeline(regions, search, solve);
  timeline.add(without_passages(search, regions.motion, distinct_contacts(search, std::move(found))));
  std::vector<Undecided_part> undecided = timeline.undecided();
  const bool is_complete = undecided.empty();
  return {timeline.state_at_begin(), timeline.state_at_end(), timeline.events(), std::move(undecided),
          summary_of(solve, is_complete)};
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACTS_OF_REGIONS_H
