// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_COMMON_HALF_PLANE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_COMMON_HALF_PLANE_H

#include <CGAL/Spline_constraints_d/operations/internal/Control_points_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Disk_contacts.h>
#include <CGAL/Spline_constraints_d/operations/internal/Mirrored_contact.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A half-plane that touches a front and several copies of it in a row, moved by multiples of one vector d; where that is need not be rational.

Where <N(u), d> = 0, the half-plane of N has the points X(u) + s d on its boundary, and so that of each copy with the same parameter, where the copy has the same tangent: k = 0 and k_v = 0 there. Each branch has one maximum, which is that point if it holds it.
*/
template <Enclosing_number Interval>
class Basic_common_half_plane
{
  using Interval_pair = std::array<Interval, 2>;
  using Site_arc_2 = Basic_site_arc_2<Interval>;
  using Site_graph_2 = Basic_site_graph_2<Interval>;
  using Front = Basic_front<Interval>;
  using Front_part = Basic_front_part<Interval>;
  using Disk_curvature = Basic_disk_curvature<Interval>;

  const Site_graph_2& m_graph;
  const Disk_curvature& m_curvature;
  const Front_part& m_part;

public:
  Basic_common_half_plane(const Site_graph_2& graph, const Disk_curvature& curvature, const Front_part& part) : m_graph(graph), m_curvature(curvature), m_part(part) {}

  // Whether it is proved that a half-plane over the part touches all contacts, of which one is nothing: that of disks that are half-planes.
  bool touches_all(const std::vector<Disk_branch>& branches) const
  {
    if (m_curvature.scaled_sites() != nullptr)
      return false;
    std::optional<Exact_pair> direction;
    bool is_half_plane = false;
    for (const Disk_branch& branch : branches) {
      if (branch.contact.kind == Disk_contact::Kind::NOTHING) {
        is_half_plane = true;
        continue;
      }
      const auto way = branch.move ? std::nullopt : way_to_copy(branch);
      if (!way || (direction && sign_of(exact_cross(*direction, *way)) != 0))
        return false;
      direction = *way;
    }
    return is_half_plane && direction && turn(*direction, m_part.range.begin) * turn(*direction, m_part.range.end) < 0;
  }

private:
  int turn(const Exact_pair& direction, double u) const
  {
    return certain_sign(dot(m_graph.front_jet(m_graph.fronts()[m_part.front], {u, u}).normal, Interval_pair{interval_of<Interval>(direction[0]), interval_of<Interval>(direction[1])}));
  }

  // The vector from the front to a contact that is a copy of it, and touched at the parameter of the front.
  std::optional<Exact_pair> way_to_copy(const Located_contact& located) const
  {
    const Front& front = m_graph.fronts()[m_part.front];
    const Disk_contact own{front.is_fan ? Disk_contact::Kind::VERTEX : Disk_contact::Kind::ARC, front.object}, &other = located.contact;
    const auto way = [](const Exact_pair& p, const Exact_pair& q) { return Exact_pair{Exact_rational(q[0] - p[0]), Exact_rational(q[1] - p[1])}; };
    if (is_exact_vertex(m_graph, own) && is_exact_vertex(m_graph, other))
      return way(m_graph.vertices()[own.index].exact_point, m_graph.vertices()[other.index].exact_point);
    if (!is_exact_arc(m_graph, own) || !is_exact_arc(m_graph, other) || own.index == other.index || have_different_chords(m_graph, own.index, other.index))
      return std::nullopt;
    const Site_arc_2 &a = m_graph.arcs()[own.index], &b = m_graph.arcs()[other.index];
    for (const bool is_reversed : {false, true}) {
      const Exact_pair d = way(a.at(0), b.at(is_reversed ? 1 : 0));
      const auto moved = [&](const Exact_pair& p) { return Exact_pair{Exact_rational(p[0] + d[0]), Exact_rational(p[1] + d[1])}; };
      const Interval v = is_reversed ? Interval(1) - interval_of<Interval>(m_part.range) : interval_of<Interval>(m_part.range);
      if (is_image(a, moved, b, is_reversed) && is_only_maximum(m_graph, m_curvature, m_part, {other, {v.inf(), v.sup()}}, located))
        return d;
    }
    return std::nullopt;
  }
};

using Common_half_plane = Basic_common_half_plane<Interval>;

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_COMMON_HALF_PLANE_H
