// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_ENVELOPE_ARC_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_ENVELOPE_ARC_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Maximal_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Touched_element.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A disk that touches an element in a point: its center, its radius, and the parameter of its other footpoint. Infinite
// where it is a half-plane.
template <Enclosing_number Interval>
struct Envelope_arc_disk
{
  std::array<Interval, 2> center;
  Interval curvature;   // 1 / radius, in units of the length of the normal
  Range other_range;    // of an arc, with the parameter there
  double parameter;     // one of them
  Interval bounds;      // of the curvature of the largest disk, by proof
  bool is_point = false;   // of a corner, in which there is no disk
};

// The radius of a disk, by its curvature in units of the length of a normal.
template <Enclosing_number Interval>
Interval radius_of_disk(const std::array<Interval, 2>& normal, const Interval& curvature)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Interval length = CGAL::sqrt(squared_norm(normal));
  if (curvature.inf() > 0)
    return length / curvature;
  if (!(curvature.sup() > 0))
    return {infinity, infinity};
  return {std::isfinite(curvature.sup()) ? (length / Interval(curvature.sup())).inf() : 0, infinity};
}

// The disks along envelope arcs of maximal disks: in doubles, and where these do not tell the curvature, with numbers
// of higher precision.
class Envelope_arc_disks
{
  static constexpr double most_error = 1e-10;   // of curvatures in doubles, relative

  const Site_graph_2<>& m_graph;
  Disk_curvature<> m_curvature;
  const Fine_level& m_fine_level;

public:
  using Disk = Envelope_arc_disk<Interval>;

  Envelope_arc_disks(const Site_graph_2<>& graph, const Disk_curvature<>& curvature, const Fine_level& fine_level)
    : m_graph(graph), m_curvature(curvature), m_fine_level(fine_level)
  {}

  // The disk that touches the element of an envelope arc in a point, up to rounding: where no number tells the largest
  // curvature, it has the largest one that is known.
  Disk operator()(std::size_t element, const Envelope_arc& envelope_arc, double u) const
  {
    const Disk result = disk(m_graph, m_curvature, element, envelope_arc, u);
    if (envelope_arc.corner || is_accurate(result.curvature))
      return result;
    const auto fine = disk(m_fine_level.graph(), m_fine_level.curvature(), element, envelope_arc, u);
    const bool is_best_of_some = envelope_arc.footpoint.kind == Disk_footpoint::Kind::ARC &&
        !is_accurate(internal::Voronoi::in_doubles(fine.curvature));
    const Interval bounds = common_part(result.bounds, internal::Voronoi::in_doubles(fine.bounds));
    return bounded(in_doubles(is_best_of_some
                                  ? disk_through_point_of_arc(m_fine_level.graph(), m_fine_level.curvature(), element,
                                                              envelope_arc.footpoint.index, u, fine.parameter)
                                  : fine),
                   bounds);
  }

  // The same, also in corners, where curvatures are not finite; where arcs join smoothly, the disk has the greater one
  // of their curvatures.
  Disk estimated(std::size_t element, const Envelope_arc& envelope_arc, double u) const
  {
    if (const auto corner = disk_in_corner(element, envelope_arc, u))
      return *corner;
    const auto joint = envelope_arc.footpoint.kind == Disk_footpoint::Kind::ARC
        ? greatest_curvature_at_joint(m_curvature.part(element, {u, u}), envelope_arc.located(u))
        : std::nullopt;
    const Disk result = (*this)(element, envelope_arc, u);
    const auto estimate = [&](const Attained_curvature<>& k, const Interval& bounds) {
      return bounded(with_curvature(m_curvature.part(element, {u, u}), k), bounds);
    };
    if (joint && m_graph.elements()[element].is_normal_cone)
      return estimate(*joint, hull(result.bounds, joint->curvature));
    if (joint && !(result.curvature.inf() > joint->curvature.inf()))
      return estimate(*joint,
                      {(std::max)(result.bounds.inf(), joint->curvature.inf()),
                       (std::max)(result.bounds.sup(), joint->curvature.sup())});
    const bool is_only_bounded = result.curvature.inf() > 0 && !std::isfinite(result.curvature.sup());
    return is_only_bounded
        ? estimate({Interval(result.curvature.inf()), result.other_range, result.parameter}, result.bounds)
        : result;
  }

