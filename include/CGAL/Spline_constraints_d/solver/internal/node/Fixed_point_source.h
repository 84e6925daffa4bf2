// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FIXED_POINT_SOURCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FIXED_POINT_SOURCE_H

#include <CGAL/Spline_constraints_d/number/Short_integer.h>
#include <CGAL/Spline_constraints_d/number/fixed_point.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// mantissa 2^exponent, with a relative error below 2^-43 and another one of `error` 2^exponent.
struct Scaled_value
{
  double mantissa;
  long exponent;
  double error = 0;
};

/*
The Bernstein coefficients of all functions of a system on a home box, as fixed-point numbers of 127 bits, and what
follows from them on boxes and at points within, without integers of any length. Every result has a bound on its error,
and where that is too large beside the result there is none: then exact arithmetic has to answer.

The unit of a function is chosen such that the sum of its blocks stays below 2^124 units. `multiplied()` is off by 6
units at most (number/fixed_point.h).
*/
class Fixed_point_source
{
  const System_layout& m_layout;
  std::vector<double> m_lower, m_upper;
  std::vector<Fixed_point_range> m_range;   // per unknown
  std::vector<Fixed_point> m_home, m_work;
  std::vector<long> m_unit;        // per function: exponent of the unit
  std::vector<double> m_error;     // per block and function, in units
  std::vector<Unsigned_fixed_point> m_parameter, m_basis;
  std::vector<Fixed_point> m_sum;
  std::vector<const Block*> m_first_block;        // per function, while constants are gathered
  std::vector<Unsigned_fixed_point> m_largest;    // per function
  std::vector<double> m_factor;
  std::vector<double> m_sum_error;

public:
  explicit Fixed_point_source(const System_layout& layout) : m_layout(layout) {}

  bool is_set() const { return !m_home.empty(); }
  void clear() { m_home.clear(); }

  // The coefficients of block b on the box [lower, upper] are values / denominators[b] 2^exponents[b].
  void set(std::span<const double> lower, std::span<const double> upper, const std::vector<Short_integer>& values,
           const std::vector<Short_integer>& denominators, const std::vector<long>& exponents);

  // As Exact_source::bernstein_coefficients(), for a box within the home box. Returns whether the error is as small as
  // that of rounding to double.
  bool bernstein_coefficients(std::span<const double> lower, std::span<const double> upper, double* coefficients,
                              double* errors, std::vector<long>& scale);

  // The values at a point of the home box.
  void evaluate(std::span<const double> point, std::vector<Scaled_value>& values);

private:
  void keep_lower_part(const Block_axis& axis, Unsigned_fixed_point t);
  void keep_upper_part(const Block_axis& axis, Unsigned_fixed_point t);
  void gather_constants();
  void compute_basis(int degree, Unsigned_fixed_point t);
};

inline void Fixed_point_source::set(std::span<const double> lower, std::span<const double> upper,
                                    const std::vector<Short_integer>& values,
                                    const std::vector<Short_integer>& denominators, const std::vector<long>& exponents)
{
  m_lower.assign(lower.begin(), lower.end());
  m_upper.assign(upper.begin(), upper.end());
  m_range.clear();
  for (std::size_t v = 0; v < lower.size(); ++v)
    m_range.emplace_back(lower[v], upper[v]);
  // one: the quotient of lengths is rounded
  const long spare_bits = bit_length(Unsigned_two_words(m_layout.blocks.size())) + 1;
  m_unit.assign(m_layout.functions, (std::numeric_limits<long>::min)() / 2);
  for (std::size_t b = 0; b < m_layout.blocks.size(); ++b) {
    const Block& block = m_layout.blocks[b];
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Short_integer& value = values[block.offset + i];
      long& unit = m_unit[block.functions[i % block.functions.size()]];
      if (value != 0)
        unit = (std::max)(
            unit, bit_length(value) - bit_length(denominators[b]) + exponents[b] + spare_bits - fixed_point_bits);
    }
  }
  m_home.resize(m_layout.size);
  for (std::size_t b = 0; b < m_layout.blocks.size(); ++b) {
    const Block& block = m_layout.blocks[b];
    for (std::size_t i = 0; i < block.size(); ++i)
      m_home[block.offset + i] =
          fixed_point_quotient(values[block.offset + i],
                               exponents[b] - m_unit[block.functions[i % block.functions.size()]], denominators[b]);
  }
}

