// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H

#include <CGAL/Spline_constraints_d/function/affine_kernels.h>
#include <CGAL/Spline_constraints_d/internal/allocate_parts.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A bound on the relative error of a sum or product of the few dozen terms that occur in the analysis of a node, in any
rounding mode. Everything below computes in plain double and widens its result by this much of the sum of absolute
values, so that no proof hangs on the rounding mode.
*/
constexpr double analysis_error = 0x1p-45;

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

What the policies of the solver see of a node: all functions of the system on one box, in the local coordinates \f$s \in
[-1/2,1/2]^n\f$.

Every node looks the same here, whatever the number type it is computed in: double Bernstein coefficients and, per block
and function, a bound on their error. All quantities are enclosures; those that cost a pass over the coefficients are
computed on demand.
*/
class Node_view
{
  const internal::System_layout* m_layout;
  const double* m_coefficients = nullptr;
  const double* m_errors = nullptr;
  bool m_has_bounds = false, m_has_affine = false, m_has_derivatives = false;

  // What is known of a block before its coefficients are, and the passes over them, chosen for its numbers of functions
  // and axes.
  struct Plan
  {
    std::size_t over_first;          // of the bounds over its first axis
    std::size_t greville;            // of the first axis: k/d - 1/2, axis after axis
    std::size_t row, slow_axes;      // the linear part is tabulated on a row, over the axes from slow_axes on
    std::size_t layer_scales;        // of the first axis: one over the number of control points in a layer
    void (Node_view::*bound)(const internal::Block&, const Plan&) = nullptr;
    void (Node_view::*enclose)(const internal::Block&, const Plan&) = nullptr;
    void (Node_view::*bound_differences)(const internal::Block&, std::size_t axis) = nullptr;
  };
  static constexpr int most_axes_of_small = 4;   // as measured: enclose_small_block() is faster up to here
  static constexpr std::size_t most_coefficients_of_small = 1000;
  std::vector<Plan> m_plans;
  void (Node_view::*m_bound_sum_of_lines)() = nullptr;   // where all blocks are lines that hold all functions
  std::vector<double> m_greville, m_layer_scales, m_storage;   // all of the following lies in one piece

  std::span<double> m_block_lower, m_block_upper;            // per block and function
  std::span<double> m_hull, m_affine, m_derivatives;         // sums over the blocks, whose parts are
  std::span<double> m_hull_lower, m_hull_upper;              // per function
  std::span<double> m_slopes, m_rest_lower, m_rest_upper;    // affine enclosure
  std::span<double> m_derivative_lower, m_derivative_upper;  // functions x unknowns
  std::span<double> m_least_over_first, m_most_over_first;   // of each block, over its first axis
  std::span<double> m_work, m_base, m_block_slopes, m_layer_lower, m_layer_upper, m_block_rest_lower,
      m_block_rest_upper;
  // of blocks with one axis or none, per block and function
  std::span<double> m_line_slopes, m_line_rest_lower, m_line_rest_upper;
  std::vector<int> m_index;

public:
  explicit Node_view(const internal::System_layout& layout);
  //! not copied: parts of it are looked at.
  Node_view(const Node_view&) = delete;
  Node_view& operator=(const Node_view&) = delete;

