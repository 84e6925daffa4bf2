// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// OpenCASCADE: GeomAPI_IntCS, GeomAPI_IntSS with a tolerance of 1e-7, GeomAPI_ProjectPointOnCurve and
// GeomAPI_ProjectPointOnSurf, which know perpendiculars only, and GeomAPI_ExtremaCurveCurve with ends; with their
// default tolerances.
#include "operation_problems.h"

#include <GeomAPI_ExtremaCurveCurve.hxx>
#include <GeomAPI_IntCS.hxx>
#include <GeomAPI_IntSS.hxx>
#include <GeomAPI_ProjectPointOnCurve.hxx>
#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_BezierSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Precision.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <gp_Ax3.hxx>
#include <gp_Dir.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

namespace peers {
namespace {

gp_Pnt point_of(const Bezier_net& net, std::size_t i = 0)
{
  return {net.points[i][0], net.points[i][1], net.points[i][2]};
}

Handle(Geom_Curve) curve_of(const Bezier_net& net)
{
  TColgp_Array1OfPnt poles(1, net.degrees[0] + 1);
  for (int i = 1; i <= poles.Upper(); ++i)
    poles.SetValue(i, point_of(net, i - 1));
  return new Geom_BezierCurve(poles);
}

Handle(Geom_Surface) surface_of(const Bezier_net& net)
{
  TColgp_Array2OfPnt poles(1, net.degrees[0] + 1, 1, net.degrees[1] + 1);
  for (int i = 0; i <= net.degrees[0]; ++i)
    for (int j = 0; j <= net.degrees[1]; ++j)
      poles.SetValue(i + 1, j + 1, point_of(net, i * (net.degrees[1] + 1) + j));
  return new Geom_BezierSurface(poles);
}

Run intersected(const Handle(Geom_Curve)& curve, const Handle(Geom_Surface)& surface)
{
  const GeomAPI_IntCS intersection(curve, surface);
  return {.answer = {.points = intersection.NbPoints(),
                     .overlaps = intersection.NbSegments(),
                     .has_failed = !intersection.IsDone()},
          .phases = {}};
}

// Lines are splines already.
Run intersected(const Handle(Geom_Surface)& first, const Handle(Geom_Surface)& second)
{
  const GeomAPI_IntSS intersection(first, second, Precision::Confusion());
  return {
      .answer = {.points = intersection.IsDone() ? intersection.NbLines() : 0, .has_failed = !intersection.IsDone()},
      .phases = {}};
}

// None where there is no perpendicular.
template <class Projection>
Run projected(const Projection& projection)
{
  const bool has_failed = projection.NbPoints() == 0;
  return {.answer = {.has_failed = has_failed, .distance = has_failed ? 0 : projection.LowerDistance()}, .phases = {}};
}

} // namespace

Run operate_with_open_cascade(const Operation_problem& problem)
{
  const Bezier_net &first = problem.first, &second = problem.second;
  switch (problem.operation) {
  case Operation::CURVE_AND_SURFACE: return intersected(curve_of(first), surface_of(second));
  case Operation::LINE_AND_SPHERE:
    return intersected(new Geom_Line(point_of(first), gp_Dir(gp_Vec(point_of(first, 0), point_of(first, 1)))),
                       new Geom_SphericalSurface(gp_Ax3(point_of(second), gp_Dir(0, 0, 1)), problem.radius));
  case Operation::SURFACES: return intersected(surface_of(first), surface_of(second));
  case Operation::NEAREST_ON_CURVE: return projected(GeomAPI_ProjectPointOnCurve(point_of(first), curve_of(second)));
  case Operation::NEAREST_ON_SURFACE: return projected(GeomAPI_ProjectPointOnSurf(point_of(first), surface_of(second)));
  case Operation::NEAREST_OF_CURVES: break;
  }
  GeomAPI_ExtremaCurveCurve extrema(curve_of(first), curve_of(second));
  return {.answer = {.distance = extrema.TotalLowerDistance()}, .phases = {}};
}

} // namespace peers
