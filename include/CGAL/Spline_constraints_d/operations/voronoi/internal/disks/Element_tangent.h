// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_ELEMENT_TANGENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_ELEMENT_TANGENT_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Curves and segments on their tangents, as where drawings are aligned. The line that touches an element in the simplest
parameter of a part is in front of it elsewhere, if the element is concave.

With a direction T of the line and the normal M to the side of the disks, a point of the line is X + a T + b M, where b
>= 0 is convex, and the disk through it has k = 2 (a <N,T> + b <N,M>) / (a^2 + b^2). Let a > 0. If <N,T> >= 0, that
falls with a where a >= b. Else k <= 0 where a >= w |<X',T>|, for the width w of the part: as b is convex, b <= w |b'|,
and
<N,T> / <N,M> = b' / <X',T>. So a segment on the line has no larger disks than in its near end, or half-planes.
*/
template <Enclosing_number Interval>
class Element_tangent
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;
  const Element_part<Interval>& m_part;

public:
  Element_tangent(const Site_graph_2<Interval>& graph, const Element_part<Interval>& part)
    : m_graph(graph), m_part(part)
  {}

  // Leaves out arcs that are behind a straight element and touch its line in a rational point: all disks through them
  // are half-planes or larger.
  void erase_behind(std::vector<Disk_candidate<Interval>>& candidates) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[m_part.element];
    if (element.is_normal_cone || !m_graph.arcs()[element.object].is_straight() ||
        !m_graph.are_ends_exact(element.object))
      return;
    std::map<std::size_t, Range> ranges;   // of arcs
    for (const Disk_candidate<Interval>& c : candidates)
      if (c.kind == Candidate_kind::ARC && m_graph.are_ends_exact(c.index))
        if (const auto [place, is_new] = ranges.try_emplace(c.index, c.range); !is_new)
          place->second = united(place->second, c.range);
    std::erase_if(ranges, [&](const auto& arc) { return !is_behind(arc.first, arc.second, element); });
    std::erase_if(candidates, [&](const Disk_candidate<Interval>& c) {
      return c.kind == Candidate_kind::ARC && ranges.count(c.index);
    });
  }

  // Leaves out the candidates on segments of the line; a near end that no other arc has becomes one itself.
  void replace_segments(std::vector<Disk_candidate<Interval>>& candidates) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[m_part.element];
    if (element.is_normal_cone || !m_graph.are_ends_exact(element.object) ||
        std::none_of(candidates.begin(), candidates.end(),
                     [&](const Disk_candidate<Interval>& c) { return is_segment(c); }))
      return;
    const Exact_rational u =
        simplest_rational_between(Exact_rational(m_part.range.begin), Exact_rational(m_part.range.end));
    const Exact_pair point = m_graph.exact_point_at(element, u), normal = m_graph.exact_normal(element, u);
    std::map<std::size_t, std::optional<Arc_end>> near_ends;   // of segments of the line
    for (const Disk_candidate<Interval>& c : candidates)
      if (is_segment(c) && !near_ends.count(c.index))
        near_ends[c.index] = near_end(c.index, point, normal);
    std::erase_if(near_ends, [](const auto& segment) { return !segment.second; });
    if (near_ends.empty() || !is_in_front(normal))
      return;
    std::erase_if(candidates,
                  [&](const Disk_candidate<Interval>& c) { return is_segment(c) && near_ends.count(c.index); });
    for (const auto& [segment, end] : near_ends)
      if (const std::size_t vertex = m_graph.vertex_of(*end); m_graph.vertices()[vertex].ends.size() == 1)
        candidates.push_back({Candidate_kind::VERTEX, vertex});
  }

private:
  bool is_segment(const Disk_candidate<Interval>& c) const
  {
    return c.kind == Candidate_kind::ARC && m_graph.arcs()[c.index].is_straight() &&
        !m_graph.arcs()[c.index].turns_back() && m_graph.are_ends_exact(c.index);
  }

  // Whether the tangent with a normal is in front of the part, which is concave.
  bool is_in_front(const Exact_pair& normal) const
  {
    const Interval_pair m = interval_pair_of<Interval>(normal);
    return dot(m_part.jet.normal, m).inf() > 0 &&
        dot(m_graph.arcs()[m_graph.elements()[m_part.element].object].jet(m_part.range, 2)[2], m).sup() < 0;
  }

  // Whether a part of an arc is concave, and has the line of a straight element as its tangent where the parameter is
  // the simplest number.
  bool is_behind(std::size_t index, const Range& range, const Oriented_element<Interval>& element) const
  {
    const Site_arc_2<Interval>& arc = m_graph.arcs()[index];
    const Exact_pair normal = m_graph.exact_normal(element, 0);
    if (!(dot(arc.jet(range, 2)[2], interval_pair_of<Interval>(normal)).sup() < 0))
      return false;
    const Exact_rational v = simplest_rational_between(Exact_rational(range.begin), Exact_rational(range.end));
    return sign_of(exact_dot(normal, arc.derivative_at(v))) == 0 &&
        sign_of(exact_dot(normal, exact_difference(arc.at(v), m_graph.exact_point_at(element, 0)))) == 0;
  }

  // That of a segment on the line that is far enough away.
  std::optional<Arc_end> near_end(std::size_t segment, const Exact_pair& point, const Exact_pair& normal) const
  {
    const Interval_pair m = interval_pair_of<Interval>(normal), t = turned_left(m);
    const auto exceeds = [](const Interval& a, const Interval& x) { return (a - x).inf() > 0 && (a + x).inf() > 0; };
    std::array<Interval, 2> distances;
    std::array<int, 2> sides;
    for (const bool is_end : {false, true}) {
      const Exact_pair end = m_graph.arcs()[segment].at(is_end);
      if (sign_of(exact_dot(normal, exact_difference(end, point))) != 0)
        return std::nullopt;
      const Interval_pair way = interval_pair_of<Interval>(end) - m_part.jet.point;
      sides[is_end] = certain_sign(dot(t, way));
      const Interval& a = distances[is_end] = Interval(sides[is_end]) * dot(t, way);
      if (!exceeds(a, dot(m, way)) || !exceeds(a, Interval(m_part.range.width()) * dot(t, m_part.jet.point_derivative)))
        return std::nullopt;
    }
    const int order = certain_sign(distances[1] - distances[0]);
    return sides[0] * sides[1] > 0 && order != 0 ? std::optional(Arc_end{segment, order < 0}) : std::nullopt;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_ELEMENT_TANGENT_H
