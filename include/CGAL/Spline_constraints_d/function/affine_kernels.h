// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_AFFINE_KERNELS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_AFFINE_KERNELS_H

#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The linear part of a small tensor and what it leaves. One of the interleaved functions, or two neighbouring ones, walk
over all control points from `data` on with everything else in registers: without tables, and with hardly anything that
is done once. `Number` is a double or a Pack.
*/
struct Tensor_shape
{
  const int* degrees;            // per axis
  // numbers that an axis and the faster ones span; one more entry for the functions alone
  const std::size_t* lengths;
};

// slopes[j] <- scales[j] times the sum of the last layer along axis j less that of the first.
template <int axes, class Number>
inline void sum_slopes(const Tensor_shape& shape, const double* data, const double* scales, Number (&slopes)[axes])
{
  const std::size_t size = shape.lengths[0], step = shape.lengths[axes];
  unroll<axes>([&](auto j) {
    const std::size_t line = shape.lengths[j], inner = shape.lengths[j + 1];
    Number sum(0);
    for (std::size_t begin = 0; begin < size; begin += line)
      for (std::size_t i = begin; i < begin + inner; i += step)
        sum = sum + (load(Number(), data + i + (line - inner)) - load(Number(), data + i));
    slopes[j] = sum * scales[j];
  });
}

// What slope times abscissa leaves of the numbers along the last axis, `step` places apart: the least and the largest.
// `degree` is that of the axis if it is known to the compiler, else 0.
template <int degree, class Number>
class Last_axis
{
  Number m_offsets[degree + 1];   // slope times abscissa
  Number m_slope;
  const double* m_abscissas;
  int m_degree;
  std::size_t m_step;

public:
  Last_axis(const Number& slope, const double* abscissas, int given_degree, std::size_t step)
    : m_slope(slope), m_abscissas(abscissas), m_degree(given_degree), m_step(step)
  {
    unroll<degree + 1>([&](auto k) { m_offsets[k] = slope * abscissas[k]; });
  }

  std::pair<Number, Number> bounds(const double* data) const
  {
    Number least = load(Number(), data) - m_offsets[0], most = least;
    const auto add = [&](const Number& rest) {
      least = lesser(least, rest);
      most = greater(most, rest);
    };
    if constexpr (degree > 0)
      unroll<degree>([&](auto k) { add(load(Number(), data + (k + 1) * m_step) - m_offsets[k + 1]); });
    else
      for (int k = 1; k <= m_degree; ++k)
        add(load(Number(), data + k * m_step) - m_slope * m_abscissas[k]);
    return {least, most};
  }
};

// The least and the largest of the numbers less `base` and, for the axes from `axis` on, slope times abscissa, as far
// as they are less or larger than given ones. The abscissas of the axes follow each other.
template <int axes, int axis = 0, class Line, class Number>
inline void bound_rest(const Tensor_shape& shape, const double* data, const double* abscissas,
                       const Number (&slopes)[axes], const Line& last, const Number& base, Number& least, Number& most)
{
  if constexpr (axis + 1 == axes) {
    const auto [lower, upper] = last.bounds(data);
    least = lesser(least, lower - base);
    most = greater(most, upper - base);
  } else {
    const int degree = shape.degrees[axis];
    const std::size_t inner = shape.lengths[axis + 1];
    for (int k = 0; k <= degree; ++k, data += inner)
      bound_rest<axes, axis + 1>(shape, data, abscissas + degree + 1, slopes, last, base + slopes[axis] * abscissas[k],
                                 least, most);
  }
}

// The same along a single axis, with the bounds of the numbers themselves, in one pass over `count` numbers every
// `step` places. The slope is that from the first to the last.
template <class Number>
struct Line_bounds
{
  Number least, most, slope, rest_least, rest_most;

  Line_bounds(const double* data, std::size_t count, std::size_t step, const double* abscissas)
    : least(load(Number(), data)), most(least), slope(load(Number(), data + (count - 1) * step) - least),
      rest_least(count > 1 ? least - slope * abscissas[0] : least), rest_most(rest_least)
  {
    for (std::size_t k = 1; k < count; ++k) {
      const Number value = load(Number(), data + k * step), rest = value - slope * abscissas[k];
      least = lesser(least, value);
      most = greater(most, value);
      rest_least = lesser(rest_least, rest);
      rest_most = greater(rest_most, rest);
    }
  }

  // Makes the bounds wider by the error of the numbers and, for what was rounded here, by a share of what was added.
  void widen(const Number& error_of_numbers, double share)
  {
    const Number size = greater(magnitude(least), magnitude(most)), error = error_of_numbers + size * share,
                 rest_error = error_of_numbers + (size + magnitude(slope)) * share;
    least = least - error;
    most = most + error;
    rest_least = rest_least - rest_error;
    rest_most = rest_most + rest_error;
  }
};

// The least and the largest difference of neighbours among `count` numbers every `step` places; at least two of them.
template <class Number>
inline std::pair<Number, Number> bound_differences(const double* data, std::size_t count, std::size_t step)
{
  Number previous = load(Number(), data + step), least = previous - load(Number(), data), most = least;
  for (std::size_t k = 2; k < count; ++k) {
    const Number value = load(Number(), data + k * step), difference = value - previous;
    least = lesser(least, difference);
    most = greater(most, difference);
    previous = value;
  }
  return {least, most};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_AFFINE_KERNELS_H
