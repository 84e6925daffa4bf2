// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_FOOTPOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_FOOTPOINTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/compared_points.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/exact_disk_curvatures.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_clusters.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/touches_line.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The branches of footpoints over a part of an element that are left when candidates have been pruned.
*/
template <Enclosing_number Interval>
class Basic_disk_footpoints
{
  using Curve_jet = Basic_curve_jet<Interval>;
  using Site_arc_2 = Basic_site_arc_2<Interval>;
  using Site_graph_2 = Basic_site_graph_2<Interval>;
  using Oriented_element = Basic_oriented_element<Interval>;
  using Element_part = Basic_element_part<Interval>;
  using Nearly_smooth_continuation = Basic_nearly_smooth_continuation<Interval>;
  using Curvature_bounds = Basic_curvature_bounds<Interval>;
  using Disk_curvature = Basic_disk_curvature<Interval>;
  using Disk_candidate = Basic_disk_candidate<Interval>;
  using Disk_clusters = Basic_disk_clusters<Interval>;
  using Curvature_expansion = Basic_curvature_expansion<Interval>;

  using Cluster = Disk_clusters::Cluster;
  using End_state = Disk_clusters::End_state;

  const Site_graph_2& m_graph;
  const Disk_curvature& m_curvature;
  const Element_part& m_part;
  const Oriented_element& m_element;
  Disk_clusters m_clusters;
  std::vector<Disk_branch> m_branches;
  bool m_are_known;

public:
  Basic_disk_footpoints(const Site_graph_2& graph, const Disk_curvature& curvature, Disk_slopes& slopes,
                        const Element_part& part, const std::vector<Disk_candidate>& candidates, double least)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_element(graph.elements()[part.element]),
      m_clusters(graph, curvature, slopes, part, candidates, least), m_are_known(m_clusters.are_known())
  {
    if (!m_are_known)
      return;
    for (const Disk_candidate& candidate : candidates)
      if (candidate.kind == Disk_candidate::Kind::VERTEX)
        m_branches.push_back(branch_to(Disk_footpoint::Kind::VERTEX, candidate.index));
    for (const Cluster& cluster : m_clusters)
      if (!add_nearly_smooth_joint(cluster))
        add_branches(cluster);
    if (!(least > 0))
      m_branches.push_back(Disk_branch());
    const auto is_inside = [&](const Disk_candidate& c) {
      return curvature.side_of_own_circle(
                 part,
                 c.kind == Disk_candidate::Kind::VERTEX
                     ? graph.vertices()[c.index].point
                     : graph.arcs()[c.index].point(Range{c.range.middle(), c.range.middle()})) < 0;
    };
    if (const auto circle = curvature.of_own_circle(part);
        circle && circle->value.sup() >= least && std::none_of(candidates.begin(), candidates.end(), is_inside))
      m_branches.push_back(branch_to(Disk_footpoint::Kind::CIRCLE, m_element.object));
  }

  // Whether each branch is a function.
  bool are_known() const { return m_are_known; }

  // The branches, but for those that are below another one throughout the part. Those that move are the greater one of
  // two footpoints.
  std::vector<Disk_branch> highest() const
  {
    if (m_branches.size() < 2)
      return m_branches;
    std::vector<std::pair<Disk_branch, std::vector<Curvature_expansion>>> highest;
    for (const Disk_branch& branch : m_branches) {
      const std::pair next(branch,
                           branch.move ? std::vector{expansion(branch.move->positive), expansion(branch.move->negative)}
                                       : std::vector{expansion(branch)});
      bool is_below = false;
      for (auto other = highest.begin(); other != highest.end() && !is_below;) {
        const int order = order_over_part(next, *other);
        is_below = order < 0;
        other = order > 0 ? highest.erase(other) : other + 1;
      }
      if (!is_below)
        highest.push_back(next);
    }
    std::vector<Disk_branch> result;
    for (const auto& [branch, curvatures] : highest)
      result.push_back(branch);
    return result;
  }

  int sign_of_move(const Disk_branch& branch, double u) const
  {
    const Element_part point = m_curvature.part(m_part.element, {u, u});
    if (branch.move->joined_ends)
      return common_sign(*branch.move->joined_ends, [&](const Arc_end& end) { return at(point, end).dv; });
    const double v = branch.move->event == Disk_event::TIP ? u : branch.move->parameter;
    return certain_sign(at(point, branch.move->arc, {v, v}).dv);
  }

