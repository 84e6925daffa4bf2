// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_EXACT_SOURCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_EXACT_SOURCE_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/number/Short_integer.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Cell_grid.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Fixed_point_source.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/Integer_term.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/scaled_matrix_product.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The functions of a system as integer polynomials, one set per cell of the grid of their breaks, and what the solver asks
of them exactly: the Bernstein coefficients on a box with dyadic corners, and the values at a dyadic point. Rounding
happens once, at the end.

Each function is multiplied by the common denominator of its coefficients, which moves no root and no sign. On request
all of them are multiplied by a matrix, when every block of the layout holds them all. Not shared between threads: the
scratch numbers live here.
*/
class Exact_source : public Cell_grid
{
  // Where the part of a function in a block lies.
  struct Place
  {
    std::size_t block, member;
  };

  const System_layout& m_layout;
  std::vector<Integer_term> m_terms;
  std::vector<Short_integer> m_denominators;           // per block: product over the axes of lcm_i C(d,i)
  std::vector<Short_integer> m_matrix;   // functions x functions, row-major; empty: the functions as they are
  std::vector<Short_integer> m_values, m_work;
  std::vector<std::pair<Short_integer, long>> m_point;   // of an evaluation: mantissa 2^exponent, exponent <= 0
  std::vector<Dyadic_sum<Short_integer>> m_sums;
  Short_integer m_horner, m_shifted;
  std::vector<std::vector<Place>> m_places;   // per function
  std::vector<long> m_exponents;              // per block, of an expansion
  Fixed_point_source m_fixed_point;
  Cell m_home_cell;
  std::vector<double> m_home_lower, m_home_upper;
  Run_control* m_control;   // null: none

public:
  // With a control, the constructor throws Run_stopped when it says so: many large functions take long.
  Exact_source(const Constraint_system_d& system, const System_layout& layout, Run_control* control = nullptr)
    : Exact_source(system, layout, breaks_of_splines(system, layout), control)
  {
    m_control = nullptr;
  }

  // With the cells of another source of the same system.
  Exact_source(const Constraint_system_d& system, const System_layout& layout,
               std::vector<std::vector<Exact_rational>> breaks, Run_control* control = nullptr)
    : Cell_grid(std::move(breaks)), m_layout(layout), m_fixed_point(layout), m_control(control)
  {
    for (int f = 0; f < layout.functions; ++f) {
      check();
      append_integer_terms(m_terms, function_of(system, f), f, layout, *this);
    }
    m_places.resize(layout.functions);
    m_denominators.reserve(layout.blocks.size());
    for (std::size_t b = 0; b < layout.blocks.size(); ++b)
      for (std::size_t m = 0; m < layout.blocks[b].functions.size(); ++m)
        m_places[layout.blocks[b].functions[m]].push_back({b, m});
    for (const Block& block : layout.blocks) {
      Short_integer& denominator = m_denominators.emplace_back(1);
      for (int degree : block.degrees)
        denominator *= common_binomial(degree);
    }
    m_values.resize(layout.size);
  }

  const System_layout& layout() const { return m_layout; }

  // With a control, coefficients on a box are not finished when it stops the run: Run_stopped is thrown.
  void set_control(Run_control* control) { m_control = control; }

  // The matrix that the functions are multiplied by, row-major; empty: none.
  const std::vector<Short_integer>& matrix() const { return m_matrix; }
  void set_matrix(const std::vector<Short_integer>& matrix) { m_matrix = matrix; }

  // Multiplies the functions by a matrix (row-major) whose columns act on the functions times 2^-scale. The rows are
  // multiplied by powers of two. Returns whether all numbers are finite.
  bool multiply(const double* matrix, const std::vector<long>& scale)
  {
    std::optional<std::vector<Short_integer>> product = scaled_matrix_product(matrix, scale, m_matrix);
    if (product)
      m_matrix = *std::move(product);
    return product.has_value();
  }

  // Writes the Bernstein coefficients of all functions on the box [lower, upper], those of function f scaled by
  // 2^-scale[f] such that the largest lies in [1/2, 1), and a bound on the rounding error per block and function.
  template <class NT, class Coordinate>
  void bernstein_coefficients(const Cell& cell, std::span<const Coordinate> lower, std::span<const Coordinate> upper,
                              NT* coefficients, double* errors, std::vector<long>& scale);

