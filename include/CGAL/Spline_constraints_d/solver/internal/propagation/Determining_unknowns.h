// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_DETERMINING_UNKNOWNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_DETERMINING_UNKNOWNS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Equation_block.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Few unknowns of a block of which the others follow by linear equations, where there are such: boxes are to be split in
these, as what is known of the others depends on them. There are two ways to follow:

All at once: every term has at most one factor that is not among the few, which are a vertex cover of the graph of the
unknowns that are multiplied. A third of the unknowns at most.

One after the other, each by an equality that is linear in it (tearing). As long as no equality tells an unknown, one of
those of the equality with the fewest is torn, which occurs most often. These are of use where they are at most a
quarter of the unknowns, and one of them is in half of the equalities: in a chain, where each is in a few, what is far
along it depends too much on them, and neighbours tell more.
*/
class Determining_unknowns
{
  struct Equality
  {
    std::vector<int> unknowns, linear_unknowns;
    std::size_t open; // unknowns that are not known
  };

  const Sparse_system& m_system;
  std::vector<char> m_is_determining;
  std::vector<char> m_is_open;                               // of the block in hand, and does not follow yet
  std::vector<std::vector<int>> m_partners, m_equalities_of; // of unknowns
  std::vector<std::size_t> m_open_partners;
  std::vector<Equality> m_equalities;            // of the block in hand
  std::set<std::pair<std::size_t, int>> m_queue; // of these, those with open unknowns, by their number
  std::vector<int> m_few;

public:
  // In O(e log n + n^2) for the n unknowns of the largest block and e occurrences of pairs of unknowns in terms.
  Determining_unknowns(const Sparse_system& system, const Block_order& order);

