// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNEL_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNEL_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Curve_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/joined_edges.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Kernel_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Kernel_centre_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/kernel_elements.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Uncertain.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVisibility

The kernel of a region of the plane: the points from which all of the region is seen. It is convex: what is on the left
of all tangents of the boundary. Its own boundary, counterclockwise, consists of arcs of the curves, where these turn
left, and of segments of tangents of inflections and at ends.

\tparam Kernel_ a `SplineKernel`.
*/
template <SplineKernel Kernel_>
class Region_kernel_2
{
public:
  using Kernel = Kernel_;
  using Point = typename Kernel::Point_2;

  //! a closed range of numbers.
  using Range = std::pair<Exact_rational, Exact_rational>;

private:
  using Bounds = internal::Common::Vector_bounds<2>;

  internal::Convex_hull::Curve_parts_2 m_parts;
  std::vector<internal::Exact_pair> m_flat;   // corners of a kernel, or of a set around it, without interior
  std::optional<internal::Exact_pair> m_centre;
  std::vector<Kernel_edge_2> m_edges;
  std::vector<Bounds> m_vertices;             // the sources of edges
  bool m_may_have_interior = true, m_is_straight = true;

public:
  /*!
  the kernel of a region.
  \param region the region. One with holes, or of several parts, has no kernel, other than a point where parts touch.
  */
  explicit Region_kernel_2(const Planar_region_2<Kernel>& region)
  {
    m_may_have_interior = region.boundaries().size() == 1;
    if (!m_may_have_interior && !region.has_touching_boundaries())
      return;
    const Upward_rounding_guard guard;
    m_parts = internal::Convex_hull::Curve_parts_2(region.curves());
    std::vector<internal::Visibility::Tangent_family> tangents;
    for (const internal::Regions::Boundary_loop_2& loop : region.loops())
      for (const internal::Regions::Boundary_piece& piece : loop.pieces()) {
        tangents.emplace_back(piece);
        m_is_straight = m_is_straight && internal::Common::power_coefficients(tangents.back().curvature()).empty();
      }
    const internal::Visibility::Kernel_centre_2 centre(tangents, box_of(region));
    m_centre = centre.centre();
    if (centre.is_flat()) {
      m_may_have_interior = false;
      m_flat = centre.polygon();
    }
    if (m_centre) {
      append_edges(internal::Visibility::Kernel_boundary_2(internal::Visibility::kernel_elements(tangents, *m_centre)));
      join_arcs();
    }
  }

  //! whether no point sees all of the region; indeterminate if neither a point that does nor a proof that there is none
  //! was found.
  CGAL::Uncertain<bool> is_empty() const
  {
    const bool is_proved_empty = !m_may_have_interior && m_flat.empty(),
               is_proved_not_empty = has_interior() || (m_is_straight && !m_flat.empty());
    return {is_proved_empty, !is_proved_not_empty};
  }

  //! whether the kernel has an interior, by proof.
  bool has_interior() const { return m_centre.has_value(); }

  /*!
  the boundary: each part begins in the point where the one before ends. Arcs of a closed curve end at its seam. None if
  the kernel has no interior.
  */
  const std::vector<Kernel_edge_2>& edges() const { return m_edges; }

  //! corners of a segment, or a point, that the kernel lies in if it has no interior; it is the whole of it if all
  //! curves of the region are straight. None if it is empty.
  std::vector<Point> flat_part() const
  {
    std::vector<Point> result;
    for (const internal::Exact_pair& p : m_flat)
      result.push_back(internal::kernel_object<Kernel, Point>(p));
    return result;
  }

  //! whether all of the boundary is proved, or that the kernel is empty, or what it is if it has no interior.
  bool is_complete() const
  {
    return has_interior()
        ? std::none_of(m_edges.begin(), m_edges.end(),
                       [](const Kernel_edge_2& edge) { return edge.kind == Kernel_edge_kind::UNDECIDED; })
        : !m_may_have_interior && (m_flat.empty() || m_is_straight);
  }

  //! a point in the interior. \pre `has_interior()`
  Point centre() const
  {
    CGAL_precondition(has_interior());
    return internal::kernel_object<Kernel, Point>(*m_centre);
  }

