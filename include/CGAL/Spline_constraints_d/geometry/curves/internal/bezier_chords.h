// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_BEZIER_CHORDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_BEZIER_CHORDS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A Bézier curve in homogeneous coordinates x, y, weight, rounded to doubles.
using Rounded_bezier = std::vector<std::array<double, 3>>;

double distance_from_segment(double px, double py, double qx, double qy);

// The curve is in the hull of its control points where weights are positive.
bool is_near_its_chord(const Rounded_bezier& curve, double error);

// Appends points of the curve but the first, such that chords between them have the error at most, or after 2^16 parts.
void append_chords(std::vector<std::array<double, 2>>& points, Rounded_bezier curve, double error, int depth = 0);

template <SplineKernel Kernel>
Rounded_bezier rounded_bezier(const Bspline_curve_2<Kernel>& piece)
{
  const auto& map = piece.representation();
  Rounded_bezier result;
  for (std::size_t k = 0; k < piece.size(); ++k)
    result.push_back({converted_number<double>(map.numerator(0).coefficients()[k]),
                      converted_number<double>(map.numerator(1).coefficients()[k]),
                      converted_number<double>(map.control_weight(k))});
  return result;
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE double distance_from_segment(double px, double py, double qx, double qy)
{
  const double square = qx * qx + qy * qy;
  const double s = square > 0 ? (std::max)(0., (std::min)(1., (px * qx + py * qy) / square)) : 0;
  return std::hypot(px - s * qx, py - s * qy);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool is_near_its_chord(const Rounded_bezier& curve, double error)
{
  const auto& a = curve.front();
  const auto& b = curve.back();
  return std::all_of(curve.begin(), curve.end(), [&](const auto& p) {
    return p[2] > 0 &&
        distance_from_segment(p[0] / p[2] - a[0] / a[2], p[1] / p[2] - a[1] / a[2], b[0] / b[2] - a[0] / a[2],
                              b[1] / b[2] - a[1] / a[2]) <= error;
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE void append_chords(std::vector<std::array<double, 2>>& points, Rounded_bezier curve,
                                                  double error, int depth)
{
  if (depth == 16 || is_near_its_chord(curve, error)) {
    const auto& p = curve.back();
    points.push_back({p[0] / p[2], p[1] / p[2]});
    return;
  }
  Rounded_bezier left{curve.front()};
  for (std::size_t last = curve.size() - 1; last > 0; --last) {
    for (std::size_t i = 0; i < last; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        curve[i][j] = (curve[i][j] + curve[i + 1][j]) / 2;
    left.push_back(curve.front());
  }
  append_chords(points, left, error, depth + 1);
  append_chords(points, curve, error, depth + 1);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_BEZIER_CHORDS_H
