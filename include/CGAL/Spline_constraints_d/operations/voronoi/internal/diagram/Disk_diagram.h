// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DISK_DIAGRAM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DISK_DIAGRAM_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Maximal_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Stretch_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/check_magnitude.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/undecided_parts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The centers of all maximal disks, as a planar graph. Each stretch of a front is a halfedge: the centers of its disks. Fronts are traversed with the free side on the left, so that halfedges follow each other around the region that belongs to a connected set of curves. The twin of a halfedge is that of the front on
the other side of the disks, found by the other contact of one disk in the middle of the stretch: both stretches contain that disk, and so, as the ends of both are events, all the others. Vertices are the cycles of this structure: nothing is compared by coordinates.
*/
class Disk_diagram
{
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // A stretch of a front.
  struct Part
  {
    std::size_t front, stretch;
  };

  struct Halfedge
  {
    std::vector<Part> parts;   // in order; several where the normals of a vertex come in several fans
    std::size_t twin = none, next = none, previous = none, source = none;
    bool begins_unresolved = false;   // something before it is not resolved
  };

  struct Vertex
  {
    std::vector<std::size_t> outgoing;   // halfedges, clockwise
    bool is_at_infinity = false;
    bool is_resolved = true;
  };

private:
  const Site_graph_2& m_graph;
  std::shared_ptr<const Fine_level> m_fine_level;   // of the graph
  Stretch_disks m_disks;
  std::vector<std::size_t> m_fronts;                       // those it is made of
  std::vector<std::vector<Disk_stretch>> m_stretches;      // of each front
  std::vector<std::vector<std::size_t>> m_halfedges_of;    // of each front, for each stretch
  std::vector<Halfedge> m_halfedges;
  std::vector<Vertex> m_vertices;
  std::vector<Part> m_lone_circles;                        // one of each cycle whose disks all are the same

public:
  // The fronts are all, or those of some cycles; others have no stretches.
  Disk_diagram(const Site_graph_2& graph, std::shared_ptr<const Fine_level> fine_level, std::vector<std::size_t> fronts, std::vector<std::vector<Disk_stretch>> stretches)
    : m_graph(graph), m_fine_level(std::move(fine_level)), m_disks(graph, Disk_curvature(graph), *m_fine_level), m_fronts(std::move(fronts)), m_stretches(std::move(stretches))
  {
    const Upward_rounding_guard guard;
    for (const auto& stretches : m_stretches)
      m_halfedges_of.emplace_back(stretches.size(), none);
    connect_cycles();
    match_twins();
    make_vertices();
  }

  const std::vector<Halfedge>& halfedges() const { return m_halfedges; }
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Part>& lone_circles() const { return m_lone_circles; }
  // The parts of fronts that are not resolved, or that are resolved and have no twin.
  std::vector<Front_range> unresolved_parts() const
  {
    std::vector<Front_range> result;
    for (const std::size_t f : m_fronts) {
      const std::vector<Disk_stretch>& stretches = m_stretches[f];
      for (std::size_t i = 0; i <= stretches.size(); ++i)
        if (stretches.empty() || (i > 0 && stretches[i - 1].events[1] == Disk_event::UNRESOLVED) || (i < stretches.size() && stretches[i].events[0] == Disk_event::UNRESOLVED))
          result.push_back({f, {i > 0 ? stretches[i - 1].range.end : 0, i < stretches.size() ? stretches[i].range.begin : 1}});
    }
    for (const Halfedge& h : m_halfedges)
      if (!is_at_infinity(h) && h.twin == none)
        for (const Part& part : h.parts)
          result.push_back({part.front, stretch(part).range});
    return result;
  }

  bool is_complete() const { return m_graph.is_proved() && unresolved_parts().empty(); }

  const Disk_stretch& stretch(const Part& part) const { return m_stretches[part.front][part.stretch]; }
  const Front& front(const Part& part) const { return m_graph.fronts()[part.front]; }
  const Front& front(const Halfedge& h) const { return front(h.parts.front()); }
  const Disk_contact& contact(const Halfedge& h) const { return stretch(h.parts.front()).contact; }
  bool is_at_infinity(const Halfedge& h) const { return contact(h).kind == Disk_contact::Kind::NOTHING; }