  //! ranges of the coordinates of the point where an edge begins; each is one number where it is known exactly.
  std::array<Range, 2> source_ranges(std::size_t edge) const
  {
    const auto& [x, y] = m_vertices[edge];
    return {Range{x.lower, x.upper}, Range{y.lower, y.upper}};
  }

  //! the point at the middle of these ranges, rounded where the kernel is not exact.
  Point source(std::size_t edge) const
  {
    const auto& [x, y] = m_vertices[edge];
    return internal::kernel_object<Kernel, Point>(
        internal::Exact_pair{Exact_rational((x.lower + x.upper) / 2), Exact_rational((y.lower + y.upper) / 2)});
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
    internal::check_error(error, "Region_kernel_2");
    std::vector<Point> result{source(edge)};
    if (m_edges[edge].kind == Kernel_edge_kind::ARC)
      m_parts.append_samples<Kernel>(m_edges[edge].curve, m_edges[edge].parameter(0), m_edges[edge].parameter(1),
                                     to_rational(error), result);
    else
      result.push_back(source(after(edge)));
    return result;
  }

  /*!
  the polygon of these points of all parts, all on the boundary of the kernel but for the widths of ranges and rounding;
  empty if the kernel has no interior.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  CGAL::Polygon_2<Kernel> polygon(double error) const
  {
    internal::check_error(error, "Region_kernel_2");
    CGAL::Polygon_2<Kernel> result;
    for (std::size_t i = 0; i < m_edges.size(); ++i) {
      const std::vector<Point> points = polyline(i, error);
      result.insert(result.vertices_end(), points.begin(), points.end() - 1);
    }
    return result;
  }

  /*!
  bounds of the area; the same number twice where all vertices are known exactly and the curves are polynomial. They are
  as close as the ranges of vertices.
  \param error how far from each other the bounds may be in addition; positive.
  \pre `is_complete()`
  \throws Invalid_input when the error is not positive.
  */
  Range area(double error = 1e-12) const
  {
    internal::check_error(error, "Region_kernel_2");
    CGAL_precondition(is_complete());
    internal::Common::Rational_interval result(Exact_rational(0), Exact_rational(0));
    std::vector<internal::Regions::Boundary_piece> arcs;
    for (std::size_t i = 0; i < m_edges.size(); ++i)
      if (m_edges[i].kind == Kernel_edge_kind::ARC)
        m_parts.append_sector(m_edges[i].curve, m_edges[i].parameters[0], m_edges[i].parameters[1], *m_centre, arcs,
                              result);
      else
        result = result +
            twice_triangle(m_vertices[i], m_vertices[after(i)]) *
                internal::Common::Rational_interval(internal::Convex_hull::one_half());
    if (!arcs.empty())
      result = result + internal::Regions::Boundary_loop_2(arcs).signed_area(to_rational(error) / 2);
    return {result.lower, result.upper};
  }

private:
  using Boundary = internal::Visibility::Kernel_boundary_2;
  using Corner = Boundary::Corner;
  using Place = internal::Visibility::Kernel_element_2::Place;

  std::size_t after(std::size_t edge) const { return (edge + 1) % m_edges.size(); }

  static std::vector<internal::Exact_pair> box_of(const Planar_region_2<Kernel>& region)
  {
    CGAL::Bbox_2 box;
    for (const auto& curve : region.curves())
      box += curve.bbox();
    const Exact_rational x0 = to_rational(box.xmin()), x1 = to_rational(box.xmax()), y0 = to_rational(box.ymin()),
                         y1 = to_rational(box.ymax());
    return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
  }

