// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_COVERING_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_COVERING_SITES_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Whether all disks of one radius r on a short range of an element touch or hold one of some sites, by exact computation:
where they are smallest in one point and touch two sites there.

The centers of the disks of a straight element are on a segment, and those that are no more than r from a convex site, a
point or a segment, on a part of that. The centers of the disks of a normal cone are on an arc of the circle of radius r
around its vertex, of at most 90 degrees, and those no more than r from another point on a smaller part of the circle
than a half. So a site that is that near at both ends of a range is so throughout, and two sites cover a range if one is
near from its begin to some number, and the other one from there to its end. If there is such a number at all, it is the
simplest one in a range as small as this, in drawings.
*/
class Covering_sites
{
  const Site_graph_2<>& m_graph;
  const Oriented_element<>& m_element;
  Exact_rational m_radius;
  std::vector<std::size_t> m_vertices, m_segments;

public:
  Covering_sites(const Site_graph_2<>& graph, std::size_t element, const Exact_rational& radius,
                 const std::vector<Disk_candidate<>>& candidates)
    : m_graph(graph), m_element(graph.elements()[element]), m_radius(radius)
  {
    for (const Disk_candidate<>& candidate : candidates)
      if (candidate.kind == Disk_candidate<>::Kind::VERTEX)
        add_vertex(candidate.index);
      else if (candidate.kind == Disk_candidate<>::Kind::ARC &&
               (m_element.is_normal_cone || candidate.index != m_element.object) &&
               graph.are_ends_exact(candidate.index)) {
        add_vertex(graph.vertex_of({candidate.index, false}));
        add_vertex(graph.vertex_of({candidate.index, true}));
        if (graph.arcs()[candidate.index].is_straight())
          m_segments.push_back(candidate.index);
      }
  }

  const std::vector<std::size_t>& vertices() const { return m_vertices; }

  bool cover(const Range& range) const
  {
    if (!m_element.is_normal_cone &&
        !(m_graph.arcs()[m_element.object].is_segment() && m_graph.are_ends_exact(m_element.object)))
      return false;
    const Exact_rational begin(range.begin), end(range.end), between = simplest_rational_between(begin, end);
    return is_one_near(begin, between) && is_one_near(between, end);
  }

  // Whether all of some centers are opposite to two parallel walls, between these, and the distance of the walls is no
  // more than that of a disk.
  bool are_walls_around(const Interval_pair& centers) const
  {
    const auto is_opposite = [&](std::size_t segment) {
      const auto [a, b] = ends_of(segment);
      const Interval_pair p = interval_pair_of<Interval>(a), d = interval_pair_of<Interval>(b) - p;
      const Interval along = dot(d, centers - p);
      return along.inf() >= 0 && along.sup() <= squared_norm(d).inf();
    };
    std::vector<std::size_t> walls;
    std::copy_if(m_segments.begin(), m_segments.end(), std::back_inserter(walls), is_opposite);
    for (const std::size_t s : walls)
      for (const std::size_t t : walls) {
        const auto [a, b] = ends_of(s);
        const auto [c, e] = ends_of(t);
        const Exact_pair d = exact_difference(b, a);
        const Exact_rational height = exact_cross(d, exact_difference(c, a));
        if (sign_of(exact_cross(d, exact_difference(e, c))) == 0 &&
            height * height <= 4 * m_radius * m_radius * exact_dot(d, d)) {
          const Interval of_centers =
              dot(turned_left(interval_pair_of<Interval>(d)), centers - interval_pair_of<Interval>(a));
          if (sign_of(height) > 0 ? of_centers.inf() >= 0 && of_centers.sup() <= interval_of(height).inf()
                                  : of_centers.sup() <= 0 && of_centers.inf() >= interval_of(height).sup())
            return true;
        }
      }
    return false;
  }

  // Whether the disk at an end of the element touches a vertex.
  bool touches_at_end(bool end, std::size_t vertex) const
  {
    return sign_of_reach(Exact_rational(end ? 1 : 0), vertex) == 0;
  }

private:
  // Not one of the element, which its disks touch all the same.
  void add_vertex(std::size_t vertex)
  {
    const bool is_own = m_element.is_normal_cone ? vertex == m_element.object
                                                 : vertex == m_graph.vertex_of({m_element.object, false}) ||
            vertex == m_graph.vertex_of({m_element.object, true});
    if (m_graph.vertices()[vertex].is_exact && !is_own)
      m_vertices.push_back(vertex);
  }

  std::array<Exact_pair, 2> ends_of(std::size_t arc) const
  {
    return {m_graph.arcs()[arc].at(0), m_graph.arcs()[arc].at(1)};
  }

  Exact_pair point(const Exact_rational& u) const { return m_graph.exact_point_at(m_element, u); }

  // Whether a vertex is in the disk, on its boundary or outside: 1, 0, -1.
  int sign_of_reach(const Exact_rational& u, std::size_t vertex) const
  {
    const Exact_pair n = m_graph.exact_normal(m_element, u),
                     d = exact_difference(m_graph.vertices()[vertex].exact_point, point(u));
    const Exact_rational along = 2 * m_radius * exact_dot(n, d), dd = exact_dot(d, d);
    return sign_of(along) < 0 ? -1 : sign_of(Exact_rational(along * along - dd * dd * exact_dot(n, n)));
  }

  bool is_one_near(const Exact_rational& from, const Exact_rational& to) const
  {
    return std::any_of(m_vertices.begin(), m_vertices.end(),
                       [&](std::size_t v) { return sign_of_reach(from, v) >= 0 && sign_of_reach(to, v) >= 0; }) ||
        std::any_of(m_segments.begin(), m_segments.end(),
                    [&](std::size_t s) { return is_segment_near(from, s) && is_segment_near(to, s); });
  }

  // Of a segment, only what is opposite to the center is looked at, and only from a segment whose disks have rational
  // centers: the centers so near are those in a rectangle.
  bool is_segment_near(const Exact_rational& u, std::size_t segment) const
  {
    if (m_element.is_normal_cone)
      return false;
    const Exact_pair n = m_graph.exact_normal(m_element, u), p = point(u), a = m_graph.arcs()[segment].at(0),
                     d = exact_difference(m_graph.arcs()[segment].at(1), a);
    const auto length = rational_square_root(exact_dot(n, n));
    if (!length)
      return false;
    const Exact_rational scale = m_radius / *length;
    const Exact_pair to_center =
        exact_difference(Exact_pair{Exact_rational(p[0] + scale * n[0]), Exact_rational(p[1] + scale * n[1])}, a);
    const Exact_rational along = exact_dot(d, to_center), across = exact_cross(d, to_center), dd = exact_dot(d, d);
    return sign_of(along) >= 0 && along <= dd && across * across <= m_radius * m_radius * dd;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_COVERING_SITES_H
