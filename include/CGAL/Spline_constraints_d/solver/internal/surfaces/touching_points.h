// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point on a face of a cell where the curves on the face have a singular point without branches.
struct Touching_point
{
  Plane_point vertex;
  int axis; // of the face
};

enum class Touching_position
{
  INSIDE,  // a surface touches the face from within the domain
  OUTSIDE, // from the other side: the point is all of it in the domain
  UNKNOWN
};

// The derivative of a function by some unknowns, at a point; of a spline, in the cell below it.
inline Exact_rational derivative_at(const Spline_function& function, const std::vector<int>& unknowns,
                                    const std::vector<Exact_rational>& point)
{
  Exact_rational result(0);
  for (const Spline_term& term : function.terms()) {
    std::size_t piece = 0;
    for (std::size_t j = 0; j < term.variables.size(); ++j)
      piece = piece * term.cells(j) + cell_at(term.breaks[j], point[term.variables[j]]);
    for (std::size_t i = 0; i < term.pieces[piece].size(); ++i) {
      Exact_rational value = term.pieces[piece][i];
      std::size_t taken = 0;
      for (std::size_t j = term.degrees.size(), rest = i; j-- > 0;) {
        const std::size_t count = static_cast<std::size_t>(term.degrees[j]) + 1;
        int exponent = static_cast<int>(rest % count);
        rest /= count;
        for (const int unknown : unknowns)
          if (unknown == term.variables[j]) {
            value *= exponent--;
            ++taken;
            if (exponent < 0)
              break;
          }
        for (; exponent > 0; --exponent)
          value *= point[term.variables[j]];
      }
      if (taken == unknowns.size())
        result += value;
    }
  }
  return result;
}

/*
Where the surface of one equality in three unknowns lies beside a face that it touches at a rational point: near it the
surface is x_k - c = - Q / (2 f_k) + ..., with the quadratic form Q of the second derivatives along the face, which is
definite. One sign of a second derivative tells which way, if it is not zero.

On an edge or a corner of the domain the surface would leave arcs on the faces if it had other points in the domain near
this one: no plane lies in a wedge. So a regular point there without arcs is alone.
*/
inline Touching_position position_of(const Touching_point& point, const Constraint_system_d& system)
{
  const Plane_point& vertex = point.vertex;
  const std::size_t axis = static_cast<std::size_t>(point.axis);
  const bool is_upper = vertex.box[axis].first == system.domain(point.axis).second,
             is_lower = vertex.box[axis].first == system.domain(point.axis).first;
  std::vector<Exact_rational> place;
  bool is_rational = true, is_at_break = false;
  for (std::size_t j = 0; j < vertex.box.size(); ++j) {
    const auto& [lower, upper] = vertex.box[j];
    const auto& [begin, end] = system.domain(static_cast<int>(j));
    is_rational = is_rational && lower == upper;
    is_at_break = is_at_break || (vertex.is_fixed[j] && lower != begin && lower != end);
    place.push_back(lower);
  }
  if (system.dimension() != 3 || !is_rational || is_at_break || (!is_lower && !is_upper))
    return Touching_position::UNKNOWN;
  const Spline_function& equality = system.equalities().front();
  const auto has_slope = [&](int unknown) { return derivative_at(equality, {unknown}, place) != 0; };
  if (vertex.planes() > 1)
    return has_slope(0) || has_slope(1) || has_slope(2) ? Touching_position::OUTSIDE : Touching_position::UNKNOWN;
  if (!vertex.is_singular)
    return Touching_position::UNKNOWN;
  const int other = point.axis == 0 ? 1 : 0, third = 3 - point.axis - other;
  const Exact_rational slope = derivative_at(equality, {point.axis}, place),
                       a = derivative_at(equality, {other, other}, place),
                       b = derivative_at(equality, {other, third}, place),
                       c = derivative_at(equality, {third, third}, place);
  if (slope == 0 || Exact_rational(a * c - b * b) <= 0)
    return Touching_position::UNKNOWN;
  // the surface lies at greater values of the unknown where a and the slope have opposite signs
  const bool is_greater = (a > 0) != (slope > 0);
  return is_greater == is_lower ? Touching_position::INSIDE : Touching_position::OUTSIDE;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_TOUCHING_POINTS_H