  // The parameter where a part begins or ends.
  double end_parameter(const Part& part, bool end) const { return end != front(part).is_reversed ? stretch(part).range.end : stretch(part).range.begin; }

  // The range of a front in which the disk is where a halfedge begins or ends: between the stretches there.
  Front_range range_of_end(std::size_t halfedge, bool end) const
  {
    const Part& part = end ? m_halfedges[halfedge].parts.back() : m_halfedges[halfedge].parts.front();
    const std::vector<Disk_stretch>& stretches = m_stretches[part.front];
    const std::size_t behind = part.stretch + (end != front(part).is_reversed);
    const auto bound = [&](std::size_t i, bool upper) { return stretches[i].holds_events == upper ? stretches[i].range.end : stretches[i].range.begin; };
    return {part.front, {behind > 0 ? bound(behind - 1, false) : 0, behind < stretches.size() ? bound(behind, true) : 1}};
  }

  // The point of a corner, if that is where a halfedge begins or ends.
  std::optional<Interval_pair> corner_at_end(std::size_t halfedge, bool end) const
  {
    const Part& part = end ? m_halfedges[halfedge].parts.back() : m_halfedges[halfedge].parts.front();
    if (const auto& corner = stretch(part).corner; corner && corner->is_end == (end != front(part).is_reversed))
      return m_graph.vertices()[m_graph.vertex_of({front(part).object, corner->is_end})].point;
    const Stretch_disks::Disk disk = estimated_disk(part, end_parameter(part, end));
    return disk.is_point ? std::optional(disk.center) : std::nullopt;
  }

  // The arc of a circle, if any, all of which a disk touches where a halfedge begins: its stretch comes before that.
  std::optional<std::size_t> circle_before(std::size_t halfedge) const
  {
    const Part& first = m_halfedges[halfedge].parts.front();
    for (Part part = part_after(m_halfedges[m_halfedges[halfedge].previous].parts.back()); part.front != first.front || part.stretch != first.stretch; part = part_after(part))
      if (stretch(part).contact.kind == Disk_contact::Kind::CIRCLE)
        return front(part).object;
    return std::nullopt;
  }

  const std::shared_ptr<const Fine_level>& fine_level() const { return m_fine_level; }

  // See Stretch_disks.
  Stretch_disks::Disk estimated_disk(const Part& part, double u) const { return m_disks.estimated(part.front, stretch(part), u); }

private:
  // Calls visit(part, unresolved before it) along a cycle of fronts, and returns whether something behind the last one is unresolved.
  template <class Visit>
  bool traverse(std::size_t first, std::vector<char>& is_visited, const Visit& visit) const
  {
    bool is_unresolved = false;
    std::size_t f = first;
    do {
      is_visited[f] = true;
      const bool is_reversed = m_graph.fronts()[f].is_reversed;
      const std::size_t n = m_stretches[f].size();
      is_unresolved = is_unresolved || n == 0;
      for (std::size_t i = 0; i < n; ++i) {
        const Part part{f, is_reversed ? n - 1 - i : i};
        const auto& events = stretch(part).events;
        is_unresolved = is_unresolved || events[is_reversed] == Disk_event::UNRESOLVED;
        if (stretch(part).contact.kind != Disk_contact::Kind::CIRCLE) {
          visit(part, is_unresolved);
          is_unresolved = false;
        }
        is_unresolved = is_unresolved || events[!is_reversed] == Disk_event::UNRESOLVED;
      }
      f = m_graph.fronts()[f].next;
    } while (f != first);
    return is_unresolved;
  }

  // The next one in the traversal of a cycle, of which some part is resolved.
  Part part_after(const Part& part) const
  {
    const bool is_reversed = front(part).is_reversed;
    if (is_reversed ? part.stretch > 0 : part.stretch + 1 < m_stretches[part.front].size())
      return {part.front, is_reversed ? part.stretch - 1 : part.stretch + 1};
    std::size_t f = front(part).next;
    while (m_stretches[f].empty())
      f = m_graph.fronts()[f].next;
    return {f, m_graph.fronts()[f].is_reversed ? m_stretches[f].size() - 1 : 0};
  }

