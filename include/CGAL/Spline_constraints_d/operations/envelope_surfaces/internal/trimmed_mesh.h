// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TRIMMED_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TRIMMED_MESH_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Trimmed_envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_image.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Surface_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// The triangles of a part that are kept or undecided, cut where labels of the ends of edges differ.
class Trimmed_triangles
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Unknowns = Surface_points::Point;
  using Label = std::function<Nearest_feet_label(std::span<const double>)>;

  const Envelope_part_3& m_part;
  const Solution_surface_mesh& m_all;
  Label m_label;
  Operation_budget& m_budget;
  Image_functions m_functions;
  Surface_points m_points;
  Surface_image m_image;
  std::vector<Nearest_feet_label> m_labels;    // of vertices of all triangles
  std::vector<std::optional<Vertex>> m_copies; // of them
  std::map<std::pair<Vertex, Vertex>, Vertex> m_cuts;
  Solution_surface_mesh m_result;
  std::vector<Nearest_feet_label> m_face_labels;

public:
  //! \pre The arguments live longer.
  Trimmed_triangles(const Envelope_part_3& part, const Solution_surface_mesh& all, Label label,
                    Operation_budget& budget)
    : m_part(part), m_all(all), m_label(std::move(label)), m_budget(budget),
      m_functions(image_functions(part.image, own_domain(part))), m_points(part.solutions),
      m_image(part.solutions, m_points, &m_functions)
  {
    m_result.undecided_parts = all.undecided_parts;
    m_result.error = all.error;
    m_result.work = all.work;
    m_copies.resize(all.mesh.num_vertices());
    for (const Vertex v : all.mesh.vertices())
      m_labels.push_back(m_budget.must_stop() ? Nearest_feet_label::UNDECIDED : m_label(all.unknowns[v]));
    for (const auto f : all.mesh.faces())
      add(f);
    for (const auto e : all.mesh.edges())
      if (all.is_feature[e])
        add_feature(all.mesh.halfedge(e));
  }

  const Solution_surface_mesh& mesh() const { return m_result; }
  const std::vector<Nearest_feet_label>& labels() const { return m_face_labels; }

