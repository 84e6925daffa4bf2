// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_H

// Everything for stating and solving systems. Geometry is in CGAL/Spline_constraints_d/geometry.h and operations.h,
// reading and writing of files in CGAL/Spline_constraints_d/IO.h; and each header can be included alone.
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/Spline_constraints_d/function.h>
#include <CGAL/Spline_constraints_d/solver.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_H