  bool is_sign_of_move_monotone(const Disk_branch& branch) const
  {
    if (branch.move->joined_ends)
      return are_footpoints_monotone(branch);
    if (branch.move->event != Disk_event::TIP)
      return certain_sign(at(m_part, branch.move->arc, {branch.move->parameter, branch.move->parameter}).duv) != 0;
    const Curvature_bounds k = at(m_part, branch.move->arc, m_part.range);
    return certain_sign(k.duv + k.dvv) != 0;
  }

  // Whether the footpoint moves into the end of its arc at the begin or end of the element.
  bool is_move_at_end(const Disk_branch& branch, bool end) const
  {
    return branch.move->event == Disk_event::JOINT && !branch.move->joined_ends &&
        is_touched_at_end({branch.move->arc, branch.move->parameter == 1}, end);
  }

  // Whether the footpoint stays what it is, or goes over into the end of an arc, or into the next arc, at most once in
  // the part.
  bool moves_once(const Disk_branch& branch) const
  {
    return !branch.move ||
        (branch.move->event == Disk_event::JOINT && !branch.move->joined_ends && is_sign_of_move_monotone(branch));
  }

  // What is touched in a point of the part, if that is certain.
  std::optional<Located_footpoint> footpoint_at(const Disk_branch& branch, double u) const
  {
    if (!branch.move)
      return branch;
    const int sign = sign_of_move(branch, u);
    return sign == 0 ? std::nullopt : std::optional(sign > 0 ? branch.move->positive : branch.move->negative);
  }

  // Whether two branches have the same curvature at the begin or end of the element, by exact computation. They do not
  // move, or there.
  bool are_equal_at_end(const Disk_branch& a, const Disk_branch& b, bool end) const
  {
    const auto x = exact_curvature_at_end(a, end), y = exact_curvature_at_end(b, end);
    return (x && y && *x == *y) || are_mirrored_at_end(a, b, end);
  }

  // The sign of the difference of the curvatures of two branches.
  int compare(const Disk_branch& a, const Disk_branch& b, double u) const
  {
    const Element_part part = m_curvature.part(m_part.element, {u, u});
    const auto x = footpoint_at(a, u), y = footpoint_at(b, u);
    if (!x || !y)
      return 0;
    const auto sign_in = [](const Curvature_expansion& difference) { return certain_sign(difference.at_middle); };
    if (const int order_of_points = sign_in(difference_of_points(m_graph, m_curvature, part, *x, *y));
        order_of_points != 0)
      return order_of_points;
    const int order = certain_sign(maximum(part, *x) - maximum(part, *y));
    return order != 0 ? order : sign_by_tangent_disks(m_graph, m_curvature, part, *x, *y, sign_in);
  }

  // The footpoints that disks have before and after one that touches all of them: their curvature there grows least and
  // most.
  std::optional<std::pair<Disk_branch, Disk_branch>>
  before_and_after_common_disk(const std::vector<Disk_branch>& branches) const
  {
    std::vector<Interval> slopes;
    for (const Disk_branch& branch : branches)
      slopes.push_back(slope(branch));
    const auto first_of = [&](const auto& is_less) {
      for (std::size_t i = 0; i < branches.size(); ++i) {
        std::size_t greater = 0;
        for (std::size_t j = 0; j < branches.size(); ++j)
          greater += i != j && is_less(slopes[i], slopes[j]);
        if (greater + 1 == branches.size())
          return i;
      }
      return branches.size();
    };
    const std::size_t before = first_of([](const Interval&a, const Interval&b) { return a.sup() < b.inf(); }),
                      after = first_of([](const Interval&a, const Interval&b) { return a.inf() > b.sup(); });
    if (before == branches.size() || after == branches.size())
      return std::nullopt;
    return std::pair(branches[before], branches[after]);
  }