  // The element that the disk touches elsewhere, if that is certain, by doubles or numbers of higher precision.
  std::optional<Touched_element> touched_element(std::size_t element, const Envelope_arc& envelope_arc, double u,
                                                 bool is_fine) const
  {
    const auto touched_in = [&](const auto& graph, const auto& curvature) {
      const auto d = disk(graph, curvature, element, envelope_arc, u);
      return internal::Voronoi::touched_element(graph, envelope_arc.footpoint, d.other_range, d.center);
    };
    return is_fine ? touched_in(m_fine_level.graph(), m_fine_level.curvature()) : touched_in(m_graph, m_curvature);
  }

private:
  template <Enclosing_number Number>
  static Disk in_doubles(const Envelope_arc_disk<Number>& disk)
  {
    return {internal::Voronoi::in_doubles(disk.center), internal::Voronoi::in_doubles(disk.curvature), disk.other_range,
            disk.parameter, internal::Voronoi::in_doubles(disk.bounds)};
  }

  static Disk bounded(Disk disk, const Interval& bounds)
  {
    disk.bounds = bounds;
    return disk;
  }

  static bool is_accurate(const Interval& k)
  {
    return std::isfinite(k.sup()) && k.sup() - k.inf() <= most_error * k.sup();
  }

  template <Enclosing_number Number>
  static Envelope_arc_disk<Number> disk(const Site_graph_2<Number>& graph, const Disk_curvature<Number>& curvature,
                                        std::size_t element, const Envelope_arc& envelope_arc, double u)
  {
    const Element_part<Number> point = curvature.part(element, {u, u});
    return with_curvature(point,
                          envelope_arc.corner ? curvature_in_corner<Number>(envelope_arc, u)
                                              : largest_curvature(graph, curvature, point, envelope_arc.located(u)));
  }

  template <Enclosing_number Number>
  static Envelope_arc_disk<Number> disk_through_point_of_arc(const Site_graph_2<Number>& graph,
                                                             const Disk_curvature<Number>& curvature,
                                                             std::size_t element, std::size_t arc, double u, double v)
  {
    const Element_part<Number> point = curvature.part(element, {u, u});
    return with_curvature(
        point, Attained_curvature<Number>{curvature(point, arc, {v, v}, graph.arcs()[arc].jet({v, v})).value, {v, v}});
  }

  template <Enclosing_number Number>
  static Envelope_arc_disk<Number> with_curvature(const Element_part<Number>& point,
                                                  const Attained_curvature<Number>& k)
  {
    const auto &x = point.jet.point, &n = point.jet.normal;
    return {{x[0] + n[0] / k.curvature, x[1] + n[1] / k.curvature}, k.curvature, k.range, k.parameter, k.curvature};
  }

  // In the corner of a pocket there is no disk; the other end of the envelope arc has one. Between, nothing can be
  // told.
  template <Enclosing_number Number>
  static Attained_curvature<Number> curvature_in_corner(const Envelope_arc& envelope_arc, double u)
  {
    const double event = envelope_arc.corner->is_end ? envelope_arc.range.begin : envelope_arc.range.end;
    return {u == event ? Number(envelope_arc.corner->curvature) : any_number<Number>(),
            envelope_arc.boxes.front().second.range};
  }