  // Whether a part begins where another one ends, in the next fan of the same vertex.
  bool goes_on(const Part& before, const Part& after) const
  {
    const Front &a = front(before), &b = front(after);
    return a.is_fan && b.is_fan && a.object == b.object && a.next == after.front && before.front != after.front && stretch(before).contact == stretch(after).contact &&
           stretch(before).range.end == 1 && stretch(before).events[1] == Disk_event::NONE && stretch(after).range.begin == 0 && stretch(after).events[0] == Disk_event::NONE;
  }

  void connect_cycles()
  {
    std::vector<char> is_visited(m_stretches.size(), false);
    for (const std::size_t first : m_fronts) {
      if (is_visited[first])
        continue;
      std::vector<Halfedge> cycle;
      const bool is_unresolved_at_end = traverse(first, is_visited, [&](const Part& part, bool is_unresolved) {
        if (!cycle.empty() && !is_unresolved && goes_on(cycle.back().parts.back(), part))
          cycle.back().parts.push_back(part);
        else {
          cycle.push_back({{part}});
          cycle.back().begins_unresolved = is_unresolved;
        }
      });
      if (cycle.empty()) {
        if (!m_stretches[first].empty())
          m_lone_circles.push_back({first, 0});
        continue;
      }
      cycle.front().begins_unresolved = cycle.front().begins_unresolved || is_unresolved_at_end;
      if (cycle.size() > 1 && !cycle.front().begins_unresolved && goes_on(cycle.back().parts.back(), cycle.front().parts.front())) {
        cycle.back().parts.insert(cycle.back().parts.end(), cycle.front().parts.begin(), cycle.front().parts.end());
        cycle.erase(cycle.begin());
      }
      append_cycle(std::move(cycle));
    }
  }

  void append_cycle(std::vector<Halfedge> cycle)
  {
    const std::size_t first = m_halfedges.size(), n = cycle.size();
    for (std::size_t i = 0; i < n; ++i) {
      cycle[i].previous = first + (i + n - 1) % n;
      cycle[i].next = first + (i + 1) % n;
      for (const Part& part : cycle[i].parts)
        m_halfedges_of[part.front][part.stretch] = first + i;
      m_halfedges.push_back(std::move(cycle[i]));
    }
  }

  // The disks of one of two twins tell which one the other is, unless they are too near to an event; those of both do not contradict each other.
  void match_twins()
  {
    std::vector<std::size_t> twins(m_halfedges.size(), none), told(m_halfedges.size(), 0);   // of the latter how many have it as their twin
    for (std::size_t i = 0; i < m_halfedges.size(); ++i)
      if (!is_at_infinity(m_halfedges[i]) && (twins[i] = twin_of(m_halfedges[i])) != none)
        ++told[twins[i]];
    for (std::size_t i = 0; i < m_halfedges.size(); ++i)
      if (const std::size_t twin = twins[i]; twin != none && told[twin] == 1 && (twins[twin] == i || (twins[twin] == none && told[i] == 0)))
        std::tie(m_halfedges[i].twin, m_halfedges[twin].twin) = std::pair(twin, i);
  }

  std::size_t twin_of(const Halfedge& h) const
  {
    if (const Part& part = h.parts.front(); stretch(part).corner) {   // the other side of the pocket, which may be larger and have its disks told by bounds
      const std::size_t other = stretch(part).corner->is_end != front(part).is_reversed ? h.next : h.previous;
      return is_contact_with(contact(m_halfedges[other]), front(part)) && is_contact_with(contact(h), front(m_halfedges[other])) ? other : none;
    }
    for (const bool is_fine : {false, true})
      for (const Part& part : h.parts)
        for (const double share : {0.5, 0.40625, 0.59375, 0.25, 0.75, 0.125, 0.875}) {
          const Range& range = stretch(part).range;
          const auto touched = m_disks.touched_front(part.front, stretch(part), range.begin + share * range.width(), is_fine);
          if (const std::size_t twin = touched ? halfedge_at(*touched, front(part)) : none; twin != none)
            return twin;
        }
    for (const Part& part : h.parts)
      if (const std::size_t twin = twin_at_tip(part); twin != none)
        return twin;
    return none;
  }

