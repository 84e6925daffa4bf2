// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CONIC_TRAITS_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CONIC_TRAITS_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/internal/conic_parts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/internal/core_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/conic_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <concepts>
#include <optional>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Curve_2 of CGAL::Arr_conic_traits_2; its class template has different names in different versions of CGAL.
template <class Arc>
concept Conic_traits_arc = requires(const Arc& arc) {
  typename Arc::Rat_kernel;
  arc.r();
  arc.w();
  arc.is_full_conic();
  { arc.orientation() } -> std::convertible_to<CGAL::Orientation>;
};

// X_monotone_curve_2, which hides most of what it inherits from Curve_2.
template <class Arc>
concept Conic_traits_x_monotone_arc = !Conic_traits_arc<Arc> && requires(const Arc& arc) {
  typename Arc::Conic_arc_2::Rat_kernel;
  arc.r();
  arc.w();
  arc.is_directed_right();
  { arc.orientation() } -> std::convertible_to<CGAL::Orientation>;
};

template <class Arc>
Conic_equation conic_equation(const Arc& arc)
{
  const auto number = [](const auto& x) { return converted_number<Exact_rational>(CORE::BigRat(x)); };
  return {number(arc.r()), number(arc.s()), number(arc.t()), number(arc.u()), number(arc.v()), number(arc.w())};
}

// A rational point of an ellipse.
inline Exact_kernel::Point_2 point_of_ellipse(const Conic_equation& conic)
{
  const Exact_rational determinant = 4 * conic.r * conic.s - conic.t * conic.t;
  const Exact_kernel::Point_2 center(Exact_rational((conic.t * conic.v - 2 * conic.s * conic.u) / determinant),
                                     Exact_rational((conic.t * conic.u - 2 * conic.r * conic.v) / determinant));
  const auto point =
      rational_point_of_form(conic.r, Exact_rational(conic.t / 2), conic.s, Exact_rational(-conic(center)));
  if (!point.roots)
    throw_without_rational_point("to_bspline_curve: the ellipse", point.is_complete);
  return center + Exact_kernel::Vector_2((*point.roots)[0], (*point.roots)[1]);
}

// The whole ellipse from one of its points.
inline Bspline_curve_2<Exact_kernel> ellipse_from(const Conic_equation& conic, const Exact_kernel::Point_2& source)
{
  return conic_arc(conic.around(source), source, {});
}

inline CGAL::Orientation orientation_of_ellipse(const Bspline_curve_2<Exact_kernel>& ellipse)
{
  return CGAL::orientation(ellipse(0), ellipse(1), ellipse(2));
}

inline Bspline_curve_2<Exact_kernel> arc_of_conic(const Conic_equation& equation, const Exact_kernel::Point_2& source,
                                                  const Exact_kernel::Point_2& target, CGAL::Orientation orientation)
{
  const Conic_through_origin conic = equation.around(source);
  const Exact_kernel::Vector_2 chord = target - source;
  if (conic.determinant() == 0)
    throw Invalid_input("to_bspline_curve: the conic of the arc is a pair of lines");
  const auto [sigma, tau] = conic.direction_of(chord);
  if (!conic.is_ellipse()) {
    const auto arc = conic_arc(conic, source, std::span(&chord, 1));
    return arc.source() == source ? arc : arc.reversed();
  }
  const auto ellipse = ellipse_from(equation, source);
  const Exact_rational end = turn_parameter(sigma, Exact_rational(tau / conic.height_of_path()));
  return orientation_of_ellipse(ellipse) == orientation ? ellipse.restricted(Exact_rational(0), end)
                                                        : ellipse.restricted(end, Exact_rational(4)).reversed();
}

template <class Point>
Exact_kernel::Point_2 rational_end(const Point& p)
{
  const auto x = rational_value_of(p.x()), y = rational_value_of(p.y());
  if (!x || !y)
    throw Invalid_input("to_bspline_curve: an end of the conic arc has no rational coordinates");
  return {*x, *y};
}

template <class Arc>
Bspline_curve_2<Exact_kernel> curve_between_ends(const Arc& arc)
{
  const auto source = rational_end(arc.source()), target = rational_end(arc.target());
  return arc.orientation() == CGAL::COLLINEAR ? segment_curve(source, target)
                                              : arc_of_conic(conic_equation(arc), source, target, arc.orientation());
}

// Since CGAL 6 curves are made by a function object of the traits class.
template <class Traits, class... Arguments>
typename Traits::Curve_2 make_conic_traits_curve(const Arguments&... arguments)
{
  if constexpr (requires(const Traits& traits) { traits.construct_curve_2_object()(arguments...); })
    return Traits().construct_curve_2_object()(arguments...);
  else
    return typename Traits::Curve_2(arguments...);
}

