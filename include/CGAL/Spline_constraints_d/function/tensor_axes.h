// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_TENSOR_AXES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_TENSOR_AXES_H

#include <CGAL/Spline_constraints_d/function/Value_and_gradient.h>
#include <CGAL/Spline_constraints_d/function/bernstein_kernels.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Numbers whose comparisons always have an answer: floating point and exact types, not intervals.
template <class NT>
concept Totally_comparable = requires(const NT& a, const NT& b) {
  { a < b } -> std::same_as<bool>;
  { a == b } -> std::same_as<bool>;
};

template <class NT>
inline bool is_finite_number(const NT& x)
{
  if constexpr (std::is_floating_point_v<NT>)
    return std::isfinite(x);
  else if constexpr (requires { x.is_bounded(); })
    return x.is_bounded();
  else
    return true;
}

template <bool is_protected>
inline bool is_finite_number(const CGAL::Interval_nt<is_protected>& x)
{
  return std::isfinite(x.inf()) && std::isfinite(x.sup());
}

// Whether a factor may be skipped. An interval that happens to be [0,0] is not worth the question.
template <class NT>
inline bool is_known_zero(const NT& x)
{
  if constexpr (Totally_comparable<NT>)
    return x == NT(0);
  else
    return false;
}

// The smaller of two numbers; on intervals the enclosure of it, made of the smaller ends.
template <class NT>
inline NT least(const NT& a, const NT& b)
{
  if constexpr (Totally_comparable<NT>)
    return b < a ? b : a;
  else if constexpr (requires { NT(a.lower(), a.upper()); })
    return NT((std::min)(a.lower(), b.lower()), (std::min)(a.upper(), b.upper()));
  else
    return (min)(a, b);
}

template <class NT>
inline NT greatest(const NT& a, const NT& b)
{
  if constexpr (Totally_comparable<NT>)
    return a < b ? b : a;
  else if constexpr (requires { NT(a.lower(), a.upper()); })
    return NT((std::max)(a.lower(), b.lower()), (std::max)(a.upper(), b.upper()));
  else
    return (max)(a, b);
}

// Least and largest of at least one number.
template <class NT>
inline std::pair<NT, NT> least_and_greatest(const std::vector<NT>& numbers)
{
  std::pair<NT, NT> result(numbers.front(), numbers.front());
  for (const NT& x : numbers) {
    result.first = least(result.first, x);
    result.second = greatest(result.second, x);
  }
  return result;
}

// Throws unless all numbers are finite; the message names the first that is not.
template <class NT>
inline void check_finite(const std::vector<NT>& numbers, std::string_view what)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!is_finite_number(numbers[i]))
      throw Invalid_input(std::string(what) + " " + std::to_string(i) + " is not a finite number");
}

// Throws unless two counts agree.
void check_count(std::size_t count, std::size_t expected, std::string_view what);

// Number of entries of a tensor with these degrees.
std::size_t tensor_size(const std::vector<int>& degrees);

// The same for degrees that come from outside: throws when one is negative or the size cannot be represented.
template <class NT>
std::size_t checked_tensor_size(const std::vector<int>& degrees, std::string_view who)
{
  const std::size_t limit = static_cast<std::size_t>((std::numeric_limits<std::ptrdiff_t>::max)()) / sizeof(NT);
  std::size_t size = 1;
  for (std::size_t j = 0; j < degrees.size(); ++j) {
    if (degrees[j] < 0)
      throw Invalid_input(std::string(who) + ": degree " + std::to_string(degrees[j]) + " of axis " +
                          std::to_string(j) + " is negative");
    const std::size_t extent = static_cast<std::size_t>(degrees[j]) + 1;
    if (size > limit / extent)
      throw Invalid_input(std::string(who) + ": too many coefficients (overflow at axis " + std::to_string(j) + ")");
    size *= extent;
  }
  return size;
}

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template std::size_t checked_tensor_size<double>(const std::vector<int>&, std::string_view);
extern template std::size_t checked_tensor_size<Exact_rational>(const std::vector<int>&, std::string_view);
#endif

// A tensor seen along one of its axes.
Axis_view axis_view(const std::vector<int>& degrees, std::size_t axis);

// Distance in memory between neighbours along each axis.
std::vector<std::size_t> tensor_strides(const std::vector<int>& degrees);