  // Where a fan has its contact on an arc that begins or ends there, on the side that comes next: without the disk, which is too near to the vertex to tell. (Elsewhere the arc may come back, so that it is the other side.)
  std::size_t twin_at_tip(const Part& part) const
  {
    const Disk_contact& contact = stretch(part).contact;
    if (!front(part).is_fan || contact.kind != Disk_contact::Kind::ARC)
      return none;
    Range range = stretch(part).boxes.front().second.range;
    for (const auto& [part_of_front, located] : stretch(part).boxes)
      range = united(range, located.range);
    for (const std::size_t side : {2 * contact.index, 2 * contact.index + 1})
      if (front(part).next == side || m_graph.fronts()[side].next == part.front)
        return halfedge_at({side, range}, front(part));
    return none;
  }

  // The halfedge of the only stretch with a contact on a front that may hold a parameter. Events are somewhere between the ranges of their stretches.
  std::size_t halfedge_at(const Touched_front& touched, const Front& other) const
  {
    const std::vector<Disk_stretch>& stretches = m_stretches[touched.front];
    std::size_t result = none;
    for (std::size_t s = 0; s < stretches.size(); ++s) {
      const Range around{s > 0 ? stretches[s - 1].range.end : 0, s + 1 < stretches.size() ? stretches[s + 1].range.begin : 1};
      if (!around.meets(touched.range))
        continue;
      const auto& [range, events] = std::tie(stretches[s].range, stretches[s].events);
      if ((events[0] == Disk_event::UNRESOLVED && touched.range.begin < range.begin) || (events[1] == Disk_event::UNRESOLVED && touched.range.end > range.end))
        return none;
      if (is_contact_with(stretches[s].contact, other)) {
        if (result != none)
          return none;
        result = s;
      }
    }
    return result == none ? none : m_halfedges_of[touched.front][result];
  }

  // Around the source of a halfedge: the twin of the one before it begins there, too.
  void make_vertices()
  {
    for (std::size_t first = 0; first < m_halfedges.size(); ++first) {
      if (is_at_infinity(m_halfedges[first]) || m_halfedges[first].source != none)
        continue;
      Vertex vertex;
      const auto visit = [&](std::size_t h) {
        m_halfedges[h].source = m_vertices.size();
        vertex.outgoing.push_back(h);
        vertex.is_resolved = vertex.is_resolved && !m_halfedges[h].begins_unresolved;
      };
      const auto previous_twin = [&](std::size_t h) {
        const Halfedge& before = m_halfedges[m_halfedges[h].previous];
        vertex.is_at_infinity = vertex.is_at_infinity || is_at_infinity(before);
        return before.twin;
      };
      std::size_t h = first_of_star(first);
      do {
        visit(h);
        h = previous_twin(h);
      } while (h != none && m_halfedges[h].source == none);
      vertex.is_resolved = vertex.is_resolved && (h != none || vertex.is_at_infinity);
      m_vertices.push_back(std::move(vertex));
    }
  }

  // The outgoing halfedge of a vertex with which visiting begins: at infinity the one before which there is nothing, elsewhere any.
  std::size_t first_of_star(std::size_t halfedge) const
  {
    std::size_t result = halfedge;
    while (m_halfedges[result].twin != none) {
      const std::size_t before = m_halfedges[m_halfedges[result].twin].next;
      if (is_at_infinity(m_halfedges[before]))
        return result;
      if (before == halfedge || m_halfedges[before].source != none)
        return halfedge;
      result = before;
    }
    return result;
  }
};

// The diagram of a graph of curves, on all fronts, or on those of some cycles. With a tag for parallel work, fronts are handed to all cores.
template <class Concurrency_tag>
Disk_diagram disk_diagram(const Site_graph_2& graph, std::vector<std::size_t> fronts, const std::string& operation)
{
  check_magnitude(graph, operation);
  const Site_tree_2 tree(graph);
  const Cusps_2 cusps = Cusp_finder_2(graph, tree)();
  const auto fine_level = std::make_shared<const Fine_level>(graph);
  std::vector<std::vector<Disk_stretch>> stretches(graph.fronts().size());
  parallel_for<Concurrency_tag>(fronts.size(), [&](std::size_t i, std::size_t) {
    const Upward_rounding_guard guard;
    stretches[fronts[i]] = Maximal_disks(graph, tree, cusps, fine_level.get())(fronts[i]);
  });
  return Disk_diagram(graph, fine_level, std::move(fronts), std::move(stretches));
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DISK_DIAGRAM_H
