// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DISK_DIAGRAM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DISK_DIAGRAM_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Envelope_arc_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Maximal_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/check_magnitude.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/for_each_element.h>
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
The centers of all maximal disks, as a planar graph. Each envelope arc of an element is a halfedge: the centers of its
disks. Elements are traversed with the free side on the left, so that halfedges follow each other around the region that
belongs to a connected set of curves. The twin of a halfedge is that of the element on the other side of the disks,
found by the other footpoint of one disk in the middle of the envelope arc: both envelope arcs contain that disk, and
so, as the ends of both are events, all the others. Vertices are the cycles of this structure: nothing is compared by
coordinates.
*/
class Disk_diagram
{
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // An envelope arc of an element.
  struct Part
  {
    std::size_t element, envelope_arc;
  };

  struct Halfedge
  {
    std::vector<Part> parts;   // in order; several where the normals of a vertex come in several normal cones
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
  const Site_graph_2<>& m_graph;
  std::shared_ptr<const Fine_level> m_fine_level;   // of the graph
  Envelope_arc_disks m_disks;
  std::vector<std::size_t> m_elements;                       // those it is made of
  std::vector<std::vector<Envelope_arc>> m_envelope_arcs;      // of each element
  std::vector<std::vector<std::size_t>> m_halfedges_of;    // of each element, for each envelope arc
  std::vector<Halfedge> m_halfedges;
  std::vector<Vertex> m_vertices;
  std::vector<Part> m_lone_circles;                        // one of each cycle whose disks all are the same
  Rest_of_search m_rest;

public:
  // The elements are all, or those of some cycles; others have no envelope arcs.
  Disk_diagram(const Site_graph_2<>& graph, std::shared_ptr<const Fine_level> fine_level,
               std::vector<std::size_t> elements, std::vector<std::vector<Envelope_arc>> envelope_arcs,
               Rest_of_search rest, Search_control& control)
    : m_graph(graph), m_fine_level(std::move(fine_level)), m_disks(graph, Disk_curvature<>(graph), *m_fine_level),
      m_elements(std::move(elements)), m_envelope_arcs(std::move(envelope_arcs)),
      m_rest(std::move(rest))
  {
    const Upward_rounding_guard guard;
    for (const auto& envelope_arcs : m_envelope_arcs)
      m_halfedges_of.emplace_back(envelope_arcs.size(), none);
    connect_cycles();
    match_twins(control);
    make_vertices();
    m_rest.why_not = control.reason();
  }

  const std::vector<Halfedge>& halfedges() const { return m_halfedges; }
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Part>& lone_circles() const { return m_lone_circles; }
  // The parts of elements that are not resolved, or that are resolved and have no twin: if the search was ended, as the
  // other side was not swept.
  std::vector<Undecided_range> unresolved_parts() const
  {
    std::vector<Undecided_range> result;
    for (const std::size_t f : m_elements) {
      const std::vector<Envelope_arc>& envelope_arcs = m_envelope_arcs[f];
      for (std::size_t i = 0; i <= envelope_arcs.size(); ++i)
        if (envelope_arcs.empty() || (i > 0 && envelope_arcs[i - 1].events[1] == Disk_event::UNRESOLVED) ||
            (i < envelope_arcs.size() && envelope_arcs[i].events[0] == Disk_event::UNRESOLVED)) {
          const Range range{i > 0 ? envelope_arcs[i - 1].range.end : 0,
                            i < envelope_arcs.size() ? envelope_arcs[i].range.begin : 1};
          result.push_back({f, range, m_rest.why_not_decided(f, range)});
        }
    }
    for (const Halfedge& h : m_halfedges)
      if (!is_at_infinity(h) && h.twin == none)
        for (const Part& part : h.parts)
          result.push_back({part.element, envelope_arc(part).range, m_rest.why_not_connected()});
    return result;
  }

