// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ARCS_OF_CHAIN_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ARCS_OF_CHAIN_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The pieces of a chain as arcs: a piece belongs to the arc of the one before if that goes on in it, `goes_on(before,
// after)`. A closed chain begins where an arc begins, if there is more than one.
template <class Piece, class Goes_on>
std::vector<std::vector<Piece>> arcs_of_chain(const std::vector<Piece>& pieces, bool is_closed, const Goes_on& goes_on)
{
  std::vector<std::vector<Piece>> arcs;
  for (const Piece& piece : pieces)
    if (!arcs.empty() && goes_on(arcs.back().back(), piece))
      arcs.back().push_back(piece);
    else
      arcs.push_back({piece});
  if (is_closed && arcs.size() > 1 && goes_on(arcs.back().back(), arcs.front().front())) {
    arcs.back().insert(arcs.back().end(), arcs.front().begin(), arcs.front().end());
    arcs.erase(arcs.begin());
  }
  return arcs;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_ARCS_OF_CHAIN_H
