// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_H

// All of the floor of functions: splines, polynomials and formulas in several unknowns, and constraints between them.
#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Expression_graph.h>
#include <CGAL/Spline_constraints_d/function/Graph_evaluation.h>
#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/Operation_count.h>
#include <CGAL/Spline_constraints_d/function/Polynomial_quotient.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Rational_function.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Value_and_gradient.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/affine_kernels.h>
#include <CGAL/Spline_constraints_d/function/bernstein_composition.h>
#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/function/bernstein_kernels.h>
#include <CGAL/Spline_constraints_d/function/bernstein_product.h>
#include <CGAL/Spline_constraints_d/function/coefficient_packs.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/concepts.h>
#include <CGAL/Spline_constraints_d/function/constraint_idioms.h>
#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/function/expression_bounds.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/function/knot_vector.h>
#include <CGAL/Spline_constraints_d/function/linear_elimination.h>
#include <CGAL/Spline_constraints_d/function/rational_decomposition.h>
#include <CGAL/Spline_constraints_d/function/rational_factors.h>
#include <CGAL/Spline_constraints_d/function/simplex_conversion.h>
#include <CGAL/Spline_constraints_d/function/simplex_faces.h>
#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/function/weight_sign.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_H
