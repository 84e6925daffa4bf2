// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSET_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSET_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/curve_offsets.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_parts_2.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Polygon_with_holes_2.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

A trimmed offset: the boundary of the set of all points at no more than a given distance from curves and points, or,
within a region, at no less than that from its boundary.

It consists of closed boundaries, each of offsets of parts of curves, and of arcs of circles around points, in order.
The set is on their left: outer boundaries are counterclockwise, holes clockwise.

Arcs are connected by proof, and boundaries are proved to be outer ones or holes. A boundary may touch itself or another
one in points, but does not cross it: offsets that touch are connected as those at a distance that is a little greater.
Where something is not decided, `is_complete()` is false, and `undecided()` tells where that is; boundaries that are
affected are not closed.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Trimmed_offset_2
{
public:
  using Point = typename Kernel::Point_2;
  using Polygon_with_holes = CGAL::Polygon_with_holes_2<Kernel>;

  using Boundary = Trimmed_offset_boundary_2;

  //! an arc: the offset of a part of a curve, or an arc of a circle around a point.
  struct Arc
  {
    /// whether it belongs to a point: an end or a corner of a curve, or an isolated point
    bool is_circular;
    std::optional<Point> center;          ///< the point; of the offset of a curve, none
    /// the index of the curve; of a point, the lowest index of a curve that ends or has a joint or a crossing there; of
    /// an isolated point, none
    std::optional<std::size_t> curve;
    /// of the curve, where the arc begins and ends; of a point of a curve, twice its own one
    std::array<double, 2> parameters;
  };

private:
  internal::Voronoi::Curve_offset m_offset;
  std::vector<Arc> m_arcs;

public:
  //! an offset without boundaries. Others are made by `trimmed_offset()`.
  Trimmed_offset_2() = default;

  //! an offset that an operation has found.
  explicit Trimmed_offset_2(internal::Voronoi::Curve_offset offset) : m_offset(std::move(offset))
  {
    for (const auto& [center, curve, parameters] : m_offset.arcs) {
      m_arcs.push_back({center.has_value(), std::nullopt, curve, parameters});
      if (center)
        m_arcs.back().center = internal::kernel_object<Kernel, Point>(*center);
    }
  }

  //! the arcs.
  const std::vector<Arc>& arcs() const { return m_arcs; }

  //! the boundaries; each arc belongs to one.
  const std::vector<Boundary>& boundaries() const { return m_offset.boundaries; }

  //! whether all of the offset is proved.
  bool is_complete() const { return m_offset.summary.is_complete; }

  //! the parts of curves and points, in order, beside which the offset is not proved: it is not known whether their
  //! points are nearest to points of the offset, which boundary goes on there, or which one is around the other.
  //! Operands are the curves and behind them the points, as they were given; points have no ranges. If curves are not
  //! proved to be disjoint, all of each curve. The place holds the offset of the part; it is not known if the search
  //! was ended before the sites were.
  const std::vector<Undecided_part>& undecided() const { return m_offset.undecided; }

  //! the work; nodes are the ranges of curves and of normals in their ends that were looked at.
  const Summary& summary() const { return m_offset.summary; }

  /*!
  points along an arc, so many that it is no farther from the lines of their chords than a given distance, up to
  rounding of the points.

  \param arc the index of the arc.
  \param error the distance; positive.
  \throws Invalid_input when there is no such arc, or the error is not positive.
  */
  std::vector<Point> polyline(std::size_t arc, double error) const
  {
    std::vector<Point> result;
    for (const std::array<double, 2>& point : internal::Voronoi::points_of_arc(m_offset, arc, error))
      result.push_back(internal::kernel_object<Kernel, Point>(point));
    return result;
  }

  /*!
  the set as polygons, one for each component, with chords of the arcs as edges: if the error is small enough for these
  not to meet elsewhere, the polygons are simple. Boundaries that are not closed, or whose component is not known, are
  left out.

  \param error the distance of arcs from the lines of their chords, at most; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Polygon_with_holes> polygons_with_holes(double error) const
  {
    internal::check_error(error, "Trimmed_offset_2");
    return internal::Regions::polygons_of_parts<Polygon_with_holes>(
        boundaries(), [&](std::size_t b) { return polygon(boundaries()[b], error); });
  }

private:
  CGAL::Polygon_2<Kernel> polygon(const Boundary& boundary, double error) const
  {
    CGAL::Polygon_2<Kernel> result;
    for (const std::size_t arc : boundary.arcs) {
      const std::vector<Point> points = polyline(arc, error);
      result.insert(result.vertices_end(), points.begin() + 1, points.end());   // the first one ends the arc before
    }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSET_2_H