  //! looks at other coefficients; nothing is computed yet.
  void reset(const double* coefficients, const double* errors)
  {
    m_coefficients = coefficients;
    m_errors = errors;
    m_has_bounds = m_has_affine = m_has_derivatives = false;
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
  double lower(int f) { compute_bounds(); return m_hull_lower[f]; }
  double upper(int f) { compute_bounds(); return m_hull_upper[f]; }

  //! bounds of one block's part of a function; `entry` is `Block::first_error` + place of the function in the block.
  double block_lower(std::size_t entry) { compute_bounds(); return m_block_lower[entry]; }
  double block_upper(std::size_t entry) { compute_bounds(); return m_block_upper[entry]; }

  //! the function is `sum_j slope(f)[j] s_j` + something in `[rest_lower(f), rest_upper(f)]`.
  const double* slopes(int f) { compute_affine(); return m_slopes.data() + static_cast<std::size_t>(f) * dimension(); }
  double rest_lower(int f) { compute_affine(); return m_rest_lower[f]; }
  double rest_upper(int f) { compute_affine(); return m_rest_upper[f]; }

  //! bounds of the partial derivatives of a function on the box, one per unknown, in local coordinates.
  const double* derivative_lower(int f)
  {
    compute_derivatives();
    return m_derivative_lower.data() + static_cast<std::size_t>(f) * dimension();
  }
  const double* derivative_upper(int f)
  {
    compute_derivatives();
    return m_derivative_upper.data() + static_cast<std::size_t>(f) * dimension();
  }

  //! calls `visit(j, lower, upper)` for every axis `j` of a block with the bounds of its layers of control points:
  //! entry `k * m + f` belongs to layer `k` of the `f`-th of the block's `m` functions. Costs about two passes over the
  //! block for all axes together.
  template <class Visitor>
  void visit_layers(const internal::Block& block, const Visitor& visit);

private:
  void compute_bounds()
  {
    if (!m_has_bounds)
      bound_blocks();
  }
  void compute_affine()
  {
    if (!m_has_affine)
      enclose_blocks();
  }
  void compute_derivatives()
  {
    if (!m_has_derivatives)
      bound_derivatives();
  }
  void bound_blocks();
  void enclose_blocks();
  void bound_derivatives();

  template <int members>
  void bound_block(const internal::Block& block, const Plan& plan);
  void enclose_line(const internal::Block& block, const Plan& plan);
  void add_enclosure(const internal::Block& block);
  template <int axes, int last_degree>
  void enclose_small_block(const internal::Block& block, const Plan& plan);
  template <int members>
  void enclose_block(const internal::Block& block, const Plan& plan);
  template <class Number>
  internal::Line_bounds<Number> bound_line_at(const internal::Block& block, const Plan& plan, std::size_t m,
                                              std::size_t functions);
  template <int members>
  void bound_line(const internal::Block& block, const Plan& plan);
  template <int members>
  void bound_sum_of_lines();
  template <int members>
  void compute_slopes(const internal::Block& block);
  template <int members>
  void tabulate(const internal::Block& block, const Plan& plan, double* line);
  template <int members>
  void bound_differences(const internal::Block& block, std::size_t axis);
  void bound_differences_of_line(const internal::Block& block, std::size_t axis);
  void add_derivatives(const internal::Block& block, std::size_t axis);

  void choose_passes(const internal::Block& block, Plan& plan);

  // The number of functions of a block; `members` is 0 for more than it pays to tell apart.
  template <int members>
  static std::size_t functions_of(const internal::Block& block)
  {
    return members > 0 ? static_cast<std::size_t>(members) : block.functions.size();
  }

  static bool is_line(const internal::Block& block) { return block.axes.size() <= 1; }

  // What varies faster than the first axis.
  static std::size_t inner_size(const internal::Block& block)
  {
    return block.axes.empty() ? block.functions.size() : block.lengths[1];
  }
};

inline Node_view::Node_view(const internal::System_layout& layout)
  : m_layout(&layout)
{
  const std::size_t functions = layout.functions, entries = functions * layout.dimension;
  std::size_t work = 1, members = 1, slopes = 1, layers = 1, over_first = 0, greville = 0;
  for (const internal::Block& block : layout.blocks)
    greville = std::accumulate(block.degrees.begin(), block.degrees.end(), greville + block.degrees.size());
  m_greville.reserve(greville);
  m_plans.reserve(layout.blocks.size());
  for (const internal::Block& block : layout.blocks) {
    const std::size_t m = block.functions.size(), axes = block.axes.size();
    Plan plan{over_first, m_greville.size(), block.size(), 0, m_layer_scales.size()};
    for (std::size_t j = 0; j < axes; ++j) {
      if (block.lengths[j] >= internal::least_row) {
        plan.row = block.lengths[j];
        plan.slow_axes = j;
      }
      for (int k = 0; k <= block.degrees[j]; ++k)
        m_greville.push_back(block.degrees[j] == 0 ? 0 : static_cast<double>(k) / block.degrees[j] - 0.5);
      m_layer_scales.push_back((block.degrees[j] + 1.0) / static_cast<double>(block.points));
      layers = (std::max)(layers, m * (block.degrees[j] + 1));
    }
    choose_passes(block, plan);
    m_plans.push_back(plan);
    over_first += inner_size(block);
    work = (std::max)({work, plan.row, 2 * inner_size(block)});
    members = (std::max)(members, m);
    slopes = (std::max)(slopes, m * axes);
  }
  internal::allocate_parts<double>(m_storage,
                                   {{&m_block_lower, layout.errors},
                                    {&m_block_upper, layout.errors},
                                    {&m_hull, 2 * functions},
                                    {&m_affine, entries + 2 * functions},
                                    {&m_derivatives, 2 * entries},
                                    {&m_least_over_first, over_first},
                                    {&m_most_over_first, over_first},
                                    {&m_work, work},
                                    {&m_base, members},
                                    {&m_block_slopes, slopes},
                                    {&m_layer_lower, layers},
                                    {&m_layer_upper, layers},
                                    {&m_block_rest_lower, members},
                                    {&m_block_rest_upper, members},
                                    {&m_line_slopes, layout.errors},
                                    {&m_line_rest_lower, layout.errors},
                                    {&m_line_rest_upper, layout.errors}});
  m_hull_lower = m_hull.first(functions);
  m_hull_upper = m_hull.last(functions);
  m_slopes = m_affine.first(entries);
  m_rest_lower = m_affine.subspan(entries, functions);
  m_rest_upper = m_affine.last(functions);
  m_derivative_lower = m_derivatives.first(entries);
  m_derivative_upper = m_derivatives.last(entries);
  m_index.resize(layout.dimension);
  if (!layout.blocks.empty() &&
      std::all_of(layout.blocks.begin(), layout.blocks.end(),
                  [&](const internal::Block& block) { return is_line(block) && block.functions.size() == functions; }))
    m_bound_sum_of_lines = functions == internal::pack_size ? &Node_view::bound_sum_of_lines<internal::pack_size>
                                                            : &Node_view::bound_sum_of_lines<0>;
}

inline void Node_view::choose_passes(const internal::Block& block, Plan& plan)
{
  internal::run_with_constant<6>(block.functions.size(), [&](auto members) {
    plan.bound = is_line(block) ? &Node_view::bound_line<members> : &Node_view::bound_block<members>;
    plan.enclose = is_line(block) ? &Node_view::enclose_line : &Node_view::enclose_block<members>;
    plan.bound_differences =
        is_line(block) ? &Node_view::bound_differences_of_line : &Node_view::bound_differences<members>;
  });
  if (block.functions.size() > 1 && block.size() <= most_coefficients_of_small)
    internal::run_with_constant<most_axes_of_small>(block.axes.size(), [&](auto axes) {
      if constexpr (axes > 1)
        internal::run_with_constant<4>(
            block.degrees.back(), [&](auto degree) { plan.enclose = &Node_view::enclose_small_block<axes, degree>; });
    });
}

inline void Node_view::bound_blocks()
{
  m_has_bounds = true;
  if (m_bound_sum_of_lines != nullptr)
    return (this->*m_bound_sum_of_lines)();
  std::fill(m_hull.begin(), m_hull.end(), 0.0);
  for (std::size_t b = 0; b < m_plans.size(); ++b) {
    const internal::Block& block = m_layout->blocks[b];
    (this->*m_plans[b].bound)(block, m_plans[b]);
    for (std::size_t m = 0, functions = block.functions.size(); m < functions; ++m) {
      m_hull_lower[block.functions[m]] += m_block_lower[block.first_error + m];
      m_hull_upper[block.functions[m]] += m_block_upper[block.first_error + m];
    }
  }
}

// Bounds over the first axis are kept: they serve the layers along all others.
template <int members>
void Node_view::bound_block(const internal::Block& block, const Plan& plan)
{
  const std::size_t functions = functions_of<members>(block), inner = inner_size(block);
  const double* data = m_coefficients + block.offset;
  double *least = m_least_over_first.data() + plan.over_first, *most = m_most_over_first.data() + plan.over_first;
  double *lower = m_block_lower.data() + block.first_error, *upper = m_block_upper.data() + block.first_error;
  internal::bound_over_axis(data, block.size() / inner, inner, least, most);
  internal::bound_row<members>(functions, inner, least, most, lower, upper);
  const double* errors = m_errors + block.first_error;
  for (std::size_t m = 0; m < functions; ++m) {
    const double error = errors[m] + internal::analysis_error * (std::max)(std::abs(lower[m]), std::abs(upper[m]));
    lower[m] -= error;
    upper[m] += error;
  }
}

inline void Node_view::enclose_blocks()
{
  compute_bounds();
  m_has_affine = true;
  const auto sums = m_bound_sum_of_lines != nullptr ? m_slopes : m_affine;   // of lines, the rest is there
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t b = 0; b < m_plans.size(); ++b)
    (this->*m_plans[b].enclose)(m_layout->blocks[b], m_plans[b]);
}

