// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_BLOCK_ORDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_BLOCK_ORDER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Equation_block.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

// Before strong_components.hpp, as reverse_graph.hpp there has a get() that hides others from it.
#include <boost/pending/disjoint_sets.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/strong_components.hpp>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The blocks of unknowns that equalities can be solved for one after the other: those of a block depend on no unknowns of
later ones (the fine decomposition of Dulmage and Mendelsohn). Each equality is given an unknown of its own by a
matching; an unknown needs the others of its equality, and those that need each other, in however many steps, are a
block. Where there is no such matching, as where equalities are fewer or more than unknowns, all are one block.
*/
class Block_order
{
  std::vector<std::vector<int>> m_unknowns; // of each equality
  std::vector<int> m_equality_of;           // each unknown: its own, or -1
  std::vector<int> m_unknown_of;            // each equality: its own, or -1
  std::vector<int> m_block;                 // of each unknown
  std::vector<Equation_block> m_blocks;

public:
  // In O(n e) for n unknowns and e occurrences of them, nearly always in O(e).
  explicit Block_order(const Sparse_system& system);

  // In the order in which they can be solved.
  const std::vector<Equation_block>& blocks() const { return m_blocks; }
  // The place of the one with an unknown.
  int block(int unknown) const { return m_block[unknown]; }

private:
  bool match(int equality);
  void find_blocks();
  void order_blocks(int count);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Block_order::Block_order(const Sparse_system& system)
  : m_equality_of(system.dimension(), -1), m_unknown_of(system.equalities().size(), -1), m_block(system.dimension(), 0)
{
  for (const int i : system.equalities()) {
    std::vector<int>& unknowns = m_unknowns.emplace_back();
    for (const auto& occurrence : system.occurrences(i))
      unknowns.push_back(occurrence.unknown);
    for (const auto& part : system.elementary_parts(i))
      unknowns.push_back(system.function(part.function).unknown);
  }
  bool are_matched = m_unknown_of.size() == m_equality_of.size();
  for (std::size_t i = 0; i < m_unknown_of.size() && are_matched; ++i)
    are_matched = match(static_cast<int>(i));
  if (are_matched)
    find_blocks();
  const std::size_t count = 1 + *std::ranges::max_element(m_block);
  std::vector<std::vector<int>> equalities(count), unknowns(count);
  for (int j = 0; j < system.dimension(); ++j) {
    unknowns[m_block[j]].push_back(j);
    if (are_matched)
      equalities[m_block[j]].push_back(system.equalities()[m_equality_of[j]]);
  }
  if (count == 1)
    equalities.front() = system.equalities();
  for (std::size_t k = 0; k < count; ++k)
    m_blocks.emplace_back(system, std::move(equalities[k]), std::move(unknowns[k]));
}

// Gives an equality an unknown, breadth-first: others may have to take another one for it.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Block_order::match(int equality)
{
  std::vector<int> equalities{equality}, asked_by(m_block.size(), -1); // the unknowns that were seen: for whom
  for (std::size_t k = 0; k < equalities.size(); ++k)
    for (const int j : m_unknowns[equalities[k]]) {
      if (asked_by[j] >= 0)
        continue;
      asked_by[j] = equalities[k];
      if (m_equality_of[j] >= 0) {
        equalities.push_back(m_equality_of[j]);
        continue;
      }
      for (int free = j; free >= 0;) {
        const int taker = asked_by[free];
        m_equality_of[free] = taker;
        free = std::exchange(m_unknown_of[taker], free);
      }
      return true;
    }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Block_order::find_blocks()
{
  boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS> needs(m_block.size());
  for (std::size_t j = 0; j < m_block.size(); ++j)
    for (const int other : m_unknowns[m_equality_of[j]])
      boost::add_edge(j, static_cast<std::size_t>(other), needs);
  const int count = boost::strong_components(
      needs, boost::make_iterator_property_map(m_block.begin(), boost::get(boost::vertex_index, needs)));
  order_blocks(count);
}

// The largest ones first, each after those that it needs: one is solved anew for each solution of those before it.
CGAL_SPLINE_CONSTRAINTS_INLINE void Block_order::order_blocks(int count)
{
  std::vector<std::vector<int>> unknowns(count);
  for (std::size_t j = 0; j < m_block.size(); ++j)
    unknowns[m_block[j]].push_back(static_cast<int>(j));
  std::vector<int> largest_first(count), place(count, -1);
  std::iota(largest_first.begin(), largest_first.end(), 0);
  std::ranges::stable_sort(largest_first, [&](int a, int b) { return unknowns[a].size() > unknowns[b].size(); });
  std::vector<char> is_open(count, 0);
  int next = 0;
  for (const int block : largest_first)
    for (std::vector<int> stack{block}; !stack.empty();) {
      const int last = stack.back();
      if (is_open[last] != 0) { // all that it needs have their places
        place[last] = place[last] < 0 ? next++ : place[last];
        stack.pop_back();
        continue;
      }
      is_open[last] = 1;
      for (const int j : unknowns[last])
        for (const int other : m_unknowns[m_equality_of[j]])
          if (is_open[m_block[other]] == 0)
            stack.push_back(m_block[other]);
    }
  for (int& block : m_block)
    block = place[block];
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_BLOCK_ORDER_H
