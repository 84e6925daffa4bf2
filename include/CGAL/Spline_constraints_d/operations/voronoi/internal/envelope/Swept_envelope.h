// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_SWEPT_ENVELOPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_SWEPT_ENVELOPE_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Envelope_arc.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The envelope arcs of an element, as it is swept from its begin to its end.
*/
class Swept_envelope
{
  std::vector<Envelope_arc> m_arcs;
  std::optional<Range> m_unresolved;   // at the end of what has been swept

public:
  std::vector<Envelope_arc>& arcs() { return m_arcs; }
  const std::optional<Range>& unresolved() const { return m_unresolved; }

  // All of them, once the element has been swept; none if nothing could be resolved.
  std::vector<Envelope_arc> take()
  {
    if (m_unresolved && !m_arcs.empty())
      m_arcs.back().events[1] = Disk_event::UNRESOLVED;
    return std::move(m_arcs);
  }

  // Whether all that has been swept is resolved.
  bool is_resolved() const
  {
    return !m_unresolved && std::all_of(m_arcs.begin(), m_arcs.end(), [](const Envelope_arc& arc) {
      return arc.events[0] != Disk_event::UNRESOLVED && arc.events[1] != Disk_event::UNRESOLVED;
    });
  }

  // After an event, which ends the last one.
  void append_event(Disk_event event, const Located_footpoint& after, const Range& range)
  {
    m_arcs.back().events[1] = event;
    m_arcs.push_back({after.footpoint, range, {event, Disk_event::NONE}, {{range, after}}});
  }

  void append(const Located_footpoint& located, const Range& range)
  {
    if (!m_arcs.empty() && !m_unresolved && m_arcs.back().footpoint == located.footpoint) {
      m_arcs.back().range.end = range.end;
      m_arcs.back().boxes.emplace_back(range, located);
      return;
    }
    // Two neighbouring ranges have different footpoints only if both have the same curvature between them, which is
    // decided nowhere.
    const Disk_event event = m_unresolved || !m_arcs.empty() ? Disk_event::UNRESOLVED : Disk_event::NONE;
    if (!m_arcs.empty())
      m_arcs.back().events[1] = event;
    m_arcs.push_back({located.footpoint, range, {event, Disk_event::NONE}, {{range, located}}});
    m_unresolved.reset();
  }

  // Those of a range, of which the first one goes on with the last footpoint.
  void append(const std::vector<Envelope_arc>& envelope_arcs)
  {
    const Envelope_arc& first = envelope_arcs.front();
    for (const auto& [range, located] : first.boxes)
      append(located, range);
    m_arcs.back().events[1] = first.events[1];
    if (first.corner)
      m_arcs.back().corner = first.corner;
    m_arcs.back().holds_events = m_arcs.back().holds_events || first.holds_events;
    m_arcs.insert(m_arcs.end(), envelope_arcs.begin() + 1, envelope_arcs.end());
  }

  void append_unresolved(const Range& range)
  {
    if (m_unresolved)
      m_unresolved->end = range.end;
    else
      m_unresolved = range;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_SWEPT_ENVELOPE_H
