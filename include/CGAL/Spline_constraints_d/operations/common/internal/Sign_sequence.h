// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SIGN_SEQUENCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SIGN_SEQUENCE_H

#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// Where a formula along a curve is zero, or jumps. Signs are 0 where there is no curve, or nothing is known.
struct Sign_event
{
  std::pair<Exact_rational, Exact_rational> range;
  int before = 0, after = 0;
  bool is_break = false;   // at a break of the curve
  bool is_cut = false;     // the formula says nothing there, but only on either side
  std::vector<Solution_d<double>> zeros = {};

  bool is_family() const
  {
    return std::any_of(zeros.begin(), zeros.end(),
                       [](const auto& zero) { return zero.kind() == Solution_kind::CONTINUUM; });
  }
  bool is_undecided() const
  {
    return std::any_of(zeros.begin(), zeros.end(),
                       [](const auto& zero) { return zero.kind() == Solution_kind::UNDECIDED; });
  }
};

/*
The signs of a formula along a curve: events, and the sign in each gap between them, zero in gaps that are empty. A
system in one unknown gives all zeros on a piece, so that one value between two of them is the sign of the gap.
*/
class Sign_sequence
{
  std::vector<Sign_event> m_events;
  std::vector<int> m_signs;   // before, between and after the events

public:
  // `formula(piece, u)`, continuous between successive pieces where `joins(piece, next)`.
  template <class Formula, class Joins>
  Sign_sequence(const std::vector<Differentiated_map>& pieces, bool is_closed, const Formula& formula,
                const Joins& joins, Budgeted_solver& solve)
  {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      Sign_sequence next(pieces[i], formula, solve);
      if (i == 0)
        *this = std::move(next);
      else
        append(std::move(next), pieces[i].begin(), joins(pieces[i - 1], pieces[i]));
    }
    for (std::size_t i = 0; i < m_events.size(); ++i) {
      m_events[i].before = m_signs[i];
      m_events[i].after = m_signs[i + 1];
    }
    if (is_closed)
      close(pieces.front().begin(), joins(pieces.back(), pieces.front()));
  }

  const std::vector<Sign_event>& events() const { return m_events; }

  // At the two ends of the domain, 0 where an event is there.
  int first_sign() const { return m_signs.front(); }
  int last_sign() const { return m_signs.back(); }

private:
  template <class Formula>
  Sign_sequence(const Differentiated_map& piece, const Formula& formula, Budgeted_solver& solve)
  {
    const auto [u] = parameters(piece.map());
    const Expression f = formula(piece, u);
    const auto sign_between = [&](const Exact_rational& a, const Exact_rational& b) {
      return sign_of(f(std::array<Exact_rational, 1>{Exact_rational((a + b) / 2)}));
    };
    for (const Solution_d<double>& solution : solve({f == 0})) {
      const auto [lower, upper] = solution.exact_box()[0];
      m_events.push_back(
          {{(std::max)(lower, piece.begin()), (std::min)(upper, piece.end())}, 0, 0, false, false, {solution}});
    }
    std::sort(m_events.begin(), m_events.end(),
              [](const Sign_event& a, const Sign_event& b) { return a.range < b.range; });
    Exact_rational last = piece.begin();
    for (const Sign_event& event : m_events) {
      m_signs.push_back(sign_between(last, event.range.first));
      last = event.range.second;
    }
    m_signs.push_back(sign_between(last, piece.end()));
  }

  void append(Sign_sequence next, const Exact_rational& at, bool is_joined);

  static void merge(Sign_event& event, Sign_event& next);

  // The end of a closed curve is the begin: an event there is reported with the first parameter. Families that meet
  // there remain two.
  void close(const Exact_rational& begin, bool is_joined);
};

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE void Sign_sequence::append(Sign_sequence next, const Exact_rational& at, bool is_joined)
{
  const bool is_zero_before = m_signs.back() == 0, is_zero_after = next.m_signs.front() == 0;
  const bool is_needed = !is_joined || (!is_zero_before && !is_zero_after && m_signs.back() != next.m_signs.front());
  if (is_needed) {
    m_events.push_back({{at, at}, 0, 0, true, !is_joined});
    m_signs.push_back(next.m_signs.front());
  } else if (is_zero_before && is_zero_after) {
    merge(m_events.back(), next.m_events.front());
    m_signs.back() = next.m_signs[1];
    next.m_events.erase(next.m_events.begin());
    next.m_signs.erase(next.m_signs.begin());
  } else if (is_zero_before) {
    m_signs.back() = next.m_signs.front();
    m_events.back().is_break = true;
  } else if (is_zero_after)
    next.m_events.front().is_break = true;
  std::move(next.m_events.begin(), next.m_events.end(), std::back_inserter(m_events));
  m_signs.insert(m_signs.end(), next.m_signs.begin() + 1, next.m_signs.end());
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Sign_sequence::merge(Sign_event& event, Sign_event& next)
{
  event.range.second = next.range.second;
  event.is_break = true;
  std::move(next.zeros.begin(), next.zeros.end(), std::back_inserter(event.zeros));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Sign_sequence::close(const Exact_rational& begin, bool is_joined)
{
  const std::size_t size = m_events.size();
  const bool is_zero_begin = m_signs.front() == 0, is_zero_end = m_signs.back() == 0;
  if (!is_joined || (!is_zero_begin && !is_zero_end)) {
    if (!is_joined || m_signs.front() != m_signs.back())
      m_events.insert(m_events.begin(), {{begin, begin}, m_signs.back(), m_signs.front(), true, !is_joined});
    return;
  }
  if (size == 1 && is_zero_begin && is_zero_end)
    return; // zero everywhere
  if (is_zero_begin)
    m_events.front().before = is_zero_end ? m_signs[size - 1] : m_signs[size];
  if (is_zero_end)
    m_events.back().after = is_zero_begin ? m_signs[1] : m_signs[0];
  if (is_zero_end && !m_events.back().is_family()) {
    Sign_event at_end = std::move(m_events.back());
    m_events.pop_back();
    at_end.range = {begin, begin};
    if (!is_zero_begin)
      m_events.insert(m_events.begin(), std::move(at_end));
  } else if (is_zero_end && is_zero_begin && !m_events.front().is_family())
    m_events.erase(m_events.begin()); // a part of the family at the end
  (is_zero_end && m_events.back().is_family() ? m_events.back() : m_events.front()).is_break = true;
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SIGN_SEQUENCE_H
