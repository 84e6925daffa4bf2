// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SWEEP_SHEETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SWEEP_SHEETS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/sheets/Face_sheet.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The triangles of the boundary of what a solid sweeps, which cross each other: the envelopes of its patches, what its
// edges sweep, and its first and last position where they bound.
class Sweep_sheets
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Cell = std::pair<std::size_t, std::size_t>; // a patch, and the index of a range of time

  // The triangles of the envelope in a cell.
  struct Cell_content
  {
    std::vector<Corners> triangles;
    std::vector<std::array<int, 3>> edges; // of a triangle opposite to its corners: on the boundary, or -1
    std::vector<std::unique_ptr<Boundary_edge>> boundary;
  };

  const Solid_boundary& m_solid;
  Common::Operation_budget& m_budget;
  std::vector<Moving_surface> m_moving;
  Space_of_places m_space;
  Triangle_soup m_soup;
  Points_of_places m_points;
  std::map<Cell, Cell_content> m_cells; // where patches do not move along themselves
  std::map<std::size_t, Double_kernel::Vector_3> m_folds; // points, with normals into the solid
  double m_error = 0;
  std::vector<Undecided_part> m_undecided;

public:
  // \pre Patches are smooth, and no line inside of them touches its envelope all the time. `has_outer_normals` tells it
  // of each moved patch.
  Sweep_sheets(const Solid_boundary& solid, const Rational_motion_3& motion, const std::vector<bool>& has_outer_normals,
               const std::vector<Envelope_surface_3>& envelopes, const Surface_mesh_options& options,
               Common::Operation_budget& budget)
    : m_solid(solid), m_budget(budget), m_moving(moving_surfaces(solid, motion, has_outer_normals)),
      m_space(space_of(motion, envelopes)), m_points(m_moving, m_space, m_soup, options.chord_error)
  {
    for (std::size_t patch = 0; patch < solid.size(); ++patch)
      for (const Envelope_part_3& part : envelopes[patch].parts())
        if (!part.constant_unknown)
          add_part(patch, part, options);
    add_faces();
    add_envelope();
    constexpr double share = 0.5;
    move_folds(share * options.chord_error);
  }

  Triangle_soup& soup() { return m_soup; }

  // Measured: how far the triangles of the envelope are from it.
  double error() const { return m_error; }

  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

