// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_NEAREST_SITES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_NEAREST_SITES_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Site_tree_2.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The sites that are nearest to a point: arcs without their ends, and vertices.

Boxes of the tree and ranges of arcs are split until all that are not certainly farther away than another one belong to one site, or are too small. A range on which the distance is monotone has its nearest point in one of its ends: if that is within the arc it is left to the next range, else to the vertex.
*/
class Nearest_sites_2
{
  static constexpr double least_width = 0x1p-40;

  enum class Kind { NODE, ARC, VERTEX };

  struct Candidate
  {
    Kind kind;
    std::size_t index;
    Range range{};
    Interval squared_distance{};
  };

  const Site_graph_2& m_graph;
  const Site_tree_2& m_tree;
  Interval_pair m_point;
  double m_most = std::numeric_limits<double>::infinity();   // bound of the least squared distance

public:
  Nearest_sites_2(const Site_graph_2& graph, const Site_tree_2& tree, const Interval_pair& point) : m_graph(graph), m_tree(tree), m_point(point) {}

  // The nearest sites: vertices are counted behind arcs. One, if it is proved; all that may be, if it is not.
  std::vector<std::size_t> operator()()
  {
    std::vector<Candidate> candidates;
    if (!m_tree.empty())
      add(candidates, {Kind::NODE, 0});
    bool is_split = true;
    while (is_split && !belong_to_one_site(candidates)) {
      is_split = false;
      std::vector<Candidate> parts;
      for (const Candidate& candidate : candidates)
        is_split = split(candidate, parts) || is_split;
      std::erase_if(parts, [&](const Candidate& candidate) { return candidate.squared_distance.inf() > m_most; });
      candidates = std::move(parts);
    }
    return sites_of(candidates);
  }

private:
  std::size_t site_of(const Candidate& candidate) const { return candidate.index + (candidate.kind == Kind::VERTEX ? m_graph.arcs().size() : 0); }

  std::vector<std::size_t> sites_of(const std::vector<Candidate>& candidates) const
  {
    std::vector<std::size_t> result;
    for (const Candidate& candidate : candidates)
      result.push_back(site_of(candidate));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Whether the nearest point is known to be on one arc inside, or a vertex.
  bool belong_to_one_site(const std::vector<Candidate>& candidates) const
  {
    return std::all_of(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
      const bool is_site = candidate.kind == Kind::VERTEX || (candidate.kind == Kind::ARC && candidate.range.begin > 0 && candidate.range.end < 1);
      return is_site && site_of(candidate) == site_of(candidates.front());
    });
  }

  void add(std::vector<Candidate>& candidates, Candidate candidate)
  {
    const Interval_pair box = candidate.kind == Kind::NODE   ? m_tree.node(candidate.index).box
                              : candidate.kind == Kind::ARC ? m_graph.arcs()[candidate.index].point(candidate.range)
                                                             : m_graph.vertices()[candidate.index].point;
    candidate.squared_distance = squared_norm(box - m_point);
    m_most = (std::min)(m_most, candidate.squared_distance.sup());   // there is a point in the box
    candidates.push_back(candidate);
  }

  // Adds the parts of a candidate, or itself; returns whether it has been split.
  bool split(const Candidate& candidate, std::vector<Candidate>& parts)
  {
    if (candidate.squared_distance.inf() > m_most)
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
    const Site_arc_2& arc = m_graph.arcs()[candidate.index];
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

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_NEAREST_SITES_2_H
