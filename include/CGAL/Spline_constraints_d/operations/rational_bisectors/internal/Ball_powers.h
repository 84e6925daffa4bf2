// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_BALL_POWERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_BALL_POWERS_H

#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Foot_grid.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/Touching_balls.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

// The powers of points X of a surface with respect to balls around P that touch it in F: the squared distances |X-P|^2
// from the centers minus the squared radii. They are negative inside of the balls.
struct Ball_powers
{
  using Interval = Foot_grid::Interval;
  using Box = Foot_grid::Box;
  using Bounds = Foot_grid::Bounds;

  // Bounds from below of the power of points of a part of the surface, and signs of its derivatives by the parameters
  // of the feet: those of |X-P|^2 - |F-P|^2 are 2 <P',F-X>.
  struct Change
  {
    double least;
    std::array<int, 2> trends;
  };

  static Change change_of_power(const Touching_balls& balls, const Bounds& part)
  {
    if (!std::isfinite(part.distance))
      return {-std::numeric_limits<double>::infinity(), {0, 0}};
    Change result{power_of_all(part, balls).inf(), {0, 0}};
    Interval least(power_of_all(part, balls.middle).inf());
    for (const std::size_t axis : {0, 1}) {
      Interval slope =
          dot(balls.centers[axis],
              {balls.foot.center[0] - Interval(part.center[0]), balls.foot.center[1] - Interval(part.center[1]),
               balls.foot.center[2] - Interval(part.center[2])}) +
          extent(balls.foot, balls.centers[axis]) + extent(part, balls.centers[axis]);
      slope = Interval(2) * slope;
      result.trends[axis] = slope.inf() > 0 ? 1 : slope.sup() < 0 ? -1 : 0;
      least -= CGAL::abs(slope) * Interval(balls.half_widths[axis]);
    }
    result.least = (std::max)(result.least, least.inf());
    return result;
  }

  // Of one point of the surface.
  static double greatest_power(const Touching_balls& balls, const Box& sample)
  {
    const Bounds point = Ball_nets::bounds_of_point(sample);
    if (!std::isfinite(point.distance))
      return std::numeric_limits<double>::infinity();
    Interval result(power(point, balls.middle.foot, balls.middle.normal, balls.middle.x).sup());
    for (const std::size_t axis : {0, 1}) {
      Box difference;
      for (std::size_t c = 0; c < 3; ++c)
        difference[c] = balls.foot.point[c] - sample[c];
      result += Interval(2) * CGAL::abs(dot(balls.centers[axis], difference)) * Interval(balls.half_widths[axis]);
    }
    return result.sup();
  }

  // Whether all points are outside of all balls.
  static bool is_outside(const Bounds& cell, const Touching_balls& balls)
  {
    return std::isfinite(cell.distance) && power_of_all(cell, balls).inf() > 0;
  }

  // The squared distance of points of a cell from the centers minus the squared radii, from below.
  static Interval power_of_all(const Bounds& cell, const Touching_ball& balls)
  {
    const Interval near = power(cell, balls.foot, balls.normal, balls.x);
    if (near.inf() > 0)
      return near;
    // |c + s a + t b - P|^2 >= |c - P|^2 - 2 |<a,c-P>| - 2 |<b,c-P>|
    Box difference;
    for (std::size_t c = 0; c < 3; ++c)
      difference[c] = Interval(cell.center[c]) - balls.center[c];
    Interval square = CGAL::square(difference[0]) + CGAL::square(difference[1]) + CGAL::square(difference[2]);
    for (const auto* vector : {&cell.first, &cell.second})
      square -= Interval(2) * CGAL::abs(dot({(*vector)[0], (*vector)[1], (*vector)[2]}, difference));
    const double least = square_root(Interval((std::max)(square.inf(), 0.0))).inf() - cell.distance;
    const Interval far = CGAL::square(Interval((std::max)(least, 0.0))) - CGAL::square(CGAL::abs(balls.x).sup());
    return Interval((std::max)(near.inf(), far.inf()), (std::max)(near.sup(), far.sup()));
  }

  /*
  For points X of a cell,

    |X-F|^2 - 2 x <X-F,n>,

  which is positive outside of the balls. The second term is small near the foot, where the cell is nearly at a right
  angle to the normal.
  */
  static Interval power(const Bounds& cell, const Bounds& feet, const Box& normal, const Interval& x)
  {
    if (!std::isfinite(cell.distance) || !std::isfinite(feet.distance))
      return Interval::largest();
    Interval square(0), extent = Interval(cell.radius) + Interval(feet.radius);
    for (std::size_t c = 0; c < 3; ++c)
      square += CGAL::square(Interval(cell.center[c]) - Interval(feet.center[c]));
    const Interval distance = square_root(square) + Interval(-extent.sup(), extent.sup());
    return CGAL::square(Interval((std::max)(distance.inf(), 0.0), distance.sup())) -
        Interval(2) * x * height(cell, feet, normal);
  }

  // <X,d> for points of a cell, without its center and with it.
  static Interval extent(const Bounds& cell, const Box& d)
  {
    const Interval length = square_root(dot(d, d));
    Interval slack = Interval(cell.distance) * length;
    for (const auto* vector : {&cell.first, &cell.second})
      slack += CGAL::abs(dot({(*vector)[0], (*vector)[1], (*vector)[2]}, d));
    return Interval(-slack.sup(), slack.sup());
  }

  static Interval height(const Bounds& cell, const Box& d)
  {
    return dot({cell.center[0], cell.center[1], cell.center[2]}, d) + extent(cell, d);
  }

  // <X-F,d> for points of a cell.
  static Interval height(const Bounds& cell, const Bounds& feet, const Box& d)
  {
    Box difference;
    for (std::size_t c = 0; c < 3; ++c)
      difference[c] = Interval(cell.center[c]) - Interval(feet.center[c]);
    return dot(difference, d) + extent(cell, d) + extent(feet, d);
  }
};

} // namespace Rational_bisectors
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_INTERNAL_BALL_POWERS_H