  // Where an element ends in a vertex from which the arc of the footpoint leads into the half-plane of its normal, or
  // in a cusp, or where one of both has infinite curvature, there is only the point.
  std::optional<Disk> disk_in_corner(std::size_t f, const Envelope_arc& envelope_arc, double u) const
  {
    if ((u != 0 && u != 1) || envelope_arc.footpoint.kind != Disk_footpoint::Kind::ARC)
      return std::nullopt;
    const Oriented_element<>& element = m_graph.elements()[f];
    const bool is_normal_cone = element.is_normal_cone;
    const Arc_end own{element.object, u == 1};
    const Site_graph_2<>::Vertex& vertex = m_graph.vertices()[is_normal_cone ? element.object : m_graph.vertex_of(own)];
    const Interval_pair normal = m_graph.element_jet(element, {u, u}).normal;
    const std::optional<Arc_end> across = is_normal_cone ? std::nullopt : m_graph.across_cusp(element, own);
    for (const Arc_end& end : vertex.ends) {
      const double v = end.parameter();
      if (end.arc != envelope_arc.footpoint.index)
        continue;
      const int side = side_of_normal(element, u, end);
      const bool is_corner = !is_normal_cone && (end == across || side > 0),
                 is_round = side == 0 && envelope_arc.located(u).range.meets({v, v}) &&
          (is_bent_infinitely(normal, end) || (!is_normal_cone && is_bent_infinitely(normal, own)));
      if (is_corner || is_round)
        return Disk{vertex.point, any_number(), {v, v}, v, any_number(), true};
    }
    return std::nullopt;
  }

  // Whether an arc leaves the vertex in which an element begins or ends into the half-plane of its normal there (1), or
  // out of it (-1): exactly, where the ends are known so.
  int side_of_normal(const Oriented_element<>& element, double u, const Arc_end& end) const
  {
    if (m_graph.is_exact(end) && (element.is_normal_cone || m_graph.is_exact({element.object, u == 1})))
      return sign_of(exact_dot(m_graph.exact_normal(element, Exact_rational(u)), m_graph.direction(end)));
    return certain_sign(Interval(end.is_end ? -1 : 1) *
                        dot(m_graph.element_jet(element, {u, u}).normal,
                            m_graph.arcs()[end.arc].direction_over({end.parameter(), end.parameter()})));
  }

  // Whether an arc has infinite curvature in an end, toward the side of the normal.
  bool is_bent_infinitely(const Interval_pair& normal, const Arc_end& end) const
  {
    return !m_graph.is_regular(end) &&
        dot(normal, m_graph.arcs()[end.arc].tangent_jet({end.parameter(), end.parameter()})[1]).inf() > 0;
  }

  // Of the element and of another arc, in the point where they join; of an arc alone if the element is a small normal
  // cone between two, where the footpoint is next to the vertex.
  std::optional<Attained_curvature<>> greatest_curvature_at_joint(const Element_part<>& point,
                                                                  const Located_footpoint& located) const
  {
    const Oriented_element<>& element = m_graph.elements()[point.element];
    const std::size_t other = located.footpoint.index;
    const auto curvature = [&](const Arc_end& end) {
      const Curve_jet<> x = m_graph.arcs()[end.arc].jet({end.parameter(), end.parameter()}, 2);
      return dot(point.jet.normal, x[2]) / squared_norm(x[1]);
    };
    if (m_graph.is_in_nearly_smooth_joint(element))
      for (const Arc_end& end : m_graph.vertices()[element.object].ends)
        if (end.arc == other && located.range.meets({end.parameter(), end.parameter()}))
          return Attained_curvature<>{curvature(end), {end.parameter(), end.parameter()}};
    if (element.is_normal_cone || !point.range.is_number())
      return std::nullopt;
    const Arc_end own{element.object, point.range.begin == 1};
    if (point.range.begin != own.parameter() || m_graph.is_pocket(element, own))
      return std::nullopt;
    for (const Arc_end& next : m_graph.vertices()[m_graph.vertex_of(own)].ends)
      if (next.arc == other && m_graph.continuations(own).hold(next) &&
          located.range.meets({next.parameter(), next.parameter()})) {
        const Interval a = curvature(own), b = curvature(next);
        return Attained_curvature<>{a.inf() > b.inf() ? a : b, {next.parameter(), next.parameter()}};
      }
    return std::nullopt;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_ENVELOPE_ARC_DISKS_H
