// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LINEAR_ENCLOSURE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LINEAR_ENCLOSURE_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/allocate_parts.h>
#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>

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

Every solution s of the node satisfies A s + g = 0 for some g in [lower, upper]. A sparse system is never expanded for it: A is read off the
affine enclosures. With C an approximate inverse of A on those equations and unknowns where it pays, (C A) s + C g = 0 holds as well, and
where C A is close to the identity each row bounds one unknown. Products are \f$O(m^2 n)\f$, no tensor is formed.
*/
class Linear_enclosure
{
  int m_dimension, m_equations;
  std::vector<double> m_numbers;   // all of the following lies in one piece
  std::vector<int> m_indices;
  std::span<double> m_inverse;                         // C: equations x equations
  std::span<double> m_work;                            // A, eliminated in place: the column of a pivot holds that of its row in C
  std::span<double> m_middle, m_half_width, m_size;    // of the right-hand sides; sums of absolute values of the rows
  std::span<double> m_radius;                          // of the right-hand sides, carried through the elimination
  std::span<int> m_pivot_of_row;                       // unknown that a row was solved for, or -1
  std::span<int> m_row_of;                             // of a pivot's unknown, or -1
  std::span<double> m_product, m_lower, m_upper;       // C A and C g
  std::span<double> m_centre, m_reach;                 // per unknown: its row's bound, centre and half width
  std::span<double> m_scale;
  int m_rank = 0;

public:
  Linear_enclosure(int dimension, int equations)
    : m_dimension(dimension), m_equations(equations)
  {
    const std::size_t n = dimension, m = equations;
    internal::allocate_parts<double>(m_numbers, {{&m_inverse, m * m}, {&m_work, m * n}, {&m_middle, m}, {&m_half_width, m}, {&m_size, m}, {&m_radius, m}, {&m_product, m * n},
                                                 {&m_lower, m}, {&m_upper, m}, {&m_centre, n}, {&m_reach, n}, {&m_scale, m}});
    internal::allocate_parts<int>(m_indices, {{&m_pivot_of_row, m}, {&m_row_of, n}});
  }
  //! not copied: parts of it are looked at.
  Linear_enclosure(const Linear_enclosure&) = delete;
  Linear_enclosure& operator=(const Linear_enclosure&) = delete;

  //! contracts the box by each equation as it stands; false when no solution is left.
  bool contract_by_equations(Node_view& node, Local_box& box) const
  {
    const double* slopes = node.slopes(0);
    return contract_by_rows(slopes, [&](int i) { return std::pair(node.rest_lower(i), node.rest_upper(i)); }, box);
  }

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

  //! the image of the whole node under s -> s - C f(s): all solutions of the node lie in [centre - reach, centre + reach] on each axis.
  //! Only with an inverse.
  double centre(int j) const { return m_centre[j]; }
  double reach(int j) const { return m_reach[j]; }

  //! contracts the box to that image; false when no solution is left. Cheaper than the rows, which say little more. Only with an inverse.
  bool contract_by_image(Local_box& box) const
  {
    bool is_left = true;
    for (int j = 0; j < m_dimension; ++j)
      is_left = box.intersect(j, m_centre[j] - m_reach[j], m_centre[j] + m_reach[j]) && is_left;
    return is_left;
  }

  //! C, with a row per equation: a product of elementary matrices, and so regular but for rounding.
  const double* matrix() const { return m_inverse.data(); }

  //! row of C for the unknown j: f_j' = sum_k inverse(j, k) f_k is close to s_j.
  const double* inverse_row(int j) const { return m_inverse.data() + m_row_of[j] * m_equations; }

