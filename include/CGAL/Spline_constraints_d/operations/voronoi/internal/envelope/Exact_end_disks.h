// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_EXACT_END_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_EXACT_END_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/exact_disk_curvatures.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Reflection_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/touches_line.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Arc_parameter.h>

#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Disks that touch an element in its begin or end, and what branches of footpoints touch there, by exact computation:
where curvatures are equal there, enclosures cannot tell.
*/
template <Enclosing_number Interval = Common::Interval>
class Exact_end_disks
{
  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  std::size_t m_index;   // of the element
  const Oriented_element<Interval>& m_element;

public:
  Exact_end_disks(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature, std::size_t element)
    : m_graph(graph), m_curvature(curvature), m_index(element), m_element(graph.elements()[element])
  {}

  // Whether the footpoint moves into the end of its arc at the begin or end of the element.
  bool is_move(const Disk_branch& branch, bool end) const
  {
    return branch.move->event == Disk_event::JOINT && !branch.move->joined_ends &&
        is_touched_at_end({branch.move->arc, branch.move->parameter == 1}, end);
  }

  // Whether two branches have the same curvature at the begin or end of the element, by exact computation. They do not
  // move, or there.
  bool are_equal(const Disk_branch& a, const Disk_branch& b, bool end) const
  {
    const auto x = exact_curvature_at_end(a, end), y = exact_curvature_at_end(b, end);
    return (x && y && *x == *y) || are_mirrored_at_end(a, b, end);
  }

private:
  Element_part<Interval> end_of_element(bool end) const
  {
    return m_curvature.part(m_index, end ? Range{1, 1} : Range{0, 0});
  }

