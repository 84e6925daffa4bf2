// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LINEAR_ENCLOSURE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LINEAR_ENCLOSURE_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/allocate_parts.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Row_elimination.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

The equalities of a node as linear equations with interval right-hand sides, and their preconditioned form.

Every solution s of the node satisfies A s + g = 0 for some g in [lower, upper]. A sparse system is never expanded for
it: A is read off the affine enclosures. With C an approximate inverse of A on those equations and unknowns where it
pays, (C A) s + C g = 0 holds as well, and where C A is close to the identity each row bounds one unknown. Products are
\f$O(m^2 n)\f$, no tensor is formed.
*/
class Linear_enclosure
{
  int m_dimension, m_equations;
  std::vector<double> m_numbers;   // all of the following lies in one piece
  std::vector<int> m_indices;
  std::span<double> m_inverse;                         // C: equations x equations
  std::span<double> m_middle, m_half_width, m_size;    // of the right-hand sides; sums of absolute values of the rows
  std::span<int> m_pivot_of_row;                       // unknown that a row was solved for, or -1
  std::span<int> m_row_of;                             // of a pivot's unknown
  std::span<double> m_product, m_lower, m_upper;       // C A and C g
  std::span<double> m_centre, m_reach;                 // per unknown: its row's bound, centre and half width
  internal::Row_elimination<0> m_elimination;          // of more rows than it pays to tell apart
  int m_rank = 0;

public:
  Linear_enclosure(int dimension, int equations);
  //! not copied: parts of it are looked at.
  Linear_enclosure(const Linear_enclosure&) = delete;
  Linear_enclosure& operator=(const Linear_enclosure&) = delete;

  //! contracts the box by each equation as it stands; false when no solution is left.
  bool contract_by_equations(Node_view& node, Local_box& box) const;

  //! forms the preconditioned rows.
  void precondition(Node_view& node);

  //! contracts the box by the preconditioned rows; false when no solution is left.
  bool contract_by_preconditioned(Local_box& box) const
  {
    return contract_by_rows(m_product.data(), [&](int i) { return std::pair(m_lower[i], m_upper[i]); }, box);
  }

  //! number of unknowns.
  int dimension() const { return m_dimension; }
  //! number of equations.
  int equations() const { return m_equations; }

  //! every unknown has a row of its own: C is an approximate (left) inverse.
  bool has_inverse() const { return m_rank == m_dimension; }

  //! the image of the whole node under s -> s - C f(s): all solutions of the node lie in [centre - reach, centre +
  //! reach] on each axis. Only with an inverse.
  double centre(int j) const { return m_centre[j]; }
  double reach(int j) const { return m_reach[j]; }

  //! contracts the box to that image; false when no solution is left. Cheaper than the rows, which say little more.
  //! Only with an inverse.
  bool contract_by_image(Local_box& box) const;

  //! C, with a row per equation: a product of elementary matrices, and so regular but for rounding.
  const double* matrix() const { return m_inverse.data(); }

  //! row of C for the unknown j: f_j' = sum_k inverse(j, k) f_k is close to s_j.
  const double* inverse_row(int j) const { return m_inverse.data() + m_row_of[j] * m_equations; }

  //! the errors of the functions make up a good part of the width of some preconditioned row, and keep its unknown from
  //! being known well.
  bool is_blurred_by(const std::vector<double>& errors) const;

private:
  static constexpr int largest_known_size = 4;   // beyond, it does not matter
  int known_size() const { return m_dimension == m_equations && m_dimension <= largest_known_size ? m_dimension : 0; }

  // run(integral_constant<int, size>), with the number of equations and of unknowns known to the compiler; 0: not
  // known.
  template <class Run>
  void run_with_size(const Run& run) const
  {
    internal::run_with_constant<largest_known_size>(known_size(), run);
  }

