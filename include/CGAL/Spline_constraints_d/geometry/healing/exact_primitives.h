// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_EXACT_PRIMITIVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_EXACT_PRIMITIVES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/Joint_control_points.h>
#include <CGAL/Spline_constraints_d/geometry/healing/Primitive_kind.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/healed_splines.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/geometry/healing/internal/Primitive_healer.h>
#endif

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDHealing

A curve or surface that `with_exact_primitives()` has made.

\tparam Spline `Bspline_curve_2`, `Bspline_curve_3` or `Bspline_surface_3`.
*/
template <class Spline>
struct Exact_primitive
{
  Spline spline;       ///< with exact numbers
  Primitive_kind kind; ///< what it was recognised as: that is what `spline` is, exactly
  /// a proved bound: no point of `spline` is farther than that from a point of the one that was given, whose parameters
  /// are in the same piece, nor the other way round
  double displacement;
};

/*!
\ingroup PkgSplineConstraintsDHealing

Curves or surfaces of which primitives have been made exact. When a limit was reached, or the visitor stopped the run,
those that were not looked at before are undecided, and as they were given.
*/
template <class Spline>
struct Exact_primitives
{
  //! the map of the kernel from coordinates to others.
  using Aff_transformation = typename Spline::Aff_transformation;

  std::vector<Exact_primitive<Spline>> primitives; ///< in the order of those that were given
  /// the rigid motion from coordinates in which the primitives have the simplest numbers: see `simple_splines()`
  Aff_transformation frame = CGAL::IDENTITY;
  std::vector<Undecided_part> unfinished = {}; ///< see `undecided()`
  Summary work = {};                           ///< see `summary()`

  //! the curves or surfaces.
  std::vector<Spline> splines() const
  {
    std::vector<Spline> result;
    for (const Exact_primitive<Spline>& primitive : primitives)
      result.push_back(primitive.spline);
    return result;
  }

  /*!
  the curves or surfaces before the motion `frame`. Primitives that were rotated or moved together by numbers that are
  not simple have simple numbers here; to compute with these is faster, and answers only have to be moved by `frame`.
  */
  std::vector<Spline> simple_splines() const
  {
    const Aff_transformation back = frame.inverse();
    std::vector<Spline> result;
    for (const Exact_primitive<Spline>& primitive : primitives)
      result.push_back(primitive.spline.transformed(back));
    return result;
  }

  //! how many were recognised.
  std::size_t number_of_recognised() const
  {
    return static_cast<std::size_t>(std::count_if(primitives.begin(), primitives.end(), [](const auto& primitive) {
      return primitive.kind != Primitive_kind::GENERAL && primitive.kind != Primitive_kind::UNDECIDED;
    }));
  }

  //! a proved bound for how far any point was moved.
  double displacement() const
  {
    double result = 0;
    for (const Exact_primitive<Spline>& primitive : primitives)
      result = (std::max)(result, primitive.displacement);
    return result;
  }

  //! whether all have been looked at: unless a limit was reached or the visitor stopped the run.
  bool is_complete() const { return work.is_complete; }

  //! the boxes of those that have not been looked at.
  const std::vector<Undecided_part>& undecided() const { return unfinished; }

  //! the work; a node is a curve or surface.
  const Summary& summary() const { return work; }
};