// Adds what is known of a block to the functions.
inline void Node_view::add_enclosure(const internal::Block& block)
{
  const std::size_t functions = block.functions.size(), axes = block.axes.size();
  for (std::size_t m = 0; m < functions; ++m) {
    const std::size_t f = block.functions[m], entry = block.first_error + m;
    double total = (std::max)(std::abs(m_block_lower[entry]), std::abs(m_block_upper[entry]));
    for (std::size_t j = 0; j < axes; ++j) {
      const double slope = m_block_slopes[j * functions + m];
      total += std::abs(slope);
      m_slopes[f * m_layout->dimension + block.axes[j]] += slope;
    }
    const double error = m_errors[entry] + internal::analysis_error * total;
    m_rest_lower[f] += m_block_rest_lower[m] - error;
    m_rest_upper[f] += m_block_rest_upper[m] + error;
  }
}

// The same as enclose_block() where few coefficients make tables and long rows not worth while.
template <int axes, int last_degree>
void Node_view::enclose_small_block(const internal::Block& block, const Plan& plan)
{
  const std::size_t functions = block.functions.size();
  const internal::Tensor_shape shape{block.degrees.data(), block.lengths.data()};
  const double *greville = m_greville.data() + plan.greville, *scales = m_layer_scales.data() + plan.layer_scales,
               *last_abscissas = greville;
  for (int j = 0; j < axes - 1; ++j)
    last_abscissas += block.degrees[j] + 1;
  internal::for_each_place(functions, [&](auto type, std::size_t m) {
    using Number = decltype(type);
    const double* data = m_coefficients + block.offset + m;
    Number slopes[axes], least(HUGE_VAL), most(-HUGE_VAL);
    internal::sum_slopes<axes>(shape, data, scales, slopes);
    const internal::Last_axis<last_degree, Number> last(slopes[axes - 1], last_abscissas, block.degrees.back(),
                                                        functions);
    internal::bound_rest<axes>(shape, data, greville, slopes, last, Number(0), least, most);
    internal::unroll<axes>([&](auto j) { internal::store(m_block_slopes.data() + j * functions + m, slopes[j]); });
    internal::store(m_block_rest_lower.data() + m, least);
    internal::store(m_block_rest_upper.data() + m, most);
  });
  add_enclosure(block);
}

