// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_EDGE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_EDGE_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

An edge of a Voronoi diagram.
*/
struct Voronoi_edge_2
{
  //! the site on its right, and that on its left; the same one if both footpoints are on one piece.
  std::array<std::size_t, 2> sites;

  //! where it begins and ends.
  std::array<std::size_t, 2> vertices;

  //! of each site, where the disks touch it at the begin and at the end of the edge; none, if the site is a point.
  std::array<std::optional<std::array<double, 2>>, 2> parameters;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_EDGE_2_H