  // `rest(i)`: the bounds of what the row leaves of an equation.
  template <class Rest>
  bool contract_by_rows(const double* rows, const Rest& rest, Local_box& box) const
  {
    bool is_left = true;
    run_with_size([&](auto size) {
      const int n = size > 0 ? size : m_dimension;
      for (int i = 0; i < m_equations && is_left; ++i) {
        const auto [lower, upper] = rest(i);
        is_left = contract_by_row<size>(rows + i * n, lower, upper, box);
      }
    });
    return is_left;
  }

  template <int size>
  void precondition_with(Node_view& node, internal::Row_elimination<size>& elimination);
  template <int size, class Row>
  void multiply(const internal::Row_elimination<size>& elimination, Row row, const double* slopes);
  template <int size>
  bool contract_by_row(const double* row, double lower, double upper, Local_box& box) const;
};

// 0 = row s + [lower, upper]: each unknown lies in what the others leave it.
template <int size>
bool Linear_enclosure::contract_by_row(const double* row, double lower, double upper, Local_box& box) const
{
  const int n = size > 0 ? size : m_dimension;
  double sum_lower = lower, sum_upper = upper, row_size = (std::max)(std::abs(lower), std::abs(upper));
  for (int k = 0; k < n; ++k) {
    const double a = row[k], u = a * box.lower[k], v = a * box.upper[k];
    sum_lower += (std::min)(u, v);
    sum_upper += (std::max)(u, v);
    row_size += std::abs(a);
  }
  const double error = internal::analysis_error * row_size;
  sum_lower -= error;
  sum_upper += error;
  if (sum_lower > 0 || sum_upper < 0)
    return false;
  for (int k = 0; k < n; ++k) {
    const double a = row[k];
    if (std::abs(a) * 0x1p30 < row_size)
      continue;
    // a s_k in -[sum without its own part]; taking the part out again doubles the rounding error at most
    const double u = a * box.lower[k], v = a * box.upper[k], own_lower = (std::min)(u, v), own_upper = (std::max)(u, v);
    const double rest_lower = sum_lower - own_lower - error, rest_upper = sum_upper - own_upper + error;
    if (-rest_upper <= own_lower && -rest_lower >= own_upper)
      continue;   // nothing to gain, as is found without a division
    double lo = -rest_upper / a, hi = -rest_lower / a;
    if (a < 0)
      std::swap(lo, hi);
    const double slack = internal::analysis_error * (std::max)(std::abs(lo), std::abs(hi));
    if (!box.intersect(k, lo - slack, hi + slack))
      return false;
  }
  return true;
}

template <int size>
void Linear_enclosure::precondition_with(Node_view& node, internal::Row_elimination<size>& elimination)
{
  const int n = elimination.columns(), m = elimination.rows();
  const double* slopes = m == 0 ? nullptr : node.slopes(0);
  for (int i = 0; i < m; ++i) {
    double row_size = 0;
    for (int k = 0; k < n; ++k)
      row_size += std::abs(slopes[i * n + k]);
    const double lo = node.rest_lower(i), hi = node.rest_upper(i);
    m_middle[i] = 0.5 * (lo + hi);
    m_half_width[i] = 0.5 * (hi - lo);
    m_size[i] = (std::max)(std::abs(lo), std::abs(hi)) + row_size;
    elimination.set_row(i, slopes + i * n, row_size, m_half_width[i]);
  }
  elimination.run();
  m_rank = elimination.rank();
  const auto multiply_row = [&](auto row) { multiply<size>(elimination, row, slopes); };
  if constexpr (size > 0)
    internal::unroll<size>(multiply_row);
  else
    for (int row = 0; row < m; ++row)
      multiply_row(row);
}

