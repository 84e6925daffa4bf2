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
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include <Eigen/Dense>
#include <Eigen/SparseLU>

#include <cmath>
#include <cstddef>
#include <functional>
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
  int m_dimension, m_equalities;
  Affine_enclosures m_enclosures;
  std::vector<Row> m_rows;
  std::optional<Row_elimination<0>> m_dense;
  std::optional<Sparse_elimination> m_sparse;
  std::vector<double> m_slopes, m_radii; // of all equalities, for the dense elimination
  const std::function<void()>& m_check;

  static constexpr int largest_dense_dimension = 64;
  static constexpr std::size_t short_row = 64; // of unknowns: longer ones are solved for their own one only

public:
  // `check()` may end the work by an exception.
  Preconditioned_rows(const Sparse_system& system, const std::function<void()>& check)
    : m_system(system), m_dimension(system.dimension()), m_equalities(static_cast<int>(system.equalities().size())),
      m_enclosures(system), m_rows(m_equalities), m_check(check)
  {
    if (m_dimension <= largest_dense_dimension) {
      m_dense.emplace(m_equalities, m_dimension);
      m_slopes.resize(static_cast<std::size_t>(m_dimension) * m_dimension);
    } else
      m_sparse.emplace(m_dimension);
  }

  Affine_enclosures& enclosures() { return m_enclosures; }
  const std::vector<Weighted_index>& multiples(int row) const { return m_rows[row].multiples; }

  // Forms the rows that bound something on a box, wherever it is wide; false when there are none.
  bool eliminate(const Box_of_ranges& box)
  {
    m_enclosures.set_box(box);
    return m_dense ? eliminate_densely() : eliminate_sparsely();
  }

  // Forms all rows by the inverse of the derivatives at the centre of a box; false when it is singular.
  bool invert(const Box_of_ranges& box)
  {
    m_enclosures.set_box(box);
    return m_dense ? invert_densely() : invert_sparsely();
  }

  // Narrows the box that the rows were formed on; false when no solution is left.
  bool narrow(Box_of_ranges& box)
  {
    for (const Row& row : m_rows)
      if (!narrow_by(row, box))
        return false;
    return true;
  }

private:
  // Slopes in parts of the box, and the half width of the rest, of each equality.
  template <class Add, class Set_radius>
  void visit_equalities(const Add& add, const Set_radius& set_radius)
  {
    for (int i = 0; i < m_equalities; ++i)
      set_radius(i, m_enclosures.visit_slopes(m_system.equalities()[i], [&](int j, double slope) {
        add(i, j, slope * m_enclosures.offset(j).sup());
      }));
  }

  bool eliminate_densely();
  bool eliminate_sparsely();
  bool invert_densely();
  bool invert_sparsely();
  bool narrow_by(const Row& row, Box_of_ranges& box);
  bool has_finite_multiples() const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::eliminate_densely()
{
  m_radii.resize(m_equalities);
  std::fill(m_slopes.begin(), m_slopes.end(), 0.0);
  visit_equalities([&](int i, int j, double slope) { m_slopes[i * m_dimension + j] = slope; },
                   [&](int i, double radius) { m_radii[i] = radius; });
  for (int i = 0; i < m_equalities; ++i) {
    const double* row = m_slopes.data() + i * m_dimension;
    double size = m_radii[i];
    for (int j = 0; j < m_dimension; ++j)
      size += std::abs(row[j]);
    m_dense->set_row(i, row, size, m_radii[i]);
  }
  m_dense->run();
  for (int i = 0; i < m_equalities; ++i) {
    Row& row = m_rows[i];
    row.unknown = i < m_dense->rank() ? m_dense->unknown(i) : -1;
    row.multiples.clear();
    for (int k = 0; k < m_equalities; ++k)
      if (const double part = m_dense->part(i, k); part != 0)
        row.multiples.emplace_back(m_system.equalities()[m_dense->equation(k)], part);
  }
  return m_dense->rank() > 0 && has_finite_multiples();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_rows::eliminate_sparsely()
{
  m_sparse->begin();
  visit_equalities([&](int i, int j, double slope) { m_sparse->add_entry(i, j, slope); },
                   [&](int i, double radius) { m_sparse->set_radius(i, radius); });
  m_sparse->run(m_check);
  int count = 0;
  const auto add_row = [&](int i) {
    Row& row = m_rows[count++];
    row.unknown = m_sparse->pivot(i);
    row.multiples.clear();
    for (const auto& [k, part] : m_sparse->multipliers(i))
      row.multiples.emplace_back(m_system.equalities()[k], part);
  };
  const std::vector<int>& solved_rows = m_sparse->solved_rows();
  std::for_each(solved_rows.rbegin(), solved_rows.rend(), add_row);
  for (int i = 0; i < m_dimension; ++i)
    if (m_sparse->pivot(i) < 0)
      add_row(i);
  return !solved_rows.empty() && has_finite_multiples();
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
  for (const Row& row : m_rows)
    for (const auto& [k, part] : row.multiples)
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
