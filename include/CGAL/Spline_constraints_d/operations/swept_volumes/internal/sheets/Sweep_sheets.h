// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SWEEP_SHEETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SHEETS_SWEEP_SHEETS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
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
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// \throws Invalid_input when an edge is neither a seam nor a pole.
inline void check_closed(const Common::Spline_patch<3>& surface)
{
  for (const int axis : {0, 1})
    for (const Exact_rational& end : {surface.domain(axis).first, surface.domain(axis).second})
      if (!surface.is_closed(axis) && !surface.pole(axis, end))
        throw Invalid_input("swept volume: the surface is not closed: its edge at " +
                            std::string(axis == 0 ? "u" : "v") + " = " + shortest_text(to_nearest_double(end)) +
                            " is neither a seam nor a pole");
}

// The triangles of the boundary of what a closed surface sweeps, which cross each other: its envelope, and its first
// and last position where they bound.
class Sweep_sheets
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Cell = std::array<std::size_t, 3>; // indices of its lower cuts

  // The triangles of the envelope in a cell.
  struct Cell_content
  {
    bool is_still = true; // the surface moves along itself
    std::vector<Corners> triangles;
    std::vector<std::array<int, 3>> edges; // of a triangle opposite to its corners: on the boundary, or -1
    std::vector<std::unique_ptr<Boundary_edge>> boundary;
  };

  const Common::Spline_patch<3>& m_surface;
  const Rational_motion_3& m_motion;
  Common::Operation_budget& m_budget;
  Moving_surface m_moving;
  Space_of_places m_space;
  Triangle_soup m_soup;
  Points_of_places m_points;
  std::map<Cell, Cell_content> m_cells;
  double m_error = 0;
  std::vector<Undecided_part> m_undecided;

public:
  // \pre the surface is closed
  Sweep_sheets(const Common::Spline_patch<3>& surface, const Rational_motion_3& motion,
               bool has_outer_normals, const Envelope_surface_3& envelope, const Surface_mesh_options& options,
               Common::Operation_budget& budget)
    : m_surface(surface), m_motion(motion), m_budget(budget), m_moving(surface, motion, has_outer_normals),
      m_space(space_of(envelope)), m_points(m_moving, m_space, m_soup, options.chord_error)
  {
    for (const Envelope_part_3& part : envelope.parts())
      if (!part.constant_unknown)
        add_part(part, options, budget);
    for_each_cell([&](const Cell& cell) {
      if (m_cells[cell].is_still) // so that it is inside all the time, and not between two times
        m_space.is_closed[2] = false;
    });
    add_faces();
    add_envelope();
  }

  Triangle_soup& soup() { return m_soup; }

  // Measured: how far the triangles of the envelope are from it.
  double error() const { return m_error; }

  const std::vector<Undecided_part>& undecided() const { return m_undecided; }

