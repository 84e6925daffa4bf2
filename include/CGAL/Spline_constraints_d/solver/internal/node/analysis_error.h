// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_ANALYSIS_ERROR_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_ANALYSIS_ERROR_H

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A bound on the relative error of a sum or product of the few dozen terms that occur in the analysis of a node, in any
rounding mode. Everything below computes in plain double and widens its result by this much of the sum of absolute
values, so that no proof hangs on the rounding mode.
*/
constexpr double analysis_error = 0x1p-45;

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_ANALYSIS_ERROR_H
