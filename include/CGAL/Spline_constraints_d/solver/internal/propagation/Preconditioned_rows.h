// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PRECONDITIONED_ROWS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PRECONDITIONED_ROWS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Row_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Affine_enclosures.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Combinations of the equalities on a box, each of which is solved for one unknown: with multipliers of an inverse of the
derivatives at the centre, or of an elimination that leaves out what bounds nothing yet. All that is said of solutions
comes from the equalities and the multipliers, which may be any: how exactly these were computed does not matter.
*/
class Preconditioned_rows
{
  struct Row
  {
    int unknown = -1; // that it was solved for, if any: the others have been eliminated from it
    std::vector<Weighted_index> multiples;
  };

  const Sparse_system& m_system;
  int m_dimension;
  Affine_enclosures m_enclosures;
  std::vector<Row> m_rows;
  std::size_t m_count = 0; // of the rows that were formed last
  std::optional<Row_elimination<0>> m_dense;
  std::optional<Sparse_elimination> m_sparse;
  Equation_block m_all;
  std::vector<int> m_place;              // of unknowns in the block in hand, or -1
  std::vector<char> m_repeats;           // of constraints: an unknown
  std::vector<double> m_slopes, m_radii; // of its equalities, for the dense elimination
  const std::function<void()>& m_check;

  static constexpr int largest_dense_dimension = 64;
  static constexpr std::size_t short_row = 64; // of unknowns: longer ones are solved for their own one only

public:
  // `check()` may end the work by an exception.
  Preconditioned_rows(const Sparse_system& system, const std::function<void()>& check)
    : m_system(system), m_dimension(system.dimension()), m_enclosures(system),
      m_rows((std::max)(system.equalities().size(), static_cast<std::size_t>(m_dimension))), m_place(m_dimension, -1),
      m_check(check)
  {
    std::vector<int> unknowns(m_dimension);
    std::iota(unknowns.begin(), unknowns.end(), 0);
    m_all = Equation_block(system, system.equalities(), std::move(unknowns));
    for (int i = 0; i < system.constraints(); ++i)
      m_repeats.push_back(system.repeats_unknown(i) ? 1 : 0);
  }

  Affine_enclosures& enclosures() { return m_enclosures; }
  const std::vector<Weighted_index>& multiples(int row) const { return m_rows[row].multiples; }

  // Forms the rows of some equalities, of all by default: those that bound something on a box, wherever it is wide, are
  // solved; the others stay equalities, or what is left of them. False when they say no more than propagation knows.
  bool eliminate(const Box_of_ranges& box) { return eliminate(box, m_all); }
  bool eliminate(const Box_of_ranges& box, const Equation_block& block);

  // Forms all rows by the inverse of the derivatives at the centre of a box; false when it is singular.
  bool invert(const Box_of_ranges& box)
  {
    m_enclosures.set_box(box, m_all);
    m_count = m_dimension;
    return m_dimension <= largest_dense_dimension ? invert_densely() : invert_sparsely();
  }

  // Narrows the box that the rows were formed on; false when no solution is left.
  bool narrow(Box_of_ranges& box)
  {
    return std::all_of(m_rows.begin(), m_rows.begin() + m_count, [&](const Row& row) { return narrow_by(row, box); });
  }

private:
  // Slopes in parts of the box, by the places of unknowns in a block, and the half width of the rest, of each equality.
  template <class Add, class Set_radius>
  void visit_equalities(const Equation_block& block, const Add& add, const Set_radius& set_radius)
  {
    for (int i = 0; i < static_cast<int>(block.equalities().size()); ++i) {
      double others = 0;
      const double radius = m_enclosures.visit_slopes(block.equalities()[i], [&](int j, double slope) {
        const double size = slope * m_enclosures.offset(j).sup();
        if (m_place[j] >= 0)
          add(i, m_place[j], size);
        else
          others += std::abs(size);
      });
      set_radius(i, radius + others);
    }
  }