  // Whether two branches are mirror images of each other in the normal at an end of the element, in which disks are so,
  // too.
  bool are_mirrored_at_end(const Disk_branch& a, const Disk_branch& b, bool end) const
  {
    if (a.move || b.move || a.footpoint.kind != Disk_footpoint::Kind::ARC ||
        is_scaled(m_curvature, a.footpoint) != is_scaled(m_curvature, b.footpoint) ||
        (!m_element.is_normal_cone && !m_graph.is_exact({m_element.object, end})))
      return false;
    const auto mirror = Reflection_2::in_line(m_graph.exact_point(m_element, end),
                                              m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0)));
    const Element_part<Interval> point = end_of_element(end);
    const auto image =
        mirrored(m_graph, mirror, {a.footpoint, largest_curvature(m_graph, m_curvature, point, a).range}, b.footpoint);
    return image && is_only_maximum(m_graph, m_curvature, point, *image, b);
  }

  // Whether the disk that touches the element in its begin or end touches an arc in an end of it, by exact computation:
  // k_v = 0.
  bool is_touched_at_end(const Arc_end& other, bool end) const
  {
    if (!m_graph.is_exact(other) || (!m_element.is_normal_cone && !m_graph.is_exact({m_element.object, end})))
      return false;
    return is_touched(other.arc, m_graph.arcs()[other.arc].at(Exact_rational(other.parameter())),
                      m_graph.direction(other), end);
  }

  // The same for a point of an arc and its tangent there.
  bool is_touched(std::size_t arc, const Exact_pair& q, const Exact_pair& tangent, bool end) const
  {
    const Exact_pair normal = m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0)),
                     d = exact_difference(q, m_graph.exact_point(m_element, end));
    const Exact_rational nt = exact_dot(normal, tangent), dt = exact_dot(d, tangent), dd = exact_dot(d, d);
    if (m_curvature.is_arc_scaled(arc) && sign_of(dt) != 0)   // k = nt / dt is the positive zero
      return sign_of(nt) == sign_of(dt) &&
          nt * nt * dd ==
          (2 * exact_dot(normal, d) * nt +
           (m_curvature.scaled_sites()->squared_factor - 1) * exact_dot(normal, normal) * dt) *
              dt;
    if (m_curvature.is_arc_scaled(arc) || sign_of(dd) == 0)
      return sign_of(nt) == 0 && sign_of(dt) == 0;
    return nt * dd == 2 * exact_dot(normal, d) * dt;
  }

  // Of the disk that touches an arc where a branch has its maximum, if the parameter there is the simplest number.
  std::optional<Number_with_root> exact_curvature_in_arc(const Disk_branch& branch, bool end) const
  {
    const auto v = branch.move || branch.footpoint.kind != Disk_footpoint::Kind::ARC
        ? std::nullopt
        : Arc_parameter(m_graph, branch.footpoint.index).simplest_of_piece_within(branch.range);
    if (!v || (!m_element.is_normal_cone && !m_graph.is_exact({m_element.object, end})))
      return std::nullopt;
    const Site_arc_2<Interval>& arc = m_graph.arcs()[branch.footpoint.index];
    const Exact_pair q = arc.at(*v), &p = m_graph.exact_point(m_element, end);
    if (p == q || !is_touched(branch.footpoint.index, q, arc.derivative_at(*v), end) ||
        !is_only_maximum(m_graph, m_curvature, end_of_element(end), {branch.footpoint, branch.range}, branch))
      return std::nullopt;
    return curvature_of_disk_through(q, p, m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0)),
                                     squared_factor(m_curvature, branch.footpoint));
  }

  // The end of an arc that a branch touches there. It has one maximum, which is there if it is one.
  std::optional<Arc_end> touched_end(const Disk_branch& branch, bool end) const
  {
    if (branch.move)
      return is_move(branch, end) ? std::optional(Arc_end{branch.move->arc, branch.move->parameter == 1})
                                  : std::nullopt;
    for (const bool is_end : {false, true})
      if (const Arc_end other{branch.footpoint.index, is_end}; branch.footpoint.kind == Disk_footpoint::Kind::ARC &&
          (is_end ? branch.range.end == 1 : branch.range.begin == 0) && is_touched_at_end(other, end) &&
          m_curvature(end_of_element(end), other).dvv.sup() < 0)
        return other;
    return std::nullopt;
  }

  // Whether the half-plane of an end of the element touches an arc, in the point where a branch has its maximum.
  bool is_half_plane_at_end(const Disk_branch& branch, bool end) const
  {
    if (branch.move || branch.footpoint.kind != Disk_footpoint::Kind::ARC || m_curvature.scaled_sites() != nullptr ||
        (!m_element.is_normal_cone && !m_graph.is_exact({m_element.object, end})))
      return false;
    const Exact_pair normal = m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0));
    return is_only_maximum(m_graph, m_curvature, end_of_element(end), {branch.footpoint, branch.range}, branch) &&
        touches_line(m_graph, branch.footpoint.index, branch.range, m_graph.exact_point(m_element, end),
                     {Exact_rational(-normal[1]), normal[0]});
  }

  std::optional<Number_with_root> exact_curvature_at_end(const Disk_branch& branch, bool end) const
  {
    if (is_half_plane_at_end(branch, end))
      return Number_with_root{};
    if (const auto inside = exact_curvature_in_arc(branch, end))
      return inside;
    const auto touched = touched_end(branch, end);
    const bool is_elsewhere = touched &&
        m_graph.arcs()[touched->arc].at(Exact_rational(touched->parameter())) != m_graph.exact_point(m_element, end);
    return exact_curvature_at_end(
        is_elsewhere ? Disk_footpoint{Disk_footpoint::Kind::VERTEX, m_graph.vertex_of(*touched)} : branch.footpoint,
        end,
        squared_factor(m_curvature,
                       touched ? Disk_footpoint{Disk_footpoint::Kind::ARC, touched->arc} : branch.footpoint));
  }

  // Of the disk that touches a footpoint and the end of the element, where it is known exactly: footpoints are points,
  // or in the inside of segments and circular arcs. Disks through that end itself have the curvature of the arc there.
  std::optional<Number_with_root> exact_curvature_at_end(const Disk_footpoint& footpoint, bool end,
                                                         const Exact_rational& factor) const
  {
    if (footpoint.kind == Disk_footpoint::Kind::NOTHING)
      return Number_with_root{};
    if (!m_element.is_normal_cone && !m_graph.is_exact({m_element.object, end}))
      return std::nullopt;
    if (!m_element.is_normal_cone && factor == 1 &&
        footpoint == Disk_footpoint{Disk_footpoint::Kind::VERTEX, m_graph.vertex_of({m_element.object, end})}) {
      const Site_arc_2<Interval>& own = m_graph.arcs()[m_element.object];
      const Exact_rational k =
          own.has_singular_end() ? Exact_rational(0) : own.curvature_at(Exact_rational(end ? 1 : 0));
      return own.has_singular_end() ? std::nullopt
                                    : std::optional(Number_with_root{m_element.is_reversed ? Exact_rational(-k) : k});
    }
    const Exact_pair &p = m_graph.exact_point(m_element, end),
                     n = m_graph.exact_normal(m_element, Exact_rational(end ? 1 : 0));
    if (footpoint.kind == Disk_footpoint::Kind::VERTEX && m_graph.vertices()[footpoint.index].is_exact)
      return curvature_of_disk_through(m_graph.vertices()[footpoint.index].exact_point, p, n, factor);
    if (footpoint.kind != Disk_footpoint::Kind::ARC)
      return std::nullopt;
    const Site_arc_2<Interval>& arc = m_graph.arcs()[footpoint.index];
    if (arc.is_straight())
      return curvature_of_disk_on_line(arc.at(0), arc.at(1), p, n, factor);
    return arc.circle() && factor == 1 ? curvature_of_disk_on_circle(arc.circle()->first, arc.circle()->second, p, n)
                                       : std::nullopt;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_EXACT_END_DISKS_H
