// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_DISK_CANDIDATES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_DISK_CANDIDATES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusps_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Hidden_arcs.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Separate_faces.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Singular_ends.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/compared_points.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_tree_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The candidates for the maximal disks of an element: those whose curvature may reach the largest one that is known to be
attained.
*/
template <Enclosing_number Interval = Common::Interval>
class Disk_candidates
{
  using Interval_pair = std::array<Interval, 2>;

  static constexpr double least_width = std::same_as<Interval, CGAL::Interval_nt<false>> ? 0x1p-46 : 0x1p-54,
                          least_gain = 4;
  // a fraction of a millisecond
  static constexpr unsigned bounds_between_checks = std::same_as<Interval, CGAL::Interval_nt<false>> ? 64 : 4;

  const Site_graph_2<Interval>& m_graph;
  const Site_tree_2& m_tree;
  Disk_curvature<Interval> m_curvature;
  Singular_ends<Interval> m_singular_ends;
  Hidden_arcs<Interval> m_hidden_arcs;
  Separate_faces<Interval> m_separate_faces;
  const Cusps_2* m_cusps;   // none, or those that are known
  mutable Regular_check m_check;
  mutable std::size_t m_number_of_bounds = 0;

public:
  static constexpr std::size_t most_candidates = 200;   // more are left only where too many cannot be told apart
  // Of candidates. More would be needed only where disks nearly have the curvature of a curve along much of that; with
  // 128 bits, what was proved in surveys needed less than 800.
  static constexpr std::size_t most_parts = std::same_as<Interval, CGAL::Interval_nt<false>> ? 4000 : 1000;

  Disk_candidates(const Site_graph_2<Interval>& graph, const Site_tree_2& tree,
                  const Disk_curvature<Interval>& curvature, const Cusps_2* cusps = nullptr,
                  Search_control* control = nullptr)
    : m_graph(graph), m_tree(tree), m_curvature(curvature), m_singular_ends(graph), m_hidden_arcs(graph),
      m_separate_faces(graph, curvature.scaled_sites() != nullptr), m_cusps(cusps),
      m_check(control, bounds_between_checks)
  {}

  // How many candidates have been bounded so far: where most of the work is.
  std::size_t number_of_bounds() const { return m_number_of_bounds; }

  std::vector<Disk_candidate<Interval>> all() const
  {
    std::vector<Disk_candidate<Interval>> result;
    if (!m_tree.empty())
      result.push_back({Disk_candidate<Interval>::Kind::NODE, 0});
    return result;
  }

  // A curvature of the disks of a part as a function of the parameter of the element: its value in the middle, its
  // derivative over the part, and a lower bound.
  struct Level
  {
    Interval at_middle, slope;
    double least = 0;
  };

  /*
  Removes candidates that cannot be touched over a part of the element, and splits others until they are not larger than
  what the part may see. A candidate is too low throughout, or lower than another one for each point of the part, or its
  highest point is its end, which it shares with a neighbour; or it is behind the element, or its arc, or seen from
  another face. Returns a curvature that is attained for all disks, of which one may be known.
  */
  double prune(const Element_part<Interval>& part, std::vector<Disk_candidate<Interval>>& candidates,
               double known_least = 0) const
  {
    return prune(part, candidates, known_least, nullptr)->least;
  }

  // The same if disks of less curvature than a wanted one do not matter. Nothing is returned, and candidates are not
  // told, if that is exceeded throughout.
  std::optional<double> prune(const Element_part<Interval>& part, std::vector<Disk_candidate<Interval>>& candidates,
                              const Level& wanted) const
  {
    const auto attained = prune(part, candidates, wanted.least, &wanted);
    return attained ? std::optional(attained->least) : std::nullopt;
  }

