// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_PROPER_REPARAMETRIZATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_PROPER_REPARAMETRIZATION_H

#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDCurveProperness

A range of the parameter of a curve on which it runs along one component of its image, once and in one direction.
*/
struct Curve_stretch
{
  //! a number, or an enclosure of an irrational one.
  using Range = std::pair<Exact_rational, Exact_rational>;

  Range begin, end;             ///< the ends of the range
  std::size_t component;        ///< the index of the component
  int index;                    ///< the tracing index of the polynomial or rational piece
  Polynomial_quotient h;        ///< the curve is the component after this function of its parameter
  Range image_begin, image_end; ///< the parameters of the component at `begin` and `end`
  bool is_reversed;             ///< whether it is run against its direction
};

/*!
\ingroup PkgSplineConstraintsDCurveProperness

A part of the range of the parameter of a component, with the number of stretches that run over it.
*/
struct Covered_range
{
  Curve_stretch::Range begin, end; ///< numbers, or enclosures of irrational ones
  int times;                       ///< how often
};

/*!
\ingroup PkgSplineConstraintsDCurveProperness

A part of the image of a curve, as a curve of its own.
*/
template <int d>
struct Proper_component
{
  Bspline_curve<internal::Exact_kernel, d> curve; ///< proper, of the lowest degree that is possible
  int degree;                                     ///< that of the map
  bool is_closed;                                 ///< whether it is a whole algebraic curve, and closed
  std::vector<Covered_range> coverage;            ///< in order
};

/*!
\ingroup PkgSplineConstraintsDCurveProperness

What `proper_reparametrization()` tells of a curve \f$c\f$: curves \f$\tilde c\f$ that take almost no point twice, and
for each stretch of the curve a function \f$h\f$ with \f$c = \tilde c \circ h\f$.

Where a component is closed as a whole, its parameter is \f$h(t)\f$ from -1 to 1, and \f$2 - 1/h(t)\f$ from 1 to 3.
*/
template <int d>
struct Proper_reparametrization
{
  std::vector<Proper_component<d>> components; ///< parts of the image that are apart in their parameters
  std::vector<Curve_stretch> stretches;        ///< in the order of the curve's parameter
  std::vector<Undecided_part> unfinished = {}; ///< see `undecided()`
  Summary work = {};                           ///< see `summary()`

  //! the greatest tracing index of a stretch; 0 when the run was stopped.
  int tracing_index() const
  {
    int result = 0;
    for (const Curve_stretch& stretch : stretches)
      result = (std::max)(result, stretch.index);
    return result;
  }

  //! the parameters of the curve at which it turns back on its own image.
  std::vector<Curve_stretch::Range> folds() const
  {
    std::vector<Curve_stretch::Range> result;
    for (std::size_t i = 1; i < stretches.size(); ++i) {
      const Curve_stretch &before = stretches[i - 1], &after = stretches[i];
      if (before.component == after.component && before.is_reversed != after.is_reversed &&
          before.image_end == after.image_begin)
        result.push_back(after.begin);
    }
    return result;
  }

  //! how often the curve runs over the part of its image that it runs over most often.
  int times() const
  {
    int result = 0;
    for (const Proper_component<d>& component : components)
      for (const Covered_range& range : component.coverage)
        result = (std::max)(result, range.times);
    return result;
  }

  //! whether all of the curve was looked at: unless a limit was reached or the visitor stopped the run.
  bool is_complete() const { return work.is_complete; }

  //! the range of the curve, if it was not looked at.
  const std::vector<Undecided_part>& undecided() const { return unfinished; }

  //! the work; a node is a polynomial piece.
  const Summary& summary() const { return work; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_PROPER_REPARAMETRIZATION_H