  // The value of every function at a point, with a relative error below 2^-51: the sign is right.
  using Value = Scaled_value;
  template <class Coordinate>
  void evaluate(const Cell& cell, std::span<const Coordinate> point, std::vector<Value>& values);

  // The same with errors that the values tell of, and faster.
  template <class Coordinate>
  void evaluate_closely(const Cell& cell, std::span<const Coordinate> point, std::vector<Value>& values)
  {
    if constexpr (std::is_same_v<Coordinate, double>)
      if (has_fixed_point(cell, point, point))
        return m_fixed_point.evaluate(point, values);
    evaluate(cell, point, values);
  }

  // Most of the boxes and points that are asked for lie in this part of a cell, until leave_home(). What was asked for
  // before has no influence on the answers.
  template <class Coordinate>
  void set_home(const Cell& cell, std::span<const Coordinate> lower, std::span<const Coordinate> upper);
  void leave_home()
  {
    m_home_cell.clear();
    m_fixed_point.clear();
  }

private:
  void check()
  {
    if (m_control != nullptr)
      m_control->check();
  }

  bool is_in_home(const Cell& cell, std::span<const double> lower, std::span<const double> upper) const
  {
    if (cell != m_home_cell)
      return false;
    for (std::size_t v = 0; v < lower.size(); ++v)
      if (!(m_home_lower[v] <= lower[v] && upper[v] <= m_home_upper[v] && m_home_lower[v] < m_home_upper[v]))
        return false;
    return true;
  }

  Short_integer& value_at(const Place& place, std::size_t point)
  {
    const Block& block = m_layout.blocks[place.block];
    return m_values[block.offset + point * block.functions.size() + place.member];
  }

  void add_to_all(const Place& place, const Short_integer& constant)
  {
    for (std::size_t p = 0; p < m_layout.blocks[place.block].points; ++p)
      value_at(place, p) += constant;
  }

  template <class Coordinate>
  void set_point(std::span<const Coordinate> point);
  void contract_last_axis(const Short_integer* coefficients, std::size_t points, int degree, const Short_integer& x,
                          long exponent);
  void load(const Cell& cell);
  template <class Coordinate>
  void expand(const Cell& cell, std::span<const Coordinate> lower, std::span<const Coordinate> upper);
  void gather_constants();
  template <class Coordinate>
  bool has_fixed_point(const Cell& cell, std::span<const Coordinate> lower, std::span<const Coordinate> upper);

  // lcm_i C(d,i) = lcm(1,...,d+1) / (d+1)
  static Short_integer common_binomial(int degree)
  {
    Short_integer common(1);
    for (int i = 2; i <= degree + 1; ++i)
      common *= i / gcd(common, i);
    return common / (degree + 1);
  }
};

template <class Coordinate>
void Exact_source::set_home(const Cell& cell, std::span<const Coordinate> lower, std::span<const Coordinate> upper)
{
  leave_home();
  if constexpr (std::is_same_v<Coordinate, double>) {
    m_home_cell = cell;
    m_home_lower.assign(lower.begin(), lower.end());
    m_home_upper.assign(upper.begin(), upper.end());
  }
}

// Whether fixed-point numbers may answer for a box. They begin with the expansion on the home box, which most boxes and
// points ask for first.
template <class Coordinate>
bool Exact_source::has_fixed_point(const Cell& cell, std::span<const Coordinate> lower,
                                   std::span<const Coordinate> upper)
{
  if constexpr (std::is_same_v<Coordinate, double>) {
    if (!m_matrix.empty() || !is_in_home(cell, lower, upper))
      return false;
    if (!m_fixed_point.is_set()) {
      expand(cell, std::span<const double>(m_home_lower), std::span<const double>(m_home_upper));
      m_fixed_point.set(m_home_lower, m_home_upper, m_values, m_denominators, m_exponents);
    }
    return true;
  }
  return false;
}

// The sums of the terms on a cell, in power form.
inline void Exact_source::load(const Cell& cell)
{
  for (Short_integer& value : m_values)
    value = 0;
  for (const Integer_term& term : m_terms) {
    const Block& block = m_layout.blocks[term.block];
    const std::vector<Short_integer>& source = term.piece(cell, m_layout);
    const std::size_t members = block.functions.size();
    Short_integer* values = m_values.data() + block.offset;
    if (m_matrix.empty())
      for (std::size_t p = 0; p < block.points; ++p)
        values[p * members + term.member] += source[p];
    else
      for (std::size_t m = 0; m < members; ++m)
        for (std::size_t p = 0; p < block.points; ++p)
          add_product(values[p * members + m], m_matrix[m * members + term.function], source[p]);
  }
}

