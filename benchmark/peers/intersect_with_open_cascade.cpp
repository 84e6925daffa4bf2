// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// OpenCASCADE: Geom2dAPI_InterCurveCurve with its default tolerance.
#include "curve_intersection.h"

#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <TColgp_Array1OfPnt2d.hxx>
#include <gp_Pnt2d.hxx>

namespace peers {
namespace {

Handle(Geom2d_Curve) open_cascade_curve(const Bezier_curve& curve)
{
  TColgp_Array1OfPnt2d poles(1, static_cast<int>(curve.size()));
  for (int i = 1; i <= poles.Upper(); ++i)
    poles.SetValue(i, gp_Pnt2d(curve[i - 1].x, curve[i - 1].y));
  return new Geom2d_BezierCurve(poles);
}

} // namespace

Run intersect_with_open_cascade(const Bezier_curve& a, const Bezier_curve& b)
{
  const Geom2dAPI_InterCurveCurve intersection(open_cascade_curve(a), open_cascade_curve(b));
  return {.answer = {.points = intersection.NbPoints(), .overlaps = intersection.NbSegments()}, .phases = {}};
}

} // namespace peers
