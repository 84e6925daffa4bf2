// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_arrays.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/analysis_error.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/line_passes.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/tensor_passes.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

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
  static constexpr int most_axes_of_small = 4;   // as measured: enclose_small_tensor() is faster up to here
  static constexpr std::size_t most_coefficients_of_small = 1000;

  internal::Node_arrays m_arrays;
  bool m_has_bounds = false, m_has_affine = false, m_has_derivatives = false;

public:
  explicit Node_view(const internal::System_layout& layout);
  //! not copied: parts of it are looked at.
  Node_view(const Node_view&) = delete;
  Node_view& operator=(const Node_view&) = delete;

  //! looks at other coefficients; nothing is computed yet.
  void reset(const double* coefficients, const double* errors);

  //! number of unknowns.
  int dimension() const { return m_arrays.layout->dimension; }
  //! number of equalities; functions with a larger index belong to inequalities.
  int equalities() const { return m_arrays.layout->equalities; }
  //! number of all functions.
  int functions() const { return m_arrays.layout->functions; }

  //! the blocks that hold the coefficients.
  const internal::System_layout& layout() const { return *m_arrays.layout; }
  //! the coefficients, laid out as `layout()` says.
  const double* coefficients() const { return m_arrays.coefficients; }
  //! the error bounds per block and function.
  const double* errors() const { return m_arrays.errors; }

  //! bounds of the function on the box.
  double lower(int f) { compute_bounds(); return m_arrays.hull_lower[f]; }
  double upper(int f) { compute_bounds(); return m_arrays.hull_upper[f]; }

  //! bounds of one block's part of a function; `entry` is `Block::first_error` + place of the function in the block.
  double block_lower(std::size_t entry) { compute_bounds(); return m_arrays.block_lower[entry]; }
  double block_upper(std::size_t entry) { compute_bounds(); return m_arrays.block_upper[entry]; }

  //! the function is `sum_j slope(f)[j] s_j` + something in `[rest_lower(f), rest_upper(f)]`.
  const double* slopes(int f);
  double rest_lower(int f) { compute_affine(); return m_arrays.rest_lower[f]; }
  double rest_upper(int f) { compute_affine(); return m_arrays.rest_upper[f]; }

  //! bounds of the partial derivatives of a function on the box, one per unknown, in local coordinates.
  const double* derivative_lower(int f);
  const double* derivative_upper(int f);

  //! calls `visit(j, lower, upper)` for every axis `j` of a block with the bounds of its layers of control points:
  //! entry `k * m + f` belongs to layer `k` of the `f`-th of the block's `m` functions. Costs about two passes over the
  //! block for all axes together.
  template <class Visitor>
  void visit_layers(const internal::Block& block, const Visitor& visit);

private:
  void compute_bounds();
  void compute_affine();
  void compute_derivatives();
  void bound_blocks();
  void enclose_blocks();
  void bound_derivatives();
  static void choose_passes(const internal::Block& block, internal::Node_arrays::Plan& plan);
};

// It instantiates all passes.
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::choose_passes(const internal::Block& block,
                                                             internal::Node_arrays::Plan& plan)
{
  internal::run_with_constant<6>(block.functions.size(), [&](auto members) {
    plan.bound = internal::is_line(block) ? &internal::bound_line<members> : &internal::bound_tensor<members>;
    plan.enclose = internal::is_line(block) ? &internal::enclose_line : &internal::enclose_tensor<members>;
    plan.bound_differences = internal::is_line(block) ? &internal::bound_differences_of_line
                                                      : &internal::bound_differences_of_tensor<members>;
  });
  if (block.functions.size() > 1 && block.size() <= most_coefficients_of_small)
    internal::run_with_constant<most_axes_of_small>(block.axes.size(), [&](auto axes) {
      if constexpr (axes > 1)
        internal::run_with_constant<4>(
            block.degrees.back(), [&](auto degree) { plan.enclose = &internal::enclose_small_tensor<axes, degree>; });
    });
}
#endif