  const Envelope_arc& envelope_arc(const Part& part) const { return m_envelope_arcs[part.element][part.envelope_arc]; }
  const Oriented_element<>& element(const Part& part) const { return m_graph.elements()[part.element]; }
  const Oriented_element<>& element(const Halfedge& h) const { return element(h.parts.front()); }
  const Disk_footpoint& footpoint(const Halfedge& h) const { return envelope_arc(h.parts.front()).footpoint; }
  bool is_at_infinity(const Halfedge& h) const { return footpoint(h).kind == Disk_footpoint::Kind::NOTHING; }

  // The parameter where a part begins or ends.
  double end_parameter(const Part& part, bool end) const
  {
    return end != element(part).is_reversed ? envelope_arc(part).range.end : envelope_arc(part).range.begin;
  }

  // The range of an element in which the disk is where a halfedge begins or ends: between the envelope arcs there.
  Element_range range_of_end(std::size_t halfedge, bool end) const
  {
    const Part& part = end ? m_halfedges[halfedge].parts.back() : m_halfedges[halfedge].parts.front();
    const std::vector<Envelope_arc>& envelope_arcs = m_envelope_arcs[part.element];
    const std::size_t behind = part.envelope_arc + (end != element(part).is_reversed);
    const auto bound = [&](std::size_t i, bool upper) {
      return envelope_arcs[i].holds_events == upper ? envelope_arcs[i].range.end : envelope_arcs[i].range.begin;
    };
    return {part.element,
            {behind > 0 ? bound(behind - 1, false) : 0, behind < envelope_arcs.size() ? bound(behind, true) : 1}};
  }

  // The point of a corner, if that is where a halfedge begins or ends.
  std::optional<Interval_pair> corner_at_end(std::size_t halfedge, bool end) const
  {
    const Part& part = end ? m_halfedges[halfedge].parts.back() : m_halfedges[halfedge].parts.front();
    if (const auto& corner = envelope_arc(part).corner; corner && corner->is_end == (end != element(part).is_reversed))
      return m_graph.vertices()[m_graph.vertex_of({element(part).object, corner->is_end})].point;
    const Envelope_arc_disks::Disk disk = estimated_disk(part, end_parameter(part, end));
    return disk.is_point ? std::optional(disk.center) : std::nullopt;
  }

  // The arc of a circle, if any, all of which a disk touches where a halfedge begins: its envelope arc comes before
  // that.
  std::optional<std::size_t> circle_before(std::size_t halfedge) const
  {
    const Part& first = m_halfedges[halfedge].parts.front();
    for (Part part = part_after(m_halfedges[m_halfedges[halfedge].previous].parts.back());
         part.element != first.element || part.envelope_arc != first.envelope_arc; part = part_after(part))
      if (envelope_arc(part).footpoint.kind == Disk_footpoint::Kind::CIRCLE)
        return element(part).object;
    return std::nullopt;
  }

  const std::shared_ptr<const Fine_level>& fine_level() const { return m_fine_level; }

  // See Envelope_arc_disks.
  Envelope_arc_disks::Disk estimated_disk(const Part& part, double u) const
  {
    return m_disks.estimated(part.element, envelope_arc(part), u);
  }

private:
  // Calls visit(part, unresolved before it) along a cycle of elements, and returns whether something behind the last
  // one is unresolved.
  template <class Visit>
  bool traverse(std::size_t first, std::vector<char>& is_visited, const Visit& visit) const
  {
    bool is_unresolved = false;
    std::size_t f = first;
    do {
      is_visited[f] = true;
      const bool is_reversed = m_graph.elements()[f].is_reversed;
      const std::size_t n = m_envelope_arcs[f].size();
      is_unresolved = is_unresolved || n == 0;
      for (std::size_t i = 0; i < n; ++i) {
        const Part part{f, is_reversed ? n - 1 - i : i};
        const auto& events = envelope_arc(part).events;
        is_unresolved = is_unresolved || events[is_reversed] == Disk_event::UNRESOLVED;
        if (envelope_arc(part).footpoint.kind != Disk_footpoint::Kind::CIRCLE) {
          visit(part, is_unresolved);
          is_unresolved = false;
        }
        is_unresolved = is_unresolved || events[!is_reversed] == Disk_event::UNRESOLVED;
      }
      f = m_graph.elements()[f].next;
    } while (f != first);
    return is_unresolved;
  }

