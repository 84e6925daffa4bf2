// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_PARTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_PARTS_2_H

// What trimmed bisectors, sectors and offsets consist of.
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

Edges of a Voronoi diagram that go on in each other, as a part of a trimmed bisector. Chains end where the edges of the
bisector at a vertex are not two, at infinity, and in vertices that are not resolved.
*/
struct Trimmed_bisector_chain_2
{
  //! an edge of the diagram.
  struct Arc
  {
    std::size_t edge;    ///< its index
    bool is_reversed;    ///< whether the chain runs along it from its end to its begin
  };

  std::vector<Arc> arcs;                   ///< in order, with the first curve on the right
  std::array<std::size_t, 2> vertices;     ///< of the diagram, where the chain begins and ends
  bool is_closed;                          ///< whether it ends where it begins, and goes on there
};

/*!
\ingroup PkgSplineConstraintsDVoronoi

An arc of a trimmed \f$\alpha\f$-sector.
*/
struct Trimmed_alpha_sector_arc_2
{
  //! for each operand, whether the nearest point is an end or a corner, or the operand itself.
  std::array<bool, 2> is_point;

  //! of each operand, where the nearest points are at the begin and at the end of the arc; none, if it is a point.
  std::array<std::optional<std::array<double, 2>>, 2> parameters;
};

/*!
\ingroup PkgSplineConstraintsDVoronoi

Arcs of a trimmed \f$\alpha\f$-sector that go on in each other.
*/
struct Trimmed_alpha_sector_chain_2
{
  std::vector<std::size_t> arcs;   ///< in order, with the first operand on the right
  bool is_closed;                  ///< whether it is proved to be closed
};

/*!
\ingroup PkgSplineConstraintsDVoronoi

A boundary of a trimmed offset.
*/
struct Trimmed_offset_boundary_2
{
  std::vector<std::size_t> arcs;        ///< in order
  bool is_closed;                       ///< whether it is proved to be closed
  bool is_hole;                         ///< whether it is proved to be that of a hole of the set
  /// the index of the outer boundary of the same component of the set, its own one if it is that; none, if it is not
  /// known
  std::optional<std::size_t> outer;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_PARTS_2_H