// Bounds over the slower axes are taken once and serve all faster ones.
template <class Visitor>
void Node_view::visit_layers(const internal::Block& block, const Visitor& visit)
{
  compute_bounds();
  const std::size_t functions = block.functions.size(), axes = block.axes.size();
  const double *lower = m_arrays.coefficients + block.offset, *upper = lower;
  for (std::size_t j = 0; j < axes; ++j) {
    const std::size_t inner = block.lengths[j + 1], count = static_cast<std::size_t>(block.degrees[j]) + 1;
    if (inner == functions)
      visit(j, lower, upper);
    else {
      internal::run_with_constant<6>(functions, [&](auto members) {
        for (std::size_t k = 0; k < count; ++k)
          internal::bound_row<members>(functions, inner, lower + k * inner, upper + k * inner,
                                       m_arrays.layer_lower.data() + k * functions,
                                       m_arrays.layer_upper.data() + k * functions);
      });
      visit(j, static_cast<const double*>(m_arrays.layer_lower.data()),
            static_cast<const double*>(m_arrays.layer_upper.data()));
    }
    if (j + 1 == axes)
      break;
    if (j == 0) {
      const std::size_t place =
          m_arrays.plans[static_cast<std::size_t>(&block - m_arrays.layout->blocks.data())].over_first;
      lower = m_arrays.least_over_first.data() + place;
      upper = m_arrays.most_over_first.data() + place;
    } else {
      double *least = m_arrays.work.data(), *most = least + internal::inner_size(block);
      internal::bound_over_axis(lower, upper, count, inner, least, most);
      lower = least;
      upper = most;
    }
  }
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::reset(const double* coefficients, const double* errors)
{
  m_arrays.coefficients = coefficients;
  m_arrays.errors = errors;
  m_has_bounds = m_has_affine = m_has_derivatives = false;
}

CGAL_SPLINE_CONSTRAINTS_INLINE const double* Node_view::slopes(int f)
{
  compute_affine();
  return m_arrays.slopes.data() + static_cast<std::size_t>(f) * dimension();
}

CGAL_SPLINE_CONSTRAINTS_INLINE const double* Node_view::derivative_lower(int f)
{
  compute_derivatives();
  return m_arrays.derivative_lower.data() + static_cast<std::size_t>(f) * dimension();
}

CGAL_SPLINE_CONSTRAINTS_INLINE const double* Node_view::derivative_upper(int f)
{
  compute_derivatives();
  return m_arrays.derivative_upper.data() + static_cast<std::size_t>(f) * dimension();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::compute_bounds()
{
  if (!m_has_bounds)
    bound_blocks();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::compute_affine()
{
  if (!m_has_affine)
    enclose_blocks();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::compute_derivatives()
{
  if (!m_has_derivatives)
    bound_derivatives();
}

CGAL_SPLINE_CONSTRAINTS_INLINE Node_view::Node_view(const internal::System_layout& layout) : m_arrays(layout)
{
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
    choose_passes(layout.blocks[b], m_arrays.plans[b]);
  const auto is_line_of_all = [&](const internal::Block& block) {
    return internal::is_line(block) && block.functions.size() == static_cast<std::size_t>(layout.functions);
  };
  if (!layout.blocks.empty() && std::all_of(layout.blocks.begin(), layout.blocks.end(), is_line_of_all))
    m_arrays.bound_sum = layout.functions == internal::pack_size ? &internal::bound_sum_of_lines<internal::pack_size>
                                                                 : &internal::bound_sum_of_lines<0>;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::bound_blocks()
{
  m_has_bounds = true;
  if (m_arrays.bound_sum != nullptr)
    return m_arrays.bound_sum(m_arrays);
  std::fill(m_arrays.hull.begin(), m_arrays.hull.end(), 0.0);
  for (std::size_t b = 0; b < m_arrays.plans.size(); ++b) {
    const internal::Block& block = m_arrays.layout->blocks[b];
    m_arrays.plans[b].bound(m_arrays, block, m_arrays.plans[b]);
    for (std::size_t m = 0, functions = block.functions.size(); m < functions; ++m) {
      m_arrays.hull_lower[block.functions[m]] += m_arrays.block_lower[block.first_error + m];
      m_arrays.hull_upper[block.functions[m]] += m_arrays.block_upper[block.first_error + m];
    }
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::enclose_blocks()
{
  compute_bounds();
  m_has_affine = true;
  const auto sums = m_arrays.bound_sum != nullptr ? m_arrays.slopes : m_arrays.affine; // of lines, the rest is there
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t b = 0; b < m_arrays.plans.size(); ++b)
    m_arrays.plans[b].enclose(m_arrays, m_arrays.layout->blocks[b], m_arrays.plans[b]);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_view::bound_derivatives()
{
  compute_bounds();
  m_has_derivatives = true;
  std::fill(m_arrays.derivatives.begin(), m_arrays.derivatives.end(), 0.0);
  for (std::size_t b = 0; b < m_arrays.plans.size(); ++b) {
    const internal::Block& block = m_arrays.layout->blocks[b];
    for (std::size_t j = 0, axes = block.axes.size(); j < axes; ++j)
      if (block.degrees[j] > 0)
        m_arrays.plans[b].bound_differences(m_arrays, block, j);
  }
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NODE_VIEW_H