// Fills m_values with the Bernstein coefficients on a box, as integers: those of block b times 2^m_exponents[b] /
// m_denominators[b]. Along each axis: x = begin + width t in integers, p(x) -> sum_i p_i t^i, then sums of binomially
// weighted coefficients.
template <class Coordinate>
void Exact_source::expand(const Cell& cell, std::span<const Coordinate> lower, std::span<const Coordinate> upper)
{
  load(cell);
  m_exponents.assign(m_layout.blocks.size(), 0);
  std::vector<Short_integer> weights;
  for (int v = 0; v < m_layout.dimension; ++v) {
    const auto [begin, width, exponent] = common_dyadic<Short_integer>(lower[v], upper[v]);
    for (const Block_axis& axis : m_layout.blocks_of_axis[v]) {
      check();
      const Block& block = m_layout.blocks[axis.block];
      const int degree = axis.view.degree;
      const std::size_t inner = axis.view.inner;
      weights.assign(1, common_binomial(degree));   // lcm_i C(d,i) / C(d,k), times width^k
      for (int k = 1; k <= degree; ++k) {
        weights.push_back(weights.back() * k * width);
        weights.back() /= degree - k + 1;
      }
      const std::size_t line = inner * (degree + 1);
      for (std::size_t o = 0; o < axis.view.outer; ++o)
        for (std::size_t i = 0; i < inner; ++i) {
          Short_integer* a = m_values.data() + block.offset + o * line + i;
          if (exponent < 0)
            for (int k = 0; k < degree; ++k)
              shift_left(a[inner * k], static_cast<unsigned long>(-exponent) * (degree - k));
          for (int r = 0; r < degree && begin != 0; ++r)
            for (int k = degree - 1; k >= r; --k)
              add_product(a[inner * k], begin, a[inner * (k + 1)]);
          for (int k = 0; k <= degree; ++k)
            a[inner * k] *= weights[k];
          for (int r = 1; r <= degree; ++r)
            for (int k = degree; k >= r; --k)
              a[inner * k] += a[inner * (k - 1)];
        }
      if (exponent < 0)
        m_exponents[axis.block] += exponent * degree;
    }
  }
}

template <class NT, class Coordinate>
void Exact_source::bernstein_coefficients(const Cell& cell, std::span<const Coordinate> lower,
                                          std::span<const Coordinate> upper, NT* coefficients, double* errors,
                                          std::vector<long>& scale)
{
  if constexpr (std::is_same_v<NT, double> && std::is_same_v<Coordinate, double>)
    if (has_fixed_point(cell, lower, upper) &&
        m_fixed_point.bernstein_coefficients(lower, upper, coefficients, errors, scale))
      return;
  expand(cell, lower, upper);
  gather_constants();

  // One scale per function, then the only rounding.
  std::vector<long>& largest = scale;
  largest.assign(m_layout.functions, (std::numeric_limits<long>::min)());
  for (std::size_t b = 0; b < m_layout.blocks.size(); ++b) {
    const Block& block = m_layout.blocks[b];
    const long shift = m_exponents[b] - bit_length(m_denominators[b]) + 1;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Short_integer& value = m_values[block.offset + i];
      long& most = largest[block.functions[i % block.functions.size()]];
      if (value != 0)
        most = (std::max)(most, static_cast<long>(bit_length(value)) + shift);
    }
  }
  for (long& s : largest)
    if (s == (std::numeric_limits<long>::min)())
      s = 0;
  for (std::size_t b = 0; b < m_layout.blocks.size(); ++b) {
    check();
    const Block& block = m_layout.blocks[b];
    const std::size_t members = block.functions.size();
    // in the hundreds of degrees, the denominator leaves the range of double
    const long length = bit_length(m_denominators[b]);
    const double denominator = to_scaled_double(m_denominators[b], -length);
    for (std::size_t m = 0; m < members; ++m)
      errors[block.first_error + m] = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
      const std::size_t m = i % members;
      const long shift = m_exponents[b] - scale[block.functions[m]];
      const Short_integer& value = m_values[block.offset + i];
      if constexpr (std::is_same_v<NT, double>) {
        const double rounded = to_scaled_double(value, shift - length) / denominator;
        coefficients[block.offset + i] = rounded;
        double& error = errors[block.first_error + m];
        error = (std::max)(error, std::abs(rounded));
      } else {
        coefficients[block.offset + i] = Number_traits<NT>::from_rational(
            scaled_rational(value.to_big_integer(), shift) / scaled_rational(m_denominators[b].to_big_integer(), 0));
      }
    }
    for (std::size_t m = 0; m < members; ++m)
      errors[block.first_error + m] *= 0x1p-50;   // truncation, rounding of the denominator and the division: 3 x 2^-52
    for (std::size_t m = 0; m < members && std::is_same_v<NT, double>; ++m)
      errors[block.first_error + m] += 0x1p-1000; // and what underflows
  }
}

