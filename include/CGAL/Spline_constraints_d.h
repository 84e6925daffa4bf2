// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_H

// Everything for stating and solving systems; reading and writing of files is in CGAL/Spline_constraints_d/IO.
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Rational_function.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/function/linear_elimination.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/batch.h>
#include <CGAL/Spline_constraints_d/solver/curve_extremes.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>
#include <CGAL/Spline_constraints_d/solver/newton_improvement.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_H
