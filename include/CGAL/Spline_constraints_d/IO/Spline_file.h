// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_SPLINE_FILE_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_SPLINE_FILE_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

A curve or surface of a file.
*/
template <class Object>
struct Spline_file_entry
{
  //! the curve or surface.
  Object object;
  //! the name that the file gives it; empty if there is none.
  std::string name;
  //! where it begins in the file, counted from 1.
  int line = 0, column = 0;
};

/*!
\ingroup PkgSplineConstraintsDIO

The curves and surfaces of a file, each kind in the order of the file.
*/
template <SplineKernel Kernel>
struct Spline_file
{
  //! the curves in the plane.
  std::vector<Spline_file_entry<Bspline_curve_2<Kernel>>> curves_2;
  //! the curves in space.
  std::vector<Spline_file_entry<Bspline_curve_3<Kernel>>> curves_3;
  //! the surfaces in space.
  std::vector<Spline_file_entry<Bspline_surface_3<Kernel>>> surfaces_3;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_SPLINE_FILE_H