// A row of C A and C g with its rounding errors, from the original rows: elimination may be as inaccurate as it likes.
// What it says of its unknown: three roundings, of the reciprocal and the products, are small beside the analysis
// error.
template <int size, class Row>
BOOST_FORCEINLINE void Linear_enclosure::multiply(const internal::Row_elimination<size>& elimination, Row row,
                                                  const double* slopes)
{
  const int n = elimination.columns(), m = elimination.rows(), equation = elimination.equation(row);
  double sums[size + 1], *inverse = m_inverse.data() + equation * m,
                         *product = size > 0 ? sums : m_product.data() + equation * n;
  double middle = 0, radius = 0, row_size = 0;
  std::fill_n(product, n, 0.0);
  for (int k = 0; k < m; ++k) {
    const double c = elimination.part(row, k);
    const int other = elimination.equation(k);
    inverse[other] = c;
    if (size == 0 && c == 0)
      continue;
    for (int j = 0; j < n; ++j)
      product[j] += c * slopes[other * n + j];
    middle += c * m_middle[other];
    radius += std::abs(c) * m_half_width[other];
    row_size += std::abs(c) * m_size[other];
  }
  if constexpr (size > 0)
    std::copy_n(sums, n, m_product.data() + equation * n);
  radius += internal::analysis_error * row_size;   // also covers the rounding of the products, as |s| <= 1/2
  const double lower = m_lower[equation] = middle - radius, upper = m_upper[equation] = middle + radius;
  m_pivot_of_row[equation] = row < m_rank ? elimination.unknown(row) : -1;
  if (row >= m_rank)
    return;
  const int pivot = elimination.unknown(row);
  m_row_of[pivot] = equation;
  if (m_rank < n)
    return;
  double reach = 0.5 * (upper - lower);
  for (int j = 0; j < n; ++j)
    reach += j == pivot ? 0 : 0.5 * std::abs(product[j]);
  const double factor = 1 / product[pivot], magnitude = (std::max)(std::abs(lower), std::abs(upper));
  m_centre[pivot] = -0.5 * (lower + upper) * factor;
  m_reach[pivot] = (reach + internal::analysis_error * (magnitude + reach)) * std::abs(factor);
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Linear_enclosure::Linear_enclosure(int dimension, int equations)
  : m_dimension(dimension), m_equations(equations),
    m_elimination(known_size() > 0 ? 0 : equations, known_size() > 0 ? 0 : dimension)
{
  const std::size_t n = dimension, m = equations;
  internal::allocate_parts<double>(m_numbers,
                                   {{&m_inverse, m * m},
                                    {&m_middle, m},
                                    {&m_half_width, m},
                                    {&m_size, m},
                                    {&m_product, m * n},
                                    {&m_lower, m},
                                    {&m_upper, m},
                                    {&m_centre, n},
                                    {&m_reach, n}});
  internal::allocate_parts<int>(m_indices, {{&m_pivot_of_row, m}, {&m_row_of, n}});
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Linear_enclosure::contract_by_equations(Node_view& node, Local_box& box) const
{
  const double* slopes = node.slopes(0);
  return contract_by_rows(
      slopes, [&](int i) { return std::pair(node.rest_lower(i), node.rest_upper(i)); }, box);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Linear_enclosure::contract_by_image(Local_box& box) const
{
  bool is_left = true;
  for (int j = 0; j < m_dimension; ++j)
    is_left = box.intersect(j, m_centre[j] - m_reach[j], m_centre[j] + m_reach[j]) && is_left;
  return is_left;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Linear_enclosure::is_blurred_by(const std::vector<double>& errors) const
{
  for (int i = 0; i < m_equations; ++i) {
    double error = 0;
    for (int k = 0; k < m_equations; ++k)
      error += std::abs(m_inverse[i * m_equations + k]) * errors[k];
    if (64 * error > m_upper[i] - m_lower[i] && (m_pivot_of_row[i] < 0 || error > 0x1p-12)) // pivots are one
      return true;
  }
  return false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Linear_enclosure::precondition(Node_view& node)
{
  run_with_size([&](auto size) {
    if constexpr (size > 0) {
      internal::Row_elimination<size> elimination(size, size);
      precondition_with<size>(node, elimination);
    } else
      precondition_with<size>(node, m_elimination);
  });
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LINEAR_ENCLOSURE_H
