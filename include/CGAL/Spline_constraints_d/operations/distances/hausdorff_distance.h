// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_HAUSDORFF_DISTANCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_HAUSDORFF_DISTANCE_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/distances/internal/Farthest_point_search.h>
#endif

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

The Hausdorff distance of two curves, or a one-sided one, within certain bounds; and a point that is as far from the
other curve as these say.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Hausdorff_distance
{
public:
  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  internal::Distances::Found_hausdorff_distance<d> m_found;
  std::array<Point, 2> m_points;

public:
  //! what `hausdorff_distance()` has found, with points of the kernel.
  explicit Hausdorff_distance(internal::Distances::Found_hausdorff_distance<d> found)
    : m_found(std::move(found)), m_points{internal::kernel_object<Kernel, Point>(m_found.points[0]),
                                          internal::kernel_object<Kernel, Point>(m_found.points[1])}
  {}

  //! the square of the distance lies between these numbers.
  const Range& squared_distance_range() const { return m_found.squared_distance; }

  //! the distance lies between these doubles.
  std::pair<double, double> distance_range() const { return internal::Distances::root_range(m_found.squared_distance); }

  //! the curve that has the far point, 0 or 1.
  std::size_t curve() const { return m_found.curve; }

  //! the parameter on the first (0) or second (1) curve: on `curve()`, of a point whose distance from the other curve
  //! lies in the range as well, by proof; on the other one, of a point near the one that is nearest to it.
  const Exact_rational& parameter(std::size_t curve) const { return m_found.parameters[curve]; }

  //! the point with this parameter.
  const Point& point(std::size_t curve) const { return m_points[curve]; }

  //! whether the bounds differ by no more than the tolerance.
  bool is_complete() const { return m_found.summary.is_complete; }

  //! the parts of both curves that may be farther from the other one than the lower bound and the tolerance say.
  const std::vector<Undecided_part>& undecided() const { return m_found.undecided; }

  //! the work: its nodes are parts of the curves.
  const Summary& summary() const { return m_found.summary; }
};

namespace internal {
namespace Distances {

// Curves in the same space.
template <class A, class B>
concept Curves_of_one_space = (ParametricCurve_2<A> && ParametricCurve_2<B>) ||
    (ParametricCurve_3<A> && ParametricCurve_3<B>);

template <class Curve>
using Hausdorff_distance_of = Hausdorff_distance<typename Curve::Kernel, ParametricCurve_2<Curve> ? 2 : 3>;

template <class C1, class C2>
Hausdorff_distance_of<C1> hausdorff_distance(const C1& c1, const C2& c2, double tolerance, bool is_one_sided,
                                             const Solver_options& options)
{
  constexpr int d = ParametricCurve_2<C1> ? 2 : 3;
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw Invalid_input("hausdorff_distance: the tolerance must be positive and finite");
  return Hausdorff_distance_of<C1>(
      hausdorff_distance_of<d>(exact_map<d>(c1), exact_map<d>(c2), tolerance, is_one_sided, options));
}

} // namespace Distances
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDDistances

the Hausdorff distance of two curves in the plane or in space, the largest distance of a point of one of them from the
other one: \f$\max(h(C_1,C_2), h(C_2,C_1))\f$ with
\f$h(A,B) = \max_u \min_v |A(u) - B(v)|\f$. The bounds are certified, and their difference is at most the tolerance,
unless that is so small (about \f$10^{-12}\f$ times the size of the curves) that the rounding of doubles shows. Curves
may have corners.

Ranges of the curve's parameter are bisected, those with the largest upper bounds first. For the middle \f$m\f$ of one,
the least distance from \f$B\f$ is bounded from below, by another branch and bound. With a point \f$B(v)\f$ next to
\f$A(m)\f$, the distances of the whole range are bounded from above by those of \f$A(u)\f$ from \f$B(v)\f$ and from
\f$B(v + s(u-m))\f$, where \f$s\f$ makes the point follow \f$A(u)\f$. Their error is of second order in the length of
the range where \f$h\f$ is attained on smooth pieces, so that few ranges are left at every length, and where the curves
are parallel.

\tparam C1,C2 models of `ParametricCurve_2`, or of `ParametricCurve_3`; points of the result are those of the kernel of
`C1`.
\param c1 the first curve.
\param c2 the second curve.
\param tolerance the largest difference of the bounds that is good enough.
\param options a time limit and a visitor; where the run ends early, the bounds are certified, but farther apart. Its
tolerance and the number of nodes do not matter.
\throws Invalid_input when the tolerance is not positive and finite, or the weight of a curve is not proved to have one
sign.
*/
template <class C1, class C2>
requires internal::Distances::Curves_of_one_space<C1, C2>
auto hausdorff_distance(const C1& c1, const C2& c2, double tolerance = 1e-6, const Solver_options& options = {})
{
  return internal::Distances::hausdorff_distance(c1, c2, tolerance, false, options);
}

/*!
\ingroup PkgSplineConstraintsDDistances

the largest distance of a point of the first curve from the second curve, \f$h(C_1,C_2)\f$; otherwise as
`hausdorff_distance()`.
*/
template <class C1, class C2>
requires internal::Distances::Curves_of_one_space<C1, C2>
auto one_sided_hausdorff_distance(const C1& c1, const C2& c2, double tolerance = 1e-6,
                                  const Solver_options& options = {})
{
  return internal::Distances::hausdorff_distance(c1, c2, tolerance, true, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_HAUSDORFF_DISTANCE_H
