// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_CELL_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_CELL_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_edge_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

The points that are nearest to a site of a Voronoi diagram, or to one of several sites, by the boundary of them,
counterclockwise.

Where the foot of the perpendicular goes over to a site on the same curve there is no edge, but this perpendicular: it
joins the ends of two chains, or leads to infinity. A cell without chains is all of the region of the site, or of the
plane, up to such perpendiculars.
*/
struct Voronoi_cell_2
{
  //! an edge as the boundary sees it: with the site of the cell on its left, and the adjacent one on its right.
  struct Edge : Voronoi_edge_2
  {
    std::size_t index;    ///< that of the edge in the diagram
    bool is_reversed;     ///< whether the boundary runs from the end of the edge to its begin
  };

  //! edges of the boundary, each of which begins where the one before ends.
  struct Chain
  {
    std::vector<Edge> edges;   ///< in order
    /// whether the last one ends where the first one begins; if not, the chain begins and ends at infinity, or where
    /// the foot of the perpendicular goes over to another site
    bool is_closed;
  };

  std::vector<Chain> chains;   ///< the open ones first
  bool is_complete;            ///< whether they are proved to be all of the boundary
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_CELL_2_H
