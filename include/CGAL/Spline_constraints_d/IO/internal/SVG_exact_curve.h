// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_EXACT_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_EXACT_CURVE_H

#include <CGAL/Spline_constraints_d/IO/internal/Text_source.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A curve of an SVG drawing, before it is rounded to the numbers of a kernel.
struct SVG_exact_curve
{
  Bspline_curve_2<Exact_kernel> curve;
  std::string id, element;
  std::size_t position;
};

// The curves of a drawing; defined in SVG_reader.h.
std::vector<SVG_exact_curve> exact_curves_of_SVG(const Text_source& source);

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_SVG_EXACT_CURVE_H
