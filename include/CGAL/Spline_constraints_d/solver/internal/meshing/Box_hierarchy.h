// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_BOX_HIERARCHY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_BOX_HIERARCHY_H

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Finds the pairs of many small boxes that meet. Boxes are halved at the median of their longest extent, and parts are
compared whose own boxes meet. For triangles of a surface this is several times faster than box_self_intersection_d(),
which sorts along one axis after the other.
*/
class Box_hierarchy
{
  struct Item
  {
    CGAL::Bbox_3 box;
    std::size_t index;
  };
  struct Node
  {
    CGAL::Bbox_3 box;
    std::size_t begin, end; // of its items
    std::size_t second = 0; // the second child, behind the first one, which is next; 0: a leaf
  };

  std::vector<Item> m_items;
  std::vector<Node> m_nodes;

public:
  explicit Box_hierarchy(const std::vector<CGAL::Bbox_3>& boxes)
  {
    m_items.reserve(boxes.size());
    for (const CGAL::Bbox_3& box : boxes)
      m_items.push_back({box, m_items.size()});
    if (!boxes.empty())
      build(0, boxes.size());
  }

  // Calls f(i, k) for the indices of each pair of boxes that meet until it says true; whether it did.
  template <class Function>
  bool any_pair(const Function& f) const
  {
    return !m_nodes.empty() && any_within(0, f);
  }

private:
  std::size_t build(std::size_t begin, std::size_t end)
  {
    constexpr std::size_t most_items = 6;
    const std::size_t own = m_nodes.size();
    CGAL::Bbox_3 box;
    for (std::size_t i = begin; i < end; ++i)
      box += m_items[i].box;
    m_nodes.push_back({box, begin, end});
    if (end - begin > most_items) {
      const std::size_t middle = begin + (end - begin) / 2;
      halve(begin, middle, end, longest_axis(box));
      build(begin, middle);
      const std::size_t second = build(middle, end);
      m_nodes[own].second = second;
    }
    return own;
  }

  static int longest_axis(const CGAL::Bbox_3& box)
  {
    const double x = box.x_span(), y = box.y_span(), z = box.z_span();
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
  }

  void halve(std::size_t begin, std::size_t middle, std::size_t end, int axis)
  {
    const auto at = [&](std::size_t i) { return m_items.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [axis](const Item& a, const Item& b) {
      return a.box.min(axis) + a.box.max(axis) < b.box.min(axis) + b.box.max(axis);
    });
  }

  template <class Function>
  bool any_within(std::size_t node, const Function& f) const
  {
    const Node& own = m_nodes[node];
    if (own.second != 0)
      return any_within(node + 1, f) || any_within(own.second, f) || any_between(node + 1, own.second, f);
    for (std::size_t i = own.begin; i < own.end; ++i)
      for (std::size_t k = own.begin; k < i; ++k)
        if (CGAL::do_overlap(m_items[i].box, m_items[k].box) && f(m_items[i].index, m_items[k].index))
          return true;
    return false;
  }

  template <class Function>
  bool any_between(std::size_t first, std::size_t second, const Function& f) const
  {
    const Node &a = m_nodes[first], &b = m_nodes[second];
    if (!CGAL::do_overlap(a.box, b.box))
      return false;
    if (a.second != 0 && (b.second == 0 || a.end - a.begin >= b.end - b.begin))
      return any_between(first + 1, second, f) || any_between(a.second, second, f);
    if (b.second != 0)
      return any_between(first, second + 1, f) || any_between(first, b.second, f);
    for (std::size_t i = a.begin; i < a.end; ++i)
      if (CGAL::do_overlap(m_items[i].box, b.box))
        for (std::size_t k = b.begin; k < b.end; ++k)
          if (CGAL::do_overlap(m_items[i].box, m_items[k].box) && f(m_items[i].index, m_items[k].index))
            return true;
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_BOX_HIERARCHY_H
