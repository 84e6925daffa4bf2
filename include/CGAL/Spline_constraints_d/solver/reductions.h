// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_REDUCTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_REDUCTIONS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Dense_preconditioner.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Keeps the whole box: plain subdivision.

\cgalModels{Reduction}
*/
class No_reduction
{
public:
  //! leaves the box as it is.
  bool contract(Node_view&, Linear_enclosure&, Local_box&) { return true; }
};

/*!
\ingroup PkgSplineConstraintsDSolver

The projected polyhedron of Sherbrooke and Patrikalakis (\cgalCite{p-cgl-03}): seen along one axis, the graph of each
equality lies in the convex hull of the segments \f$(k/d, [\min, \max])\f$ of its layers of control points; where that
hull misses zero there is no solution.

About two passes over the coefficients. For a sum of terms on disjoint unknowns the hull is that of the expanded tensor.

\cgalModels{Reduction}
*/
class Projected_polyhedron_reduction
{
public:
  //! contracts the box; `false` when it proves that no solution is left.
  bool contract(Node_view& node, Linear_enclosure&, Local_box& box);

private:
  const double *m_lower = nullptr, *m_upper = nullptr;
  std::vector<std::pair<double, double>> m_others;   // per equality of a block

  // The other blocks of a function add their whole range to every layer.
  void add_other_blocks(Node_view& node, const internal::Block& block);

  bool contract_axis(const internal::Block& block, std::size_t axis, const double* lower, const double* upper,
                     Local_box& box);

  // The smallest t in [0,1] where the hull of the layers meets zero, seen from the first layer on (or from the last one
  // back);
  // 2 when it misses zero. The crossing is on an edge from a layer before the first that reaches zero to that one or a
  // later one.
  double crossing(int degree, std::size_t members, std::size_t member, double add_lower, double add_upper,
                  bool is_reversed) const;
};

/*!
\ingroup PkgSplineConstraintsDSolver

The default reduction: the equations' own affine enclosures, the projected polyhedron, and the preconditioned affine
enclosures.

The affine modes cost \f$O(n^2)\f$ per equation and no pass over the coefficients beyond the one that bounds the node,
so they come first; sparse and separable equations are never expanded. Where there is a complete inverse for as many
equalities as unknowns, the image under the Newton operator \f$s - C f(s)\f$ is all that the preconditioned rows say of
the whole node, and where that is a small part of it nothing else is asked. Where they leave no complete inverse, the
control points of \f$C f\f$ are formed if all equalities share their blocks, some of these have several axes and, by
counted operations, that costs no more than a split. A second sweep over the linear rows follows where anything was
gained, since it is cheap beside a pass.

\cgalModels{Reduction}
*/
class Preconditioned_reduction
{
  Projected_polyhedron_reduction m_projection;
  internal::Dense_preconditioner m_dense;

public:
  //! contracts the box; `false` when it proves that no solution is left.
  bool contract(Node_view& node, Linear_enclosure& linear, Local_box& box);

private:
  static bool is_whole(const Local_box& box);

  // So much is gained, half of the width being left on the mean of the axes, that passes over the coefficients are
  // better spent on what is left.
  static bool is_small_part(const Local_box& box);

  bool is_dense_form_cheap(const Node_view& node);

