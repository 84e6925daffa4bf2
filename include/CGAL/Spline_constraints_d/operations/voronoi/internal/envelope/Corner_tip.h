// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_TIP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_TIP_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_slope.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Two arcs that join nearly smoothly, seen from the side where their angle is more than 180 degrees, if the largest disks
at the vertex are those of the curvature of one of them: the diagram has a tip there. From far away it is that of a
smooth joint where the curvature jumps, with disks that touch both arcs; very near to it they touch the vertex and the
arc with the larger curvature.
*/
template <Enclosing_number Interval = Common::Interval>
class Corner_tip
{
  const Site_graph_2<Interval>& m_graph;
  const Element_part<Interval>& m_part;
  const Oriented_element<Interval>& m_element;

public:
  Corner_tip(const Site_graph_2<Interval>& graph, const Element_part<Interval>& part)
    : m_graph(graph), m_part(part), m_element(graph.elements()[part.element])
  {}

  /*
  The arc with the larger curvature, seen from the vertex or the other arc, if there is no other candidate, and no disk
  touches it twice: so the disks leave no part of it out.
  */
  std::optional<Located_footpoint> only_footpoint(const std::vector<Disk_candidate<Interval>>& candidates) const
  {
    for (const Arc_end& other : other_ends()) {
      Range range{other.parameter(), other.parameter()};
      for (const Disk_candidate<Interval>& candidate : candidates)
        if (candidate.kind == Disk_candidate<Interval>::Kind::ARC && candidate.index == other.arc)
          range = united(range, candidate.range);
        else
          range = Range();
      if (is_part(range) && m_graph.arcs()[other.arc].is_spiral(range))
        return Located_footpoint{{Disk_footpoint::Kind::ARC, other.arc}, range};
    }
    return std::nullopt;
  }

  // The vertex, and behind it on the element the other arc.
  struct Footpoints
  {
    Arc_end own, other;
    Located_footpoint vertex, arc;
  };

  /*
  The arc with the larger curvature. A disk that touches it and the vertex leaves nothing between but the arc, on which
  curvatures grow up to the vertex. So all disks between touch the vertex, too, as that in the vertex does.
  */
  std::optional<Footpoints> vertex_and_arc(const std::vector<Disk_candidate<Interval>>& candidates) const
  {
    if (m_element.is_normal_cone)
      return std::nullopt;
    for (const Arc_end& other : other_ends()) {
      const Arc_end own = m_graph.nearly_smooth_continuation(other)->end;
      const std::size_t vertex = m_graph.vertex_of(own);
      Range range{other.parameter(), other.parameter()}, own_range{own.parameter(), own.parameter()};
      const int way = own.is_end ? 1 : -1;
      // without those of the own arc on which the curvature grows up to the vertex
      std::vector<Disk_candidate<Interval>> left(candidates);
      take_connected(left, own_range, [&](const Disk_candidate<Interval>& c) {
        return c.index == own.arc && certain_sign(c.bounds.dv) == way;
      });
      for (const Disk_candidate<Interval>& candidate : left)
        if (candidate.kind == Disk_candidate<Interval>::Kind::ARC && candidate.index == other.arc)
          range = united(range, candidate.range);
        else if (candidate.kind != Disk_candidate<Interval>::Kind::VERTEX || candidate.index != vertex)
          range = Range();
      if (is_part(range) && m_graph.arcs()[other.arc].is_spiral(range))
        return Footpoints{
            own, other, {{Disk_footpoint::Kind::VERTEX, vertex}}, {{Disk_footpoint::Kind::ARC, other.arc}, range}};
    }
    return std::nullopt;
  }

  // Whether the disk that touches the element in a point touches the vertex (1) or the arc (-1); 0 if that is not
  // certain.
  int sign(const Disk_curvature<Interval>& curvature, Disk_slopes& slopes, const Footpoints& footpoints, double u,
           double least) const
  {
    if (u == footpoints.own.parameter()) {
      const Element_part<Interval> point = curvature.part(m_part.element, {u, u});
      const Interval arc = curvature(point, footpoints.other.arc, footpoints.arc.range,
                                     m_graph.arcs()[footpoints.other.arc].jet(footpoints.arc.range))
                               .value;
      return arc.sup() < curvature(point, footpoints.vertex.footpoint.index).value.inf() ? 1 : 0;
    }
    const auto distances = [](const Range& range, const Arc_end& end) {
      return end.is_end ? Range{1 - range.end, 1 - range.begin} : range;
    };
    switch (slopes(footpoints.own.is_end, footpoints.other)
                .slopes(distances({u, u}, footpoints.own), distances(footpoints.arc.range, footpoints.other), least)
                .pattern) {
    case Sign_pattern::NEGATIVE: return 1;
    case Sign_pattern::FALLING:
    case Sign_pattern::POSITIVE: return -1;
    default: return 0;
    }
  }

private:
  static bool is_part(const Range& range) { return range.width() > 0 && range.width() < 1; }

  // The ends of arcs next to the element in a vertex that the part reaches.
  std::vector<Arc_end> other_ends() const
  {
    std::vector<Arc_end> result;
    if (m_element.is_normal_cone) {
      for (const Arc_end& end : m_graph.vertices()[m_element.object].ends)
        if (m_graph.nearly_smooth_continuation(end))
          result.push_back(end);
      return result;
    }
    for (const bool end : {false, true})
      if (const auto& next = m_graph.nearly_smooth_continuation({m_element.object, end}); next &&
          (end ? m_part.range.end == 1 : m_part.range.begin == 0) &&
          !m_graph.is_pocket(m_element, {m_element.object, end}))
        result.push_back(next->end);
    return result;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_TIP_H
