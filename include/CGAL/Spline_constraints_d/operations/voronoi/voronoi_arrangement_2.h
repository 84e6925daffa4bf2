// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_ARRANGEMENT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_ARRANGEMENT_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_arrangement_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Bbox_2.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

template <SplineKernel Kernel>
class Arrangement_refinement;

} // namespace Voronoi
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDVoronoi

The edges of a Voronoi diagram or a medial axis as an arrangement of chords, for point location, overlays and all else
that CGAL does with arrangements.
*/
template <SplineKernel Kernel>
struct Voronoi_arrangement_2
{
  /*!
  an exact arrangement of chords; `edge->curve().data()` lists their labels. What its records know:
  - `vertex->data()`, the vertex of the diagram that is there, the first one if there are several, as in a crossing;
    nothing where chords of one edge meet;
  - `halfedge->data()`, the site that is nearest on its left; nothing on the sides of a box;
  - `face->data()`, in increasing order the regions of the sites along its edges, see `Voronoi_site_2::region`: one, if
    the diagram and the arrangement are complete, and the diagram is not cut there. CGAL's stream operators
    (`CGAL/IO/Arr_iostream.h`) write and read its geometry, without labels and records.
  */
  using Arrangement =
      CGAL::Arrangement_2<internal::Regions::Chord_traits_2,
                          CGAL::Arr_extended_dcel<internal::Regions::Chord_traits_2, std::optional<std::size_t>,
                                                  std::optional<std::size_t>, std::vector<std::size_t>>>;

  //! the arrangement. Labels are indices of edges of the diagram, and of chords of the polylines; of the sides of a
  //! box, the number of edges, and 0 to 3.
  Arrangement arrangement;

  //! the samples of each edge that the chords join: with the parameters of both sites, and the radius.
  std::vector<std::vector<Voronoi_sample_2<Kernel>>> polylines;

  //! whether the arrangement is proved to have the connections of the diagram: chords meet in their ends only, and
  //! edges around each vertex have the same order.
  bool has_same_topology = false;

  //! the work; nodes are edges whose samples were computed.
  const Summary& summary() const { return m_summary; }

  //! whether it has the connections of the diagram, by proof.
  bool is_complete() const { return m_summary.is_complete; }

  //! the edges that have no chords, as limits or a visitor ended the search; an operand is an edge of the diagram. If
  //! there are none, and the connections are not those of the diagram, a part without operands says so.
  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

private:
  Summary m_summary;
  std::vector<Undecided_part> m_undecided;

  friend class internal::Voronoi::Arrangement_refinement<Kernel>;
};

namespace internal {
namespace Voronoi {

// A chord at one of the ends of a polyline.
struct End_chord
{
  std::size_t edge;
  CGAL::Exact_predicates_exact_constructions_kernel::Direction_2 direction;
};

// Whether the chords that leave a vertex are in the clockwise order of the edges there.
inline bool has_order_of_edges(std::vector<End_chord> chords, const std::vector<std::size_t>& edges)
{
  if (chords.size() != edges.size())
    return false;
  // directions increase counterclockwise
  std::sort(chords.begin(), chords.end(),
            [](const End_chord& a, const End_chord& b) { return b.direction < a.direction; });
  for (std::size_t shift = 0; shift < edges.size(); ++shift) {
    bool is_equal = true;
    for (std::size_t i = 0; i < edges.size(); ++i)
      is_equal = is_equal && chords[(i + shift) % edges.size()].edge == edges[i];
    if (is_equal)
      return true;
  }
  return edges.empty();
}

template <class Diagram, class Arrangement, class Point>
bool has_topology_of(const Diagram& diagram, const Arrangement& arrangement,
                     const std::vector<std::vector<Point>>& polylines, double most_radius)
{
  if (!is_crossing_free(arrangement, polylines))
    return false;
  std::vector<std::vector<End_chord>> chords(diagram.vertices().size());
  for (std::size_t e = 0; e < polylines.size(); ++e)
    if (const auto& p = polylines[e]; p.size() > 1) {
      const auto& [first, last] = diagram.edges()[e].vertices;
      chords[first].push_back({e, (p[1] - p[0]).direction()});
      chords[last].push_back({e, (p[p.size() - 2] - p.back()).direction()});
    }
  for (std::size_t v = 0; v < chords.size(); ++v)
    if (const auto& vertex = diagram.vertices()[v];
        vertex.radius && *vertex.radius <= most_radius && !has_order_of_edges(chords[v], vertex.edges))
      return false;
  return true;
}

// Makes the arrangement of a diagram, as far as limits allow.
template <SplineKernel Kernel>
class Arrangement_refinement
{
  using Result = Voronoi_arrangement_2<Kernel>;
  using Arrangement = typename Result::Arrangement;
  using Samples = std::vector<std::vector<Voronoi_sample_2<Kernel>>>;

