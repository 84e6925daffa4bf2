// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_MESH_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Envelope_surfaces {

// Number of closed unknowns that are at an end of their range in a whole box.
inline int seams_at(const Envelope_part_3& part, const Curve_vertex::Exact_box& box)
{
  int result = 0;
  for (const int j : part.closed_unknowns) {
    const auto& own = box[static_cast<std::size_t>(j)];
    const auto& range = part.solutions.system().domain(j);
    if (own.first == own.second && (own.first == range.first || own.first == range.second))
      ++result;
  }
  return result;
}

// Twice as many cells on each seam as there are.
inline int characteristic_without_copies(const Envelope_part_3& part)
{
  double result = static_cast<double>(part.solutions.patches().size());
  std::vector<bool> is_used(part.solutions.vertices().size(), false);
  for (const Surface_arc& arc : part.solutions.arcs()) {
    if (arc.patches == 0)
      continue;
    result -= std::pow(0.5, seams_at(part, arc.box));
    for (const std::size_t v : arc.ends)
      is_used[v] = true;
  }
  for (std::size_t v = 0; v < is_used.size(); ++v)
    if (is_used[v])
      result += std::pow(0.5, seams_at(part, part.solutions.vertices()[v].box));
  return static_cast<int>(std::lround(result));
}

// Adds triangles with all that is known of their vertices and edges. Surfaces are numbered on.
inline void append(Solution_surface_mesh& result, const Solution_surface_mesh& other)
{
  std::size_t first = 0;
  for (const auto f : result.mesh.faces())
    first = (std::max)(first, result.surface[f] + 1);
  std::vector<Solution_surface_mesh::Mesh::Vertex_index> copy(other.mesh.num_vertices());
  for (const auto v : other.mesh.vertices()) {
    copy[v] = result.mesh.add_vertex(other.mesh.point(v));
    result.unknowns[copy[v]] = other.unknowns[v];
    result.differentials[copy[v]] = other.differentials[v];
  }
  for (const auto f : other.mesh.faces()) {
    std::vector<Solution_surface_mesh::Mesh::Vertex_index> corners;
    for (const auto v : other.mesh.vertices_around_face(other.mesh.halfedge(f)))
      corners.push_back(copy[v]);
    result.surface[result.mesh.add_face(corners)] = first + other.surface[f];
  }
  for (const auto e : other.mesh.edges())
    if (other.is_feature[e]) {
      const auto h = other.mesh.halfedge(e);
      result
          .is_feature[result.mesh.edge(result.mesh.halfedge(copy[other.mesh.source(h)], copy[other.mesh.target(h)]))] =
          true;
    }
  result.error = (std::max)(result.error, other.error);
  result.undecided_parts.insert(result.undecided_parts.end(), other.undecided_parts.begin(),
                                other.undecided_parts.end());
  result.work += other.work;
}

} // namespace Envelope_surfaces
} // namespace internal

CGAL_SPLINE_CONSTRAINTS_INLINE int Envelope_surface_3::euler_characteristic() const
{
  int result = 0;
  for (const Envelope_part_3& part : m_parts)
    result += internal::Envelope_surfaces::characteristic_without_copies(part);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solution_surface_mesh Envelope_surface_3::mesh(const Surface_mesh_options& options,
                                                                              const Solver_options& run) const
{
  internal::Common::Operation_budget budget(run);
  Solution_surface_mesh result;
  for (const Envelope_part_3& part : m_parts) {
    const Solution_surface_mesh own = to_surface_mesh(part.solutions, part.image, options, budget.remaining());
    budget.add(own.summary());
    internal::Envelope_surfaces::append(result, own);
  }
  const std::size_t own_undecided = m_undecided.size();
  std::size_t of_parts = 0;
  for (const Envelope_part_3& part : m_parts)
    of_parts += part.solutions.undecided_regions().size();
  result.undecided_parts.insert(result.undecided_parts.end(), m_undecided.begin(),
                                m_undecided.begin() + static_cast<std::ptrdiff_t>(own_undecided - of_parts));
  result.work.is_complete = result.undecided_parts.empty();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Envelope_surface_3& surface)
{
  std::size_t surfaces = 0;
  for (const Envelope_part_3& part : surface.parts())
    surfaces += part.solutions.surfaces().size();
  return out << "surfaces: " << (surface.is_complete() ? "" : "at least ") << surfaces << " in "
             << surface.parts().size() << " parts, Euler characteristic " << surface.euler_characteristic() << ", "
             << surface.undecided().size() << " undecided; complete: " << (surface.is_complete() ? "yes" : "no")
             << "; nodes " << surface.summary().nodes << "; seconds " << surface.summary().seconds;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_INTERNAL_ENVELOPE_MESH_H
