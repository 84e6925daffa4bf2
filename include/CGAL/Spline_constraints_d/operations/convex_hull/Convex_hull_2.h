// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULL_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULL_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_of_curves_2.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/hull_of_curves.h>
#endif

#include <CGAL/Polygon_2.h>
#include <CGAL/assertions.h>

#include <concepts>
#include <cstddef>
#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDConvexHulls

The convex hull of curves and points in the plane: its boundary, counterclockwise, of arcs of the curves and segments
that touch them.

\tparam Kernel_ a `SplineKernel`.
*/
template <SplineKernel Kernel_>
class Convex_hull_2
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_2;
  using Curve = Bspline_curve_2<Kernel>;

private:
  internal::Convex_hull::Hull_of_curves_2 m_hull;

public:
  /*!
  the hull of these curves and points.
  \param curves a range of curves.
  \param points a range of points.
  \param options those of the solver; limits hold for the operation as a whole.
  \throws Invalid_input when there are neither curves nor points, a coordinate is not finite, or an option makes no
  sense.
  */
  template <std::ranges::input_range Curves, std::ranges::input_range Points = std::vector<Point>>
    requires std::convertible_to<std::ranges::range_value_t<Curves>, Bspline_curve_2<Kernel_>>
  explicit Convex_hull_2(const Curves& curves, const Points& points = {}, const Solver_options& options = {})
  {
    const std::vector<Curve> splines(std::ranges::begin(curves), std::ranges::end(curves));
    const auto pieces = internal::Regions::pieces_of_curves(splines);
    std::vector<internal::Exact_pair> exact_points;
    for (const Point& point : points)
      exact_points.push_back({internal::converted_number<Exact_rational>(point.x()),
                              internal::converted_number<Exact_rational>(point.y())});
    if (pieces.empty() && exact_points.empty())
      throw Invalid_input("Convex_hull_2: there are neither curves nor points");
    m_hull = internal::Convex_hull::hull_of_curves(pieces, std::move(exact_points), options);
  }

  /*!
  the boundary: each part begins in the point where the one before ends, which may be on two curves. Arcs of a closed
  curve end at its seam. The hull of one point has one segment, from this point to itself; one that is a segment has two
  of them. There are none when a limit was reached before there were any.
  */
  const std::vector<Hull_edge_2>& edges() const { return m_hull.edges; }

  //! whether no part of the boundary is undecided.
  bool is_complete() const { return m_hull.undecided.empty(); }

  //! where the boundary is undecided: boxes that hold what it may be there, with the parts of curves that may belong to
  //! it. When a limit was reached, or the visitor stopped the run, before there were edges, one box around the hull.
  const std::vector<Undecided_part>& undecided() const { return m_hull.undecided; }

  //! the work; nodes are those of the solver, and steps between two questions whether to go on.
  const Summary& summary() const { return m_hull.summary; }

  //! the point at the middle of the range of parameters, rounded where the kernel is not exact.
  Point point(const Boundary_vertex_2& vertex) const
  {
    return internal::kernel_object<Kernel, Point>(m_hull.point(vertex.curve, vertex.parameter()));
  }

  /*!
  points along a part of the boundary, from its source to its target, so that no point of it is farther from the chords
  between them than a given distance, but for the rounding of coordinates.
  \param edge the index of the part.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Point> polyline(std::size_t edge, double error) const
  {
    internal::check_error(error, "Convex_hull_2");
    const auto& [kind, source, target] = m_hull.edges[edge];
    std::vector<Point> result{point(source)};
    if (kind == Hull_edge_kind::ARC)
      m_hull.parts.append_samples<Kernel>(source.curve, source.parameter(), target.parameter(), to_rational(error),
                                          result);
    else
      result.push_back(point(target));
    return result;
  }

  /*!
  the polygon of these points of all parts; its vertices are on the boundary, and the boundary is nowhere farther from
  it, but for the rounding of coordinates.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  CGAL::Polygon_2<Kernel> polygon(double error) const
  {
    internal::check_error(error, "Convex_hull_2");
    CGAL::Polygon_2<Kernel> result;
    for (std::size_t i = 0; i < m_hull.edges.size(); ++i) {
      const std::vector<Point> points = polyline(i, error);
      for (std::size_t k = 0; k + 1 < points.size(); ++k)
        result.push_back(points[k]);
    }
    return result;
  }

  /*!
  bounds of the area; the same number twice where all vertices are known exactly and the curves are polynomial. They are
  as close as the ranges of the parameters of vertices.
  \param error how far from each other the bounds may be in addition; positive.
  \pre `is_complete()`
  \throws Invalid_input when the error is not positive.
  */
  std::pair<Exact_rational, Exact_rational> area(double error = 1e-12) const
  {
    internal::check_error(error, "Convex_hull_2");
    CGAL_precondition(is_complete());
    return internal::Convex_hull::area_of_hull(m_hull, error);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULL_2_H
