// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_TRIANGULATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_TRIANGULATION_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Triangle_bound.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

// What belongs to a triangle: the index of its face of the surface, if it has the label that is asked for, and the
// bound of its error, once it is known.
struct Triangle_info
{
  std::optional<std::size_t> face = {};
  std::optional<double> error = {};
};

// What belongs to a vertex: its point on the surface, once it is known and unless it is a pole; its place in the mesh.
struct Vertex_info
{
  bool is_known = false;
  std::optional<Triangle_bound::Point> point = {};
  std::optional<Trimmed_surface_mesh_3::Mesh::Vertex_index> index = {};
};

/*
Triangles in a cell, whose faces are bounded by constraints. A triangle whose distance to the surface is too great is
split at the middle of its longest edge; that is exact, so constraints stay where they are. A new vertex only has
triangles around it on the two sides of this edge: if it is a constraint, those on each side belong to the face there.
*/
class Cell_triangulation
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<Vertex_info, Kernel>;
  using Face_base = CGAL::Triangulation_face_base_with_info_2<Triangle_info, Kernel,
                                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>;
  using Vertex = Triangulation::Vertex_handle;
  using Triangle = Triangulation::Face_handle;
  using Point = Kernel::Point_2;
  using Loop = std::vector<Surface_face_edge_3>;

  const Surface_cell_3& m_cell;
  Triangle_bound m_bound;
  Triangulation m_triangulation;

public:
  explicit Cell_triangulation(const Surface_cell_3& cell) : m_cell(cell), m_bound(cell) {}

  void add_constraints(const Surface_face_3& face)
  {
    for (const Loop& loop : face.loops)
      for (std::size_t i = 0; i < loop.size(); ++i)
        m_triangulation.insert_constraint(local(loop[i]), local(loop[(i + 1) % loop.size()]));
  }

  // Marks the triangles of a face, from one beside its boundary.
  void mark(const Surface_face_3& face, std::size_t index)
  {
    const Loop& loop = face.loops.front();
    const Vertex first = m_triangulation.insert(local(loop[0])), second = m_triangulation.insert(local(loop[1]));
    Triangle seed;
    int opposite = 0;
    m_triangulation.is_edge(first, second, seed, opposite);
    if (seed->vertex(Triangulation::ccw(opposite)) != first) // it is on the right
      seed = seed->neighbor(opposite);
    std::vector<Triangle> open{seed};
    seed->info().face = index;
    while (!open.empty()) {
      const Triangle triangle = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Triangle next = triangle->neighbor(i);
        if (triangle->is_constrained(i) || next->info().face)
          continue;
        next->info().face = index;
        open.push_back(next);
      }
    }
  }

  // Splits triangles until the error of all is small enough; whether it is so in the end.
  bool refine(double error, Common::Run_of_steps& run)
  {
    constexpr std::size_t most_vertices = 2000000;
    bool has_changed = true;
    while (std::exchange(has_changed, false)) {
      std::vector<std::array<Vertex, 3>> coarse;
      for (const Triangle triangle : m_triangulation.finite_face_handles())
        if (triangle->info().face && !(error_of(triangle) <= error))
          coarse.push_back({triangle->vertex(0), triangle->vertex(1), triangle->vertex(2)});
      for (const auto& [a, b, c] : coarse) {
        Triangle triangle;
        if (!m_triangulation.is_face(a, b, c, triangle))
          continue;
        if (run.must_stop() || m_triangulation.number_of_vertices() > most_vertices || !split(triangle))
          return false;
        has_changed = true;
      }
    }
    return true;
  }

  // Adds the triangles with a point for each vertex to a mesh; whether there were no others.
  bool add_to(Trimmed_surface_mesh_3& result)
  {
    bool is_complete = true;
    for (const Triangle triangle : m_triangulation.finite_face_handles()) {
      if (!triangle->info().face)
        continue;
      const double error = error_of(triangle);
      if (!std::isfinite(error)) {
        is_complete = false;
        continue;
      }
      if (is_at_pole(triangle))
        continue;
      std::array<Trimmed_surface_mesh_3::Mesh::Vertex_index, 3> vertices;
      for (int i = 0; i < 3; ++i)
        vertices[static_cast<std::size_t>(i)] = vertex_in(result, triangle->vertex(i));
      auto face = result.mesh.add_face(vertices[0], vertices[1], vertices[2]);
      if (face == Trimmed_surface_mesh_3::Mesh::null_face()) { // faces meet in a point only
        for (int i = 0; i < 3; ++i) {
          triangle->vertex(i)->info().index.reset();
          vertices[static_cast<std::size_t>(i)] = vertex_in(result, triangle->vertex(i));
        }
        face = result.mesh.add_face(vertices[0], vertices[1], vertices[2]);
      }
      result.surface_face[face] = *triangle->info().face;
      result.error = (std::max)(result.error, error);
    }
    return is_complete;
  }

