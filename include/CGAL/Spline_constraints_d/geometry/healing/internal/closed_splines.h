// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_CLOSED_SPLINES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_CLOSED_SPLINES_H

#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/exact_shapes.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

template <int d>
using Exact_coordinates = std::array<Exact_rational, d>;

template <int d>
Exact_rational squared_distance_of(const Exact_coordinates<d>& a, const Exact_coordinates<d>& b)
{
  Exact_rational result = 0;
  for (int i = 0; i < d; ++i) {
    const Exact_rational x = a[i] - b[i];
    result += x * x;
  }
  return result;
}

// Points no two of which are nearer than a distance: one that is nearer to a known one is that one.
template <int d>
class Known_points
{
  using Cell = std::array<double, d>;

  double m_distance;
  Exact_rational m_squared_distance;
  std::map<Cell, std::vector<Exact_coordinates<d>>> m_points;

public:
  explicit Known_points(double distance)
    : m_distance(distance), m_squared_distance(to_rational(distance) * to_rational(distance))
  {}

  double distance() const { return m_distance; }

  // The known point near a point; it is known from now on, if there is none.
  Exact_coordinates<d> at(const Exact_coordinates<d>& p)
  {
    const Cell cell = cell_of(p);
    std::array<int, d> offset;
    offset.fill(-1);
    do {
      Cell next = cell;
      for (int i = 0; i < d; ++i)
        next[i] += offset[i];
      if (const auto known = m_points.find(next); known != m_points.end())
        for (const Exact_coordinates<d>& q : known->second)
          if (squared_distance_of<d>(p, q) <= m_squared_distance)
            return q;
    } while (is_advanced(offset));
    m_points[cell].push_back(p);
    return p;
  }

private:
  // Cells are wider than the distance, so that rounding leads to none but the next ones.
  Cell cell_of(const Exact_coordinates<d>& p) const
  {
    Cell result;
    for (int i = 0; i < d; ++i)
      result[i] = std::floor(to_nearest_double(p[i]) / (2 * m_distance));
    return result;
  }

  static bool is_advanced(std::array<int, d>& offset)
  {
    for (int& x : offset) {
      if (++x <= 1)
        return true;
      x = -1;
    }
    return false;
  }
};

/*
A spline of any shape: control points near points with simple coordinates in a frame become these; then sides of which
all control points are near the first one become points, opposite sides that are near each other become the same one,
with the same weights up to a factor, and control points near known ones become these. On clamped knots, where sides
are control points.
*/
template <int d>
class Closed_spline
{
  using Spline = Homogeneous_spline<Exact_rational, d>;

  double m_distance, m_relative;
  std::vector<Exact_coordinates<d>> m_points;
  std::vector<Exact_rational> m_weights;

public:
  Spline spline;
  bool is_changed;

  // Weights are changed by a relative amount.
  Closed_spline(const Spline& given, double relative, const Known_frames& frames, const Rational_frame& frame,
                Known_points<d>& known)
    : m_distance(known.distance()), m_relative(relative), spline(given), is_changed(false)
  {
    for (std::size_t k = 0; k < given.numerator(0).coefficients().size(); ++k) {
      m_points.push_back(given.control_point(k));
      m_weights.push_back(given.control_weight(k));
    }
    const auto points = m_points;
    const auto weights = m_weights;
    for (auto& p : m_points)
      if (const auto simple = frames.simple_point(frame, rounded_point<d>(p)))
        for (int i = 0; i < d; ++i)
          p[i] = simple->cartesian(i);
    for (int axis = 0; axis < given.dimension(); ++axis)
      close_axis(axis);
    for (auto& p : m_points)
      p = known.at(p);
    is_changed = points != m_points || weights != m_weights;
    if (is_changed)
      spline = rebuilt();
  }

private:
  bool are_near(const Exact_coordinates<d>& a, const Exact_coordinates<d>& b) const
  {
    return squared_distance_of<d>(a, b) <= Exact_rational(to_rational(m_distance) * to_rational(m_distance));
  }

  // The control points of a side, in the order of the other axis.
  std::vector<std::size_t> side(int axis, int which) const
  {
    const Exact_function& f = spline.numerator(0);
    const std::size_t last = which == 0 ? 0 : f.size(axis) - 1;
    if (f.dimension() == 1)
      return {last};
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < f.size(1 - axis); ++i)
      result.push_back(axis == 0 ? last * f.size(1) + i : i * f.size(1) + last);
    return result;
  }

  void close_axis(int axis)
  {
    const std::vector<std::size_t> first = side(axis, 0), last = side(axis, 1);
    for (const auto* ends : {&first, &last})
      if (ends->size() > 1) {
        bool is_pole = true;
        for (const std::size_t k : *ends)
          is_pole = is_pole && are_near(m_points[k], m_points[ends->front()]);
        for (const std::size_t k : *ends)
          if (is_pole)
            m_points[k] = Exact_coordinates<d>(m_points[ends->front()]);
      }
    bool is_seam = true;
    Exact_rational factor = m_weights[last.front()] / m_weights[first.front()];
    if (CGAL::abs(Exact_rational(factor - 1)) <= to_rational(m_relative))
      factor = 1;
    for (std::size_t i = 0; i < first.size(); ++i) {
      const Exact_rational ratio = m_weights[last[i]] / Exact_rational(factor * m_weights[first[i]]);
      is_seam = is_seam && are_near(m_points[first[i]], m_points[last[i]]) &&
          CGAL::abs(Exact_rational(ratio - 1)) <= to_rational(m_relative);
    }
    if (!is_seam)
      return;
    for (std::size_t i = 0; i < first.size(); ++i) {
      m_points[last[i]] = m_points[first[i]];
      m_weights[last[i]] = factor * m_weights[first[i]];
    }
  }

  Spline rebuilt() const
  {
    std::vector<Exact_function> functions;
    for (int i = 0; i <= (spline.is_rational() ? d : d - 1); ++i) {
      std::vector<Exact_rational> coefficients;
      for (std::size_t k = 0; k < m_points.size(); ++k)
        coefficients.push_back(i == d ? m_weights[k] : Exact_rational(m_points[k][i] * m_weights[k]));
      functions.push_back(with_coefficients(spline.numerator(0), std::move(coefficients)));
    }
    return Spline(std::move(functions), "with_exact_primitives");
  }
};

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_CLOSED_SPLINES_H
