// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_DISJOINT_SETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_DISJOINT_SETS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// Sets of indices that are united.
class Disjoint_sets
{
  mutable std::vector<std::size_t> m_parent;

public:
  explicit Disjoint_sets(std::size_t size) : m_parent(size)
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }

  void unite(std::size_t a, std::size_t b) { m_parent[root_of(b)] = root_of(a); }
  bool are_united(std::size_t a, std::size_t b) const { return root_of(a) == root_of(b); }

  // In the order of their first members.
  std::vector<std::vector<std::size_t>> sets() const
  {
    std::vector<std::vector<std::size_t>> result;
    std::map<std::size_t, std::size_t> place_of;
    for (std::size_t i = 0; i < m_parent.size(); ++i) {
      const auto [known, is_new] = place_of.emplace(root_of(i), result.size());
      if (is_new)
        result.emplace_back();
      result[known->second].push_back(i);
    }
    return result;
  }

private:
  std::size_t root_of(std::size_t i) const
  {
    while (m_parent[i] != i)
      i = m_parent[i] = m_parent[m_parent[i]];
    return i;
  }
};

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_DISJOINT_SETS_H
