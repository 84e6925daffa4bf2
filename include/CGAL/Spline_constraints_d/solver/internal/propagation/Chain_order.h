// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHAIN_ORDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHAIN_ORDER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Constraints one after the other so that few unknowns are at the same time in what is before and what is after a place
(the frontier of an elimination): begun with the shortest constraint, then always the one that leaves the smallest
frontier. Where all frontiers are small, the constraints are a chain.
*/
class Chain_order
{
  std::vector<int> m_order;
  std::size_t m_largest_frontier = 0;

public:
  // In O(m^2 k) for m constraints in k unknowns each.
  Chain_order(const std::vector<Polynomial_constraint>& constraints, int dimension);

  // The places of the constraints.
  const std::vector<int>& order() const { return m_order; }
  std::size_t largest_frontier() const { return m_largest_frontier; }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Chain_order::Chain_order(const std::vector<Polynomial_constraint>& constraints,
                                                        int dimension)
{
  std::vector<std::vector<int>> unknowns;
  std::vector<int> uses(dimension, 0);
  for (const auto& [polynomial, relation] : constraints)
    for (const int j : unknowns.emplace_back(polynomial.variables()))
      ++uses[j];
  std::vector<char> is_done(constraints.size(), 0), is_in_frontier(dimension, 0);
  long frontier = 0;
  // how much the frontier grows by a constraint: what it begins, without what it ends
  const auto growth = [&](std::size_t i) {
    long result = 0;
    for (const int j : unknowns[i])
      result += (is_in_frontier[j] == 0 ? 1 : 0) - (uses[j] == 1 ? 1 : 0);
    return result;
  };
  while (m_order.size() < constraints.size()) {
    std::size_t next = constraints.size();
    long least = 0;
    for (std::size_t i = 0; i < constraints.size(); ++i)
      if (is_done[i] == 0)
        if (const long own = growth(i); next == constraints.size() || own < least) {
          next = i;
          least = own;
        }
    is_done[next] = 1;
    m_order.push_back(static_cast<int>(next));
    frontier += least;
    m_largest_frontier = (std::max)(m_largest_frontier, static_cast<std::size_t>(frontier));
    for (const int j : unknowns[next])
      is_in_frontier[j] = --uses[j] > 0 ? 1 : 0;
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHAIN_ORDER_H
