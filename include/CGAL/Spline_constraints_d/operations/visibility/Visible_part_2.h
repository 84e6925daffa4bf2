// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PART_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PART_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_operand.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_of_curves_2.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/visibility/internal/sight_of_curves.h>
#endif

#include <CGAL/Polygon_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVisibility

What is seen from a point between curves in the plane: all points that a segment joins to the viewpoint without crossing
a curve. Its boundary, counterclockwise, consists of arcs of curves, and of segments of rays.

\tparam Kernel_ a `SplineKernel`.
*/
template <SplineKernel Kernel_>
class Visible_part_2
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_2;
  using Curve = Bspline_curve_2<Kernel>;

private:
  internal::Visibility::Sight_of_curves_2 m_sight;

public:
  /*!
  what is seen of these curves.
  \param viewpoint the point.
  \param curves a range of curves.
  \param options limits, for the operation as a whole, a visitor, and those of the solver that looks for crossings of
  curves.
  \throws Invalid_input when there are no curves, a coordinate is not finite, an option makes no sense, or the viewpoint
  is on a curve at a parameter that is not rational.
  */
  template <std::ranges::input_range Curves>
    requires std::convertible_to<std::ranges::range_value_t<Curves>, Bspline_curve_2<Kernel_>>
  Visible_part_2(const Point& viewpoint, const Curves& curves, const Solver_options& options = {})
  {
    const std::vector<Curve> splines(std::ranges::begin(curves), std::ranges::end(curves));
    const auto pieces = internal::Regions::pieces_of_curves(splines);
    if (pieces.empty())
      throw Invalid_input("Visible_part_2: there are no curves");
    std::vector<internal::Common::Spline_patch<2>> patches;
    for (const Curve& curve : splines)
      patches.emplace_back(curve);
    m_sight = internal::Visibility::sight_of_curves({internal::converted_number<Exact_rational>(viewpoint.x()),
                                                     internal::converted_number<Exact_rational>(viewpoint.y())},
                                                    patches, pieces, options);
  }

  /*!
  the boundary, counterclockwise around the viewpoint: each part begins in the point where the one before ends, which
  may be on two curves. Arcs of a closed curve end at its seam. There are none if no curve is seen. Where the viewpoint
  is an end or a point of a curve, arcs end in it.
  */
  const std::vector<Visible_edge_2>& edges() const { return m_sight.edges; }

  //! whether no part of the boundary is undecided.
  bool is_complete() const { return m_sight.undecided.empty(); }

  //! what is not decided: the box around all curves and the viewpoint, with the parts of two curves between which the
  //! boundary is not known; without these, where nothing is known.
  const std::vector<Undecided_part>& undecided() const { return m_sight.undecided; }

  //! whether a curve is seen in all directions.
  bool is_bounded() const
  {
    return !m_sight.edges.empty() &&
        std::none_of(m_sight.edges.begin(), m_sight.edges.end(),
                     [](const Visible_edge_2& edge) { return edge.kind == Visible_edge_kind::OPEN; });
  }

  //! the work; nodes are those of the solver, and steps between two questions whether to go on.
  const Summary& summary() const { return m_sight.summary; }

  //! the point at the middle of the range of parameters, rounded where the kernel is not exact.
  Point point(const Boundary_vertex_2& vertex) const
  {
    return internal::kernel_object<Kernel, Point>(m_sight.parts.point(vertex.curve, vertex.parameter()));
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
    internal::check_error(error, "Visible_part_2");
    const auto& [kind, source, target] = m_sight.edges[edge];
    std::vector<Point> result{point(source)};
    if (kind == Visible_edge_kind::ARC)
      m_sight.parts.append_samples<Kernel>(source.curve, source.parameter(), target.parameter(), to_rational(error),
                                           result);
    else
      result.push_back(point(target));
    return result;
  }

  /*!
  the polygon of these points of all parts, and of the viewpoint between rays where no curve is seen: the visibility
  polygon, within a distance.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  CGAL::Polygon_2<Kernel> polygon(double error) const
  {
    internal::check_error(error, "Visible_part_2");
    CGAL::Polygon_2<Kernel> result;
    const auto append = [&](const Point& point) {
      if (result.is_empty() || point != result[result.size() - 1])
        result.push_back(point);
    };
    for (std::size_t i = 0; i < m_sight.edges.size(); ++i) {
      std::vector<Point> points = polyline(i, error);
      if (m_sight.edges[i].kind == Visible_edge_kind::OPEN)
        points.insert(points.begin() + 1, internal::kernel_object<Kernel, Point>(m_sight.viewpoint));
      for (const Point& point : points)
        append(point);
    }
    if (result.size() > 1 && result[0] == result[result.size() - 1])
      result.erase(result.vertices_end() - 1);
    return result;
  }

  /*!
  bounds of the area of all that is seen, between the viewpoint and the curves: the same number twice where all vertices
  are known exactly and the curves are polynomial. They are as close as the ranges of the parameters of vertices.
  \param error how far from each other the bounds may be in addition; positive.
  \pre `is_complete()`
  \throws Invalid_input when the error is not positive.
  */
  std::pair<Exact_rational, Exact_rational> area(double error = 1e-12) const
  {
    internal::check_error(error, "Visible_part_2");
    CGAL_precondition(is_complete());
    return internal::Visibility::area_of_sight(m_sight, error);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PART_2_H