  // The next one in the traversal of a cycle, of which some part is resolved.
  Part part_after(const Part& part) const
  {
    const bool is_reversed = element(part).is_reversed;
    if (is_reversed ? part.envelope_arc > 0 : part.envelope_arc + 1 < m_envelope_arcs[part.element].size())
      return {part.element, is_reversed ? part.envelope_arc - 1 : part.envelope_arc + 1};
    std::size_t f = element(part).next;
    while (m_envelope_arcs[f].empty())
      f = m_graph.elements()[f].next;
    return {f, m_graph.elements()[f].is_reversed ? m_envelope_arcs[f].size() - 1 : 0};
  }

  // Whether a part begins where another one ends, in the next normal cone of the same vertex.
  bool goes_on(const Part& before, const Part& after) const
  {
    const Oriented_element<> &a = element(before), &b = element(after);
    return a.is_normal_cone && b.is_normal_cone && a.object == b.object && a.next == after.element &&
        before.element != after.element && envelope_arc(before).footpoint == envelope_arc(after).footpoint &&
        envelope_arc(before).range.end == 1 && envelope_arc(before).events[1] == Disk_event::NONE &&
        envelope_arc(after).range.begin == 0 && envelope_arc(after).events[0] == Disk_event::NONE;
  }

  void connect_cycles()
  {
    std::vector<char> is_visited(m_envelope_arcs.size(), false);
    for (const std::size_t first : m_elements) {
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
        if (!m_envelope_arcs[first].empty())
          m_lone_circles.push_back({first, 0});
        continue;
      }
      cycle.front().begins_unresolved = cycle.front().begins_unresolved || is_unresolved_at_end;
      if (cycle.size() > 1 && !cycle.front().begins_unresolved &&
          goes_on(cycle.back().parts.back(), cycle.front().parts.front())) {
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
        m_halfedges_of[part.element][part.envelope_arc] = first + i;
      m_halfedges.push_back(std::move(cycle[i]));
    }
  }

  // The disks of one of two twins tell which one the other is, unless they are too near to an event; those of both do
  // not contradict each other. If the search was ended the other side may not be there: less is tried.
  void match_twins(Search_control& control)
  {
    // of the latter how many have it as their twin
    std::vector<std::size_t> twins(m_halfedges.size(), none), told(m_halfedges.size(), 0);
    for (std::size_t i = 0; i < m_halfedges.size(); ++i)
      if (!is_at_infinity(m_halfedges[i]) && !control.is_overdue() && (twins[i] = twin_of(m_halfedges[i])) != none)
        ++told[twins[i]];
    for (std::size_t i = 0; i < m_halfedges.size(); ++i)
      if (const std::size_t twin = twins[i];
          twin != none && told[twin] == 1 && (twins[twin] == i || (twins[twin] == none && told[i] == 0)))
        std::tie(m_halfedges[i].twin, m_halfedges[twin].twin) = std::pair(twin, i);
  }

  std::size_t twin_of(const Halfedge& h) const
  {
    // the other side of the pocket, which may be larger and have its disks told by bounds
    if (const Part& part = h.parts.front(); envelope_arc(part).corner) {
      const std::size_t other = envelope_arc(part).corner->is_end != element(part).is_reversed ? h.next : h.previous;
      return is_footpoint_with(footpoint(m_halfedges[other]), element(part)) &&
              is_footpoint_with(footpoint(h), element(m_halfedges[other]))
          ? other
          : none;
    }
    const bool is_searched = m_rest.why_not == Undecided_reason::NONE;
    for (const bool is_fine : is_searched ? std::vector<bool>{false, true} : std::vector<bool>{false})
      for (const Part& part : h.parts)
        for (const double share : {0.5, 0.40625, 0.59375, 0.25, 0.75, 0.125, 0.875}) {
          const Range& range = envelope_arc(part).range;
          const auto touched =
              m_disks.touched_element(part.element, envelope_arc(part), range.begin + share * range.width(), is_fine);
          if (const std::size_t twin = touched ? halfedge_at(*touched, element(part)) : none; twin != none)
            return twin;
        }
    for (const Part& part : h.parts)
      if (const std::size_t twin = twin_at_tip(part); twin != none)
        return twin;
    return none;
  }

