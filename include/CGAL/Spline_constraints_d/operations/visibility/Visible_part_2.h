// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PART_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PART_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/intersections/pairwise_intersections.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_sweep_2.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
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
  internal::Exact_pair m_viewpoint;
  internal::Convex_hull::Curve_parts_2 m_parts;
  std::vector<Visible_edge_2> m_edges;
  Summary m_summary;

public:
  /*!
  what is seen of these curves.
  \param viewpoint the point.
  \param curves the curves.
  \param options those of the solver that looks for crossings of curves.
  \throws Invalid_input when there are no curves, a coordinate is not finite, an option makes no sense, or the viewpoint
  is on a curve at a parameter that is not rational.
  */
  Visible_part_2(const Point& viewpoint, const std::vector<Curve>& curves, const Solver_options& options = {})
    : m_viewpoint{internal::converted_number<Exact_rational>(viewpoint.x()),
                  internal::converted_number<Exact_rational>(viewpoint.y())}
  {
    if (curves.empty())
      throw Invalid_input("Visible_part_2: there are no curves");
    const auto meetings = pairwise_intersections(curves, options, Self_intersections::INCLUDED);
    const Upward_rounding_guard guard;
    std::vector<internal::Visibility::Sight_crossing> crossings;
    for (const auto& pair : meetings.pairs())
      for (const auto& meeting : pair.intersections)
        crossings.push_back(
            {meeting.kind(), {pair.first, pair.second}, {meeting.parameter_range(0), meeting.parameter_range(1)}});
    m_parts = internal::Convex_hull::Curve_parts_2(curves);
    const internal::Visibility::Sight_sweep_2 sweep(m_parts, m_viewpoint, std::move(crossings));
    m_edges = sweep.edges();
    m_summary = meetings.summary();
    m_summary.is_complete = sweep.is_complete();
  }

  /*!
  the boundary, counterclockwise around the viewpoint: each part begins in the point where the one before ends, which
  may be on two curves. Arcs of a closed curve end at its seam. There are none if no curve is seen. Where the viewpoint
  is an end or a point of a curve, arcs end in it.
  */
  const std::vector<Visible_edge_2>& edges() const { return m_edges; }

  //! whether no part of the boundary is undecided.
  bool is_complete() const { return m_summary.is_complete; }

  //! whether a curve is seen in all directions.
  bool is_bounded() const
  {
    return !m_edges.empty() && std::none_of(m_edges.begin(), m_edges.end(), [](const Visible_edge_2& edge) {
      return edge.kind == Visible_edge_kind::OPEN;
    });
  }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }

  //! the point at the middle of the range of parameters, rounded where the kernel is not exact.
  Point point(const Boundary_vertex_2& vertex) const
  {
    return internal::kernel_object<Kernel, Point>(m_parts.point(vertex.curve, vertex.parameter()));
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
    const auto& [kind, source, target] = m_edges[edge];
    std::vector<Point> result{point(source)};
    if (kind == Visible_edge_kind::ARC)
      m_parts.append_samples<Kernel>(source.curve, source.parameter(), target.parameter(), to_rational(error), result);
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
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
      std::vector<Point> points = polyline(i, error);
      if (m_edges[i].kind == Visible_edge_kind::OPEN)
        points.insert(points.begin() + 1, internal::kernel_object<Kernel, Point>(m_viewpoint));
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
    internal::Common::Rational_interval result(Exact_rational(0), Exact_rational(0));
    std::vector<internal::Regions::Boundary_piece> arcs;
    for (const Visible_edge_2& edge : m_edges)
      if (edge.kind == Visible_edge_kind::ARC)
        m_parts.append_sector(edge.source.curve, edge.source.parameters, edge.target.parameters, m_viewpoint, arcs,
                              result);
    if (!arcs.empty())
      result = result + internal::Regions::Boundary_loop_2(arcs).signed_area(to_rational(error) / 2);
    return {result.lower, result.upper};
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PART_2_H