  //! the errors of the functions make up a good part of the width of some preconditioned row, and keep its unknown from being known well.
  bool is_blurred_by(const std::vector<double>& errors) const
  {
    for (int i = 0; i < m_equations; ++i) {
      double error = 0;
      for (int k = 0; k < m_equations; ++k)
        error += std::abs(m_inverse[i * m_equations + k]) * errors[k];
      if (64 * error > m_upper[i] - m_lower[i] && (m_pivot_of_row[i] < 0 || error > 0x1p-12))   // pivots are one
        return true;
    }
    return false;
  }

private:
  // run(integral_constant<int, size>), with the number of equations and of unknowns known to the compiler; 0: not known.
  template <class Run>
  void run_with_size(const Run& run) const
  {
    constexpr int largest = 4;   // beyond, it does not matter
    internal::run_with_constant<largest>(m_dimension == m_equations ? m_dimension : 0, run);
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
  void eliminate(Node_view& node);
  template <int size>
  void multiply(Node_view& node);
  template <int size>
  void bound_unknowns();
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

inline void Linear_enclosure::precondition(Node_view& node)
{
  run_with_size([&](auto size) {
    eliminate<size>(node);
    multiply<size>(node);
    if (has_inverse())
      bound_unknowns<size>();
  });
}

// Gauss-Jordan with full pivoting, rows weighed by what they can still contract: a row whose interval part is larger than half its pivot bounds nothing and would
// only blur the others, so elimination stops there (in a huge box the linear equations are solved and the rest waits).
template <int size>
void Linear_enclosure::eliminate(Node_view& node)
{
  const int n = size > 0 ? size : m_dimension, m = size > 0 ? size : m_equations;
  m_rank = 0;
  const double* slopes = m == 0 ? nullptr : node.slopes(0);
  for (int i = 0; i < m; ++i) {
    double row_size = 0;
    for (int k = 0; k < n; ++k) {
      m_work[i * n + k] = slopes[i * n + k];
      row_size += std::abs(slopes[i * n + k]);
    }
    const double lo = node.rest_lower(i), hi = node.rest_upper(i);
    m_middle[i] = 0.5 * (lo + hi);
    m_half_width[i] = m_radius[i] = 0.5 * (hi - lo);
    m_size[i] = (std::max)(std::abs(lo), std::abs(hi)) + row_size;
    const double total = row_size + 2 * m_radius[i];
    m_scale[i] = total > 0 ? 1 / total : 0;
    m_pivot_of_row[i] = -1;
  }
  std::fill_n(m_row_of.begin(), n, -1);
  while (m_rank < m && m_rank < n) {
    int pivot_row = -1, pivot = -1;
    double best = 1e-16;
    for (int i = 0; i < m; ++i) {
      if (m_pivot_of_row[i] >= 0)
        continue;
      const double *row = m_work.data() + i * n, scale = m_scale[i], least = 2 * m_radius[i];
      for (int k = 0; k < n; ++k) {
        const double a = std::abs(row[k]);
        if (m_row_of[k] < 0 && a * scale > best && least < a) {
          best = a * scale;
          pivot_row = i;
          pivot = k;
        }
      }
    }
    if (pivot_row < 0)
      break;
    ++m_rank;
    m_pivot_of_row[pivot_row] = pivot;
    m_row_of[pivot] = pivot_row;
    double* row = m_work.data() + pivot_row * n;
    const double factor = 1 / row[pivot];
    for (int k = 0; k < n; ++k)
      row[k] = k == pivot ? factor : factor * row[k];
    m_radius[pivot_row] *= std::abs(factor);
    for (int i = 0; i < m; ++i) {
      double* other = m_work.data() + i * n;
      const double a = other[pivot];
      if (i == pivot_row || a == 0)
        continue;
      for (int k = 0; k < n; ++k)
        other[k] = (k == pivot ? 0 : other[k]) - a * row[k];
      m_radius[i] += std::abs(a) * m_radius[pivot_row];
    }
  }
  std::fill_n(m_inverse.begin(), m * m, 0.0);
  for (int i = 0; i < m; ++i) {
    m_inverse[i * m + i] = 1;
    for (int k = 0; k < m; ++k)
      if (m_pivot_of_row[k] >= 0)
        m_inverse[i * m + k] = m_work[i * n + m_pivot_of_row[k]];
  }
}

// C A and C g with their rounding errors, from the original rows: elimination may be as inaccurate as it likes.
template <int size>
void Linear_enclosure::multiply(Node_view& node)
{
  const int n = size > 0 ? size : m_dimension, m = size > 0 ? size : m_equations;
  const double* slopes = m == 0 ? nullptr : node.slopes(0);
  for (int i = 0; i < m; ++i) {
    double* product = m_product.data() + i * n;
    std::fill_n(product, n, 0.0);
    double middle = 0, radius = 0, row_size = 0;
    for (int k = 0; k < m; ++k) {
      const double c = m_inverse[i * m + k];
      if (c == 0)
        continue;
      for (int j = 0; j < n; ++j)
        product[j] += c * slopes[k * n + j];
      middle += c * m_middle[k];
      radius += std::abs(c) * m_half_width[k];
      row_size += std::abs(c) * m_size[k];
    }
    radius += internal::analysis_error * row_size;   // also covers the rounding of the products, as |s| <= 1/2
    m_lower[i] = middle - radius;
    m_upper[i] = middle + radius;
  }
}

// Three roundings, of the reciprocal and the products, are small beside the analysis error.
template <int size>
void Linear_enclosure::bound_unknowns()
{
  const int n = size > 0 ? size : m_dimension, m = size > 0 ? size : m_equations;
  for (int i = 0; i < m; ++i) {
    const int pivot = m_pivot_of_row[i];
    if (pivot < 0)
      continue;
    const double *row = m_product.data() + i * n, own = row[pivot], lower = m_lower[i], upper = m_upper[i];
    double reach = 0.5 * (upper - lower);
    for (int k = 0; k < n; ++k)
      reach += k == pivot ? 0 : 0.5 * std::abs(row[k]);
    const double factor = 1 / own, magnitude = (std::max)(std::abs(lower), std::abs(upper));
    m_centre[pivot] = -0.5 * (lower + upper) * factor;
    m_reach[pivot] = (reach + internal::analysis_error * (magnitude + reach)) * std::abs(factor);
  }
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LINEAR_ENCLOSURE_H
