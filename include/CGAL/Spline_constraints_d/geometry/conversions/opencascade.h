// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_OPENCASCADE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_OPENCASCADE_H

#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <Geom2d_BSplineCurve.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>

#include <array>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Knots with their multiplicities as one sequence. Of a periodic one with n control points the last n + 1 knots, which
// are one period of it.
template <class FT>
std::vector<FT> knot_sequence(const TColStd_Array1OfReal& knots, const TColStd_Array1OfInteger& multiplicities,
                              bool is_periodic)
{
  std::vector<FT> result;
  for (int i = knots.Lower(); i <= knots.Upper(); ++i)
    result.insert(result.end(), static_cast<std::size_t>(multiplicities(i)), converted_number<FT>(knots(i)));
  if (is_periodic)
    result.erase(result.begin(), result.begin() + (multiplicities(multiplicities.Lower()) - 1));
  return result;
}

template <class Kernel, class Curve>
auto curve_from_opencascade(const Curve& curve)
{
  constexpr int d = std::is_same_v<Curve, Geom2d_BSplineCurve> ? 2 : 3;
  using Spline = Bspline_curve<Kernel, d>;
  std::vector<typename Spline::Point> points;
  std::vector<typename Kernel::FT> weights;
  for (int i = 1; i <= curve.NbPoles(); ++i) {
    const auto pole = curve.Pole(i);
    if constexpr (d == 2)
      points.push_back(kernel_object<Kernel, typename Spline::Point>(std::array{pole.X(), pole.Y()}));
    else
      points.push_back(kernel_object<Kernel, typename Spline::Point>(std::array{pole.X(), pole.Y(), pole.Z()}));
    if (curve.IsRational())
      weights.push_back(converted_number<typename Kernel::FT>(curve.Weight(i)));
  }
  const auto knots = knot_sequence<typename Kernel::FT>(curve.Knots(), curve.Multiplicities(), curve.IsPeriodic());
  return curve.IsPeriodic() ? Spline::from_periodic(curve.Degree(), knots, std::move(points), std::move(weights))
                            : Spline(curve.Degree(), knots, points, weights);
}

// What a spline of OpenCASCADE is made of along one axis.
struct Opencascade_axis
{
  TColStd_Array1OfReal knots;
  TColStd_Array1OfInteger multiplicities;

  explicit Opencascade_axis(const std::vector<Exact_rational>& sequence)
    : Opencascade_axis(grouped(sequence))
  {}

private:
  explicit Opencascade_axis(const std::vector<std::pair<double, int>>& groups)
    : knots(1, static_cast<int>(groups.size())), multiplicities(1, static_cast<int>(groups.size()))
  {
    for (std::size_t i = 0; i < groups.size(); ++i) {
      knots(static_cast<int>(i) + 1) = groups[i].first;
      multiplicities(static_cast<int>(i) + 1) = groups[i].second;
    }
  }

  static std::vector<std::pair<double, int>> grouped(const std::vector<Exact_rational>& sequence)
  {
    std::vector<std::pair<double, int>> result;
    for (std::size_t i = 0; i < sequence.size(); ++i)
      if (i > 0 && sequence[i] == sequence[i - 1])
        ++result.back().second;
      else
        result.emplace_back(to_nearest_double(sequence[i]), 1);
    return result;
  }
};

// OpenCASCADE checks what it is given; what it refuses is reported as bad input.
template <class Make>
auto made_by_opencascade(const Make& make)
{
  try {
    return make();
  } catch (const Standard_Failure& failure) {
    throw Invalid_input("to_opencascade: OpenCASCADE refuses it: " + std::string(failure.GetMessageString()));
  }
}

inline gp_Pnt2d pole_of(const Exact_kernel::Point_2& p) { return {to_nearest_double(p.x()), to_nearest_double(p.y())}; }
inline gp_Pnt pole_of(const Exact_kernel::Point_3& p)
{
  return {to_nearest_double(p.x()), to_nearest_double(p.y()), to_nearest_double(p.z())};
}

