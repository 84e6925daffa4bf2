// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_DENSE_PRECONDITIONER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_DENSE_PRECONDITIONER_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/matrix_inverse.h>

#include <Eigen/Core>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A square matrix of a size that is known to the compiler, two rows in one register.
*/
template <int n>
struct Columns_in_registers
{
  static constexpr int packs = n / pack_size;

  Pack pairs[n][packs + 1];   // of rows, per column; one more, since there are no arrays of none
  double last_row[n];

  Columns_in_registers() = default;

  // From an array of columns. These were written one by one just now, and are not read in pairs.
  explicit Columns_in_registers(const double* columns)
  {
    unroll<n>([&](auto i) {
      unroll<packs>(
          [&](auto r) { pairs[i][r] = Pack(columns[i * n + r * pack_size], columns[i * n + r * pack_size + 1]); });
      last_row[i] = columns[i * n + n - 1];
    });
  }

  Columns_in_registers absolute() const
  {
    Columns_in_registers result;
    unroll<n>([&](auto i) {
      unroll<packs>([&](auto r) { result.pairs[i][r] = magnitude(pairs[i][r]); });
      result.last_row[i] = magnitude(last_row[i]);
    });
    return result;
  }

  BOOST_FORCEINLINE void multiply(const double* from, double* to) const
  {
    const auto product = [&](const auto& entry) {
      auto sum = entry(std::integral_constant<int, 0>()) * from[0];
      unroll<n - 1>([&](auto i) { sum = sum + entry(std::integral_constant<int, i + 1>()) * from[i + 1]; });
      return sum;
    };
    unroll<packs>([&](auto r) { store(to + r * pack_size, product([&](auto i) { return pairs[i][r]; })); });
    if constexpr (n % pack_size != 0)
      store(to + n - 1, product([&](auto i) { return last_row[i]; }));
  }
};

/*
The control points of C f, formed block by block: at most n^2 multiplications per control point. Tighter than the affine
rows, since the cancellation between the equations happens before the bounds are taken, where they share blocks.
*/
class Dense_preconditioner
{
  const System_layout* m_source = nullptr;
  bool m_is_cheap = false;
  System_layout m_layout;   // of what is formed
  std::unique_ptr<Node_view> m_view;
  std::vector<std::size_t> m_block;          // of the source
  std::vector<double> m_coefficients, m_errors, m_source_errors;
  std::vector<double> m_work, m_matrix, m_columns;

public:
  // Has to be called first. A layout stays where it is.
  void prepare(const System_layout& source)
  {
    if (m_source != &source)
      lay_out(source);
  }

  // Every block that holds an equality holds them all, and some have several axes: along single ones, as of two curves,
  // nothing cancels that the linear rows do not see.
  static bool may_pay(const System_layout& layout)
  {
    bool has_several_axes = false;
    for (const Block& block : layout.blocks)
      if (block.holds_equalities(layout.equalities)) {
        if (members_of(block, layout.equalities) < static_cast<std::size_t>(layout.equalities))
          return false;
        has_several_axes = has_several_axes || block.axes.size() > 1;
      }
    return has_several_axes;
  }

  // By counted operations, to form C f costs no more than to split the node and look at both halves: n multiplications
  // per coefficient, beside half a degree for the split and about a dozen operations in the passes that bound
  // functions, slopes, derivatives and layers, each on two nodes.
  bool is_cheap() const { return m_is_cheap; }

  // The preconditioned equalities of a square system as a node of their own; null when the mean slopes are singular.
  Node_view* apply(Node_view& node)
  {
    const int n = m_layout.equalities;
    const double* slopes = node.slopes(0);
    for (int i = 0; i < n * n; ++i)   // no call for a few numbers
      m_work[i] = slopes[i];
    return invert(n, m_work, m_matrix) ? &formed(node) : nullptr;
  }