// A function that nearly vanishes on a box may be the sum of blocks that do not. Their constant parts cancel here,
// where it is exact: each block gives (nearly) its first control value to the block with the finest unit, and what is
// left of it is as small as its variation.
inline void Exact_source::gather_constants()
{
  for (const std::vector<Place>& places : m_places) {
    if (places.size() < 2)
      continue;
    const Place& home = *std::min_element(places.begin(), places.end(), [&](const Place& a, const Place& b) {
      return m_exponents[a.block] < m_exponents[b.block];
    });
    Short_integer sum(0);   // in units of the home block
    for (const Place& place : places)
      if (&place != &home) {
        Short_integer constant = value_at(place, 0) / m_denominators[place.block];
        if (constant == 0)
          continue;
        add_to_all(place, Short_integer(-constant * m_denominators[place.block]));
        shift_left(constant, static_cast<unsigned long>(m_exponents[place.block] - m_exponents[home.block]));
        sum += constant;
      }
    if (sum != 0)
      add_to_all(home, Short_integer(sum * m_denominators[home.block]));
  }
}

template <class Coordinate>
void Exact_source::set_point(std::span<const Coordinate> point)
{
  m_point.resize(point.size());
  for (std::size_t v = 0; v < point.size(); ++v) {
    m_point[v] = to_dyadic<Short_integer>(point[v]);
    auto& [x, exponent] = m_point[v];
    if (exponent > 0) {
      shift_left(x, static_cast<unsigned long>(exponent));
      exponent = 0;
    }
  }
}

// Horner's scheme on every row of the last axis, at x 2^exponent, into m_work; the coefficients may lie there.
inline void Exact_source::contract_last_axis(const Short_integer* coefficients, std::size_t points, int degree,
                                             const Short_integer& x, long exponent)
{
  for (std::size_t p = 0; p < points; ++p) {
    const Short_integer* a = coefficients + p * (degree + 1);
    m_horner = a[degree];
    for (int k = degree - 1; k >= 0; --k) {
      m_horner *= x;
      if (a[k] != 0) {
        set_shifted(m_shifted, a[k], static_cast<unsigned long>(-exponent) * (degree - k));
        m_horner += m_shifted;
      }
    }
    m_work[p] = m_horner;
  }
}

template <class Coordinate>
void Exact_source::evaluate(const Cell& cell, std::span<const Coordinate> point, std::vector<Value>& values)
{
  set_point(point);
  m_sums.resize(m_layout.functions);
  for (auto& sum : m_sums)
    sum.reset();
  for (const Integer_term& term : m_terms) {
    const Block& block = m_layout.blocks[term.block];
    const std::vector<Short_integer>& coefficients = term.piece(cell, m_layout);
    const Short_integer* rest = coefficients.data();
    m_work.resize((std::max)(m_work.size(), block.points));
    std::size_t points = block.points;
    long exponent = 0;
    for (std::size_t j = block.axes.size(); j-- > 0; rest = m_work.data()) {
      const auto& [x, e] = m_point[block.axes[j]];
      points /= block.degrees[j] + 1;
      contract_last_axis(rest, points, block.degrees[j], x, e);
      exponent += e * block.degrees[j];
    }
    if (m_matrix.empty())
      m_sums[term.function].add(rest[0], exponent);
    else
      for (int f = 0; f < m_layout.functions; ++f)
        m_sums[f].add(rest[0] * m_matrix[f * m_layout.functions + term.function], exponent);
  }
  values.resize(m_layout.functions);
  for (int f = 0; f < m_layout.functions; ++f) {
    const long bits = bit_length(m_sums[f].mantissa());
    values[f] = {to_scaled_double(m_sums[f].mantissa(), -bits), m_sums[f].exponent() + bits};
  }
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_EXACT_SOURCE_H
