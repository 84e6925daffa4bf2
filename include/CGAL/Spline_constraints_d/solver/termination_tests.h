// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TERMINATION_TESTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TERMINATION_TESTS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/matrix_inverse.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Fills `bounds` with an \f$n \times n\f$ bound (row-major) on \f$|I - C\,J|\f$ over all Jacobians \f$J\f$ that the
derivative bounds of the node allow, in the node's local coordinates, and returns the largest row sum; infinite when
there is no approximate inverse \f$C\f$. Below one, \f$s \mapsto s - C f(s)\f$ is a contraction of the node: it holds at
most one solution, and \f$C\f$ is regular. Costs a pass over the coefficients per unknown, then \f$O(n^3)\f$.
*/
double contraction_bound(Node_view& node, const Linear_enclosure& linear, std::vector<double>& bounds);

/*!
\ingroup PkgSplineConstraintsDSolver

The graph-box test with isolated solutions: \f$\|I - C\,J\|_\infty < 1\f$ on the box.

\cgalModels{TerminationTest}
*/
class Graph_box_test
{
  std::vector<double> m_bounds;

public:
  //! `true` only when the node holds at most one solution.
  bool has_at_most_one_solution(Node_view& node, const Linear_enclosure& linear)
  {
    return contraction_bound(node, linear, m_bounds) < 1;
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver

The normal-cone test of Elber and Kim (\cgalCite{ek-gcs-01}, Theorem 1), decided by the dual hyperplanes of Hanniel and
Elber.

Each equality gets a cone \f$(v_i, \alpha_i)\f$ around all its gradients: \f$v_i\f$ is the mean direction of the
gradient's control vectors, \f$\alpha_i\f$ the largest angle to one of them (for a sum of terms: the ball around the sum
of the means that the deviations of the terms add up to). The tangent cones meet in the origin alone when all vertices
of the parallelepiped \f$|\langle x, v_i\rangle| \le \sin\alpha_i\f$ lie inside the unit ball. Proves uniqueness only,
and is weaker than the graph box from four unknowns on. \f$2^{n-1}\f$ vertices up to `n = 12`, a norm bound beyond.

\cgalModels{TerminationTest}
*/
class Normal_cone_test
{
  std::vector<double> m_axes, m_sines, m_inverse, m_point, m_sum, m_work;

public:
  //! `true` only when the node holds at most one solution.
  bool has_at_most_one_solution(Node_view& node, const Linear_enclosure&);

private:
  bool bound_normals(Node_view& node, int function);
  bool bound_by_control_vectors(Node_view& node, const internal::Block& block, std::size_t member, double* axis,
                                double& sine);
  bool bound_by_ball(Node_view& node, int function, double* axis, double& sine);
  template <class Visitor>
  void visit_control_vectors(const Node_view& node, const internal::Block& block, std::size_t member,
                             const Visitor& visit);
  bool tangent_cones_meet_in_origin(int n);
};

// Calls visit(g) with every control vector g of the gradient on the block's own basis: along an axis of degree d, the
// derivative raised to degree d again has the coefficients k (b_k - b_{k-1}) + (d - k)(b_{k+1} - b_k).
template <class Visitor>
void Normal_cone_test::visit_control_vectors(const Node_view& node, const internal::Block& block, std::size_t member,
                                             const Visitor& visit)
{
  const std::size_t members = block.functions.size(), axes = block.axes.size();
  const double* data = node.coefficients() + block.offset + member;
  m_work.assign(axes, 0);
  for (std::size_t p = 0; p < block.points; ++p) {
    for (std::size_t j = 0; j < axes; ++j) {
      const internal::Axis_view view = block.view(j);
      const std::size_t stride = view.inner / members;
      const int d = view.degree, k = static_cast<int>(p / stride % (d + 1));
      const double here = data[p * members];
      const double before = k > 0 ? here - data[(p - stride) * members] : 0;
      const double after = k < d ? data[(p + stride) * members] - here : 0;
      m_work[j] = k * before + (d - k) * after;
    }
    visit(m_work);
  }
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE double contraction_bound(Node_view& node, const Linear_enclosure& linear,
                                                        std::vector<double>& bounds)
{
  if (!linear.has_inverse())
    return HUGE_VAL;
  bounds.resize(static_cast<std::size_t>(node.dimension()) * node.dimension());
  const double *lower = node.derivative_lower(0), *upper = node.derivative_upper(0);
  double largest = 0;
  internal::run_with_constant<4>(node.equalities() == node.dimension() ? node.dimension() : 0, [&](auto size) {
    const int n = size > 0 ? size : node.dimension(), m = size > 0 ? size : node.equalities();
    const auto bound_rows = [&](const auto& range) {
      for (int j = 0; j < n && largest < HUGE_VAL; ++j) {
        const double sum = internal::contraction_row(n, m, j, linear.inverse_row(j), range, bounds.data() + j * n);
        largest = sum <= largest ? largest : sum < HUGE_VAL ? sum : HUGE_VAL;
      }
    };
    if constexpr (size > 0) { // once for all rows
      std::array<internal::Derivative_range, size * size> ranges;
      internal::unroll<size * size>([&](auto entry) { ranges[entry] = {lower[entry], upper[entry]}; });
      bound_rows([&](int i, int k) -> const internal::Derivative_range& { return ranges[i * n + k]; });
    } else
      bound_rows([&](int i, int k) { return internal::Derivative_range(lower[i * n + k], upper[i * n + k]); });
  });
  return largest;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Normal_cone_test::has_at_most_one_solution(Node_view& node, const Linear_enclosure&)
{
  const int n = node.dimension();
  if (node.equalities() != n)
    return false;
  m_axes.assign(n * n, 0);
  m_sines.assign(n, 0);
  for (int i = 0; i < n; ++i)
    if (!bound_normals(node, i))
      return false;
  return tangent_cones_meet_in_origin(n);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Normal_cone_test::bound_normals(Node_view& node, int function)
{
  const internal::Block* only = nullptr;
  std::size_t member = 0, blocks = 0;
  for (const internal::Block& block : node.layout().blocks)
    for (std::size_t m = 0; m < block.functions.size(); ++m)
      if (block.functions[m] == function && !block.axes.empty()) {
        only = &block;
        member = m;
        ++blocks;
      }
  double* axis = m_axes.data() + function * node.dimension();
  return blocks == 1 ? bound_by_control_vectors(node, *only, member, axis, m_sines[function])
                     : bound_by_ball(node, function, axis, m_sines[function]);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Normal_cone_test::bound_by_control_vectors(Node_view& node,
                                                                               const internal::Block& block,
                                                                               std::size_t member, double* axis,
                                                                               double& sine)
{
  const std::size_t axes = block.axes.size(), entry = block.first_error + member;
  const double size = (std::max)(std::abs(node.block_lower(entry)), std::abs(node.block_upper(entry)));
  double error = 0; // of the length of a control vector
  for (int d : block.degrees)
    error += 2 * d * (node.errors()[entry] + internal::analysis_error * size);
  m_sum.assign(axes, 0);
  bool is_good = true;
  visit_control_vectors(node, block, member, [&](const std::vector<double>& g) {
    double length = 0;
    for (double x : g)
      length += x * x;
    length = std::sqrt(length);
    is_good = is_good && length > 4 * error;
    for (std::size_t j = 0; j < axes; ++j)
      m_sum[j] += is_good ? g[j] / length : 0;
  });
  double length = 0;
  for (double x : m_sum)
    length += x * x;
  length = std::sqrt(length);
  if (!is_good || !(length > 0))
    return false;
  for (double& x : m_sum)
    x /= length;
  double cosine = 1;
  visit_control_vectors(node, block, member, [&](const std::vector<double>& g) {
    double product = 0, size_of_g = 0;
    for (std::size_t j = 0; j < axes; ++j) {
      product += g[j] * m_sum[j];
      size_of_g += g[j] * g[j];
    }
    size_of_g = std::sqrt(size_of_g);
    const double value = (product - error) / (size_of_g + error) - internal::analysis_error;
    cosine = value < cosine ? value : cosine;
  });
  if (!(cosine > 0))
    return false;
  for (std::size_t j = 0; j < axes; ++j)
    axis[block.axes[j]] = m_sum[j];
  sine = std::sqrt((std::max)(0.0, 1 - cosine * cosine) + internal::analysis_error);
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Normal_cone_test::bound_by_ball(Node_view& node, int function, double* axis,
                                                                    double& sine)
{
  const int n = node.dimension();
  double length = 0, radius = 0;
  for (int j = 0; j < n; ++j) {
    const double lower = node.derivative_lower(function)[j], upper = node.derivative_upper(function)[j];
    axis[j] = 0.5 * (lower + upper);
    length += axis[j] * axis[j];
    radius += 0.25 * (upper - lower) * (upper - lower);
  }
  length = std::sqrt(length);
  radius = std::sqrt(radius) + internal::analysis_error * length;
  if (!(radius < length))
    return false;
  for (int j = 0; j < n; ++j)
    axis[j] /= length;
  sine = radius / length * (1 + internal::analysis_error);
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Normal_cone_test::tangent_cones_meet_in_origin(int n)
{
  m_inverse.resize(n * n);
  m_work = m_axes;
  if (!internal::invert(n, m_work, m_inverse))
    return false;
  double defect = 0, length_sum = 0; // Frobenius norm of I - Y V; sum of column lengths of Y times the sines
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      double entry = i == k ? 1 : 0, size = 1;
      for (int l = 0; l < n; ++l) {
        entry -= m_inverse[i * n + l] * m_axes[l * n + k];
        size += std::abs(m_inverse[i * n + l] * m_axes[l * n + k]);
      }
      defect += std::abs(entry) + internal::analysis_error * size;
    }
  for (int k = 0; k < n; ++k) {
    double length = 0;
    for (int i = 0; i < n; ++i)
      length += m_inverse[i * n + k] * m_inverse[i * n + k];
    length_sum += std::sqrt(length) * m_sines[k];
  }
  const double limit = (1 - defect) * (1 - 0x1p-30);
  if (!(defect < 0.5))
    return false;
  if (length_sum < limit)
    return true;
  if (n > 12)
    return false;
  m_point.resize(n);
  for (unsigned signs = 0; signs < (1u << (n - 1)); ++signs) {
    double length = 0;
    for (int i = 0; i < n; ++i) {
      double x = 0;
      for (int k = 0; k < n; ++k)
        x += m_inverse[i * n + k] * (signs >> k & 1 ? -m_sines[k] : m_sines[k]);
      length += x * x;
    }
    if (!(std::sqrt(length) < limit))
      return false;
  }
  return true;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TERMINATION_TESTS_H