// All index vectors from 0 to the given bounds, the last index fastest.
template <class Visit>
void for_each_index(const std::vector<int>& bounds, const Visit& visit)
{
  std::vector<int> index(bounds.size(), 0);
  for (;;) {
    visit(index);
    std::size_t j = bounds.size();
    while (j > 0 && index[j - 1] == bounds[j - 1])
      index[--j] = 0;
    if (j == 0)
      return;
    ++index[j - 1];
  }
}

// The positions in a tensor with degrees `all` of the entries of a smaller one that begins at the index `lower`, in the
// order of the smaller.
template <class Visit>
void for_each_position(const std::vector<int>& all, const std::vector<int>& lower, const std::vector<int>& degrees,
                       const Visit& visit)
{
  const std::vector<std::size_t> strides = tensor_strides(all);
  for_each_index(degrees, [&](const std::vector<int>& index) {
    std::size_t position = 0;
    for (std::size_t j = 0; j < index.size(); ++j)
      position += strides[j] * static_cast<std::size_t>(lower[j] + index[j]);
    visit(position);
  });
}

template <class NT>
std::vector<NT> tensor_block(const std::vector<NT>& data, const std::vector<int>& all, const std::vector<int>& lower,
                             const std::vector<int>& degrees)
{
  std::vector<NT> result;
  result.reserve(tensor_size(degrees));
  for_each_position(all, lower, degrees, [&](std::size_t position) { result.push_back(data[position]); });
  return result;
}

// All entries with some of the indices on one axis.
template <class NT>
std::vector<NT> tensor_range(const std::vector<NT>& data, const std::vector<int>& all, int axis, std::size_t first,
                             std::size_t count)
{
  std::vector<int> lower(all.size(), 0), degrees = all;
  lower[axis] = static_cast<int>(first);
  degrees[axis] = static_cast<int>(count) - 1;
  return tensor_block(data, all, lower, degrees);
}

template <class NT>
void place_tensor_block(std::vector<NT>& data, const std::vector<int>& all, const std::vector<int>& lower,
                        const std::vector<NT>& block, const std::vector<int>& degrees)
{
  std::size_t next = 0;
  for_each_position(all, lower, degrees, [&](std::size_t position) { data[position] = block[next++]; });
}

// A matrix of which each row has `width` entries from column `first[row]` on; without `first` all columns.
template <class NT>
struct Row_matrix
{
  std::size_t rows;
  std::size_t columns;
  std::size_t width;
  std::vector<std::size_t> first;
  std::vector<NT> entries;

  Row_matrix(std::size_t r, std::size_t c) : rows(r), columns(c), width(c), entries(r * c, NT(0)) {}

  // A band matrix, to be filled row by row.
  static Row_matrix band(std::size_t columns, std::size_t width)
  {
    Row_matrix result(0, columns);
    result.width = width;
    return result;
  }

  void add_row(std::size_t first_column, const std::vector<NT>& row)
  {
    ++rows;
    first.push_back(first_column);
    entries.insert(entries.end(), row.begin(), row.end());
  }

  NT& operator()(std::size_t i, std::size_t j) { return entries[i * width + j]; }
  const NT& operator()(std::size_t i, std::size_t j) const { return entries[i * width + j]; }
};

/*
Applies a matrix to every line of a tensor along one axis. Elevation, restriction, knot insertion and the changes
between bases are all of this kind: they differ by the matrix, which is built once, while this loop runs over contiguous
rows.
*/
template <class NT>
std::vector<NT> transform_axis(const std::vector<NT>& data, const Axis_view& view, const Row_matrix<NT>& matrix)
{
  std::vector<NT> result(view.outer * matrix.rows * view.inner, NT(0));
  for (std::size_t o = 0; o < view.outer; ++o)
    for (std::size_t k = 0; k < matrix.rows; ++k) {
      NT* target = result.data() + (o * matrix.rows + k) * view.inner;
      const std::size_t first = matrix.first.empty() ? 0 : matrix.first[k];
      for (std::size_t i = 0; i < matrix.width; ++i) {
        const NT& factor = matrix(k, i);
        if (is_known_zero(factor))
          continue;
        const NT* source = data.data() + (o * matrix.columns + first + i) * view.inner;
        for (std::size_t s = 0; s < view.inner; ++s)
          target[s] += factor * source[s];
      }
    }
  return result;
}

// weights[axis][r][k]: what entry k of the axis contributes to the derivative of order r along it.
template <class NT>
using Contraction_weights = std::vector<std::vector<std::vector<NT>>>;

