// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMELINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMELINE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_d.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_times.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

/*
What happens in the course of time. All times at which the state changes are those of candidates. Those whose enclosures
meet are one group; between two groups nothing changes, and one time tells the state.

`States` has `at(time, candidates)`, the state at a time, where all candidates are known, and `overlap_lasts(range,
before)`, whether they do so in all of a range of times, as they do at one before it.
*/
template <class Contact, class Search, class Candidate, class States>
class Contact_timeline
{
  using Candidates = std::vector<Candidate>;

  struct Group
  {
    Parameter_range time;
    Candidates candidates;

    bool is_proved() const
    {
      return std::ranges::all_of(candidates, [](const Candidate& c) { return c.is_proved(); });
    }

    // Whether it is one time for certain.
    bool is_instant() const
    {
      return time.first == time.second ||
          (candidates.size() == 1 && candidates.front().is_alone &&
           candidates.front().solution.kind() == Solution_kind::CERTIFIED);
    }
  };

  States& m_states;
  const Search& m_search;
  Budgeted_solver& m_solve;
  Contact_state m_state_at_begin = Contact_state::UNDECIDED, m_state_at_end = Contact_state::UNDECIDED;
  std::vector<Contact_event_d<Contact>> m_events;
  std::vector<Undecided_part> m_undecided;

public:
  Contact_timeline(States& states, const Search& search, Budgeted_solver& solve)
    : m_states(states), m_search(search), m_solve(solve)
  {}

  // From all distinct contacts at which the state may change, in the order of time.
  Contact_events_d<Contact> operator()(const Candidates& candidates)
  {
    add(candidates);
    return {m_state_at_begin, m_state_at_end, m_events, m_undecided, summary_of(m_solve, m_undecided.empty())};
  }

private:
  void add(const Candidates& candidates)
  {
    const auto [begin, end] = m_search.motion().domain();
    const std::vector<Group> groups = groups_of(candidates);
    Contact_state before = m_state_at_begin = known_state_at(begin, candidates);
    Exact_rational time_before = begin;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Exact_rational& next = i + 1 < groups.size() ? groups[i + 1].time.first : end;
      const Exact_rational time_after =
          groups[i].time.second < next ? short_number_between(groups[i].time.second, next) : end;
      const Contact_state after = known_state_at(time_after, candidates);
      if (m_solve.has_ended())
        break;
      add_group(groups[i], before, after, {time_before, time_after});
      before = after;
      time_before = time_after;
    }
    if (!m_solve.has_ended())
      m_state_at_end = known_state_at(end, candidates);
    if (m_solve.has_ended())
      m_undecided.push_back(undecided_time({time_before, end}, in_words(m_solve.reason())));
  }

  static std::vector<Group> groups_of(const Candidates& candidates)
  {
    std::vector<Group> result;
    for (const Candidate& c : candidates)
      if (!result.empty() && c.time.first <= result.back().time.second) {
        result.back().time.second = (std::max)(result.back().time.second, c.time.second);
        result.back().candidates.push_back(c);
      } else
        result.push_back({c.time, {c}});
    return result;
  }

  Contact_state known_state_at(const Exact_rational& time, const Candidates& candidates)
  {
    const Contact_state result = m_states.at(time, candidates);
    if (result == Contact_state::UNDECIDED && !m_solve.has_ended())
      m_undecided.push_back(undecided_time({time, time}, States::not_decided));
    return result;
  }

  // `around`: a time before it and one after it, with these states.
  void add_group(const Group& group, Contact_state before, Contact_state after, const Parameter_range& around)
  {
    if (before == Contact_state::UNDECIDED || after == Contact_state::UNDECIDED) {
      m_undecided.push_back(undecided_time(group.time, States::not_decided));
      return;
    }
    const bool do_graze = before == Contact_state::APART && after == Contact_state::APART &&
        std::ranges::any_of(group.candidates, [](const Candidate& c) { return c.is_proved(); });
    if (before != after || do_graze)
      m_events.push_back({group.time, before, after, proved_contacts<Contact>(m_search, group.candidates)});
    if (before == Contact_state::OVERLAPPING && after == Contact_state::OVERLAPPING) {
      if (!group.is_instant() && !m_states.overlap_lasts(group.time, around.first))
        m_undecided.push_back(undecided_time(group.time, "whether they overlap all the time"));
    } else
      for (const Candidate& c : group.candidates)
        if (!c.is_proved())
          m_undecided.push_back(undecided_contact(m_search, c));
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMELINE_H