// The slope along an axis is the mean of the last layer minus the mean of the first; what the linear function leaves of
// the control net (its value at the Greville abscissae k/d subtracted) bounds the rest. The faster axes' part of it is
// tabulated, the slower ones contribute a number per row.
template <int members>
void Node_view::enclose_block(const internal::Block& block, const Plan& plan)
{
  compute_slopes<members>(block);
  const std::size_t functions = functions_of<members>(block);
  const double *data = m_coefficients + block.offset, *line = m_work.data();
  tabulate<members>(block, plan, m_work.data());
  std::fill_n(m_index.begin(), plan.slow_axes, 0);
  const auto base = [&](std::size_t row) {
    for (std::size_t j = plan.slow_axes; row > 0 && j-- > 0;) {   // odometer over the slower axes
      if (++m_index[j] <= block.degrees[j])
        break;
      m_index[j] = 0;
    }
    const double* greville = m_greville.data() + plan.greville;
    std::fill_n(m_base.begin(), functions, 0.0);
    for (std::size_t j = 0; j < plan.slow_axes; ++j) {
      for (std::size_t m = 0; m < functions; ++m)
        m_base[m] += m_block_slopes[j * functions + m] * greville[m_index[j]];
      greville += block.degrees[j] + 1;
    }
    return static_cast<const double*>(m_base.data());
  };
  const auto rest = [&](auto type, std::size_t begin, std::size_t i) -> decltype(type) {
    return internal::load(type, data + begin + i) - internal::load(type, line + i);
  };
  internal::bound_ranges<members>(functions, {block.size() / plan.row, plan.row, plan.row}, rest, rest,
                                  m_block_rest_lower.data(), m_block_rest_upper.data(), base);
  add_enclosure(block);
}

// Sums over the slowest axis are taken once and serve all faster ones.
template <int members>
void Node_view::compute_slopes(const internal::Block& block)
{
  const std::size_t functions = functions_of<members>(block), axes = block.axes.size();
  const double* data = m_coefficients + block.offset;
  double points = 1;   // summed into each entry of `data`
  for (std::size_t j = 0; j < axes; ++j) {
    const std::size_t inner = block.lengths[j + 1];
    const double* last = data + inner * block.degrees[j];
    double* slope = m_block_slopes.data() + j * functions;
    internal::sum_range<members>(
        functions, inner,
        [&](auto type, std::size_t i) -> decltype(type) {
          return internal::load(type, last + i) - internal::load(type, data + i);
        },
        slope);
    const double scale = static_cast<double>(functions) / (points * static_cast<double>(inner));
    for (std::size_t m = 0; m < functions; ++m)
      slope[m] *= scale;
    if (j + 1 < axes) {
      internal::sum_over_axis(data, static_cast<std::size_t>(block.degrees[j]) + 1, inner, m_work.data());
      data = m_work.data();
      points *= block.degrees[j] + 1;
    }
  }
}

