// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_ARRAYS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_ARRAYS_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/allocate_parts.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/analysis_error.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The coefficients of a node, what is known of them, and where the passes over its blocks keep their numbers.

A pass bounds the part of the functions that one block holds and adds it to what is known of the functions; Node_view
says which pass is due. All arrays lie in one piece of memory, allocated once for all nodes of a system.
*/
struct Node_arrays
{
  const System_layout* layout;
  const double* coefficients = nullptr;
  const double* errors = nullptr;

  // What is known of a block before its coefficients are, and the passes over them, chosen for its numbers of functions
  // and axes.
  struct Plan
  {
    std::size_t over_first;       // of the bounds over its first axis
    std::size_t greville;         // of the first axis: k/d - 1/2, axis after axis
    std::size_t row, slow_axes;   // the linear part is tabulated on a row, over the axes from slow_axes on
    std::size_t layer_scales;     // of the first axis: one over the number of control points in a layer
    void (*bound)(Node_arrays&, const Block&, const Plan&) = nullptr;
    void (*enclose)(Node_arrays&, const Block&, const Plan&) = nullptr;
    void (*bound_differences)(Node_arrays&, const Block&, std::size_t axis) = nullptr;
  };
  std::vector<Plan> plans;
  void (*bound_sum)(Node_arrays&) = nullptr;             // where all blocks are lines that hold all functions
  std::vector<double> greville, layer_scales, storage;   // all of the following lies in one piece

  std::span<double> block_lower, block_upper;             // per block and function
  std::span<double> hull, affine, derivatives;            // sums over the blocks, whose parts are
  std::span<double> hull_lower, hull_upper;               // per function
  std::span<double> slopes, rest_lower, rest_upper;       // affine enclosure
  std::span<double> derivative_lower, derivative_upper;   // functions x unknowns
  std::span<double> least_over_first, most_over_first;    // of each block, over its first axis
  std::span<double> work, base, block_slopes, layer_lower, layer_upper, block_rest_lower, block_rest_upper;
  // of blocks with one axis or none, per block and function
  std::span<double> line_slopes, line_rest_lower, line_rest_upper;
  std::vector<int> index;

  explicit Node_arrays(const System_layout& layout);
  Node_arrays(const Node_arrays&) = delete;
  Node_arrays& operator=(const Node_arrays&) = delete;

  // Adds the affine enclosure of a block to that of the functions.
  void add_enclosure(const Block& block);
  // Adds the bounds of the differences along an axis of a block to the derivatives of the functions.
  void add_derivatives(const Block& block, std::size_t axis);

private:
  // The plan of a block without its passes; `over_first` is where its bounds over the first axis begin.
  Plan plan_of(const Block& block, std::size_t over_first);
};

// The number of functions of a block; `members` is 0 for more than it pays to tell apart.
template <int members>
std::size_t functions_of(const Block& block)
{
  return members > 0 ? static_cast<std::size_t>(members) : block.functions.size();
}

// Whether the block is on one unknown or none.
inline bool is_line(const Block& block) { return block.axes.size() <= 1; }

// How many numbers vary faster than the first axis.
inline std::size_t inner_size(const Block& block)
{
  return block.axes.empty() ? block.functions.size() : block.lengths[1];
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Node_arrays::Node_arrays(const System_layout& system_layout) : layout(&system_layout)
{
  const std::size_t functions = layout->functions, entries = functions * layout->dimension;
  std::size_t size_over_first = 0, work_size = 1, members = 1, slope_count = 1, layer_size = 1, abscissas = 0;
  for (const Block& block : layout->blocks)
    abscissas = std::accumulate(block.degrees.begin(), block.degrees.end(), abscissas + block.degrees.size());
  greville.reserve(abscissas);
  plans.reserve(layout->blocks.size());
  for (const Block& block : layout->blocks) {
    plans.push_back(plan_of(block, size_over_first));
    const std::size_t m = block.functions.size();
    for (int degree : block.degrees)
      layer_size = (std::max)(layer_size, m * (degree + 1));
    size_over_first += inner_size(block);
    work_size = (std::max)({work_size, plans.back().row, 2 * inner_size(block)});
    members = (std::max)(members, m);
    slope_count = (std::max)(slope_count, m * block.axes.size());
  }
  allocate_parts<double>(storage,
                         {{&block_lower, layout->errors},
                          {&block_upper, layout->errors},
                          {&hull, 2 * functions},
                          {&affine, entries + 2 * functions},
                          {&derivatives, 2 * entries},
                          {&least_over_first, size_over_first},
                          {&most_over_first, size_over_first},
                          {&work, work_size},
                          {&base, members},
                          {&block_slopes, slope_count},
                          {&layer_lower, layer_size},
                          {&layer_upper, layer_size},
                          {&block_rest_lower, members},
                          {&block_rest_upper, members},
                          {&line_slopes, layout->errors},
                          {&line_rest_lower, layout->errors},
                          {&line_rest_upper, layout->errors}});
  hull_lower = hull.first(functions);
  hull_upper = hull.last(functions);
  slopes = affine.first(entries);
  rest_lower = affine.subspan(entries, functions);
  rest_upper = affine.last(functions);
  derivative_lower = derivatives.first(entries);
  derivative_upper = derivatives.last(entries);
  index.resize(layout->dimension);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Node_arrays::Plan Node_arrays::plan_of(const Block& block, std::size_t over_first)
{
  Plan plan{over_first, greville.size(), block.size(), 0, layer_scales.size()};
  for (std::size_t j = 0; j < block.axes.size(); ++j) {
    if (block.lengths[j] >= least_row) {
      plan.row = block.lengths[j];
      plan.slow_axes = j;
    }
    for (int k = 0; k <= block.degrees[j]; ++k)
      greville.push_back(block.degrees[j] == 0 ? 0 : static_cast<double>(k) / block.degrees[j] - 0.5);
    layer_scales.push_back((block.degrees[j] + 1.0) / static_cast<double>(block.points));
  }
  return plan;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_arrays::add_enclosure(const Block& block)
{
  const std::size_t functions = block.functions.size(), axes = block.axes.size();
  for (std::size_t m = 0; m < functions; ++m) {
    const std::size_t f = block.functions[m], entry = block.first_error + m;
    double total = (std::max)(std::abs(block_lower[entry]), std::abs(block_upper[entry]));
    for (std::size_t j = 0; j < axes; ++j) {
      const double slope = block_slopes[j * functions + m];
      total += std::abs(slope);
      slopes[f * layout->dimension + block.axes[j]] += slope;
    }
    const double error = errors[entry] + analysis_error * total;
    rest_lower[f] += block_rest_lower[m] - error;
    rest_upper[f] += block_rest_upper[m] + error;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Node_arrays::add_derivatives(const Block& block, std::size_t axis)
{
  for (std::size_t m = 0, functions = block.functions.size(); m < functions; ++m) {
    const std::size_t entry = static_cast<std::size_t>(block.functions[m]) * layout->dimension + block.axes[axis],
                      e = block.first_error + m;
    const double size = (std::max)(std::abs(block_lower[e]), std::abs(block_upper[e])),
                 error = 2 * errors[e] + analysis_error * size;
    derivative_lower[entry] += block.degrees[axis] * (block_rest_lower[m] - error);
    derivative_upper[entry] += block.degrees[axis] * (block_rest_upper[m] + error);
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_ARRAYS_H
