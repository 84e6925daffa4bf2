// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_FACTOR_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_FACTOR_SYSTEM_H

#include <CGAL/Spline_constraints_d/function/internal/factors_in_several_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Vanishing_face.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A system with one factor of each equality, and the faces of the domain, or planes of breaks, that its solutions lie
// on: an unknown and its value for each.
struct Factor_system
{
  Constraint_system_d system;
  std::vector<std::pair<int, Exact_rational>> faces = {};
};

// A function that is a short polynomial in few unknowns, whose factors are found at once.
inline std::optional<Power_polynomial> short_polynomial(const Spline_function& function, int dimension)
{
  constexpr std::size_t most_unknowns = 3, most_coefficients = 1000;
  std::size_t coefficients = 0;
  std::set<int> unknowns;
  for (const Spline_term& term : function.terms()) {
    if (term.pieces.size() != 1)
      return std::nullopt;
    coefficients += term.pieces[0].size();
    unknowns.insert(term.variables.begin(), term.variables.end());
  }
  if (coefficients > most_coefficients || unknowns.size() > most_unknowns)
    return std::nullopt;
  return restricted(function, Partial_point(static_cast<std::size_t>(dimension)));
}

inline Constraint_system_d with_equality(const Constraint_system_d& system, std::size_t index,
                                         const Power_polynomial& polynomial)
{
  Constraint_system_d result(domain_of(system));
  for (std::size_t i = 0; i < system.equalities().size(); ++i)
    if (i == index)
      result.add(polynomial, Relation::EQUAL);
    else
      result.add(system.equalities()[i], Relation::EQUAL);
  for (const auto& [function, relation] : system.inequalities())
    result.add(function, relation);
  return result;
}

// The parts of a system, whose solutions together are its own: for one factor of each equality. A factor that is zero
// on a face of the domain is divided out, and the face is a part.
inline std::vector<Factor_system> factor_systems(const Constraint_system_d& system)
{
  if (std::any_of(system.equalities().begin(), system.equalities().end(), is_zero_everywhere))
    return {{system}};
  std::vector<Factor_system> result;
  const auto append = [&](std::vector<Factor_system>&& parts) {
    std::move(parts.begin(), parts.end(), std::back_inserter(result));
  };
  if (const std::optional<Vanishing_face> face = vanishing_face(system)) {
    Constraint_system_d rest = without_face(system, *face).first;
    const auto constant = short_polynomial(rest.equalities()[face->equality], rest.dimension());
    if (!constant || !constant->is_constant())
      append(factor_systems(rest));
    if (const std::optional<Constraint_system_d> on_face = system_on_face(system, *face)) {
      std::vector<Factor_system> own = factor_systems(*on_face);
      for (Factor_system& part : own)
        part.faces.emplace_back(face->axis, face->value);
      append(std::move(own));
    }
    return result;
  }
  for (std::size_t i = 0; i < system.equalities().size(); ++i)
    if (const auto polynomial = short_polynomial(system.equalities()[i], system.dimension())) {
      const std::vector<Power_polynomial> factors = different_factors(*polynomial);
      if (factors.size() < 2)
        continue;
      for (const Power_polynomial& factor : factors)
        append(factor_systems(with_equality(system, i, factor)));
      return result;
    }
  return {{system}};
}

// Whether the parts are others than the system itself.
inline bool is_split(const Constraint_system_d& system, const std::vector<Factor_system>& parts)
{
  const auto is_same = [](const Spline_function& f, const Spline_function& g) { return f.terms() == g.terms(); };
  return parts.size() != 1 || !parts.front().faces.empty() ||
      !std::equal(system.equalities().begin(), system.equalities().end(), parts.front().system.equalities().begin(),
                  is_same);
}

/*
The common solutions of two parts, as a system with one equality less than unknowns; nothing if they differ in more than
one factor, or lie on parallel faces. Equalities are restricted to the faces.
*/
inline std::optional<Constraint_system_d> common_system(const Factor_system& first, const Factor_system& second)
{
  const int n = first.system.dimension();
  Exact_ranges domain = domain_of(first.system);
  std::vector<std::pair<int, Exact_rational>> faces;
  for (const Factor_system* part : {&first, &second})
    for (const auto& [axis, value] : part->faces) {
      domain[axis] = part->system.domain(axis);
      const auto same =
          std::find_if(faces.begin(), faces.end(), [&, own = axis](const auto& known) { return known.first == own; });
      if (same == faces.end())
        faces.emplace_back(axis, value);
      else if (same->second != value)
        return std::nullopt;
    }
  std::vector<Spline_function> equalities;
  for (const auto& [axis, value] : faces)
    equalities.push_back(Power_polynomial::variable(axis) - Power_polynomial(value));
  for (const Factor_system* part : {&first, &second})
    for (Spline_function function : part->system.equalities()) {
      for (const auto& [axis, value] : faces)
        function = on_face(function, axis, value);
      const auto is_same = [&](const Spline_function& other) { return other.terms() == function.terms(); };
      if (!is_zero_everywhere(function) && std::none_of(equalities.begin(), equalities.end(), is_same))
        equalities.push_back(std::move(function));
    }
  if (static_cast<int>(equalities.size()) != n - 1)
    return std::nullopt;
  Constraint_system_d result(std::move(domain));
  for (Spline_function& function : equalities)
    result.add(std::move(function), Relation::EQUAL);
  // those of a part on a face are restricted to it already
  for (const auto& [function, relation] : (first.faces.empty() ? second : first).system.inequalities())
    result.add(function, relation);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_FACTOR_SYSTEM_H
