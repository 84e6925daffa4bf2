// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAM_OF_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAM_OF_CURVES_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_coincidence_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_sample_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_site_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Edge_samples.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Nearest_sites_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Vertex_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/cell_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/parameter_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/voronoi_sites.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/check_magnitude.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/components_of_vertices.h>

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
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

  //! where the disk of a vertex touches a site.
  struct Footpoint
  {
    std::size_t site;                       ///< the site
    double parameter;                       ///< of the curve; of a point, no number
    std::array<double, 2> parameter_bounds; ///< of the exact parameter, proved if the vertex is resolved
  };

  //! a vertex.
  struct Vertex
  {
    Point point;                        ///< where it is, rounded; if it is at infinity, no point
    double radius;                      ///< the distance from the sites
    std::vector<std::size_t> edges;     ///< that begin or end here, clockwise; an edge that does both is listed twice
    /// one between each edge and the next one, clockwise; one, if there are no edges
    std::vector<Footpoint> footpoints;
    bool is_at_infinity;                ///< whether an edge has no end here
    bool is_resolved;                   ///< whether it is proved to be one vertex
    /// the exact point is in it, by proof; infinite where nothing is proved, or it is at infinity
    CGAL::Bbox_2 box;
    std::array<double, 2> radius_bounds;   ///< the exact distance is between them
  };

  //! an edge.
  struct Edge
  {
    /// the site on its right, and that on its left; the same one if both footpoints are on one piece
    std::array<std::size_t, 2> sites;
    std::array<std::size_t, 2> vertices;                    ///< where it begins and ends
    /// of each site, where the disks touch it at the begin and at the end of the edge; of points, no numbers
    std::array<std::array<double, 2>, 2> parameters;
  };

  //! an edge as the boundary of a cell sees it: with the site of the cell on its left, and the adjacent one on its
  //! right.
  struct Boundary_edge : Edge
  {
    std::size_t index;                  ///< that of the edge
    bool is_reversed;                   ///< whether the boundary runs from the end of the edge to its begin
  };

  //! edges of the boundary of a cell, each of which begins where the one before ends.
  struct Boundary_chain
  {
    std::vector<Boundary_edge> edges;   ///< in order
    /// whether the last one ends where the first one begins; if not, the chain begins and ends at infinity, or where
    /// the foot of the perpendicular goes over to another site
    bool is_closed;
  };

  /*!
  the points that are nearest to a site, or to one of several sites, by the boundary of them, counterclockwise.

  Where the foot of the perpendicular goes over to a site on the same curve there is no edge, but this perpendicular: it
  joins the ends of two chains, or leads to infinity. A cell without chains is all of the region of the site, or of the
  plane, up to such perpendiculars.
  */
  struct Cell
  {
    std::vector<Boundary_chain> chains;     ///< the open ones first
    bool is_complete;                       ///< whether they are proved to be all of the boundary
  };

private:
  using Part = internal::Voronoi::Disk_diagram::Part;

  std::shared_ptr<const internal::Voronoi::Site_graph_2<>> m_graph;
  std::shared_ptr<const internal::Voronoi::Disk_diagram> m_diagram;
  internal::Voronoi::Site_tree_2 m_tree;
  std::vector<Site> m_sites;
  std::vector<Vertex> m_vertices;
  std::vector<Edge> m_edges;
  std::vector<std::size_t> m_halfedge_of_edge, m_edge_of_halfedge;
  std::vector<std::vector<std::size_t>> m_halfedges_of_site;
  std::vector<char> m_is_undecided;   // of each site: whether some of its cell is
  std::vector<Undecided_part_2> m_undecided;
  std::vector<Voronoi_coincidence_2> m_coincident_parts;
  std::size_t m_number_of_regions = 0;

public:
#ifndef DOXYGEN_RUNNING
  Voronoi_diagram_of_curves_2(std::shared_ptr<const internal::Voronoi::Site_graph_2<>> graph,
                              std::shared_ptr<const internal::Voronoi::Disk_diagram> diagram)
    : m_graph(std::move(graph)), m_diagram(std::move(diagram)), m_tree(*m_graph),
      m_undecided(internal::Voronoi::undecided_parts(*m_graph, m_diagram->unresolved_parts()))
  {
    const Upward_rounding_guard guard;
    make_coincident_parts();
    make_sites();
    make_vertices();
    make_edges();
    make_cells();
  }