  // With a curvature of which one is known to be attained, and one that is wanted, or none.
  std::optional<Level> prune(const Element_part<Interval>& part, std::vector<Disk_candidate<Interval>>& candidates,
                             double known_least, const Level* wanted) const
  {
    const Element_part<Interval> middle = m_curvature.part(part.element, {part.range.middle(), part.range.middle()});
    const Interval shift = interval_of<Interval>(part.range) - Interval(part.range.middle());
    Level attained{Interval(0), Interval(0)};
    const std::optional<Curvature_bounds<Interval>> circle = m_curvature.of_own_circle(part);
    if (circle)
      attained = {m_curvature.of_own_circle(middle)->value, circle->du, circle->value.inf()};
    attained.least = (std::max)({attained.least, known_least, m_singular_ends.own_curvature(part)});
    const auto is_hidden = [&](const Disk_candidate<Interval>& candidate) {
      return m_cusps != nullptr && candidate.kind == Disk_candidate<Interval>::Kind::ARC &&
          m_cusps->hide(in_doubles(part), candidate.index, candidate.range, in_doubles(candidate.jet),
                        in_doubles(candidate.bounds.value));
    };
    const auto is_low = [&](const Disk_candidate<Interval>& candidate) {
      return is_too_low(candidate, attained, shift) || (wanted != nullptr && is_too_low(candidate, *wanted, shift)) ||
          is_hidden(candidate) || (!may_be_scaled(candidate) && m_singular_ends.is_behind(part, candidate)) ||
          (circle && !may_be_scaled(candidate) && m_curvature.side_of_own_circle(part, points(candidate)) > 0);
    };
    std::vector<Disk_candidate<Interval>> pool, parts = std::move(candidates);
    // those that may be touched by the smallest disks first: what they attain excludes others
    std::priority_queue<std::pair<double, std::size_t>> open;
    const auto add_parts = [&] {
      for (Disk_candidate<Interval>& candidate : parts) {
        bound(part, middle, candidate, attained);
        open.emplace(candidate.bounds.value.sup(), pool.size());
        pool.push_back(candidate);
      }
      parts.clear();
    };
    std::vector<std::size_t> settled;
    for (add_parts(); !open.empty();) {
      for (; !open.empty(); add_parts()) {
        if (wanted != nullptr &&
            (attained.at_middle - wanted->at_middle + (attained.slope - wanted->slope) * shift).inf() > 0)
          return std::nullopt;
        const std::size_t i = open.top().second;
        open.pop();
        if (is_low(pool[i]) ||
            (!may_be_scaled(pool[i]) &&
             (m_separate_faces.hold(part, middle, pool[i]) || m_hidden_arcs.hold(part, pool[i]))))
          continue;
        if (is_small(part, pool[i], attained.least) || open.size() + settled.size() > most_candidates ||
            pool.size() > most_parts)
          settled.push_back(i);
        else
          split(part, pool[i], parts);
      }
      std::erase_if(settled, [&](std::size_t i) { return is_low(pool[i]); });
      if (settled.size() <= most_candidates && pool.size() <= most_parts)
        std::erase_if(settled, [&](std::size_t i) {
          const bool was_too_early = !is_small(part, pool[i], attained.least);
          if (was_too_early)
            open.emplace(pool[i].bounds.value.sup(), i);
          return was_too_early;
        });
    }
    for (const std::size_t i : settled)
      candidates.push_back(pool[i]);
    erase_lower_on_small_arcs(part, middle, attained.least, candidates);
    return attained;
  }

  // Whether sites are scaled that a candidate holds.
  bool may_be_scaled(const Disk_candidate<Interval>& candidate) const
  {
    switch (candidate.kind) {
    case Disk_candidate<Interval>::Kind::NODE: return m_curvature.scaled_sites() != nullptr;
    case Disk_candidate<Interval>::Kind::VERTEX: return m_curvature.is_vertex_scaled(candidate.index);
    default: return m_curvature.is_arc_scaled(candidate.index);
    }
  }

  // A box around the points of a candidate.
  Interval_pair points(const Disk_candidate<Interval>& candidate) const
  {
    switch (candidate.kind) {
    case Disk_candidate<Interval>::Kind::NODE: return box(candidate.index);
    case Disk_candidate<Interval>::Kind::VERTEX: return m_graph.vertices()[candidate.index].point;
    default: return candidate.jet[0];
    }
  }

private:
  Interval_pair box(std::size_t node) const { return {m_tree.node(node).box[0], m_tree.node(node).box[1]}; }

