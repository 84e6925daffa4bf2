// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_FEATURES_AWAY_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_FEATURES_AWAY_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Boundary_of_cells.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/number_of_components.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/manifoldness.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The places near some points.
class Neighbourhood
{
  double m_size;
  std::set<std::array<long, 3>> m_cells; // of a grid

public:
  explicit Neighbourhood(double size) : m_size(size) {}

  // Places up to the size away are near, and some beyond it.
  template <class Point>
  void add(const Point& p)
  {
    const std::array<long, 3> cell = cell_of(p);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k)
          m_cells.insert({cell[0] + i, cell[1] + j, cell[2] + k});
  }

  template <class Point>
  bool contains(const Point& p) const
  {
    return m_cells.count(cell_of(p)) > 0;
  }

private:
  template <class Point>
  std::array<long, 3> cell_of(const Point& p) const
  {
    return {std::lround(p.x() / m_size), std::lround(p.y() / m_size), std::lround(p.z() / m_size)};
  }
};

// Whether closed surfaces still have all their parts and handles when the triangles at near vertices are cut out: then
// none of them is made by what is there.
inline bool has_all_features_away(Boundary_of_cells::Mesh mesh, const Boundary_of_cells::Topology& topology,
                                  const Neighbourhood& near)
{
  using Mesh = Boundary_of_cells::Mesh;
  const auto part_of = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:part", 0).first;
  Polygon_mesh_processing::connected_components(mesh, part_of);
  for (const auto face : mesh.faces()) {
    const auto around = mesh.vertices_around_face(mesh.halfedge(face));
    if (std::any_of(around.begin(), around.end(), [&](const auto v) { return near.contains(mesh.point(v)); }))
      CGAL::Euler::remove_face(mesh.halfedge(face), mesh);
  }
  mesh.collect_garbage();
  Polygon_mesh_processing::duplicate_non_manifold_vertices(mesh);
  std::set<std::size_t> parts;
  for (const auto face : mesh.faces())
    parts.insert(part_of[face]);
  std::vector<bool> is_seen(mesh.number_of_halfedges(), false);
  int loops = 0;
  for (const auto first : mesh.halfedges()) {
    if (!mesh.is_border(first) || is_seen[first])
      continue;
    ++loops;
    for (auto h = first; !is_seen[h]; h = mesh.next(h))
      is_seen[h] = true;
  }
  const int characteristic =
      static_cast<int>(mesh.number_of_vertices() + mesh.number_of_faces()) - static_cast<int>(mesh.number_of_edges());
  const int handles = (2 * static_cast<int>(number_of_components(mesh)) - loops - characteristic) / 2;
  return parts.size() == topology.parts && handles == static_cast<int>(topology.parts) - topology.characteristic / 2;
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_FEATURES_AWAY_H