  // By the first derivatives, and where these are nearly the same, as for points next to each other, by the second
  // ones.
  bool is_difference_monotone(const Disk_branch& a, const Disk_branch& b) const
  {
    if (!a.move && !b.move && certain_sign(difference_of_points(m_graph, m_curvature, m_part, a, b).slope) != 0)
      return true;
    const auto sign_in = [shift = shift_from_middle()](const Curvature_expansion& difference) {
      return certain_sign(difference.derivative(shift));
    };
    return certain_sign(slope(a) - slope(b)) != 0 ||
        (!a.move && !b.move &&
         (sign_in(expansion(a) - expansion(b)) != 0 ||
          sign_by_tangent_disks(m_graph, m_curvature, m_part, a, b, sign_in) != 0));
  }

private:
  // Which of two branches has the greater curvature throughout the part, 0 if that is not certain.
  int order_over_part(const std::pair<Disk_branch, std::vector<Curvature_expansion>>& a,
                      const std::pair<Disk_branch, std::vector<Curvature_expansion>>& b) const
  {
    const auto sign_in = [shift = shift_from_middle()](const Curvature_expansion& difference) {
      return difference.sign(shift);
    };
    const bool do_move = a.first.move || b.first.move;
    if (const int order = do_move ? 0 : sign_in(difference_of_points(m_graph, m_curvature, m_part, a.first, b.first));
        order != 0)
      return order;
    const auto is_below = [&](const auto& lower, const auto& upper) {
      return std::all_of(lower.begin(), lower.end(), [&](const auto& x) {
        return std::any_of(upper.begin(), upper.end(), [&](const auto& y) { return sign_in(x - y) < 0; });
      });
    };
    if (is_below(a.second, b.second))
      return -1;
    if (is_below(b.second, a.second))
      return 1;
    return do_move ? 0 : sign_by_tangent_disks(m_graph, m_curvature, m_part, a.first, b.first, sign_in);
  }

  Curvature_bounds at(const Element_part& part, std::size_t arc, const Range& range) const
  {
    return m_curvature(part, arc, range, m_graph.arcs()[arc].jet(range));
  }

  Curvature_bounds at(const Element_part& part, const Arc_end& end) const
  {
    return at(part, end.arc, {end.parameter(), end.parameter()});
  }

  // The sign of numbers that belong to two ends, on the way from the arc of the first to that of the second one, if it
  // is the same.
  template <class Number_at>
  static int common_sign(const std::array<Arc_end, 2>& ends, const Number_at& number_at)
  {
    const int first = certain_sign(number_at(ends[0])) * (ends[0].is_end ? 1 : -1),
              second = certain_sign(number_at(ends[1])) * (ends[1].is_end ? -1 : 1);
    return first == second ? first : 0;
  }

  // Whether k_uv has one sign on both arcs: the point where k is greatest moves along them in one direction.
  bool are_footpoints_monotone(const Disk_branch& branch) const
  {
    const auto& [event, arc, parameter, positive, negative, ends, between] = *branch.move;
    return common_sign(*ends, [&, &ends = ends, &negative = negative, &positive = positive](const Arc_end& end) {
      const Range& range = (end == (*ends)[0] ? negative : positive).range;
      return at(m_part, end.arc, range).duv;
    }) != 0;
  }

  // Disks that may touch two arcs that join nearly smoothly: the footpoint goes over from one to the other. Returns
  // whether a cluster belongs to such a pair.
  bool add_nearly_smooth_joint(const Cluster& cluster)
  {
    for (const bool end : {false, true}) {
      const Arc_end own{cluster.arc, end};
      const auto& next = m_graph.nearly_smooth_continuation(own);
      const Cluster* other = next && cluster.touches(end) &&
              m_curvature.is_arc_scaled(cluster.arc) == m_curvature.is_arc_scaled(next->end.arc)
          ? m_clusters.cluster_at(next->end)
          : nullptr;
      if (other == nullptr || cluster.arc == other->arc || cluster.ends[end] != End_state::UNKNOWN ||
          other->ends[next->end.is_end] != End_state::UNKNOWN)
        continue;
      m_are_known = m_are_known && !is_part_at(m_graph.vertex_of(own)) && cluster.ends[!end] != End_state::UNKNOWN &&
          other->ends[!next->end.is_end] != End_state::UNKNOWN;
      if (cluster.arc < other->arc)
        add_nearly_smooth_joint(cluster, *other, own, *next);
      return true;
    }
    return false;
  }

  void add_nearly_smooth_joint(const Cluster& cluster, const Cluster& other, const Arc_end& own,
                               const Nearly_smooth_continuation& next)
  {
    const int side = side_of_disks(cluster, own, false), other_side = side_of_disks(other, next.end, true);
    m_are_known = m_are_known && side != 0 && side == other_side;
    const bool is_vertex_touched = (side > 0) == next.is_left_reflex;
    Disk_branch branch;
    static_cast<Located_footpoint&>(branch) = footpoint_with(cluster);
    branch.move = {is_vertex_touched ? Disk_event::JOINT : Disk_event::CROSSING,
                   own.arc,
                   own.parameter(),
                   footpoint_with(other),
                   footpoint_with(cluster),
                   std::array{own, next.end}};
    if (is_vertex_touched)
      branch.move->between = Located_footpoint{{Disk_footpoint::Kind::VERTEX, m_graph.vertex_of(own)}};
    m_branches.push_back(branch);
  }

