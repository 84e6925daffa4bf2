// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_VALUE_AND_GRADIENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_VALUE_AND_GRADIENT_H

#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

Value and first derivatives of a function at a point: `gradient[j]` is the derivative along axis `j`.
*/
template <class NT>
struct Value_and_gradient
{
  NT value;
  std::vector<NT> gradient;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_VALUE_AND_GRADIENT_H
