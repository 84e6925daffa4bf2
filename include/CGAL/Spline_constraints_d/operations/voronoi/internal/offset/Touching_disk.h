// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TOUCHING_DISK_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TOUCHING_DISK_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Disk_reach.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_ranges.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
A disk of a given radius r that touches an element in a point X(a), and a site in a point Y(b), both known exactly; and
the disks on both sides of it.

The disk of u holds Y(v) where a function H(u,v) is negative (see Disk_reach). Here H(a,b) = 0, which is decided
exactly, as is whether H_u and H_v are zero there: for points opposite to each other, and where the site is tangent to
the disk. Where they are not, bounds over a box tell their signs, and where they are, bounds of the second derivatives
tell the signs of H in all quadrants around (a,b): whether H is positive but in (a,b), so that the site is never held;
or negative for some v, whatever u.
*/
template <Enclosing_number Interval = Common::Interval>
class Touching_disk
{
  using Jet = typename Disk_reach<Interval>::Jet;

  static constexpr double most_way = 0x1p-4;   // between a point of an arc and the part of it that is looked at

  // From (a,b) to the border of a box.
  struct Way
  {
    int direction;
    Interval width;
  };

  const Site_graph_2<Interval>& m_graph;
  const Oriented_element<Interval>& m_element;
  Interval m_radius;
  Exact_rational m_square;   // of 2 r
  Exact_rational m_parameter;
  Exact_pair m_point, m_normal;
  std::optional<Exact_disk> m_disk;   // if a site is touched
  std::array<Way, 2> m_ways{Way{-1, Interval(0)}, Way{1, Interval(0)}};   // of u

public:
  // At a parameter of an element that ends exactly.
  Touching_disk(const Site_graph_2<Interval>& graph, std::size_t element, const Exact_rational& radius,
                const Exact_rational& parameter)
    : m_graph(graph), m_element(graph.elements()[element]), m_radius(interval_of<Interval>(radius)),
      m_square(4 * radius * radius), m_parameter(parameter), m_point(graph.exact_point_at(m_element, parameter)),
      m_normal(graph.exact_normal(m_element, parameter))
  {}

  static bool is_defined(const Site_graph_2<Interval>& graph, std::size_t element)
  {
    const Oriented_element<Interval>& f = graph.elements()[element];
    return f.is_normal_cone ? graph.vertices()[f.object].is_exact : graph.are_ends_exact(f.object);
  }

  struct Arc_part
  {
    std::size_t arc;
    Range range;
  };

  // Candidates that are next to each other, as one.
  static std::vector<Arc_part> parts_of_arcs(const std::vector<Disk_candidate<Interval>>& candidates)
  {
    std::vector<Arc_part> parts, result;
    for (const Disk_candidate<Interval>& candidate : candidates)
      if (candidate.kind == Disk_candidate<Interval>::Kind::ARC)
        parts.push_back({candidate.index, candidate.range});
    std::sort(parts.begin(), parts.end(), [](const Arc_part& a, const Arc_part& b) {
      return a.arc != b.arc ? a.arc < b.arc : a.range.begin < b.range.begin;
    });
    for (const Arc_part& part : parts)
      if (!result.empty() && result.back().arc == part.arc && part.range.begin - result.back().range.end < most_way)
        result.back().range = united(result.back().range, part.range);
      else
        result.push_back(part);
    return result;
  }

  // Where an exact disk of a small part may be: at the simplest number, or, on a segment, where it touches an end of an
  // arc.
  static std::vector<Exact_rational> simple_parameters(const Site_graph_2<Interval>& graph,
                                                       const Element_part<Interval>& part, const Exact_rational& radius,
                                                       const std::vector<Disk_candidate<Interval>>& candidates)
  {
    const Exact_rational begin(part.range.begin), end(part.range.end);
    std::vector<Exact_rational> result{simplest_rational_between(begin, end)};
    const Oriented_element<Interval>& element = graph.elements()[part.element];
    const auto add = [&](std::size_t vertex) {
      for (const Exact_rational& u :
           touching_parameters(graph.vertices()[vertex].exact_point, graph.arcs()[element.object], radius))
        if (begin <= u && u <= end && std::find(result.begin(), result.end(), u) == result.end())
          result.push_back(u);
    };
    if (element.is_normal_cone || !graph.arcs()[element.object].is_segment())
      return result;
    for (const Disk_candidate<Interval>& candidate : candidates) {
      if (candidate.kind == Disk_candidate<Interval>::Kind::VERTEX)
        add(candidate.index);
      if (candidate.kind == Disk_candidate<Interval>::Kind::ARC && candidate.range.begin < most_way)
        add(graph.vertex_of({candidate.index, false}));
      if (candidate.kind == Disk_candidate<Interval>::Kind::ARC && candidate.range.end > 1 - most_way)
        add(graph.vertex_of({candidate.index, true}));
    }
    return result;
  }

