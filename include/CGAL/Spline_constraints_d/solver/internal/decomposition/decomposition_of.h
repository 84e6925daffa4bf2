// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_DECOMPOSITION_OF_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_DECOMPOSITION_OF_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/Reduced_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The groups of unknowns that constraints connect, each with as many equalities as unknowns or more.
class Independent_parts
{
  struct Part
  {
    std::vector<int> unknowns;
    std::vector<Reducible_function*> equalities, inequalities;
  };

  Reduced_system& m_system;
  std::vector<int> m_parent;
  std::map<int, Part> m_parts; // by the root

public:
  // All unknowns are in one part, whatever connects them, if `is_one`.
  Independent_parts(Reduced_system& system, int dimension, bool is_one = false)
    : m_system(system), m_parent(static_cast<std::size_t>(dimension))
  {
    std::iota(m_parent.begin(), m_parent.end(), 0);
    for (auto* functions : {&system.equalities(), &system.inequalities()})
      for (const Reducible_function& f : *functions)
        for (const int unknown : f.unknowns())
          m_parent[root(unknown)] = root(f.unknowns().front());
    for (int j = 0, first = -1; j < dimension; ++j)
      if (is_one && !system.is_eliminated(j)) {
        first = first < 0 ? j : first;
        m_parent[root(j)] = root(first);
      }
    for (int j = 0; j < dimension; ++j)
      if (!system.is_eliminated(j))
        m_parts[root(j)].unknowns.push_back(j);
    for (Reducible_function& f : system.equalities())
      m_parts[root_of(f)].equalities.push_back(&f);
    for (Reducible_function& f : system.inequalities())
      m_parts[root_of(f)].inequalities.push_back(&f);
  }

  // No part has fewer equalities than unknowns, and none has no unknowns, as one of constants would.
  bool are_determined() const
  {
    return std::all_of(m_parts.begin(), m_parts.end(), [](const auto& entry) {
      return !entry.second.unknowns.empty() && entry.second.unknowns.size() <= entry.second.equalities.size();
    });
  }

  std::size_t size() const { return m_parts.size(); }

  std::vector<System_part> take()
  {
    std::vector<System_part> result;
    for (auto& [representative, part] : m_parts)
      result.push_back(system_of(part));
    return result;
  }

private:
  int root(int v)
  {
    while (m_parent[v] != v)
      v = m_parent[v] = m_parent[m_parent[v]];
    return v;
  }

  int root_of(const Reducible_function& f)
  {
    const std::vector<int> unknowns = f.unknowns();
    return unknowns.empty() ? -1 : root(unknowns.front());
  }

  System_part system_of(Part& part)
  {
    std::vector<Constraint_system_d::Domain> domain;
    for (const int unknown : part.unknowns)
      domain.push_back(m_system.domain(unknown));
    System_part result{Constraint_system_d(std::move(domain)), std::move(part.unknowns)};
    for (auto* functions : {&part.equalities, &part.inequalities})
      for (Reducible_function* f : *functions)
        result.system.add(renumbered(f->take_function(), result.unknowns), f->relation);
    return result;
  }

  static Spline_function renumbered(const Spline_function& function, const std::vector<int>& unknowns)
  {
    Spline_function result;
    for (Spline_term term : function.terms()) {
      for (int& variable : term.variables)
        variable = static_cast<int>(std::lower_bound(unknowns.begin(), unknowns.end(), variable) - unknowns.begin());
      result += Spline_function(std::move(term));
    }
    return result;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE System_decomposition decomposition_of(const Constraint_system_d& system,
                                                                     const std::function<void()>& check)
try {
  System_decomposition result;
  Reduced_system reduced(system, check);
  reduced.reduce();
  if (reduced.is_impossible())
    result.is_without_solutions = true;
  if (reduced.is_impossible() || reduced.is_dependent())
    return result;
  Independent_parts parts(reduced, system.dimension());
  if (!parts.are_determined() || (parts.size() == 1 && !reduced.is_changed()))
    return result;
  result.parts = parts.take();
  result.eliminated = std::move(reduced.eliminated());
  return result;
} catch (const Invalid_input&) { // numbers or tensors became too large
  return {};
}

CGAL_SPLINE_CONSTRAINTS_INLINE System_decomposition elimination_of(const Constraint_system_d& system,
                                                                   std::size_t freedom,
                                                                   const std::function<void()>& check)
try {
  System_decomposition result;
  Reduced_system reduced(system, check, freedom);
  reduced.reduce();
  if (reduced.is_impossible() || reduced.is_dependent() || reduced.eliminated().empty())
    return result;
  result.parts = Independent_parts(reduced, system.dimension(), true).take();
  result.eliminated = std::move(reduced.eliminated());
  return result;
} catch (const Invalid_input&) { // numbers or tensors became too large
  return {};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DECOMPOSITION_DECOMPOSITION_OF_H