  static constexpr int most_refinements = 8;

  const Voronoi_diagram_of_curves_2<Kernel>& m_diagram;
  double m_most_radius;
  Search_control m_control;

public:
  Arrangement_refinement(const Voronoi_diagram_of_curves_2<Kernel>& diagram, double most_radius,
                         const Solver_options& options)
    : m_diagram(diagram), m_most_radius(most_radius), m_control(options)
  {}

  // With errors that are halved until it has the topology of the diagram.
  Result operator()(double error)
  {
    check_error(error, "to_arrangement");
    Result result;
    for (int i = 0; i <= most_refinements && !result.has_same_topology; ++i, error /= 2) {
      Samples samples = samples_of_edges(error, i == 0 ? 1 : 0);
      if (i > 0 && m_control.has_ended())   // the one before has more edges
        break;
      std::vector<std::vector<typename Arrangement::Point_2>> polylines;
      for (const auto& edge : samples) {
        auto& polyline = polylines.emplace_back();
        for (const auto& sample : edge)
          polyline.emplace_back(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()));
      }
      result.polylines = std::move(samples);
      result.arrangement = polyline_arrangement<Arrangement>(polylines);
      result.has_same_topology =
          !m_control.has_ended() && has_topology_of(m_diagram, result.arrangement, polylines, m_most_radius);
    }
    return result;
  }

  bool has_all_edges() const { return m_sampled == m_diagram.edges().size(); }

  // Tells what is known of the final arrangement.
  void complete(Result& result)
  {
    for (std::size_t e = m_sampled; e < m_diagram.edges().size(); ++e)
      result.m_undecided.push_back({{}, {{e, {}}}, in_words(m_control.reason())});
    if (result.m_undecided.empty() && !result.has_same_topology)
      result.m_undecided.push_back({{},
                                    {},
                                    m_control.has_ended()
                                        ? in_words(m_control.reason())
                                        : "chords are not proved to have the connections of the edges"});
    result.m_summary = m_control.summary(result.m_undecided.empty());
  }

private:
  std::size_t m_sampled = 0;   // edges in the first arrangement

  // Of all edges, or, if the search is ended, of the first ones; they begin and end in the vertices.
  Samples samples_of_edges(double error, double progress)
  {
    Samples result(m_diagram.edges().size());
    for (std::size_t e = 0; e < result.size(); ++e) {
      try {
        m_control.check();
        m_control.add_node();
      } catch (const Run_stopped&) {
        break;
      }
      result[e] = m_diagram.polyline(e, error, m_most_radius);
      const auto& [first, last] = m_diagram.edges()[e].vertices;
      const auto is_kept = [&](std::size_t v) {
        const std::optional<double>& radius = m_diagram.vertices()[v].radius;
        return !result[e].empty() && radius && *radius <= m_most_radius;
      };
      if (is_kept(first))
        result[e].front().point = *m_diagram.vertices()[first].point;
      if (is_kept(last))
        result[e].back().point = *m_diagram.vertices()[last].point;
      m_control.add_progress(progress / static_cast<double>(result.size()));
      m_sampled = (std::max)(m_sampled, e + 1);
    }
    return result;
  }
};

// Whether edges to infinity have been followed to disks of a radius.
template <SplineKernel Kernel>
bool edges_reach(const Voronoi_diagram_of_curves_2<Kernel>& diagram, const Voronoi_arrangement_2<Kernel>& arrangement,
                 double radius)
{
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const bool is_end : {false, true})
      if (const auto& samples = arrangement.polylines[e]; !samples.empty() &&
          diagram.vertices()[diagram.edges()[e].vertices[is_end]].is_at_infinity &&
          !((is_end ? samples.back() : samples.front()).radius >= radius))
        return false;
  return true;
}

