// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_INTEGER_TERM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_INTEGER_TERM_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Short_integer.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Cell_grid.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A term of a function of a system, times a common denominator of the coefficients of the function, as integer polynomials
in power form: one per cell of its own breaks.
*/
class Integer_term
{
  // per axis with breaks, of a cell of the system: of its piece; no axis: there is one piece
  std::vector<std::vector<std::size_t>> m_offsets;
  std::vector<std::vector<Short_integer>> m_pieces;   // padded to the degrees of the block

public:
  int function;
  std::size_t block;
  std::size_t member;   // place of the function in the block

  Integer_term(const Spline_term& term, int function, const Short_integer& denominator, const System_layout& layout,
               const Cell_grid& grid)
    : function(function)
  {
    find_block(term, layout);
    set_offsets(term, grid);
    for (const auto& coefficients : term.pieces)
      add_piece(coefficients, term.degrees, denominator, layout.blocks[block]);
  }

  // The coefficients on a cell of the system.
  const std::vector<Short_integer>& piece(const Cell& cell, const System_layout& layout) const
  {
    std::size_t index = 0;
    for (std::size_t j = 0; j < m_offsets.size(); ++j)
      if (!m_offsets[j].empty())
        index += m_offsets[j][cell[layout.blocks[block].axes[j]]];
    return m_pieces[index];
  }

private:
  void find_block(const Spline_term& term, const System_layout& layout)
  {
    for (block = 0;; ++block) {
      const Block& candidate = layout.blocks[block];
      if (candidate.axes != term.variables)
        continue;
      const auto place = std::lower_bound(candidate.functions.begin(), candidate.functions.end(), function);
      if (place != candidate.functions.end() && *place == function) {
        member = place - candidate.functions.begin();
        return;
      }
    }
  }

  void set_offsets(const Spline_term& term, const Cell_grid& grid)
  {
    if (term.pieces.size() > 1)
      m_offsets.resize(term.variables.size());
    std::size_t stride = 1;
    for (std::size_t j = m_offsets.size(); j-- > 0; stride *= term.cells(j)) {
      const std::vector<Exact_rational>& breaks = grid.breaks(term.variables[j]);
      if (!term.breaks[j].empty())
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
          const auto next = std::upper_bound(term.breaks[j].begin(), term.breaks[j].end(), breaks[k]);
          const std::size_t cell = next - term.breaks[j].begin() - 1;
          m_offsets[j].push_back(stride * (std::min)(cell, term.cells(j) - 1));
        }
    }
  }

  void add_piece(const std::vector<Exact_rational>& coefficients, const std::vector<int>& degrees,
                 const Short_integer& denominator, const Block& padding)
  {
    std::vector<Short_integer>& padded = m_pieces.emplace_back(padding.points, Short_integer(0));
    std::vector<int> k(degrees.size(), 0);
    for (const Exact_rational& coefficient : coefficients) {
      std::size_t position = 0;
      for (std::size_t j = 0; j < k.size(); ++j)
        position = position * (static_cast<std::size_t>(padding.degrees[j]) + 1) + k[j];
      padded[position] = numerator_over(coefficient, denominator);
      for (std::size_t j = k.size(); j-- > 0 && ++k[j] > degrees[j];)
        k[j] = 0;
    }
  }
};

// The terms of a function of a system, with one common denominator.
inline void append_integer_terms(std::vector<Integer_term>& result, const Spline_function& function, int index,
                                 const System_layout& layout, const Cell_grid& grid)
{
  Short_integer denominator(1);
  for (const Spline_term& term : function.terms())
    for (const auto& coefficients : term.pieces)
      for (const Exact_rational& coefficient : coefficients)
        extend_common_denominator(denominator, coefficient);
  for (const Spline_term& term : function.terms())
    result.emplace_back(term, index, denominator, layout, grid);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_INTEGER_TERM_H