private:
  Space_of_places space_of(const Envelope_surface_3& envelope) const
  {
    Space_of_places result;
    std::array<std::set<double>, 3> cuts;
    const std::array<Common::Parameter_range, 3> ranges{m_surface.domain(0), m_surface.domain(1), m_motion.domain()};
    const auto add = [&](int axis, const Exact_rational& value) {
      cuts[static_cast<std::size_t>(axis)].insert(to_nearest_double(value));
    };
    for (int axis = 0; axis < 3; ++axis) {
      add(axis, ranges[static_cast<std::size_t>(axis)].first);
      add(axis, ranges[static_cast<std::size_t>(axis)].second);
    }
    for (const Envelope_part_3& part : envelope.parts())
      for (int axis = 0; axis < 3; ++axis)
        if (!part.constant_unknown) {
          const auto& [lower, upper] = part.solutions.system().domain(axis);
          add(axis, lower);
          add(axis, upper);
        } else if (part.constant_unknown->first == axis)
          add(axis, part.constant_unknown->second);
    for (std::size_t a = 0; a < 3; ++a)
      result.cuts[a].assign(cuts[a].begin(), cuts[a].end());
    for (int axis : {0, 1}) {
      const auto& [lower, upper] = ranges[static_cast<std::size_t>(axis)];
      result.is_closed[static_cast<std::size_t>(axis)] = m_surface.is_closed(axis);
      result.is_pole[static_cast<std::size_t>(axis)] = {m_surface.pole(axis, lower).has_value(),
                                                        m_surface.pole(axis, upper).has_value()};
    }
    result.is_closed[2] = m_motion.has_same_map(m_motion.domain().first, m_motion.domain().second);
    return result;
  }

  std::optional<Cell> cell_of(const Constraint_system_d& system) const
  {
    Cell result;
    for (int axis = 0; axis < 3; ++axis) {
      const auto& cuts = m_space.cuts[static_cast<std::size_t>(axis)];
      const auto lower = std::lower_bound(cuts.begin(), cuts.end(), to_nearest_double(system.domain(axis).first));
      result[static_cast<std::size_t>(axis)] = static_cast<std::size_t>(lower - cuts.begin());
      if (*(lower + 1) != to_nearest_double(system.domain(axis).second))
        return std::nullopt;
    }
    return result;
  }

  void add_part(const Envelope_part_3& part, const Surface_mesh_options& options, Common::Operation_budget& budget)
  {
    const std::optional<Cell> cell = cell_of(part.solutions.system());
    if (!cell && !part.solutions.patches().empty()) {
      m_undecided.push_back({{}, {}, "the envelope goes on beside a line of the surface that touches it all the time"});
      return;
    }
    if (!cell)
      return add_empty_cells(part.solutions.system());
    Surface_mesh_options own = options;
    own.is_remeshed = false; // neighbours only need the points of boundaries
    const Solution_surface_mesh found = to_surface_mesh(part.solutions, part.image, own, budget.remaining());
    budget.add(found.summary());
    m_error = (std::max)(m_error, found.error);
    m_undecided.insert(m_undecided.end(), found.undecided().begin(), found.undecided().end());
    Cell_content& content = m_cells[*cell];
    content.is_still = false;
    const std::vector<std::size_t> points = points_of(found);
    std::map<Mesh::Edge_index, int> edge_of;
    for (const auto edge : found.mesh.edges())
      if (found.mesh.is_border(edge)) {
        const auto halfedge = found.mesh.halfedge(edge);
        const auto from = found.mesh.source(halfedge), to = found.mesh.target(halfedge);
        edge_of[edge] = static_cast<int>(content.boundary.size());
        content.boundary.push_back(std::make_unique<Boundary_edge>(
            Boundary_edge{{place_of(found, from), place_of(found, to)}, {points[from], points[to]}}));
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

  // All cells of a box without a part of the envelope.
  void add_empty_cells(const Constraint_system_d& system)
  {
    for_each_cell([&](const Cell& cell) {
      for (int axis = 0; axis < 3; ++axis) {
        const double lower = m_space.cuts[static_cast<std::size_t>(axis)][cell[static_cast<std::size_t>(axis)]];
        if (lower < to_nearest_double(system.domain(axis).first) ||
            lower >= to_nearest_double(system.domain(axis).second))
          return;
      }
      m_cells[cell].is_still = false;
    });
  }

  // On lines where faces meet, places that are the same but for rounding are one.
  Place place_of(const Solution_surface_mesh& found, Mesh::Vertex_index vertex)
  {
    const std::vector<double>& unknowns = found.unknowns[vertex];
    const Place result{unknowns[0], unknowns[1], unknowns[2]};
    for (int axis = 0; axis < 3; ++axis)
      if (is_cut((axis + 1) % 3, result) && is_cut((axis + 2) % 3, result))
        return m_points.on_line(axis, result);
    return result;
  }

  // Those on boundaries are found by their places, as others share them. An edge at a pole is one point.
  std::vector<std::size_t> points_of(const Solution_surface_mesh& found)
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
        if (is_point_of_pole(place_of(found, from), place_of(found, to)))
          if (const auto p = first_of(from), q = first_of(to); p != q)
            same[q] = p;
      }
    for (const auto vertex : found.mesh.vertices()) {
      const auto first = first_of(vertex);
      result[vertex] = found.mesh.is_border(vertex) ? m_points.index_of(place_of(found, first))
                                                    : m_points.index_of_point(in_doubles(found.mesh.point(vertex)));
      if (first != vertex)
        m_points.set_index(place_of(found, vertex), result[vertex]);
    }
    return result;
  }

  static Double_kernel::Point_3 in_doubles(const Mesh::Point& point) { return {point.x(), point.y(), point.z()}; }

  template <class Visitor>
  void for_each_cell(const Visitor& visit) const
  {
    Cell cell;
    for (cell[0] = 0; cell[0] + 1 < m_space.cuts[0].size(); ++cell[0])
      for (cell[1] = 0; cell[1] + 1 < m_space.cuts[1].size(); ++cell[1])
        for (cell[2] = 0; cell[2] + 1 < m_space.cuts[2].size(); ++cell[2])
          visit(cell);
  }

  void add_faces()
  {
    for (int axis = 0; axis < 3; ++axis)
      for_each_cell([&](const Cell& cell) { add_lower_face(axis, cell); });
    for (int axis = 0; axis < 3; ++axis)
      for_each_cell([&](const Cell& cell) {
        const auto a = static_cast<std::size_t>(axis);
        if (cell[a] + 2 == m_space.cuts[a].size() && !m_space.is_closed[a])
          add_face(axis, cell, std::nullopt);
      });
  }

  bool is_cut(int axis, const Place& place) const
  {
    const auto& cuts = m_space.cuts[static_cast<std::size_t>(axis)];
    return std::binary_search(cuts.begin(), cuts.end(), place[static_cast<std::size_t>(axis)]);
  }

  // The face at the lower end of a cell, with the cell below; that at the first end with the last cell, if they are the
  // same.
  void add_lower_face(int axis, const Cell& cell)
  {
    const auto a = static_cast<std::size_t>(axis);
    Cell below = cell;
    if (cell[a] > 0)
      --below[a];
    else if (m_space.is_closed[a])
      below[a] = m_space.cuts[a].size() - 2;
    else
      return add_face(axis, std::nullopt, cell);
    add_face(axis, below, cell);
  }

  void add_face(int axis, const std::optional<Cell>& below, const std::optional<Cell>& above)
  {
    if (m_budget.must_stop())
      return;
    const auto a = static_cast<std::size_t>(axis);
    Place lower, upper;
    const Cell& cell = above ? *above : *below;
    for (std::size_t k = 0; k < 3; ++k) {
      lower[k] = m_space.cuts[k][cell[k]];
      upper[k] = m_space.cuts[k][cell[k] + 1];
    }
    lower[a] = upper[a] = above ? lower[a] : upper[a];
    std::array<Face_sheet::Side, 2> sides{side_of(axis, below, true), side_of(axis, above, false)};
    const bool is_pole = axis < 2 && !(below && above);
    if (!is_pole || !sides[0].chain.empty() || !sides[1].chain.empty())
      Face_sheet(m_points, axis, lower, upper, std::move(sides), [&] { return m_budget.must_stop(); })();
  }

  Face_sheet::Side side_of(int axis, const std::optional<Cell>& cell, bool is_below)
  {
    if (!cell)
      return {axis == 2 && !is_below, 0};
    const auto a = static_cast<std::size_t>(axis);
    const double lower = m_space.cuts[a][(*cell)[a]], upper = m_space.cuts[a][(*cell)[a] + 1];
    constexpr double inside = 0x1p-30; // part of the cell
    const double value = is_below ? upper : lower;
    Face_sheet::Side result{std::nullopt, value + (is_below ? -inside : inside) * (upper - lower)};
    const Cell_content& content = m_cells.at(*cell);
    if (content.is_still)
      result.is_inward = false;
    for (const auto& edge : content.boundary)
      if (edge->places[0][a] == value && edge->places[1][a] == value &&
          !is_point_of_pole(edge->places[0], edge->places[1]))
        result.chain.push_back(edge.get());
    return result;
  }

  // Whether an edge is a pole at one time, but for the rounding of its ends.
  bool is_point_of_pole(const Place& from, const Place& to) const
  {
    constexpr double rounding = 0x1p-40;
    const bool is_one_time = std::abs(from[2] - to[2]) <= rounding * (m_space.cuts[2].back() - m_space.cuts[2].front());
    for (int axis : {0, 1})
      if (m_space.is_at_pole(from, axis) && m_space.is_at_pole(to, axis))
        return is_one_time;
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
