// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_DISK_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_DISK_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_footpoint.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Disks of symmetric drawings, with centers on axes of symmetry, that touch an element and several footpoints at once;
where these are need not be rational.

Let a footpoint, which is not scaled, lie on the mirror image of the element. Any disk that touches the element and the
image of that point is its own image, so that the branch of the footpoint has these disks. Where another branch crosses
it, one disk touches both, and the images of all that it touches; if the second one is on an axis as well, its images in
that axis too. Each branch has one maximum, which is the image if it holds it.
*/
template <Enclosing_number Interval = Common::Interval>
class Mirrored_disk
{
  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  const std::vector<Disk_branch>& m_branches;

public:
  Mirrored_disk(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                const Element_part<Interval>& part, const std::vector<Disk_branch>& branches)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_branches(branches)
  {}

  // Whether it is proved that one disk over the part touches all footpoints, those that move in the end of an arc.
  bool touches_all() const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[m_part.element];
    if (element.is_normal_cone && m_curvature.is_vertex_scaled(element.object))
      return false;
    for (const Disk_branch& image : m_branches)
      if (const auto mirror = mirror_of_element(image))
        for (const Disk_branch& other : m_branches)
          if (&other != &image && touches_all(image, *mirror, other))
            return true;
    return false;
  }

private:
  Touched_point touched_on_element(const Range& range) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[m_part.element];
    return {{element.is_normal_cone ? Disk_footpoint::Kind::VERTEX : Disk_footpoint::Kind::ARC, element.object}, range};
  }

  // The reflection that maps the element to a footpoint.
  std::optional<Reflection_2> mirror_of_element(const Disk_branch& branch) const
  {
    if (branch.move || is_scaled(m_curvature, branch.footpoint))
      return std::nullopt;
    for (const Reflection_2& mirror : reflections(m_graph, touched_on_element({}).footpoint, branch.footpoint))
      if (const auto image = mirrored(m_graph, mirror, touched_on_element(m_part.range), branch.footpoint);
          image && image->range.meets(branch.range))
        return mirror;
    return std::nullopt;
  }

  // The same where the second branch crosses the first one.
  bool touches_all(const Disk_branch& image, const Reflection_2& mirror, const Disk_branch& other) const
  {
    const auto zero = crossing(image, fixed(other));
    if (!zero)
      return false;
    const Element_part<Interval> point = m_curvature.part(m_part.element, *zero);
    const Touched_point on_element = touched_on_element(*zero),
                        on_other{fixed(other).footpoint,
                                 largest_curvature(m_graph, m_curvature, point, fixed(other)).range};
    std::vector<Reflection_2> mirrors{mirror};
    if (const auto second = mirror_of_element(other))
      mirrors.push_back(*second);
    if (other.move && !is_tangent_to_joint(mirror, other))
      return false;
    std::vector<Touched_point> touched{on_element, on_other};
    std::vector<const Disk_branch*> left;
    for (const Disk_branch& branch : m_branches)
      if (&branch != &other)
        left.push_back(&branch);
    for (std::size_t i = 0; i < touched.size() && !left.empty(); ++i)
      for (const Reflection_2& m : mirrors)
        std::erase_if(left, [&](const Disk_branch* branch) {
          const auto y = touched_image(m, touched[i], *branch, point);
          if (y)
            touched.push_back(*y);
          return y.has_value();
        });
    return left.empty();
  }

  // A branch, or the vertex in which it moves from one arc to the next one.
  Located_footpoint fixed(const Disk_branch& branch) const
  {
    return branch.move ? Located_footpoint{{Disk_footpoint::Kind::VERTEX,
                                            m_graph.vertex_of({branch.move->arc, branch.move->parameter == 1})}}
                       : Located_footpoint(branch);
  }

  // Where the curvatures of two footpoints change their order.
  std::optional<Range> crossing(const Located_footpoint& a, const Located_footpoint& b) const
  {
    const auto sign_at = [&](double u) {
      const Element_part<Interval> point = m_curvature.part(m_part.element, {u, u});
      return certain_sign(largest_curvature(m_graph, m_curvature, point, a).curvature -
                          largest_curvature(m_graph, m_curvature, point, b).curvature);
    };
    const int at_begin = sign_at(m_part.range.begin), at_end = sign_at(m_part.range.end);
    return at_begin * at_end < 0 ? std::optional(range_of_zero(m_part.range, sign_at, at_begin)) : std::nullopt;
  }

  // Whether disks with the center on the axis are tangent to arcs where they pass through the joint in which the
  // footpoint moves.
  bool is_tangent_to_joint(const Reflection_2& mirror, const Disk_branch& branch) const
  {
    const Arc_end end{branch.move->arc, branch.move->parameter == 1};
    return branch.move->event == Disk_event::JOINT && !branch.move->joined_ends && m_graph.is_exact(end) &&
        m_curvature.is_arc_scaled(end.arc) == m_curvature.is_vertex_scaled(m_graph.vertex_of(end)) &&
        mirror.is_perpendicular(m_graph.vertices()[m_graph.vertex_of(end)].exact_point, m_graph.direction(end));
  }

  std::optional<Touched_point> touched_image(const Reflection_2& mirror, const Touched_point& point,
                                             const Disk_branch& branch, const Element_part<Interval>& part) const
  {
    const auto image =
        branch.move || is_scaled(m_curvature, point.footpoint) != is_scaled(m_curvature, branch.footpoint)
        ? std::nullopt
        : mirrored(m_graph, mirror, point, branch.footpoint);
    return image && is_only_maximum(m_graph, m_curvature, part, *image, branch) ? image : std::nullopt;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_DISK_H
