// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_EQUATION_BLOCK_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_EQUATION_BLOCK_H

#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Some equalities of a system, by the places of the constraints, and unknowns that they are to be solved for.
class Equation_block
{
  std::vector<int> m_equalities, m_unknowns;
  std::vector<int> m_occurring_unknowns, m_monomials, m_functions; // in the equalities

public:
  Equation_block() = default;
  Equation_block(const Sparse_system& system, std::vector<int> equalities, std::vector<int> unknowns)
    : m_equalities(std::move(equalities)), m_unknowns(std::move(unknowns)), m_occurring_unknowns(m_unknowns)
  {
    for (const int i : m_equalities) {
      for (const auto& occurrence : system.occurrences(i))
        m_occurring_unknowns.push_back(occurrence.unknown);
      for (const auto& term : system.terms(i))
        m_monomials.push_back(term.monomial);
      for (const auto& part : system.elementary_parts(i)) {
        m_functions.push_back(part.function);
        m_occurring_unknowns.push_back(system.function(part.function).unknown);
      }
    }
    for (std::vector<int>* places : {&m_occurring_unknowns, &m_monomials, &m_functions}) {
      std::ranges::sort(*places);
      places->erase(std::ranges::unique(*places).begin(), places->end());
    }
  }

  const std::vector<int>& equalities() const { return m_equalities; }
  const std::vector<int>& unknowns() const { return m_unknowns; }

  // What occurs in the equalities, and the unknowns of the block in any case; in ascending order.
  const std::vector<int>& occurring_unknowns() const { return m_occurring_unknowns; }
  const std::vector<int>& monomials() const { return m_monomials; }
  const std::vector<int>& functions() const { return m_functions; }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_EQUATION_BLOCK_H
