// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_BEZIER_TRAITS_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_BEZIER_TRAITS_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/internal/core_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Kernel_traits.h>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Curve_2 and X_monotone_curve_2 of CGAL::Arr_Bezier_curve_traits_2; their class templates have different names in
// different versions of CGAL.
template <class Curve>
concept Bezier_traits_curve = requires(const Curve& curve) {
  curve.control_points_begin();
  curve.control_points_end();
  curve.x_polynomial();
};

template <class Curve>
concept Bezier_traits_x_monotone_curve = requires(const Curve& curve) {
  { curve.supporting_curve() } -> Bezier_traits_curve;
  curve.source();
  curve.target();
  curve.xid();
};

template <class Curve>
using Kernel_of_Bezier_curve =
    typename CGAL::Kernel_traits<std::decay_t<decltype(*std::declval<const Curve&>().control_points_begin())>>::Kernel;

template <class X_monotone_curve, class Point>
Exact_rational rational_parameter(const X_monotone_curve& curve, const Point& end)
{
  const auto& originator = *end.get_originator(curve.supporting_curve(), curve.xid());
  std::optional<Exact_rational> result;
  if (originator.has_parameter())
    result = rational_value_of(originator.parameter());
  else if (const auto& bound = originator.point_bound(); bound.t_min == bound.t_max)
    result = converted_number<Exact_rational>(bound.t_min);
  if (!result)
    throw Invalid_input("to_bspline_curve: an end of the x-monotone Bezier curve is at no rational parameter, or at "
                        "none that is known");
  return *result;
}

// The control points of the Taylor polynomial at the begin of a curve, as a Bezier curve of the same degree.
template <int d>
std::vector<typename Bspline_curve<Exact_kernel, d>::Point>
control_points_of_polynomial(const Bspline_curve<Exact_kernel, d>& curve)
{
  const auto [begin, end] = curve.domain();
  const int degree = curve.degree();
  // divided by degree! / (degree - i)! for unit length, they are the forward differences
  auto differences = curve.derivatives(begin, degree);
  Exact_rational factor(1);
  for (int i = 1; i <= degree; ++i) {
    factor *= Exact_rational((end - begin) / (degree - i + 1));
    differences[i] = differences[i] * factor;
  }
  std::vector<typename Bspline_curve<Exact_kernel, d>::Point> result;
  for (int j = 0; j <= degree; ++j) {
    result.push_back(CGAL::ORIGIN + differences[0]);
    for (int i = 0; i + j < degree; ++i)
      differences[i] = differences[i] + differences[i + 1];
  }
  return result;
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

//! a `Curve_2` of `CGAL::Arr_Bezier_curve_traits_2`, over \f$[0,1]\f$, in the kernel of its control points. Exact.
//! \throws Invalid_input for less than two control points.
template <internal::Bezier_traits_curve Curve>
auto to_bspline_curve(const Curve& curve)
{
  using Kernel = internal::Kernel_of_Bezier_curve<Curve>;
  return bezier_curve<Kernel>(
      std::vector<CGAL::Point_2<Kernel>>(curve.control_points_begin(), curve.control_points_end()));
}

/*!
an `X_monotone_curve_2` of `CGAL::Arr_Bezier_curve_traits_2`, from its source to its target; parameters are those of the
supporting curve, unless the part runs against it: then its domain is run through backwards. Exact.
\throws Invalid_input when an end is at no rational parameter, as a point with a vertical tangent rarely is; when its
parameter is not known yet, since the traits class finds that out only when it must; and when numerator and denominator
of a parameter given as an algebraic number have 190 bits or more.
*/
template <internal::Bezier_traits_x_monotone_curve Curve>
auto to_bspline_curve(const Curve& curve)
{
  const auto whole = to_bspline_curve(curve.supporting_curve());
  using FT = typename std::decay_t<decltype(whole)>::FT;
  const Exact_rational source = internal::rational_parameter(curve, curve.source()),
                       target = internal::rational_parameter(curve, curve.target());
  const auto part = [&](const Exact_rational& begin, const Exact_rational& end) {
    return whole.restricted(internal::converted_number<FT>(begin), internal::converted_number<FT>(end));
  };
  return source < target ? part(source, target) : part(target, source).reversed();
}

/*!
the polynomial pieces of a curve as a `Curve_2` of `CGAL::Arr_Bezier_curve_traits_2` each; nothing if a piece is no
polynomial curve. Weights that cancel do not matter: each piece is compared with the one polynomial it can be. Decided
exactly.
\tparam Bezier_curve the type `Curve_2` of the traits class.
*/
template <internal::Bezier_traits_curve Bezier_curve, ParametricCurve_2 Curve>
std::optional<std::vector<Bezier_curve>> to_bezier_traits_curves(const Curve& curve)
{
  std::vector<Bezier_curve> result;
  for (const auto& piece : internal::exact_curve<2>(curve).bezier_pieces()) {
    const auto points = internal::control_points_of_polynomial(piece);
    const auto [begin, end] = piece.domain();
    if (!(bezier_curve(points).with_domain(begin, end) == piece))
      return std::nullopt;
    std::vector<typename internal::Kernel_of_Bezier_curve<Bezier_curve>::Point_2> own_points;
    for (const auto& p : points)
      own_points.push_back(*internal::point_without_rounding<internal::Kernel_of_Bezier_curve<Bezier_curve>, 2>(p));
    result.emplace_back(own_points.begin(), own_points.end());
  }
  return result;
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_BEZIER_TRAITS_CURVES_H