  static bool is_too_low(const Disk_candidate<Interval>& candidate, const Level& attained, const Interval& shift)
  {
    const Curvature_bounds<Interval>& k = candidate.bounds;
    if (k.is_below_vertex || k.value.sup() < attained.least || k.value.sup() <= 0)
      return true;
    if (candidate.kind == Disk_candidate<Interval>::Kind::NODE)
      return false;
    if ((k.dv.inf() > 0 && candidate.range.end < 1) || (k.dv.sup() < 0 && candidate.range.begin > 0))
      return true;
    const Interval difference = candidate.at_middle - attained.at_middle + (k.du - attained.slope) * shift;
    if (candidate.kind == Disk_candidate<Interval>::Kind::VERTEX)
      return difference.sup() < 0;
    return (difference +
            k.factor * k.dv * (interval_of<Interval>(candidate.range) - Interval(candidate.range.middle())))
               .sup() < 0;
  }

  // Removes the parts of small arcs that are lower than a point of the same arc throughout: an end, or the one that is
  // about the highest. All curvatures are nearly the same there, and change more over the part than they differ.
  void erase_lower_on_small_arcs(const Element_part<Interval>& part, const Element_part<Interval>& middle, double least,
                                 std::vector<Disk_candidate<Interval>>& candidates) const
  {
    const auto is_on = [](const Disk_candidate<Interval>& c, std::size_t arc) {
      return c.kind == Disk_candidate<Interval>::Kind::ARC && c.index == arc;
    };
    std::vector<std::size_t> arcs;
    for (const Disk_candidate<Interval>& c : candidates)
      if (c.kind == Disk_candidate<Interval>::Kind::ARC && is_small_and_elsewhere(part, c.index, least) &&
          std::find(arcs.begin(), arcs.end(), c.index) == arcs.end())
        arcs.push_back(c.index);
    for (const std::size_t arc : arcs) {
      std::vector<Disk_candidate<Interval>> parts;
      std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(parts),
                   [&](const Disk_candidate<Interval>& c) { return is_on(c, arc); });
      if (parts.size() < 2)
        continue;
      const Disk_candidate<Interval>& highest = *std::max_element(
          parts.begin(), parts.end(), [](const Disk_candidate<Interval>& a, const Disk_candidate<Interval>& b) {
            return a.at_middle.inf() < b.at_middle.inf();
          });
      const auto curvature_at = [&](const Range& range) {
        return m_curvature(middle, arc, range, m_graph.arcs()[arc].jet(range));
      };
      for (const double v : {maximal_curvature<Interval>(curvature_at, highest.range).parameter, 0.0, 1.0})
        std::erase_if(candidates, [&](const Disk_candidate<Interval>& c) {
          return is_on(c, arc) && is_lower_than_point(part, arc, v, c.range, 0);
        });
    }
  }

  // Whether an arc is not that of the element, and much smaller than the disks.
  bool is_small_and_elsewhere(const Element_part<Interval>& part, std::size_t arc, double least) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    return is_small_beside_disks(part, m_tree.squared_size(arc), least) && !m_curvature.is_arc_scaled(arc) &&
        (element.is_normal_cone || element.object != arc);
  }

  // Whether points that are not farther away from each other than some squared distance are seen as one by disks of at
  // least some curvature, which may be as large as all the scene.
  bool is_small_beside_disks(const Element_part<Interval>& part, double squared_distance, double least) const
  {
    constexpr double most_share = 0x1p-20;   // of the square
    return squared_distance < most_share * m_tree.squared_size() &&
        squared_distance * least * least < most_share * squared_norm(part.jet.normal).inf();
  }

  bool is_lower_than_point(const Element_part<Interval>& part, std::size_t arc, double v, const Range& range,
                           int depth) const
  {
    constexpr int most_depth = 5;
    const int sign = range.meets({v, v}) ? 0 : compared_points(m_graph.arcs()[arc], {v, v}, range).sign(part);
    const auto is_lower = [&](const Range& r) { return is_lower_than_point(part, arc, v, r, depth + 1); };
    return sign > 0 ||
        (sign == 0 && depth < most_depth && !range.meets({v, v}) && is_lower({range.begin, range.middle()}) &&
         is_lower({range.middle(), range.end}));
  }

  // Bounds the curvature for a candidate, and learns from it what is attained.
  void bound(const Element_part<Interval>& part, const Element_part<Interval>& middle,
             Disk_candidate<Interval>& candidate, Level& attained) const
  {
    ++m_number_of_bounds;
    m_check();
    Curvature_bounds<Interval>& k = candidate.bounds;
    if (candidate.kind == Disk_candidate<Interval>::Kind::NODE) {
      k.value = m_curvature.through_box(part, box(candidate.index));
      return;
    }
    const Interval shift_u = interval_of<Interval>(part.range) - Interval(part.range.middle());
    if (candidate.kind == Disk_candidate<Interval>::Kind::VERTEX) {
      k = m_curvature(part, candidate.index);
      candidate.at_middle = m_curvature(middle, candidate.index).value;
      learn(candidate.at_middle, k.du, shift_u, attained);
    } else {
      const double v = candidate.range.middle();
      const Range point{v, v};
      const Curve_jet<Interval> jet = m_graph.arcs()[candidate.index].jet(point, 2);
      k = m_curvature(part, candidate.index, candidate.range, candidate.jet, middle, jet);
      const Curvature_bounds<Interval> center = m_curvature(middle, candidate.index, point, jet);
      const Interval shift_v = interval_of<Interval>(candidate.range) - Interval(v);
      candidate.at_middle = center.value;
      learn(center.value, m_curvature(part, candidate.index, point, jet, middle, jet).du, shift_u, attained);
      k.value = common_part(k.value, center.value + k.du * shift_u + k.factor * k.dv * shift_v);
      k.dv = common_part(k.dv, center.dv + k.duv * shift_u + k.dvv * shift_v);
      for (const double end : {0.0, 1.0})
        if (candidate.range.meets({end, end}) && k.value.sup() > attained.least)
          learn_from_end(part, middle, candidate.index, end, shift_u, attained);
    }
    if (std::isfinite(k.value.inf()))
      attained.least = (std::max)(attained.least, k.value.inf());
  }

  // An end of an arc may be much nearer than the middle of what is not split yet.
  void learn_from_end(const Element_part<Interval>& part, const Element_part<Interval>& middle, std::size_t arc,
                      double end, const Interval& shift_u, Level& attained) const
  {
    const Curve_jet<Interval> jet = m_graph.arcs()[arc].jet({end, end}, 2);
    learn(m_curvature(middle, arc, {end, end}, jet).value, m_curvature(part, arc, {end, end}, jet, middle, jet).du,
          shift_u, attained);
  }

  // Of a point that disks of the part pass through.
  static void learn(const Interval& at_middle, const Interval& slope, const Interval& shift_u, Level& attained)
  {
    if (!std::isfinite(slope.sup() - slope.inf()))
      return;
    if (at_middle.inf() > attained.at_middle.inf()) {
      attained.at_middle = at_middle;
      attained.slope = slope;
    }
    if (const double least = (at_middle + slope * shift_u).inf(); std::isfinite(least))
      attained.least = (std::max)(attained.least, least);
  }

  bool is_small(const Element_part<Interval>& part, const Disk_candidate<Interval>& candidate, double least) const
  {
    if (candidate.kind != Disk_candidate<Interval>::Kind::ARC)
      return candidate.kind == Disk_candidate<Interval>::Kind::VERTEX;
    if (candidate.range.width() < (std::max)(least_width, way_of_footpoint(part, candidate.bounds)))
      return true;
    const auto size = [](const auto& p) { return (std::max)(p[0].sup() - p[0].inf(), p[1].sup() - p[1].inf()); };
    // Where the touching point moves by a and the normal turns by b, the other end of the diameter moves by a + 2 r b,
    // and that is no more than the curves are large; r |N| = |N| / k.
    const double normal = std::sqrt(squared_norm(part.jet.normal).sup()),
                 turn = size(part.jet.normal) / (std::max)(least, normal / size(m_tree.node(0).box));
    if (is_small_at_normal_cone(part, candidate, least))
      return false;
    const double seen = size(part.jet.point) +
        turn *
            relevance_of_turn(part, candidate.bounds,
                              least > 0 && m_graph.arcs()[candidate.index].is_on_line_or_circle());
    return size(candidate.jet[0]) <= seen && candidate.range.width() <= 0.5 && !is_decided_by_parts(part, candidate);
  }

  // Whether an arc that begins or ends in the vertex of a normal cone is much smaller than the disks, and not known to
  // be out of reach: most of it is, when it is divided, as disks through its points are small.
  bool is_small_at_normal_cone(const Element_part<Interval>& part, const Disk_candidate<Interval>& candidate,
                               double least) const
  {
    constexpr double least_width = 0x1p-6;
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (!element.is_normal_cone || candidate.range.width() <= least_width ||
        (m_graph.vertex_of({candidate.index, false}) != element.object &&
         m_graph.vertex_of({candidate.index, true}) != element.object))
      return false;
    return is_small_beside_disks(part, squared_norm(candidate.jet[0] - part.jet.point).sup(), least);
  }

  // Whether more is learnt of the derivative in the parts of a candidate than in parts of the element: of small curves
  // far away.
  static bool is_decided_by_parts(const Element_part<Interval>& part, const Disk_candidate<Interval>& candidate)
  {
    const Curvature_bounds<Interval>& k = candidate.bounds;
    const auto size = [](const Interval& x) { return (std::max)(-x.inf(), x.sup()); };
    const double by_parts = size(k.dvv) * candidate.range.width(), by_element = size(k.duv) * part.range.width();
    return certain_sign(k.dv) == 0 && !(k.dvv.sup() < 0) && std::isfinite(by_parts) &&
        by_parts > least_gain * by_element;
  }

  // About how far the footpoint moves over the part, if that is known: far where disks are nearly half-planes, and a
  // segment nearly on their border.
  static double way_of_footpoint(const Element_part<Interval>& part, const Curvature_bounds<Interval>& k)
  {
    constexpr double most_ratio = 16;   // of bounds of k_vv
    const double speed = (std::max)(-k.duv.inf(), k.duv.sup()) / -k.dvv.sup();
    return k.dvv.sup() < 0 && k.dvv.inf() >= most_ratio * k.dvv.sup() && std::isfinite(speed)
        ? part.range.width() * speed
        : 0;
  }

  // Where nothing is known of the curvature, beside the element, only the way of the touching point counts: to split
  // the part would not help. Where the candidate may have several maxima it is split as well, the more so the smaller
  // the part is already.
  static double relevance_of_turn(const Element_part<Interval>& part, const Curvature_bounds<Interval>& k,
                                  bool is_on_line_or_circle)
  {
    if (!std::isfinite(k.value.sup()))
      return 0;
    const bool has_one_maximum = is_on_line_or_circle || certain_sign(k.dv) != 0 || k.dvv.sup() < 0;
    return has_one_maximum ? 1 : std::clamp(64 * part.range.width(), 1.0 / 64, 0.25);
  }

  void split(const Element_part<Interval>& part, const Disk_candidate<Interval>& candidate,
             std::vector<Disk_candidate<Interval>>& parts) const
  {
    const auto add_arc = [&](std::size_t arc, const Range& range) {
      parts.push_back({Disk_candidate<Interval>::Kind::ARC, arc, range, m_graph.arcs()[arc].jet(range)});
    };
    if (candidate.kind == Disk_candidate<Interval>::Kind::ARC) {
      add_arc(candidate.index, {candidate.range.begin, candidate.range.middle()});
      add_arc(candidate.index, {candidate.range.middle(), candidate.range.end});
      return;
    }
    const Site_tree_2::Node& node = m_tree.node(candidate.index);
    if (!node.is_leaf())
      for (const std::size_t child : node.children)
        parts.push_back({Disk_candidate<Interval>::Kind::NODE, child});
    else if (const Site_tree_2::Item& item = m_tree.item(node); !item.is_arc) {
      if (const Oriented_element<Interval>& element = m_graph.elements()[part.element];
          !element.is_normal_cone || element.object != item.index)
        parts.push_back({Disk_candidate<Interval>::Kind::VERTEX, item.index});
    } else if (m_curvature.is_arc_scaled(item.index) ||
               !(m_graph.is_never_touched(part.element, item.index) || m_separate_faces.hold(part.element, item.index)))
      add_arc(item.index, Range());
  }
};

// Takes those parts of an arc that are connected with a range, and extends that. Returns whether there are any.
template <Enclosing_number Interval, class Is_taken>
bool take_connected(std::vector<Disk_candidate<Interval>>& candidates, Range& range, const Is_taken& is_taken)
{
  const std::size_t size = candidates.size();
  for (bool is_any = true; is_any;) {
    const auto next = std::find_if(candidates.begin(), candidates.end(), [&](const auto& c) {
      return c.kind == Candidate_kind::ARC && c.range.meets(range) && is_taken(c);
    });
    is_any = next != candidates.end();
    if (is_any) {
      range = united(range, next->range);
      candidates.erase(next);
    }
  }
  return candidates.size() < size;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_DISK_CANDIDATES_H
