// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_PRODUCT_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_PRODUCT_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>

#include <CGAL/Fraction_traits.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The product of Bernstein tensors. In scaled form, c_i = C(d,i) b_i on every axis, it is a plain convolution, as for
powers (Farouki and Rajan, Algorithms for polynomials in Bernstein form, 1988). Only axes on which both factors have a
positive degree need the scaling: C(d,i) C(0,0) / C(d,i) = 1 on the others, so that a product of functions of different
variables is an outer product, without any rounding but its own.
*/

// The three shapes of a convolution. The result's degrees are the sums.
struct Convolution_shape
{
  std::vector<int> first, second, result;
  std::vector<std::size_t> first_strides, second_strides, result_strides;

  Convolution_shape(std::vector<int> a, std::vector<int> b)
    : first(std::move(a)), second(std::move(b)), result(first)
  {
    for (std::size_t j = 0; j < result.size(); ++j)
      result[j] += second[j];
    first_strides = tensor_strides(first);
    second_strides = tensor_strides(second);
    result_strides = tensor_strides(result);
  }
};

// One row by one row, the second of a length known to the compiler.
template <std::size_t length, class NT>
inline void convolve_short_rows(const NT* a, std::size_t size, const NT* b, NT* c)
{
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < length; ++k)
      c[i + k] += a[i] * b[k];
}

template <class NT>
inline void convolve_rows(const NT* a, std::size_t a_size, const NT* b, std::size_t b_size, NT* c)
{
  switch (b_size) {
  case 1: return convolve_short_rows<1>(a, a_size, b, c);
  case 2: return convolve_short_rows<2>(a, a_size, b, c);
  case 3: return convolve_short_rows<3>(a, a_size, b, c);
  case 4: return convolve_short_rows<4>(a, a_size, b, c);
  case 5: return convolve_short_rows<5>(a, a_size, b, c);
  case 6: return convolve_short_rows<6>(a, a_size, b, c);
  case 7: return convolve_short_rows<7>(a, a_size, b, c);
  default:
    for (std::size_t i = 0; i < a_size; ++i)
      for (std::size_t k = 0; k < b_size; ++k)
        c[i + k] += a[i] * b[k];
  }
}

template <class NT>
void convolve(const Convolution_shape& shape, std::size_t axis, const NT* a, const NT* b, NT* c)
{
  const std::size_t a_size = static_cast<std::size_t>(shape.first[axis]) + 1;
  const std::size_t b_size = static_cast<std::size_t>(shape.second[axis]) + 1;
  if (axis + 1 == shape.result.size()) {
    // The longer row runs in the unrolled position's outer loop.
    if (a_size >= b_size)
      convolve_rows(a, a_size, b, b_size, c);
    else
      convolve_rows(b, b_size, a, a_size, c);
    return;
  }
  for (std::size_t i = 0; i < a_size; ++i)
    for (std::size_t k = 0; k < b_size; ++k)
      convolve(shape, axis + 1, a + i * shape.first_strides[axis], b + k * shape.second_strides[axis],
               c + (i + k) * shape.result_strides[axis]);
}

// The convolution of two non-empty tensors; dimension 0 is the product of two numbers.
template <class NT>
std::vector<NT> convolved(const Convolution_shape& shape, const std::vector<NT>& a, const std::vector<NT>& b)
{
  std::vector<NT> c(tensor_size(shape.result), NT(0));
  if (shape.result.empty())
    c[0] = a[0] * b[0];
  else
    convolve(shape, 0, a.data(), b.data(), c.data());
  return c;
}

// The product, axis by axis, of the binomials that scale each entry; axes that are not shared do not count.
template <class NT>
std::vector<NT> scaling_weights(const std::vector<int>& degrees, const std::vector<bool>& is_shared)
{
  std::vector<NT> weights(1, NT(1));
  for (std::size_t j = 0; j < degrees.size(); ++j) {
    const std::vector<NT> binomial = is_shared[j] ? binomials<NT>(degrees[j]) : std::vector<NT>(degrees[j] + 1, NT(1));
    std::vector<NT> next;
    next.reserve(weights.size() * binomial.size());
    for (const NT& weight : weights)
      for (const NT& factor : binomial)
        next.push_back(weight * factor);
    weights = std::move(next);
  }
  return weights;
}