// The linear function on the faster axes.
template <int members>
void Node_view::tabulate(const internal::Block& block, const Plan& plan, double* line)
{
  const std::size_t functions = functions_of<members>(block);
  const double* greville = m_greville.data() + plan.greville;
  for (std::size_t j = 0; j < block.axes.size(); ++j)
    greville += block.degrees[j] + 1;
  std::fill_n(line, functions, 0.0);
  for (std::size_t j = block.axes.size(); j-- > plan.slow_axes;) {
    greville -= block.degrees[j] + 1;
    const double* slope = m_block_slopes.data() + j * functions;
    for (int k = block.degrees[j]; k >= 0; --k)
      internal::add_repeated<members>(functions, block.lengths[j + 1], line, slope, greville[k],
                                      line + k * block.lengths[j + 1]);
  }
}

inline void Node_view::bound_derivatives()
{
  compute_bounds();
  m_has_derivatives = true;
  std::fill(m_derivatives.begin(), m_derivatives.end(), 0.0);
  for (std::size_t b = 0; b < m_plans.size(); ++b) {
    const internal::Block& block = m_layout->blocks[b];
    for (std::size_t j = 0, axes = block.axes.size(); j < axes; ++j)
      if (block.degrees[j] > 0)
        (this->*m_plans[b].bound_differences)(block, j);
  }
}

template <int members>
void Node_view::bound_differences(const internal::Block& block, std::size_t axis)
{
  const std::size_t functions = functions_of<members>(block), inner = block.lengths[axis + 1],
                    line = block.lengths[axis];
  const double* data = m_coefficients + block.offset;
  const auto difference = [&](auto type, std::size_t begin, std::size_t i) -> decltype(type) {
    return internal::load(type, data + begin + inner + i) - internal::load(type, data + begin + i);
  };
  internal::bound_ranges<members>(functions, {block.size() / line, line, line - inner}, difference, difference,
                                  m_block_rest_lower.data(), m_block_rest_upper.data());
  add_derivatives(block, axis);
}

// Adds the bounds of the differences along an axis to the derivatives of the functions.
inline void Node_view::add_derivatives(const internal::Block& block, std::size_t axis)
{
  for (std::size_t m = 0, functions = block.functions.size(); m < functions; ++m) {
    const std::size_t entry = static_cast<std::size_t>(block.functions[m]) * m_layout->dimension + block.axes[axis],
                      e = block.first_error + m;
    const double size = (std::max)(std::abs(m_block_lower[e]), std::abs(m_block_upper[e])),
                 error = 2 * m_errors[e] + internal::analysis_error * size;
    m_derivative_lower[entry] += block.degrees[axis] * (m_block_rest_lower[m] - error);
    m_derivative_upper[entry] += block.degrees[axis] * (m_block_rest_upper[m] + error);
  }
}

// Bounds over the slower axes are taken once and serve all faster ones.
template <class Visitor>
void Node_view::visit_layers(const internal::Block& block, const Visitor& visit)
{
  compute_bounds();
  const std::size_t functions = block.functions.size(), axes = block.axes.size();
  const double *lower = m_coefficients + block.offset, *upper = lower;
  for (std::size_t j = 0; j < axes; ++j) {
    const std::size_t inner = block.lengths[j + 1], count = static_cast<std::size_t>(block.degrees[j]) + 1;
    if (inner == functions)
      visit(j, lower, upper);
    else {
      internal::run_with_constant<6>(functions, [&](auto members) {
        for (std::size_t k = 0; k < count; ++k)
          internal::bound_row<members>(functions, inner, lower + k * inner, upper + k * inner,
                                       m_layer_lower.data() + k * functions, m_layer_upper.data() + k * functions);
      });
      visit(j, static_cast<const double*>(m_layer_lower.data()), static_cast<const double*>(m_layer_upper.data()));
    }
    if (j + 1 == axes)
      break;
    if (j == 0) {
      const std::size_t place = m_plans[static_cast<std::size_t>(&block - m_layout->blocks.data())].over_first;
      lower = m_least_over_first.data() + place;
      upper = m_most_over_first.data() + place;
    } else {
      double *least = m_work.data(), *most = least + inner_size(block);
      internal::bound_over_axis(lower, upper, count, inner, least, most);
      lower = least;
      upper = most;
    }
  }
}

} // namespace Spline_constraints
} // namespace CGAL

#include <CGAL/Spline_constraints_d/solver/internal/node/Node_view_impl.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