  // From each corner to the next one, along one element: on its tangent at the begin, on the arc, and on its tangent at
  // the end.
  void append_edges(const Boundary& boundary)
  {
    const std::vector<Corner>& corners = boundary.corners();
    for (std::size_t c = 0; c < corners.size(); ++c) {
      const Corner &corner = corners[c], &next = corners[(c + 1) % corners.size()];
      const std::size_t i = corner.elements[1];
      const internal::Visibility::Kernel_element_2& element = boundary.elements()[i];
      const auto begin = element.range_of_end(0), end = element.range_of_end(1);
      const bool is_decided = corner.is_decided && next.is_decided && next.elements[0] == i &&
          is_one_place(corner.summits[1]) && is_one_place(next.summits[0]);
      const Bounds source = moved(corner.point);
      if (!is_decided) {
        append(Kernel_edge_kind::UNDECIDED, element, begin, end, source);
        continue;
      }
      if (element.is_line()) {
        append(Kernel_edge_kind::SEGMENT, element, begin, begin, source);
        continue;
      }
      const Place from = corner.summits[1][0].place, to = next.summits[0][0].place;
      if (from == Place::BEGIN)
        append(Kernel_edge_kind::SEGMENT, element, begin, begin, source);
      if (from != Place::END && to != Place::BEGIN) {
        const Parameters first = from == Place::BEGIN ? begin : range(corner.summits[1]),
                         last = to == Place::END ? end : range(next.summits[0]);
        append(Kernel_edge_kind::ARC, element, first, last, from == Place::BEGIN ? bounds(element, begin) : source);
      }
      if (to == Place::END)
        append(Kernel_edge_kind::SEGMENT, element, end, end, from == Place::END ? source : bounds(element, end));
    }
  }

  using Parameters = internal::Common::Parameter_range;
  using Summits = std::array<internal::Visibility::Kernel_element_2::Summit, 2>;

  static bool is_one_place(const Summits& summits) { return summits[0].place == summits[1].place; }
  static Parameters range(const Summits& summits)
  {
    return {(std::min)(summits[0].range.first, summits[1].range.first),
            (std::max)(summits[0].range.second, summits[1].range.second)};
  }

  void append(Kernel_edge_kind kind, const internal::Visibility::Kernel_element_2& element, const Parameters& first,
              const Parameters& last, const Bounds& source)
  {
    m_edges.push_back({kind, element.curve(), {element.on_curve(first), element.on_curve(last)}});
    m_vertices.push_back(source);
  }

  Bounds moved(Bounds bounds) const
  {
    for (std::size_t k = 0; k < 2; ++k)
      bounds[k] = bounds[k] + internal::Common::Rational_interval((*m_centre)[k]);
    return bounds;
  }

  // Of the points of a curve in a range.
  Bounds bounds(const internal::Visibility::Kernel_element_2& element, const Parameters& range) const
  {
    const auto [first, last] = element.on_curve(range);
    const internal::Exact_pair point = m_parts.point(element.curve(), first);
    Bounds result{internal::Common::Rational_interval(point[0]), internal::Common::Rational_interval(point[1])};
    for (const internal::Convex_hull::Hull_piece_2& piece : m_parts.between(element.curve(), first, last))
      for (const internal::Exact_pair& p : piece.points())
        for (std::size_t k = 0; k < 2; ++k)
          result[k] = hull(result[k], internal::Common::Rational_interval(p[k]));
    return result;
  }

  // Of the triangle with the centre.
  internal::Common::Rational_interval twice_triangle(const Bounds& p, const Bounds& q) const
  {
    const auto arm = [&](const Bounds& bounds, std::size_t k) {
      return bounds[k] - internal::Common::Rational_interval((*m_centre)[k]);
    };
    return arm(p, 0) * arm(q, 1) - arm(p, 1) * arm(q, 0);
  }

  // One edge for successive arcs of one curve; the first one does not go on from the last one.
  void join_arcs()
  {
    using Edge = std::pair<Kernel_edge_2, Bounds>;   // with its source
    const auto goes_on = [](const Edge& a, const Edge& b) {
      const Kernel_edge_2 &edge = a.first, &next = b.first;
      return edge.kind == Kernel_edge_kind::ARC && next.kind == Kernel_edge_kind::ARC && edge.curve == next.curve &&
          edge.parameters[1] == next.parameters[0] && edge.is_reversed() == next.is_reversed();
    };
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < m_edges.size(); ++i)
      edges.emplace_back(m_edges[i], m_vertices[i]);
    edges = internal::Regions::joined_edges(std::move(edges), goes_on, [](Edge& edge, const Edge& next) {
      edge.first.parameters[1] = next.first.parameters[1];
    });
    m_edges.clear();
    m_vertices.clear();
    for (const auto& [edge, source] : edges) {
      m_edges.push_back(edge);
      m_vertices.push_back(source);
    }
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNEL_2_H
