// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_PATCH_TRIANGULATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_PATCH_TRIANGULATION_H

#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_points.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Triangles of a patch, in the plane of its two parameters. Its boundary is a polygon there, and all triangles are inside
of it; lifted to the surface they are a graph over the polygon within the box of the patch, which is convex. No edge
but those of the polygon has both ends on one face of the box. So triangles of patches in different boxes meet in
the chords of their common arcs alone.
*/
class Patch_triangulation
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>; // index of the point
  using Face_base = CGAL::Triangulation_face_base_with_info_2<bool, Kernel,             // whether it is inside
                                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
  using Triangulation =
      CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>,
                                                 CGAL::No_constraint_intersection_tag>;
  using Vertex = Triangulation::Vertex_handle;
  using Triangle = Triangulation::Face_handle;

  Mesh_points& m_points;
  std::size_t m_patch;
  Triangulation m_triangulation;
  std::set<std::pair<std::size_t, std::size_t>> m_seen; // edges that were looked at

public:
  using Chord = std::pair<std::size_t, std::size_t>;

  Patch_triangulation(Mesh_points& points, std::size_t patch) : m_points(points), m_patch(patch) {}

  // The polygon with these points; false when it crosses or touches itself, or is degenerate.
  bool set_boundary(const std::vector<std::size_t>& loop)
  {
    if (loop.size() < 3)
      return false;
    std::vector<Vertex> vertices;
    for (const std::size_t i : loop) {
      const std::size_t before = m_triangulation.number_of_vertices();
      vertices.push_back(m_triangulation.insert(place_of(i)));
      if (m_triangulation.number_of_vertices() == before)
        return false;
      vertices.back()->info() = i;
    }
    try {
      for (std::size_t k = 0; k < vertices.size(); ++k)
        m_triangulation.insert_constraint(vertices[k], vertices[(k + 1) % vertices.size()]);
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    for (std::size_t k = 0; k < vertices.size(); ++k) // no vertex lies on a chord of others
      if (!is_chord(vertices[k], vertices[(k + 1) % vertices.size()]))
        return false;
    return m_triangulation.dimension() == 2;
  }

  // The chords of the boundary that the surface is too far from.
  std::set<Chord> steep_chords()
  {
    std::set<Chord> result;
    for (const auto& edge : m_triangulation.constrained_edges()) {
      const Chord chord = chord_of(edge);
      if (!m_points.is_near_chord(m_patch, chord.first, chord.second))
        result.insert(chord);
    }
    return result;
  }

  // Adds points until all triangles are fine. The chords of the boundary that have to be halved before they can be so.
  std::set<Chord> refine()
  {
    constexpr int most_rounds = 24;
    std::set<Chord> coarse;
    for (int round = 0; round < most_rounds; ++round) {
      mark_inside();
      std::vector<std::size_t> added;
      for (const auto& [ends, edge] : new_edges())
        if (const std::optional<std::size_t> point = point_to_add(edge, coarse))
          added.push_back(*point);
      if (added.empty())
        break;
      for (const std::size_t i : added)
        insert(i);
    }
    return coarse;
  }

  // Triples of points, counterclockwise in the plane of the parameters.
  std::vector<std::array<std::size_t, 3>> triangles()
  {
    mark_inside();
    std::vector<std::array<std::size_t, 3>> result;
    for (const Triangle triangle : m_triangulation.finite_face_handles())
      if (triangle->info())
        result.push_back({triangle->vertex(0)->info(), triangle->vertex(1)->info(), triangle->vertex(2)->info()});
    return result;
  }

private:
  Kernel::Point_2 place_of(std::size_t i) const
  {
    const std::array<int, 2>& parameters = m_points.set().patches()[m_patch].parameters;
    return {m_points[i].unknowns[static_cast<std::size_t>(parameters[0])],
            m_points[i].unknowns[static_cast<std::size_t>(parameters[1])]};
  }

  bool is_chord(const Vertex& a, const Vertex& b) const
  {
    Triangle triangle;
    int opposite = 0;
    return m_triangulation.is_edge(a, b, triangle, opposite) && triangle->is_constrained(opposite);
  }

  // All triangles that are not reached from outside without crossing the boundary.
  void mark_inside()
  {
    for (const Triangle triangle : m_triangulation.all_face_handles())
      triangle->info() = true;
    std::vector<Triangle> open{m_triangulation.infinite_face()};
    open.back()->info() = false;
    while (!open.empty()) {
      const Triangle triangle = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i)
        if (const Triangle next = triangle->neighbor(i); !triangle->is_constrained(i) && next->info()) {
          next->info() = false;
          open.push_back(next);
        }
    }
  }

  // The edges inside that were not looked at, in the order of their ends: CGAL's order depends on where triangles lie
  // in memory, and the mesh should not.
  std::vector<std::pair<Chord, Triangulation::Edge>> new_edges() const
  {
    std::vector<std::pair<Chord, Triangulation::Edge>> result;
    for (const auto& edge : m_triangulation.finite_edges())
      if (edge.first->info() && !m_triangulation.is_constrained(edge) && m_seen.count(chord_of(edge)) == 0)
        result.emplace_back(chord_of(edge), edge);
    std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return result;
  }

  static Chord chord_of(const Triangulation::Edge& edge)
  {
    return std::minmax(edge.first->vertex(Triangulation::ccw(edge.second))->info(),
                       edge.first->vertex(Triangulation::cw(edge.second))->info());
  }

  // A point that splits an edge which is not fine. Where the surface above it is beyond the boundary of the patch,
  // chords of the boundary are too long.
  std::optional<std::size_t> point_to_add(const Triangulation::Edge& edge, std::set<Chord>& coarse)
  {
    const auto& [triangle, k] = edge;
    const auto [a, b] = chord_of(edge);
    m_seen.insert({a, b});
    const std::optional<std::size_t> middle = m_points.add_inside(m_patch, a, b);
    if (!middle) {
      for (const Triangle& beside : {triangle, triangle->neighbor(k)})
        for (int i = 0; i < 3; ++i)
          if (beside->is_constrained(i))
            coarse.insert(chord_of({beside, i}));
      return std::nullopt;
    }
    if (m_points.is_fine(a, *middle, b) && !m_points.are_on_one_plane(a, b))
      return std::nullopt;
    return middle;
  }

  // Unless the point has been rounded to the boundary.
  void insert(std::size_t point)
  {
    const Kernel::Point_2 place = place_of(point);
    Triangulation::Locate_type type;
    int index = 0;
    const Triangle triangle = m_triangulation.locate(place, type, index);
    if (type == Triangulation::VERTEX || (type == Triangulation::EDGE && triangle->is_constrained(index)) ||
        type == Triangulation::OUTSIDE_CONVEX_HULL || type == Triangulation::OUTSIDE_AFFINE_HULL)
      return;
    m_triangulation.insert(place, type, triangle, index)->info() = point;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_PATCH_TRIANGULATION_H
