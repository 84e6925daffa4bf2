// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CELL_NARROWING_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CELL_NARROWING_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Constraint_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Preconditioned_rows.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <cstddef>
#include <functional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Narrows cells by all constraints of their window: by one after the other and by combinations.
class Cell_narrowing
{
  Constraint_propagation m_propagation;
  Preconditioned_rows m_rows;
  Box_of_ranges m_before;

public:
  // `check()` may end the work by an exception.
  Cell_narrowing(const Sparse_system& system, const std::function<void()>& check)
    : m_propagation(system), m_rows(system, check)
  {}

  // False when nothing is left.
  bool operator()(Box_of_ranges& cell);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool Cell_narrowing::operator()(Box_of_ranges& cell)
{
  constexpr int most_rounds = 2;
  constexpr double least_gain = 0.1;
  m_propagation.wake_all();
  if (!m_propagation.narrow(cell))
    return false;
  for (int round = 0; round < most_rounds; ++round) {
    if (!m_rows.eliminate(cell))
      return true;
    m_before = cell;
    if (!m_rows.narrow(cell))
      return false;
    bool is_gain = false;
    for (std::size_t j = 0; j < cell.size(); ++j)
      if (width(cell[j]) < (1 - least_gain) * width(m_before[j])) {
        is_gain = true;
        m_propagation.wake_constraints_of(static_cast<int>(j));
      }
    if (!is_gain)
      return true;
    if (!m_propagation.narrow(cell))
      return false;
  }
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CELL_NARROWING_H
