// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_EXACT_SOURCE_IMPL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_EXACT_SOURCE_IMPL_H

// How an Exact_source is set up.
#include <CGAL/Spline_constraints_d/solver/internal/node/Exact_source.h>

#include <algorithm>
#include <iterator>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline std::vector<std::vector<Exact_rational>> Exact_source::collect_breaks(const Constraint_system_d& system,
                                                                             const System_layout& layout)
{
  std::vector<std::vector<Exact_rational>> result(layout.dimension);
  for (int f = 0; f < layout.functions; ++f)
    for (const Spline_term& term : function_of(system, f).terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j) {
        if (term.breaks[j].empty())
          continue;
        const auto& [lower, upper] = system.domain(term.variables[j]);
        std::vector<Exact_rational>& breaks = result[term.variables[j]];
        if (breaks.empty())
          breaks = {lower, upper};   // also of a domain that is one point
        std::copy_if(term.breaks[j].begin(), term.breaks[j].end(), std::back_inserter(breaks),
                     [&lower = lower, &upper = upper](const Exact_rational& b) { return lower < b && b < upper; });
      }
  for (std::vector<Exact_rational>& breaks : result)
    if (breaks.size() > 2) {
      std::sort(breaks.begin(), breaks.end());
      breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    }
  return result;
}

inline void Exact_source::add_function(const Spline_function& function, int index)
{
  Short_integer denominator(1);
  for (const Spline_term& term : function.terms())
    for (const auto& coefficients : term.pieces)
      for (const Exact_rational& coefficient : coefficients)
        extend_common_denominator(denominator, coefficient);

  for (const Spline_term& term : function.terms()) {
    Term& result = m_terms.emplace_back();
    result.function = index;
    for (result.block = 0;; ++result.block) {
      const Block& block = m_layout.blocks[result.block];
      const auto member = std::find(block.functions.begin(), block.functions.end(), index);
      if (block.axes == term.variables && member != block.functions.end()) {
        result.member = member - block.functions.begin();
        break;
      }
    }
    const Block& block = m_layout.blocks[result.block];
    if (term.pieces.size() > 1)
      result.offsets.resize(term.variables.size());
    std::size_t stride = 1;
    for (std::size_t j = result.offsets.size(); j-- > 0; stride *= term.cells(j)) {
      const std::vector<Exact_rational>& breaks = m_breaks[term.variables[j]];
      if (!term.breaks[j].empty())
        for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
          const auto next = std::upper_bound(term.breaks[j].begin(), term.breaks[j].end(), breaks[k]);
          const std::size_t cell = next - term.breaks[j].begin() - 1;
          result.offsets[j].push_back(stride * (std::min)(cell, term.cells(j) - 1));
        }
    }
    for (const auto& coefficients : term.pieces) {
      std::vector<Short_integer>& padded = result.pieces.emplace_back(block.points, Short_integer(0));
      std::vector<int> k(term.degrees.size(), 0);
      for (const Exact_rational& coefficient : coefficients) {
        std::size_t position = 0;
        for (std::size_t j = 0; j < k.size(); ++j)
          position = position * (static_cast<std::size_t>(block.degrees[j]) + 1) + k[j];
        padded[position] = numerator_over(coefficient, denominator);
        for (std::size_t j = k.size(); j-- > 0 && ++k[j] > term.degrees[j];)
          k[j] = 0;
      }
    }
  }
}

// lcm_i C(d,i) = lcm(1,...,d+1) / (d+1)
inline Short_integer Exact_source::common_binomial(int degree)
{
  Short_integer common(1);
  for (int i = 2; i <= degree + 1; ++i)
    common *= i / gcd(common, i);
  return common / (degree + 1);
}

inline bool Exact_source::multiply(const double* matrix, const std::vector<long>& scale)
{
  const std::size_t n = scale.size();
  if (!std::all_of(matrix, matrix + n * n, [](double x) { return std::isfinite(x); }))
    return false;
  std::vector<Short_integer> product(n * n, Short_integer(0));
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<std::pair<Short_integer, long>> row;
    long finest = (std::numeric_limits<long>::max)();
    for (std::size_t i = 0; i < n; ++i) {
      auto& [factor, exponent] = row.emplace_back(to_dyadic<Short_integer>(matrix[j * n + i]));
      exponent -= scale[i];
      if (factor != 0)
        finest = (std::min)(finest, exponent);
    }
    for (std::size_t i = 0; i < n; ++i) {
      auto& [factor, exponent] = row[i];
      if (factor == 0)
        continue;
      shift_left(factor, static_cast<unsigned long>(exponent - finest));
      if (m_matrix.empty())
        product[j * n + i] = factor;
      else
        for (std::size_t k = 0; k < n; ++k)
          add_product(product[j * n + k], factor, m_matrix[i * n + k]);
    }
  }
  m_matrix = std::move(product);
  return true;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_EXACT_SOURCE_IMPL_H