  // Where a normal cone has its footpoint on an arc that begins or ends there, on the side that comes next: without the
  // disk, which is too near to the vertex to tell. (Elsewhere the arc may come back, so that it is the other side.)
  std::size_t twin_at_tip(const Part& part) const
  {
    const Disk_footpoint& footpoint = envelope_arc(part).footpoint;
    if (!element(part).is_normal_cone || footpoint.kind != Disk_footpoint::Kind::ARC)
      return none;
    Range range = envelope_arc(part).boxes.front().second.range;
    for (const auto& [part_of_element, located] : envelope_arc(part).boxes)
      range = united(range, located.range);
    for (const std::size_t side : {2 * footpoint.index, 2 * footpoint.index + 1})
      if (element(part).next == side || m_graph.elements()[side].next == part.element)
        return halfedge_at({side, range}, element(part));
    return none;
  }

  // The halfedge of the only envelope arc with a footpoint on an element that may hold a parameter. Events are
  // somewhere between the ranges of their envelope arcs.
  std::size_t halfedge_at(const Touched_element& touched, const Oriented_element<>& other) const
  {
    const std::vector<Envelope_arc>& envelope_arcs = m_envelope_arcs[touched.element];
    std::size_t result = none;
    for (std::size_t s = 0; s < envelope_arcs.size(); ++s) {
      const Range around{s > 0 ? envelope_arcs[s - 1].range.end : 0,
                         s + 1 < envelope_arcs.size() ? envelope_arcs[s + 1].range.begin : 1};
      if (!around.meets(touched.range))
        continue;
      const auto& [range, events] = std::tie(envelope_arcs[s].range, envelope_arcs[s].events);
      if ((events[0] == Disk_event::UNRESOLVED && touched.range.begin < range.begin) ||
          (events[1] == Disk_event::UNRESOLVED && touched.range.end > range.end))
        return none;
      if (is_footpoint_with(envelope_arcs[s].footpoint, other)) {
        if (result != none)
          return none;
        result = s;
      }
    }
    return result == none ? none : m_halfedges_of[touched.element][result];
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

  // The outgoing halfedge of a vertex with which visiting begins: at infinity the one before which there is nothing,
  // elsewhere any.
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

// The diagram of a graph of curves, on all elements, or on those of some cycles. With a tag for parallel work, elements
// are handed to all cores.
template <class Concurrency_tag>
Disk_diagram disk_diagram(const Site_graph_2<>& graph, std::vector<std::size_t> elements, const std::string& operation,
                          Search_control& control)
{
  check_magnitude(graph, operation);
  const Site_tree_2 tree(graph);
  const Cusps_2 cusps = Cusp_finder_2(graph, tree, &control)();
  const auto fine_level = std::make_shared<const Fine_level>(graph);
  std::vector<std::vector<Envelope_arc>> envelope_arcs(graph.elements().size());
  Rest_of_search rest(graph.elements().size());
  for_each_element<Concurrency_tag>(elements, control, [&](std::size_t element) {
    Maximal_disks<> disks(graph, tree, cusps, control.has_fine_level() ? fine_level.get() : nullptr, &control);
    envelope_arcs[element] = disks(element);
    rest.begins[element] = disks.begin_of_rest();
  });
  rest.why_not = control.reason();
  return Disk_diagram(graph, fine_level, std::move(elements), std::move(envelope_arcs), std::move(rest), control);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DISK_DIAGRAM_H
