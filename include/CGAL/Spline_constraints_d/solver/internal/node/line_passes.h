// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_LINE_PASSES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_LINE_PASSES_H

#include <CGAL/Spline_constraints_d/function/affine_kernels.h>
#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Node_arrays.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/analysis_error.h>

#include <boost/config.hpp>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The passes of a Node_view over blocks on one unknown or none.

// Along a line, what the affine enclosure needs comes with the bounds. Those of a function of the block, or of two
// neighbouring ones.
template <class Number>
BOOST_FORCEINLINE Line_bounds<Number> bound_line_at(Node_arrays& node, const Block& block,
                                                    const Node_arrays::Plan& plan, std::size_t m, std::size_t functions)
{
  const std::size_t entry = block.first_error + m;
  Line_bounds<Number> line(node.coefficients + block.offset + m, block.points, functions,
                           node.greville.data() + plan.greville);
  line.widen(load(Number(), node.errors + entry), analysis_error);
  store(node.block_lower.data() + entry, line.least);
  store(node.block_upper.data() + entry, line.most);
  store(node.line_slopes.data() + entry, line.slope);
  return line;
}

template <int members>
void bound_line(Node_arrays& node, const Block& block, const Node_arrays::Plan& plan)
{
  const std::size_t functions = functions_of<members>(block);
  for_each_place(functions, [&](auto type, std::size_t m) {
    const auto line = bound_line_at<decltype(type)>(node, block, plan, m, functions);
    store(node.line_rest_lower.data() + block.first_error + m, line.rest_least);
    store(node.line_rest_upper.data() + block.first_error + m, line.rest_most);
  });
}

// As for planar curves: the sums over the blocks stay in registers.
template <int members>
void bound_sum_of_lines(Node_arrays& node)
{
  const std::size_t functions = functions_of<members>(node.layout->blocks[0]), blocks = node.plans.size();
  for_each_place(functions, [&](auto type, std::size_t m) {
    using Number = decltype(type);
    Number lower(0), upper(0), rest_lower(0), rest_upper(0);
    for (std::size_t b = 0; b < blocks; ++b) {
      const auto line = bound_line_at<Number>(node, node.layout->blocks[b], node.plans[b], m, functions);
      lower = lower + line.least;
      upper = upper + line.most;
      rest_lower = rest_lower + line.rest_least;
      rest_upper = rest_upper + line.rest_most;
    }
    store(node.hull_lower.data() + m, lower);
    store(node.hull_upper.data() + m, upper);
    store(node.rest_lower.data() + m, rest_lower);
    store(node.rest_upper.data() + m, rest_upper);
  });
}

void enclose_line(Node_arrays& node, const Block& block, const Node_arrays::Plan&);

void bound_differences_of_line(Node_arrays& node, const Block& block, std::size_t axis);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void enclose_line(Node_arrays& node, const Block& block, const Node_arrays::Plan&)
{
  const std::size_t functions = block.functions.size();
  if (!block.axes.empty())
    for (std::size_t m = 0; m < functions; ++m)
      node.slopes[block.functions[m] * node.layout->dimension + block.axes[0]] +=
          node.line_slopes[block.first_error + m];
  if (node.bound_sum == nullptr) // else the sums are there
    for (std::size_t m = 0; m < functions; ++m) {
      node.rest_lower[block.functions[m]] += node.line_rest_lower[block.first_error + m];
      node.rest_upper[block.functions[m]] += node.line_rest_upper[block.first_error + m];
    }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void bound_differences_of_line(Node_arrays& node, const Block& block, std::size_t axis)
{
  const std::size_t functions = block.functions.size();
  for_each_place(functions, [&](auto type, std::size_t m) {
    const auto [least, most] =
        bound_differences<decltype(type)>(node.coefficients + block.offset + m, block.points, functions);
    store(node.block_rest_lower.data() + m, least);
    store(node.block_rest_upper.data() + m, most);
  });
  node.add_derivatives(block, axis);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_LINE_PASSES_H
