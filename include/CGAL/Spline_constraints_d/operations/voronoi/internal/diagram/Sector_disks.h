// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_SECTOR_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_SECTOR_DISKS_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Sector_cusp_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Envelope_arc_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_chains.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/check_magnitude.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/for_each_element.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
All points P that are c times as far from some sites B of a graph, which are scaled by c > 1, as from the others, A.

On the way from a point X of A along a normal the distance t from X grows by 1, and that from B by less than c in units
of c: so t = |P - B| / c for one P. Let K(u) be the curvature of the disk around P through X, in units of the normal,
where u runs along an element of A: it is the greatest one of disks that are touched by B when they are scaled. P
belongs to the result if no other point of A is in that disk: K is not below the curvature of the largest disk without A
inside. So the result consists of those envelope arcs of the upper envelope of both that belong to B, and ends of these
are crossings: of the result and the self-bisector of A, where it goes over to another element, or of B.

Where A and B meet, disks shrink to a point. Around it, the result has two curves for each arc of A there, or for
several next to each other: it goes on from one to the other.
*/
class Sector_disks
{
public:
  // What a disk of an element touches when it is scaled.
  struct Arc
  {
    std::size_t element, envelope_arc;
    Disk_footpoint footpoint;
    double begin, end;   // of the element, in the order of traversal
  };

private:
  std::shared_ptr<const Site_graph_2<>> m_graph;
  std::shared_ptr<const Scaled_sites<>> m_scaled;
  std::shared_ptr<const Fine_level> m_fine_level;   // of both
  Disk_curvature<> m_curvature;
  Envelope_arc_disks m_disks;
  std::vector<std::vector<Envelope_arc>> m_envelope_arcs;   // of each element
  Rest_of_search m_rest;
  Free_chains m_free;

public:
  // With the envelope arcs of the elements of A.
  Sector_disks(std::shared_ptr<const Site_graph_2<>> graph, std::shared_ptr<const Scaled_sites<>> scaled,
               std::shared_ptr<const Fine_level> fine_level, const std::vector<std::size_t>& elements,
               std::vector<std::vector<Envelope_arc>> envelope_arcs, Rest_of_search rest)
    : m_graph(std::move(graph)), m_scaled(std::move(scaled)), m_fine_level(std::move(fine_level)),
      m_curvature(*m_graph, m_scaled.get()), m_disks(*m_graph, m_curvature, *m_fine_level),
      m_envelope_arcs(std::move(envelope_arcs)), m_rest(std::move(rest)), m_free(free_chains(elements))
  {}

  const Site_graph_2<>& graph() const { return *m_graph; }
  const Oriented_element<>& element(const Arc& arc) const { return m_graph->elements()[arc.element]; }
  const std::vector<Free_chains::Chain>& chains() const { return m_free.chains(); }
  std::vector<Undecided_range> undecided() const { return m_free.undecided(m_rest); }

  // The arcs of a piece of a chain, in the order of traversal.
  std::vector<Arc> arcs(std::size_t index) const
  {
    const Free_chains::Piece& piece = m_free.pieces()[index];
    const Range range{piece.range[0].location.end, piece.range[1].location.begin};
    std::vector<Arc> result;
    for (std::size_t i = 0; i < m_envelope_arcs[piece.element].size(); ++i)
      if (const Envelope_arc& envelope_arc = m_envelope_arcs[piece.element][i];
          range.begin <= envelope_arc.range.begin && envelope_arc.range.end <= range.end)
        result.push_back({piece.element, i, envelope_arc.footpoint, envelope_arc.range.begin, envelope_arc.range.end});
    if (m_free.element(piece).is_reversed) {
      std::reverse(result.begin(), result.end());
      for (Arc& arc : result)
        std::swap(arc.begin, arc.end);
    }
    return result;
  }

  struct Disk
  {
    Interval_pair center;
    Interval radius;
    double parameter;   // of the footpoint, if that is an arc
  };

  // The disk of an arc that touches the element in a point, up to rounding.
  Disk disk(const Arc& arc, double u) const
  {
    const Envelope_arc_disks::Disk disk = m_disks(arc.element, m_envelope_arcs[arc.element][arc.envelope_arc], u);
    if (!std::isfinite(disk.curvature.sup() - disk.curvature.inf()))   // where A and B meet
      return {m_graph->element_jet(element(arc), {u, u}).point, Interval(0), disk.parameter};
    return {disk.center, CGAL::sqrt(squared_norm(m_graph->element_jet(element(arc), {u, u}).normal)) / disk.curvature,
            disk.parameter};
  }

private:
  static Interval_pair center(const Element_part<>& part, const Interval& k)
  {
    return {part.jet.point[0] + part.jet.normal[0] / k, part.jet.point[1] + part.jet.normal[1] / k};
  }

