// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_OF_SOLUTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_OF_SOLUTIONS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_crossings.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_mesher.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_remesher.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Makes the mesh of all surfaces of a solution.
class Mesh_of_solutions
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Triangle = std::array<std::size_t, 3>;

  const Surface_solution_set_d& m_set;
  const Surface_mesh_options& m_options;
  Run_control& m_control;
  Mesh_points m_points;
  Surface_mesher m_mesher;
  std::vector<Vertex> m_vertex_of; // of points and their copies; null where no triangle is
  Remeshed_vertices m_vertices;
  std::set<std::size_t> m_apart; // patches with triangles that do not join the others

public:
  Mesh_of_solutions(const Surface_solution_set_d& set, const Image_functions* image,
                    const Surface_mesh_options& options, Run_control& control)
    : m_set(set), m_options(options), m_control(control), m_points(set, image, options), m_mesher(m_points, control)
  {}

  // Triangles that are made well-shaped need to be only as fine before as neighbours should be; if that was too coarse,
  // so that the mesh crosses itself afterwards, they are as fine as all are to be, and vertices do not leave the
  // surface.
  Solution_surface_mesh operator()()
  {
    Solution_surface_mesh result;
    if ((!m_options.is_remeshed || !remesh(result, true)) && !remesh(result, false))
      Surface_remesher(result, m_points, m_vertices, m_control).measure_error();
    result.mesh.remove_property_map(m_vertices);
    name_undecided(result);
    return result;
  }

