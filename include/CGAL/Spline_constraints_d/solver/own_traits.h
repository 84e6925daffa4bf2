// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_OWN_TRAITS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_OWN_TRAITS_H

// For programs that use the compiled library, and `Subdivision_solver_d` or `Curve_solver_d` with traits of their own,
// or on all cores with other traits than the default ones: what is compiled in the library for the traits of the
// package is compiled in the program for these. Without the compiled library nothing needs this header.
#include <CGAL/Spline_constraints_d/solver/internal/curves/all_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposed_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/solution_set.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/all_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/united_surfaces.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_OWN_TRAITS_H
