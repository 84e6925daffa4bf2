// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_HALF_PLANE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_HALF_PLANE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Control_points_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_footpoint.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
A half-plane that touches an element and several copies of it in a row, moved by multiples of one vector d; where that
is need not be rational.

Where <N(u), d> = 0, the half-plane of N has the points X(u) + s d on its boundary, and so that of each copy with the
same parameter, where the copy has the same tangent: k = 0 and k_v = 0 there. Each branch has one maximum, which is that
point if it holds it.
*/
template <Enclosing_number Interval = Common::Interval>
class Common_half_plane
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;

public:
  Common_half_plane(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                    const Element_part<Interval>& part)
    : m_graph(graph), m_curvature(curvature), m_part(part)
  {}

  // Whether it is proved that a half-plane over the part touches all footpoints, of which one is nothing: that of disks
  // that are half-planes.
  bool touches_all(const std::vector<Disk_branch>& branches) const
  {
    if (m_curvature.scaled_sites() != nullptr)
      return false;
    std::optional<Exact_pair> direction;
    bool is_half_plane = false;
    for (const Disk_branch& branch : branches) {
      if (branch.footpoint.kind == Disk_footpoint::Kind::NOTHING) {
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
    return certain_sign(dot(m_graph.element_jet(m_graph.elements()[m_part.element], {u, u}).normal,
                            Interval_pair{interval_of<Interval>(direction[0]), interval_of<Interval>(direction[1])}));
  }

  // The vector from the element to a footpoint that is a copy of it, and touched at the parameter of the element.
  std::optional<Exact_pair> way_to_copy(const Located_footpoint& located) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[m_part.element];
    const Disk_footpoint own{element.is_normal_cone ? Disk_footpoint::Kind::VERTEX : Disk_footpoint::Kind::ARC,
                             element.object},
        &other = located.footpoint;
    if (is_exact_vertex(m_graph, own) && is_exact_vertex(m_graph, other))
      return exact_difference(m_graph.vertices()[other.index].exact_point, m_graph.vertices()[own.index].exact_point);
    if (own.kind != Disk_footpoint::Kind::ARC || other.kind != Disk_footpoint::Kind::ARC ||
        have_different_chords(m_graph, own.index, other.index))
      return std::nullopt;
    const Homogeneous_piece a = m_graph.arcs()[own.index].piece().uncut(),
                            b = m_graph.arcs()[other.index].piece().uncut();
    for (const bool is_reversed : {false, true}) {
      const Control_points_2 p(a), q(b);
      const Exact_pair d = exact_difference(q.point(is_reversed ? q.size() - 1 : 0), p.point(0));
      const auto moved = [&](const Exact_pair& x) {
        return Exact_pair{Exact_rational(x[0] + d[0]), Exact_rational(x[1] + d[1])};
      };
      if (d != Exact_pair{0, 0} && is_image(a, moved, b, is_reversed) &&
          is_only_maximum(m_graph, m_curvature, m_part,
                          {other, corresponding_range(m_graph, own.index, m_part.range, other.index, is_reversed)},
                          located))
        return d;
    }
    return std::nullopt;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_HALF_PLANE_H
