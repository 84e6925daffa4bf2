// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_NEIGHBORHOOD_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_NEIGHBORHOOD_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Oriented_mesh.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

// The nodes of a neighbourhood: the vertices of the mesh; of each facet the center and both apexes; of each edge both
// gap points.
class Node_numbers
{
  std::size_t m_vertices = 0, m_facets = 0;

public:
  Node_numbers() = default;
  explicit Node_numbers(const Oriented_mesh& mesh) : m_vertices(mesh.points.size()), m_facets(mesh.facets.size()) {}

  bool is_vertex(std::size_t node) const { return node < m_vertices; }
  std::size_t center(std::size_t facet) const { return m_vertices + 3 * facet; }
  std::size_t apex(std::size_t facet, int side) const { return center(facet) + 1 + side; }
  std::size_t gap(std::size_t edge, int side) const { return m_vertices + 3 * m_facets + 2 * edge + side; }
};

/*
A tetrahedron of a neighbourhood. Its nodes are the center of a facet, or a gap point; the ends of an edge; an apex.
From the center to the apex, or from the edge to the gap point, the way goes from the middle to the outer, or inner,
side. The faces that have the gap point and the apex, but not both ends of the edge, are on the boundary.
*/
struct Patch_place
{
  std::array<std::size_t, 4> nodes;
  std::size_t facet, edge;
  int side;
  bool is_gap;
};

// The tetrahedra around a mesh for given heights of the apexes.
struct Neighborhood
{
  using Heights = std::array<std::vector<Exact_rational>, 2>; // by side and facet

  Node_numbers numbers;
  std::vector<Exact_kernel::Point_3> points; // of the nodes
  std::vector<Patch_place> patches;

  // Those of a facet are at 6 f + 2 i + side, those of an edge at 6 F + 4 e + 2 side + k for the k-th of its facets.
  static std::size_t facet_patch(std::size_t facet, int corner, int side) { return 6 * facet + 2 * corner + side; }
  static std::size_t gap_patch(const Oriented_mesh& mesh, std::size_t edge, int side, int k)
  {
    return 6 * mesh.facets.size() + 4 * edge + 2 * side + k;
  }
};

inline Exact_kernel::Point_3 center_of_facet(const Oriented_mesh& mesh, std::size_t facet)
{
  const auto& [p, q, r] = mesh.facets[facet];
  return CGAL::centroid(mesh.points[p], mesh.points[q], mesh.points[r]);
}

Neighborhood neighborhood_of(const Oriented_mesh& mesh, const Neighborhood::Heights& heights,
                             const Exact_rational& gap_position);

// The least heights: apexes above are above the tangent planes of the corners, those below are below.
Neighborhood::Heights least_heights(const Oriented_mesh& mesh);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Neighborhood neighborhood_of(const Oriented_mesh& mesh,
                                                            const Neighborhood::Heights& heights,
                                                            const Exact_rational& gap_position)
{
  Neighborhood result;
  result.numbers = Node_numbers(mesh);
  const Node_numbers& numbers = result.numbers;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    const Exact_kernel::Point_3 center = center_of_facet(mesh, f);
    result.points.push_back(center);
    result.points.push_back(center + heights[OUTER][f] * mesh.normals[f]);
    result.points.push_back(center - heights[INNER][f] * mesh.normals[f]);
    for (int i = 0; i < 3; ++i)
      for (const int side : {OUTER, INNER})
        result.patches.push_back(
            {{numbers.center(f), mesh.facets[f][i], mesh.facets[f][(i + 1) % 3], numbers.apex(f, side)},
             f,
             mesh.edges_of_facets[f][i],
             side,
             false});
  }
  for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
    const auto& [ends, facets] = mesh.edges[e];
    for (const int side : {OUTER, INNER}) {
      const Exact_kernel::Point_3& a = result.points[numbers.apex(facets[0], side)];
      const Exact_kernel::Point_3& b = result.points[numbers.apex(facets[1], side)];
      const Exact_kernel::Point_3 gap = b + gap_position * (a - b);
      result.points.push_back(gap);
      for (const std::size_t f : facets)
        result.patches.push_back({{numbers.gap(e, side), ends[0], ends[1], numbers.apex(f, side)}, f, e, side, true});
    }
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Neighborhood::Heights least_heights(const Oriented_mesh& mesh)
{
  Neighborhood::Heights result;
  for (const int side : {OUTER, INNER})
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
      const Exact_kernel::Point_3 center = center_of_facet(mesh, f);
      Exact_rational least(0);
      for (const std::size_t v : mesh.facets[f]) {
        const Exact_rational height = mesh.gradients[v] * (center - mesh.points[v]),
                             slope = mesh.gradients[v] * mesh.normals[f];
        least = (std::max)(least, Exact_rational((side == OUTER ? -height : height) / slope));
      }
      result[side].push_back(least);
    }
  return result;
}
#endif

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_NEIGHBORHOOD_H
