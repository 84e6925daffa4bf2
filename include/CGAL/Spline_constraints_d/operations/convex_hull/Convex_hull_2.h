// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULL_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULL_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/joined_edges.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/assertions.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
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
  internal::Convex_hull::Curve_parts_2 m_parts;
  std::vector<internal::Exact_pair> m_points;
  std::vector<Hull_edge_2> m_edges;
  Summary m_summary;

public:
  /*!
  the hull of these curves and points.
  \param curves the curves.
  \param points the points.
  \param options those of the solver; limits hold for the operation as a whole.
  \throws Invalid_input when there are neither curves nor points, a coordinate is not finite, or an option makes no
  sense.
  */
  Convex_hull_2(const std::vector<Curve>& curves, const std::vector<Point>& points, const Solver_options& options = {})
  {
    if (curves.empty() && points.empty())
      throw Invalid_input("Convex_hull_2: there are neither curves nor points");
    const Upward_rounding_guard guard;
    m_parts = internal::Convex_hull::Curve_parts_2(curves);
    std::map<internal::Exact_pair, Boundary_vertex_2> isolated;
    for (const Point& point : points) {
      m_points.push_back({internal::converted_number<Exact_rational>(point.x()),
                          internal::converted_number<Exact_rational>(point.y())});
      isolated.try_emplace(m_points.back(), Boundary_vertex_2{curves.size() + m_points.size() - 1, {}});
    }
    const internal::Convex_hull::Hull_boundary_2 boundary(m_parts.pieces(), std::move(isolated), options);
    m_edges = with_joined_arcs(boundary.edges());
    m_summary = boundary.work();
    m_summary.is_complete = is_complete();
  }

  /*!
  the boundary: each part begins in the point where the one before ends, which may be on two curves. Arcs of a closed
  curve end at its seam. The hull of one point has one segment, from this point to itself; one that is a segment has two
  of them.
  */
  const std::vector<Hull_edge_2>& edges() const { return m_edges; }

  //! whether no part of the boundary is undecided.
  bool is_complete() const
  {
    return std::none_of(m_edges.begin(), m_edges.end(),
                        [](const Hull_edge_2& edge) { return edge.kind == Hull_edge_kind::UNDECIDED; });
  }

  //! the work of the solver.
  const Summary& summary() const { return m_summary; }

  //! the point at the middle of the range of parameters, rounded where the kernel is not exact.
  Point point(const Boundary_vertex_2& vertex) const
  {
    return internal::kernel_object<Kernel, Point>(exact_point(vertex.curve, vertex.parameter()));
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
    const auto& [kind, source, target] = m_edges[edge];
    std::vector<Point> result{point(source)};
    if (kind == Hull_edge_kind::ARC)
      m_parts.append_samples<Kernel>(source.curve, source.parameter(), target.parameter(), to_rational(error), result);
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
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
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
    std::vector<internal::Regions::Boundary_piece> arcs;
    Exact_rational twice_polygon(0), twice_rest(0);
    for (std::size_t i = 0; i < m_edges.size(); ++i)
      if (m_edges[i].kind == Hull_edge_kind::ARC)
        for (const internal::Convex_hull::Hull_piece_2& piece :
             m_parts.between(m_edges[i].source.curve, certain_end(i, 0), certain_end(i, 1)))
          arcs.push_back(piece.curve());
      else {
        const auto [begin, end] = certain_segment(i);
        twice_polygon += internal::exact_cross(begin, end);
        twice_rest += twice_area_beside_segment(i);
      }
    const internal::Common::Rational_interval below_arcs = arcs.empty()
        ? internal::Common::Rational_interval(Exact_rational(0))
        : internal::Regions::Boundary_loop_2(arcs).signed_area(to_rational(error) / 2);
    return {Exact_rational(below_arcs.lower + twice_polygon / 2),
            Exact_rational(below_arcs.upper + (twice_polygon + twice_rest) / 2)};
  }

private:
  // One edge for successive arcs of one curve; the first one does not go on from the last one.
  static std::vector<Hull_edge_2> with_joined_arcs(std::vector<Hull_edge_2> edges)
  {
    const auto goes_on = [](const Hull_edge_2& edge, const Hull_edge_2& next) {
      return edge.kind == Hull_edge_kind::ARC && next.kind == Hull_edge_kind::ARC &&
          edge.target.curve == next.source.curve && edge.target.parameters == next.source.parameters &&
          edge.is_reversed() == next.is_reversed();
    };
    return internal::Regions::joined_edges(
        std::move(edges), goes_on, [](Hull_edge_2& edge, const Hull_edge_2& next) { edge.target = next.target; });
  }

  internal::Exact_pair exact_point(std::size_t curve, const Exact_rational& parameter) const
  {
    return curve < m_parts.number_of_curves() ? m_parts.point(curve, parameter)
                                              : m_points[curve - m_parts.number_of_curves()];
  }

  // The parameter of the begin or end of an arc such that all before it, or after it, is on the boundary.
  const Exact_rational& certain_end(std::size_t i, int end) const
  {
    const Hull_edge_2& edge = m_edges[i];
    const auto& [lower, upper] = (end == 0 ? edge.source : edge.target).parameters;
    return edge.is_reversed() == (end == 0) ? lower : upper;
  }

  std::size_t before(std::size_t i) const { return (i + m_edges.size() - 1) % m_edges.size(); }
  std::size_t after(std::size_t i) const { return (i + 1) % m_edges.size(); }

  // Where the arcs next to a segment certainly belong to the boundary; points that are known exactly where there are no
  // arcs.
  std::array<internal::Exact_pair, 2> certain_segment(std::size_t i) const
  {
    const auto end = [&](const Boundary_vertex_2& vertex, std::size_t neighbour, int side) {
      return m_edges[neighbour].kind == Hull_edge_kind::ARC
          ? exact_point(m_edges[neighbour].source.curve, certain_end(neighbour, side))
          : exact_point(vertex.curve, vertex.parameter());
    };
    return {end(m_edges[i].source, before(i), 1), end(m_edges[i].target, after(i), 0)};
  }

  // A bound for what is between that segment and the boundary: the hull of its ends and the parts of the arcs where
  // these may end.
  Exact_rational twice_area_beside_segment(std::size_t i) const
  {
    using Exact_point = internal::Exact_kernel::Point_2;
    std::vector<Exact_point> points, hull;
    for (const internal::Exact_pair& p : certain_segment(i))
      points.emplace_back(p[0], p[1]);
    for (const Boundary_vertex_2& vertex : {m_edges[i].source, m_edges[i].target})
      if (vertex.parameters.first < vertex.parameters.second)
        for (const internal::Convex_hull::Hull_piece_2& piece :
             m_parts.between(vertex.curve, vertex.parameters.first, vertex.parameters.second))
          for (const internal::Exact_pair& p : piece.points())
            points.emplace_back(p[0], p[1]);
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    Exact_rational result(0);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Exact_point &p = hull[k], &q = hull[(k + 1) % hull.size()];
      result += p.x() * q.y() - q.x() * p.y();
    }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULL_2_H
