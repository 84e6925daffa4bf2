// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_KNOT_VECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_KNOT_VECTOR_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_blossom.h>
#include <CGAL/Spline_constraints_d/function/internal/Shared_vector.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Knots t_0 <= ... <= t_{n+d} of n control points of degree d; the domain is [t_d, t_n]. Everything here is the blossom of
the polynomial on a non-empty span (de Boor's recurrence with one argument per level): equal arguments evaluate, the
ends of a span extract Bézier points, d consecutive knots of a finer vector insert them.
*/
template <class NT>
struct Knot_axis
{
  int degree;
  Shared_vector<NT> knots;

  std::size_t size() const { return knots.size() - degree - 1; }
  const NT& begin() const { return knots[degree]; }
  const NT& end() const { return knots[size()]; }

  // Whether the first and last control points are those of the ends of the domain.
  bool is_clamped() const { return knots.front() == begin() && knots.back() == end(); }

  friend bool operator==(const Knot_axis&, const Knot_axis&) = default;
};

// A value that occurs among the knots inside the domain, and how often.
template <class NT>
struct Break
{
  NT value;
  int multiplicity;
};

// Throws unless the knots are a valid vector for the degree, of a spline that is continuous on a non-empty domain.
template <class NT>
void check_knots(const Knot_axis<NT>& axis, const std::string& where)
{
  const std::vector<NT>& knots = *axis.knots;
  const std::size_t order = static_cast<std::size_t>(axis.degree) + 1;
  if (knots.size() < 2 * order)
    throw Invalid_input(where + ": " + std::to_string(knots.size()) + " knots, at least " + std::to_string(2 * order) +
                        " are needed");
  check_finite(knots, where + ": knot");
  for (std::size_t i = 1; i < knots.size(); ++i)
    if (knots[i] < knots[i - 1])
      throw Invalid_input(where + ": knot " + std::to_string(i) + " is smaller than the one before");
  if (!(axis.begin() < axis.end()))
    throw Invalid_input(where + ": the domain is empty");
  for (std::size_t i = 0; i < knots.size();) {
    std::size_t last = i + 1;
    while (last < knots.size() && knots[last] == knots[i])
      ++last;
    const bool is_inside = axis.begin() < knots[i] && knots[i] < axis.end();
    if (last - i > order || (is_inside && last - i == order))
      throw Invalid_input(where + ": knot " + std::to_string(i) + " occurs " + std::to_string(last - i) +
                          " times, the spline of degree " + std::to_string(axis.degree) + " is not continuous there");
    i = last;
  }
}

// The distinct knots from end to end of the domain. The multiplicity at the two ends has no meaning here.
template <class NT>
std::vector<Break<NT>> breaks_of(const Knot_axis<NT>& axis)
{
  std::vector<Break<NT>> result{{axis.begin(), 1}};
  for (const NT& knot : axis.knots)
    if (axis.begin() < knot && !(axis.end() < knot)) {
      if (result.back().value == knot)
        ++result.back().multiplicity;
      else
        result.push_back({knot, 1});
    }
  return result;
}

// The clamped knot vector on breaks.
template <class NT>
Knot_axis<NT> clamped(int degree, const std::vector<Break<NT>>& breaks)
{
  std::vector<NT> knots;
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == breaks.size();
    knots.insert(knots.end(), is_end ? degree + 1 : breaks[i].multiplicity, breaks[i].value);
  }
  return {degree, std::move(knots)};
}

// Breaks of a sum or product of the given degree: at each the smoothness of the less smooth operand.
template <class NT>
std::vector<Break<NT>> common_breaks(int degree, const Knot_axis<NT>& a, const Knot_axis<NT>& b)
{
  std::vector<Break<NT>> result = breaks_of(a);
  for (Break<NT>& entry : result)
    entry.multiplicity += degree - a.degree;
  for (Break<NT> entry : breaks_of(b)) {
    entry.multiplicity += degree - b.degree;
    const auto position = std::lower_bound(result.begin(), result.end(), entry.value,
                                           [](const Break<NT>& x, const NT& value) { return x.value < value; });
    if (position != result.end() && position->value == entry.value)
      position->multiplicity = (std::max)(position->multiplicity, entry.multiplicity);
    else
      result.insert(position, entry);
  }
  return result;
}

