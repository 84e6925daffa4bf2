// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BERNSTEIN_NET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BERNSTEIN_NET_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Double_interval = CGAL::Interval_nt<false>;   // within an Upward_rounding_guard
template <int d>
using Double_intervals = std::array<Double_interval, d>;

inline Double_interval hull_of(const Double_interval& a, const Double_interval& b)
{
  return {(std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup())};
}

template <std::size_t d>
std::array<Double_interval, d> hull_of(std::array<Double_interval, d> a, const std::array<Double_interval, d>& b)
{
  for (std::size_t i = 0; i < d; ++i)
    a[i] = hull_of(a[i], b[i]);
  return a;
}

/*
A point, curve or surface on a box of parameters that has no breaks inside, by the Bernstein coefficients of the
numerators and of the weight, in intervals.

Derivatives are those by the place in the box, from 0 to 1 along each axis.
*/
template <int d>
class Bernstein_net
{
  using Point = Double_intervals<d>;

  std::array<std::size_t, 2> m_sizes{1, 1};   // the last axis is fastest
  std::vector<Point> m_points;                // numerators
  std::vector<Double_interval> m_weights;     // none: they are 1

public:
  //! \pre no breaks inside the domain
  explicit Bernstein_net(const Spline_patch<d>& patch)
  {
    for (int i = 0; i < d; ++i) {
      const Exact_function f = clamped(patch.numerators()[i], patch);
      m_points.resize(f.coefficients().size());
      for (std::size_t k = 0; k < m_points.size(); ++k)
        m_points[k][i] = to_double_interval(f.coefficients()[k]);
      for (int axis = 0; axis < f.dimension(); ++axis)
        m_sizes[axis] = f.size(axis);
    }
    if (patch.is_rational())
      for (const Exact_rational& w : clamped(patch.weight(), patch).coefficients())
        m_weights.emplace_back(to_double_interval(w));
  }

  // Whether the coefficients of the weight show that it is positive. Otherwise nothing is known of points and
  // derivatives.
  bool has_bounds() const
  {
    return std::all_of(m_weights.begin(), m_weights.end(), [](const Double_interval& w) { return w.inf() > 0; });
  }

  // The point with the least parameters. \pre `has_bounds()`
  Point corner() const { return point(0); }

  // Bounds of the points. \pre `has_bounds()`
  Point values() const
  {
    Point result = point(0);
    for (std::size_t k = 1; k < m_points.size(); ++k)
      result = hull_of(result, point(k));
    return result;
  }

  // Bounds of the derivative by an axis, where the points are within bounds. \pre `has_bounds()`
  Point derivatives(int axis, const Point& values) const
  {
    Point result;
    if (m_sizes[axis] == 1) {
      result.fill(0);
      return result;
    }
    for (int i = 0; i < d; ++i)
      result[i] = differences(axis, [&](std::size_t k) { return m_points[k][i]; });
    if (m_weights.empty())
      return result;
    Double_interval weight = m_weights[0];
    for (const Double_interval& w : m_weights)
      weight = hull_of(weight, w);
    const Double_interval slope = differences(axis, [&](std::size_t k) { return m_weights[k]; });
    for (int i = 0; i < d; ++i)
      result[i] = (result[i] - values[i] * slope) / weight;
    return result;
  }

  // The parts on both sides of the middle of an axis.
  std::array<Bernstein_net, 2> halves(int axis) const
  {
    std::array<Bernstein_net, 2> result{*this, *this};
    for_each_line(axis, [&](std::size_t first, std::size_t step) {
      halve(result[0].m_points, result[1].m_points, first, step, m_sizes[axis]);
      if (!m_weights.empty())
        halve(result[0].m_weights, result[1].m_weights, first, step, m_sizes[axis]);
    });
    return result;
  }

  // The part at an end (0 or 1) of an axis, which keeps its number.
  Bernstein_net face(int axis, int side) const
  {
    Bernstein_net result(*this);
    result.m_points.clear();
    result.m_weights.clear();
    for_each_line(axis, [&](std::size_t first, std::size_t step) {
      const std::size_t k = first + (side == 0 ? 0 : (m_sizes[axis] - 1) * step);
      result.m_points.push_back(m_points[k]);
      if (!m_weights.empty())
        result.m_weights.push_back(m_weights[k]);
    });
    result.m_sizes[axis] = 1;
    return result;
  }

private:
  // All functions have the same degrees.
  static Exact_function clamped(Exact_function f, const Spline_patch<d>& patch)
  {
    std::vector<int> degrees = patch.weight().degrees();
    for (const Exact_function& numerator : patch.numerators())
      for (std::size_t axis = 0; axis < degrees.size(); ++axis)
        degrees[axis] = (std::max)(degrees[axis], numerator.degree(static_cast<int>(axis)));
    for (int axis = 0; axis < f.dimension(); ++axis)
      f = f.restricted(axis, f.domain(axis).first, f.domain(axis).second);
    return f.degrees() == degrees ? f : f.elevated(degrees);
  }

  Point point(std::size_t k) const
  {
    Point result = m_points[k];
    if (!m_weights.empty())
      for (Double_interval& x : result)
        x = x / m_weights[k];
    return result;
  }

  // Calls visit(first, step) for each row of coefficients along an axis.
  template <class Visit>
  void for_each_line(int axis, const Visit& visit) const
  {
    const std::size_t step = axis == 0 ? m_sizes[1] : 1, other = axis == 0 ? 1 : m_sizes[1];
    for (std::size_t line = 0; line < m_sizes[1 - axis]; ++line)
      visit(line * other, step);
  }

  // The derivative of the coefficients along an axis.
  template <class Coefficient>
  Double_interval differences(int axis, const Coefficient& coefficient) const
  {
    std::optional<Double_interval> result;
    for_each_line(axis, [&](std::size_t first, std::size_t step) {
      for (std::size_t k = first, last = first + (m_sizes[axis] - 1) * step; k < last; k += step) {
        const Double_interval difference = coefficient(k + step) - coefficient(k);
        result = result ? hull_of(*result, difference) : difference;
      }
    });
    return static_cast<double>(m_sizes[axis] - 1) * *result;
  }

  static Double_interval mean(const Double_interval& a, const Double_interval& b) { return 0.5 * (a + b); }

  static Point mean(const Point& a, const Point& b)
  {
    Point result;
    for (int i = 0; i < d; ++i)
      result[i] = mean(a[i], b[i]);
    return result;
  }

  // By de Casteljau's algorithm: both are the whole row at first.
  template <class T>
  static void halve(std::vector<T>& lower, std::vector<T>& upper, std::size_t first, std::size_t step, std::size_t size)
  {
    for (std::size_t r = 1; r < size; ++r) {
      for (std::size_t k = 0; k + r < size; ++k)
        upper[first + k * step] = mean(upper[first + k * step], upper[first + (k + 1) * step]);
      lower[first + r * step] = upper[first];
    }
  }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_BERNSTEIN_NET_H
