// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_FACE_SHEET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_FACE_SHEET_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Points_of_places.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// An edge on the boundary of the envelope.
struct Boundary_edge
{
  std::array<Place, 2> places;
  std::array<std::size_t, 2> points;
  std::vector<std::size_t> inner = {}; // points on it, from the first one on, that others need
};

// That edge, where it lies on a face, by the parameters of the face.
struct Edge_on_face
{
  Boundary_edge* edge;
  std::array<Place, 2> places;
};

/*
The triangles of a face between two cells of places, or of a face of the box of all places. In a cell the moving surface
goes inwards where its velocity points against the normal; the boundary of what is swept are the envelope, which bounds
the places where it goes inwards, and the places on faces where it does so on one side alone. Before all times it goes
nowhere inwards, after all times everywhere. At an edge of the solid this leaves what the edge sweeps while the
surface goes inwards on one side of it. Where the edge is smooth, as on a seam, velocities are the same on both sides,
and there remain the slivers between the two chains of edges in which the envelope ends on either side, which are
joined by them.
*/
class Face_sheet
{
public:
  // A side of the face: whether the surface goes inwards there everywhere, nowhere, or where edges of the envelope
  // tell.
  struct Side
  {
    std::optional<bool> is_inward; // everywhere, if that is known; else by the patch on this side
    std::size_t patch = 0;
    std::function<Place(const Place&)> inner = {}; // the place of it a little inside of the cell
    std::vector<Edge_on_face> chain = {};
  };

private:
  using Point_2 = Exact_kernel::Point_2;
  struct Vertex_label
  {
    Place place{};
    bool is_known = false;
    std::optional<std::size_t> index = {}; // of its point, once it was asked for
  };
  struct Face_label
  {
    std::array<bool, 2> is_inward{};
    bool is_reached = false;
  };
  using Vertices = CGAL::Triangulation_vertex_base_with_info_2<Vertex_label, Exact_kernel>;
  using Faces = CGAL::Triangulation_face_base_with_info_2<Face_label, Exact_kernel,
                                                          CGAL::Constrained_triangulation_face_base_2<Exact_kernel>>;
  using Triangulation = CGAL::Constrained_triangulation_plus_2<CGAL::Constrained_Delaunay_triangulation_2<
      Exact_kernel, CGAL::Triangulation_data_structure_2<Vertices, Faces>, CGAL::Exact_intersections_tag>>;
  using Vertex = Triangulation::Vertex_handle;
  using Face = Triangulation::Face_handle;

  Points_of_places& m_points;
  std::size_t m_patch; // the parameters are those of this one
  int m_axis;
  std::array<std::size_t, 2> m_free; // the other axes
  Place m_lower, m_upper;
  std::array<double, 2> m_scale{1, 1};
  std::array<Side, 2> m_sides;
  std::function<bool()> m_is_stopped; // then the triangles are coarse, and nobody uses them
  Triangulation m_triangulation;
  std::map<std::array<double, 2>, Vertex> m_vertex_at;
  std::map<std::array<double, 2>, Double_kernel::Point_3> m_moved; // points of places
  std::map<std::pair<Vertex, Vertex>, Triangulation::Constraint_id> m_constraints;
  std::array<std::vector<std::pair<Triangulation::Constraint_id, Boundary_edge*>>, 2> m_edges;
  std::array<std::set<Triangulation::Constraint_id>, 2> m_is_of_chain;
  std::array<std::optional<std::pair<Point_2, bool>>, 2> m_seeds; // see label_faces()

public:
  // The face where the axis has the value of the lower and the upper place.
  Face_sheet(Points_of_places& points, std::size_t patch, int axis, const Place& lower, const Place& upper,
             std::array<Side, 2> sides, std::function<bool()> is_stopped)
    : m_points(points), m_patch(patch), m_axis(axis), m_free{axis == 0 ? 1u : 0u, axis == 2 ? 1u : 2u}, m_lower(lower),
      m_upper(upper), m_sides(std::move(sides)), m_is_stopped(std::move(is_stopped))
  {}

  // Adds its triangles, and tells edges of the envelope which points they need.
  void operator()()
  {
    if (m_sides[0].chain.empty() && m_sides[1].chain.empty() && !is_kept_without_chains())
      return;
    choose_scale();
    add_lines();
    for (int side : {0, 1})
      add_chain(side);
    name_made_vertices();
    refine();
    add_triangles();
    tell_edges();
  }

private:
  bool is_kept_without_chains()
  {
    Place middle;
    for (std::size_t a = 0; a < 3; ++a)
      middle[a] = 0.5 * (m_lower[a] + m_upper[a]);
    return is_inward_at(0, middle) != is_inward_at(1, middle);
  }

  bool is_inward_at(int side, const Place& place) const
  {
    const Side& own = m_sides[static_cast<std::size_t>(side)];
    return own.is_inward ? *own.is_inward : m_points.moving(own.patch).is_inward(own.inner(place));
  }