#endif

  //! the sites: the polynomial pieces of all curves, and behind them all their ends and the isolated points.
  const std::vector<Site>& sites() const { return m_sites; }

  //! what curves have in common, for each two of them: pieces of the same points are one site, that of the curve with
  //! the lowest index.
  const std::vector<Voronoi_coincidence_2>& coincident_parts() const { return m_coincident_parts; }

  //! the vertices.
  const std::vector<Vertex>& vertices() const { return m_vertices; }

  //! the edges.
  const std::vector<Edge>& edges() const { return m_edges; }

  //! the number of regions that the edges cut the plane into: one for each connected set of curves and points.
  std::size_t number_of_regions() const { return m_number_of_regions; }

  //! whether all of the diagram is proved.
  bool is_complete() const { return m_diagram->is_complete(); }

  //! the parts of curves beside which disks are not decided, or edges not connected, in order; none if the diagram is
  //! complete, and some if it is not. A part that belongs to an isolated point has no curve: the greatest index.
  const std::vector<Undecided_part_2>& undecided() const { return m_undecided; }

  //! the sites that are on a curve: its pieces, and the points where these end. Of a part that is also on a curve of a
  //! lower index, there are only the ends: see `coincident_parts()`.
  std::vector<std::size_t> sites_of_curve(std::size_t curve) const
  {
    std::vector<std::size_t> result;
    const auto is_on_curve = [&](const auto& end) { return m_graph->curve_of_arc(end.arc) == curve; };
    for (std::size_t i = 0; i < m_sites.size(); ++i) {
      const std::size_t arcs = m_graph->arcs().size();
      if (i < arcs ? m_graph->curve_of_arc(i) == curve
                   : std::ranges::any_of(m_graph->vertices()[i - arcs].ends, is_on_curve))
        result.push_back(i);
    }
    return result;
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
    const std::set<std::size_t> inner(sites.begin(), sites.end());
    if (!inner.empty() && *inner.rbegin() >= m_sites.size())
      throw Invalid_input("Voronoi_diagram_of_curves_2: there is no site " + std::to_string(*inner.rbegin()));
    std::vector<std::size_t> halfedges;
    Cell result{{}, m_graph->is_proved()};
    for (const std::size_t site : inner) {
      halfedges.insert(halfedges.end(), m_halfedges_of_site[site].begin(), m_halfedges_of_site[site].end());
      result.is_complete = result.is_complete && !m_is_undecided[site];
    }
    const auto is_inside = [&](std::size_t h) {
      return inner.contains(site_of(m_diagram->element(m_diagram->halfedges()[h])));
    };
    for (const auto& [chain, is_closed] : internal::Voronoi::Cell_boundaries(*m_diagram, is_inside)(halfedges)) {
      result.chains.push_back({{}, is_closed});
      for (const std::size_t h : chain)
        result.chains.back().edges.push_back(boundary_edge(h));
    }
    return result;
  }

  //! the cell of a site; see above. \throws Invalid_input when there is no such site.
  Cell cell(std::size_t site) const { return cell(std::vector<std::size_t>{site}); }

  /*!
  points along an edge, so many that it passes the middles of their chords at no more than a given distance, where the
  bounds of their radii are close together.

  An edge with an end at infinity is cut where the radius of the disks is larger than a given one; nothing is left if
  all are.

  \param edge the index of the edge.
  \param error the distance; positive.
  \param most_radius the radius.
  \throws Invalid_input when there is no such edge, or the error is not positive.
  */
  std::vector<Sample> polyline(std::size_t edge, double error,
                               double most_radius = std::numeric_limits<double>::infinity()) const
  {
    internal::check_error(error, "Voronoi_diagram_of_curves_2");
    if (edge >= m_edges.size())
      throw Invalid_input("Voronoi_diagram_of_curves_2: there is no edge " + std::to_string(edge));
    const Upward_rounding_guard guard;
    std::vector<Sample> result;
    for (const Part& part : m_diagram->halfedges()[m_halfedge_of_edge[edge]].parts)
      edge_samples().append(part, error, most_radius, result);
    if (!result.empty()) {
      put_at_vertex(m_edges[edge].vertices[0], most_radius, result.front());
      put_at_vertex(m_edges[edge].vertices[1], most_radius, result.back());
    }
    return result;
  }

  //! points along an edge of the boundary of a cell, from its begin to its end; otherwise as above.
  std::vector<Sample> polyline(const Boundary_edge& edge, double error,
                               double most_radius = std::numeric_limits<double>::infinity()) const
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
  the sites that are nearest to a point, by increasing indices: one, if that is proved; if it is not, all that may be.
  These are equally near, as in points of an edge, up to about 10^-28 of the distances; what doubles do not tell apart
  is decided with 128 bits.

  \param point the point. The answer does not depend on whether the diagram is complete.
  \throws Invalid_input when a coordinate is not finite, or its absolute value is greater than \f$2^{250}\f$.

  Complexity: that of a search in a tree of boxes, and of subdivision of the curves near by, in interval arithmetic.
  */
  std::vector<std::size_t> nearest_sites(const Point& point) const
  {
    const Upward_rounding_guard guard;
    const internal::Exact_pair exact{internal::converted_number<Exact_rational>(point.x()),
                                     internal::converted_number<Exact_rational>(point.y())};
    internal::Voronoi::check_magnitude(exact, "Voronoi_diagram_of_curves_2::nearest_sites");
    return internal::Voronoi::nearest_sites(*m_graph, m_tree, *m_diagram->fine_level(), exact);
  }

