// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// SISL: s1857 on B-spline curves of one piece.
#include "curve_intersection.h"

#include <sisl.h>

#include <cstdlib>
#include <vector>

namespace peers {
namespace {

SISLCurve* sisl_curve(const Bezier_curve& curve)
{
  const int order = static_cast<int>(curve.size());
  std::vector<double> knots(2 * curve.size(), 0.0), coefficients;
  for (int i = order; i < 2 * order; ++i)
    knots[i] = 1;
  for (const Control_point& p : curve)
    coefficients.insert(coefficients.end(), {p.x, p.y});
  constexpr int polynomial_spline = 1, dimension = 2, copy = 1;
  return newCurve(order, order, knots.data(), coefficients.data(), polynomial_spline, dimension, copy);
}

} // namespace

Run intersect_with_sisl(const Bezier_curve& a, const Bezier_curve& b)
{
  // The first tolerance is not used by s1857; the second is the distance at which two points count as one.
  constexpr double unused_tolerance = 1e-6, tolerance = 1e-6;
  SISLCurve* const first = sisl_curve(a);
  SISLCurve* const second = sisl_curve(b);
  int points = 0, curves = 0, status = 0;
  double *first_parameters = nullptr, *second_parameters = nullptr;
  SISLIntcurve** overlaps = nullptr;
  s1857(first, second, unused_tolerance, tolerance, &points, &first_parameters, &second_parameters, &curves, &overlaps,
        &status);
  std::free(first_parameters);
  std::free(second_parameters);
  if (overlaps != nullptr)
    freeIntcrvlist(overlaps, curves);
  freeCurve(first);
  freeCurve(second);
  return {.answer = {.points = points, .overlaps = curves, .has_failed = status < 0}, .phases = {}};
}

} // namespace peers