// Adds the sides of a box, and removes what is outside.
template <class Arrangement>
void cut_at(const CGAL::Bbox_2& box, std::size_t label, Arrangement& arrangement)
{
  const std::array<Chord_traits_2::Point_2, 4> corners{
      {{box.xmin(), box.ymin()}, {box.xmax(), box.ymin()}, {box.xmax(), box.ymax()}, {box.xmin(), box.ymax()}}};
  std::vector<Chord_traits_2::Curve_2> sides;
  for (std::size_t i = 0; i < 4; ++i)
    sides.emplace_back(Chord_segment_traits_2::Curve_2(corners[i], corners[(i + 1) % 4]), Chord_label{label, i});
  CGAL::insert(arrangement, sides.begin(), sides.end());
  const auto is_outside = [&](const Chord_traits_2::Point_2& p) {
    return p.x() < box.xmin() || p.x() > box.xmax() || p.y() < box.ymin() || p.y() > box.ymax();
  };
  std::vector<typename Arrangement::Halfedge_handle> outer;
  for (auto e = arrangement.edges_begin(); e != arrangement.edges_end(); ++e)
    if (is_outside(e->source()->point()) || is_outside(e->target()->point()))
      outer.push_back(e);
  for (const auto& e : outer)
    arrangement.remove_edge(e);
}

template <SplineKernel Kernel>
void label_vertices(const Voronoi_diagram_of_curves_2<Kernel>& diagram, Voronoi_arrangement_2<Kernel>& result)
{
  std::map<Chord_traits_2::Point_2, std::size_t> vertex_at;
  for (std::size_t v = 0; v < diagram.vertices().size(); ++v)
    if (const auto& vertex = diagram.vertices()[v]; !vertex.is_at_infinity)
      vertex_at.try_emplace({CGAL::to_double(vertex.point->x()), CGAL::to_double(vertex.point->y())}, v);
  for (auto v = result.arrangement.vertices_begin(); v != result.arrangement.vertices_end(); ++v)
    if (const auto found = vertex_at.find(v->point()); found != vertex_at.end())
      v->set_data(found->second);
}

template <SplineKernel Kernel>
void label_halfedges(const Voronoi_diagram_of_curves_2<Kernel>& diagram, Voronoi_arrangement_2<Kernel>& result)
{
  for (auto h = result.arrangement.halfedges_begin(); h != result.arrangement.halfedges_end(); ++h)
    for (const Chord_label& label : h->curve().data())
      if (label.curve < diagram.edges().size()) {
        const auto& [begin, end] = std::array{result.polylines[label.curve][label.chord].point,
                                              result.polylines[label.curve][label.chord + 1].point};
        const bool is_along_edge = (h->direction() == CGAL::ARR_LEFT_TO_RIGHT) == (begin < end);
        h->set_data(diagram.edges()[label.curve].sites[is_along_edge ? 1 : 0]);
      }
}

template <SplineKernel Kernel>
void label_faces(const Voronoi_diagram_of_curves_2<Kernel>& diagram, Voronoi_arrangement_2<Kernel>& result)
{
  for (auto face = result.arrangement.faces_begin(); face != result.arrangement.faces_end(); ++face) {
    std::set<std::size_t> regions;
    const auto insert_regions = [&](auto begin, auto end) {
      for (; begin != end; ++begin) {
        auto h = *begin;
        do
          if (h->data())
            regions.insert(diagram.sites()[*h->data()].region);
        while (++h != *begin);
      }
    };
    insert_regions(face->outer_ccbs_begin(), face->outer_ccbs_end());
    insert_regions(face->inner_ccbs_begin(), face->inner_ccbs_end());
    face->set_data({regions.begin(), regions.end()});
  }
}

