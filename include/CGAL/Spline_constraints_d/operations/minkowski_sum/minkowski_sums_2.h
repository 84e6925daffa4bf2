// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUMS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUMS_2_H

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/Minkowski_sum_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

the Minkowski sum of two regions, \f$A \oplus B = \{a + b : a \in A,\ b \in B\}\f$; with a disk, all points that are not
farther from \f$A\f$ than its radius.

Its boundary is a part of the convolution of both boundaries: the sums of points with the same outer normal, where a
convex corner has all normals between those of the two curves that meet there. Sums in which the curvatures of both
boundaries add up to less than zero are left out, and those of reflex corners, since there the regions overlap, \f$B\f$
reflected, next to their contact. What is left is cut at all crossings, and one point beside each of the parts, moved by
very little from it, is proved to be inside of the sum, or not: it is if the boundaries of \f$A\f$ and of \f$B\f$,
reflected in that point, cross, or one is inside of the other. Both regions may have holes and several parts.

All is decided by interval arithmetic in double precision and, where this does not tell how pieces cross, where they
end, or which sign the sum of both curvatures has, with 128 bits; and exactly for directions at the ends of curves and
for rational points in which pieces touch, end in others or coincide; nothing depends on a tolerance. As many arcs of
the boundary end in each vertex as begin there, so that some parts tell about others. Where pieces with opposite
directions coincide, the sum is on both sides. Where that is not enough, `Minkowski_sum_2::is_complete()` is false:
where parts of the boundary touch, or three cross, in a point that is not rational. What is not decided inside of the
sum does not matter.

\tparam Kernel a `SplineKernel`.
\param a the first region.
\param b the second region. Where one of them is not complete, the sum is not.
\param options limits of time and nodes, a visitor; see `Minkowski_sum_2::undecided()`. The rest of the options has no
effect.
\throws Invalid_input when an option makes no sense; when the greatest absolute value of a coordinate is neither 0 nor
between \f$2^{-250}\f$ and \f$2^{250}\f$; when the derivative of a curve is zero, other than in the end of a piece, as
where the first two control points of a cubic are the same, or a boundary turns back in a cusp; the message names the
curve and the parameter.

Complexity: the product of the numbers of arcs for the convolution, crossings of each two of its pieces whose boxes
meet, and for each of the parts the product of the numbers of arcs once more. Source: \cgalCite{kes-gcps-05}, equations
(1) to (3), for the convolution of curves; \cgalCite{w-eecpms-06} for corners.
*/
template <SplineKernel Kernel>
Minkowski_sum_2<Kernel> minkowski_sum(const Planar_region_2<Kernel>& a, const Planar_region_2<Kernel>& b,
                                      const Solver_options& options = {})
{
  return Minkowski_sum_2<Kernel>(internal::Minkowski_sum::sum_of_regions(
      {internal::Minkowski_sum::sum_operand(a, 0), internal::Minkowski_sum::sum_operand(b, a.curves().size())},
      options));
}

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

the Minkowski sum of a region and a polygon.
\throws Invalid_input when the polygon is empty or crosses itself, and as above.
*/
template <SplineKernel Kernel, class Container>
Minkowski_sum_2<Kernel> minkowski_sum(const Planar_region_2<Kernel>& a, const CGAL::Polygon_2<Kernel, Container>& b,
                                      const Solver_options& options = {})
{
  return minkowski_sum(a, planar_region(b), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUMS_2_H