// The last non-empty span [t_q, t_{q+1}] of the domain that begins at or before a parameter.
template <class NT>
std::size_t span_of(const Knot_axis<NT>& axis, const NT& u)
{
  const auto first = axis.knots.begin() + axis.degree, last = axis.knots.begin() + axis.size();
  // At the right end the span before it; left of the domain the first one.
  const NT& inside = u < axis.end() ? (u < axis.begin() ? axis.begin() : u) : axis.end();
  const auto after =
      inside < axis.end() ? std::upper_bound(first, last, inside) : std::lower_bound(first, last, inside);
  return static_cast<std::size_t>(after - axis.knots.begin()) - 1;
}

// The control points that the function depends on between two parameters: the first, and how many.
template <class NT>
std::pair<std::size_t, std::size_t> points_between(const Knot_axis<NT>& axis, const NT& begin, const NT& end)
{
  const auto degree = static_cast<std::size_t>(axis.degree), first = span_of(axis, begin) - degree;
  const auto after = std::lower_bound(axis.knots.begin() + static_cast<std::ptrdiff_t>(first + degree + 1),
                                      axis.knots.end(), end);
  return {first, static_cast<std::size_t>(after - axis.knots.begin()) - first};   // the last span ends there
}

// The axis of some of the control points.
template <class NT>
Knot_axis<NT> part_of_axis(const Knot_axis<NT>& axis, std::size_t first_point, std::size_t count)
{
  const auto first = axis.knots.begin() + static_cast<std::ptrdiff_t>(first_point);
  return {axis.degree, std::vector<NT>(first, first + static_cast<std::ptrdiff_t>(count + axis.degree + 1))};
}

// Weights of the control points span - d, ..., span in the blossom of the polynomial on a non-empty span, with one
// argument more at a time: after d of them they are complete.
template <class NT>
class Blossom_weights
{
  const Knot_axis<NT>* m_axis;
  std::size_t m_span;
  std::vector<NT> m_weights{NT(1)};

public:
  Blossom_weights(const Knot_axis<NT>& axis, std::size_t span) : m_axis(&axis), m_span(span) {}

  void add(const Blossom_argument<NT>& x)
  {
    const std::size_t level = m_weights.size();
    m_weights.push_back(NT(0));
    NT carried(0);
    for (std::size_t r = 0; r < level; ++r) {
      if (is_known_zero(m_weights[r])) {   // as many are where arguments are knots
        m_weights[r] = std::exchange(carried, NT(0));
        continue;
      }
      const NT& right = m_axis->knots[m_span + r + 1];
      const NT& left = m_axis->knots[m_span + r + 1 - level];
      const NT quotient = m_weights[r] / NT(right - left);
      m_weights[r] = carried + NT(NT(x.weight * right) - x.value) * quotient;
      carried = NT(x.value - NT(x.weight * left)) * quotient;
    }
    m_weights[level] = carried;
  }

  const std::vector<NT>& weights() const { return m_weights; }
};

// Exact numbers have kernels of their own, on integers.
template <class NT>
inline constexpr bool is_exact_rational = std::is_same_v<NT, Exact_rational>;

template <class NT>
using Blossom = std::conditional_t<is_exact_rational<NT>, Integer_blossom, Blossom_weights<NT>>;

template <class NT>
using Band_matrix = std::conditional_t<is_exact_rational<NT>, Integer_band, Row_matrix<NT>>;

// To be filled row by row, with as many weights as the order of an axis.
template <class NT>
Band_matrix<NT> band_matrix(const Knot_axis<NT>& axis)
{
  return Band_matrix<NT>::band(axis.size(), static_cast<std::size_t>(axis.degree) + 1);
}

// The weights for all arguments at once, `argument(i)` for i < d.
template <class NT, class Argument>
auto blossom_weights(const Knot_axis<NT>& axis, std::size_t span, const Argument& argument)
{
  Blossom<NT> result(axis, span);
  for (int i = 0; i < axis.degree; ++i)
    result.add(argument(i));
  return result.weights();
}

// The derivative of some order at a parameter, as weights of the control points of a span.
template <class NT>
auto derivative_weights(const Knot_axis<NT>& axis, std::size_t span, const NT& u, int order)
{
  auto result = blossom_weights(axis, span, [&](int i) {
    return i < order ? Blossom_argument<NT>{NT(1), NT(0)} : Blossom_argument<NT>{u, NT(1)};
  });
  const auto multiply = [&](auto& weights, int degree) {
    for (auto& weight : weights)
      weight *= std::decay_t<decltype(weight)>(degree);
  };
  for (int r = 0; r < order; ++r)
    if constexpr (is_exact_rational<NT>)
      multiply(result.numerators, (std::max)(axis.degree - r, 0));
    else
      multiply(result, (std::max)(axis.degree - r, 0));
  return result;
}

