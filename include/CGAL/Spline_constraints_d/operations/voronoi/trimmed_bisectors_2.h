// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTORS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTORS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Trimmed_bisector_2.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/Point_2.h>
#include <CGAL/tags.h>

#include <concepts>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

template <class Concurrency_tag, SplineKernel Kernel, class... Operands>
Trimmed_bisector_2<Kernel> bisector_of(const Solver_options& options, const Operands&... operands)
{
  return Trimmed_bisector_2<Kernel>(
      bisector_of_operands<Concurrency_tag>(ordered_operands(operands...), options));
}

} // namespace Voronoi
} // namespace internal

/// \addtogroup PkgSplineConstraintsDVoronoi
/// @{

/*!
the trimmed bisector of two curves in the plane: all points that have the same distance from both, as chains with the
first curve on the right.

The distance is that of the nearest point of a curve, which may be one of its ends. Other than `bisector_curves()`, this
has no centers of circles that touch both curves, but have another point of them inside.

Curves may cross or touch each other and themselves: a chain begins in each of the angles at a common point of both.
They may share end points, and overlap. Points of which such a common end, or a point of a common piece, is the only
nearest point are equally far from both curves, too, but no part of the result: they form areas, or a normal of both. An
edge between what is common and one of the curves is a part of the boundary of such an area, and belongs to the result.
Where curves touch at parameters that are not rational, or have a zero derivative at one in the inside of a piece, the
bisector is not resolved, and `Trimmed_bisector_2::is_complete()` is false.

It is proved as the Voronoi diagram of both curves, see `voronoi_diagram()`.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to hand
the sides of the curves to all cores through TBB. The answers are the same.
\tparam C1,C2 models of `ParametricCurve_2` with the same kernel.
\param a the first curve.
\param b the second curve.
\param options limits and a visitor, as of `voronoi_diagram()`.
\throws Invalid_input when the greatest absolute value of a coordinate is neither 0 nor between \f$2^{-250}\f$ and
\f$2^{250}\f$, a piece of a curve is a point, the weight of a curve is not proved to have one sign, or an option makes
no sense.

Complexity: that of the Voronoi diagram.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 C1, ParametricCurve_2 C2>
  requires std::same_as<typename C1::Kernel, typename C2::Kernel>
Trimmed_bisector_2<typename C1::Kernel> trimmed_bisector(const C1& a, const C2& b, const Solver_options& options = {})
{
  return internal::Voronoi::bisector_of<Concurrency_tag, typename C1::Kernel>(options, a, b);
}

//! the trimmed bisector of a curve and a point, with the curve on the right. Of a point on the curve, edges are between
//! this point and the curve as it goes on.
//! \throws Invalid_input as above.
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 Curve>
Trimmed_bisector_2<typename Curve::Kernel> trimmed_bisector(const Curve& a, const typename Curve::Kernel::Point_2& b,
                                                            const Solver_options& options = {})
{
  return internal::Voronoi::bisector_of<Concurrency_tag, typename Curve::Kernel>(options, a, b);
}

//! the trimmed bisector of a point and a curve, with the point on the right.
//! \throws Invalid_input as above.
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 Curve>
Trimmed_bisector_2<typename Curve::Kernel> trimmed_bisector(const typename Curve::Kernel::Point_2& a, const Curve& b,
                                                            const Solver_options& options = {})
{
  return internal::Voronoi::bisector_of<Concurrency_tag, typename Curve::Kernel>(options, a, b);
}

//! the bisector of two points, a line, with the first one on the right.
//! \throws Invalid_input when the points are equal, a coordinate is not finite, or the magnitudes are not as above.
template <class Concurrency_tag = CGAL::Sequential_tag, SplineKernel Kernel>
Trimmed_bisector_2<Kernel> trimmed_bisector(const CGAL::Point_2<Kernel>& a, const CGAL::Point_2<Kernel>& b,
                                            const Solver_options& options = {})
{
  return internal::Voronoi::bisector_of<Concurrency_tag, Kernel>(options, a, b);
}

/*!
the trimmed self-bisector of a curve in the plane: the centers of all disks that touch it in two points or more, ends
included, and have no point of it inside. It ends in centers of curvature, in corners, and at infinity.

The points inside of a closed curve are its medial axis. That of a circle is a vertex of the diagram without edges.

\tparam Concurrency_tag as above.
\param curve a model of `ParametricCurve_2`; it may cross and touch itself, as above.
\param options as above.
\throws Invalid_input as above.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 Curve>
Trimmed_bisector_2<typename Curve::Kernel> trimmed_self_bisector(const Curve& curve,
                                                                 const Solver_options& options = {})
{
  return internal::Voronoi::bisector_of<Concurrency_tag, typename Curve::Kernel>(options, curve);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_BISECTORS_2_H
