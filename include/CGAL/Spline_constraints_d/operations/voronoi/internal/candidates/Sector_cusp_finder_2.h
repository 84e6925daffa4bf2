// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SECTOR_CUSP_FINDER_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SECTOR_CUSP_FINDER_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_finder_2.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Settles the ends of arcs X in vertices p from which just one other arc Y leaves in the same direction, where distances
from some sites are divided by c > 1.

In X(u) the disk has a radius of r u^m at most, and scaled it is in the circle around X(u) with 1 + c times that. Of all
arcs but X and Y next to p, and of p itself, X(u) is as far away as a multiple of u tells, as they are on the other side
of a line through p; and of the rest, as boxes tell. So disks touch nothing but X and Y. If Y is scaled, and both turn
by less than a right angle, and have less curvature than all of these disks, scaled for Y, each disk is touched by Y in
one point when it is scaled, on both sides of X. If Y is not scaled, no disk touches scaled sites.
*/
class Sector_cusp_finder_2
{
  static constexpr double least_width = 0x1p-16, given_up_width = 0x1p-6;   // of an element
  static constexpr int most_halvings = 10;                                  // of arcs, to see that they are far away

  // Disks that touch a part of the element of an arc next to its end, and the distance from the element within which
  // they touch anything when they are scaled.
  struct Disks
  {
    Arc_end own, other;
    double width;
    Interval reach;
    Interval_pair points;   // of the element
  };

  const Site_graph_2<>& m_graph;
  Disk_curvature<> m_curvature;   // with scaled sites
  Interval m_factor;            // c
  Search_control* m_control;      // none: nothing ends the search

public:
  Sector_cusp_finder_2(const Site_graph_2<>& graph, const Disk_curvature<>& curvature,
                       Search_control* control = nullptr)
    : m_graph(graph), m_curvature(curvature), m_factor(factor(*curvature.scaled_sites())), m_control(control)
  {}

  Cusps_2 operator()(const std::vector<std::size_t>& elements) const
  {
    const Upward_rounding_guard guard;
    Cusps_2 result(m_graph, m_curvature.scaled_sites());
    if (!result.has_cusps())
      return result;
    Regular_check check(m_control, 1);
    for (const std::size_t f : elements)
      if (const Oriented_element<>& element = m_graph.elements()[f]; !element.is_normal_cone)
        for (const bool is_end : {false, true}) {
          const Arc_end own{element.object, is_end};
          if (const std::vector<Arc_end> others = others_beside(element, own); !others.empty()) {
            check();
            result.set_side(f, is_end,
                            others.size() == 1 ? side(f, own, others[0])
                                               : Cusp_side{range_at(own, given_up_width), std::nullopt, std::nullopt});
          }
        }
    add_scaled_sides(result);
    return result;
  }

private:
  // Without a factor, disks in a cusp between scaled arcs touch these and no other element. A scaled disk that touches
  // one of them on that side is a part of its disk there: it would have the element inside.
  void add_scaled_sides(Cusps_2& result) const
  {
    const Site_tree_2 tree(m_graph);
    const Cusp_finder_2 finder(m_graph, tree, m_control);
    for (std::size_t f = 0; f < m_graph.elements().size(); ++f)
      for (const bool is_end : {false, true})
        if (const Oriented_element<>& element = m_graph.elements()[f];
            !element.is_normal_cone && m_curvature.is_arc_scaled(element.object))
          if (const auto other = m_graph.across_cusp(element, {element.object, is_end});
              other && m_curvature.is_arc_scaled(other->arc))
            result.set_side(f, is_end, finder.side(f, {element.object, is_end}));
  }

  static Interval factor(const Scaled_sites<>& sites)
  {
    const Upward_rounding_guard guard;
    return CGAL::sqrt(interval_of(sites.squared_factor));
  }

  // Those that leave in the same direction, but not an arc behind, if it is the only one and not scaled.
  std::vector<Arc_end> others_beside(const Oriented_element<>& element, const Arc_end& own) const
  {
    std::vector<Arc_end> result;
    for (const Arc_end& end : m_graph.vertices()[m_graph.vertex_of(own)].ends)
      if (end != own && are_same_directions(m_graph.direction(own), m_graph.direction(end)))
        result.push_back(end);
    if (result.size() == 1 && !m_curvature.is_arc_scaled(result[0].arc) &&
        m_graph.across_cusp(element, own) != result[0])
      result.clear();
    return result;
  }

  Cusp_side side(std::size_t element, const Arc_end& own, const Arc_end& other) const
  {
    for (double width = 0.5; width >= least_width; width /= 2)
      if (const auto footpoint = settled(element, own, other, width))
        return {range_at(own, width), footpoint, std::nullopt};
    return {range_at(own, given_up_width), std::nullopt, std::nullopt};
  }