  // Whether the part ends in a vertex.
  bool is_part_at(std::size_t vertex) const
  {
    if (m_element.is_normal_cone)
      return m_element.object == vertex;
    return (m_part.range.begin == 0 && m_graph.vertex_of({m_element.object, false}) == vertex) ||
        (m_part.range.end == 1 && m_graph.vertex_of({m_element.object, true}) == vertex);
  }

  // The side on which the disks are that touch an arc, seen on the way to one of its ends, or away from it: 1 left, -1
  // right; 0 if that is not certain. It is that of the point in which they touch the element.
  int side_of_disks(const Cluster& cluster, const Arc_end& end, bool is_away) const
  {
    const Curve_jet y = m_graph.arcs()[cluster.arc].jet(cluster.range, 1);
    return certain_sign(dot(turned_left(y[1]), m_part.jet.point - y[0])) * (end.is_end != is_away ? 1 : -1);
  }

  void add_branches(const Cluster& cluster)
  {
    if (cluster.has_inner_maximum())
      add_inner_maximum(cluster);
    else
      for (const bool end : {false, true})
        if (cluster.ends[end] == End_state::MAXIMUM && cluster.touches(end))
          add_vertex({cluster.arc, end});
  }

  static Disk_branch branch_to(Disk_footpoint::Kind kind, std::size_t index)
  {
    Disk_branch result;
    result.footpoint = {kind, index};
    return result;
  }

  Located_footpoint footpoint_with(const Cluster& cluster) const
  {
    const bool is_own = !m_element.is_normal_cone && m_element.object == cluster.arc;
    return {{Disk_footpoint::Kind::ARC, cluster.arc,
             !is_own                                       ? 0
                 : cluster.range.begin >= m_part.range.end ? 1
                 : cluster.range.end <= m_part.range.begin ? -1
                                                           : 0},
            cluster.range,
            cluster.least,
            cluster.corner};
  }

  void add_inner_maximum(const Cluster& cluster)
  {
    Disk_branch branch;
    static_cast<Located_footpoint&>(branch) = footpoint_with(cluster);
    bool is_added_there = false;
    for (const bool end : {false, true})
      if (cluster.ends[end] == End_state::UNKNOWN) {
        const auto beyond = footpoint_beyond({cluster.arc, end});
        if (!beyond)
          continue;
        m_are_known = m_are_known && !branch.move;
        branch.move = {Disk_event::JOINT, cluster.arc, end ? 1.0 : 0.0, end ? *beyond : branch, end ? branch : *beyond};
        is_added_there = is_added_there ||
            (beyond->footpoint.kind == Disk_footpoint::Kind::ARC && is_before(beyond->footpoint.index, cluster.arc));
      }
    if (is_added_there)   // not before both ends have been looked at: the footpoint may go over in only one of them
      return;
    const bool is_own = !m_element.is_normal_cone && m_element.object == cluster.arc;
    if (is_own && branch.footpoint.side == 0) {
      m_are_known = m_are_known && !branch.move;
      const int sign = certain_sign(at(m_part, cluster.arc, m_part.range).dv);
      const Located_footpoint after{
          {Disk_footpoint::Kind::ARC, cluster.arc, 1}, cluster.range, cluster.least, cluster.corner},
          before{{Disk_footpoint::Kind::ARC, cluster.arc, -1}, cluster.range, cluster.least, cluster.corner};
      if (sign != 0)
        branch.footpoint.side = sign;
      else
        branch.move = {Disk_event::TIP, cluster.arc, 0, after, before};
    }
    m_branches.push_back(branch);
  }

  // Joints belong to one of their arcs: if possible to that of the element, for which bounds are tight.
  bool is_before(std::size_t a, std::size_t b) const
  {
    const auto is_other = [&](std::size_t arc) { return m_element.is_normal_cone || arc != m_element.object; };
    return std::pair(is_other(a), a) < std::pair(is_other(b), b);
  }

