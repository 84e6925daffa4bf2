// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_COMPONENTS_OF_VERTICES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_COMPONENTS_OF_VERTICES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Of each vertex of a graph, the index of the connected set of arcs and vertices that it belongs to.
inline std::vector<std::size_t> components_of_vertices(const Site_graph_2<>& graph)
{
  boost::disjoint_sets_with_storage<> sets(graph.vertices().size());
  for (std::size_t arc = 0; arc < graph.arcs().size(); ++arc)
    sets.union_set(graph.vertex_of({arc, false}), graph.vertex_of({arc, true}));
  std::map<std::size_t, std::size_t> index_of_root;
  std::vector<std::size_t> result;
  for (std::size_t v = 0; v < graph.vertices().size(); ++v)
    result.push_back(index_of_root.emplace(sets.find_set(v), index_of_root.size()).first->second);
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_COMPONENTS_OF_VERTICES_H
