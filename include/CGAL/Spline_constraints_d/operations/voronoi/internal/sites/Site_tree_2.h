// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_TREE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_TREE_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The arcs and isolated vertices of a graph in a binary tree of boxes.
*/
class Site_tree_2
{
public:
  struct Node
  {
    Interval_pair box;
    std::size_t first, last;                  // of the items
    std::size_t children[2] = {0, 0};         // none for a single item
    bool is_leaf() const { return last - first == 1; }
  };

  struct Item
  {
    bool is_arc;
    std::size_t index;
    Interval_pair box;
  };

private:
  std::vector<Item> m_items;
  std::vector<Node> m_nodes;   // the root comes first
  std::vector<double> m_squared_sizes;   // of the arcs
  double m_squared_size = 0;             // of everything

public:
  // Vertices on arcs are sites as well if that is asked for.
  explicit Site_tree_2(const Site_graph_2<>& graph, const std::vector<bool>& are_sites = {})
  {
    const Upward_rounding_guard guard;
    for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
      m_items.push_back({true, i, graph.arcs()[i].point(Range())});
      m_squared_sizes.push_back(squared_diagonal(m_items.back().box));
    }
    for (std::size_t i = 0; i < graph.vertices().size(); ++i)
      if (graph.vertices()[i].ends.empty() || (i < are_sites.size() && are_sites[i]))
        m_items.push_back({false, i, graph.vertices()[i].point});
    if (!m_items.empty())
      m_squared_size = squared_diagonal(m_nodes[build(0, m_items.size())].box);
  }

  bool empty() const { return m_items.empty(); }
  const Node& node(std::size_t i) const { return m_nodes[i]; }
  const Item& item(const Node& leaf) const { return m_items[leaf.first]; }

  // Not less than the squared distance of any two points of an arc, or of any two sites.
  double squared_size(std::size_t arc) const { return m_squared_sizes[arc]; }
  double squared_size() const { return m_squared_size; }

private:
  static double squared_diagonal(const Interval_pair& box)
  {
    const auto square = [](const Interval& x) { return CGAL::square(Interval(x.sup()) - Interval(x.inf())); };
    return (square(box[0]) + square(box[1])).sup();
  }

  static double middle(const Interval& x) { return x.inf() / 2 + x.sup() / 2; }

  std::size_t build(std::size_t first, std::size_t last)
  {
    Interval_pair box = m_items[first].box;
    for (std::size_t i = first + 1; i < last; ++i)
      box = hull(box, m_items[i].box);
    const std::size_t index = m_nodes.size();
    m_nodes.push_back({box, first, last});
    if (last - first == 1)
      return index;
    const std::size_t axis = box[0].sup() - box[0].inf() < box[1].sup() - box[1].inf(),
                      half = first + (last - first) / 2;
    std::nth_element(m_items.begin() + static_cast<std::ptrdiff_t>(first),
                     m_items.begin() + static_cast<std::ptrdiff_t>(half),
                     m_items.begin() + static_cast<std::ptrdiff_t>(last),
                     [axis](const Item& a, const Item& b) { return middle(a.box[axis]) < middle(b.box[axis]); });
    const std::size_t lower = build(first, half), upper = build(half, last);
    m_nodes[index].children[0] = lower;
    m_nodes[index].children[1] = upper;
    return index;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_TREE_2_H