// A face of a box that no edge passes is part of one region, that of the sites that are nearest to a corner of it.
template <SplineKernel Kernel>
void label_whole_box(const Voronoi_diagram_of_curves_2<Kernel>& diagram, Voronoi_arrangement_2<Kernel>& result)
{
  for (auto face = result.arrangement.faces_begin(); face != result.arrangement.faces_end(); ++face)
    if (!face->is_unbounded() && face->data().empty()) {
      const auto& corner = face->outer_ccb()->source()->point();
      const std::size_t site =
          diagram.nearest_sites(typename Kernel::Point_2(CGAL::to_double(corner.x()), CGAL::to_double(corner.y())))
              .front();
      face->set_data({diagram.sites()[site].region});
    }
}

template <class Halfedge>
CGAL::Polygon_2<CGAL::Exact_predicates_exact_constructions_kernel> polygon_along(Halfedge begin)
{
  CGAL::Polygon_2<CGAL::Exact_predicates_exact_constructions_kernel> result;
  auto h = begin;
  do
    result.push_back(h->source()->point());
  while (++h != begin);
  return result;
}

template <SplineKernel Kernel>
void label_records(const Voronoi_diagram_of_curves_2<Kernel>& diagram, Voronoi_arrangement_2<Kernel>& result)
{
  label_vertices(diagram, result);
  label_halfedges(diagram, result);
  label_faces(diagram, result);
}

} // namespace Voronoi
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDVoronoi

a Voronoi diagram or a medial axis as an arrangement of chords of its edges.

Edges that have a vertex in common end in the same vertex of the arrangement, the point of the vertex, rounded; so do
those that end in the angles between curves that cross, in one point. Edges to infinity are cut.

Whether the arrangement has the connections of the diagram is decided exactly; if not, the error is halved, up to eight
times. Then each connected part of it can be deformed to that part of the diagram without a change of the connections.

\param diagram the diagram.
\param error a distance between edges and chords, see `Voronoi_diagram_of_curves_2::polyline()`; positive.
\param most_radius edges to infinity are cut where the radius of the disks is larger, and so are vertices of such
radius; positive and finite.
\param options limits and a visitor, which is told the share of the edges that have chords. When they end the search,
the rest has none. CGAL's sweep over the chords that there are is not interrupted.
\throws Invalid_input when the error is not positive, the radius is not positive or not finite, or a coordinate of a
chord is greater than \f$2^{250}\f$.

Complexity: that of a sweep, \f$O(n \log n)\f$ for \f$n\f$ chords, for each error that is tried.
*/
template <SplineKernel Kernel>
Voronoi_arrangement_2<Kernel> to_arrangement(const Voronoi_diagram_of_curves_2<Kernel>& diagram, double error,
                                             double most_radius, const Solver_options& options = {})
{
  if (!(most_radius > 0 && std::isfinite(most_radius)))
    throw Invalid_input("to_arrangement: the radius must be positive and finite");
  internal::Voronoi::Arrangement_refinement<Kernel> refinement(diagram, most_radius, options);
  auto result = refinement(error);
  internal::Voronoi::label_records(diagram, result);
  refinement.complete(result);
  return result;
}