  double speed_at(int side, const Place& place) const
  {
    const Side& own = m_sides[static_cast<std::size_t>(side)];
    return m_points.moving(own.patch).speed(own.inner(place));
  }

  const Moving_surface& moving() const { return m_points.moving(m_patch); }

  std::size_t index_of(Vertex vertex)
  {
    std::optional<std::size_t>& index = vertex->info().index;
    if (!index)
      index = m_points.index_of({m_patch, vertex->info().place});
    return *index;
  }

  // Lengths in space, about, so that triangles are well-shaped.
  void choose_scale()
  {
    constexpr int steps = 8;
    for (std::size_t i = 0; i < 2; ++i) {
      double length = 0;
      for (int k = 1; k < steps; ++k) {
        Place from = m_lower, to = m_lower;
        const std::size_t other = m_free[1 - i], own = m_free[i];
        from[other] = to[other] = m_lower[other] + (m_upper[other] - m_lower[other]) * k / steps;
        from[own] = m_lower[own] + (m_upper[own] - m_lower[own]) * (k - 1) / steps;
        to[own] = m_lower[own] + (m_upper[own] - m_lower[own]) * k / steps;
        length += std::sqrt(CGAL::squared_distance(moving()(from), moving()(to)));
      }
      const double range = m_upper[m_free[i]] - m_lower[m_free[i]];
      m_scale[i] = std::exp2(std::round(std::log2(length > 0 ? length / range : 1 / range))); // products are exact
    }
  }

  Vertex vertex_at(const Place& place)
  {
    const std::array<double, 2> seen{place[m_free[0]], place[m_free[1]]};
    const auto [known, is_new] = m_vertex_at.try_emplace(seen);
    if (is_new) {
      known->second = m_triangulation.insert(Point_2(seen[0] * m_scale[0], seen[1] * m_scale[1]));
      known->second->info() = {on_face(place), true, {}};
    }
    return known->second;
  }

  Place on_face(Place place) const
  {
    place[static_cast<std::size_t>(m_axis)] = m_lower[static_cast<std::size_t>(m_axis)];
    return place;
  }

  void add_lines()
  {
    for (std::size_t i = 0; i < 2; ++i)
      for (double end : {m_lower[m_free[1 - i]], m_upper[m_free[1 - i]]}) {
        Place from = m_lower;
        from[m_free[1 - i]] = end;
        const std::vector<Place> places =
            m_points.places_on_line(m_patch, static_cast<int>(m_free[i]), from, m_lower[m_free[i]], m_upper[m_free[i]]);
        for (std::size_t k = 1; k < places.size(); ++k)
          add_constraint(vertex_at(places[k - 1]), vertex_at(places[k]));
      }
  }

  void add_chain(int side)
  {
    for (const auto& [edge, places] : m_sides[static_cast<std::size_t>(side)].chain) {
      const Vertex from = vertex_at(places[0]), to = vertex_at(places[1]);
      if (from == to)
        continue;
      m_edges[side].emplace_back(add_constraint(from, to), edge);
      m_is_of_chain[side].insert(m_edges[side].back().first);
    }
  }

  Triangulation::Constraint_id add_constraint(Vertex from, Vertex to)
  {
    const auto [known, is_new] = m_constraints.try_emplace({(std::min)(from, to), (std::max)(from, to)});
    if (is_new)
      known->second = m_triangulation.insert_constraint(from, to);
    return known->second;
  }

  // Those where chains cross.
  void name_made_vertices()
  {
    for (Vertex vertex : m_triangulation.finite_vertex_handles())
      if (!vertex->info().is_known)
        vertex->info() = {place_of(vertex->point()), true, {}};
  }

  Place place_of(const Point_2& point) const
  {
    Place result = m_lower;
    const std::array<double, 2> seen{CGAL::to_double(point.x()) / m_scale[0], CGAL::to_double(point.y()) / m_scale[1]};
    for (std::size_t i = 0; i < 2; ++i)
      result[m_free[i]] = (std::clamp)(seen[i], m_lower[m_free[i]], m_upper[m_free[i]]);
    return result;
  }

  Place middle_of(Face face) const
  {
    Place result = m_lower;
    for (std::size_t i = 0; i < 2; ++i)
      result[m_free[i]] = (face->vertex(0)->info().place[m_free[i]] + face->vertex(1)->info().place[m_free[i]] +
                           face->vertex(2)->info().place[m_free[i]]) /
          3;
    return result;
  }