inline bool Fixed_point_source::bernstein_coefficients(std::span<const double> lower, std::span<const double> upper,
                                                       double* coefficients, double* errors, std::vector<long>& scale)
{
  m_work = m_home;
  m_error.assign(m_layout.errors, 2);   // of the home box
  for (int v = 0; v < m_layout.dimension; ++v) {
    const bool cuts_before = lower[v] != m_lower[v], cuts_after = upper[v] != m_upper[v];
    if (!cuts_before && !cuts_after)
      continue;
    const Unsigned_fixed_point to = m_range[v](upper[v]),
                               from = cuts_before ? Fixed_point_range(m_lower[v], upper[v])(lower[v]) : 0;
    for (const Block_axis& axis : m_layout.blocks_of_axis[v]) {
      if (cuts_after)
        keep_lower_part(axis, to);
      if (cuts_before)
        keep_upper_part(axis, from);
      const Block& block = m_layout.blocks[axis.block];
      // 6 units per level of de Casteljau's scheme, and the rounding of the parameter: a quarter of a unit times the
      // degree
      for (std::size_t m = 0; m < block.functions.size(); ++m)
        m_error[block.first_error + m] += 14.0 * axis.view.degree;
    }
  }
  gather_constants();

  m_largest.assign(m_layout.functions, 0);
  for (const Block& block : m_layout.blocks)
    for (std::size_t i = 0; i < block.size(); ++i) {
      Unsigned_fixed_point& most = m_largest[block.functions[i % block.functions.size()]];
      most = (std::max)(most, magnitude(m_work[block.offset + i]));
    }
  for (const Block& block : m_layout.blocks)
    for (std::size_t m = 0; m < block.functions.size(); ++m)
      if (!(m_error[block.first_error + m] <= 0x1p-52 * approximate(m_largest[block.functions[m]])))
        return false;
  scale.resize(m_layout.functions);
  m_factor.resize(m_layout.functions);
  for (int f = 0; f < m_layout.functions; ++f) {
    const int bits = bit_length(m_largest[f]);
    scale[f] = m_unit[f] + bits;
    m_factor[f] = double_power_of_two(-bits);
  }
  for (const Block& block : m_layout.blocks) {
    const std::size_t members = block.functions.size();
    for (std::size_t m = 0; m < members; ++m) {
      const double by = m_factor[block.functions[m]];
      double most = 0;
      for (std::size_t i = m; i < block.size(); i += members) {
        coefficients[block.offset + i] = by * approximate(m_work[block.offset + i]);
        most = (std::max)(most, std::abs(coefficients[block.offset + i]));
      }
      errors[block.first_error + m] = 0x1p-51 * most + m_error[block.first_error + m] * by * (1 + 0x1p-40) + 0x1p-1000;
    }
  }
  return true;
}

// De Casteljau's scheme, up to the parameter.
inline void Fixed_point_source::keep_lower_part(const Block_axis& axis, Unsigned_fixed_point t)
{
  const std::size_t inner = axis.view.inner, line = inner * (axis.view.degree + 1);
  Fixed_point* data = m_work.data() + m_layout.blocks[axis.block].offset;
  for (std::size_t o = 0; o < axis.view.outer; ++o, data += line)
    for (int r = 1; r <= axis.view.degree; ++r)
      for (std::size_t i = line; i-- > inner * r;)
        data[i] = data[i - inner] + multiplied(data[i] - data[i - inner], t);
}

// And from it on.
inline void Fixed_point_source::keep_upper_part(const Block_axis& axis, Unsigned_fixed_point t)
{
  const std::size_t inner = axis.view.inner, line = inner * (axis.view.degree + 1);
  Fixed_point* data = m_work.data() + m_layout.blocks[axis.block].offset;
  for (std::size_t o = 0; o < axis.view.outer; ++o, data += line)
    for (int r = 1; r <= axis.view.degree; ++r)
      for (std::size_t i = 0; i < line - inner * r; ++i)
        data[i] += multiplied(data[i + inner] - data[i], t);
}