private:
  static std::vector<Moving_surface> moving_surfaces(const Solid_boundary& solid, const Rational_motion_3& motion,
                                                     const std::vector<bool>& has_outer_normals)
  {
    std::vector<Moving_surface> result;
    for (std::size_t patch = 0; patch < solid.size(); ++patch)
      result.emplace_back(solid[patch], motion, has_outer_normals[patch]);
    return result;
  }

  // The time is cut where velocities jump. A closed motion counts as an open one where a patch moves along itself, so
  // that it is inside all the time, and not between two times.
  Space_of_places space_of(const Rational_motion_3& motion, const std::vector<Envelope_surface_3>& envelopes) const
  {
    const auto [begin, end] = motion.domain();
    std::set<double> times{to_nearest_double(begin), to_nearest_double(end)};
    std::size_t cells = 0; // with an envelope, which may be empty
    for (const Envelope_surface_3& envelope : envelopes)
      for (const Envelope_part_3& part : envelope.parts())
        if (!part.constant_unknown) {
          const auto& [first, last] = part.solutions.system().domain(2);
          times.insert({to_nearest_double(first), to_nearest_double(last)});
          ++cells;
        }
    const bool is_nowhere_still = cells == m_solid.size() * (times.size() - 1);
    return {m_solid, motion, {times.begin(), times.end()}, is_nowhere_still && motion.has_same_map(begin, end)};
  }

  std::size_t range_of_time(const Constraint_system_d& system) const
  {
    const auto& times = m_space.times();
    return static_cast<std::size_t>(
        std::lower_bound(times.begin(), times.end(), to_nearest_double(system.domain(2).first)) - times.begin());
  }

  void add_part(std::size_t patch, const Envelope_part_3& part, const Surface_mesh_options& options)
  {
    Surface_mesh_options own = options;
    own.is_remeshed = false; // neighbours only need the points of boundaries
    const Solution_surface_mesh found = to_surface_mesh(part.solutions, part.image, own, m_budget.remaining());
    m_budget.add(found.summary());
    m_error = (std::max)(m_error, found.error);
    m_undecided.insert(m_undecided.end(), found.undecided().begin(), found.undecided().end());
    Cell_content& content = m_cells[{patch, range_of_time(part.solutions.system())}];
    const std::vector<std::size_t> points = points_of(patch, found);
    std::map<Mesh::Edge_index, int> edge_of;
    for (const auto edge : found.mesh.edges())
      if (found.mesh.is_border(edge)) {
        const auto halfedge = found.mesh.halfedge(edge);
        const auto from = found.mesh.source(halfedge), to = found.mesh.target(halfedge);
        edge_of[edge] = static_cast<int>(content.boundary.size());
        content.boundary.push_back(std::make_unique<Boundary_edge>(
            Boundary_edge{{place_of(patch, found, from), place_of(patch, found, to)}, {points[from], points[to]}}));
      }
    for (const auto face : found.mesh.faces()) {
      Corners corners;
      std::array<int, 3> edges;
      auto halfedge = found.mesh.halfedge(face);
      for (int k = 0; k < 3; ++k, halfedge = found.mesh.next(halfedge)) {
        corners[static_cast<std::size_t>(k)] = points[found.mesh.source(halfedge)];
        const auto own = edge_of.find(found.mesh.edge(halfedge));
        edges[static_cast<std::size_t>(k)] = own == edge_of.end() ? -1 : own->second;
      }
      content.triangles.push_back(corners);
      content.edges.push_back(edges);
    }
  }

  // On lines where faces meet, places that are the same but for rounding are one.
  Place place_of(std::size_t patch, const Solution_surface_mesh& found, Mesh::Vertex_index vertex)
  {
    const std::vector<double>& unknowns = found.unknowns[vertex];
    const Place result = Space_of_places::snapped(Place{unknowns[0], unknowns[1], unknowns[2]});
    const auto is_cut = [&](int axis) { return m_space.is_cut(axis, result[static_cast<std::size_t>(axis)]); };
    for (int axis = 0; axis < 3; ++axis)
      if (is_cut((axis + 1) % 3) && is_cut((axis + 2) % 3))
        return m_points.on_line(patch, axis, result);
    return result;
  }

  // Those on boundaries are found by their places, as others share them. An edge at a pole is one point.
  std::vector<std::size_t> points_of(std::size_t patch, const Solution_surface_mesh& found)
  {
    std::vector<std::size_t> result(found.mesh.number_of_vertices());
    std::map<Mesh::Vertex_index, Mesh::Vertex_index> same;
    const auto first_of = [&](Mesh::Vertex_index vertex) {
      while (same.count(vertex) > 0)
        vertex = same.at(vertex);
      return vertex;
    };
    for (const auto edge : found.mesh.edges())
      if (found.mesh.is_border(edge)) {
        const auto from = found.mesh.vertex(edge, 0), to = found.mesh.vertex(edge, 1);
        if (is_point_of_pole(patch, place_of(patch, found, from), place_of(patch, found, to)))
          if (const auto p = first_of(from), q = first_of(to); p != q)
            same[q] = p;
      }
    for (const auto vertex : found.mesh.vertices()) {
      const auto first = first_of(vertex);
      result[vertex] = found.mesh.is_border(vertex) ? m_points.index_of({patch, place_of(patch, found, first)})
                                                    : m_points.index_of_point(in_doubles(found.mesh.point(vertex)));
      if (first != vertex)
        m_points.set_index({patch, place_of(patch, found, vertex)}, result[vertex]);
    }
    for (const auto vertex : found.mesh.vertices()) {
      const std::vector<double>& unknowns = found.unknowns[vertex];
      if (const auto step = m_moving[patch].inner_normal_of_fold({unknowns[0], unknowns[1], unknowns[2]}))
        m_folds.try_emplace(result[vertex], *step);
    }
    return result;
  }

  static Double_kernel::Point_3 in_doubles(const Mesh::Point& point) { return {point.x(), point.y(), point.z()}; }

  void add_faces()
  {
    for (std::size_t patch = 0; patch < m_solid.size(); ++patch)
      for (int k = 0; k < 4; ++k)
        for (std::size_t range = 0; range < m_space.number_of_times(); ++range)
          add_face_of_side({patch, k}, range);
    for (std::size_t patch = 0; patch < m_solid.size(); ++patch)
      for (std::size_t cut = 0; cut < m_space.times().size(); ++cut)
        add_position(patch, cut);
  }

  // What a side sweeps in a range of time: once for two that are glued, and of poles, which sweep a curve, where the
  // envelope ends in them.
  void add_face_of_side(const Patch_side& side, std::size_t range)
  {
    const std::optional<Glued_side>& other = m_solid.glued(side);
    if (other && other->side < side)
      return;
    std::array<Face_sheet::Side, 2> sides{side_of_edge(side, {side, false}, range), Face_sheet::Side{false}};
    if (other)
      sides[1] = side_of_edge(side, *other, range);
    else if (sides[0].chain.empty())
      return;
    Place lower{0, 0, m_space.times()[range]}, upper{1, 1, m_space.times()[range + 1]};
    const auto axis = static_cast<std::size_t>(side.axis());
    lower[axis] = upper[axis] = side.end();
    add_face(side.patch, side.axis(), lower, upper, std::move(sides));
  }

  // A patch at a time between two ranges, before all or after all.
  void add_position(std::size_t patch, std::size_t cut)
  {
    const std::size_t last = m_space.number_of_times();
    if (m_space.is_closed() && cut == last)
      return;
    std::array<Face_sheet::Side, 2> sides{Face_sheet::Side{false}, Face_sheet::Side{true}};
    if (cut > 0 || m_space.is_closed())
      sides[0] = side_of_time(patch, cut > 0 ? cut - 1 : last - 1, true);
    if (cut < last)
      sides[1] = side_of_time(patch, cut, false);
    const double time = m_space.times()[cut];
    add_face(patch, 2, {0, 0, time}, {1, 1, time}, std::move(sides));
  }

  void add_face(std::size_t patch, int axis, const Place& lower, const Place& upper,
                std::array<Face_sheet::Side, 2> sides)
  {
    if (!m_budget.must_stop())
      Face_sheet(m_points, patch, axis, lower, upper, std::move(sides), [&] { return m_budget.must_stop(); })();
  }

  static constexpr double m_inside = 0x1p-30; // part of a range: a little inside

  // Of a face at a side, by the parameters of a side that is glued to it.
  Face_sheet::Side side_of_edge(const Patch_side& face, const Glued_side& own, std::size_t range) const
  {
    const auto content = m_cells.find({own.side.patch, range});
    if (content == m_cells.end())
      return {false};
    const auto axis = static_cast<std::size_t>(own.side.axis()), free = 1 - axis;
    const auto face_axis = static_cast<std::size_t>(face.axis()), face_free = 1 - face_axis;
    Face_sheet::Side result{std::nullopt, own.side.patch, [=](const Place& place) {
                              Place inner;
                              inner[axis] = own.side.end() == 0 ? m_inside : 1 - m_inside;
                              inner[free] = own.parameter(place[face_free]);
                              inner[2] = place[2];
                              return inner;
                            }};
    const auto on_face = [&](const Place& place) {
      Place on;
      on[face_axis] = face.end();
      on[face_free] = own.parameter(place[free]);
      on[2] = place[2];
      return on;
    };
    for (const auto& edge : content->second.boundary)
      if (edge->places[0][axis] == own.side.end() && edge->places[1][axis] == own.side.end() &&
          !is_point_of_pole(own.side.patch, edge->places[0], edge->places[1]))
        result.chain.push_back({edge.get(), {on_face(edge->places[0]), on_face(edge->places[1])}});
    return result;
  }

  // Of a position at an end of a range of time. For a closed motion it is that of the first time.
  Face_sheet::Side side_of_time(std::size_t patch, std::size_t range, bool is_end) const
  {
    const auto content = m_cells.find({patch, range});
    if (content == m_cells.end())
      return {false};
    const double lower = m_space.times()[range], upper = m_space.times()[range + 1], time = is_end ? upper : lower;
    const double own = time + (is_end ? -m_inside : m_inside) * (upper - lower);
    Face_sheet::Side result{std::nullopt, patch, [own](const Place& place) { return Place{place[0], place[1], own}; }};
    for (const auto& edge : content->second.boundary)
      if (edge->places[0][2] == time && edge->places[1][2] == time &&
          !is_point_of_pole(patch, edge->places[0], edge->places[1]))
        result.chain.push_back({edge.get(), edge->places});
    return result;
  }

  // Whether an edge is a pole at one time, but for the rounding of its ends.
  bool is_point_of_pole(std::size_t patch, const Place& from, const Place& to) const
  {
    constexpr double rounding = 0x1p-40;
    for (int k = 0; k < 4; ++k) {
      const Patch_side side{patch, k};
      const auto axis = static_cast<std::size_t>(side.axis());
      if (m_space.is_pole(side) && from[axis] == side.end() && to[axis] == side.end())
        return std::abs(from[2] - to[2]) <= rounding * m_space.length(2);
    }
    return false;
  }

  // The triangles of the envelope, with the points that faces need on their edges.
  void add_envelope()
  {
    for (const auto& [cell, content] : m_cells)
      for (std::size_t i = 0; i < content.triangles.size(); ++i) {
        std::vector<std::size_t> around;
        int divided = 0, last = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t corner = content.triangles[i][k];
          around.push_back(corner);
          if (content.edges[i][k] < 0)
            continue;
          std::vector<std::size_t> inner = content.boundary[static_cast<std::size_t>(content.edges[i][k])]->inner;
          if (inner.empty())
            continue;
          if (content.boundary[static_cast<std::size_t>(content.edges[i][k])]->points[0] != corner)
            std::reverse(inner.begin(), inner.end());
          around.insert(around.end(), inner.begin(), inner.end());
          ++divided;
          last = static_cast<int>(k);
        }
        add_polygon(content.triangles[i], around, divided, last);
      }
  }

  // Folds of the envelope lie in what is swept, and may lie deeper in it: then they do not cross the boundary where
  // they are near it, at the ends of creases.
  void move_folds(double distance)
  {
    std::map<std::size_t, Double_kernel::Vector_3> steps = m_folds;
    for (const auto& [cell, content] : m_cells)
      for (const auto& edge : content.boundary) {
        const auto from = m_folds.find(edge->points[0]), to = m_folds.find(edge->points[1]);
        if (from != m_folds.end() && to != m_folds.end())
          for (const std::size_t point : edge->inner)
            steps.try_emplace(point, 0.5 * (from->second + to->second));
      }
    for (const auto& [point, step] : steps)
      m_soup.points[point] = m_soup.points[point] + distance * step;
  }

  void add_polygon(const Corners& corners, const std::vector<std::size_t>& around, int divided, int last)
  {
    if (divided == 0)
      return m_points.add_triangle(corners);
    const std::size_t center = divided == 1
        ? corners[static_cast<std::size_t>((last + 2) % 3)]
        : m_points.index_of_point(
              CGAL::centroid(m_points.point(corners[0]), m_points.point(corners[1]), m_points.point(corners[2])));
    for (std::size_t k = 0; k < around.size(); ++k) {
      const std::size_t next = around[(k + 1) % around.size()];
      if (around[k] != center && next != center)
        m_points.add_triangle({center, around[k], next});
    }
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SWEEP_SHEETS_H
