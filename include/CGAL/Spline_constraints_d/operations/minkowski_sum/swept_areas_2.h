// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_SWEPT_AREAS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_SWEPT_AREAS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/Minkowski_sum_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <concepts>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// Both sides of a curve, as boundaries without anything between them: one that turns back at both ends, or two if the
// curve is closed.
template <ParametricCurve_2 Curve>
Sum_operand_2 both_sides(const Curve& curve)
{
  std::vector<Boundary_piece> pieces = boundary_pieces(curve, 0);
  for (std::size_t i = 1; i < pieces.size(); ++i)
    if (pieces[i - 1].at(1) != pieces[i].at(0))
      throw Invalid_input("swept_area: the curve has a jump at parameter " +
                          internal::shortest_text(to_nearest_double(pieces[i].parameters[0])));
  const Boundary_loop_2 forward(pieces);
  Boundary_loop_2 backward(forward);
  backward.reverse();
  if (pieces.front().at(0) == pieces.back().at(1))
    return {{forward, backward}, 1};
  pieces.insert(pieces.end(), backward.pieces().begin(), backward.pieces().end());
  return {{Boundary_loop_2(std::move(pieces))}, 1};
}

} // namespace Minkowski_sum
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

what a region covers when it is moved along a curve, without being turned: the Minkowski sum of both, \f$A \oplus C =
\{a + C(u)\}\f$. Move the region first if one of its points is to follow the curve.

It is computed and proved as `minkowski_sum()`, with the curve as a region without inner points: both of its sides are
boundaries. The curve may be open or closed, have corners, and cross itself. For a disk there is `trimmed_offset()`,
which decides more.

\tparam Kernel a `SplineKernel`.
\tparam Curve a model of `ParametricCurve_2` with the same kernel.
\param region the region; where it is not complete, the area is not.
\param path the curve. Its index in the arcs of the result is zero.
\param options as of `minkowski_sum()`.
\throws Invalid_input when an option makes no sense; when the greatest absolute value of a coordinate is neither 0 nor
between \f$2^{-250}\f$ and \f$2^{250}\f$; when the derivative of a curve is zero, other than in the end of a piece, a
curve turns back in a cusp or has a jump; the message names the parameter.

Complexity: as that of `minkowski_sum()`, with each arc of the curve counted twice.
*/
template <SplineKernel Kernel, ParametricCurve_2 Curve>
  requires std::same_as<Kernel, typename Curve::Kernel>
Minkowski_sum_2<Kernel> swept_area(const Planar_region_2<Kernel>& region, const Curve& path,
                                   const Solver_options& options = {})
{
  return Minkowski_sum_2<Kernel>(internal::Minkowski_sum::sum_of_regions(
      {internal::Minkowski_sum::sum_operand(region, 0), internal::Minkowski_sum::both_sides(path)}, options));
}

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

what a curve covers when it is moved along another one, without being turned: \f$\{C_1(u) + C_2(v)\}\f$. Parts where
this is a curve alone, as where both are segments on parallel lines, are not in the result, which has boundaries of
areas.

\param curve the curve.
\param path the other curve. The index of each is zero in the arcs of the result.
\param options as above.
\throws Invalid_input as above.
*/
template <ParametricCurve_2 Curve, ParametricCurve_2 Path>
  requires std::same_as<typename Curve::Kernel, typename Path::Kernel>
Minkowski_sum_2<typename Curve::Kernel> swept_area(const Curve& curve, const Path& path,
                                                   const Solver_options& options = {})
{
  return Minkowski_sum_2<typename Curve::Kernel>(internal::Minkowski_sum::sum_of_regions(
      {internal::Minkowski_sum::both_sides(curve), internal::Minkowski_sum::both_sides(path)}, options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_SWEPT_AREAS_2_H
