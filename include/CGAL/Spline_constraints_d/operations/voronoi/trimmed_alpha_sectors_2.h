// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTORS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTORS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Trimmed_alpha_sector_2.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/Point_2.h>
#include <CGAL/tags.h>

#include <concepts>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

template <class Concurrency_tag, SplineKernel Kernel, class A, class B>
Trimmed_alpha_sector_2<Kernel> sector_of(const A& a, const B& b, const typename Kernel::FT& alpha,
                                         const Solver_options& options)
{
  return Trimmed_alpha_sector_2<Kernel>(sector_of_operands<Concurrency_tag>(
      ordered_operands(a, b), converted_number<Exact_rational>(alpha), options));
}

} // namespace Voronoi
} // namespace internal

/// \addtogroup PkgSplineConstraintsDVoronoi
/// @{

/*!
the trimmed \f$\alpha\f$-sector of two curves in the plane: all points \f$P\f$ whose distances \f$d_i\f$ from both have
the ratio \f$\alpha : 1 - \alpha\f$, \f$(1-\alpha)\,d_1(P) = \alpha\,d_2(P)\f$. It is the boundary of the set of points
that are nearer to the first curve in this sense.

The distance is that of the nearest point of a curve, which may be one of its ends. Other than `alpha_sectors()`, this
has no points on normals of points that are not the nearest ones.

Let \f$\alpha < 1/2\f$; else the curves are exchanged. On each normal of the first curve, with those of its ends and
corners, there is just one point whose distance from the second curve is \f$c = (1-\alpha)/\alpha\f$ times that along
the normal, as \f$c > 1\f$. The disk around it through the foot \f$X\f$ of the normal \f$N\f$ is \f$1/k\f$ times as
large as \f$N\f$, where \f$k\f$ is the greatest one that belongs to a point \f$Y\f$ of the second curve,
\f[ |Y - X|^2 k^2 - 2 \langle N, Y - X\rangle k - (c^2 - 1) |N|^2 = 0, \quad k > 0. \f]
The point belongs to the sector if no other point of the first curve is in that disk. So the sector is a part of the
upper envelope of functions of one variable for each side of each curve, which is computed and proved as that of
`voronoi_diagram()` is: it is cut where it crosses the self-bisectors of both curves and where feet arrive at ends, and
between, one comparison decides.

Where curves meet, both distances are 0. The chains come to such a point, and leave it again on the other side of the
first curve; pieces that are common to both curves are no part of the result.

Where curves touch in a point, two arcs that leave it in the same direction have the sector on both sides of the first
one; that is settled by expansions at the point, if its parameters are rational. Where these are not, or more than two
arcs leave in the same direction, the sector is not resolved: `Trimmed_alpha_sector_2::is_complete()` is false, and
`Trimmed_alpha_sector_2::undecided()` tells where. A crossing of the sector with both self-bisectors in one point is
decided if it is on an axis of symmetry of what is touched, or if it is rational, and all sites there are points, lines
and circles.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to hand
the sides of the curves to all cores through TBB. The answers are the same.
\tparam C1,C2 models of `ParametricCurve_2` with the same kernel.
\param a the first curve.
\param b the second curve.
\param alpha the share of the distance from the first curve, exactly; between 0 and 1, and not 1/2.
\param options limits and a visitor, as of `voronoi_diagram()`.
\throws Invalid_input when \f$\alpha\f$ is not inside of (0,1), or is 1/2: `trimmed_bisector()` is for that; when the
greatest absolute value of a coordinate is neither 0 nor between \f$2^{-250}\f$ and \f$2^{250}\f$, a piece of a curve is
a point, the weight of a curve is not proved to have one sign, or an option makes no sense.

Complexity: that of the Voronoi diagram. Source: \cgalCite{kes-gcps-05}, section 3, has the sector;
\cgalCite{hmek-pvce-05} has the idea of the envelope.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 C1, ParametricCurve_2 C2>
requires std::same_as<typename C1::Kernel, typename C2::Kernel> Trimmed_alpha_sector_2<typename C1::Kernel>
trimmed_alpha_sector(const C1& a, const C2& b, const typename C1::Kernel::FT& alpha,
                     const Solver_options& options = {})
{
  return internal::Voronoi::sector_of<Concurrency_tag, typename C1::Kernel>(a, b, alpha, options);
}

//! the trimmed \f$\alpha\f$-sector of a curve and a point.
//! \throws Invalid_input as above.
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 Curve>
Trimmed_alpha_sector_2<typename Curve::Kernel>
trimmed_alpha_sector(const Curve& a, const typename Curve::Kernel::Point_2& b, const typename Curve::Kernel::FT& alpha,
                     const Solver_options& options = {})
{
  return internal::Voronoi::sector_of<Concurrency_tag, typename Curve::Kernel>(a, b, alpha, options);
}

//! the trimmed \f$\alpha\f$-sector of a point and a curve.
//! \throws Invalid_input as above.
template <class Concurrency_tag = CGAL::Sequential_tag, ParametricCurve_2 Curve>
Trimmed_alpha_sector_2<typename Curve::Kernel>
trimmed_alpha_sector(const typename Curve::Kernel::Point_2& a, const Curve& b, const typename Curve::Kernel::FT& alpha,
                     const Solver_options& options = {})
{
  return internal::Voronoi::sector_of<Concurrency_tag, typename Curve::Kernel>(a, b, alpha, options);
}

//! the \f$\alpha\f$-sector of two points, a circle of Apollonius.
//! \throws Invalid_input as above, or when a coordinate is not finite.
template <class Concurrency_tag = CGAL::Sequential_tag, SplineKernel Kernel>
Trimmed_alpha_sector_2<Kernel> trimmed_alpha_sector(const CGAL::Point_2<Kernel>& a, const CGAL::Point_2<Kernel>& b,
                                                    const typename Kernel::FT& alpha,
                                                    const Solver_options& options = {})
{
  return internal::Voronoi::sector_of<Concurrency_tag, Kernel>(a, b, alpha, options);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_ALPHA_SECTORS_2_H
