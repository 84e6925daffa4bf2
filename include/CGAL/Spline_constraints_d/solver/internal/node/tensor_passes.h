// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_TENSOR_PASSES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_TENSOR_PASSES_H

#include <CGAL/Spline_constraints_d/function/affine_kernels.h>
#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_arrays.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/analysis_error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The passes of a Node_view over blocks on several unknowns.

// Bounds over the first axis are kept: they serve the layers along all others.
template <int members>
void bound_tensor(Node_arrays& node, const Block& block, const Node_arrays::Plan& plan)
{
  const std::size_t functions = functions_of<members>(block), inner = inner_size(block);
  const double* data = node.coefficients + block.offset;
  double *least = node.least_over_first.data() + plan.over_first, *most = node.most_over_first.data() + plan.over_first;
  double *lower = node.block_lower.data() + block.first_error, *upper = node.block_upper.data() + block.first_error;
  bound_over_axis(data, block.size() / inner, inner, least, most);
  bound_row<members>(functions, inner, least, most, lower, upper);
  const double* errors = node.errors + block.first_error;
  for (std::size_t m = 0; m < functions; ++m) {
    const double error = errors[m] + analysis_error * (std::max)(std::abs(lower[m]), std::abs(upper[m]));
    lower[m] -= error;
    upper[m] += error;
  }
}

// The same as enclose_tensor() where few coefficients make tables and long rows not worth while.
template <int axes, int last_degree>
void enclose_small_tensor(Node_arrays& node, const Block& block, const Node_arrays::Plan& plan)
{
  const std::size_t functions = block.functions.size();
  const Tensor_shape shape{block.degrees.data(), block.lengths.data()};
  const double *greville = node.greville.data() + plan.greville, *scales = node.layer_scales.data() + plan.layer_scales,
               *last_abscissas = greville;
  for (int j = 0; j < axes - 1; ++j)
    last_abscissas += block.degrees[j] + 1;
  const double* coefficients = node.coefficients + block.offset;
  double *block_slopes = node.block_slopes.data(), *rest_lower = node.block_rest_lower.data(),
         *rest_upper = node.block_rest_upper.data();   // not looked up in the loop, which is faster
  for_each_place(functions, [&](auto type, std::size_t m) {
    using Number = decltype(type);
    const double* data = coefficients + m;
    Number slopes[axes], least(HUGE_VAL), most(-HUGE_VAL);
    sum_slopes<axes>(shape, data, scales, slopes);
    const Last_axis<last_degree, Number> last(slopes[axes - 1], last_abscissas, block.degrees.back(), functions);
    bound_rest<axes>(shape, data, greville, slopes, last, Number(0), least, most);
    unroll<axes>([&](auto j) { store(block_slopes + j * functions + m, slopes[j]); });
    store(rest_lower + m, least);
    store(rest_upper + m, most);
  });
  node.add_enclosure(block);
}

// Sums over the slowest axis are taken once and serve all faster ones.
template <int members>
void compute_slopes_of_tensor(Node_arrays& node, const Block& block)
{
  const std::size_t functions = functions_of<members>(block), axes = block.axes.size();
  const double* data = node.coefficients + block.offset;
  double points = 1;   // summed into each entry of `data`
  for (std::size_t j = 0; j < axes; ++j) {
    const std::size_t inner = block.lengths[j + 1];
    const double* last = data + inner * block.degrees[j];
    double* slope = node.block_slopes.data() + j * functions;
    sum_range<members>(
        functions, inner,
        [&](auto type, std::size_t i) -> decltype(type) { return load(type, last + i) - load(type, data + i); }, slope);
    const double scale = static_cast<double>(functions) / (points * static_cast<double>(inner));
    for (std::size_t m = 0; m < functions; ++m)
      slope[m] *= scale;
    if (j + 1 < axes) {
      sum_over_axis(data, static_cast<std::size_t>(block.degrees[j]) + 1, inner, node.work.data());
      data = node.work.data();
      points *= block.degrees[j] + 1;
    }
  }
}

// The linear function on the faster axes, at the Greville abscissae.
template <int members>
void tabulate_linear_part(Node_arrays& node, const Block& block, const Node_arrays::Plan& plan, double* line)
{
  const std::size_t functions = functions_of<members>(block);
  const double* greville = node.greville.data() + plan.greville;
  for (std::size_t j = 0; j < block.axes.size(); ++j)
    greville += block.degrees[j] + 1;
  std::fill_n(line, functions, 0.0);
  for (std::size_t j = block.axes.size(); j-- > plan.slow_axes;) {
    greville -= block.degrees[j] + 1;
    const double* slope = node.block_slopes.data() + j * functions;
    for (int k = block.degrees[j]; k >= 0; --k)
      add_repeated<members>(functions, block.lengths[j + 1], line, slope, greville[k], line + k * block.lengths[j + 1]);
  }
}

// The slope along an axis is the mean of the last layer minus the mean of the first; what the linear function leaves of
// the control net (its value at the Greville abscissae k/d subtracted) bounds the rest. The faster axes' part of it is
// tabulate_linear_partd, the slower ones contribute a number per row.
template <int members>
void enclose_tensor(Node_arrays& node, const Block& block, const Node_arrays::Plan& plan)
{
  compute_slopes_of_tensor<members>(node, block);
  const std::size_t functions = functions_of<members>(block);
  const double *data = node.coefficients + block.offset, *line = node.work.data();
  tabulate_linear_part<members>(node, block, plan, node.work.data());
  std::fill_n(node.index.begin(), plan.slow_axes, 0);
  const auto base = [&](std::size_t row) {
    for (std::size_t j = plan.slow_axes; row > 0 && j-- > 0;) {   // odometer over the slower axes
      if (++node.index[j] <= block.degrees[j])
        break;
      node.index[j] = 0;
    }
    const double* greville = node.greville.data() + plan.greville;
    std::fill_n(node.base.begin(), functions, 0.0);
    for (std::size_t j = 0; j < plan.slow_axes; ++j) {
      for (std::size_t m = 0; m < functions; ++m)
        node.base[m] += node.block_slopes[j * functions + m] * greville[node.index[j]];
      greville += block.degrees[j] + 1;
    }
    return static_cast<const double*>(node.base.data());
  };
  const auto rest = [&](auto type, std::size_t begin, std::size_t i) -> decltype(type) {
    return load(type, data + begin + i) - load(type, line + i);
  };
  bound_ranges<members>(functions, {block.size() / plan.row, plan.row, plan.row}, rest, rest,
                        node.block_rest_lower.data(), node.block_rest_upper.data(), base);
  node.add_enclosure(block);
}

// The differences of neighbours along an axis bound the derivatives.
template <int members>
void bound_differences_of_tensor(Node_arrays& node, const Block& block, std::size_t axis)
{
  const std::size_t functions = functions_of<members>(block), inner = block.lengths[axis + 1],
                    line = block.lengths[axis];
  const double* data = node.coefficients + block.offset;
  const auto difference = [&](auto type, std::size_t begin, std::size_t i) -> decltype(type) {
    return load(type, data + begin + inner + i) - load(type, data + begin + i);
  };
  bound_ranges<members>(functions, {block.size() / line, line, line - inner}, difference, difference,
                        node.block_rest_lower.data(), node.block_rest_upper.data());
  node.add_derivatives(block, axis);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_TENSOR_PASSES_H
