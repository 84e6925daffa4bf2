// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_EXACT_JOINTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_EXACT_JOINTS_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/joints/internal/Joint_places.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Bbox_2.h>

#include <cmath>
#include <cstddef>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDJoints
/// @{

/*!
Curves of which ends that were nearly on others are on them, and what that took. When a limit was reached, or the
visitor stopped the run, before that was found, they are those that were given.
*/
template <SplineKernel Kernel>
struct Exact_joints_2
{
  std::vector<Bspline_curve_2<Kernel>> curves;   ///< in the order of those that were given
  /// how many points have been joined with another one, or put on a curve, or got its tangent
  std::size_t joints;
  /// how many points and directions are near what they should be, and have been left there
  std::size_t left;
  double displacement;                           ///< the greatest distance by which a control point was moved, rounded
  Summary work = {};                             ///< see `summary()`

  //! whether nothing remains to be moved but what is `left`: unless a limit was reached or the visitor stopped the run.
  bool is_complete() const { return work.is_complete; }

  //! the box around all curves, if the result is not complete.
  std::vector<Undecided_part> undecided() const
  {
    if (is_complete())
      return {};
    CGAL::Bbox_2 box;
    for (const Bspline_curve_2<Kernel>& curve : curves)
      box += curve.bbox();
    return {{{{box.xmin(), box.xmax()}, {box.ymin(), box.ymax()}}, {}, internal::in_words(work.why_not)}};
  }

  //! the work; a node is what is done between two questions whether to go on.
  const Summary& summary() const { return work; }
};

/*!
curves that meet exactly where others do so but for rounding. A point of contact on a slanted line or on a circle is on
neither of them once its coordinates are rounded: a gap of \f$10^{-16}\f$ remains, or a crossing at a tiny angle, and
diagrams and offsets have to decide what happens there. Here it is taken back, by a choice of the caller.

Points are the ends of curves with clamped knots, and the points within curves at knots whose multiplicity is the
degree. Those that are not farther apart than `most_distance`, and no ends of one piece of a curve, become the same
point, that of the first curve. A point that is not farther than that from the inside of one piece, of the same curve or
another one, is moved onto it: to the nearest point, or where the parameter is a simpler number, if that is not farther
away along the piece than the point was beside it, or than rounding errors. Pieces that leave it at an angle of at most
`most_angle` with the tangent there, forward or backward, get this tangent, and those that leave a point at such an
angle with each other get the same one: the next control point is moved onto that, and where the curve is flat, but for
rounding, those behind it.

The control points next to a point are moved with it, so that directions stay, and straight pieces stay straight. What a
tangent in another point depends on is not moved, if pieces have it in common there. So what is near and cannot be
moved, is near several pieces at once, or belongs to a circle of points of which each one is on a piece that ends in the
next one, is left as it is.

\tparam Kernel a kernel of rational numbers, which hold the moved points exactly, as `Simple_cartesian<Exact_rational>`;
of `curves`, any.
\param curves a range of `Bspline_curve_2`.
\param most_distance the greatest distance of what is to meet; much smaller than the details of the curves. Not
negative.
\param most_angle the greatest angle of tangents that are to be the same, in radians: between 0 and \f$\pi/4\f$.
\param options limits of time and nodes, a visitor; the rest of the options has no effect.
\throws Invalid_input when the distance or the angle is not one of these, or an option makes no sense.

Complexity: \f$O(n \log n)\f$ for \f$n\f$ control points, and a projection for each point and piece with a box around
it.
*/
template <SplineKernel Kernel, std::ranges::input_range Curves>
  requires internal::RationalSplineKernel<Kernel>
Exact_joints_2<Kernel> with_exact_joints(const Curves& curves, double most_distance, double most_angle,
                                         const Solver_options& options = {})
{
  if (!(0 <= most_distance && std::isfinite(most_distance)))
    throw Invalid_input("with_exact_joints: the distance is " + std::to_string(most_distance) +
                        ", it has to be a number that is not negative");
  if (!(0 <= most_angle && most_angle <= CGAL_PI / 4))
    throw Invalid_input("with_exact_joints: the angle is " + std::to_string(most_angle) +
                        ", it has to be between 0 and pi/4");
  std::vector<Bspline_curve_2<Kernel>> exact;
  for (const auto& curve : curves)
    exact.emplace_back(curve);
  internal::Common::Run_of_steps run(options);
  try {
    const internal::Joints::Joint_places<Kernel> places(exact, most_distance, most_angle, run);
    return {places.points.curves(), places.joints, places.left, places.points.displacement(), run.summary(true)};
  } catch (const internal::Run_stopped&) {
    return {std::move(exact), 0, 0, 0, run.summary(false)};
  }
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_JOINTS_EXACT_JOINTS_2_H
