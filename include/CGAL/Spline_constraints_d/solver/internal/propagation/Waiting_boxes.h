// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_WAITING_BOXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_WAITING_BOXES_H

#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Boxes that wait to be looked at, the last one first: one after the other in memory.
class Waiting_boxes
{
public:
  // The unknown whose range was split, or -1, and how often.
  struct Origin
  {
    int split_unknown, depth;
  };
  // Of the domain.
  static double share_of(const Origin& origin) { return std::ldexp(1.0, -origin.depth); }

private:
  std::vector<Interval> m_ranges;
  std::vector<Origin> m_origins;

public:
  std::size_t size() const { return m_origins.size(); }
  bool is_empty() const { return m_origins.empty(); }

  void push(const Box_of_ranges& box, const Origin& origin)
  {
    m_ranges.insert(m_ranges.end(), box.begin(), box.end());
    m_origins.push_back(origin);
  }

  // In the same order.
  void push(const Waiting_boxes& boxes)
  {
    m_ranges.insert(m_ranges.end(), boxes.m_ranges.begin(), boxes.m_ranges.end());
    m_origins.insert(m_origins.end(), boxes.m_origins.begin(), boxes.m_origins.end());
  }

  Origin pop(Box_of_ranges& box)
  {
    const auto first = m_ranges.end() - static_cast<std::ptrdiff_t>(m_ranges.size() / m_origins.size());
    box.assign(first, m_ranges.end());
    m_ranges.erase(first, m_ranges.end());
    const Origin result = m_origins.back();
    m_origins.pop_back();
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_WAITING_BOXES_H