  // Whether it is one of few.
  bool operator[](int unknown) const { return m_is_determining[unknown] != 0; }

private:
  bool cover_products(const Equation_block& block);
  void find_partners(const Equation_block& block);
  bool tear(const Equation_block& block);
  void add_equality(int constraint);
  bool follow_unknown();
  int unknown_to_tear() const;
  void set_known(int unknown);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Determining_unknowns::Determining_unknowns(const Sparse_system& system,
                                                                          const Block_order& order)
  : m_system(system), m_is_determining(system.dimension(), 0), m_is_open(system.dimension(), 0),
    m_partners(system.dimension()), m_equalities_of(system.dimension()), m_open_partners(system.dimension(), 0)
{
  for (const Equation_block& block : order.blocks()) {
    for (const int j : block.unknowns())
      m_is_open[j] = 1;
    if (cover_products(block) || tear(block))
      for (const int j : m_few)
        m_is_determining[j] = 1;
    for (const int j : block.unknowns())
      m_is_open[j] = 0;
  }
}

// Greedily, those first that are multiplied by themselves or by most others; whether few are enough.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Determining_unknowns::cover_products(const Equation_block& block)
{
  constexpr std::size_t part = 3;
  m_few.clear();
  find_partners(block);
  for (const int j : block.unknowns()) {
    const bool is_own_partner = std::ranges::binary_search(m_partners[j], j);
    m_open_partners[j] = is_own_partner ? m_partners.size() + 1 : m_partners[j].size();
  }
  for (;;) {
    const int next = *std::ranges::max_element(block.unknowns(), {}, [this](int j) { return m_open_partners[j]; });
    if (m_open_partners[next] == 0)
      return true;
    if (part * (m_few.size() + 1) > block.unknowns().size())
      return false;
    m_few.push_back(next);
    m_open_partners[next] = 0;
    for (const int other : m_partners[next])
      if (m_open_partners[other] > 0)
        --m_open_partners[other];
  }
}

// Of each unknown of the block those in a term with it, in ascending order; itself where it has a power.
CGAL_SPLINE_CONSTRAINTS_INLINE void Determining_unknowns::find_partners(const Equation_block& block)
{
  const auto add = [&](int i, int j) {
    if (m_is_open[i] != 0 && m_is_open[j] != 0)
      m_partners[i].push_back(j);
  };
  for (const int i : block.equalities()) {
    for (const auto& part : m_system.parts(i))
      if (part.degree > 1)
        add(part.unknown, part.unknown);
    for (const auto& part : m_system.elementary_parts(i)) {
      const int unknown = m_system.function(part.function).unknown;
      add(unknown, unknown);
    }
    for (const auto& term : m_system.terms(i))
      for (std::size_t f = m_system.first_factor(term.monomial); f < m_system.last_factor(term.monomial); ++f)
        for (std::size_t g = m_system.first_factor(term.monomial); g < m_system.last_factor(term.monomial); ++g)
          if (f != g || m_system.factor(f).exponent > 1)
            add(m_system.factor(f).unknown, m_system.factor(g).unknown);
  }
  for (const int j : block.unknowns()) {
    std::ranges::sort(m_partners[j]);
    m_partners[j].erase(std::ranges::unique(m_partners[j]).begin(), m_partners[j].end());
  }
}

// Whether few are enough, and one of them is in many equalities.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Determining_unknowns::tear(const Equation_block& block)
{
  constexpr std::size_t part = 4, part_of_equalities = 2;
  m_few.clear();
  m_equalities.clear();
  m_queue.clear();
  for (const int i : block.equalities())
    add_equality(i);
  while (!m_queue.empty() && part * m_few.size() <= block.unknowns().size())
    if (!follow_unknown()) {
      m_few.push_back(unknown_to_tear());
      set_known(m_few.back());
    }
  return part * m_few.size() <= block.unknowns().size() && std::ranges::any_of(m_few, [this](int j) {
           return part_of_equalities * m_equalities_of[j].size() >= m_equalities.size();
         });
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Determining_unknowns::add_equality(int constraint)
{
  const int index = static_cast<int>(m_equalities.size());
  Equality& equality = m_equalities.emplace_back();
  for (const auto& part : m_system.elementary_parts(constraint))
    equality.unknowns.push_back(m_system.function(part.function).unknown);
  for (const auto& occurrence : m_system.occurrences(constraint)) {
    if (occurrence.degree == 1 && std::ranges::find(equality.unknowns, occurrence.unknown) == equality.unknowns.end())
      equality.linear_unknowns.push_back(occurrence.unknown);
    equality.unknowns.push_back(occurrence.unknown);
  }
  std::ranges::sort(equality.unknowns);
  equality.unknowns.erase(std::ranges::unique(equality.unknowns).begin(), equality.unknowns.end());
  std::erase_if(equality.unknowns, [this](int j) { return m_is_open[j] == 0; });
  for (const int j : equality.unknowns)
    m_equalities_of[j].push_back(index);
  equality.open = equality.unknowns.size();
  if (equality.open > 0)
    m_queue.emplace(equality.open, index);
}

// By an equality where it is the only open one; whether there was one.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Determining_unknowns::follow_unknown()
{
  for (auto next = m_queue.begin(); next != m_queue.end() && next->first == 1; ++next)
    for (const int j : m_equalities[next->second].linear_unknowns)
      if (m_is_open[j] != 0) {
        set_known(j);
        return true;
      }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Determining_unknowns::unknown_to_tear() const
{
  int result = -1;
  for (const int j : m_equalities[m_queue.begin()->second].unknowns)
    if (m_is_open[j] != 0 && (result < 0 || m_equalities_of[j].size() > m_equalities_of[result].size()))
      result = j;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Determining_unknowns::set_known(int unknown)
{
  m_is_open[unknown] = 0;
  for (const int i : m_equalities_of[unknown]) {
    Equality& equality = m_equalities[i];
    m_queue.erase({equality.open, i});
    if (--equality.open > 0)
      m_queue.emplace(equality.open, i);
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_DETERMINING_UNKNOWNS_H
