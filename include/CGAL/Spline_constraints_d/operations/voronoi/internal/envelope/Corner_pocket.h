// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_POCKET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_POCKET_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Two arcs that join nearly smoothly, seen from the side where their angle is less than 180 degrees. From far away there
is nothing but a smooth joint; but disks in the corner touch both arcs, at distances from it that are smaller than any
interval can tell apart.

Let the disk that touches the element in X touch the other arc in Y, and let both be near the corner. It cuts a pocket
off, bounded by X, the corner, Y and the chord XY. The chords of disks that are empty do not cross. So a disk that
touches the element between X and the corner touches something else in the pocket, and if nothing else is there, the
other arc. Hence such points X form a range of the element that begins in the corner, and for this no disk has to be
looked at.
*/
template <Enclosing_number Interval = Common::Interval>
class Corner_pocket
{
  using Interval_pair = std::array<Interval, 2>;

  static constexpr int most_halvings = 12, most_shrinkings = 60;

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  Arc_end m_own, m_other;
  double m_scale;   // of the parameter of the other arc
  Range m_range;    // of that, with all that disks may touch there

public:
  // The pocket at an end of a part of an element, if there is one.
  static std::optional<Corner_pocket<Interval>> at_end_of(const Element_part<Interval>& part,
                                                          const Site_graph_2<Interval>& graph,
                                                          const Disk_curvature<Interval>& curvature)
  {
    const Oriented_element<Interval>& element = graph.elements()[part.element];
    for (const bool end : {false, true}) {
      if (element.is_normal_cone || (end ? part.range.end < 1 : part.range.begin > 0))
        continue;
      if (const Arc_end own{element.object, end}; graph.is_pocket(element, own))
        return Corner_pocket<Interval>(graph, curvature, part, own, *graph.nearly_smooth_continuation(own));
    }
    return std::nullopt;
  }

  // Takes the candidates that belong to the pocket: those of the other arc, or the ones that are connected with the
  // corner; and those of the arc itself on which the curvature grows up to the corner, where it goes on growing on the
  // other arc. Returns whether the other arc has any.
  bool take(std::vector<Disk_candidate<Interval>>& candidates)
  {
    Range own{m_own.parameter(), m_own.parameter()};
    const int way = m_own.is_end ? 1 : -1;
    take_connected(candidates, own, [&](const Disk_candidate<Interval>& c) {
      return c.index == m_own.arc && certain_sign(c.bounds.dv) == way;
    });
    const auto is_of_other = [&](const Disk_candidate<Interval>& c) {
      return c.kind == Disk_candidate<Interval>::Kind::ARC && c.index == m_other.arc;
    };
    Range all = m_range;
    for (const Disk_candidate<Interval>& candidate : candidates)
      if (is_of_other(candidate))
        all = united(all, candidate.range);
    if (!m_graph.arcs()[m_other.arc].is_spiral(all))
      return take_connected(candidates, m_range, is_of_other);
    m_range = all;
    return std::erase_if(candidates, is_of_other) > 0;
  }

  // The end of the element that is in the corner.
  bool end() const { return m_own.is_end; }

  // Where disks touch the other arc. There may be several maxima of their curvature.
  Located_footpoint footpoint() const { return footpoint(m_range); }

  // The same for the disks of a range of the element that are not larger than those of some curvature.
  Located_footpoint footpoint(const Range& range, double least) const
  {
    const Element_part<Interval> part = m_curvature.part(m_part.element, range);
    Range result = m_range;
    for (int i = 0; i < most_shrinkings; ++i) {
      const double middle = result.middle();
      const Range far = m_other.is_end ? Range{result.begin, middle} : Range{middle, result.end};
      if (!is_below(part, far, least, most_halvings / 2))
        break;
      (m_other.is_end ? result.begin : result.end) = middle;
    }
    return footpoint(result);
  }

  // Whether disks in the pocket leave no part of the other arc out: none touches it twice.
  bool has_one_envelope_arc() const { return m_graph.arcs()[m_other.arc].is_spiral(m_range); }

  // Whether disks may touch the far end of the other arc, as those do that are too far from the corner: if a footpoint
  // with the arc may be there, and their curvature is not known to decrease toward it.
  bool may_touch_far_end(const Located_footpoint& located) const
  {
    const double far = 1 - m_other.parameter();
    const int way = m_other.is_end ? -1 : 1;   // of the parameter, to the far end
    return located.range.meets({far, far}) &&
        certain_sign(m_curvature(m_part, m_other.arc, {far, far}, m_graph.arcs()[m_other.arc].jet({far, far})).dv) !=
        -way;
  }

  // Whether points are outside of all that may be in the pocket of a disk.
  bool is_outside(const Interval_pair& points) const
  {
    const Interval_pair pocket = hull(m_part.jet.point, m_graph.arcs()[m_other.arc].point(m_range));
    return certain_sign(points[0] - pocket[0]) != 0 || certain_sign(points[1] - pocket[1]) != 0;
  }

  // Whether the radii of the disks in the pocket grow with the distance from the corner: their footpoints are never
  // opposite.
  bool has_growing_disks() const
  {
    const Curve_jet<Interval> y = m_graph.arcs()[m_other.arc].jet(m_range, 1);
    const Interval way(m_other.is_end != m_own.is_end ? 1 : -1),
        side(m_graph.elements()[m_part.element].is_reversed ? -1 : 1);
    return dot(m_part.jet.normal, (way * side) * turned_left(y[1])).inf() > 0;
  }

  // Whether the largest disk that touches the element in a point touches the other arc (1) rather than one of some
  // curvature (-1); 0 if that is not certain.
  int sign(double u, const Interval& other_curvature) const
  {
    const Element_part<Interval> point = m_curvature.part(m_part.element, {u, u});
    const double distance = std::abs(u - m_own.parameter()) * m_scale, v = m_other.is_end ? 1 - distance : distance;
    if (m_range.begin < v && v < m_range.end && (at(point, {v, v}) - other_curvature).inf() > 0)
      return 1;
    return is_below(point, m_range, other_curvature.inf(), most_halvings) ? -1 : 0;
  }

private:
  Corner_pocket(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                const Element_part<Interval>& part, const Arc_end& own,
                const Nearly_smooth_continuation<Interval>& next)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_own(own), m_other(next.end),
      m_scale(next.scale), m_range{next.end.parameter(), next.end.parameter()}
  {}

  Located_footpoint footpoint(const Range& range) const { return {{Disk_footpoint::Kind::ARC, m_other.arc}, range}; }

  Interval at(const Element_part<Interval>& point, const Range& range) const
  {
    return m_curvature(point, m_other.arc, range, m_graph.arcs()[m_other.arc].jet(range)).value;
  }

  bool is_below(const Element_part<Interval>& point, const Range& range, double curvature, int halvings) const
  {
    if (at(point, range).sup() < curvature)
      return true;
    return halvings > 0 && is_below(point, {range.begin, range.middle()}, curvature, halvings - 1) &&
        is_below(point, {range.middle(), range.end}, curvature, halvings - 1);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CORNER_POCKET_H