template <class NT>
std::vector<NT> scaled(std::vector<NT> data, const std::vector<NT>& weights)
{
  for (std::size_t i = 0; i < data.size(); ++i)
    data[i] *= weights[i];
  return data;
}

// A tensor of fractions as integers over one common denominator.
template <class Integer>
struct Integer_tensor
{
  std::vector<Integer> numerators;
  Integer denominator = Integer(1);
};

// log2 of the largest absolute value, roughly; infinity beyond the range of doubles.
template <class Integer>
double bits_of(const std::vector<Integer>& numbers)
{
  double largest = 1;
  for (const Integer& x : numbers)
    largest = (std::max)(largest, std::fabs(CGAL::to_double(x)));
  return std::log2(largest) + 0.01;
}

// Clears denominators. False when the common denominator would dwarf the fractions themselves.
template <class NT, class Integer>
bool clear_denominators(const std::vector<NT>& data, Integer_tensor<Integer>& result)
{
  typename CGAL::Fraction_traits<NT>::Decompose decompose;
  std::vector<Integer> denominators(data.size());
  result.numerators.resize(data.size());
  double bits = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    decompose(data[i], result.numerators[i], denominators[i]);
    if (result.denominator == denominators[i])
      continue;
    const Integer common = CGAL::gcd(result.denominator, denominators[i]);
    if (common == denominators[i])
      continue;
    const Integer factor = CGAL::integral_division(denominators[i], common);
    bits += std::log2(CGAL::to_double(factor));
    if (bits > 900)
      return false;
    result.denominator *= factor;
  }
  if (bits > 64 + 4 * (std::max)(bits_of(result.numerators), bits_of(denominators)))
    return false;
  for (std::size_t i = 0; i < data.size(); ++i)
    if (denominators[i] != result.denominator) {
      const Integer factor = CGAL::integral_division(result.denominator, denominators[i]);
      result.numerators[i] *= factor;
    }
  return true;
}

// 2^exponent, by ring operations alone.
template <class Integer>
Integer power_of_two(int exponent)
{
  Integer result(1);
  for (; exponent >= 30; exponent -= 30)
    result *= Integer(1 << 30);
  result *= Integer(1 << exponent);
  return result;
}

// Writes every row of the last axis as one long integer: its value at `base`.
template <class Integer>
std::vector<Integer> packed_rows(const std::vector<Integer>& data, std::size_t extent, const Integer& base)
{
  std::vector<Integer> rows(data.size() / extent);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Integer value = data[(r + 1) * extent - 1];
    for (std::size_t k = extent - 1; k-- > 0;) {
      value *= base;
      value += data[r * extent + k];
    }
    rows[r] = value;
  }
  return rows;
}

// The inverse, for entries below base / 2 in absolute value: half a base added to each makes them digits.
template <class Integer>
std::vector<Integer> unpacked_rows(const std::vector<Integer>& rows, std::size_t extent, const Integer& base)
{
  const Integer half = CGAL::div(base, Integer(2));
  const Integer shift = packed_rows(std::vector<Integer>(extent, half), extent, base)[0];
  std::vector<Integer> data(rows.size() * extent);
  for (std::size_t r = 0; r < rows.size(); ++r) {
    Integer value = rows[r] + shift, quotient, digit;
    for (std::size_t k = 0; k < extent; ++k) {
      CGAL::div_mod(value, base, quotient, digit);
      data[r * extent + k] = digit - half;
      value = quotient;
    }
  }
  return data;
}

