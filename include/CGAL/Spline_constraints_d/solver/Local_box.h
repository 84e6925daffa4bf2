// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LOCAL_BOX_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LOCAL_BOX_H

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

A part of a node's box in the node's own coordinates, where the node is \f$[-1/2,1/2]^n\f$.
*/
struct Local_box
{
  std::vector<double> lower, upper;

  //! the whole node.
  void reset(int dimension)
  {
    if (this->dimension() != dimension) {
      lower.resize(dimension);
      upper.resize(dimension);
    }
    for (int j = 0; j < dimension; ++j) {
      lower[j] = -0.5;
      upper[j] = 0.5;
    }
  }

  int dimension() const { return static_cast<int>(lower.size()); }
  double width(int j) const { return upper[j] - lower[j]; }

  //! makes an axis at least so wide, around its middle, but no wider than the node.
  void widen(int j, double least)
  {
    if (!(width(j) < least))
      return;
    const double middle = 0.5 * (lower[j] + upper[j]);
    lower[j] = (std::max)(-0.5, middle - 0.5 * least);
    upper[j] = (std::min)(0.5, middle + 0.5 * least);
  }

  //! keeps what lies in `[lo, hi]` on axis `j`; returns whether anything is left.
  bool intersect(int j, double lo, double hi)
  {
    lower[j] = (std::max)(lower[j], lo);
    upper[j] = (std::min)(upper[j], hi);
    return lower[j] <= upper[j];
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_LOCAL_BOX_H
