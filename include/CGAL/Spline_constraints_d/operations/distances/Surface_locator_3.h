// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_SURFACE_LOCATOR_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_SURFACE_LOCATOR_3_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
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

A B-spline surface that is prepared for many queries, as a `Curve_locator` is: it stands for its surface in
`closest_points()`, `projections()` and `distance_range()`.

\tparam Kernel_ a `SplineKernel`.

Copies share what is prepared, and queries of several threads at a time are safe.
*/
template <SplineKernel Kernel_>
class Surface_locator_3 : public internal::Distances::Spline_locator<Bspline_surface_3<Kernel_>, Kernel_, 3>
{
  using Base = internal::Distances::Spline_locator<Bspline_surface_3<Kernel_>, Kernel_, 3>;

public:
  using Kernel = Kernel_;
  using Surface = Bspline_surface_3<Kernel>;
  using Point = typename Kernel::Point_3;

  //! the locator of a surface. Linear in the number of its pieces, times the fourth power of the degree.
  explicit Surface_locator_3(Surface surface) : Base(std::move(surface)) {}

  //! the surface.
  const Surface& surface() const { return this->spline(); }

  /*!
  the point of the surface that is nearest to a point: one of them, where there are several. Doubles decide nearly
  always, without an allocation if these are the numbers of the kernel; otherwise `closest_points()` does.
  \throws Invalid_input when a coordinate is not finite.

  Complexity: about the logarithm of the number of pieces for points near the surface.
  */
  Located_point<Kernel, 3> closest_point(const Point& p) const { return this->nearest(p); }

  /*!
  the first common point of a ray and the surface, from its source on; nothing if there is none, by proof. Doubles
  decide where the ray crosses a piece inside, without an allocation if these are the numbers of the kernel;
  otherwise `intersections()` does, as at breaks and where the ray touches the surface.
  \throws Invalid_input when a coordinate is not finite or the ray is degenerate.

  Complexity: about the logarithm of the number of pieces, and linear in those that the ray passes near.
  */
  std::optional<Located_hit<Kernel, 3>> first_intersection(const typename Kernel::Ray_3& ray) const
  {
    return this->first_on(ray, [](const auto& a, const auto& b) { return intersections(a, b); });
  }
};

namespace internal {
namespace Distances {

template <SplineKernel Kernel>
struct Distance_operand_of<Surface_locator_3<Kernel>>
{
  static auto get(const Surface_locator_3<Kernel>& locator) { return locator.operand(); }
};

} // namespace Distances
namespace Common {

template <SplineKernel K>
struct Spline_operand<Surface_locator_3<K>> : Spline_operand<Bspline_surface_3<K>>
{
  static auto map(const Surface_locator_3<K>& locator)
  {
    return Spline_operand<Bspline_surface_3<K>>::map(locator.surface());
  }
  static auto patch(const Surface_locator_3<K>& locator) { return patch_of(map(locator)); }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_SURFACE_LOCATOR_3_H
