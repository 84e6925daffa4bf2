// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_CURVE_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

A part of a curve of `Curve_pair_locus_2` without seams or breaks inside.
*/
struct Curve_pair_arc
{
  /// the index of two parts of the operands, all with the first part of the first curve before others
  std::size_t part;
  std::size_t index; ///< that of the curve in `Curve_pair_locus_2::solutions(part)`
  bool is_reversed;  ///< whether it is passed from its end to its begin
};

/*!
\ingroup PkgSplineConstraintsDLoci

One of the curves of `Curve_pair_locus_2`.
*/
struct Curve_pair_curve
{
  std::vector<Curve_pair_arc> arcs; ///< in order; each begins in the point where the one before ends
  bool is_closed;                   ///< whether the last arc ends where the first one begins
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_CURVE_PAIR_CURVE_H