  // Where disks touch the line of a segment and a point, if that is opposite, or the numbers are rational.
  static std::vector<Exact_rational> touching_parameters(const Exact_pair& p, const Site_arc_2<Interval>& segment,
                                                         const Exact_rational& radius)
  {
    const Exact_rational foot = segment.parameter_of_foot(p);
    const Exact_pair d = exact_difference(segment.at(1), segment.at(0));
    const Exact_rational dd = exact_dot(d, d);
    const auto length = rational_square_root(dd);
    const Exact_rational height = length
        ? Exact_rational(CGAL::abs(exact_cross(d, exact_difference(p, segment.at(0)))) / *length)
        : Exact_rational(0),
                         square = (2 * radius - height) * height / dd;
    const auto way = sign_of(square) > 0 ? rational_square_root(square) : std::nullopt;
    return way ? std::vector<Exact_rational>{Exact_rational(foot - *way), Exact_rational(foot + *way)}
               : std::vector<Exact_rational>{foot};
  }

  // What the disks of a part of the element that holds the parameter do before and behind it, if the disk touches one
  // of some sites, and others are not held.
  std::optional<std::array<Held, 2>> sides(const Range& range, const std::vector<Disk_candidate<Interval>>& candidates)
  {
    const Disk_reach<Interval> reach(m_graph, m_element, m_radius, range);
    m_ways = ways_to_ends(range, m_parameter);
    std::array<Held, 2> result{Held::NO, Held::NO};
    const auto add = [&](const std::array<Held, 2>& sides) {
      result = {held_by_any(result[0], sides[0]), held_by_any(result[1], sides[1])};
    };
    for (const Disk_candidate<Interval>& candidate : candidates)
      if (candidate.kind == Disk_candidate<Interval>::Kind::VERTEX)
        add(sides_with_vertex(reach, candidate.index));
      else if (candidate.kind == Disk_candidate<Interval>::Kind::NODE)
        add({Held::UNKNOWN, Held::UNKNOWN});
    for (const auto& [arc, part] : parts_of_arcs(candidates))
      add(sides_with_arc(reach, arc, part));
    return m_disk ? std::optional(result) : std::nullopt;
  }

  // The disk, by its center, if it is known to touch something.
  const std::optional<Exact_disk>& disk() const { return m_disk; }

private:
  // Whether the disk touches a point; then it is known.
  bool touches(const Exact_pair& y)
  {
    const Exact_pair d = exact_difference(y, m_point);
    const Exact_rational height = exact_dot(m_normal, d);
    if (sign_of(height) <= 0)
      return false;
    const Exact_rational scale = exact_dot(d, d) / (2 * height);   // of the normal, as the way to the center
    const Exact_disk disk(m_point, {Exact_rational(scale * m_normal[0]), Exact_rational(scale * m_normal[1])});
    if (4 * disk.squared_radius != m_square)
      return false;
    m_disk = disk;
    return true;
  }

  bool is_opposite(const Exact_pair& y) const
  {
    return sign_of(exact_cross(m_normal, exact_difference(y, m_point))) == 0;
  }

  std::array<Held, 2> sides_with_vertex(const Disk_reach<Interval>& reach, std::size_t index)
  {
    const auto& vertex = m_graph.vertices()[index];
    if (!vertex.is_exact || !touches(vertex.exact_point)) {
      const Held held = reach.hold_vertex(index);
      return {held, held};
    }
    const Jet h = reach.of_vertex(index);
    const auto side = [&](const Way& u) { return held_beside(h, u, is_opposite(vertex.exact_point)); };
    return {side(m_ways[0]), side(m_ways[1])};
  }

  // Whether a point is held that is touched in a.
  static Held held_beside(const Jet& h, const Way& u, bool is_opposite)
  {
    const int sign = is_opposite ? certain_sign(h.uu) : u.direction * certain_sign(h.u);
    return sign > 0 ? Held::NO : sign < 0 ? Held::YES : Held::UNKNOWN;
  }