  // The same with a given matrix, row by row. It needs no proof: a solution of f solves C f whatever C is.
  Node_view& apply(Node_view& node, const std::vector<double>& matrix)
  {
    m_matrix = matrix;
    return formed(node);
  }

private:
  Node_view& formed(Node_view& node)
  {
    for (std::size_t b = 0; b < m_block.size(); ++b) {
      const Block &source = m_source->blocks[m_block[b]], &target = m_layout.blocks[b];
      const std::size_t members = select_columns(source);
      for (std::size_t i = 0; i < members; ++i) {
        const std::size_t entry = source.first_error + i;
        const double size = (std::max)(std::abs(node.block_lower(entry)), std::abs(node.block_upper(entry)));
        m_source_errors[i] =
            (node.errors()[entry] + analysis_error * size) * (1 + m_layout.equalities * analysis_error);
      }
      multiply(node.coefficients() + source.offset, source.functions.size(), members, target.points,
               m_coefficients.data() + target.offset, m_errors.data() + target.first_error);
    }
    m_view->reset(m_coefficients.data(), m_errors.data());
    return *m_view;
  }

  // How many equalities a block holds.
  static std::size_t members_of(const Block& block, int equalities)
  {
    return static_cast<std::size_t>(std::lower_bound(block.functions.begin(), block.functions.end(), equalities) -
                                    block.functions.begin());
  }

  // The columns of C for the equalities that a block holds; returns their number.
  std::size_t select_columns(const Block& block)
  {
    const std::size_t n = m_layout.equalities, members = members_of(block, m_layout.equalities);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < members; ++i)
        m_columns[i * n + j] = m_matrix[j * n + block.functions[i]];
    return members;
  }

  // to <- C from, control point by control point, and errors <- |C| errors of the source; sizes known to the compiler
  // where it pays.
  void multiply(const double* from, std::size_t stride, std::size_t members, std::size_t points, double* to,
                double* errors) const;

  template <int n>
  void multiply_fixed(const double* from, std::size_t stride, std::size_t points, double* to, double* errors) const
  {
    const Columns_in_registers<n> matrix(m_columns.data());
    for (std::size_t p = 0; p < points; ++p, from += stride, to += n)
      matrix.multiply(from, to);
    matrix.absolute().multiply(m_source_errors.data(), errors);
  }

  void lay_out(const System_layout& source)
  {
    m_source = &source;
    m_layout = System_layout::of_combined_equalities(source);
    m_block.clear();
    for (std::size_t b = 0; b < source.blocks.size(); ++b)
      if (source.blocks[b].holds_equalities(source.equalities))
        m_block.push_back(b);
    double products = 0, passes = 0;
    for (const Block& block : m_layout.blocks) {
      const double degrees = std::accumulate(block.degrees.begin(), block.degrees.end(), 0.0);
      const double degree = block.degrees.empty() ? 0 : degrees / static_cast<double>(block.degrees.size());
      products += static_cast<double>(block.size()) * source.equalities;
      passes += static_cast<double>(block.size()) * 2 * (0.5 * degree + 12);
    }
    m_is_cheap = products <= passes;
    m_view = std::make_unique<Node_view>(m_layout);
    m_coefficients.resize(m_layout.size);
    m_errors.resize(m_layout.errors);
    m_source_errors.resize(source.equalities);
    for (auto* matrix : {&m_work, &m_matrix, &m_columns})
      matrix->resize(source.equalities * source.equalities);
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Dense_preconditioner::multiply(const double* from, std::size_t stride,
                                                                   std::size_t members, std::size_t points, double* to,
                                                                   double* errors) const
{
  run_with_constant<6>(static_cast<int>(members) == m_layout.equalities ? members : 0, [&](auto size) {
    if constexpr (size > 0)
      multiply_fixed<size>(from, stride, points, to, errors);
    else {
      const Eigen::Index rows = m_layout.equalities, columns = static_cast<Eigen::Index>(members),
                         count = static_cast<Eigen::Index>(points);
      const Eigen::Map<const Eigen::MatrixXd> matrix(m_columns.data(), rows, columns);
      const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> source(
          from, columns, count, Eigen::OuterStride<>(static_cast<Eigen::Index>(stride)));
      Eigen::Map<Eigen::MatrixXd>(to, rows, count).noalias() = matrix.lazyProduct(source);
      Eigen::Map<Eigen::VectorXd>(errors, rows).noalias() =
          matrix.cwiseAbs().lazyProduct(Eigen::Map<const Eigen::VectorXd>(m_source_errors.data(), columns));
    }
  });
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_DENSE_PRECONDITIONER_H
