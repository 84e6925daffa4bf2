// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_VIEW_IMPL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_VIEW_IMPL_H

#include <CGAL/Spline_constraints_d/solver/Node_view.h>

#include <boost/config.hpp>

#include <cstddef>

// The passes of Node_view over blocks on one unknown or none.

namespace CGAL {
namespace Spline_constraints {

// Along a line, what the affine enclosure needs comes with the bounds. Those of a function of the block, or of two
// neighbouring ones.
template <class Number>
BOOST_FORCEINLINE internal::Line_bounds<Number> Node_view::bound_line_at(const internal::Block& block, const Plan& plan,
                                                                         std::size_t m, std::size_t functions)
{
  const std::size_t entry = block.first_error + m;
  internal::Line_bounds<Number> line(m_coefficients + block.offset + m, block.points, functions,
                                     m_greville.data() + plan.greville);
  line.widen(internal::load(Number(), m_errors + entry), internal::analysis_error);
  internal::store(m_block_lower.data() + entry, line.least);
  internal::store(m_block_upper.data() + entry, line.most);
  internal::store(m_line_slopes.data() + entry, line.slope);
  return line;
}

template <int members>
void Node_view::bound_line(const internal::Block& block, const Plan& plan)
{
  const std::size_t functions = functions_of<members>(block);
  internal::for_each_place(functions, [&](auto type, std::size_t m) {
    const auto line = bound_line_at<decltype(type)>(block, plan, m, functions);
    internal::store(m_line_rest_lower.data() + block.first_error + m, line.rest_least);
    internal::store(m_line_rest_upper.data() + block.first_error + m, line.rest_most);
  });
}

// As for planar curves: the sums over the blocks stay in registers.
template <int members>
void Node_view::bound_sum_of_lines()
{
  const std::size_t functions = functions_of<members>(m_layout->blocks[0]), blocks = m_plans.size();
  internal::for_each_place(functions, [&](auto type, std::size_t m) {
    using Number = decltype(type);
    Number lower(0), upper(0), rest_lower(0), rest_upper(0);
    for (std::size_t b = 0; b < blocks; ++b) {
      const auto line = bound_line_at<Number>(m_layout->blocks[b], m_plans[b], m, functions);
      lower = lower + line.least;
      upper = upper + line.most;
      rest_lower = rest_lower + line.rest_least;
      rest_upper = rest_upper + line.rest_most;
    }
    internal::store(m_hull_lower.data() + m, lower);
    internal::store(m_hull_upper.data() + m, upper);
    internal::store(m_rest_lower.data() + m, rest_lower);
    internal::store(m_rest_upper.data() + m, rest_upper);
  });
}

inline void Node_view::enclose_line(const internal::Block& block, const Plan&)
{
  const std::size_t functions = block.functions.size();
  if (!block.axes.empty())
    for (std::size_t m = 0; m < functions; ++m)
      m_slopes[block.functions[m] * m_layout->dimension + block.axes[0]] += m_line_slopes[block.first_error + m];
  if (m_bound_sum_of_lines == nullptr)   // else the sums are there
    for (std::size_t m = 0; m < functions; ++m) {
      m_rest_lower[block.functions[m]] += m_line_rest_lower[block.first_error + m];
      m_rest_upper[block.functions[m]] += m_line_rest_upper[block.first_error + m];
    }
}

inline void Node_view::bound_differences_of_line(const internal::Block& block, std::size_t axis)
{
  const std::size_t functions = block.functions.size();
  internal::for_each_place(functions, [&](auto type, std::size_t m) {
    const auto [least, most] =
        internal::bound_differences<decltype(type)>(m_coefficients + block.offset + m, block.points, functions);
    internal::store(m_block_rest_lower.data() + m, least);
    internal::store(m_block_rest_upper.data() + m, most);
  });
  add_derivatives(block, axis);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_NODE_VIEW_IMPL_H
