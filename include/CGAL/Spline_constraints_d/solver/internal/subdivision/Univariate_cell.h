// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_CELL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_CELL_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A part of the domain of the only unknown where every function is one polynomial. Functions are multiplied by positive
constants, the same in all cells.
*/
struct Univariate_cell
{
  Exact_rational lower, upper;
  std::vector<Integer_polynomial> equalities, inequalities;

  // The polynomial whose roots are those that all equalities have in common, with the smallest multiplicity; zero where
  // all of them are.
  Integer_polynomial common_equality() const
  {
    Integer_polynomial result = equalities.front();
    for (std::size_t i = 1; i < equalities.size() && result.degree() != 0; ++i)
      result = common_divisor(result, equalities[i]);
    return result;
  }
};

// The pieces of a function of one unknown, on intervals that each lie in one of its cells.
inline std::vector<Integer_polynomial> integer_pieces(const Spline_function& function,
                                                      const std::vector<Exact_rational>& breaks)
{
  Big_integer denominator(1);
  for (const Spline_term& term : function.terms())
    for (const auto& piece : term.pieces)
      for (const Exact_rational& coefficient : piece)
        extend_common_denominator(denominator, coefficient);
  std::vector<std::vector<Big_integer>> sums((std::max)(breaks.size() - 1, std::size_t(1)));
  for (const Spline_term& term : function.terms())
    for (std::size_t i = 0; i < sums.size(); ++i) {
      std::size_t cell = 0;
      if (!term.variables.empty() && !term.breaks[0].empty()) {
        const auto next = std::upper_bound(term.breaks[0].begin() + 1, term.breaks[0].end() - 1, breaks[i]);
        cell = static_cast<std::size_t>(next - term.breaks[0].begin()) - 1;
      }
      const std::vector<Exact_rational>& piece = term.pieces[cell];
      if (sums[i].size() < piece.size())
        sums[i].resize(piece.size(), Big_integer(0));
      for (std::size_t k = 0; k < piece.size(); ++k)
        sums[i][k] += numerator_over(piece[k], denominator);
    }
  std::vector<Integer_polynomial> result;
  for (std::vector<Big_integer>& sum : sums)
    result.emplace_back(std::move(sum));
  return result;
}

// The cells of a system in one unknown, from left to right. Breaks where no polynomial changes are none. A domain that
// is a point is one cell.
inline std::vector<Univariate_cell> univariate_cells(const Constraint_system_d& system)
{
  const Exact_rational &lower = system.domain(0).first, &upper = system.domain(0).second;
  std::vector<Exact_rational> breaks{lower, upper};
  const auto add_breaks = [&](const Spline_function& function) {
    for (const Spline_term& term : function.terms())
      for (const auto& own : term.breaks)
        std::copy_if(own.begin(), own.end(), std::back_inserter(breaks),
                     [&](const Exact_rational& b) { return lower < b && b < upper; });
  };
  for (const Spline_function& function : system.equalities())
    add_breaks(function);
  for (const auto& inequality : system.inequalities())
    add_breaks(inequality.function);
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());

  std::vector<Univariate_cell> cells((std::max)(breaks.size() - 1, std::size_t(1)));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i].lower = breaks[i];
    cells[i].upper = breaks.size() == 1 ? breaks[0] : breaks[i + 1];
  }
  const auto add_pieces = [&](const Spline_function& function, auto member) {
    std::vector<Integer_polynomial> pieces = integer_pieces(function, breaks);
    for (std::size_t i = 0; i < cells.size(); ++i)
      (cells[i].*member).push_back(std::move(pieces[i]));
  };
  for (const Spline_function& function : system.equalities())
    add_pieces(function, &Univariate_cell::equalities);
  for (const auto& inequality : system.inequalities())
    add_pieces(inequality.function, &Univariate_cell::inequalities);

  std::vector<Univariate_cell> merged;
  for (Univariate_cell& cell : cells)
    if (!merged.empty() && merged.back().equalities == cell.equalities &&
        merged.back().inequalities == cell.inequalities)
      merged.back().upper = cell.upper;
    else
      merged.push_back(std::move(cell));
  return merged;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_UNIVARIATE_CELL_H
