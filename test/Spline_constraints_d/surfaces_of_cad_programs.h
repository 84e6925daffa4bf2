// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact surfaces as programs for CAD write them: in doubles, circles with the weights 1, cos, 1, rotated and moved by
// what is no rational number.

#ifndef TEST_SURFACES_OF_CAD_PROGRAMS_H
#define TEST_SURFACES_OF_CAD_PROGRAMS_H

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace surfaces_of_cad_programs {

using Rounded = CGAL::Simple_cartesian<double>;
using Rounded_surface = SC::Bspline_surface_3<Rounded>;

struct Motion
{
  std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<double, 3> translation{0, 0, 0};

  // About an axis that is not of length one.
  static Motion turned(const std::array<double, 3>& axis, double angle, const std::array<double, 3>& translation)
  {
    const double length = std::hypot(axis[0], axis[1], axis[2]), c = std::cos(angle), s = std::sin(angle);
    const std::array<double, 3> n{axis[0] / length, axis[1] / length, axis[2] / length};
    Motion result;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      result.rotation[i][i] = n[i] * n[i] * (1 - c) + c;
      result.rotation[i][j] = n[i] * n[j] * (1 - c) - s * n[k];
      result.rotation[j][i] = n[i] * n[j] * (1 - c) + s * n[k];
    }
    result.translation = translation;
    return result;
  }

  Rounded::Point_3 operator()(const Rounded::Point_3& p) const
  {
    std::array<double, 3> x = translation;
    for (std::size_t i = 0; i < 3; ++i)
      x[i] += rotation[i][0] * p.x() + rotation[i][1] * p.y() + rotation[i][2] * p.z();
    return {x[0], x[1], x[2]};
  }
};

// The weights along an axis of a surface whose weights are products of such: one at the ends of quadratic pieces, where
// they can be.
inline std::vector<double> standard_weights(const Surface& surface, int axis)
{
  const std::vector<Rational> weights = surface.control_weights();
  const std::size_t step = axis == 0 ? surface.size(1) : 1;
  std::vector<double> result;
  for (std::size_t i = 0; i < surface.size(axis); ++i)
    result.push_back(CGAL::to_double(Rational(weights[i * step] / weights[0])));
  if (surface.degree(axis) == 2) {
    for (std::size_t i = 1; i + 1 < result.size(); i += 2)
      result[i] /= std::sqrt(result[i - 1] * result[i + 1]);
    for (std::size_t i = 0; i < result.size(); i += 2)
      result[i] = 1;
  }
  return result;
}

inline Rounded_surface written(const Surface& surface, const Motion& motion = {})
{
  const auto doubles = [](const std::vector<Rational>& numbers) {
    std::vector<double> result;
    for (const Rational& x : numbers)
      result.push_back(CGAL::to_double(x));
    return result;
  };
  const std::vector<double> along_0 = standard_weights(surface, 0), along_1 = standard_weights(surface, 1);
  std::vector<Rounded::Point_3> points;
  std::vector<double> weights;
  for (const Point& p : surface.control_points())
    points.push_back(motion({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())}));
  for (const double a : along_0)
    for (const double b : along_1)
      weights.push_back(a * b);
  return Rounded_surface({surface.degree(0), surface.degree(1)}, doubles(surface.knots(0)), doubles(surface.knots(1)),
                         points, weights);
}

} // namespace surfaces_of_cad_programs

#endif // TEST_SURFACES_OF_CAD_PROGRAMS_H