private:
  // The numbers are doubles, unless the domain of the surface was changed.
  Point local(const Surface_face_edge_3& edge) const
  {
    return Point(Kernel::FT(m_cell.local_parameter(0, edge.source.x())),
                 Kernel::FT(m_cell.local_parameter(1, edge.source.y())));
  }

  static Triangle_bound::Local_point enclosure(const Vertex& vertex)
  {
    return {CGAL::to_interval(vertex->point().x()), CGAL::to_interval(vertex->point().y())};
  }

  const std::optional<Triangle_bound::Point>& point_of(const Vertex& vertex) const
  {
    if (!std::exchange(vertex->info().is_known, true)) {
      const Triangle_bound::Local_point at = enclosure(vertex);
      const Upward_rounding_guard guard;
      vertex->info().point = m_bound.point(at);
    }
    return vertex->info().point;
  }

  double error_of(const Triangle& triangle) const
  {
    std::optional<double>& error = triangle->info().error;
    if (!error) {
      std::array<Triangle_bound::Local_point, 3> parameters;
      std::array<Triangle_bound::Point, 3> points;
      for (int i = 0; i < 3; ++i) {
        const auto& point = point_of(triangle->vertex(i));
        if (!point) {
          error = std::numeric_limits<double>::infinity();
          return *error;
        }
        points[static_cast<std::size_t>(i)] = *point;
        parameters[static_cast<std::size_t>(i)] = enclosure(triangle->vertex(i));
      }
      const Upward_rounding_guard guard;
      error = m_bound(parameters, points);
    }
    return *error;
  }

  // Whether two vertices are one point, so that there is no triangle.
  bool is_at_pole(const Triangle& triangle) const
  {
    const auto &p = point_of(triangle->vertex(0)), &q = point_of(triangle->vertex(1)),
               &r = point_of(triangle->vertex(2));
    return p == q || q == r || r == p;
  }

  // At the middle of the edge that is longest on the surface, or in the cell if that is not known. False if the cell
  // has become too small.
  bool split(const Triangle& triangle)
  {
    const auto squared_length = [&](int i) {
      const Vertex a = triangle->vertex(Triangulation::ccw(i)), b = triangle->vertex(Triangulation::cw(i));
      const auto &p = point_of(a), &q = point_of(b);
      return p && q ? CGAL::squared_distance(*p, *q) : CGAL::to_double(CGAL::squared_distance(a->point(), b->point()));
    };
    int longest = 0;
    double greatest = squared_length(0);
    for (const int i : {1, 2})
      if (const double length = squared_length(i); length > greatest) {
        longest = i;
        greatest = length;
      }
    const Vertex a = triangle->vertex(Triangulation::ccw(longest)), b = triangle->vertex(Triangulation::cw(longest));
    constexpr double least_length = 0x1p-30;
    if (CGAL::to_double(CGAL::squared_distance(a->point(), b->point())) < least_length * least_length)
      return false;
    const Point first = a->point(), second = b->point();
    const std::optional<std::size_t> left = triangle->info().face, right = triangle->neighbor(longest)->info().face;
    const Vertex vertex = m_triangulation.insert(CGAL::midpoint(first, second), Triangulation::EDGE, triangle, longest);
    Triangulation::Face_circulator around = m_triangulation.incident_faces(vertex), done = around;
    do {
      around->info() = {};
      if (m_triangulation.is_infinite(around))
        continue;
      const Point middle = CGAL::centroid(m_triangulation.triangle(around));
      around->info().face = CGAL::orientation(first, second, middle) == CGAL::RIGHT_TURN ? right : left;
    } while (++around != done);
    return true;
  }

  Trimmed_surface_mesh_3::Mesh::Vertex_index vertex_in(Trimmed_surface_mesh_3& result, const Vertex& vertex) const
  {
    auto& index = vertex->info().index;
    if (!index) {
      index = result.mesh.add_vertex(*point_of(vertex));
      const auto exact = [&](int axis) {
        return m_cell.parameter(axis, Exact_rational(CGAL::exact(vertex->point()[axis])));
      };
      result.parameters[*index] = {exact(0), exact(1)};
    }
    return *index;
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE Trimmed_surface_mesh_3 mesh_of_label(const Trimmed_surface_3& surface, int label,
                                                                    double error, const Solver_options& options)
{
  if (!(error > 0) || !std::isfinite(error))
    throw Invalid_input("to_surface_mesh: the error must be positive and finite");
  Common::Run_of_steps run(options);
  Trimmed_surface_mesh_3 result;
  result.parameters =
      result.mesh
          .add_property_map<Trimmed_surface_mesh_3::Mesh::Vertex_index, Trimmed_surface_mesh_3::Parameters>(
              "v:parameters")
          .first;
  result.surface_face =
      result.mesh.add_property_map<Trimmed_surface_mesh_3::Mesh::Face_index, std::size_t>("f:surface_face").first;
  result.undecided_parts = surface.undecided();
  for (std::size_t cell = 0; cell < surface.cells().size(); ++cell) {
    Cell_triangulation triangulation(surface.cells()[cell]);
    std::vector<std::size_t> faces;
    for (std::size_t f = 0; f < surface.faces().size(); ++f)
      if (surface.faces()[f].cell == cell && surface.faces()[f].label == label)
        faces.push_back(f);
    if (faces.empty())
      continue;
    for (const std::size_t f : faces)
      triangulation.add_constraints(surface.faces()[f]);
    for (const std::size_t f : faces)
      triangulation.mark(surface.faces()[f], f);
    const bool is_fine = triangulation.refine(error, run), has_all = triangulation.add_to(result);
    if (!is_fine || !has_all) {
      const auto& [u, v] = surface.cells()[cell].domain;
      result.undecided_parts.push_back({{},
                                        {{0, {to_double_range(u), to_double_range(v)}}},
                                        run.is_stopped() ? in_words(run.reason()) : "triangles with a greater error"});
    }
  }
  result.work = run.summary(result.undecided_parts.empty());
  return result;
}

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_CELL_TRIANGULATION_H
