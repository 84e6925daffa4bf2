// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_polynomials.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>

#include <cstddef>
#include <initializer_list>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point on a face of a cell where the curves on the face have a singular point without branches.
struct Touching_point
{
  Plane_point vertex;
  std::size_t index; // of the vertex
  int axis;          // of the face
};

enum class Touching_position
{
  INSIDE,  // a surface touches the face from within the domain
  OUTSIDE, // from the other side: the point is all of it in the domain
  UNKNOWN
};

/*
Where the surface of one equality in three unknowns lies beside a face of the domain that it touches at a rational
point p. In the differences from p the equality is s x_k + Q + ... with a quadratic form Q of the unknowns along the
face: near p the surface is x_k = - Q / s + ..., to one side if Q is definite.

On an edge or a corner of the domain the surface would leave arcs on the faces if it had other points in the domain near
this one: no plane lies in a wedge. So a regular point there without arcs is alone.
*/
inline Touching_position position_of(const Touching_point& point, const Constraint_system_d& system)
{
  const Plane_point& vertex = point.vertex;
  Exact_point place;
  for (std::size_t j = 0; j < vertex.box.size(); ++j) {
    const auto& [lower, upper] = vertex.box[j];
    const auto& [begin, end] = system.domain(static_cast<int>(j));
    if (lower != upper || (vertex.is_fixed[j] && lower != begin && lower != end))
      return Touching_position::UNKNOWN; // irrational, or on a break
    place.push_back(lower);
  }
  if (system.dimension() != 3)
    return Touching_position::UNKNOWN;
  const Spline_function polynomial = on_cell(system, vertex.box).equalities().front();
  const Power_polynomial at_point = centred(*restricted(polynomial, Partial_point(3)), place);
  const auto coefficient = [&](std::initializer_list<int> unknowns) {
    Monomial monomial;
    for (const int v : unknowns)
      monomial = monomial.with_exponent(v, monomial.exponent(v) + 1);
    const auto term = at_point.terms().find(monomial);
    return term == at_point.terms().end() ? Exact_rational(0) : term->second;
  };
  if (coefficient({}) != 0)
    return Touching_position::UNKNOWN;
  if (vertex.planes() > 1)
    return coefficient({0}) != 0 || coefficient({1}) != 0 || coefficient({2}) != 0 ? Touching_position::OUTSIDE
                                                                                   : Touching_position::UNKNOWN;
  const int first = point.axis == 0 ? 1 : 0, second = 3 - point.axis - first;
  const Exact_rational slope = coefficient({point.axis}), a = coefficient({first, first}),
                       b = coefficient({first, second}), c = coefficient({second, second});
  if (slope == 0 || Exact_rational(4 * a * c - b * b) <= 0)
    return Touching_position::UNKNOWN;
  const bool is_greater = (a > 0) != (slope > 0), is_lower_face = place[point.axis] == system.domain(point.axis).first;
  return is_greater == is_lower_face ? Touching_position::INSIDE : Touching_position::OUTSIDE;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H
