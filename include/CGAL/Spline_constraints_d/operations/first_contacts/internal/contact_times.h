// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMES_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_d.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
What is common to contacts in the plane and in space. A candidate is a solution of the equations of two elements: it has
a `time`, the `solution`, `is_alone` (or else there may be others in the enclosure), and `is_proved()`. A search gives
candidates. Beside it stand `may_be_the_same(search, a, b)`; `rank(a)`, which is larger for elements of less dimension;
`is_tiny(search, a)`, whether its enclosure is of the size of the tolerance; `contact_of(search, a)`; and
`undecided_contact(search, a)`.
*/

inline bool do_meet(const Parameter_range& a, const Parameter_range& b)
{
  return a.first <= b.second && b.first <= a.second;
}

// A number between two others; one with few digits, if there is one.
inline Exact_rational short_number_between(const Exact_rational& lower, const Exact_rational& upper)
{
  const Exact_rational middle((lower + upper) / 2);
  for (double scale = 4; scale < 0x1p52; scale *= 16)
    if (const Exact_rational result(std::round(to_nearest_double(middle) * scale) / scale);
        lower < result && result < upper)
      return result;
  return middle;
}

// A time before a range of times and after another one, as far from the range as that is long if there is room.
inline Exact_rational time_close_before(const Parameter_range& range, const Exact_rational& before)
{
  if (!(before < range.first))
    return range.first;
  return short_number_between((std::max)(before, Exact_rational(2 * range.first - range.second)), range.first);
}

inline Undecided_part undecided_time(const Parameter_range& time, const std::string& reason)
{
  return {{to_double_range(time)}, {}, reason};
}

// Whether the solution was only not told apart from the end of a piece, so that it is the contact in that end.
inline bool is_next_to_end(const Solution_d<double>& solution)
{
  return solution.reason() == Undecided_reason::DOMAIN_BOUNDARY || solution.reason() == Undecided_reason::INEQUALITY;
}

/*
Each contact once: in elements of the least dimension. What is undecided in a box of the size of the tolerance, in which
a contact is proved by other equations, is that contact; others in the box are not told apart from it.
*/
template <class Search, class Candidate>
std::vector<Candidate> distinct_contacts(const Search& search, std::vector<Candidate> candidates)
{
  std::stable_sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
    return std::pair(b.is_proved(), rank(b)) < std::pair(a.is_proved(), rank(a));
  });
  std::vector<Candidate> result;
  for (Candidate& candidate : candidates) {
    const bool is_within_tolerance = is_tiny(search, candidate);
    const auto known = std::find_if(result.begin(), result.end(), [&](const Candidate& other) {
      return (candidate.is_proved() || is_within_tolerance || is_next_to_end(candidate.solution)) &&
          other.is_proved() && may_be_the_same(search, other, candidate);
    });
    if (known == result.end())
      result.push_back(std::move(candidate));
    else if (is_within_tolerance) {
      known->is_alone = false;
      known->time = {(std::min)(known->time.first, candidate.time.first),
                     (std::max)(known->time.second, candidate.time.second)};
    }
  }
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return result;
}

template <class Contact, class Search, class Candidate>
std::vector<Contact> proved_contacts(const Search& search, const std::vector<Candidate>& candidates)
{
  std::vector<Contact> result;
  for (const Candidate& candidate : candidates)
    if (candidate.is_proved())
      result.push_back(contact_of(search, candidate));
  return result;
}

// What of the contacts in a range of times is not proved, or was not looked for.
template <class Search, class Candidate>
std::vector<Undecided_part> undecided_contacts(const Search& search, const std::vector<Candidate>& found,
                                               const Parameter_range& time, Budgeted_solver& solve)
{
  std::vector<Undecided_part> result;
  for (const Candidate& c : found)
    if (!c.is_proved())
      result.push_back(undecided_contact(search, c));
  if (search.stop() && *search.stop() <= time.second)
    result.push_back(undecided_time({*search.stop(), time.second}, in_words(solve.reason())));
  return result;
}

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

// Where nothing is known but how they lie to each other at the first time, or not even that.
template <class Contact>
First_contact_d<Contact> undecided_first_contact(const Parameter_range& domain, Budgeted_solver& solve,
                                                 const std::string& reason)
{
  return {Contact_state::UNDECIDED,
          domain,
          false,
          {},
          {undecided_time({domain.first, domain.first}, solve.has_ended() ? in_words(solve.reason()) : reason)},
          summary_of(solve, false)};
}

template <class Candidate, class Search>
std::vector<Candidate> all_candidates(Search& search)
{
  std::vector<Candidate> result;
  search([&](const Parameter_range&, std::vector<Candidate> candidates) {
    result.insert(result.end(), candidates.begin(), candidates.end());
    return true;
  });
  return result;
}

// The earliest candidates, of operands that are apart at first.
template <class Contact, class Search, class Candidate>
First_contact_d<Contact> earliest_contact(Search& search, Budgeted_solver& solve)
{
  std::vector<Candidate> found;
  search([&](const Parameter_range&, std::vector<Candidate> candidates) {
    found.insert(found.end(), candidates.begin(), candidates.end());
    return std::none_of(candidates.begin(), candidates.end(), [](const auto& c) { return c.is_proved(); });
  });
  std::optional<Exact_rational> first = search.stop(), last;
  for (const Candidate& c : found) {
    first = first ? (std::min)(*first, c.time.first) : c.time.first;
    if (c.is_proved())
      last = last ? (std::min)(*last, c.time.second) : c.time.second;
  }
  if (!first)
    return {Contact_state::APART, std::nullopt, false, {}, {}, summary_of(solve, true)};
  const Parameter_range time(*first, last ? *last : search.motion().domain().second);
  std::erase_if(found, [&](const Candidate& c) { return c.time.first > time.second; });
  found = distinct_contacts(search, std::move(found));
  std::vector<Undecided_part> undecided = undecided_contacts(search, found, time, solve);
  const bool is_complete = undecided.empty();
  return {Contact_state::APART, time,
          last.has_value(),     proved_contacts<Contact>(search, found),
          std::move(undecided), summary_of(solve, is_complete)};
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMES_H
