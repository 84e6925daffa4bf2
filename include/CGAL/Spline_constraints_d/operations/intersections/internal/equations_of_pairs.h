// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_EQUATIONS_OF_PAIRS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_EQUATIONS_OF_PAIRS_H

#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Face_factor.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Equations of pairs of points of two parametric surfaces A and B, whose unknowns are the parameters of both.

// The equation of the points of a surface where a polynomial is zero, in its own parameters.
inline Constraint_system_d incidence(const Power_polynomial& polynomial, const Spline_patch<3>& patch)
{
  return Surface_equations(Surface_shape(polynomial), Surface_shape(patch)).system();
}

// A function of the parameters of one of the surfaces, as one of all unknowns.
inline Spline_function in_all_unknowns(const Spline_function& function, const Surface_equations& surfaces,
                                       std::size_t surface)
{
  Spline_function result;
  for (Spline_term term : function.terms()) {
    for (int& v : term.variables)
      v += static_cast<int>(surfaces.parameter(surface, 0).unknown);
    result += Spline_function(std::move(term));
  }
  return result;
}

// A vector function of the parameters of one of the surfaces, by all unknowns.
inline Vector_expression<3> formula(const Parametric_vector<3>& function, const Surface_equations& surfaces,
                                    std::size_t surface, std::span<const Unknown> all)
{
  return function(all.subspan(surfaces.parameter(surface, 0).unknown, 2));
}

// The product of the difference of both points with a tangent of one surface. At its poles a tangent is zero: the
// function is divided by its factor there.
inline Spline_function projection(const Surface_equations& surfaces, std::size_t surface, int axis)
{
  const std::vector<Unknown> all = unknowns_in(domain_of(surfaces.system()));
  const Parametric_vector<3> point(*surfaces.surface(surface).patch), other(*surfaces.surface(1 - surface).patch);
  const Vector_expression<3> difference =
      formula(other, surfaces, 1 - surface, all) - formula(point, surfaces, surface, all);
  Spline_function result =
      (dot(difference, formula(point.tangent(axis), surfaces, surface, all)) == 0).spline_function();
  for (const Surface_pole& pole : surfaces.poles())
    if (pole.surface == surface)
      Face_factor::divide_out(result, static_cast<int>(pole.unknown),
                              surfaces.system().domain(static_cast<int>(pole.unknown)), pole.value);
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_EQUATIONS_OF_PAIRS_H
