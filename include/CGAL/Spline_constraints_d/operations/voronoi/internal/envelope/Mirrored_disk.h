// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_DISK_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_DISK_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_contacts.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_contact.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Disks of symmetric drawings, with centers on axes of symmetry, that touch a front and several contacts at once; where these are need not be rational.

Let a contact, which is not scaled, lie on the mirror image of the front. Any disk that touches the front and the image of that point is its own image, so that the branch of the contact has these disks. Where another branch crosses it, one disk touches both, and the images of all that it touches; if the second one is on
an axis as well, its images in that axis too. Each branch has one maximum, which is the image if it holds it.
*/
template <Enclosing_number Interval>
class Basic_mirrored_disk
{
  using Site_graph_2 = Basic_site_graph_2<Interval>;
  using Front = Basic_front<Interval>;
  using Front_part = Basic_front_part<Interval>;
  using Disk_curvature = Basic_disk_curvature<Interval>;

  const Site_graph_2& m_graph;
  const Disk_curvature& m_curvature;
  const Front_part& m_part;
  const std::vector<Disk_branch>& m_branches;

public:
  Basic_mirrored_disk(const Site_graph_2& graph, const Disk_curvature& curvature, const Front_part& part, const std::vector<Disk_branch>& branches)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_branches(branches)
  {}

  // Whether it is proved that one disk over the part touches all contacts, those that move in the end of an arc.
  bool touches_all() const
  {
    const Front& front = m_graph.fronts()[m_part.front];
    if (front.is_fan && m_curvature.is_vertex_scaled(front.object))
      return false;
    for (const Disk_branch& image : m_branches)
      if (const auto mirror = mirror_of_front(image))
        for (const Disk_branch& other : m_branches)
          if (&other != &image && touches_all(image, *mirror, other))
            return true;
    return false;
  }

private:
  Touched_point touched_on_front(const Range& range) const
  {
    const Front& front = m_graph.fronts()[m_part.front];
    return {{front.is_fan ? Disk_contact::Kind::VERTEX : Disk_contact::Kind::ARC, front.object}, range};
  }

  // The reflection that maps the front to a contact.
  std::optional<Reflection_2> mirror_of_front(const Disk_branch& branch) const
  {
    if (branch.move || is_scaled(m_curvature, branch.contact))
      return std::nullopt;
    for (const Reflection_2& mirror : reflections(m_graph, touched_on_front({}).contact, branch.contact))
      if (const auto image = mirrored(m_graph, mirror, touched_on_front(m_part.range), branch.contact); image && image->range.meets(branch.range))
        return mirror;
    return std::nullopt;
  }

  // The same where the second branch crosses the first one.
  bool touches_all(const Disk_branch& image, const Reflection_2& mirror, const Disk_branch& other) const
  {
    const auto zero = crossing(image, fixed(other));
    if (!zero)
      return false;
    const Front_part point = m_curvature.part(m_part.front, *zero);
    const Touched_point on_front = touched_on_front(*zero), on_other{fixed(other).contact, largest_curvature(m_graph, m_curvature, point, fixed(other)).range};
    std::vector<Reflection_2> mirrors{mirror};
    if (const auto second = mirror_of_front(other))
      mirrors.push_back(*second);
    if (other.move && !is_tangent_to_joint(mirror, other))
      return false;
    std::vector<Touched_point> touched{on_front, on_other};
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
  Located_contact fixed(const Disk_branch& branch) const
  {
    return branch.move ? Located_contact{{Disk_contact::Kind::VERTEX, m_graph.vertex_of({branch.move->arc, branch.move->parameter == 1})}} : Located_contact(branch);
  }

  // Where the curvatures of two contacts change their order.
  std::optional<Range> crossing(const Located_contact& a, const Located_contact& b) const
  {
    const auto sign_at = [&](double u) {
      const Front_part point = m_curvature.part(m_part.front, {u, u});
      return certain_sign(largest_curvature(m_graph, m_curvature, point, a).curvature - largest_curvature(m_graph, m_curvature, point, b).curvature);
    };
    const int at_begin = sign_at(m_part.range.begin), at_end = sign_at(m_part.range.end);
    return at_begin * at_end < 0 ? std::optional(range_of_zero(m_part.range, sign_at, at_begin)) : std::nullopt;
  }

  // Whether disks with the center on the axis are tangent to arcs where they pass through the joint in which the contact moves.
  bool is_tangent_to_joint(const Reflection_2& mirror, const Disk_branch& branch) const
  {
    const Arc_end end{branch.move->arc, branch.move->parameter == 1};
    return branch.move->event == Disk_event::JOINT && !branch.move->joined_ends && m_graph.is_exact(end) && m_curvature.is_arc_scaled(end.arc) == m_curvature.is_vertex_scaled(m_graph.vertex_of(end)) && mirror.is_perpendicular(m_graph.vertices()[m_graph.vertex_of(end)].exact_point, m_graph.direction(end));
  }

  std::optional<Touched_point> touched_image(const Reflection_2& mirror, const Touched_point& point, const Disk_branch& branch, const Front_part& part) const
  {
    const auto image = branch.move || is_scaled(m_curvature, point.contact) != is_scaled(m_curvature, branch.contact) ? std::nullopt : mirrored(m_graph, mirror, point, branch.contact);
    return image && is_only_maximum(m_graph, m_curvature, part, *image, branch) ? image : std::nullopt;
  }
};

using Mirrored_disk = Basic_mirrored_disk<Interval>;

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_DISK_H