  // Only when all are one block there may be more equalities than unknowns.
  int largest_dense_rows() const
  {
    return m_dimension <= largest_dense_dimension ? static_cast<int>(m_all.equalities().size())
                                                  : largest_dense_dimension;
  }
  Row& begin_row(int unknown)
  {
    Row& row = m_rows[m_count];
    row.unknown = unknown;
    row.multiples.clear();
    return row;
  }
  // An equality as it is says no more than propagation knows of it, unless it has an unknown more than once.
  bool is_row_known(const Row& row) const
  {
    return row.unknown < 0 && row.multiples.size() == 1 && m_repeats[row.multiples.front().first] == 0;
  }
  void eliminate_densely(const Equation_block& block);
  void eliminate_sparsely(const Equation_block& block);
  bool invert_densely();
  bool invert_sparsely();
  bool narrow_by(const Row& row, Box_of_ranges& box);
  bool has_finite_multiples() const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::eliminate(const Box_of_ranges& box,
                                                                   const Equation_block& block)
{
  m_enclosures.set_box(box, block);
  std::ranges::fill(m_place, -1);
  for (std::size_t k = 0; k < block.unknowns().size(); ++k)
    m_place[block.unknowns()[k]] = static_cast<int>(k);
  m_count = 0;
  if (block.unknowns().size() <= largest_dense_dimension)
    eliminate_densely(block);
  else
    eliminate_sparsely(block);
  const auto is_known = [this](const Row& row) { return is_row_known(row); };
  return !std::all_of(m_rows.begin(), m_rows.begin() + m_count, is_known) && has_finite_multiples();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Preconditioned_rows::eliminate_densely(const Equation_block& block)
{
  const int equalities = static_cast<int>(block.equalities().size()),
            unknowns = static_cast<int>(block.unknowns().size());
  if (!m_dense)
    m_dense.emplace(largest_dense_rows(), (std::min)(m_dimension, largest_dense_dimension));
  m_dense->resize(equalities, unknowns);
  m_slopes.assign(static_cast<std::size_t>(equalities) * unknowns, 0.0);
  m_radii.resize(equalities);
  visit_equalities(
      block, [&](int i, int k, double slope) { m_slopes[i * unknowns + k] = slope; },
      [&](int i, double radius) { m_radii[i] = radius; });
  for (int i = 0; i < equalities; ++i) {
    const double* row = m_slopes.data() + i * unknowns;
    double size = m_radii[i];
    for (int k = 0; k < unknowns; ++k)
      size += std::abs(row[k]);
    m_dense->set_row(i, row, size, m_radii[i]);
  }
  m_dense->run();
  for (int i = 0; i < equalities; ++i) {
    Row& row = begin_row(i < m_dense->rank() ? block.unknowns()[m_dense->unknown(i)] : -1);
    for (int k = 0; k < equalities; ++k)
      if (const double part = m_dense->part(i, k); part != 0)
        row.multiples.emplace_back(block.equalities()[m_dense->equation(k)], part);
    ++m_count;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Preconditioned_rows::eliminate_sparsely(const Equation_block& block)
{
  const int size = static_cast<int>(block.unknowns().size());
  if (!m_sparse)
    m_sparse.emplace(m_dimension);
  m_sparse->begin(size);
  visit_equalities(
      block, [&](int i, int k, double slope) { m_sparse->add_entry(i, k, slope); },
      [&](int i, double radius) { m_sparse->set_radius(i, radius); });
  m_sparse->run(m_check);
  const auto add_row = [&](int i) {
    Row& row = begin_row(m_sparse->pivot(i) < 0 ? -1 : block.unknowns()[m_sparse->pivot(i)]);
    for (const auto& [k, part] : m_sparse->multipliers(i))
      row.multiples.emplace_back(block.equalities()[k], part);
    ++m_count;
  };
  const std::vector<int>& solved_rows = m_sparse->solved_rows();
  std::for_each(solved_rows.rbegin(), solved_rows.rend(), add_row);
  for (int i = 0; i < size; ++i)
    if (m_sparse->pivot(i) < 0)
      add_row(i);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::invert_densely()
{
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(m_dimension, m_dimension);
  for (int i = 0; i < m_dimension; ++i)
    m_enclosures.visit_slopes(m_system.equalities()[i], [&](int j, double slope) { matrix(i, j) = slope; });
  const Eigen::MatrixXd inverse = matrix.partialPivLu().inverse();
  for (int i = 0; i < m_dimension; ++i) {
    m_rows[i].unknown = i;
    m_rows[i].multiples.clear();
    for (int k = 0; k < m_dimension; ++k)
      if (inverse(i, k) != 0)
        m_rows[i].multiples.emplace_back(m_system.equalities()[k], inverse(i, k));
  }
  return has_finite_multiples();
}

// Column by column; what is tiny beside the largest entry of its column is left out.
CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::invert_sparsely()
{
  constexpr double least_entry = 1e-9;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < m_dimension; ++i)
    m_enclosures.visit_slopes(m_system.equalities()[i],
                              [&](int j, double slope) { entries.emplace_back(i, j, slope); });
  Eigen::SparseMatrix<double> matrix(m_dimension, m_dimension);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> decomposition(matrix);
  if (decomposition.info() != Eigen::Success)
    return false;
  for (int i = 0; i < m_dimension; ++i) {
    m_rows[i].unknown = i;
    m_rows[i].multiples.clear();
  }
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(m_dimension);
  for (int k = 0; k < m_dimension; ++k) {
    m_check();
    unit[k] = 1;
    const Eigen::VectorXd column = decomposition.solve(unit);
    unit[k] = 0;
    const double least = least_entry * column.cwiseAbs().maxCoeff();
    for (int i = 0; i < m_dimension; ++i)
      if (std::abs(column[i]) > least || std::isnan(column[i]))
        m_rows[i].multiples.emplace_back(m_system.equalities()[k], column[i]);
  }
  return has_finite_multiples();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::has_finite_multiples() const
{
  for (std::size_t i = 0; i < m_count; ++i)
    for (const auto& [k, part] : m_rows[i].multiples)
      if (!std::isfinite(part))
        return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::narrow_by(const Row& row, Box_of_ranges& box)
{
  m_enclosures.set_sum(row.multiples);
  Interval total = m_enclosures.constant() + m_enclosures.rest();
  for (const int j : m_enclosures.unknowns())
    total += m_enclosures.slope(j) * m_enclosures.offset(j);
  if (total.inf() > 0 || total.sup() < 0)
    return false;
  if (!is_finite(total))
    return true;
  for (const int j : m_enclosures.unknowns()) {
    const Interval slope = m_enclosures.slope(j);
    if (has_zero(slope) || (j != row.unknown && m_enclosures.unknowns().size() > short_row))
      continue;
    Interval& offset = m_enclosures.offset(j);
    const Interval rest = without_summand(total, slope * offset);
    const Interval solved = -rest / slope;
    if (solved.inf() > offset.sup() || solved.sup() < offset.inf())
      return false;
    const Interval narrowed = common_part(solved, offset);
    if (!(width(narrowed) < width(offset)))
      continue;
    const Interval range = Interval(m_enclosures.centre(j)) + narrowed;
    if (range.inf() > box[j].sup() || range.sup() < box[j].inf())
      return false;
    offset = narrowed;
    box[j] = common_part(range, box[j]);
    total = rest + slope * narrowed;
  }
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PRECONDITIONED_ROWS_H