  // Tells of all faces whether the surface goes inwards: from the place where it moves fastest, across the chains.
  void label_faces()
  {
    for (int side : {0, 1}) {
      if (m_sides[side].is_inward) {
        for (Face face : m_triangulation.finite_face_handles())
          face->info().is_inward[side] = *m_sides[side].is_inward;
        continue;
      }
      if (!m_seeds[side])
        choose_seed(side);
      for (Face face : m_triangulation.finite_face_handles())
        face->info().is_reached = false;
      const Face seed = m_triangulation.locate(m_seeds[side]->first);
      seed->info().is_inward[side] = m_seeds[side]->second;
      seed->info().is_reached = true;
      std::deque<Face> reached{seed};
      while (!reached.empty()) {
        const Face face = reached.front();
        reached.pop_front();
        for (int k = 0; k < 3; ++k) {
          const Face next = face->neighbor(k);
          if (m_triangulation.is_infinite(next) || next->info().is_reached)
            continue;
          next->info().is_inward[side] = face->info().is_inward[side] != is_on_chain(side, face, k);
          next->info().is_reached = true;
          reached.push_back(next);
        }
      }
    }
  }

  void choose_seed(int side)
  {
    Face seed;
    double fastest = -1;
    for (Face face : m_triangulation.finite_face_handles())
      if (const double speed = std::abs(speed_at(side, middle_of(face))); speed > fastest) {
        fastest = speed;
        seed = face;
      }
    // the exact middle is inside of the face
    m_seeds[side] = {CGAL::centroid(seed->vertex(0)->point(), seed->vertex(1)->point(), seed->vertex(2)->point()),
                     is_inward_at(side, middle_of(seed))};
  }

  // Whether an odd number of edges of a chain is there.
  bool is_on_chain(int side, Face face, int k) const
  {
    if (!face->is_constrained(k))
      return false;
    bool result = false;
    const Vertex p = face->vertex(Triangulation::cw(k)), q = face->vertex(Triangulation::ccw(k));
    for (auto context = m_triangulation.contexts_begin(p, q); context != m_triangulation.contexts_end(p, q); ++context)
      if (m_is_of_chain[side].count(context->id()) > 0)
        result = !result;
    return result;
  }

  bool is_kept(Face face) const { return face->info().is_inward[0] != face->info().is_inward[1]; }

  // By value, as the next one may be a new point.
  Double_kernel::Point_3 point_of(Vertex vertex) { return m_points.point(index_of(vertex)); }

  void refine()
  {
    constexpr int rounds = 8;
    for (int round = 0; round < rounds && !m_is_stopped(); ++round) {
      label_faces();
      std::vector<Place> wanted;
      for (Face face : m_triangulation.finite_face_handles())
        if (is_kept(face) && !append_middles_of_edges(face, wanted) && is_coarse(face))
          wanted.push_back(middle_of(face));
      if (wanted.empty())
        return;
      std::sort(wanted.begin(), wanted.end());
      wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
      for (const Place& place : wanted)
        vertex_at(place);
    }
    label_faces();
  }

  bool is_coarse(Face face)
  {
    const auto middle = CGAL::centroid(point_of(face->vertex(0)), point_of(face->vertex(1)), point_of(face->vertex(2)));
    return is_far(middle, middle_of(face));
  }

  // Those of long edges between triangles that are kept, which are no part of a line or a chain.
  bool append_middles_of_edges(Face face, std::vector<Place>& wanted)
  {
    bool result = false;
    for (int k = 0; k < 3; ++k) {
      const Face next = face->neighbor(k);
      if (face->is_constrained(k) || m_triangulation.is_infinite(next))
        continue;
      const Vertex p = face->vertex(Triangulation::cw(k)), q = face->vertex(Triangulation::ccw(k));
      Place middle = m_lower;
      for (std::size_t i = 0; i < 2; ++i)
        middle[m_free[i]] = 0.5 * (p->info().place[m_free[i]] + q->info().place[m_free[i]]);
      if (is_far(CGAL::midpoint(point_of(p), point_of(q)), middle)) {
        wanted.push_back(middle);
        result = true;
      }
    }
    return result;
  }

  // Asked for each edge from both sides, and in each round again.
  bool is_far(const Double_kernel::Point_3& point, const Place& place)
  {
    const double allowed = m_points.chord_error();
    const auto [known, is_new] = m_moved.try_emplace({place[m_free[0]], place[m_free[1]]});
    if (is_new)
      known->second = moving()(place);
    return CGAL::squared_distance(point, known->second) > allowed * allowed;
  }

  void add_triangles()
  {
    for (Face face : m_triangulation.finite_face_handles())
      if (is_kept(face)) {
        Corners corners;
        for (int k = 0; k < 3; ++k)
          corners[k] = index_of(face->vertex(k));
        m_points.add_triangle(corners);
      }
  }

  void tell_edges()
  {
    for (int side : {0, 1})
      for (const auto& [id, edge] : m_edges[side]) {
        std::vector<std::size_t> on_edge;
        for (auto vertex = m_triangulation.vertices_in_constraint_begin(id);
             vertex != m_triangulation.vertices_in_constraint_end(id); ++vertex)
          on_edge.push_back(index_of(*vertex));
        if (on_edge.front() != edge->points[0])
          std::reverse(on_edge.begin(), on_edge.end());
        edge->inner.assign(on_edge.begin() + 1, on_edge.end() - 1);
      }
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_FACE_SHEET_H