  bool contract_dense(Node_view& node, Linear_enclosure& linear, Local_box& box);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool Projected_polyhedron_reduction::contract(Node_view& node, Linear_enclosure&,
                                                                             Local_box& box)
{
  for (const internal::Block& block : node.layout().blocks)
    if (!block.functions.empty() && block.functions.front() < node.equalities()) {
      add_other_blocks(node, block);
      bool is_left = true;
      node.visit_layers(block, [&](std::size_t j, const double* lower, const double* upper) {
        is_left = is_left && contract_axis(block, j, lower, upper, box);
      });
      if (!is_left)
        return false;
    }
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Projected_polyhedron_reduction::add_other_blocks(Node_view& node,
                                                                                     const internal::Block& block)
{
  m_others.clear();
  for (std::size_t m = 0; m < block.functions.size() && block.functions[m] < node.equalities(); ++m) {
    const int f = block.functions[m];
    const std::size_t entry = block.first_error + m;
    const double lower = node.lower(f), upper = node.upper(f), block_lower = node.block_lower(entry),
                 block_upper = node.block_upper(entry);
    const double size = std::abs(lower) + std::abs(upper) + std::abs(block_lower) + std::abs(block_upper);
    const double slack = node.errors()[entry] + internal::analysis_error * size;
    m_others.emplace_back(lower - block_lower - slack, upper - block_upper + slack);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Projected_polyhedron_reduction::contract_axis(const internal::Block& block,
                                                                                  std::size_t axis, const double* lower,
                                                                                  const double* upper, Local_box& box)
{
  const std::size_t members = block.functions.size();
  const int degree = block.degrees[axis];
  m_lower = lower;
  m_upper = upper;
  if (degree == 0)
    return true;
  for (std::size_t m = 0; m < m_others.size(); ++m) {
    const auto [add_lower, add_upper] = m_others[m];
    const double first = crossing(degree, members, m, add_lower, add_upper, false);
    if (first > 1)
      return false;
    const double last = 1 - crossing(degree, members, m, add_lower, add_upper, true);
    if (first == 0 && last == 1)
      continue;
    const double rounding = 0x1p-40;
    if (!box.intersect(block.axes[axis], first - rounding - 0.5, last + rounding - 0.5))
      return false;
  }
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE double Projected_polyhedron_reduction::crossing(int degree, std::size_t members,
                                                                               std::size_t member, double add_lower,
                                                                               double add_upper, bool is_reversed) const
{
  const std::ptrdiff_t step =
      is_reversed ? -static_cast<std::ptrdiff_t>(members) : static_cast<std::ptrdiff_t>(members);
  const std::size_t first = member + (is_reversed ? degree * members : 0);
  const double *from_lower = m_lower + first, *from_upper = m_upper + first;
  const auto lower = [&](int k) { return from_lower[k * step] + add_lower; };
  const auto upper = [&](int k) { return from_upper[k * step] + add_upper; };
  if (lower(0) <= 0 && upper(0) >= 0)
    return 0;
  const bool is_above = lower(0) > 0;
  // from zero, positive while on the side of layer 0
  const auto distance = [&](int k) { return is_above ? lower(k) : -upper(k); };
  int reaching = 1;
  while (reaching <= degree && distance(reaching) > 0)
    ++reaching;
  if (reaching > degree)
    return 2;
  double best = degree;
  for (int i = 0; i < reaching; ++i) {
    const double a = distance(i);
    for (int k = reaching; k <= degree; ++k)
      if (const double b = distance(k); b <= 0) {
        const double drop = a - b;
        if (0x1p-900 < drop && drop < 0x1p900 && (k - i) * a >= (best - i) * drop)
          continue; // no better, up to a few roundings, as is found without a division
        best = (std::min)(best, i + (k - i) * (a / drop));
      }
  }
  return best / degree;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_reduction::contract(Node_view& node, Linear_enclosure& linear,
                                                                       Local_box& box)
{
  // all that the preconditioned rows say of the whole node
  const bool has_image = linear.has_inverse() && linear.equations() == linear.dimension();
  if (has_image && !linear.contract_by_image(box))
    return false;
  if (has_image && is_small_part(box))
    return true;
  if (!linear.contract_by_equations(node, box) || (!has_image && !linear.contract_by_preconditioned(box)))
    return false;
  if (linear.has_inverse() && is_small_part(box))
    return linear.contract_by_equations(node, box) && linear.contract_by_preconditioned(box);
  if (!m_projection.contract(node, linear, box))
    return false;
  if (!linear.has_inverse() && is_dense_form_cheap(node) && !contract_dense(node, linear, box))
    return false;
  if (is_whole(box))
    return true; // nothing gained, and nothing to gain from the same rows again
  return linear.contract_by_equations(node, box) && linear.contract_by_preconditioned(box);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_reduction::is_whole(const Local_box& box)
{
  for (int j = 0; j < box.dimension(); ++j)
    if (box.lower[j] != -0.5 || box.upper[j] != 0.5)
      return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_reduction::is_small_part(const Local_box& box)
{
  double volume = 1;
  for (int j = 0; j < box.dimension(); ++j)
    volume *= 2 * box.width(j);
  return volume < 1;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_reduction::is_dense_form_cheap(const Node_view& node)
{
  if (node.equalities() != node.dimension() || !internal::Dense_preconditioner::may_pay(node.layout()))
    return false;
  m_dense.prepare(node.layout());
  return m_dense.is_cheap();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Preconditioned_reduction::contract_dense(Node_view& node, Linear_enclosure& linear,
                                                                             Local_box& box)
{
  Node_view* preconditioned = m_dense.apply(node);
  if (preconditioned == nullptr)
    return true;
  for (int i = 0; i < preconditioned->equalities(); ++i)
    if (preconditioned->lower(i) > 0 || preconditioned->upper(i) < 0)
      return false;
  return m_projection.contract(*preconditioned, linear, box);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_REDUCTIONS_H
