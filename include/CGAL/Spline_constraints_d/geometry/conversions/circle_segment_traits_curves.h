// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CIRCLE_SEGMENT_TRAITS_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CIRCLE_SEGMENT_TRAITS_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>

#include <array>
#include <concepts>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Curve_2 of CGAL::Arr_circle_segment_traits_2.
template <class Curve>
concept Circle_segment_traits_curve = SplineKernel<typename Curve::Kernel> &&
    std::constructible_from<Curve, typename Curve::Kernel::Segment_2> &&
    std::constructible_from<Curve, typename Curve::Kernel::Circle_2, typename Curve::Point_2,
                            typename Curve::Point_2> && requires(const Curve& curve)
{
  {
    curve.is_circular()
    } -> std::convertible_to<bool>;
};

// A segment, or an arc of a circle less than that.
template <class Circle_segment, class Curve>
std::optional<Circle_segment> circle_segment_of(const Curve& piece)
{
  using Kernel = typename Circle_segment::Kernel;
  const auto point = [](const auto& p) {
    return kernel_object<Kernel, typename Kernel::Point_2>(std::array<Exact_rational, 2>{p.x(), p.y()});
  };
  if (const auto circle = to_circle(piece)) {
    const auto end = [](const auto& p) {
      return typename Circle_segment::Point_2(converted_number<typename Kernel::FT>(p.x()),
                                              converted_number<typename Kernel::FT>(p.y()));
    };
    return Circle_segment(typename Kernel::Circle_2(point(circle->center()),
                                                    converted_number<typename Kernel::FT>(circle->squared_radius()),
                                                    circle->orientation()),
                          end(piece.source()), end(piece.target()));
  }
  if (const auto segment = to_segment(piece))
    return Circle_segment(typename Kernel::Segment_2(point(segment->source()), point(segment->target())));
  return std::nullopt;
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDConstructions

the polynomial or rational pieces of a curve as curves of `CGAL::Arr_circle_segment_traits_2`, if all are arcs of
circles, or segments that are run through with constant speed; nothing otherwise. Decided exactly.

\tparam Circle_segment the type `Curve_2` of the traits class, whose kernel must be exact.
\param curve the curve, of which no piece must run back on its circle.
*/
template <internal::Circle_segment_traits_curve Circle_segment, ParametricCurve_2 Curve>
std::optional<std::vector<Circle_segment>> to_circle_segment_traits_curves(const Curve& curve)
{
  std::vector<Circle_segment> result;
  for (const auto& piece : internal::exact_curve<2>(curve).bezier_pieces()) {
    const auto [begin, end] = piece.domain();
    const Exact_rational middle((begin + end) / 2);
    std::vector<Bspline_curve_2<internal::Exact_kernel>> arcs{piece};
    if (piece.source() == piece.target())   // a whole circle
      arcs = {piece.restricted(begin, middle), piece.restricted(middle, end)};
    for (const auto& arc : arcs) {
      const auto segment = internal::circle_segment_of<Circle_segment>(arc);
      if (!segment)
        return std::nullopt;
      result.push_back(*segment);
    }
  }
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CIRCLE_SEGMENT_TRAITS_CURVES_H
