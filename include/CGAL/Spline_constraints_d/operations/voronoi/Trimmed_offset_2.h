// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSET_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSET_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Undecided_part_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Offset_cycles.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/arcs_of_chain.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/vertex_origin.h>

#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
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

  //! an arc: the offset of a part of a curve, or an arc of a circle around a point.
  struct Arc
  {
    /// whether it belongs to a point: an end or a corner of a curve, or an isolated point
    bool is_circular;
    Point center;                         ///< the point; of the offset of a curve, none
    /// the index of the curve; of a point, the lowest index of a curve that ends or has a joint or a crossing there; of
    /// an isolated point, no index
    std::size_t curve;
    /// of the curve, where the arc begins and ends; of a point, twice that of the point on the curve
    std::array<double, 2> parameters;
  };

  //! a boundary of the set.
  struct Boundary
  {
    std::vector<std::size_t> arcs;        ///< in order
    bool is_closed;                       ///< whether it is proved to be closed
    bool is_hole;                         ///< whether it is that of a hole of the set
    /// the index of the outer boundary of the same component of the set; if it is not known, no index
    std::size_t outer;
  };

private:
  std::shared_ptr<const internal::Voronoi::Offset_cycles> m_cycles;
  bool m_is_reversed;   // the set is on the right of the chains
  std::vector<Arc> m_arcs;
  std::vector<std::vector<std::size_t>> m_pieces_of_arc;   // which are the offsets of parts of elements
  std::vector<Boundary> m_boundaries;
  std::vector<Undecided_part_2> m_undecided;

public:
#ifndef DOXYGEN_RUNNING
  Trimmed_offset_2(std::shared_ptr<const internal::Voronoi::Offset_cycles> cycles, bool is_reversed)
    : m_cycles(std::move(cycles)), m_is_reversed(is_reversed), m_undecided(m_cycles->undecided())
  {
    const Upward_rounding_guard guard;
    for (const internal::Voronoi::Offset_cycles::Chain& chain : m_cycles->chains())
      append_boundary(chain);
  }
#endif

  //! the arcs.
  const std::vector<Arc>& arcs() const { return m_arcs; }

  //! the boundaries; each arc belongs to one.
  const std::vector<Boundary>& boundaries() const { return m_boundaries; }

  //! whether all of the offset is proved.
  bool is_complete() const { return m_undecided.empty(); }

  //! the parts of curves, in order, beside which the offset is not proved: it is not known whether their points are
  //! nearest to points of the offset, which boundary goes on there, or which one is around the other. Of points that
  //! were offset with the curves there is no index, and both numbers are 0. If curves are not proved to be disjoint,
  //! all of each curve.
  const std::vector<Undecided_part_2>& undecided() const { return m_undecided; }

  /*!
  points along an arc, so many that it is no farther from the lines of their chords than a given distance, up to
  rounding of the points.

  \param arc the index of the arc.
  \param error the distance; positive.
  \throws Invalid_input when the error is not positive.
  */
  std::vector<Point> polyline(std::size_t arc, double error) const
  {
    internal::check_error(error, "Trimmed_offset_2");
    const Upward_rounding_guard guard;
    std::vector<Point> result;
    for (const std::size_t p : m_pieces_of_arc[arc]) {
      const internal::Voronoi::Offset_cycles::Piece& piece = m_cycles->pieces()[p];
      const internal::Voronoi::Element_offset offset = m_cycles->offset(piece);
      const auto [begin, end] = parameters(piece);
      const std::vector<double> stops = offset.stops(begin, end, error);
      for (std::size_t i = result.empty() ? 0 : 1; i < stops.size(); ++i)
        result.push_back(middle(offset.point({stops[i], stops[i]})));
    }
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
        m_boundaries, [&](std::size_t b) { return polygon(m_boundaries[b], error); });
  }

private:
  static Point middle(const internal::Common::Interval_pair& p)
  {
    return internal::kernel_object<Kernel, Point>(
        std::array<double, 2>{p[0].inf() / 2 + p[0].sup() / 2, p[1].inf() / 2 + p[1].sup() / 2});
  }

  std::array<double, 2> parameters(const internal::Voronoi::Offset_cycles::Piece& piece) const
  {
    const auto [from, to] = m_cycles->parameters(piece);
    return m_is_reversed ? std::array{to, from} : std::array{from, to};
  }

  CGAL::Polygon_2<Kernel> polygon(const Boundary& boundary, double error) const
  {
    CGAL::Polygon_2<Kernel> result;
    for (const std::size_t arc : boundary.arcs) {
      const std::vector<Point> points = polyline(arc, error);
      result.insert(result.vertices_end(), points.begin() + 1, points.end());   // the first one ends the arc before
    }
    return result;
  }

  Arc arc_of(std::size_t p) const
  {
    const internal::Voronoi::Offset_cycles::Piece& piece = m_cycles->pieces()[p];
    const internal::Voronoi::Oriented_element<>& element = m_cycles->element(piece);
    const internal::Voronoi::Site_graph_2<>& graph = m_cycles->graph();
    if (element.is_normal_cone) {
      const auto [curve, parameter] = internal::Voronoi::vertex_origin(graph, element.object)
                                          .value_or(std::pair(internal::Voronoi::Offset_cycles::none, 0.));
      return {true,
              internal::kernel_object<Kernel, Point>(graph.vertices()[element.object].exact_point),
              curve,
              {parameter, parameter}};
    }
    const auto [begin, end] = parameters(piece);
    return {false,
            Point(0, 0),
            graph.curve_of_arc(element.object),
            {graph.curve_parameter(element.object, begin), graph.curve_parameter(element.object, end)}};
  }

  // Whether a piece goes on where another one ends, around the same point, or with the same curve on the same side.
  bool goes_on(std::size_t before, std::size_t after) const
  {
    const internal::Voronoi::Oriented_element<> &a = m_cycles->element(m_cycles->pieces()[before]),
          &b = m_cycles->element(m_cycles->pieces()[after]);
    if (a.is_normal_cone || b.is_normal_cone)
      return before != after && a.is_normal_cone && b.is_normal_cone && a.object == b.object;
    return a.is_reversed == b.is_reversed && arc_of(before).curve == arc_of(after).curve &&
        arc_of(before).parameters[1] == arc_of(after).parameters[0];
  }

  void append_boundary(const internal::Voronoi::Offset_cycles::Chain& chain)
  {
    std::vector<std::size_t> pieces = chain.pieces;
    if (m_is_reversed)
      std::reverse(pieces.begin(), pieces.end());
    Boundary boundary{{}, chain.is_closed, chain.is_hole, chain.outer};
    for (std::vector<std::size_t>& arc : internal::Voronoi::arcs_of_chain(
             pieces, chain.is_closed, [&](std::size_t before, std::size_t after) { return goes_on(before, after); })) {
      boundary.arcs.push_back(m_arcs.size());
      m_arcs.push_back(arc_of(arc.front()));
      m_arcs.back().parameters[1] = arc_of(arc.back()).parameters[1];
      m_pieces_of_arc.push_back(std::move(arc));
    }
    m_boundaries.push_back(std::move(boundary));
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSET_2_H
