// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHAIN_WINDOW_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHAIN_WINDOW_H

#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Cell_narrowing.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Boxes of one dimension, one after the other.
class Box_list
{
  std::size_t m_dimension;
  std::vector<Interval> m_ranges;

public:
  explicit Box_list(std::size_t dimension) : m_dimension(dimension) {}

  std::size_t size() const { return m_ranges.size() / m_dimension; }
  void push_back(const Box_of_ranges& box) { push_back(box.data()); }
  void push_back(const Interval* box) { m_ranges.insert(m_ranges.end(), box, box + m_dimension); }
  const Interval* operator[](std::size_t i) const { return m_ranges.data() + i * m_dimension; }
  void get(std::size_t i, Box_of_ranges& box) const { box.assign((*this)[i], (*this)[i] + m_dimension); }
  void set(std::size_t i, const Box_of_ranges& box)
  {
    std::copy(box.begin(), box.end(), m_ranges.begin() + static_cast<std::ptrdiff_t>(i * m_dimension));
  }
};

// Of places, or of cells.
using Pairs = std::vector<std::pair<int, int>>;

// Some constraints of a chain, one after the other, and boxes in their unknowns, the cells.
struct Chain_window
{
  int first, last;           // of its constraints in the chain
  std::vector<int> unknowns; // increasing
  std::vector<Polynomial_constraint> constraints;
  std::unique_ptr<Sparse_system> system; // in its own unknowns
  std::vector<std::unique_ptr<Cell_narrowing>> narrowings; // per slot of the threads; null: not used yet
  Box_list cells;
  std::vector<char> is_left;  // of each cell
  std::vector<double> weight; // of unknowns, for splits
};

// Whether two cells do in the unknowns that their windows share.
inline bool meet(const Interval* a, const Interval* b, const Pairs& shared)
{
  return std::ranges::all_of(shared, [&](const std::pair<int, int>& places) {
    return a[places.first].inf() <= b[places.second].sup() && b[places.second].inf() <= a[places.first].sup();
  });
}

// With no cell.
Chain_window chain_window_of(std::vector<Polynomial_constraint> constraints, const std::function<void()>& check);

// By their places in both.
Pairs shared_unknowns(const Chain_window& a, const Chain_window& b);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Chain_window chain_window_of(std::vector<Polynomial_constraint> constraints,
                                                            const std::function<void()>& check)
{
  constexpr double weight_of_linear = 0.15; // beside others: their neighbours split them
  std::vector<int> unknowns;
  for (const auto& [polynomial, relation] : constraints)
    for (const int j : polynomial.variables())
      unknowns.push_back(j);
  std::ranges::sort(unknowns);
  unknowns.erase(std::unique(unknowns.begin(), unknowns.end()), unknowns.end());
  std::vector<Polynomial_constraint> own;
  for (const auto& [polynomial, relation] : constraints)
    own.emplace_back(renumbered(polynomial, unknowns), relation);
  auto system = std::make_unique<Sparse_system>(static_cast<int>(unknowns.size()), own, check);
  Box_list cells(unknowns.size());
  std::vector<double> weight(unknowns.size(), weight_of_linear);
  for (int i = 0; i < system->constraints(); ++i)
    for (const auto& o : system->occurrences(i))
      if (!system->places(o).empty() || o.degree > 1)
        weight[o.unknown] = 1;
  return {0,
          0,
          std::move(unknowns),
          std::move(constraints),
          std::move(system),
          {},
          std::move(cells),
          {},
          std::move(weight)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Pairs shared_unknowns(const Chain_window& a, const Chain_window& b)
{
  Pairs result;
  for (std::size_t i = 0; i < a.unknowns.size(); ++i)
    for (std::size_t j = 0; j < b.unknowns.size(); ++j)
      if (a.unknowns[i] == b.unknowns[j])
        result.emplace_back(static_cast<int>(i), static_cast<int>(j));
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHAIN_WINDOW_H
