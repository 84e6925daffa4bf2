// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_CELL_GRID_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_CELL_GRID_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A cell of the grid that the breaks of all splines cut the domain into: an index per unknown.
using Cell = std::vector<int>;

// The breaks of all splines of a system, per unknown and within its domain; empty where no spline has any.
std::vector<std::vector<Exact_rational>> breaks_of_splines(const Constraint_system_d& system,
                                                           const System_layout& layout);

/*
The grid that the breaks of all splines of a system cut its domain into. Not shared between threads: the scratch cell
lives here.
*/
class Cell_grid
{
  std::vector<std::vector<Exact_rational>> m_breaks;   // per unknown, empty where no spline has any
  Cell m_cell;

public:
  explicit Cell_grid(std::vector<std::vector<Exact_rational>> breaks) : m_breaks(std::move(breaks)) {}

  const std::vector<std::vector<Exact_rational>>& breaks() const { return m_breaks; }

  // Breaks of all splines on an unknown, within its domain; empty when there are none.
  const std::vector<Exact_rational>& breaks(int unknown) const { return m_breaks[unknown]; }

  // Some unknown has a break inside its domain.
  bool has_breaks() const
  {
    return std::any_of(m_breaks.begin(), m_breaks.end(), [](const auto& breaks) { return breaks.size() > 2; });
  }

  // The cell that holds a point; beyond the domain the nearest one.
  template <class Coordinate>
  const Cell& cell_of(std::span<const Coordinate> point)
  {
    const int dimension = static_cast<int>(m_breaks.size());
    m_cell.assign(dimension, 0);
    for (int v = 0; v < dimension; ++v)
      if (m_breaks[v].size() > 2) {
        const auto next = std::upper_bound(m_breaks[v].begin() + 1, m_breaks[v].end() - 1, Exact_rational(point[v]));
        m_cell[v] = static_cast<int>(next - m_breaks[v].begin()) - 1;
      }
    return m_cell;
  }

  // Calls visit(cell) for every cell that a box meets.
  template <class Coordinate, class Visitor>
  void visit_cells(std::span<const Coordinate> lower, std::span<const Coordinate> upper, const Visitor& visit)
  {
    const Cell first = cell_of(lower), last = cell_of(upper);
    const int dimension = static_cast<int>(m_breaks.size());
    Cell cell = first;
    for (int v = dimension - 1; v >= 0;) {
      visit(std::as_const(cell));
      for (v = dimension - 1; v >= 0 && ++cell[v] > last[v]; --v)
        cell[v] = first[v];
    }
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::vector<Exact_rational>>
breaks_of_splines(const Constraint_system_d& system, const System_layout& layout)
{
  std::vector<std::vector<Exact_rational>> result(layout.dimension);
  for (int f = 0; f < layout.functions; ++f)
    for (const Spline_term& term : function_of(system, f).terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j) {
        if (term.breaks[j].empty())
          continue;
        const auto& [lower, upper] = system.domain(term.variables[j]);
        std::vector<Exact_rational>& breaks = result[term.variables[j]];
        if (breaks.empty())
          breaks = {lower, upper}; // also of a domain that is one point
        std::copy_if(term.breaks[j].begin(), term.breaks[j].end(), std::back_inserter(breaks),
                     [&lower = lower, &upper = upper](const Exact_rational& b) { return lower < b && b < upper; });
      }
  for (std::vector<Exact_rational>& breaks : result)
    if (breaks.size() > 2) {
      std::sort(breaks.begin(), breaks.end());
      breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    }
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_CELL_GRID_H