  // What disks touch if the maximum is not in the arc, but beyond its end; nothing if the maximum cannot be there.
  std::optional<Located_footpoint> footpoint_beyond(const Arc_end& end)
  {
    const auto continuation = m_curvature.continuation(m_part, end);
    const std::size_t vertex = m_graph.vertex_of(end);
    if (!continuation)
      return Located_footpoint{{Disk_footpoint::Kind::VERTEX, vertex}};
    const Cluster* next = m_clusters.cluster_at(*continuation);
    if (next == nullptr || next->ends[continuation->is_end] == End_state::MAXIMUM ||
        next->ends[continuation->is_end] == End_state::TOO_LOW)
      return std::nullopt;
    if (next->ends[continuation->is_end] == End_state::NOT_A_MAXIMUM)
      m_are_known = false;
    return footpoint_with(*next);
  }

  void add_vertex(const Arc_end& end)
  {
    const std::size_t vertex = m_graph.vertex_of(end);
    for (const Arc_end& other : m_graph.vertices()[vertex].ends) {
      if (m_curvature.is_arc_scaled(other.arc) != m_curvature.is_arc_scaled(end.arc))
        continue;
      const Cluster* cluster = m_clusters.cluster_at(other);
      if (cluster != nullptr ? cluster->ends[other.is_end] != End_state::MAXIMUM
                             : certain_sign(at(m_part, other).dv) * (other.is_end ? -1 : 1) > 0)
        return;   // the maximum is in the other arc, or it has the vertex as a possible move
    }
    if (const auto continuation = m_curvature.continuation(m_part, end);
        continuation && m_clusters.cluster_at(*continuation) == nullptr)
      return;   // it is too low there
    if (m_element.is_normal_cone && m_element.object == vertex) {
      m_are_known = false;
      return;
    }
    const Disk_branch branch = branch_to(Disk_footpoint::Kind::VERTEX, vertex);
    const bool is_known = std::any_of(m_branches.begin(), m_branches.end(),
                                      [&](const Disk_branch& b) { return b.footpoint == branch.footpoint; });
    if (!is_known &&
        (m_curvature.is_vertex_scaled(vertex) || !m_graph.is_vertex_on_line_or_circle_of(m_part.element, vertex)))
      m_branches.push_back(branch);
  }

  Interval slope(const Disk_branch& branch) const
  {
    const auto slope_with = [&](const Located_footpoint& footpoint) {
      return slope_of_largest_curvature(m_graph, m_curvature, m_part, footpoint);
    };
    return branch.move ? hull(slope_with(branch.move->negative), slope_with(branch.move->positive))
                       : slope_with(branch);
  }

  Interval maximum(const Element_part& part, const Located_footpoint& footpoint) const
  {
    return largest_curvature(m_graph, m_curvature, part, footpoint).curvature;
  }

  Element_part end_of_element(bool end) const
  {
    return m_curvature.part(m_part.element, end ? Range{1, 1} : Range{0, 0});
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
    const Element_part point = end_of_element(end);
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
    const Site_arc_2& arc = m_graph.arcs()[branch.footpoint.index];
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
      return is_move_at_end(branch, end) ? std::optional(Arc_end{branch.move->arc, branch.move->parameter == 1})
                                         : std::nullopt;
    for (const bool is_end : {false, true})
      if (const Arc_end other{branch.footpoint.index, is_end}; branch.footpoint.kind == Disk_footpoint::Kind::ARC &&
          (is_end ? branch.range.end == 1 : branch.range.begin == 0) && is_touched_at_end(other, end) &&
          at(end_of_element(end), other).dvv.sup() < 0)
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
      const Site_arc_2& own = m_graph.arcs()[m_element.object];
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
    const Site_arc_2& arc = m_graph.arcs()[footpoint.index];
    if (arc.is_straight())
      return curvature_of_disk_on_line(arc.at(0), arc.at(1), p, n, factor);
    return arc.circle() && factor == 1 ? curvature_of_disk_on_circle(arc.circle()->first, arc.circle()->second, p, n)
                                       : std::nullopt;
  }

  Interval shift_from_middle() const { return interval_of<Interval>(m_part.range) - Interval(m_part.range.middle()); }

  Curvature_expansion expansion(const Located_footpoint& footpoint) const
  {
    return curvature_expansion(m_graph, m_curvature, m_part, footpoint);
  }
};

using Disk_footpoints = Basic_disk_footpoints<Interval>;

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_FOOTPOINTS_H