template <class Result, class Poles, class Curve>
opencascade::handle<Result> curve_to_opencascade(const Curve& curve)
{
  const std::vector<Exact_rational> weights = curve.control_weights();
  const auto points = curve.control_points();
  const int size = static_cast<int>(points.size());
  Poles poles(1, size);
  TColStd_Array1OfReal own_weights(1, size);
  for (int i = 0; i < size; ++i) {
    poles(i + 1) = pole_of(points[static_cast<std::size_t>(i)]);
    own_weights(i + 1) = to_nearest_double(weights[static_cast<std::size_t>(i)]);
  }
  const Opencascade_axis axis(curve.knots());
  return made_by_opencascade([&]() -> opencascade::handle<Result> {
    if (curve.is_rational())
      return new Result(poles, own_weights, axis.knots, axis.multiplicities, curve.degree());
    return new Result(poles, axis.knots, axis.multiplicities, curve.degree());
  });
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
a curve of OpenCASCADE, also a periodic one, on the same knots; a periodic one unwrapped by
`Bspline_curve::from_periodic()`. Exact in exact kernels, since doubles are rational numbers. In kernels of doubles
products of points and weights are rounded, and so are knots that are continued by a period.
\throws Invalid_input as the constructor of `Bspline_curve`.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> to_bspline_curve(const Geom2d_BSplineCurve& curve)
{
  return internal::curve_from_opencascade<Kernel>(curve);
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> to_bspline_curve(const Geom_BSplineCurve& curve)
{
  return internal::curve_from_opencascade<Kernel>(curve);
}

//! the same of a surface.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> to_bspline_surface(const Geom_BSplineSurface& surface)
{
  using FT = typename Kernel::FT;
  std::vector<CGAL::Point_3<Kernel>> points;
  std::vector<FT> weights;
  const bool is_rational = surface.IsURational() || surface.IsVRational();
  for (int i = 1; i <= surface.NbUPoles(); ++i)
    for (int j = 1; j <= surface.NbVPoles(); ++j) {
      const gp_Pnt pole = surface.Pole(i, j);
      points.push_back(
          internal::kernel_object<Kernel, CGAL::Point_3<Kernel>>(std::array{pole.X(), pole.Y(), pole.Z()}));
      if (is_rational)
        weights.push_back(internal::converted_number<FT>(surface.Weight(i, j)));
    }
  const std::array<bool, 2> is_periodic{static_cast<bool>(surface.IsUPeriodic()),
                                        static_cast<bool>(surface.IsVPeriodic())};
  const auto knots_u = internal::knot_sequence<FT>(surface.UKnots(), surface.UMultiplicities(), is_periodic[0]);
  const auto knots_v = internal::knot_sequence<FT>(surface.VKnots(), surface.VMultiplicities(), is_periodic[1]);
  return Bspline_surface_3<Kernel>::from_periodic({surface.UDegree(), surface.VDegree()}, knots_u, knots_v, points,
                                                  is_periodic, weights);
}

/*!
the curve as one of OpenCASCADE, with the doubles next to its knots, control points and weights: the same curve, if
these are doubles.
\throws Invalid_input when a control point has weight 0; and when OpenCASCADE refuses the curve: for a degree of 0 or
above 25, weights that are not positive, and knots that are too close.
*/
template <ParametricCurve_2 Curve>
opencascade::handle<Geom2d_BSplineCurve> to_opencascade(const Curve& curve)
{
  return internal::curve_to_opencascade<Geom2d_BSplineCurve, TColgp_Array1OfPnt2d>(internal::exact_curve<2>(curve));
}

//! the same in space.
template <ParametricCurve_3 Curve>
opencascade::handle<Geom_BSplineCurve> to_opencascade(const Curve& curve)
{
  return internal::curve_to_opencascade<Geom_BSplineCurve, TColgp_Array1OfPnt>(internal::exact_curve<3>(curve));
}

//! the same of a surface.
template <ParametricSurface_3 Surface>
opencascade::handle<Geom_BSplineSurface> to_opencascade(const Surface& surface)
{
  const auto exact = internal::exact_surface(surface);
  const auto points = exact.control_points();
  const auto weights = exact.control_weights();
  const int size_u = static_cast<int>(exact.size(0)), size_v = static_cast<int>(exact.size(1));
  TColgp_Array2OfPnt poles(1, size_u, 1, size_v);
  TColStd_Array2OfReal own_weights(1, size_u, 1, size_v);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int i = static_cast<int>(k) / size_v + 1, j = static_cast<int>(k) % size_v + 1;
    poles(i, j) = internal::pole_of(points[k]);
    own_weights(i, j) = to_nearest_double(weights[k]);
  }
  const internal::Opencascade_axis u(exact.knots(0)), v(exact.knots(1));
  return internal::made_by_opencascade([&]() -> opencascade::handle<Geom_BSplineSurface> {
    if (exact.is_rational())
      return new Geom_BSplineSurface(poles, own_weights, u.knots, v.knots, u.multiplicities, v.multiplicities,
                                     exact.degree(0), exact.degree(1));
    return new Geom_BSplineSurface(poles, u.knots, v.knots, u.multiplicities, v.multiplicities, exact.degree(0),
                                   exact.degree(1));
  });
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_OPENCASCADE_H
