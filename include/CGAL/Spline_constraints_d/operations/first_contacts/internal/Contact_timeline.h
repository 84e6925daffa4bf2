// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMELINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMELINE_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/First_contact_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Contact_search.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/Lasting_overlap.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/State_of_regions.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/contact_finders.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/internal/distinct_contacts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

constexpr const char* state_not_decided = "how the regions lie to each other at this time";

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

/*
What happens in the course of time. All times at which the state of the regions changes are those of candidates. Those
whose enclosures meet are one group; between two groups nothing changes, and one time tells the state.
*/
class Contact_timeline
{
  struct Group
  {
    Parameter_range time;
    std::vector<Contact_candidate> candidates;

    bool is_proved() const
    {
      return std::ranges::all_of(candidates, [](const Contact_candidate& c) { return c.is_proved(); });
    }

    // Whether it is one time for certain.
    bool is_instant() const
    {
      return time.first == time.second ||
          (candidates.size() == 1 && candidates.front().is_alone &&
           candidates.front().solution.kind() == Solution_kind::CERTIFIED);
    }
  };

  const Moving_regions& m_regions;
  const Contact_search& m_search;
  Budgeted_solver& m_solve;
  Contact_state m_state_at_begin = Contact_state::UNDECIDED, m_state_at_end = Contact_state::UNDECIDED;
  std::vector<Contact_event_2> m_events;
  std::vector<Undecided_part> m_undecided;

public:
  Contact_timeline(const Moving_regions& regions, const Contact_search& search, Budgeted_solver& solve)
    : m_regions(regions), m_search(search), m_solve(solve)
  {}

  Contact_state state_at_begin() const { return m_state_at_begin; }
  Contact_state state_at_end() const { return m_state_at_end; }
  const std::vector<Contact_event_2>& events() const { return m_events; }
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  // All distinct contacts at which the state may change, in the order of time.
  void add(const std::vector<Contact_candidate>& candidates)
  {
    const auto [begin, end] = m_regions.motion.domain();
    const std::vector<Group> groups = groups_of(candidates);
    Contact_state before = m_state_at_begin = known_state_at(begin);
    Exact_rational time_before = begin;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const Exact_rational& next = i + 1 < groups.size() ? groups[i + 1].time.first : end;
      const Exact_rational time_after =
          groups[i].time.second < next ? short_number_between(groups[i].time.second, next) : end;
      const Contact_state after = known_state_at(time_after);
      if (m_solve.has_ended())
        break;
      add_group(groups[i], before, after, {time_before, time_after});
      before = after;
      time_before = time_after;
    }
    if (!m_solve.has_ended())
      m_state_at_end = known_state_at(end);
    if (m_solve.has_ended())
      m_undecided.push_back(undecided_time({time_before, end}, in_words(m_solve.reason())));
  }

private:
  static std::vector<Group> groups_of(const std::vector<Contact_candidate>& candidates)
  {
    std::vector<Group> result;
    for (const Contact_candidate& c : candidates)
      if (!result.empty() && c.time.first <= result.back().time.second) {
        result.back().time.second = (std::max)(result.back().time.second, c.time.second);
        result.back().candidates.push_back(c);
      } else
        result.push_back({c.time, {c}});
    return result;
  }

  Contact_state state_at(const Exact_rational& time)
  {
    return State_of_regions(moved(m_regions.moving, m_regions.motion, time), m_regions.fixed, m_solve)();
  }

  Contact_state known_state_at(const Exact_rational& time)
  {
    const Contact_state result = state_at(time);
    if (result == Contact_state::UNDECIDED && !m_solve.has_ended())
      m_undecided.push_back(undecided_time({time, time}, state_not_decided));
    return result;
  }

  // `around`: a time before it and one after it, with these states.
  void add_group(const Group& group, Contact_state before, Contact_state after, const Parameter_range& around)
  {
    if (before == Contact_state::UNDECIDED || after == Contact_state::UNDECIDED) {
      m_undecided.push_back(undecided_time(group.time, state_not_decided));
      return;
    }
    const bool do_graze = before == Contact_state::APART && after == Contact_state::APART &&
        std::ranges::any_of(group.candidates, [](const Contact_candidate& c) { return c.is_proved(); });
    if (before != after || do_graze)
      m_events.push_back({group.time, before, after, proved_contacts(m_search, group.candidates)});
    if (before == Contact_state::OVERLAPPING && after == Contact_state::OVERLAPPING) {
      if (!group.is_instant() && !overlap_lasts(group.time, around.first))
        m_undecided.push_back(undecided_time(group.time, "whether the regions overlap all the time"));
    } else
      for (const Contact_candidate& c : group.candidates)
        if (!c.is_proved())
          m_undecided.push_back(undecided_contact(m_search, c, m_regions.number_of_moving_curves));
  }

  // Whether a point of the boundary of one region is inside of the other one at a time before and until the end.
  bool overlap_lasts(const Parameter_range& time, const Exact_rational& before)
  {
    const Exact_rational begin =
        before < time.first ? short_number_between(close_to(time, before), time.first) : time.first;
    const auto moving = moved(m_regions.moving, m_regions.motion, begin);
    State_of_regions state(moving, m_regions.fixed, m_solve);
    const auto back = m_regions.motion(begin).inverse();
    for (const Exact_pair& p : state.inner_points(0)) {
      const auto own = back.transform(Rational_motion_2::Kernel::Point_2(p[0], p[1]));
      if (stays_inside(m_regions.fixed, m_regions.motion, {own.x(), own.y()}, {begin, time.second}))
        return true;
    }
    const Rational_motion_2 inverse = m_regions.motion.inverse();
    for (const Exact_pair& p : state.inner_points(1))
      if (stays_inside(m_regions.moving, inverse, p, {begin, time.second}))
        return true;
    return false;
  }

  // A time between the one before a group and the group, as far from it as the group is long.
  static Exact_rational close_to(const Parameter_range& time, const Exact_rational& before)
  {
    return (std::max)(before, Exact_rational(2 * time.first - time.second));
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_TIMELINE_H
