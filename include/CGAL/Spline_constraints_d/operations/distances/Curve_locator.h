// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_CURVE_LOCATOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_CURVE_LOCATOR_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/Located_hit.h>
#include <CGAL/Spline_constraints_d/operations/distances/Located_point.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Spline_locator.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

A B-spline curve that is prepared for many queries: its Bézier pieces in doubles with bounds of their errors, the
coefficients that its squared distances from points are made of, and a pyramid of boxes around them.

It stands for its curve in `closest_points()`, `projections()` and `distance_range()`, as either operand or both: the
answers are the same, and come sooner.

\tparam Kernel_ a `SplineKernel`.
\tparam d 2 or 3.

`Curve_locator_2` and `Curve_locator_3` are names for the two. Copies share what is prepared, and queries of several
threads at a time are safe.
*/
template <SplineKernel Kernel_, int d>
class Curve_locator : public internal::Distances::Spline_locator<Bspline_curve<Kernel_, d>, Kernel_, d>
{
  using Base = internal::Distances::Spline_locator<Bspline_curve<Kernel_, d>, Kernel_, d>;

public:
  using Kernel = Kernel_;
  using Curve = Bspline_curve<Kernel, d>;
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

  //! the locator of a curve. Linear in the number of its pieces, times the cube of the degree.
  explicit Curve_locator(Curve curve) : Base(std::move(curve)) {}

  //! the curve.
  const Curve& curve() const { return this->spline(); }

  /*!
  the point of the curve that is nearest to a point: one of them, where there are several. Doubles decide nearly always,
  without an allocation if these are the numbers of the kernel; otherwise `closest_points()` does.
  \throws Invalid_input when a coordinate is not finite.

  Complexity: about the logarithm of the number of pieces for points near the curve.
  */
  Located_point<Kernel, d> closest_point(const Point& p) const { return this->nearest(p); }

  /*!
  the first common point of a ray and the curve, from its source on; nothing if there is none, by proof. Doubles
  decide where the ray crosses a piece inside, without an allocation if these are the numbers of the kernel;
  otherwise `intersections()` does, as at breaks and where the ray touches the curve.
  \throws Invalid_input when a coordinate is not finite or the ray is degenerate.

  Complexity: about the logarithm of the number of pieces, and linear in those that the ray passes near.
  */
  std::optional<Located_hit<Kernel, d>> first_intersection(const typename Kernel::Ray_2& ray) const requires(d == 2)
  {
    return this->first_on(ray, [](const auto& a, const auto& b) { return intersections(a, b); });
  }
};

template <SplineKernel Kernel, int d>
Curve_locator(Bspline_curve<Kernel, d>) -> Curve_locator<Kernel, d>;

//! \ingroup PkgSplineConstraintsDDistances
//! the locator of a curve in the plane.
template <SplineKernel Kernel>
using Curve_locator_2 = Curve_locator<Kernel, 2>;

//! \ingroup PkgSplineConstraintsDDistances
//! the locator of a curve in space.
template <SplineKernel Kernel>
using Curve_locator_3 = Curve_locator<Kernel, 3>;

namespace internal {
namespace Distances {

template <SplineKernel Kernel, int d>
struct Distance_operand_of<Curve_locator<Kernel, d>>
{
  static auto get(const Curve_locator<Kernel, d>& locator) { return locator.operand(); }
};

} // namespace Distances
namespace Common {

template <SplineKernel K, int d>
struct Spline_operand<Curve_locator<K, d>> : Spline_operand<Bspline_curve<K, d>>
{
  static auto map(const Curve_locator<K, d>& locator)
  {
    return Spline_operand<Bspline_curve<K, d>>::map(locator.curve());
  }
  static auto patch(const Curve_locator<K, d>& locator) { return patch_of(map(locator)); }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_CURVE_LOCATOR_H