/*
Contracts the axes of a tensor one after the other with every choice of derivative orders of total at most `order`, and
calls `report(orders, value)` for each. Contractions of the leading axes are shared between the choices; the first costs
one pass over the data.
*/
template <class NT, class Report>
void contract(const NT* data, std::size_t size, const Contraction_weights<NT>& weights, int order,
              std::vector<int>& orders, const Report& report)
{
  const std::size_t axis = orders.size();
  if (axis == weights.size()) {
    report(orders, *data);
    return;
  }
  const std::size_t extent = weights[axis][0].size();
  const std::size_t rest = size / extent;
  std::vector<NT> row(rest, NT(0));
  for (int r = 0; r <= order; ++r) {
    for (std::size_t s = 0; s < rest; ++s)
      row[s] = weights[axis][r][0] * data[s];
    for (std::size_t k = 1; k < extent; ++k)
      for (std::size_t s = 0; s < rest; ++s)
        row[s] += weights[axis][r][k] * data[k * rest + s];
    orders.push_back(r);
    contract(row.data(), rest, weights, order - r, orders, report);
    orders.pop_back();
  }
}

template <class NT>
Value_and_gradient<NT> contracted_gradient(const std::vector<NT>& data, const Contraction_weights<NT>& weights)
{
  Value_and_gradient<NT> result{NT(0), std::vector<NT>(weights.size(), NT(0))};
  std::vector<int> orders;
  contract(data.data(), data.size(), weights, 1, orders, [&](const std::vector<int>& derivative, const NT& value) {
    for (std::size_t j = 0; j < derivative.size(); ++j)
      if (derivative[j] == 1) {
        result.gradient[j] = value;
        return;
      }
    result.value = value;
  });
  return result;
}

// Axis by axis, in one row.
template <class NT>
NT contracted_value(const std::vector<NT>& data, const Contraction_weights<NT>& weights)
{
  std::vector<NT> row;
  std::size_t size = data.size();
  for (const std::vector<std::vector<NT>>& all_orders : weights) {
    const std::vector<NT>& factors = all_orders[0];
    const std::size_t rest = size / factors.size();
    const NT* source = row.empty() ? data.data() : row.data();
    if (row.empty())
      row.resize(rest, NT(0));
    for (std::size_t s = 0; s < rest; ++s) {
      NT sum = factors[0] * source[s];
      for (std::size_t k = 1; k < factors.size(); ++k)
        sum += factors[k] * source[k * rest + s];
      row[s] = std::move(sum);   // nothing reads it any more
    }
    size = rest;
  }
  return row.empty() ? data[0] : row[0];
}

// The symmetric matrix of second derivatives, row by row.
template <class NT>
std::vector<NT> contracted_hessian(const std::vector<NT>& data, const Contraction_weights<NT>& weights)
{
  const std::size_t n = weights.size();
  std::vector<NT> result(n * n, NT(0));
  std::vector<int> orders;
  contract(data.data(), data.size(), weights, 2, orders, [&](const std::vector<int>& derivative, const NT& value) {
    int total = 0;
    std::size_t first = n, last = 0;
    for (std::size_t j = 0; j < n; ++j)
      if (derivative[j] > 0) {
        total += derivative[j];
        first = first == n ? j : first;
        last = j;
      }
    if (total == 2)
      result[first * n + last] = result[last * n + first] = value;
  });
  return result;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void check_count(std::size_t count, std::size_t expected, std::string_view what)
{
  if (count != expected)
    throw Invalid_input(std::string(what) + ": " + std::to_string(count) + " where " + std::to_string(expected) +
                        " are needed");
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t tensor_size(const std::vector<int>& degrees)
{
  std::size_t size = 1;
  for (int d : degrees)
    size *= static_cast<std::size_t>(d) + 1;
  return size;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Axis_view axis_view(const std::vector<int>& degrees, std::size_t axis)
{
  Axis_view view{1, degrees[axis], 1};
  for (std::size_t j = 0; j < axis; ++j)
    view.outer *= static_cast<std::size_t>(degrees[j]) + 1;
  for (std::size_t j = axis + 1; j < degrees.size(); ++j)
    view.inner *= static_cast<std::size_t>(degrees[j]) + 1;
  return view;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> tensor_strides(const std::vector<int>& degrees)
{
  std::vector<std::size_t> strides(degrees.size(), 1);
  for (std::size_t j = degrees.size(); j-- > 1;)
    strides[j - 1] = strides[j] * (static_cast<std::size_t>(degrees[j]) + 1);
  return strides;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_TENSOR_AXES_H
