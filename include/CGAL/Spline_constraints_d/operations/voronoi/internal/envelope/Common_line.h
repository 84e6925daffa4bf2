// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_LINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_LINE_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/touches_line.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
A half-plane whose border is a line with rational coefficients, which touches an element and several footpoints at once:
it is the tangent in an end of an arc, or goes through two vertices, or belongs to the simplest parameter of the
element.

The half-plane of X(u) has Y(v) on its border and is tangent to the arc there where k = 0 and k_v = 0. So a vertex is
touched if it is on the line, and the end of an arc, in which the footpoint may go over to the vertex or to the next
arc, if the line is the tangent there. Any other arc is touched where a polynomial, the distance of its points from the
line times a constant and the weight, has a multiple root; its branch has one maximum, which is that point if it holds
it.
*/
template <Enclosing_number Interval = Common::Interval>
class Common_line
{
  using Interval_pair = std::array<Interval, 2>;

  struct Line
  {
    Exact_pair point, direction;

    bool holds(const Exact_pair& p) const { return sign_of(exact_cross(direction, exact_difference(p, point))) == 0; }
  };

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  const Oriented_element<Interval>& m_element;

public:
  Common_line(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
              const Element_part<Interval>& part)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_element(graph.elements()[part.element])
  {}

  // Whether it is proved that a half-plane over the part touches all footpoints, of which one is nothing: that of disks
  // that are half-planes.
  bool touches_all(const std::vector<Disk_branch>& branches) const
  {
    const auto is_nothing = [](const Disk_branch& branch) {
      return branch.footpoint.kind == Disk_footpoint::Kind::NOTHING;
    };
    if (m_curvature.scaled_sites() != nullptr || std::none_of(branches.begin(), branches.end(), is_nothing))
      return false;
    const std::vector<Line> lines = possible_lines(branches);
    return std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
      return touches_element(line) && std::all_of(branches.begin(), branches.end(), [&](const Disk_branch& branch) {
               return is_nothing(branch) || touches(line, branch);
             });
    });
  }

private:
  std::vector<Line> possible_lines(const std::vector<Disk_branch>& branches) const
  {
    std::vector<Line> result;
    std::vector<Exact_pair> points;
    const auto add_point = [&](const Disk_footpoint& footpoint) {
      if (is_exact_vertex(m_graph, footpoint))
        points.push_back(m_graph.vertices()[footpoint.index].exact_point);
    };
    if (m_element.is_normal_cone)
      add_point({Disk_footpoint::Kind::VERTEX, m_element.object});
    for (const Disk_branch& branch : branches)
      if (!branch.move)
        add_point(branch.footpoint);
      else if (const Arc_end end = end_of_move(branch); m_graph.is_exact(end))
        result.push_back({m_graph.arcs()[end.arc].at(end.is_end), m_graph.direction(end)});
    if (points.size() > 1)
      result.push_back({points[0], exact_difference(points[1], points[0])});
    const auto u = m_element.is_normal_cone
        ? std::optional(simplest_rational_between(Exact_rational(m_part.range.begin), Exact_rational(m_part.range.end)))
        : Arc_parameter(m_graph, m_element.object).simplest_of_piece_within(m_part.range);
    if (u && (!m_element.is_normal_cone || !points.empty()))
      result.push_back(tangent_of_element(*u));
    return result;
  }

  // In a point with an exact parameter: of an arc, that of its piece.
  Line tangent_of_element(const Exact_rational& u) const
  {
    const Exact_pair normal = m_graph.exact_normal(m_element, u);
    return {m_graph.exact_point_at(m_element, u), {Exact_rational(-normal[1]), normal[0]}};
  }

  static Arc_end end_of_move(const Disk_branch& branch) { return {branch.move->arc, branch.move->parameter == 1}; }

  bool touches_element(const Line& line) const
  {
    if (!m_element.is_normal_cone)
      return squared_norm(m_part.jet.normal).inf() > 0 &&
          touches_line(m_graph, m_element.object, m_part.range, line.point, line.direction);
    const auto turn = [&](double u) {
      return certain_sign(
          dot(m_graph.element_jet(m_element, {u, u}).normal, interval_pair_of<Interval>(line.direction)));
    };
    return m_graph.vertices()[m_element.object].is_exact &&
        line.holds(m_graph.vertices()[m_element.object].exact_point) &&
        turn(m_part.range.begin) * turn(m_part.range.end) < 0;
  }

  bool touches(const Line& line, const Disk_branch& branch) const
  {
    if (branch.move)
      return is_tangent_in(line, end_of_move(branch));
    if (branch.footpoint.kind == Disk_footpoint::Kind::VERTEX)
      return is_exact_vertex(m_graph, branch.footpoint) &&
          line.holds(m_graph.vertices()[branch.footpoint.index].exact_point);
    const std::size_t arc = branch.footpoint.index;
    const auto touches_end = [&](bool is_end) {
      return branch.range.meets({is_end ? 1.0 : 0.0, is_end ? 1.0 : 0.0}) && is_tangent_in(line, {arc, is_end});
    };
    return branch.footpoint.kind == Disk_footpoint::Kind::ARC &&
        (touches_line(m_graph, arc, branch.range, line.point, line.direction) || touches_end(false) ||
         touches_end(true)) &&
        is_only_maximum(m_graph, m_curvature, m_part, {branch.footpoint, branch.range}, branch);
  }

  bool is_tangent_in(const Line& line, const Arc_end& end) const
  {
    return m_graph.is_exact(end) && line.holds(m_graph.arcs()[end.arc].at(end.is_end)) &&
        sign_of(exact_cross(line.direction, m_graph.direction(end))) == 0;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_LINE_H
