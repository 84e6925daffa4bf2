// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_sample.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/Minkowski_sum_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_of_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Sum_model_2.h>
#endif

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/Uncertain.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

The Minkowski sum of two regions, or of a region and a curve: all sums of a point of one and a point of the other. A
region, whose boundaries consist of arcs that are sums of points of two curves with the same direction. It is the result
of `minkowski_sum()` and `swept_area()`.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Minkowski_sum_2
{
public:
  using Point = typename Kernel::Point_2;
  using Sample = Curve_pair_sample<Kernel>;
  using Arc = Minkowski_sum_arc_2;
  using Boundary = Minkowski_sum_boundary_2;

private:
  internal::Minkowski_sum::Sum_of_regions_2 m_sum;

public:
  //! a sum that an operation has found.
  explicit Minkowski_sum_2(internal::Minkowski_sum::Sum_of_regions_2 sum) : m_sum(std::move(sum)) {}

  //! the boundaries; those that are known, if the sum is not complete.
  const std::vector<Boundary>& boundaries() const { return m_sum.boundaries; }

  //! whether these are all, by proof.
  bool is_complete() const { return m_sum.undecided.empty(); }

  /*!
  what is not decided: boxes in the plane, outside of which the boundaries are proved. Within them there may be others,
  or an arc may be inside of the sum. When a limit was reached, or the visitor stopped the run, before any part of the
  boundary was known, there is one box around the whole sum; so there is when an operand is a region that is not
  complete, with the parameters of its curves. The parameters are about those of the points of both
  operands; curves of the second operand are counted behind those of the first one.
  */
  const std::vector<Undecided_part>& undecided() const { return m_sum.undecided; }

  //! the work; a node is what is done between two questions whether to go on.
  const Summary& summary() const { return m_sum.summary; }

  //! whether a point is inside of the sum; indeterminate on the boundary, and where it is not decided. This does not
  //! use the boundaries.
  CGAL::Uncertain<bool> has_in_interior(const Point& point) const
  {
    if (m_sum.model == nullptr)
      return CGAL::Uncertain<bool>::indeterminate();
    return internal::Minkowski_sum::has_in_interior(
        *m_sum.model, internal::Exact_pair{internal::converted_number<Exact_rational>(point.x()),
                                           internal::converted_number<Exact_rational>(point.y())});
  }

  /*!
  points along an arc of a boundary, so many that their chords are proved to be no farther from the arc than a given
  distance, and the arc from them. An arc is halved at most 20 times.
  \param boundary the index of the boundary.
  \param arc the index of the arc there.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t boundary, std::size_t arc, double error) const
  {
    internal::check_error(error, "Minkowski_sum_2");
    std::vector<Sample> result;
    for (const auto& [point, parameters] :
         internal::Minkowski_sum::samples_along_arc(*m_sum.model, boundary, arc, error))
      result.push_back({internal::kernel_object<Kernel, Point>(point), parameters});
    return result;
  }

  /*!
  polygons next to the sum, one for each part: the boundaries as polylines. Those that are not closed, or whose outer
  boundary is not known, are left out. Boundaries that touch themselves do so in a point that is a vertex of the polygon
  twice, up to rounding.
  \param error the error of the polylines, as of `polyline()`, up to rounding in vertices between arcs; positive. They
  do not meet otherwise if it is small enough.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> polygons_with_holes(double error) const
  {
    internal::check_error(error, "Minkowski_sum_2");
    return internal::Regions::polygons_of_parts<CGAL::Polygon_with_holes_2<Kernel>>(boundaries(), [&](std::size_t b) {
      CGAL::Polygon_2<Kernel> polygon;
      for (const auto& p : internal::Minkowski_sum::points_along_boundary(*m_sum.model, b, error))
        polygon.push_back(internal::kernel_object<Kernel, Point>(p));
      return polygon;
    });
  }

  //! puts these polygons to an output iterator.
  template <std::output_iterator<CGAL::Polygon_with_holes_2<Kernel>> OutputIterator>
  OutputIterator polygons_with_holes(double error, OutputIterator out) const
  {
    return std::ranges::copy(polygons_with_holes(error), out).out;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_2_H