// Bézier points of all cells of breaks that are at least as fine as the knots, cell after cell, from the control
// points.
template <class NT>
Band_matrix<NT> extraction_matrix(const Knot_axis<NT>& axis, const std::vector<Break<NT>>& breaks)
{
  Band_matrix<NT> result = band_matrix(axis);
  for (std::size_t c = 0; c + 1 < breaks.size(); ++c) {
    const std::size_t span = span_of(axis, breaks[c].value);
    std::vector<Blossom<NT>> at_begin(1, Blossom<NT>(axis, span));   // with as many arguments as their index says
    for (int i = 0; i < axis.degree; ++i)
      at_begin.emplace_back(at_begin.back()).add({breaks[c].value});
    for (int k = 0; k <= axis.degree; ++k) {
      Blossom<NT>& row = at_begin[axis.degree - k];
      for (int i = 0; i < k; ++i)
        row.add({breaks[c + 1].value});
      result.add_row(span - axis.degree, row.weights());
    }
  }
  return result;
}

// The span of the domain to compute control point j on: non-empty, and near the middle of the control point's support.
template <class NT>
std::size_t central_span(const Knot_axis<NT>& axis, std::size_t j)
{
  const std::size_t middle =
      (std::min)((std::max)(j + axis.degree / 2, static_cast<std::size_t>(axis.degree)), axis.size() - 1);
  for (std::size_t distance = 0;; ++distance) {
    if (middle + distance < axis.size() && axis.knots[middle + distance] < axis.knots[middle + distance + 1])
      return middle + distance;
    if (middle >= axis.degree + distance && axis.knots[middle - distance] < axis.knots[middle - distance + 1])
      return middle - distance;
  }
}

// Control points on finer knots, or on a part of the domain, from those on `from`.
template <class NT>
Band_matrix<NT> refinement_matrix(const Knot_axis<NT>& from, const Knot_axis<NT>& to)
{
  Band_matrix<NT> result = band_matrix(from);
  for (std::size_t j = 0; j < to.size(); ++j) {
    const std::size_t span = span_of(from, to.knots[central_span(to, j)]);
    result.add_row(span - from.degree, blossom_weights(from, span, [&](int i) {
                     return Blossom_argument<NT>{to.knots[j + 1 + i], NT(1)};
                   }));
  }
  return result;
}

// Control points on clamped knots from the Bézier points of the cells between the breaks: the inverse of extraction.
template <class NT>
Band_matrix<NT> assembly_matrix(const Knot_axis<NT>& axis, const std::vector<Break<NT>>& breaks)
{
  const std::size_t order = static_cast<std::size_t>(axis.degree) + 1;
  auto result = Band_matrix<NT>::band(order * (breaks.size() - 1), order);
  for (std::size_t j = 0; j < axis.size(); ++j) {
    const NT& begin = axis.knots[central_span(axis, j)];
    const auto position = std::lower_bound(breaks.begin(), breaks.end(), begin,
                                           [](const Break<NT>& x, const NT& value) { return x.value < value; });
    const std::size_t cell = static_cast<std::size_t>(position - breaks.begin());
    const NT length = breaks[cell + 1].value - begin;
    std::vector<NT> row(order, NT(0));
    row[0] = NT(1);
    for (int i = 0; i < axis.degree; ++i) {
      // Both from their own difference, so that 0 and 1 come out as such.
      const NT u = NT(axis.knots[j + 1 + i] - begin) / length;
      const NT v = NT(breaks[cell + 1].value - axis.knots[j + 1 + i]) / length;
      multiply_by_linear(row.data(), i, v, u);
    }
    result.add_row(cell * order, row);
  }
  return result;
}

// Control points of the derivative: differences over the knots they span. Points without influence on the domain get 0.
template <class NT>
Band_matrix<NT> derivative_matrix(const Knot_axis<NT>& axis)
{
  auto result = Band_matrix<NT>::band(axis.size(), 2);
  for (std::size_t i = 0; i + 1 < axis.size(); ++i) {
    const NT length = axis.knots[i + axis.degree + 1] - axis.knots[i + 1];
    const NT slope = length == NT(0) ? NT(0) : NT(NT(axis.degree) / length);
    result.add_row(i, std::vector<NT>{NT(-slope), slope});
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_KNOT_VECTOR_H