// The first control value of every block but one moves to this one, where it cancels with those of others: what is left
// of a block is as small as its variation.
inline void Fixed_point_source::gather_constants()
{
  m_sum.assign(m_layout.functions, 0);
  m_first_block.assign(m_layout.functions, nullptr);
  for (const Block& block : m_layout.blocks)
    for (std::size_t m = 0; m < block.functions.size(); ++m) {
      const int f = block.functions[m];
      if (m_first_block[f] == nullptr) {
        m_first_block[f] = &block;
        continue;
      }
      const Fixed_point constant = m_work[block.offset + m];
      m_sum[f] += constant;
      for (std::size_t i = m; i < block.size(); i += block.functions.size())
        m_work[block.offset + i] -= constant;
    }
  for (int f = 0; f < m_layout.functions; ++f)
    if (m_sum[f] != 0) {
      const std::size_t members = m_first_block[f]->functions.size();
      const std::size_t m = std::find(m_first_block[f]->functions.begin(), m_first_block[f]->functions.end(), f) -
          m_first_block[f]->functions.begin();
      for (std::size_t i = m; i < m_first_block[f]->size(); i += members)
        m_work[m_first_block[f]->offset + i] += m_sum[f];
    }
}

// The Bernstein polynomials at a parameter.
inline void Fixed_point_source::compute_basis(int degree, Unsigned_fixed_point t)
{
  const Unsigned_fixed_point rest = fixed_point_one - t;
  m_basis.resize(degree + 1);
  m_basis[0] = degree == 0 ? fixed_point_one : rest;
  if (degree > 0)
    m_basis[1] = t;
  for (int r = 2; r <= degree; ++r) {
    m_basis[r] = unsigned_product(m_basis[r - 1], t);
    for (int k = r - 1; k > 0; --k)
      m_basis[k] = unsigned_product(m_basis[k], rest) + unsigned_product(m_basis[k - 1], t);
    m_basis[0] = unsigned_product(m_basis[0], rest);
  }
}

inline void Fixed_point_source::evaluate(std::span<const double> point, std::vector<Scaled_value>& values)
{
  m_parameter.resize(m_layout.dimension);
  for (int v = 0; v < m_layout.dimension; ++v)
    m_parameter[v] = m_range[v](point[v]);
  m_sum.assign(m_layout.functions, 0);
  m_sum_error.assign(m_layout.functions, 0);
  m_work.resize(m_layout.size);
  for (const Block& block : m_layout.blocks) {
    const Fixed_point* rest = m_home.data() + block.offset;
    double error = 2;
    for (std::size_t j = 0; j < block.axes.size(); ++j, rest = m_work.data()) {
      const int degree = block.degrees[j];
      compute_basis(degree, m_parameter[block.axes[j]]);
      const std::size_t inner = block.lengths[j + 1];
      for (std::size_t i = 0; i < inner; ++i) {
        Fixed_point sum = multiplied(rest[i], m_basis[0]);
        for (int k = 1; k <= degree; ++k)
          sum += multiplied(rest[k * inner + i], m_basis[k]);
        m_work[i] = sum;
      }
      // A Bernstein polynomial is off by 12 units of 2^-127 per level and twice the degree for the parameter, times
      // coefficients below 2^124; 6 units per product.
      error += (degree + 1) * (14.0 * degree / 8 + 6);
    }
    for (std::size_t m = 0; m < block.functions.size(); ++m) {
      m_sum[block.functions[m]] += rest[m];
      m_sum_error[block.functions[m]] += error;
    }
  }
  values.resize(m_layout.functions);
  for (int f = 0; f < m_layout.functions; ++f) {
    const int bits = bit_length(magnitude(m_sum[f]));
    const double unit = double_power_of_two(-bits);
    values[f] = {approximate(m_sum[f]) * unit, m_unit[f] + bits, m_sum_error[f] * unit};
  }
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_FIXED_POINT_SOURCE_H