private:
  static Exact_ranges own_domain(const Envelope_part_3& part)
  {
    Exact_ranges result = domain_of(part.solutions.system());
    result.resize(static_cast<std::size_t>(part.solutions.dimension())); // without those of inequalities
    return result;
  }

  Nearest_feet_label label(Vertex v) const { return m_labels[v]; }

  void add(Mesh::Face_index f)
  {
    std::array<Vertex, 3> corners;
    std::size_t k = 0;
    for (const Vertex v : m_all.mesh.vertices_around_face(m_all.mesh.halfedge(f)))
      corners[k++] = v;
    const auto number = [&](Nearest_feet_label own) {
      return std::ranges::count_if(corners, [&](Vertex v) { return label(v) == own; });
    };
    if (number(Nearest_feet_label::NOT_NEAREST) == 3)
      return;
    if (number(Nearest_feet_label::NEAREST) == 3 || number(Nearest_feet_label::UNDECIDED) > 0) {
      add_face({copy(corners[0]), copy(corners[1]), copy(corners[2])}, f,
               number(Nearest_feet_label::NEAREST) == 3 ? Nearest_feet_label::NEAREST : Nearest_feet_label::UNDECIDED);
      return;
    }
    const bool is_one_kept = number(Nearest_feet_label::NEAREST) == 1;
    const Nearest_feet_label single = is_one_kept ? Nearest_feet_label::NEAREST : Nearest_feet_label::NOT_NEAREST;
    while (label(corners[0]) != single)
      std::ranges::rotate(corners, corners.begin() + 1);
    const Vertex first = cut(corners[0], corners[1]), second = cut(corners[0], corners[2]);
    if (is_one_kept)
      add_face({copy(corners[0]), first, second}, f, Nearest_feet_label::NEAREST);
    else {
      add_face({first, copy(corners[1]), copy(corners[2])}, f, Nearest_feet_label::NEAREST);
      add_face({first, copy(corners[2]), second}, f, Nearest_feet_label::NEAREST);
    }
    set_feature(first, second);
  }

  void add_face(const std::array<Vertex, 3>& corners, Mesh::Face_index of, Nearest_feet_label own)
  {
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      return; // the border is at a vertex
    const auto f = m_result.mesh.add_face(corners[0], corners[1], corners[2]);
    if (f == Mesh::null_face()) {
      m_result.undecided_parts.push_back({{}, {}, "a triangle at a vertex where several parts meet"});
      return;
    }
    m_result.surface[f] = m_all.surface[of];
    m_face_labels.push_back(own);
  }

  Vertex copy(Vertex v)
  {
    std::optional<Vertex>& result = m_copies[v];
    if (!result) {
      result = m_result.mesh.add_vertex(m_all.mesh.point(v));
      m_result.unknowns[*result] = m_all.unknowns[v];
      m_result.differentials[*result] = m_all.differentials[v];
    }
    return *result;
  }

  // The point of an edge where the label changes: the last one found that is kept.
  Vertex cut(Vertex a, Vertex b)
  {
    if (label(a) != Nearest_feet_label::NEAREST)
      std::swap(a, b);
    const auto [known, is_new] = m_cuts.try_emplace({a, b});
    if (!is_new)
      return known->second;
    Unknowns kept = beside(m_all.unknowns[a], m_all.unknowns[b]), other = beside(m_all.unknowns[b], kept);
    constexpr int rounds = 16;
    bool has_moved = false;
    for (int round = 0; round < rounds && !m_budget.must_stop(); ++round) {
      Unknowns middle(kept);
      for (std::size_t j = 0; j < middle.size(); ++j)
        middle[j] = 0.5 * (kept[j] + other[j]);
      if (!m_points.move_to_surface(patch_of(middle), {}, middle))
        break;
      const bool is_kept = m_label(middle) == Nearest_feet_label::NEAREST;
      has_moved = has_moved || is_kept;
      (is_kept ? kept : other) = middle;
    }
    if (!has_moved)
      return known->second = copy(a);
    const std::size_t patch = patch_of(kept);
    const Vertex result = m_result.mesh.add_vertex(m_image(patch, kept));
    m_result.differentials[result] = m_image.differentials(patch, kept);
    m_result.unknowns[result] = std::move(kept);
    return known->second = result;
  }

  // Unknowns of a point with values near those of another one, where a point has several: on seams and at poles.
  Unknowns beside(Unknowns unknowns, const Unknowns& other) const
  {
    for (const int unknown : m_part.closed_unknowns) {
      const auto j = static_cast<std::size_t>(unknown);
      const auto& range = m_part.solutions.system().domain(unknown);
      const double begin = CGAL::to_double(range.first), end = CGAL::to_double(range.second);
      for (const auto& [from, to] : {std::pair(begin, end), std::pair(end, begin)})
        if (unknowns[j] == from && std::abs(other[j] - to) < std::abs(other[j] - from))
          unknowns[j] = to;
    }
    for (const Envelope_pole& pole : m_part.poles)
      if (const auto j = static_cast<std::size_t>(pole.unknown); unknowns[j] == CGAL::to_double(pole.value))
        unknowns[j ^ 1] = other[j ^ 1];
    return unknowns;
  }

  // The one whose box is the nearest.
  std::size_t patch_of(const Unknowns& unknowns) const
  {
    std::size_t result = 0;
    double least = std::numeric_limits<double>::infinity();
    const std::vector<Surface_patch>& patches = m_part.solutions.patches();
    for (std::size_t p = 0; p < patches.size() && least > 0; ++p) {
      double distance = 0;
      for (std::size_t j = 0; j < unknowns.size(); ++j) {
        const double begin = CGAL::to_double(patches[p].box[j].first), end = CGAL::to_double(patches[p].box[j].second);
        distance = (std::max)({distance, begin - unknowns[j], unknowns[j] - end});
      }
      if (distance < least) {
        least = distance;
        result = p;
      }
    }
    return result;
  }

  // What is left of an edge.
  void add_feature(Mesh::Halfedge_index h)
  {
    const Vertex a = m_all.mesh.source(h), b = m_all.mesh.target(h);
    const auto end = [&](Vertex own, Vertex other) {
      const auto cut = m_cuts.find({other, own});
      return cut == m_cuts.end() ? m_copies[own] : std::optional(cut->second);
    };
    const std::optional<Vertex> first = end(a, b), second = end(b, a);
    if (first && second)
      set_feature(*first, *second);
  }

  void set_feature(Vertex a, Vertex b)
  {
    if (const auto h = m_result.mesh.halfedge(a, b); h != Mesh::null_halfedge())
      m_result.is_feature[m_result.mesh.edge(h)] = true;
  }
};

} // namespace Envelope_surfaces
} // namespace internal

CGAL_SPLINE_CONSTRAINTS_INLINE Solution_surface_mesh
Trimmed_envelope_surface_3::mesh(const Surface_mesh_options& options, const Solver_options& run) const
{
  using namespace internal::Envelope_surfaces;
  internal::Common::Operation_budget budget(run);
  Solution_surface_mesh result;
  const auto labels =
      result.mesh.add_property_map<Solution_surface_mesh::Mesh::Face_index, Nearest_feet_label>("f:label").first;
  for (std::size_t i = 0; i < m_untrimmed.parts().size(); ++i) {
    const Envelope_part_3& part = m_untrimmed.parts()[i];
    Solution_surface_mesh all = mesh_of(part, options, budget);
    join(all, part);
    const Trimmed_triangles trimmed(
        part, all, [&](std::span<const double> unknowns) { return label(i, unknowns); }, budget);
    Solution_surface_mesh own = trimmed.mesh();
    add_distances(own, part);
    const auto first = static_cast<Solution_surface_mesh::Mesh::size_type>(result.mesh.num_faces());
    append(result, own);
    for (std::size_t k = 0; k < trimmed.labels().size(); ++k)
      labels[Solution_surface_mesh::Mesh::Face_index(first + static_cast<unsigned>(k))] = trimmed.labels()[k];
  }
  if (budget.must_stop())
    result.undecided_parts.push_back({{}, {}, internal::in_words(budget.reason())});
  if (!is_complete())
    result.undecided_parts.insert(result.undecided_parts.end(), m_undecided.begin(), m_undecided.end());
  result.work.is_complete = result.undecided_parts.empty();
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_TRIMMED_MESH_H
