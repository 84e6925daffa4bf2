// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_NEAREST_SITES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_NEAREST_SITES_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Fine_level.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_tree_2.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// What may be nearest to a point, without a distance.
struct Near_part
{
  Candidate_kind kind;
  std::size_t index;
  Range range{};
};

/*
The sites that are nearest to a point: arcs without their ends, and vertices.

Boxes of the tree and ranges of arcs are split until all that are not certainly farther away than another one belong to
one site, or are too small. A range on which the distance is monotone has its nearest point in one of its ends: if that
is within the arc it is left to the next range, else to the vertex. Where it is not, its derivative is small, so that
the mean value form encloses it well.
*/
template <Enclosing_number Interval>
class Nearest_sites
{
  using Interval_pair = std::array<Interval, 2>;

  using Kind = Candidate_kind;

  static constexpr double least_width = std::same_as<Interval, CGAL::Interval_nt<false>> ? 0x1p-40 : 0x1p-48;

  struct Candidate : Near_part
  {
    Interval squared_distance{};
  };

  const Site_graph_2<Interval>& m_graph;
  const Site_tree_2& m_tree;
  Interval_pair m_point;
  Interval m_least{0, std::numeric_limits<double>::infinity()};   // squared distance
  std::vector<Candidate> m_candidates;

public:
  // Among some parts of the sites.
  Nearest_sites(const Site_graph_2<Interval>& graph, const Site_tree_2& tree, const Exact_pair& point,
                const std::vector<Near_part>& parts)
    : m_graph(graph), m_tree(tree), m_point(interval_pair_of<Interval>(point))
  {
    for (const Near_part& part : parts)
      add(m_candidates, part);
    bool is_split = true;
    while (is_split && !belong_to_one_site(m_candidates)) {
      is_split = false;
      std::vector<Candidate> candidates;
      for (const Candidate& candidate : m_candidates)
        is_split = split(candidate, candidates) || is_split;
      std::erase_if(candidates, [&](const Candidate& candidate) { return is_farther(candidate); });
      m_candidates = std::move(candidates);
    }
  }

  // The nearest sites: vertices are counted behind arcs. One, if it is proved; all that may be, if it is not.
  std::vector<std::size_t> sites() const
  {
    std::vector<std::size_t> result;
    for (const Candidate& candidate : m_candidates)
      result.push_back(site_of(candidate));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // The parts of the sites in which the nearest points are.
  std::vector<Near_part> parts() const { return {m_candidates.begin(), m_candidates.end()}; }

private:
  std::size_t site_of(const Candidate& candidate) const
  {
    return candidate.index + (candidate.kind == Kind::VERTEX ? m_graph.arcs().size() : 0);
  }

  // Whether the nearest point is known to be on one arc inside, or a vertex.
  bool belong_to_one_site(const std::vector<Candidate>& candidates) const
  {
    return std::all_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
      const bool is_site = candidate.kind == Kind::VERTEX ||
          (candidate.kind == Kind::ARC && candidate.range.begin > 0 && candidate.range.end < 1);
      return is_site && site_of(candidate) == site_of(candidates.front());
    });
  }

  bool is_farther(const Candidate& candidate) const { return certain_sign(candidate.squared_distance - m_least) > 0; }

  void add(std::vector<Candidate>& candidates, const Near_part& part)
  {
    candidates.push_back({part, squared_distance(part)});
    // there is a point in the part
    m_least = common_part(m_least, hull(Interval(0), candidates.back().squared_distance));
  }

  Interval squared_distance(const Near_part& part) const
  {
    if (part.kind == Kind::NODE)
      return squared_norm(Interval_pair{m_tree.node(part.index).box[0], m_tree.node(part.index).box[1]} - m_point);
    if (part.kind == Kind::VERTEX)
      return squared_norm(m_graph.vertices()[part.index].point - m_point);
    const Site_arc_2<Interval>& arc = m_graph.arcs()[part.index];
    const double middle = part.range.middle();
    const Curve_jet<Interval> jet = arc.jet(part.range, 1);
    const Interval_pair way = jet[0] - m_point;
    return common_part(squared_norm(way),
                       squared_norm(arc.point({middle, middle}) - m_point) +
                           Interval(2) * dot(way, jet[1]) * (interval_of<Interval>(part.range) - Interval(middle)));
  }

  // Adds the parts of a candidate, or itself; returns whether it has been split.
  bool split(const Candidate& candidate, std::vector<Candidate>& parts)
  {
    if (is_farther(candidate))
      return false;
    switch (candidate.kind) {
    case Kind::NODE: split_node(m_tree.node(candidate.index), parts); return true;
    case Kind::ARC: return split_arc(candidate, parts);
    default: parts.push_back(candidate); return false;
    }
  }

  void split_node(const Site_tree_2::Node& node, std::vector<Candidate>& parts)
  {
    if (node.is_leaf()) {
      const Site_tree_2::Item& item = m_tree.item(node);
      add(parts, {item.is_arc ? Kind::ARC : Kind::VERTEX, item.index});
    } else
      for (const std::size_t child : node.children)
        add(parts, {Kind::NODE, child});
  }

  bool split_arc(const Candidate& candidate, std::vector<Candidate>& parts)
  {
    const auto& [begin, end] = candidate.range;
    const Site_arc_2<Interval>& arc = m_graph.arcs()[candidate.index];
    const int slope = certain_sign(dot(arc.point(candidate.range) - m_point, arc.direction_over(candidate.range)));
    if (slope != 0) {
      if (slope < 0 ? end == 1 : begin == 0)
        add(parts, {Kind::VERTEX, m_graph.vertex_of({candidate.index, slope < 0})});
      return true;
    }
    if (candidate.range.width() < least_width) {
      parts.push_back(candidate);
      return false;
    }
    const double middle = candidate.range.middle();
    add(parts, {Kind::ARC, candidate.index, {begin, middle}});
    add(parts, {Kind::ARC, candidate.index, {middle, end}});
    return true;
  }
};

// The sites that are nearest to a point: one, if it is proved; all that may be, if it is not. What doubles do not tell
// apart is decided on the fine level.
inline std::vector<std::size_t> nearest_sites(const Site_graph_2<>& graph, const Site_tree_2& tree,
                                              const Fine_level& fine_level, const Exact_pair& point)
{
  if (tree.empty())
    return {};
  const Nearest_sites<Interval> in_doubles(graph, tree, point, {{Candidate_kind::NODE, 0}});
  const std::vector<std::size_t> result = in_doubles.sites();
  return result.size() > 1 ? Nearest_sites<Fine_interval>(fine_level.graph(), tree, point, in_doubles.parts()).sites()
                           : result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_NEAREST_SITES_2_H
