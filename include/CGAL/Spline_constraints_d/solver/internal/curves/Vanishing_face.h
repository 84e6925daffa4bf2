// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_VANISHING_FACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_VANISHING_FACE_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_vertices.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Face_factor.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A face of the domain, or a plane of breaks in it, on which an equality is zero everywhere.
struct Vanishing_face
{
  std::size_t equality;
  int axis;
  Exact_rational value;
};

// The faces of the domain and the planes of breaks for an unknown.
inline std::vector<Exact_rational> places_of_faces(const Constraint_system_d& system, int unknown)
{
  const auto& [lower, upper] = system.domain(unknown);
  std::vector<Exact_rational> result{lower, upper};
  for (const Spline_function& function : system.equalities())
    for (const Spline_term& term : function.terms())
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        if (term.variables[j] == unknown)
          result.insert(result.end(), term.breaks[j].begin(), term.breaks[j].end());
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return {std::lower_bound(result.begin(), result.end(), lower), std::upper_bound(result.begin(), result.end(), upper)};
}

inline std::optional<Vanishing_face> vanishing_face(const Constraint_system_d& system)
{
  for (int axis = 0; axis < system.dimension(); ++axis)
    for (const Exact_rational& place : places_of_faces(system, axis))
      for (std::size_t i = 0; i < system.equalities().size(); ++i)
        if (Face_factor(system.equalities()[i], axis, system.domain(axis), place).divides())
          return Vanishing_face{i, axis, place};
  return std::nullopt;
}

// The system with an equality that is divided by the factor of the face, as often as it can be, and how often this is.
inline std::pair<Constraint_system_d, int> without_face(const Constraint_system_d& system, const Vanishing_face& face)
{
  Constraint_system_d result(domain_of(system));
  int exponent = 0;
  for (std::size_t i = 0; i < system.equalities().size(); ++i) {
    Spline_function function = system.equalities()[i];
    if (i == face.equality)
      exponent = Face_factor::divide_out(function, face.axis, system.domain(face.axis), face.value);
    result.add(std::move(function), Relation::EQUAL);
  }
  for (const auto& [function, relation] : system.inequalities())
    result.add(function, relation);
  return {std::move(result), exponent};
}

// A function where an unknown has a value, in the same unknowns.
inline Spline_function on_face(const Spline_function& function, int axis, const Exact_rational& value)
{
  const Spline_function restricted = with_fixed(function, axis, value);
  Spline_function result;
  for (Spline_term term : restricted.terms()) {
    for (int& v : term.variables)
      v += v >= axis;
    result += Spline_function(std::move(term));
  }
  return result;
}

/*
The system on a face, whose curves lie within the domain: with the unknown that is constant there as an unknown whose
range is wider, and with its equation in the place of the equality that is zero. Nothing if an inequality excludes the
face.
*/
inline std::optional<Constraint_system_d> system_on_face(const Constraint_system_d& system, const Vanishing_face& face)
{
  Exact_ranges slab = domain_of(system);
  const Exact_rational width = slab[face.axis].second - slab[face.axis].first;
  slab[face.axis] = {Exact_rational(face.value - width), Exact_rational(face.value + width)};
  const auto restricted_to_face = [&](const Spline_function& function) {
    return on_face(function, face.axis, face.value);
  };
  Constraint_system_d result(slab);
  result.add(Power_polynomial::variable(face.axis) - Power_polynomial(face.value), Relation::EQUAL);
  for (std::size_t i = 0; i < system.equalities().size(); ++i)
    if (i != face.equality)
      result.add(restricted_to_face(system.equalities()[i]), Relation::EQUAL);
  for (const auto& [function, relation] : system.inequalities()) {
    Spline_function restricted = restricted_to_face(function);
    const bool is_zero = is_zero_everywhere(restricted);
    if (is_zero && is_strict(relation))
      return std::nullopt;
    if (is_zero)
      result.add(Power_polynomial(Exact_rational(1)), Relation::GREATER); // inequalities keep their numbers
    else
      result.add(std::move(restricted), relation);
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_VANISHING_FACE_H
