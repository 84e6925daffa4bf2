// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SPLITTERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SPLITTERS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Splits where the equations vary most: the axis with the largest sum over the equalities of its share in their variation
(the smear of Kearfott, each equation normalised by its own sum).

\cgalModels{Splitter}
*/
class Smear_splitter
{
public:
  //! rates the axes: the solver splits the one with the largest value that can still be split. `widths` are relative to
  //! the domain.
  void rate(Node_view& node, const std::vector<double>&, std::vector<double>& rating);
};

/*!
\ingroup PkgSplineConstraintsDSolver

Splits the axis that is widest relative to the domain.

\cgalModels{Splitter}
*/
class Widest_splitter
{
public:
  //! rates the axes by their widths.
  void rate(Node_view&, const std::vector<double>& widths, std::vector<double>& rating) { rating = widths; }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Smear_splitter::rate(Node_view& node, const std::vector<double>&,
                                                         std::vector<double>& rating)
{
  const int n = node.dimension();
  rating.assign(n, 0);
  for (int i = 0; i < node.equalities(); ++i) {
    const double *lower = node.derivative_lower(i), *upper = node.derivative_upper(i);
    double sum = 0;
    for (int j = 0; j < n; ++j)
      sum += (std::max)(-lower[j], upper[j]);
    if (sum > 0)
      for (int j = 0; j < n; ++j)
        rating[j] += (std::max)(-lower[j], upper[j]) / sum;
  }
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SPLITTERS_H