namespace internal {

template <class Spline>
struct Dimension_of_spline;

template <class Kernel, int d>
struct Dimension_of_spline<Bspline_curve<Kernel, d>>
{
  static constexpr int value = d;
  static constexpr bool is_curve = true;
};

template <class Kernel>
struct Dimension_of_spline<Bspline_surface_3<Kernel>>
{
  static constexpr int value = 3;
  static constexpr bool is_curve = false;
};

template <class Range>
using Spline_of_range = std::remove_cvref_t<std::ranges::range_reference_t<Range>>;

// A range of B-spline curves, or of surfaces.
template <class Range>
concept Spline_range = std::ranges::input_range<Range> && requires
{
  Dimension_of_spline<Spline_of_range<Range>>::value;
};

// The spline in another kernel.
template <class Target, class Source>
Target spline_in_kernel(const Source& spline)
{
  if constexpr (std::same_as<Source, Target>)
    return spline;
  else
    return Target(spline);
}

template <class Target, class Splines>
std::vector<Target> exact_copies(Splines&& splines)
{
  std::vector<Target> result;
  for (const auto& spline : splines)
    result.push_back(spline_in_kernel<Target>(spline));
  return result;
}

// The rigid motion from coordinates of the frame of splines; in the plane, of one that keeps it, seen from above.
template <class Map, int d>
Map motion_of(const Healing::Healed_splines<d>& healed)
{
  using FT = typename Map::R::FT;
  const auto number = [](const Exact_rational& x) { return converted_number<FT>(x); };
  const auto& [x, y, z] = healed.axes;
  const Exact_kernel::Point_3& o = healed.origin;
  if constexpr (d == 2)
    return Map(number(x.x()), number(-x.y()), number(o.x()), number(x.y()), number(x.x()), number(o.y()));
  else
    return Map(number(x.x()), number(y.x()), number(z.x()), number(o.x()), number(x.y()), number(y.y()), number(z.y()),
               number(o.y()), number(x.z()), number(y.z()), number(z.z()), number(o.z()));
}

template <class Spline, class Healed>
Exact_primitives<Spline> exact_primitives_of(const std::vector<Healed>& healed,
                                             const typename Spline::Aff_transformation& frame,
                                             const Run_control& control)
{
  Exact_primitives<Spline> result;
  result.frame = frame;
  std::size_t done = 0;
  for (std::size_t i = 0; i < healed.size(); ++i) {
    result.primitives.push_back({spline_in_kernel<Spline>(healed[i].spline), healed[i].kind, healed[i].displacement});
    done += healed[i].is_done() ? 1 : 0;
    if (!healed[i].is_done()) {
      Undecided_part part{{}, {{i, {}}}, in_words(control.reason())};
      for (const auto& range : healed[i].spline.representation().bounds())
        part.place.emplace_back(range.inf(), range.sup());
      for (int axis = 0; axis < Spline::number_of_parameters; ++axis) {
        const auto [begin, end] = healed[i].spline.representation().numerator(0).domain(axis);
        part.parameters[0].ranges.emplace_back(to_nearest_double(begin), to_nearest_double(end));
      }
      result.unfinished.push_back(std::move(part));
    }
  }
  result.work = summary_of(control, done, control.reason(), done == healed.size());
  return result;
}

inline void check_healing(double tolerance, const Solver_options& options)
{
  if (!(tolerance > 0 && std::isfinite(tolerance)))
    throw Invalid_input("with_exact_primitives: the tolerance is " + std::to_string(tolerance) +
                        ", it has to be a positive number");
  options.check();
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDHealing
/// @{

/*!
curves or surfaces of which lines, circles, planes, spheres, cylinders, cones and tori are so exactly, where they were
so but for rounding. Data of CAD programs are rounded: a rational circle whose weights are \f$\sqrt{1/2}\f$ in doubles
is no circle, and surfaces that are to touch, to have an axis or a seam in common or to meet at a right angle do so no
more.

Recognised are B-splines on any knots, of any degrees and with any weights that run along circles as rational quadratics
do (in whole turns or parts of them, in any number of pieces): arcs of circles, and surfaces that an arc or a straight
line describes when it is turned around an axis in its plane; and all those whose control points are on a line or in a
plane. They are replaced by exact ones

- on the same domains, with the same breaks. On planes and lines points keep their parameters. Along circles they do so
  at the breaks; between these the parameter changes by a projective map (that of a quarter with the weights \f$1,
  \sqrt{1/2}, 1\f$ to the weights 1, 1, 2), since no other rational one keeps numbers short;
- with the simplest rational numbers within the tolerance for radii, centers and heights, and axes along unit vectors
  of rational coordinates. All are relative to a system of coordinates in which they are simple: that of the data, or
  one with rational axes at a primitive with other directions or at another place (up to 16 of them). What was rotated
  or moved together by numbers that are not simple is coaxial, parallel, perpendicular or tangent again;
- closed exactly at seams and poles.

Relations that no rational coordinates have (spheres that touch each other in the direction of a diagonal, say) remain
as near as the tolerance.

All others are *general*. Their control points become points with simple coordinates, control points of others or
corners of primitives, where these are near; sides whose control points are near each other become points, and opposite
sides that are near each other the same curve.

Nothing moves by more than the tolerance; by how much at most is proved for each one, by the exact difference of two
splines: the one that was given, and one with the same points as the result at the same parameters as that, up to
rounding. A spline that is not proved to be near a primitive is general, and one with a control weight that is not
positive is returned as it was.

\tparam Kernel a kernel of rational numbers, of the result; that of `splines` is any.
\param splines a range of `Bspline_curve_2`, of `Bspline_curve_3` or of `Bspline_surface_3`.
\param tolerance the greatest distance by which points are moved: larger than the errors of the data, and much smaller
than their details.
\param options limits of time, a visitor; the rest of the options has no effect.
\throws Invalid_input when the tolerance is not positive and finite, or an option makes no sense.

Complexity: linear in the number of splines, and for each one a product of splines of its size.
*/
template <SplineKernel Kernel = CGAL::Simple_cartesian<Exact_rational>, internal::Spline_range Splines>
requires internal::RationalSplineKernel<Kernel>
auto with_exact_primitives(Splines&& splines, double tolerance, const Solver_options& options = {})
{
  using Dimension = internal::Dimension_of_spline<internal::Spline_of_range<Splines>>;
  using internal::Exact_kernel;
  internal::check_healing(tolerance, options);
  internal::Run_control control(options);
  if constexpr (Dimension::is_curve) {
    constexpr int d = Dimension::value;
    using Curve = Bspline_curve<Kernel, d>;
    auto curves = internal::exact_copies<Bspline_curve<Exact_kernel, d>>(splines);
    const internal::Healing::Healed_splines<d> healed = [&] {
      if constexpr (d == 2)
        return internal::Healing::healed_splines(std::move(curves), tolerance, control);
      else
        return internal::Healing::healed_splines(std::move(curves), {}, tolerance, control);
    }();
    return internal::exact_primitives_of<Curve>(
        healed.curves, internal::motion_of<typename Curve::Aff_transformation>(healed), control);
  } else {
    using Surface = Bspline_surface_3<Kernel>;
    const internal::Healing::Healed_splines<3> healed = internal::Healing::healed_splines(
        {}, internal::exact_copies<Bspline_surface_3<Exact_kernel>>(splines), tolerance, control);
    return internal::exact_primitives_of<Surface>(
        healed.surfaces, internal::motion_of<typename Surface::Aff_transformation>(healed), control);
  }
}

//! the same for curves in space and surfaces together, so that their relations to each other are exact, too: the curves
//! first.
template <SplineKernel Kernel = CGAL::Simple_cartesian<Exact_rational>, internal::Spline_range Curves,
          internal::Spline_range Surfaces>
requires internal::RationalSplineKernel<Kernel>
    std::pair<Exact_primitives<Bspline_curve_3<Kernel>>, Exact_primitives<Bspline_surface_3<Kernel>>>
    with_exact_primitives(Curves&& curves, Surfaces&& surfaces, double tolerance, const Solver_options& options = {})
{
  using internal::Exact_kernel;
  internal::check_healing(tolerance, options);
  internal::Run_control control(options);
  using Curve = Bspline_curve_3<Kernel>;
  using Surface = Bspline_surface_3<Kernel>;
  const internal::Healing::Healed_splines<3> healed = internal::Healing::healed_splines(
      internal::exact_copies<Bspline_curve_3<Exact_kernel>>(curves),
      internal::exact_copies<Bspline_surface_3<Exact_kernel>>(surfaces), tolerance, control);
  const auto frame = internal::motion_of<typename Kernel::Aff_transformation_3>(healed);
  return {internal::exact_primitives_of<Curve>(healed.curves, frame, control),
          internal::exact_primitives_of<Surface>(healed.surfaces, frame, control)};
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_EXACT_PRIMITIVES_H