template <class Traits>
typename Traits::Curve_2 conic_traits_curve(const Conic_part& part)
{
  using Rat_kernel = typename Traits::Rat_kernel;
  using Rational = typename Rat_kernel::FT;
  const auto number = [](const Exact_rational& x) { return converted_number<Rational>(x); };
  const auto point = [&](const Exact_kernel::Point_2& p) {
    return typename Rat_kernel::Point_2(number(p.x()), number(p.y()));
  };
  const auto end = [&](const Exact_kernel::Point_2& p) {
    using Number = typename Traits::Alg_kernel::FT;
    return typename Traits::Point_2(Number(number(p.x())), Number(number(p.y())));
  };
  if (part.orientation == CGAL::COLLINEAR)
    return make_conic_traits_curve<Traits>(typename Rat_kernel::Segment_2(point(part.source), point(part.target)));
  const auto on = [&](const Conic_equation& q, const auto&... rest) {
    return make_conic_traits_curve<Traits>(number(q.r), number(q.s), number(q.t), number(q.u), number(q.v), number(q.w),
                                           rest...);
  };
  if (!part.is_whole())
    return on(part.conic, part.orientation, end(part.source), end(part.target));
  const auto ellipse = on(part.conic);
  // the orientation is that of the side where the equation is positive
  return ellipse.orientation() == part.orientation ? ellipse : on(part.conic.opposite());
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
a `Curve_2` of `CGAL::Arr_conic_traits_2`, from its source to its target, as a rational quadratic curve, or a segment,
in the rational kernel of the traits class; a whole ellipse in its orientation from a rational point of it that is
looked for in the directions of small integers from its center. Exact: the conic is projected from the source, as in
`conic_curve()`. The domain is a part of \f$[0,4]\f$ for arcs of ellipses, otherwise a range of slopes.
\throws Invalid_input when the arc is not valid; an end has no rational coordinates, or some whose numerator and
denominator have 190 bits or more; the conic is a pair of lines; its ends are on both branches of a hyperbola; and when
no rational point of a whole ellipse is found.
*/
template <internal::Conic_traits_arc Arc>
Bspline_curve_2<typename Arc::Rat_kernel> to_bspline_curve(const Arc& arc)
{
  using Curve = Bspline_curve_2<typename Arc::Rat_kernel>;
  if (!arc.is_valid())
    throw Invalid_input("to_bspline_curve: the conic arc is not valid");
  if (arc.is_full_conic()) {
    const internal::Conic_equation conic = internal::conic_equation(arc);
    const auto ellipse = internal::ellipse_from(conic, internal::point_of_ellipse(conic));
    return Curve(internal::orientation_of_ellipse(ellipse) == arc.orientation() ? ellipse : ellipse.reversed());
  }
  return Curve(internal::curve_between_ends(arc));
}

//! the same of an `X_monotone_curve_2`. An end where the tangent is vertical is often not rational.
template <internal::Conic_traits_x_monotone_arc Arc>
Bspline_curve_2<typename Arc::Conic_arc_2::Rat_kernel> to_bspline_curve(const Arc& arc)
{
  return Bspline_curve_2<typename Arc::Conic_arc_2::Rat_kernel>(internal::curve_between_ends(arc));
}

/*!
the arcs of conics and the segments that a curve consists of, as curves of `CGAL::Arr_conic_traits_2` with exact
coefficients and ends, in the order and sense of the curve. Pieces that follow each other on one conic in the same sense
are one curve, up to a whole ellipse. Pieces whose degree was elevated are lowered, exactly. Nothing if the degree of a
piece without common factors of its homogeneous coordinates is higher than two; if a piece is a point; and if it runs
back on a line. Decided exactly in every kernel.

CGAL 5.5 computes the line between the branches of a hyperbola wrongly unless the axes of the hyperbola are at multiples
of 45 degrees, and so takes some arcs for invalid and some points for points of the other branch.
\tparam Traits the traits class.
\throws Invalid_input when the traits class takes an arc for invalid.
*/
template <class Traits, ParametricCurve_2 Curve>
  requires internal::Conic_traits_arc<typename Traits::Curve_2>
std::optional<std::vector<typename Traits::Curve_2>> to_conic_traits_curves(const Curve& curve)
{
  const auto parts = internal::conic_parts(internal::exact_curve<2>(curve));
  if (!parts)
    return std::nullopt;
  std::vector<typename Traits::Curve_2> result;
  for (const internal::Conic_part& part : *parts)
    if (result.push_back(internal::conic_traits_curve<Traits>(part)); !result.back().is_valid())
      throw Invalid_input("to_conic_traits_curves: the traits class takes an arc of a hyperbola for invalid");
  return result;
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CONIC_TRAITS_CURVES_H
