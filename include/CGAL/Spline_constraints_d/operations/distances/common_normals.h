// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_COMMON_NORMALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_COMMON_NORMALS_H

#include <CGAL/Spline_constraints_d/operations/common/Answer_list.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Found_common_normals.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/distances/internal/Common_normal_finder.h>
#endif

#include <concepts>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

The common normals of two surfaces: the pairs of points in which they meet these, by increasing distance.
*/
template <SplineKernel Kernel>
using Common_normals = Answer_list<Point_pair<Kernel, 3>>;

namespace internal {
namespace Distances {

template <class A, class B>
concept Two_surfaces = Intersection_operand<A>::is_bounded && Intersection_operand<B>::is_bounded &&
        Intersection_operand<A>::number_of_parameters == 2 &&
    Intersection_operand<B>::number_of_parameters == 2 &&
    std::same_as<typename Intersection_operand<A>::Kernel, typename Intersection_operand<B>::Kernel>;

} // namespace Distances
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDDistances

all lines that are perpendicular to two surfaces, with the points in which they are: near or far, on the same side of a
surface or not. These are the critical pairs of the distance between the surfaces, the solutions of

\f[ \langle A - B, A_u\rangle = \langle A - B, A_v\rangle = \langle N_A, B_s\rangle = \langle N_A, B_t\rangle = 0. \f]

Where the surfaces touch, there is one of length zero; where they cross, there is none. The surface whose normal has the
lower degrees is taken as \f$A\f$. At a crease the normals of both sides count. A normal at a seam is found once. Where
infinitely many pairs belong together, they are one answer, a `CONTINUUM`, if this is proved, or undecided. From a pole
of a surface, an edge that is one point, the same normal has a whole range of parameters. Where one rotation,
translation or helical motion moves both surfaces along themselves, as of coaxial ones, only normals along its axis are
single: unless all are, which takes few nodes, the rest is undecided, a suspected continuum, without further search.

\tparam A,B models of `ParametricSurface_3` with the same kernel, or objects of CGAL that are converted to one.
\param a the first surface.
\param b the second surface.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of a system of four equations in four unknowns for each two parts with continuous tangents. Source: the
collinear normal points of \cgalCite{pm-sicad-02}.
*/
template <class A, class B>
requires internal::Distances::Two_surfaces<A, B>
    Common_normals<typename internal::Common::Intersection_operand<A>::Kernel>
    common_normals(const A& a, const B& b, const Solver_options& options = {})
{
  using Kernel = typename internal::Common::Intersection_operand<A>::Kernel;
  options.check();
  internal::Distances::Found_common_normals found = internal::Distances::common_normals_of(
      internal::Common::Intersection_operand<A>::map(a), internal::Common::Intersection_operand<B>::map(b), options);
  return {internal::Distances::point_pairs<Kernel, 3>(std::move(found.pairs)), std::move(found.undecided),
          found.summary};
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_COMMON_NORMALS_H
