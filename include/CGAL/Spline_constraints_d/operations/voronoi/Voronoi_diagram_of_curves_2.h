// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAM_OF_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAM_OF_CURVES_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_cell_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_coincidence_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_edge_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_footpoint_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_sample_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_site_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/curve_diagrams.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

The Voronoi diagram of points and curves, trimmed: a planar graph of the points that have the same least distance from
two sites or more. `CGAL::Voronoi_diagram_2` is another class: it makes a Voronoi diagram of a Delaunay graph of CGAL,
whose sites are points, segments or circles; hence the longer name here.

A vertex of degree three or more is such a point of as many footpoints. Of degree two: an edge goes on there with
another site, because the foot of the perpendicular arrives at the end of one. Of degree one: the diagram ends in a
center of curvature, in a corner of the curves, or at infinity.

Edges and vertices are connected by proof. Where something is not decided, `is_complete()` is false, and `undecided()`
tells beside which parts of curves: a vertex that is not resolved stands for a small range of footpoints, in which there
may be other vertices and short edges. One that is resolved has bounds of its point, its radius and the parameters of
its footpoints, which are proved.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Voronoi_diagram_of_curves_2
{
public:
  using Point = typename Kernel::Point_2;
  using Site = Voronoi_site_2<Kernel>;
  using Sample = Voronoi_sample_2<Kernel>;
  using Footpoint = Voronoi_footpoint_2;
  using Edge = Voronoi_edge_2;
  using Cell = Voronoi_cell_2;

  //! a vertex.
  struct Vertex
  {
    std::optional<Point> point;         ///< where it is, rounded; none, if it is at infinity
    std::optional<double> radius;       ///< the distance from the sites; none, if it is at infinity
    std::vector<std::size_t> edges;     ///< that begin or end here, clockwise; an edge that does both is listed twice
    /// one between each edge and the next one, clockwise; one, if there are no edges
    std::vector<Footpoint> footpoints;
    bool is_at_infinity;                ///< whether an edge has no end here
    bool is_resolved;                   ///< whether it is proved to be one vertex
    /// the exact point is in it, by proof; infinite where nothing is proved, or it is at infinity
    CGAL::Bbox_2 box;
    std::array<double, 2> radius_bounds;   ///< the exact distance is between them
  };

private:
  std::shared_ptr<const internal::Voronoi::Curve_diagram> m_diagram;
  std::vector<Site> m_sites;
  std::vector<Vertex> m_vertices;

public:
  //! a diagram without sites. Others are made by `voronoi_diagram()` and `medial_axis()`.
  Voronoi_diagram_of_curves_2() : m_diagram(std::make_shared<const internal::Voronoi::Curve_diagram>()) {}

  //! a diagram that an operation has found.
  explicit Voronoi_diagram_of_curves_2(internal::Voronoi::Curve_diagram diagram)
    : m_diagram(std::make_shared<const internal::Voronoi::Curve_diagram>(std::move(diagram)))
  {
    for (const auto& [is_point, point, curve, parameters, region] : m_diagram->sites)
      m_sites.push_back({is_point, point_of(point), curve, parameters, region});
    for (const auto& [point, radius, edges, footpoints, is_at_infinity, is_resolved, box, radius_bounds] :
         m_diagram->vertices)
      m_vertices.push_back({point ? std::optional(point_of(*point)) : std::nullopt, radius, edges, footpoints,
                            is_at_infinity, is_resolved,
                            CGAL::Bbox_2(box[0][0], box[1][0], box[0][1], box[1][1]), radius_bounds});
  }

  //! the sites: the polynomial pieces of all curves, and behind them all their ends and the isolated points.
  const std::vector<Site>& sites() const { return m_sites; }

  //! what curves have in common, for each two of them: pieces of the same points are one site, that of the curve with
  //! the lowest index.
  const std::vector<Voronoi_coincidence_2>& coincident_parts() const { return m_diagram->coincident_parts; }

  //! the vertices.
  const std::vector<Vertex>& vertices() const { return m_vertices; }

  //! the edges.
  const std::vector<Edge>& edges() const { return m_diagram->edges; }

  //! the number of regions that the edges cut the plane into: one for each connected set of curves and points.
  std::size_t number_of_regions() const { return m_diagram->number_of_regions; }

  //! whether all of the diagram is proved.
  bool is_complete() const { return m_diagram->summary.is_complete; }

  //! the parts of curves and points beside which disks are not decided, or edges not connected, in order; none if the
  //! diagram is complete, and some if it is not. Operands are the curves and behind them the points, as they were
  //! given. Where these are in the plane is not known: `Undecided_part::place` is empty.
  const std::vector<Undecided_part>& undecided() const { return m_diagram->undecided; }

  //! the work; nodes are the ranges of curves and of normals in their ends that were looked at.
  const Summary& summary() const { return m_diagram->summary; }

  //! the sites that are on a curve: its pieces, and the points where these end. Of a part that is also on a curve of a
  //! lower index, there are only the ends: see `coincident_parts()`.
  std::vector<std::size_t> sites_of_curve(std::size_t curve) const
  {
    return internal::Voronoi::sites_of_curve(*m_diagram, curve);
  }

  /*!
  the cell of some sites: the union of their cells. Edges between two of them, or between two points of one, are inside
  and left out; of a closed curve, `sites_of_curve()`, there is what is inside of it and what is outside.

  Of a medial axis, it is the part that is in the region.

  \param sites indices of sites.
  \throws Invalid_input when there is no such site.

  Complexity: linear, up to a logarithm, in the number of all edges of these sites.
  */
  Cell cell(const std::vector<std::size_t>& sites) const
  {
    return internal::Voronoi::cell_of_sites(*m_diagram, sites);
  }

  //! the cell of a site; see above. \throws Invalid_input when there is no such site.
  Cell cell(std::size_t site) const { return cell(std::vector<std::size_t>{site}); }

  /*!
  points along an edge, so many that it passes the middles of their chords at no more than a given distance, where the
  bounds of their radii are close together.

  An edge is cut where the radius of the disks is larger than a given one, which is the way to one with an end at
  infinity; nothing is left if all are.

  \param edge the index of the edge.
  \param error the distance; positive.
  \param most_radius the radius; none: the edge is not cut.
  \throws Invalid_input when there is no such edge, or the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t edge, double error,
                               std::optional<double> most_radius = std::nullopt) const
  {
    std::vector<Sample> result;
    for (const internal::Voronoi::Disk_sample& sample :
         internal::Voronoi::samples_of_edge(
             *m_diagram, edge, error, most_radius.value_or(std::numeric_limits<double>::infinity())))
      result.push_back({point_of(sample.center), sample.radius, sample.parameters, sample.radius_bounds});
    return result;
  }

  //! points along an edge of the boundary of a cell, from its begin to its end; otherwise as above.
  std::vector<Sample> polyline(const Cell::Edge& edge, double error,
                               std::optional<double> most_radius = std::nullopt) const
  {
    std::vector<Sample> result = polyline(edge.index, error, most_radius);
    if (edge.is_reversed) {
      std::reverse(result.begin(), result.end());
      for (Sample& sample : result)
        std::swap(sample.parameters[0], sample.parameters[1]);
    }
    return result;
  }

  /*!
  the sites that are nearest to a point, by increasing indices: one, if that is proved; if it is not, all that may be;
  none, if a limit has ended the search for the sites.
  These are equally near, as in points of an edge, up to about 10^-28 of the distances; what doubles do not tell apart
  is decided with 128 bits.

  \param point the point. The answer does not depend on whether the diagram is complete.
  \throws Invalid_input when a coordinate is not finite, or its absolute value is greater than \f$2^{250}\f$.

  Complexity: that of a search in a tree of boxes, and of subdivision of the curves near by, in interval arithmetic.
  */
  std::vector<std::size_t> nearest_sites(const Point& point) const
  {
    return internal::Voronoi::nearest_sites(*m_diagram, internal::Voronoi::exact_coordinates(point));
  }

private:
  template <class Number>
  static Point point_of(const std::array<Number, 2>& coordinates)
  {
    return internal::kernel_object<Kernel, Point>(coordinates);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAM_OF_CURVES_2_H