private:
  // Whether it is remeshed and embedded, if that is so in the space of the unknowns; otherwise, unless it began coarse,
  // it is as it was before.
  bool remesh(Solution_surface_mesh& result, bool begins_coarse)
  {
    constexpr double angle = 1;
    if (begins_coarse)
      m_points.set_angle_only(angle);
    result = mesh_of_patches();
    m_points.set_options(m_options);
    if (!m_options.is_remeshed)
      return false;
    std::optional<Solution_surface_mesh> before;
    if (!begins_coarse)
      before = result;
    if (Surface_remesher(result, m_points, m_vertices, m_control).run(!begins_coarse) &&
        (m_points.surface().dimension() != 3 || !Mesh_crossings(result, m_set).exist()))
      return true;
    if (before) {
      result = *std::move(before);
      m_vertices = result.mesh.add_property_map<Vertex, Remeshed_vertex>("v:remeshing").first;
    }
    return false;
  }

  Solution_surface_mesh mesh_of_patches()
  {
    std::vector<Triangle> triangles;
    std::vector<std::size_t> patch_of_triangle;
    const std::vector<std::vector<Triangle>>& of_patches = m_mesher();
    for (std::size_t p = 0; p < of_patches.size(); ++p) {
      triangles.insert(triangles.end(), of_patches[p].begin(), of_patches[p].end());
      patch_of_triangle.resize(triangles.size(), p);
    }
    Solution_surface_mesh result;
    m_vertices = result.mesh.add_property_map<Vertex, Remeshed_vertex>("v:remeshing").first;
    const std::set<std::size_t> singular(m_set.singular_points().begin(), m_set.singular_points().end());
    const std::vector<std::size_t> copies = separate_fans(triangles, singular, m_points.size());
    m_apart.clear();
    m_vertex_of.assign(m_points.size() + copies.size(), Mesh::null_vertex());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      std::array<Vertex, 3> corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = vertex_at(result, triangles[t][k], copies);
      const auto face = result.mesh.add_face(corners[0], corners[1], corners[2]);
      if (face == Mesh::null_face())
        m_apart.insert(patch_of_triangle[t]);
      else
        result.surface[face] = m_set.patches()[patch_of_triangle[t]].surface;
    }
    add_features(result, copies);
    return result;
  }

  Vertex vertex_at(Solution_surface_mesh& result, std::size_t point, const std::vector<std::size_t>& copies)
  {
    Vertex& vertex = m_vertex_of[point];
    if (vertex == Mesh::null_vertex()) {
      const Mesh_point& own = m_points[point < m_points.size() ? point : copies[point - m_points.size()]];
      vertex = result.mesh.add_vertex(own.image);
      result.unknowns[vertex] = own.unknowns;
      result.differentials[vertex] = m_points.image().differentials(own.patch, own.unknowns);
      m_vertices[vertex] = {own.patch};
    }
    return vertex;
  }

  // Marks the edges on arcs that bound a surface, or lie where a spline has a break.
  void add_features(Solution_surface_mesh& result, const std::vector<std::size_t>& copies)
  {
    std::vector<int> edges_at(result.mesh.number_of_vertices(), 0);
    for (std::size_t a = 0; a < m_set.arcs().size(); ++a) {
      if (m_set.arcs()[a].patches != 1 && !is_on_break(m_set.arcs()[a]))
        continue;
      const std::vector<std::size_t>& chain = m_mesher.chains()[a];
      for (std::size_t k = 1; k < chain.size(); ++k) {
        const auto h = edge_between(result.mesh, chain[k - 1], chain[k], copies);
        if (h == Mesh::null_halfedge())
          continue;
        result.is_feature[result.mesh.edge(h)] = true;
        for (const Vertex v : {result.mesh.source(h), result.mesh.target(h)}) {
          ++edges_at[v];
          std::vector<int>& fixed = m_vertices[v].fixed;
          if (std::find(fixed.begin(), fixed.end(), m_set.arcs()[a].plane) == fixed.end())
            fixed.push_back(m_set.arcs()[a].plane);
        }
      }
    }
    for (const Vertex v : result.mesh.vertices())
      m_vertices[v].is_corner = edges_at[v] != 0 && (edges_at[v] != 2 || m_vertices[v].fixed.size() > 1);
    std::vector<std::size_t> apexes = m_set.singular_points(); // in all fans
    for (std::size_t k = 0; k < copies.size(); ++k)
      apexes.push_back(m_points.size() + k);
    for (const std::size_t i : apexes)
      if (const Vertex v = m_vertex_of[i]; v != Mesh::null_vertex()) {
        m_vertices[v].is_corner = m_vertices[v].is_singular = true;
        result.differentials[v] = Surface_image::no_differentials(); // not those of a gradient that is rounding errors
      }
  }

  // The edge between two points, or a copy of one; null if there is none.
  Mesh::Halfedge_index edge_between(const Mesh& mesh, std::size_t from, std::size_t to,
                                    const std::vector<std::size_t>& copies) const
  {
    const auto vertices_at = [&](std::size_t point) {
      std::vector<Vertex> result{m_vertex_of[point]};
      for (std::size_t k = 0; k < copies.size(); ++k)
        if (copies[k] == point)
          result.push_back(m_vertex_of[m_points.size() + k]);
      return result;
    };
    for (const Vertex a : vertices_at(from))
      for (const Vertex b : vertices_at(to))
        if (a != Mesh::null_vertex() && b != Mesh::null_vertex())
          if (const auto h = mesh.halfedge(a, b); h != Mesh::null_halfedge())
            return h;
    return Mesh::null_halfedge();
  }

  bool is_on_break(const Surface_arc& arc) const
  {
    const Exact_rational& value = arc.box[static_cast<std::size_t>(arc.plane)].first;
    for (const auto& system : m_set.systems())
      for (const Spline_function& function : system->equalities())
        for (const Spline_term& term : function.terms())
          for (std::size_t j = 0; j < term.variables.size(); ++j)
            if (term.variables[j] == arc.plane &&
                std::binary_search(term.breaks[j].begin(), term.breaks[j].end(), value))
              return true;
    return false;
  }

  void name_undecided(Solution_surface_mesh& result)
  {
    result.undecided_parts = m_set.undecided();
    const bool is_stopped = m_control.reason() != Undecided_reason::NONE;
    for (const std::size_t p : m_mesher.failed())
      add_undecided(result, p, is_stopped ? in_words(m_control.reason()) : "a patch that was not triangulated");
    for (const std::size_t p : m_apart)
      add_undecided(result, p, "triangles that do not join others");
    constexpr double tolerance = 1.05; // points beside middles are found up to a small part of their distance
    if (is_stopped && m_mesher.failed().empty())
      result.undecided_parts.push_back({{}, {}, in_words(m_control.reason())});
    else if (m_options.is_remeshed && result.error > tolerance * m_options.chord_error)
      result.undecided_parts.push_back({{}, {}, "triangles with a greater error"});
    result.work = summary_of(m_control, m_points.size(), m_control.reason(), result.undecided_parts.empty());
  }

  void add_undecided(Solution_surface_mesh& result, std::size_t patch, const std::string& reason) const
  {
    Undecided_part part;
    for (const auto& range : m_set.patches()[patch].box)
      part.place.push_back(to_double_range(range));
    part.reason = reason;
    result.undecided_parts.push_back(std::move(part));
  }
};

// The ranges of the unknowns of the problem.
inline Exact_ranges domain_of_problem(const Surface_solution_set_d& set)
{
  Exact_ranges result = domain_of(set.system());
  result.resize(static_cast<std::size_t>(set.dimension()));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solution_surface_mesh mesh_of_solutions(const Surface_solution_set_d& set,
                                                                       const Vector_expression<3>* image,
                                                                       const Surface_mesh_options& options,
                                                                       const Solver_options& run)
{
  if (!(options.chord_error > 0) || !(options.angle > 0) || !(options.edge_length > 0))
    throw Invalid_input("to_surface_mesh: chord error, angle and edge length must be positive");
  std::optional<Image_functions> functions;
  if (image != nullptr)
    functions = image_functions(*image, domain_of_problem(set));
  Run_control control(run);
  return Mesh_of_solutions(set, functions ? &*functions : nullptr, options, control)();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_OF_SOLUTIONS_H