private:
  internal::Voronoi::Edge_samples<Kernel> edge_samples() const { return {*m_graph, *m_diagram}; }

  std::size_t site_of(const internal::Voronoi::Oriented_element<>& element) const
  {
    return element.object + (element.is_normal_cone ? m_graph->arcs().size() : 0);
  }

  double curve_parameter(std::size_t site, double u) const
  {
    return m_sites[site].is_point ? std::numeric_limits<double>::quiet_NaN() : m_graph->curve_parameter(site, u);
  }

  // The parameters of a range of a piece; of one with ends that are not known exactly, with all errors.
  std::array<double, 2> parameter_bounds(std::size_t site, const internal::Common::Range& range) const
  {
    if (m_sites[site].is_point)
      return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    return internal::Voronoi::parameter_bounds(m_graph->arcs()[site], range);
  }

  // The disk in the end of an edge is that of the vertex, which may be known better.
  void put_at_vertex(std::size_t index, double most_radius, Sample& sample) const
  {
    const Vertex& vertex = m_vertices[index];
    const auto width = [](const std::array<double, 2>& bounds) { return bounds[1] - bounds[0]; };
    if (!vertex.is_at_infinity && vertex.radius <= most_radius &&
        width(vertex.radius_bounds) < width(sample.radius_bounds))
      sample = {vertex.point, vertex.radius, sample.parameters, vertex.radius_bounds};
  }

  static CGAL::Bbox_2 box(const internal::Common::Interval_pair& center)
  {
    return {center[0].inf(), center[1].inf(), center[0].sup(), center[1].sup()};
  }
  static std::array<double, 2> ends(const internal::Common::Interval& x) { return {x.inf(), x.sup()}; }

  void make_coincident_parts()
  {
    for (const auto& [curves, overlap] : m_graph->coincident_parts()) {
      m_coincident_parts.push_back({curves, {}, overlap.is_reversed});
      for (std::size_t k = 0; k < 2; ++k)
        m_coincident_parts.back().parameters[k] = {to_nearest_double(overlap.parameters[k].first),
                                                   to_nearest_double(overlap.parameters[k].second)};
    }
  }

  void make_sites()
  {
    const std::vector<std::size_t> regions = internal::Voronoi::components_of_vertices(*m_graph);
    m_sites = internal::Voronoi::voronoi_sites<Kernel>(*m_graph, regions);
    m_number_of_regions = regions.empty() ? 0 : *std::max_element(regions.begin(), regions.end()) + 1;
  }

  void make_vertices()
  {
    for (const auto& vertex : m_diagram->vertices()) {
      const internal::Voronoi::Disk_diagram::Halfedge& h = m_diagram->halfedges()[vertex.outgoing.front()];
      const Sample at = vertex.is_at_infinity
          ? Sample{Point(0, 0), std::numeric_limits<double>::infinity(), {}}
          : edge_samples()(h.parts.front(), m_diagram->end_parameter(h.parts.front(), false));
      const internal::Voronoi::Vertex_bounds<> bounds = internal::Voronoi::vertex_bounds(*m_graph, *m_diagram, vertex);
      const auto within = [](const internal::Common::Interval& x, const auto& value) {
        return std::clamp(CGAL::to_double(value), x.inf(), x.sup());
      };
      const Point center = internal::kernel_object<Kernel, Point>(
          std::array<double, 2>{within(bounds.center[0], at.point.x()), within(bounds.center[1], at.point.y())});
      m_vertices.push_back({center,
                            within(bounds.radius, at.radius),
                            {},
                            {},
                            vertex.is_at_infinity,
                            vertex.is_resolved,
                            box(bounds.center),
                            ends(bounds.radius)});
    }
    for (const internal::Voronoi::Disk_diagram::Part& part : m_diagram->lone_circles()) {
      const Sample at = edge_samples()(part, m_diagram->end_parameter(part, false));
      const std::size_t site = site_of(m_diagram->element(part));
      const internal::Common::Site_arc_2<>& circle = m_graph->arcs()[site];
      m_vertices.push_back({at.point,
                            at.radius,
                            {},
                            {{site, at.parameters[0], m_sites[site].parameters}},
                            false,
                            true,
                            box(circle.center()),
                            ends(CGAL::sqrt(circle.squared_radius()))});
    }
  }

  void make_edges()
  {
    const auto& halfedges = m_diagram->halfedges();
    std::vector<std::size_t>& edge_of = m_edge_of_halfedge;
    edge_of.assign(halfedges.size(), internal::Voronoi::Disk_diagram::none);
    for (std::size_t i = 0; i < halfedges.size(); ++i) {
      const std::size_t twin = halfedges[i].twin;
      if (twin == internal::Voronoi::Disk_diagram::none || twin < i)
        continue;
      edge_of[i] = edge_of[twin] = m_edges.size();
      m_halfedge_of_edge.push_back(i);
      Edge edge{{site_of(m_diagram->element(halfedges[i])), site_of(m_diagram->element(halfedges[twin]))},
                {halfedges[i].source, halfedges[twin].source},
                {}};
      for (std::size_t k = 0; k < 2; ++k)
        for (std::size_t end = 0; end < 2; ++end)
          edge.parameters[k][end] =
              curve_parameter(edge.sites[k], end_parameter(halfedges[k == 0 ? i : twin], (end == 1) == (k == 0)));
      m_edges.push_back(edge);
    }
    for (std::size_t v = 0; v < m_diagram->vertices().size(); ++v)
      for (const std::size_t h : m_diagram->vertices()[v].outgoing)
        if (edge_of[h] != internal::Voronoi::Disk_diagram::none) {
          const std::size_t site = site_of(m_diagram->element(halfedges[h]));
          m_vertices[v].edges.push_back(edge_of[h]);
          m_vertices[v].footpoints.push_back({site, curve_parameter(site, end_parameter(halfedges[h], false)),
                                              parameter_bounds(site, m_diagram->range_of_end(h, false).range)});
        }
  }

  void make_cells()
  {
    m_halfedges_of_site.resize(m_sites.size());
    for (std::size_t h = 0; h < m_diagram->halfedges().size(); ++h)
      m_halfedges_of_site[site_of(m_diagram->element(m_diagram->halfedges()[h]))].push_back(h);
    m_is_undecided.assign(m_sites.size(), false);
    for (const internal::Voronoi::Element_range& part : m_diagram->unresolved_parts())
      m_is_undecided[site_of(m_graph->elements()[part.element])] = true;
  }

  // The side of an edge on which a halfedge is.
  Boundary_edge boundary_edge(std::size_t halfedge) const
  {
    const std::size_t index = m_edge_of_halfedge[halfedge];
    const bool is_reversed = m_halfedge_of_edge[index] == halfedge;   // it has its site on the right
    Boundary_edge result{m_edges[index], index, is_reversed};
    if (is_reversed) {
      std::swap(result.sites[0], result.sites[1]);
      std::swap(result.vertices[0], result.vertices[1]);
      std::swap(result.parameters[0], result.parameters[1]);
      for (auto& ends : result.parameters)
        std::swap(ends[0], ends[1]);
    }
    return result;
  }

  double end_parameter(const internal::Voronoi::Disk_diagram::Halfedge& h, bool end) const
  {
    return m_diagram->end_parameter(end ? h.parts.back() : h.parts.front(), end);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAM_OF_CURVES_2_H
