// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_JOINED_EDGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_JOINED_EDGES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// One edge for successive edges of a cycle of which each goes on in the next one; the first one does not go on from the
// last one, unless all do.
template <class Edge, class Goes_on, class Extend>
std::vector<Edge> joined_edges(std::vector<Edge> edges, const Goes_on& goes_on, const Extend& extend)
{
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (!goes_on(edges[(i + edges.size() - 1) % edges.size()], edges[i])) {
      std::rotate(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end());
      break;
    }
  std::vector<Edge> result;
  for (const Edge& edge : edges)
    if (!result.empty() && goes_on(result.back(), edge))
      extend(result.back(), edge);
    else
      result.push_back(edge);
  return result;
}

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_JOINED_EDGES_H