  Free_chains free_chains(const std::vector<std::size_t>& elements) const
  {
    const Upward_rounding_guard guard;
    std::vector<Free_ranges> ranges(m_envelope_arcs.size());
    for (const std::size_t element : elements)
      ranges[element] = free_ranges(element);
    return {*m_graph, std::move(ranges), [&](std::size_t element, const Free_end& end) {
              const Element_part<> part = m_curvature.part(element, end.location);
              const std::size_t index = end.footpoint.index;
              return center(part,
                            end.footpoint.kind == Disk_footpoint::Kind::ARC
                                ? m_curvature(part, index, end.footpoint_location,
                                              m_graph->arcs()[index].jet(end.footpoint_location))
                                      .value
                                : m_curvature(part, index).value);
            }};
  }

  bool is_at_scaled_vertex(const Oriented_element<>& element, bool is_end) const
  {
    return !element.is_normal_cone && m_curvature.is_vertex_scaled(m_graph->vertex_of({element.object, is_end}));
  }

  // The envelope arcs that touch B, those that follow each other in one range.
  Free_ranges free_ranges(std::size_t element) const
  {
    const std::vector<Envelope_arc>& envelope_arcs = m_envelope_arcs[element];
    Free_ranges result;
    double known = 0;   // what is behind the envelope arcs
    bool goes_on = false;
    for (std::size_t i = 0; i < envelope_arcs.size(); ++i) {
      const Envelope_arc& envelope_arc = envelope_arcs[i];
      const bool is_unresolved = envelope_arc.events[0] == Disk_event::UNRESOLVED;
      if (is_unresolved && known < envelope_arc.range.begin)
        result.undecided.push_back({known, envelope_arc.range.begin});
      known = envelope_arc.range.end;
      goes_on = goes_on && !is_unresolved;
      if (is_scaled(m_curvature, envelope_arc.footpoint)) {
        if (!goes_on)
          result.free.push_back({end_at(element, i, false), {}});
        result.free.back()[1] = end_at(element, i, true);
      }
      goes_on = is_scaled(m_curvature, envelope_arc.footpoint);
    }
    if (envelope_arcs.empty() || envelope_arcs.back().events[1] == Disk_event::UNRESOLVED)
      result.undecided.push_back({known, 1});
    return result;
  }

  // The begin or end of an envelope arc.
  Free_end end_at(std::size_t element, std::size_t i, bool is_end) const
  {
    const std::vector<Envelope_arc>& envelope_arcs = m_envelope_arcs[element];
    const double u = is_end ? envelope_arcs[i].range.end : envelope_arcs[i].range.begin;
    const bool is_last = is_end ? i + 1 == envelope_arcs.size() : i == 0;
    if (envelope_arcs[i].events[is_end] == Disk_event::NONE && is_last)
      return {is_at_scaled_vertex(m_graph->elements()[element], is_end) ? Free_end::Kind::POINT
                                                                        : Free_end::Kind::FRONT_END,
              {u, u}};
    if (is_last || envelope_arcs[i].events[is_end] == Disk_event::UNRESOLVED)
      return {Free_end::Kind::UNDECIDED, {u, u}};
    const Envelope_arc& other = envelope_arcs[is_end ? i + 1 : i - 1];
    const Range location = is_end ? Range{u, other.range.begin} : Range{other.range.end, u};
    if (other.footpoint.kind != Disk_footpoint::Kind::ARC && other.footpoint.kind != Disk_footpoint::Kind::VERTEX)
      return {Free_end::Kind::UNDECIDED, location};
    const Element_part<> part = m_curvature.part(element, location);
    return {Free_end::Kind::FOOTPOINT, location, other.footpoint,
            largest_curvature(*m_graph, m_curvature, part, other.located(is_end ? other.range.begin : other.range.end))
                .range};
  }
};

// With a tag for parallel work, elements are handed to all cores.
template <class Concurrency_tag>
Sector_disks sector_disks(std::shared_ptr<const Site_graph_2<>> graph, std::shared_ptr<const Scaled_sites<>> scaled,
                          const std::vector<std::size_t>& elements, Search_control& control)
{
  check_magnitude(*graph, "trimmed_alpha_sector");
  const Site_tree_2 tree(*graph, scaled->points(*graph));
  const Disk_curvature<> curvature(*graph, scaled.get());
  const auto fine_level = std::make_shared<const Fine_level>(*graph, scaled.get());
  const Cusps_2 cusps = Sector_cusp_finder_2(*graph, curvature, &control)(elements);
  std::vector<std::vector<Envelope_arc>> envelope_arcs(graph->elements().size());
  Rest_of_search rest(graph->elements().size());
  for_each_element<Concurrency_tag>(elements, control, [&](std::size_t element) {
    Maximal_disks<> disks(*graph, tree, curvature, &cusps, control.has_fine_level() ? fine_level.get() : nullptr,
                          &control);
    envelope_arcs[element] = disks(element);
    rest.begins[element] = disks.begin_of_rest();
  });
  rest.why_not = control.reason();
  return Sector_disks(std::move(graph), std::move(scaled), fine_level, elements, std::move(envelope_arcs),
                      std::move(rest));
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_SECTOR_DISKS_H