  // The footpoint of all disks that touch the element nearer to the vertex than some width, if that is proved.
  std::optional<Located_footpoint> settled(std::size_t f, const Arc_end& own, const Arc_end& other, double width) const
  {
    const Oriented_element<>& element = m_graph.elements()[f];
    const bool is_scaled = m_curvature.is_arc_scaled(other.arc);
    const Element_part<> part = m_curvature.part(f, range_at(own, width));
    const Interval square = squared_norm(part.jet.normal),
                   normal = CGAL::sqrt(square.inf() > 0 ? square : Interval(0, square.sup()));
    const auto cusp = is_scaled ? Cusp_width::of_scaled(m_graph, own, other, (m_factor - Interval(1)) * normal, width)
                                : Cusp_width::of(m_graph, own, other, element.is_reversed == own.is_end, width);
    if (!cusp)
      return std::nullopt;
    const Corner_of_disks corner{own.parameter(), cusp->curvature, cusp->power};
    const double least = corner.least_curvature(own.is_end ? 1 - width : width);   // of all disks
    const Interval radius = Interval(normal.sup()) / Interval(least);
    const Interval_pair points =
        m_graph.vertices()[m_graph.vertex_of(own)].point + m_graph.arcs()[own.arc].way_from_end(own.is_end, part.range);
    if (!touch_nothing_else({own, other, width, (Interval(1) + m_factor) * radius, points}))
      return std::nullopt;
    if (!is_scaled)
      return Located_footpoint{};
    const Range range = range_beside(own, other, width);
    const auto is_flat = [&](std::size_t element_of_other) {
      return is_bent_less(m_graph, m_curvature.part(element_of_other, range), other.arc,
                          (Interval(1) / (m_factor * radius)).inf());
    };
    // the order of arcs may not be known
    if (!is_bent_less(m_graph, m_curvature.part(f, range_beside(own, own, width)), own.arc,
                      (Interval(1) / radius).inf()) ||
        !is_flat(2 * other.arc) || !is_flat(2 * other.arc + 1))
      return std::nullopt;
    return Located_footpoint{{Disk_footpoint::Kind::ARC, other.arc, 0}, range, least, corner};
  }

  // About twice the width next to an end of an arc in the cusp: the rest of the arc is farther away than the disks.
  Range range_beside(const Arc_end& own, const Arc_end& end, double width) const
  {
    const auto squared_speed = [&](const Arc_end& e) {
      return CGAL::to_double(squared_norm(m_graph.arcs()[e.arc].direction_over({e.parameter(), e.parameter()})));
    };
    return range_at(end, (std::min)(1.0, 2 * width * std::sqrt(squared_speed(own) / squared_speed(end))));
  }

  // Disks cannot touch anything but scaled sites if the arcs of the cusp are not scaled.
  bool touch_nothing_else(const Disks& disks) const
  {
    const bool is_scaled = m_curvature.is_arc_scaled(disks.other.arc);
    const std::size_t vertex = m_graph.vertex_of(disks.own);
    for (std::size_t v = 0; v < m_graph.vertices().size(); ++v)
      if ((is_scaled || m_curvature.is_vertex_scaled(v)) &&
          !(v == vertex ? go_away(disks, direction(disks.own)) : is_outside(disks, m_graph.vertices()[v].point)))
        return false;
    for (std::size_t arc = 0; arc < m_graph.arcs().size(); ++arc)
      if ((is_scaled || m_curvature.is_arc_scaled(arc)) && !is_apart(disks, arc))
        return false;
    return true;
  }

  // Whether an arc that does not belong to the cusp, or what is left of one that does, is not touched.
  bool is_apart(const Disks& disks, std::size_t arc) const
  {
    Range rest;
    for (const bool is_end : {false, true})
      if (const Arc_end end{arc, is_end}; m_graph.vertex_of(end) == m_graph.vertex_of(disks.own)) {
        const std::optional<Range> known = end == disks.own || end == disks.other
            ? std::optional(range_beside(disks.own, end, disks.width))
            : range_behind_line(disks, end);
        if (!known)
          return false;
        (is_end ? rest.end : rest.begin) = is_end ? known->begin : known->end;
      }
    return rest.begin >= rest.end || is_outside(disks, arc, rest, most_halvings);
  }

  bool is_outside(const Disks& disks, const Interval_pair& points) const
  {
    return (squared_norm(points - disks.points) - CGAL::square(disks.reach)).inf() > 0;
  }

  bool is_outside(const Disks& disks, std::size_t arc, const Range& range, int halvings) const
  {
    return is_outside(disks, m_graph.arcs()[arc].point(range)) ||
        (halvings > 0 && is_outside(disks, arc, {range.begin, range.middle()}, halvings - 1) &&
         is_outside(disks, arc, {range.middle(), range.end}, halvings - 1));
  }

  // Where an arc is on the other side of a line through the vertex, from which disks go away.
  std::optional<Range> range_behind_line(const Disks& disks, const Arc_end& end) const
  {
    const Interval_pair normal = direction(disks.own) - direction(end);
    if (go_away(disks, normal))
      for (double width = 0.5; width >= least_width; width /= 2)
        if (dot(outward(end, m_graph.arcs()[end.arc].direction_over(range_at(end, width))), normal).sup() < 0)
          return range_at(end, width);
    return std::nullopt;
  }

  // Whether in the direction of a normal each point of the element is farther from the vertex than its disk reaches.
  bool go_away(const Disks& disks, const Interval_pair& normal) const
  {
    const Interval_pair derivative =
        outward(disks.own, m_graph.arcs()[disks.own.arc].jet(range_at(disks.own, disks.width), 1)[1]);
    return (dot(derivative, normal) * Interval(disks.width) - disks.reach * CGAL::sqrt(squared_norm(normal))).inf() > 0;
  }

  static Interval_pair outward(const Arc_end& end, const Interval_pair& forward)
  {
    return end.is_end ? Interval_pair{-forward[0], -forward[1]} : forward;
  }

  // A unit vector, rounded.
  Interval_pair direction(const Arc_end& end) const
  {
    const Exact_pair& d = m_graph.direction(end);
    const double x = CGAL::to_double(d[0]), y = CGAL::to_double(d[1]), length = std::hypot(x, y);
    return {Interval(x / length), Interval(y / length)};
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_SECTOR_CUSP_FINDER_2_H