  std::array<Held, 2> sides_with_arc(const Disk_reach<Interval>& reach, std::size_t arc, const Range& part)
  {
    const std::optional<Exact_rational> b = m_graph.are_ends_exact(arc) ? touched_parameter(arc, part) : std::nullopt;
    if (!b) {
      const Held held = reach.hold_arc(arc, part);
      return {held, held};
    }
    const Site_arc_2<Interval>& site = m_graph.arcs()[arc];
    const Range location{interval_of(*b).inf(), interval_of(*b).sup()}, range = united(part, location);
    const Exact_pair y = site.at(*b), center = m_disk->center;
    const bool is_tangent = sign_of(exact_dot(site.tangent_at(*b), exact_difference(y, center))) == 0;
    const Jet h = reach.of_arc(arc, range), at_b = reach.of_point(arc, location);
    const int growth = is_tangent ? 0 : reach.growth(arc, range);
    const auto side = [&](const Way& u) {
      Held result = Held::NO;
      for (const Way& v : ways_to_ends(range, *b))
        if (v.width.sup() > 0)
          result = held_by_any(result,
                               is_tangent                     ? held_in_quadrant(h, at_b, u, v, is_opposite(y))
                                   : v.direction * growth > 0 ? held_beside(at_b, u, is_opposite(y))
                                                              : Held::UNKNOWN);
      return result;
    };
    return {side(m_ways[0]), side(m_ways[1])};
  }

  static std::array<Way, 2> ways_to_ends(const Range& range, const Exact_rational& parameter)
  {
    const Interval x = interval_of<Interval>(parameter);
    return {Way{-1, x - Interval(range.begin)}, Way{1, Interval(range.end) - x}};
  }

  // Where u and v leave (a,b) in given directions, and the arc is tangent to the disk.
  static Held held_in_quadrant(const Jet& h, const Jet& at_b, const Way& u, const Way& v, bool is_opposite)
  {
    if (held_beside(at_b, u, is_opposite) == Held::YES)
      return Held::YES;
    if (!(h.vv.inf() > 0))
      return Held::UNKNOWN;
    if (!is_opposite)   // H grows with v in a, and with u everywhere
      return u.direction * certain_sign(h.u) > 0 ? Held::NO : Held::UNKNOWN;
    const Interval uv = Interval(u.direction * v.direction) * h.uv;
    if (h.uu.inf() > 0 && (uv.inf() >= 0 || (h.uu * h.vv - CGAL::square(uv)).inf() > 0))
      return Held::NO;
    const Interval slope((-uv / h.vv).inf());   // of v, where H is least
    const bool is_in_box = slope.inf() > 0 && (slope * u.width).sup() <= v.width.inf();
    return is_in_box && (h.uu + Interval(2) * slope * uv + CGAL::square(slope) * h.vv).sup() < 0 ? Held::YES
                                                                                                 : Held::UNKNOWN;
  }

  // Where the disk touches an arc, next to a part of that: in an end, in the foot of the center on a segment, or in a
  // point with a simple parameter.
  std::optional<Exact_rational> touched_parameter(std::size_t arc, const Range& part)
  {
    const Site_arc_2<Interval>& site = m_graph.arcs()[arc];
    std::vector<Exact_rational> parameters;
    if (part.begin < most_way)
      parameters.emplace_back(0);
    if (part.end > 1 - most_way)
      parameters.emplace_back(1);
    if (site.is_segment()) {
      parameters.push_back(site.parameter_of_foot(m_point));   // of an opposite point
      if (const auto share = rational_square_root(Exact_rational(m_square / (4 * exact_dot(m_normal, m_normal)))))
        parameters.push_back(site.parameter_of_foot(
            {Exact_rational(m_point[0] + *share * m_normal[0]), Exact_rational(m_point[1] + *share * m_normal[1])}));
    }
    parameters.push_back(simplest_rational_between(Exact_rational(part.begin), Exact_rational(part.end)));
    const auto position = std::find_if(parameters.begin(), parameters.end(), [&](const Exact_rational& b) {
      return b >= 0 && b <= 1 && touches(site.at(b));
    });
    return position == parameters.end() ? std::nullopt : std::optional(*position);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TOUCHING_DISK_H
