// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_COINCIDENCE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_COINCIDENCE_2_H

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

Parts of two curves with the same points, or two such parts of one curve. Only the first one is a site.
*/
struct Voronoi_coincidence_2
{
  std::array<std::size_t, 2> curves;                 ///< the indices of the curves, the lower one first
  std::array<std::array<double, 2>, 2> parameters;   ///< of each curve, where the part begins and ends
  bool is_reversed;                                  ///< whether the second part begins where the first one ends
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_COINCIDENCE_2_H
