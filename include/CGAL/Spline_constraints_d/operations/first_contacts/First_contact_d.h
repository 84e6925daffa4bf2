// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_D_H

#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_state.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Uncertain.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFirstContacts

When two regions or solids meet first: see `first_contact()`.

\tparam Contact how they meet: `Contact_2` or `Contact_3`.
*/
template <class Contact>
class First_contact_d
{
public:
  //! a closed range of times.
  using Range = typename Contact::Range;

private:
  Contact_state m_state_at_begin = Contact_state::UNDECIDED;
  std::optional<Range> m_time;
  bool m_is_proved = false;
  std::vector<Contact> m_contacts;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what the operation has found; `is_proved`: there is a contact in the range of time.
  First_contact_d(Contact_state state_at_begin, std::optional<Range> time, bool is_proved,
                  std::vector<Contact> contacts, std::vector<Undecided_part> undecided, const Summary& summary)
    : m_state_at_begin(state_at_begin), m_time(std::move(time)), m_is_proved(is_proved),
      m_contacts(std::move(contacts)), m_undecided(std::move(undecided)), m_summary(summary)
  {
    m_summary.is_complete = m_summary.is_complete && m_undecided.empty();
  }

  //! how they lie to each other at the first time of the motion: already overlapping, or touching, or apart.
  Contact_state state_at_begin() const { return m_state_at_begin; }

  //! whether they meet at any time of the motion. `false` is proved for all times; indeterminate where neither is.
  CGAL::Uncertain<bool> do_meet() const { return {m_is_proved, m_time.has_value()}; }

  //! before this range they are apart, and if `do_meet()` is certain they meet in it; nothing, if they never meet. The
  //! first time of the motion alone, where they meet then.
  const std::optional<Range>& time_range() const { return m_time; }

  //! the contacts that are the first ones: all whose enclosures of the time meet `time_range()`. Several, if they come
  //! at the same time, or so close to each other that this is not decided. None if they overlap at the first time.
  const std::vector<Contact>& contacts() const { return m_contacts; }

  //! whether the time is enclosed and a contact proved, or it is proved that there is none.
  bool is_complete() const { return m_summary.is_complete; }

  //! what is not decided: the place is a range of time; the curves or surfaces that bound what is fixed are counted
  //! behind those of what moves.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

/*!
\ingroup PkgSplineConstraintsDFirstContacts

A time at which regions or solids begin or cease to meet, to touch or to overlap, or meet for this time alone.

\tparam Contact as of `First_contact_d`.
*/
template <class Contact>
struct Contact_event_d
{
  typename Contact::Range time;  ///< encloses the time, or all times if there are several
  Contact_state before;          ///< since the event before, or at the first time of the motion
  Contact_state after;           ///< until the next event
  std::vector<Contact> contacts; ///< where they meet then
};

/*!
\ingroup PkgSplineConstraintsDFirstContacts

When two regions or solids meet, and when they do not: see `contact_events()`.

\tparam Contact as of `First_contact_d`.
*/
template <class Contact>
class Contact_events_d
{
  Contact_state m_state_at_begin = Contact_state::UNDECIDED, m_state_at_end = Contact_state::UNDECIDED;
  std::vector<Contact_event_d<Contact>> m_events;
  std::vector<Undecided_part> m_undecided;
  Summary m_summary;

public:
  //! what the operation has found.
  Contact_events_d(Contact_state state_at_begin, Contact_state state_at_end,
                   std::vector<Contact_event_d<Contact>> events, std::vector<Undecided_part> undecided,
                   const Summary& summary)
    : m_state_at_begin(state_at_begin), m_state_at_end(state_at_end), m_events(std::move(events)),
      m_undecided(std::move(undecided)), m_summary(summary)
  {
    m_summary.is_complete = m_summary.is_complete && m_undecided.empty();
  }

  //! at the first time.
  Contact_state state_at_begin() const { return m_state_at_begin; }

  //! at the last time.
  Contact_state state_at_end() const { return m_state_at_end; }

  //! in the order of time. Those with `APART` before and after are contacts that last no longer than the enclosure of
  //! their time: they graze each other.
  const std::vector<Contact_event_d<Contact>>& events() const { return m_events; }

  //! whether all events are there, and all states are decided.
  bool is_complete() const { return m_summary.is_complete; }

  //! what is not decided, as of `First_contact_d`.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

  //! the work.
  const Summary& summary() const { return m_summary; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_FIRST_CONTACT_D_H
