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
  std::vector<double> m_work, m_base, m_block_slopes, m_layer_lower, m_layer_upper;
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

  //! calls `visit(j, lower, upper)` for every axis `j` of a block with the bounds of its layers of control points: entry `k * m + f` belongs to layer `k`
  //! of the `f`-th of the block's `m` functions. Costs about two passes over the block for all axes together.
  template <class Visitor>
  void visit_layers(const internal::Block& block, const Visitor& visit);

private:
  void compute_affine();
  void compute_derivatives();
  void add_block(const internal::Block& block);
  void compute_block_slopes(const internal::Block& block);
  void bound_row(const double* data, const double* line, std::size_t members, std::size_t row, double* least, double* most,
                 double* rest_least, double* rest_most);
  void add_differences(const internal::Block& block, std::size_t axis);

  // The linear function of a block at the Greville abscissa k of an axis.
  double linear_part(const internal::Block& block, std::size_t axis, std::size_t member, int k) const
  {
    const int degree = block.degrees[axis];
    return degree == 0 ? 0 : m_block_slopes[axis * block.functions.size() + member] * (static_cast<double>(k) / degree - 0.5);
  }
};

inline Node_view::Node_view(const internal::System_layout& layout)
  : m_layout(&layout)
{
  const std::size_t functions = layout.functions, entries = functions * layout.dimension;
  std::size_t size = 1, members = 1, slopes = 1, axes = 1, layers = 1;
  for (const internal::Block& block : layout.blocks) {
    const std::size_t m = block.functions.size();
    size = (std::max)(size, block.size());
    members = (std::max)(members, m);
    slopes = (std::max)(slopes, m * block.axes.size());
    axes = (std::max)(axes, block.axes.size());
    for (int degree : block.degrees)
      layers = (std::max)(layers, m * (degree + 1));
  }
  for (auto* v : {&m_layer_lower, &m_layer_upper})
    v->resize(layers);
  for (auto* v : {&m_block_lower, &m_block_upper})
    v->resize(layout.errors);
  for (auto* v : {&m_hull_lower, &m_hull_upper, &m_rest_lower, &m_rest_upper})
    v->resize(functions);
  for (auto* v : {&m_slopes, &m_derivative_lower, &m_derivative_upper})
    v->resize(entries);
  m_work.resize(5 * size);
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
  compute_block_slopes(block);
  const std::size_t members = block.functions.size(), axes = block.axes.size();

  // The linear function on the faster axes, tabulated; the slower ones contribute one number per row.
  const std::size_t row = block.stretch(block.size());
  const std::size_t slow = static_cast<std::size_t>(std::find(block.lengths.begin(), block.lengths.end(), row) - block.lengths.begin());
  double *line = m_work.data(), *least = line + row, *most = least + row, *rest_least = most + row, *rest_most = rest_least + row;
  std::fill_n(line, members, 0.0);
  for (std::size_t j = axes; j-- > slow;) {
    const std::size_t length = block.lengths[j + 1];
    for (int k = block.degrees[j]; k >= 0; --k)
      for (std::size_t i = 0; i < length; ++i)
        line[k * length + i] = line[i] + linear_part(block, j, i % members, k);
  }
  std::fill_n(least, row, HUGE_VAL);
  std::fill_n(most, row, -HUGE_VAL);
  std::fill_n(rest_least, row, HUGE_VAL);
  std::fill_n(rest_most, row, -HUGE_VAL);

  const double* data = m_coefficients + block.offset;
  std::fill_n(m_index.begin(), axes, 0);
  for (std::size_t r = 0; r < block.size() / row; ++r, data += row) {
    if (r > 0)   // odometer over the slower axes; their part of the linear function moves into the table
      for (std::size_t j = slow; j-- > 0;) {
        if (++m_index[j] <= block.degrees[j])
          break;
        m_index[j] = 0;
      }
    for (std::size_t m = 0; m < members; ++m) {
      m_base[m] = 0;
      for (std::size_t j = 0; j < slow; ++j)
        m_base[m] += linear_part(block, j, m, m_index[j]);
    }
    bound_row(data, line, members, row, least, most, rest_least, rest_most);
  }

  for (std::size_t m = 0; m < members; ++m) {
    for (std::size_t i = m + members; i < row; i += members) {
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
      const double slope = m_block_slopes[j * members + m];
      total += std::abs(slope);
      m_slopes[static_cast<std::size_t>(f) * m_layout->dimension + block.axes[j]] += slope;
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

// Sums over the slowest axis are taken once and serve all faster ones.
inline void Node_view::compute_block_slopes(const internal::Block& block)
{
  const std::size_t members = block.functions.size(), axes = block.axes.size();
  std::fill_n(m_block_slopes.begin(), axes * members, 0.0);
  const double* data = m_coefficients + block.offset;
  double points = 1;   // summed into each entry of `data`
  for (std::size_t j = 0; j < axes; ++j) {
    const std::size_t inner = block.lengths[j + 1], last = inner * block.degrees[j];
    double* slope = m_block_slopes.data() + j * members;
    if (last > 0) {
      const std::size_t stretch = block.stretch(inner);
      double* sum = m_work.data() + block.size();
      std::fill_n(sum, stretch, 0.0);
      for (std::size_t i = 0; i < inner; i += stretch)
        for (std::size_t k = 0; k < stretch; ++k)
          sum[k] += data[last + i + k] - data[i + k];
      for (std::size_t k = 0; k < stretch; k += members)
        for (std::size_t m = 0; m < members; ++m)
          slope[m] += sum[k + m];
      const double scale = static_cast<double>(members) / (points * static_cast<double>(inner));
      for (std::size_t m = 0; m < members; ++m)
        slope[m] *= scale;
    }
    if (j + 1 < axes) {
      double* total = m_work.data();
      for (std::size_t i = 0; i < inner; ++i)
        total[i] = data[i];
      for (std::size_t k = inner; k <= last; k += inner)
        for (std::size_t i = 0; i < inner; ++i)
          total[i] += data[k + i];
      data = total;
      points *= block.degrees[j] + 1;
    }
  }
}

inline void Node_view::bound_row(const double* __restrict data, const double* __restrict line, std::size_t members,
                                 std::size_t row, double* __restrict least, double* __restrict most,
                                 double* __restrict rest_least, double* __restrict rest_most)
{
  const auto widen = [&](std::size_t i, double base) {
    const double value = data[i], rest = value - (line[i] + base);
    least[i] = value < least[i] ? value : least[i];
    most[i] = value > most[i] ? value : most[i];
    rest_least[i] = rest < rest_least[i] ? rest : rest_least[i];
    rest_most[i] = rest > rest_most[i] ? rest : rest_most[i];
  };
  if (members == 1) {
    const double base = m_base[0];
    for (std::size_t i = 0; i < row; ++i)
      widen(i, base);
  } else
    for (std::size_t i = 0; i < row; i += members)
      for (std::size_t m = 0; m < members; ++m)
        widen(i + m, m_base[m]);
}

inline void Node_view::compute_derivatives()
{
  if (m_has_derivatives)
    return;
  compute_affine();
  m_has_derivatives = true;
  std::fill(m_derivative_lower.begin(), m_derivative_lower.end(), 0.0);
  std::fill(m_derivative_upper.begin(), m_derivative_upper.end(), 0.0);
  for (const internal::Block& block : m_layout->blocks)
    for (std::size_t j = 0; j < block.axes.size(); ++j)
      if (block.degrees[j] > 0)
        add_differences(block, j);
}

// Differences along an axis: where one step along it fills a vector, over pieces of such steps; else over whole lines, leaving out the differences that
// reach from one line into the next.
inline void Node_view::add_differences(const internal::Block& block, std::size_t axis)
{
  const std::size_t members = block.functions.size(), inner = block.lengths[axis + 1], line = block.lengths[axis];
  const double* data = m_coefficients + block.offset;
  const bool is_long = inner >= 16;
  const std::size_t stretch = is_long ? block.stretch(inner) : (std::max)(line, block.stretch(block.size()));
  double *lower = m_work.data(), *upper = lower + stretch;
  std::fill_n(lower, stretch, HUGE_VAL);
  std::fill_n(upper, stretch, -HUGE_VAL);
  if (is_long)
    for (std::size_t o = 0; o < block.size(); o += line)
      for (std::size_t i = o; i < o + line - inner; i += stretch)
        internal::widen_by_differences(data + i, inner, lower, upper, stretch);
  else
    for (std::size_t o = 0; o < block.size(); o += stretch)
      internal::widen_by_differences(data + o, inner, lower, upper, stretch - inner);

  for (std::size_t m = 0; m < members; ++m) {
    double least = HUGE_VAL, most = -HUGE_VAL;
    for (std::size_t i = m; i < stretch; i += members)
      if (is_long || i % line < line - inner) {
        least = (std::min)(least, lower[i]);
        most = (std::max)(most, upper[i]);
      }
    const std::size_t entry = static_cast<std::size_t>(block.functions[m]) * m_layout->dimension + block.axes[axis];
    const double size = (std::max)(std::abs(m_block_lower[block.first_error + m]), std::abs(m_block_upper[block.first_error + m]));
    const double error = 2 * m_errors[block.first_error + m] + internal::analysis_error * size;
    m_derivative_lower[entry] += block.degrees[axis] * (least - error);
    m_derivative_upper[entry] += block.degrees[axis] * (most + error);
  }
}

// Bounds over the slowest axis are taken once and serve all faster ones.
template <class Visitor>
void Node_view::visit_layers(const internal::Block& block, const Visitor& visit)
{
  const std::size_t members = block.functions.size();
  const double *lower = m_coefficients + block.offset, *upper = lower;
  double* work = m_work.data() + 2 * block.size();
  for (std::size_t j = 0; j < block.axes.size(); ++j) {
    const std::size_t inner = block.lengths[j + 1], stretch = block.stretch(inner);
    const int degree = block.degrees[j];
    for (int k = 0; k <= degree; ++k)
      internal::bound_functions(lower + k * inner, upper + k * inner, inner, stretch, members, work,
                                m_layer_lower.data() + k * members, m_layer_upper.data() + k * members);
    visit(j, m_layer_lower.data(), m_layer_upper.data());
    if (j + 1 == block.axes.size())
      break;
    double *all_lower = m_work.data(), *all_upper = all_lower + block.size();
    if (j == 0 || degree > 0) {
      for (std::size_t i = 0; i < inner; ++i) {
        all_lower[i] = lower[i];
        all_upper[i] = upper[i];
      }
      for (int k = 1; k <= degree; ++k)
        internal::widen(lower + k * inner, upper + k * inner, all_lower, all_upper, inner);
    }
    lower = all_lower;
    upper = all_upper;
  }
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
