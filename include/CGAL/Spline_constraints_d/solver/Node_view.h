// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H

#include <CGAL/Spline_constraints_d/solver/System_layout.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A bound on the relative error of a sum or product of the few dozen terms that occur in the analysis of a node, in any rounding mode.
Everything below computes in plain double and widens its result by this much of the sum of absolute values, so that no proof hangs on the rounding mode.
*/
constexpr double analysis_error = 0x1p-45;

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

What the policies of the solver see of a node: all functions of the system on one box, in the local coordinates \f$s \in [-1/2,1/2]^n\f$.

Every node looks the same here, whatever the number type it is computed in: double Bernstein coefficients and, per block and function, a
bound on their error. All quantities are enclosures; those that cost a pass over the coefficients are computed on demand.
*/
class Node_view
{
  const internal::System_layout* m_layout;
  const double* m_coefficients = nullptr;
  const double* m_errors = nullptr;
  bool m_has_affine = false, m_has_derivatives = false;

  std::vector<double> m_block_lower, m_block_upper;            // per block and function
  std::vector<double> m_hull_lower, m_hull_upper;              // per function
  std::vector<double> m_slopes, m_rest_lower, m_rest_upper;    // affine enclosure
  std::vector<double> m_derivative_lower, m_derivative_upper;  // functions x unknowns
  std::vector<double> m_row, m_base, m_block_slopes;
  std::vector<int> m_index;

public:
  explicit Node_view(const internal::System_layout& layout);

  //! looks at other coefficients; nothing is computed yet.
  void reset(const double* coefficients, const double* errors)
  {
    m_coefficients = coefficients;
    m_errors = errors;
    m_has_affine = m_has_derivatives = false;
  }

  //! number of unknowns.
  int dimension() const { return m_layout->dimension; }
  //! number of equalities; functions with a larger index belong to inequalities.
  int equalities() const { return m_layout->equalities; }
  //! number of all functions.
  int functions() const { return m_layout->functions; }

  //! the blocks that hold the coefficients.
  const internal::System_layout& layout() const { return *m_layout; }
  //! the coefficients, laid out as `layout()` says.
  const double* coefficients() const { return m_coefficients; }
  //! the error bounds per block and function.
  const double* errors() const { return m_errors; }

  //! bounds of the function on the box.
  double lower(int f) { compute_affine(); return m_hull_lower[f]; }
  double upper(int f) { compute_affine(); return m_hull_upper[f]; }

  //! bounds of one block's part of a function; `entry` is `Block::first_error` + place of the function in the block.
  double block_lower(std::size_t entry) { compute_affine(); return m_block_lower[entry]; }
  double block_upper(std::size_t entry) { compute_affine(); return m_block_upper[entry]; }

  //! the function is `sum_j slope(f)[j] s_j` + something in `[rest_lower(f), rest_upper(f)]`.
  const double* slopes(int f) { compute_affine(); return m_slopes.data() + static_cast<std::size_t>(f) * dimension(); }
  double rest_lower(int f) { compute_affine(); return m_rest_lower[f]; }
  double rest_upper(int f) { compute_affine(); return m_rest_upper[f]; }

  //! bounds of the partial derivatives of a function on the box, one per unknown, in local coordinates.
  const double* derivative_lower(int f) { compute_derivatives(); return m_derivative_lower.data() + static_cast<std::size_t>(f) * dimension(); }
  const double* derivative_upper(int f) { compute_derivatives(); return m_derivative_upper.data() + static_cast<std::size_t>(f) * dimension(); }

private:
  void compute_affine();
  void compute_derivatives();
  void add_block(const internal::Block& block);
};

inline Node_view::Node_view(const internal::System_layout& layout)
  : m_layout(&layout)
{
  const std::size_t functions = layout.functions, entries = functions * layout.dimension;
  std::size_t row = 1, members = 1, slopes = 1, axes = 1;
  for (const internal::Block& block : layout.blocks) {
    const std::size_t m = block.functions.size();
    row = (std::max)(row, m * (block.degrees.empty() ? 1 : block.degrees.back() + 1));
    members = (std::max)(members, m);
    slopes = (std::max)(slopes, m * block.axes.size());
    axes = (std::max)(axes, block.axes.size());
  }
  for (auto* v : {&m_block_lower, &m_block_upper})
    v->resize(layout.errors);
  for (auto* v : {&m_hull_lower, &m_hull_upper, &m_rest_lower, &m_rest_upper})
    v->resize(functions);
  for (auto* v : {&m_slopes, &m_derivative_lower, &m_derivative_upper})
    v->resize(entries);
  m_row.resize(5 * row);
  m_base.resize(members);
  m_block_slopes.resize(slopes);
  m_index.resize(axes);
}

inline void Node_view::compute_affine()
{
  if (m_has_affine)
    return;
  m_has_affine = true;
  for (auto* v : {&m_hull_lower, &m_hull_upper, &m_rest_lower, &m_rest_upper, &m_slopes})
    std::fill(v->begin(), v->end(), 0.0);
  for (const internal::Block& block : m_layout->blocks)
    add_block(block);
}