/*
Convolution of integers. When every sum fits into 53 bits it is done in double, where it is exact in any rounding mode.
Else the rows of the last axis are packed into one integer each (Kronecker substitution), so that a product of rows is
one multiplication of long integers.
*/
template <class Integer>
std::vector<Integer> convolved_integers(const Convolution_shape& shape, const std::vector<Integer>& a,
                                        const std::vector<Integer>& b)
{
  std::size_t summands = 1;
  for (std::size_t j = 0; j < shape.result.size(); ++j)
    summands *= static_cast<std::size_t>((std::min)(shape.first[j], shape.second[j])) + 1;
  const double bits = bits_of(a) + bits_of(b) + std::log2(static_cast<double>(summands));
  if (bits < 52) {
    const auto to_doubles = [](const std::vector<Integer>& from) {
      std::vector<double> to(from.size());
      std::transform(from.begin(), from.end(), to.begin(), [](const Integer& x) { return CGAL::to_double(x); });
      return to;
    };
    const std::vector<double> c = convolved(shape, to_doubles(a), to_doubles(b));
    return std::vector<Integer>(c.begin(), c.end());
  }
  if (shape.result.empty() || shape.first.back() == 0 || shape.second.back() == 0 || !(bits < 1000))
    return convolved(shape, a, b);

  const std::size_t a_extent = static_cast<std::size_t>(shape.first.back()) + 1;
  const std::size_t b_extent = static_cast<std::size_t>(shape.second.back()) + 1;
  const Integer base = power_of_two<Integer>(static_cast<int>(std::ceil(bits)) + 2);
  const Convolution_shape row_shape({shape.first.begin(), shape.first.end() - 1},
                                    {shape.second.begin(), shape.second.end() - 1});
  const std::vector<Integer> rows =
      convolved(row_shape, packed_rows(a, a_extent, base), packed_rows(b, b_extent, base));
  return unpacked_rows(rows, a_extent + b_extent - 1, base);
}

// The product of tensors of fractions, through integers. False when the denominators have too little in common for that
// to pay.
template <class NT>
bool multiply_fractions(const Convolution_shape& shape, const std::vector<bool>& is_shared, const std::vector<NT>& a,
                        const std::vector<NT>& b, std::vector<NT>& c)
{
  using Traits = CGAL::Fraction_traits<NT>;
  using Integer = typename Traits::Numerator_type;
  Integer_tensor<Integer> first, second;
  if (!clear_denominators(a, first) || !clear_denominators(b, second))
    return false;
  const std::vector<Integer> product =
    convolved_integers(shape, scaled(std::move(first.numerators), scaling_weights<Integer>(shape.first, is_shared)),
                       scaled(std::move(second.numerators), scaling_weights<Integer>(shape.second, is_shared)));
  const std::vector<Integer> weights = scaling_weights<Integer>(shape.result, is_shared);
  const Integer denominator = first.denominator * second.denominator;
  typename Traits::Compose compose;
  c.reserve(product.size());
  for (std::size_t i = 0; i < product.size(); ++i) {
    const Integer below = denominator * weights[i];
    c.push_back(compose(product[i], below));
  }
  return true;
}

template <class NT>
inline constexpr bool is_fraction_v = std::is_same_v<typename CGAL::Fraction_traits<NT>::Is_fraction, CGAL::Tag_true>;

// Coefficients of the product of two Bernstein tensors of the same dimension; its degrees are the sums.
template <class NT>
std::vector<NT> bernstein_product(const std::vector<int>& a_degrees, const std::vector<NT>& a,
                                  const std::vector<int>& b_degrees, const std::vector<NT>& b)
{
  std::vector<bool> is_shared(a_degrees.size());
  bool shares_an_axis = false;
  for (std::size_t j = 0; j < a_degrees.size(); ++j) {
    is_shared[j] = a_degrees[j] > 0 && b_degrees[j] > 0;
    shares_an_axis = shares_an_axis || is_shared[j];
  }
  const Convolution_shape shape(a_degrees, b_degrees);
  if (!shares_an_axis)
    return convolved(shape, a, b);
  if constexpr (is_fraction_v<NT>) {
    std::vector<NT> c;
    if (multiply_fractions(shape, is_shared, a, b, c))
      return c;
  }
  std::vector<NT> c = convolved(shape, scaled(a, scaling_weights<NT>(a_degrees, is_shared)),
                                scaled(b, scaling_weights<NT>(b_degrees, is_shared)));
  const std::vector<NT> weights = scaling_weights<NT>(shape.result, is_shared);
  for (std::size_t i = 0; i < c.size(); ++i)
    c[i] /= weights[i];
  return c;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_PRODUCT_H