/*!
\ingroup PkgSplineConstraintsDVoronoi

a Voronoi diagram or a medial axis in a box, as an arrangement of chords of its edges and the sides of the box.

The regions are faces then, also those that go to infinity: point location tells which of the connected sets of curves
and points is the nearest one, for points that are not between an edge and a chord.
`Voronoi_diagram_of_curves_2::nearest_sites()` tells it for all points, and which piece it is.

\param diagram the diagram of one site or more.
\param error a distance between edges and chords, see `Voronoi_diagram_of_curves_2::polyline()`; positive.
\param box what is outside is left out. It is not empty; the sites may be outside.
\param options as above.
\throws Invalid_input when the error is not positive, or less than \f$2^{-50}\f$ of the diameter of the box and the
first site: coordinates are doubles; when the box has no inner points, coordinates whose absolute value is not
\f$2^{250}\f$ at most; or there are no sites.

Complexity: as above; `Voronoi_arrangement_2::has_same_topology` is that of the arrangement before it is cut at the
sides of the box, and false if an edge to infinity does not reach these.
*/
template <SplineKernel Kernel>
Voronoi_arrangement_2<Kernel> to_arrangement(const Voronoi_diagram_of_curves_2<Kernel>& diagram, double error,
                                             const CGAL::Bbox_2& box, const Solver_options& options = {})
{
  constexpr double least_error = 0x1p-50;   // of the diameter
  if (!(box.xmin() < box.xmax() && box.ymin() < box.ymax() &&
        -internal::most_magnitude <= (std::min)(box.xmin(), box.ymin()) &&
        (std::max)(box.xmax(), box.ymax()) <= internal::most_magnitude))
    throw Invalid_input("to_arrangement: the box must have inner points, and coordinates between -2^250 and 2^250");
  if (diagram.sites().empty())
    throw Invalid_input("to_arrangement: the diagram has no sites");
  const auto& site = diagram.sites().front().point;
  const CGAL::Bbox_2 both = box + site.bbox();
  // no point of the box has a larger distance from that site
  const double diameter = std::hypot(both.xmax() - both.xmin(), both.ymax() - both.ymin());
  internal::check_error(error, "to_arrangement");
  if (error < least_error * diameter)
    throw Invalid_input("to_arrangement: the error is less than 2^-50 of the diameter of the box and the first site");
  internal::Voronoi::Arrangement_refinement<Kernel> refinement(diagram, 2 * diameter, options);
  auto result = refinement(error);
  result.has_same_topology = result.has_same_topology && internal::Voronoi::edges_reach(diagram, result, diameter);
  internal::Voronoi::cut_at(box, diagram.edges().size(), result.arrangement);
  internal::Voronoi::label_records(diagram, result);
  if (diagram.is_complete() && refinement.has_all_edges())
    internal::Voronoi::label_whole_box(diagram, result);
  refinement.complete(result);
  return result;
}

/*!
\ingroup PkgSplineConstraintsDVoronoi

the cell of a connected set of curves and points, `Voronoi_site_2::region`, as polygons with holes that are bounded by
chords: the faces of the region, several if a box cuts it, without the edges within them.

\param arrangement the diagram as an arrangement; one in a box, or all that is unbounded is left out.
\param region the index of the region. Where an arrangement of a diagram that is not complete has faces of several
regions, these are left out.

Complexity: that of a copy of the arrangement.
*/
template <SplineKernel Kernel>
std::vector<CGAL::Polygon_with_holes_2<CGAL::Exact_predicates_exact_constructions_kernel>>
region_polygons(const Voronoi_arrangement_2<Kernel>& arrangement, std::size_t region)
{
  auto faces = arrangement.arrangement;
  std::vector<typename Voronoi_arrangement_2<Kernel>::Arrangement::Halfedge_handle> inner_edges;
  for (auto e = faces.edges_begin(); e != faces.edges_end(); ++e)
    if (e->face()->data() == e->twin()->face()->data())
      inner_edges.push_back(e);
  for (const auto& e : inner_edges)
    faces.remove_edge(e);
  std::vector<CGAL::Polygon_with_holes_2<CGAL::Exact_predicates_exact_constructions_kernel>> result;
  for (auto face = faces.faces_begin(); face != faces.faces_end(); ++face)
    if (!face->is_unbounded() && face->data() == std::vector{region}) {
      result.emplace_back(internal::Voronoi::polygon_along(face->outer_ccb()));
      for (auto hole = face->inner_ccbs_begin(); hole != face->inner_ccbs_end(); ++hole)
        result.back().add_hole(internal::Voronoi::polygon_along(*hole));
    }
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_ARRANGEMENT_2_H