// The slope along an axis is the mean of the last layer minus the mean of the first; what the linear function leaves of the control net
// (its value at the Greville abscissae k/d subtracted) bounds the rest.
inline void Node_view::add_block(const internal::Block& block)
{
  const std::size_t members = block.functions.size(), axes = block.axes.size();
  const double* data = m_coefficients + block.offset;
  double* slopes = m_block_slopes.data();   // axes x members
  std::fill_n(slopes, axes * members, 0.0);
  for (std::size_t j = 0; j < axes; ++j) {
    const internal::Axis_view view = block.view(j);
    if (view.degree == 0)
      continue;
    const std::size_t line = view.inner * (view.degree + 1), end = view.inner * view.degree;
    const double scale = 1.0 / static_cast<double>(view.outer * view.inner / members);
    double* slope = slopes + j * members;
    for (std::size_t o = 0; o < view.outer; ++o) {
      const double* first = data + o * line;
      for (std::size_t i = 0; i < view.inner; i += members)
        for (std::size_t m = 0; m < members; ++m)
          slope[m] += first[end + i + m] - first[i + m];
    }
    for (std::size_t m = 0; m < members; ++m)
      slope[m] *= scale;
  }

  // Rows run along the last axis: position k of function m stands at k * members + m.
  const std::size_t last = axes == 0 ? 0 : block.degrees.back();
  const std::size_t row = (last + 1) * members;
  double *line = m_row.data(), *least = line + row, *most = least + row, *rest_least = most + row, *rest_most = rest_least + row;
  for (std::size_t k = 0; k <= last; ++k)
    for (std::size_t m = 0; m < members; ++m)
      line[k * members + m] = last == 0 ? 0.0 : slopes[(axes - 1) * members + m] * (static_cast<double>(k) / last - 0.5);
  for (std::size_t i = 0; i < row; ++i) {
    least[i] = rest_least[i] = HUGE_VAL;
    most[i] = rest_most[i] = -HUGE_VAL;
  }
  std::fill_n(m_base.begin(), members, 0.0);
  std::fill_n(m_index.begin(), axes, 0);
  for (std::size_t j = 0; j + 1 < axes; ++j)
    if (block.degrees[j] > 0)
      for (std::size_t m = 0; m < members; ++m)
        m_base[m] -= 0.5 * slopes[j * members + m];
  const std::size_t rows = block.points / (last + 1);
  for (std::size_t r = 0; r < rows; ++r, data += row) {
    for (std::size_t k = 0, i = 0; k <= last; ++k)
      for (std::size_t m = 0; m < members; ++m, ++i) {
        const double value = data[i];
        const double rest = value - (line[i] + m_base[m]);
        least[i] = value < least[i] ? value : least[i];
        most[i] = value > most[i] ? value : most[i];
        rest_least[i] = rest < rest_least[i] ? rest : rest_least[i];
        rest_most[i] = rest > rest_most[i] ? rest : rest_most[i];
      }
    for (std::size_t j = axes - 1; r + 1 < rows && j-- > 0;) {   // next row: odometer over the other axes
      if (block.degrees[j] == 0)
        continue;
      const double* slope = slopes + j * members;
      if (++m_index[j] <= block.degrees[j]) {
        for (std::size_t m = 0; m < members; ++m)
          m_base[m] += slope[m] / block.degrees[j];
        break;
      }
      m_index[j] = 0;
      for (std::size_t m = 0; m < members; ++m)
        m_base[m] -= slope[m];
    }
  }

  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t k = 1; k <= last; ++k) {
      const std::size_t i = k * members + m;
      least[m] = (std::min)(least[m], least[i]);
      most[m] = (std::max)(most[m], most[i]);
      rest_least[m] = (std::min)(rest_least[m], rest_least[i]);
      rest_most[m] = (std::max)(rest_most[m], rest_most[i]);
    }
    const int f = block.functions[m];
    const double error = m_errors[block.first_error + m];
    double total = (std::max)(std::abs(least[m]), std::abs(most[m]));
    const double hull_error = error + internal::analysis_error * total;
    for (std::size_t j = 0; j < axes; ++j) {
      total += std::abs(slopes[j * members + m]);
      m_slopes[static_cast<std::size_t>(f) * m_layout->dimension + block.axes[j]] += slopes[j * members + m];
    }
    const double rest_error = error + internal::analysis_error * total;
    m_block_lower[block.first_error + m] = least[m] - hull_error;
    m_block_upper[block.first_error + m] = most[m] + hull_error;
    m_hull_lower[f] += least[m] - hull_error;
    m_hull_upper[f] += most[m] + hull_error;
    m_rest_lower[f] += rest_least[m] - rest_error;
    m_rest_upper[f] += rest_most[m] + rest_error;
  }
}

inline void Node_view::compute_derivatives()
{
  if (m_has_derivatives)
    return;
  compute_affine();
  m_has_derivatives = true;
  std::fill(m_derivative_lower.begin(), m_derivative_lower.end(), 0.0);
  std::fill(m_derivative_upper.begin(), m_derivative_upper.end(), 0.0);
  for (const internal::Block& block : m_layout->blocks) {
    const std::size_t members = block.functions.size();
    double *lower = m_row.data(), *upper = lower + members;
    for (std::size_t j = 0; j < block.axes.size(); ++j) {
      const internal::Axis_view view = block.view(j);
      if (view.degree == 0)
        continue;
      internal::difference_bounds(m_coefficients + block.offset, view, members, lower, upper);
      for (std::size_t m = 0; m < members; ++m) {
        const std::size_t entry = static_cast<std::size_t>(block.functions[m]) * m_layout->dimension + block.axes[j];
        const double size = (std::max)(std::abs(m_block_lower[block.first_error + m]), std::abs(m_block_upper[block.first_error + m]));
        const double error = 2 * m_errors[block.first_error + m] + internal::analysis_error * size;
        m_derivative_lower[entry] += view.degree * (lower[m] - error);
        m_derivative_upper[entry] += view.degree * (upper[m] + error);
      }
    }
  }
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
