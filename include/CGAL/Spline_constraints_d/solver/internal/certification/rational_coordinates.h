// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_RATIONAL_COORDINATES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_RATIONAL_COORDINATES_H

#include <CGAL/Spline_constraints_d/function/internal/polynomial_of_powers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Piecewise_certification.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_refinement.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Values of some of the unknowns.
using Partial_point = std::vector<std::optional<Exact_rational>>;

// The piece of a term that holds a point; of several the last.
inline const std::vector<Exact_rational>& piece_at(const Spline_term& term, const std::vector<Exact_rational>& point)
{
  std::size_t cell = 0;
  for (std::size_t j = 0; j < term.variables.size(); ++j) {
    const auto& breaks = term.breaks[j];
    std::size_t own = 0;
    while (own + 1 < term.cells(j) && breaks[own + 1] <= point[term.variables[j]])
      ++own;
    cell = cell * term.cells(j) + own;
  }
  return term.pieces[cell];
}

// A spline without breaks as a polynomial in the unknowns that have no value, numbered in their order; nothing when it
// has breaks.
inline std::optional<Power_polynomial> restricted(const Spline_function& function, const Partial_point& values)
{
  std::vector<int> rank(values.size(), 0);
  for (std::size_t v = 1; v < values.size(); ++v)
    rank[v] = rank[v - 1] + (values[v - 1] ? 0 : 1);
  Power_polynomial result;
  for (const Spline_term& term : function.terms()) {
    if (term.pieces.size() != 1)
      return std::nullopt;
    result += polynomial_of_powers(term.degrees, term.pieces[0], [&](std::size_t j) {
      const int v = term.variables[j];
      return values[v] ? Power_polynomial(*values[v]) : Power_polynomial::variable(rank[v]);
    });
  }
  return result;
}

// The polynomial that a spline is around a point off its breaks.
inline Power_polynomial polynomial_at(const Spline_function& function, const std::vector<Exact_rational>& point)
{
  Power_polynomial result;
  for (const Spline_term& term : function.terms())
    result += polynomial_of_powers(term.degrees, piece_at(term, point),
                                   [&](std::size_t j) { return Power_polynomial::variable(term.variables[j]); });
  return result;
}

// Without those that are linear combinations of the ones before: the common zeros stay the same.
inline std::vector<Power_polynomial> linearly_independent(const std::vector<Power_polynomial>& polynomials)
{
  std::vector<Power_polynomial> result, echelon;   // none of the echelon has the first monomial of an earlier one
  for (const Power_polynomial& polynomial : polynomials) {
    Power_polynomial rest = polynomial;
    for (const Power_polynomial& row : echelon) {
      const auto& [monomial, leading] = *row.terms().begin();
      if (const auto term = rest.terms().find(monomial); term != rest.terms().end())
        rest -= Power_polynomial(Exact_rational(term->second / leading)) * row;
    }
    if (!rest.is_zero()) {
      result.push_back(polynomial);
      echelon.push_back(std::move(rest));
    }
  }
  return result;
}

/*
A solution some of whose coordinates are rational: their values, and ranges of all coordinates in which there is no
other solution with these values.
*/
struct Partly_rational_solution
{
  Partial_point values;   // none: nothing was proved
  std::vector<Exact_rational> lower, upper;

  bool is_proved() const
  {
    return std::any_of(values.begin(), values.end(), [](const auto& value) { return value.has_value(); });
  }
};

/*
Proves that a narrow box holds a solution some of whose coordinates are rational: those whose range holds a rational of
at most `longest` bits take that value, the equalities that become zero or linear combinations of others are dropped,
and the rest must have exactly one root in the ranges of the remaining unknowns, each widened by its width to both
sides. The domain and the inequalities are not looked at.
*/
inline Partly_rational_solution partly_rational_solution(const Constraint_system_d& system,
                                                         const std::vector<Exact_rational>& lower,
                                                         const std::vector<Exact_rational>& upper, long longest)
{
  const std::size_t n = lower.size();
  const Partly_rational_solution none{Partial_point(n), {}, {}};
  Partly_rational_solution result{Partial_point(n), lower, upper};
  Certified_region<Exact_rational> rest;
  std::vector<Constraint_system_d::Domain> domain;
  std::vector<std::size_t> axes;   // of the rest
  for (std::size_t j = 0; j < n; ++j) {
    const Exact_rational width = upper[j] - lower[j], value = simplest_rational_between(lower[j], upper[j]);
    if (bit_length(numerator_of(value)) + bit_length(denominator_of(value)) <= longest) {
      result.values[j] = result.lower[j] = result.upper[j] = value;
      continue;
    }
    axes.push_back(j);
    rest.lower.push_back(lower[j] - width);
    rest.upper.push_back(upper[j] + width);
    domain.emplace_back(rest.lower.back(), rest.upper.back());
  }
  if (domain.size() == n)
    return none;
  std::vector<Power_polynomial> remaining;
  for (const Spline_function& function : system.equalities()) {
    const auto polynomial = restricted(function, result.values);
    if (!polynomial || (polynomial->is_constant() && !polynomial->is_zero()))
      return none;
    remaining.push_back(*polynomial);
  }
  if (domain.empty())
    return result;
  Constraint_system_d remaining_system(domain);
  for (const Power_polynomial& polynomial : linearly_independent(remaining))
    remaining_system.add(polynomial, Relation::EQUAL);
  const System_layout layout(remaining_system);
  Exact_source source(remaining_system, layout);
  Piecewise_certification<Exact_rational> certification(layout, source);
  if (certification.certify(rest) != Piecewise_certification<Exact_rational>::ONE_ROOT)
    return none;
  constexpr int bits = 200;
  const Root_enclosure<Exact_rational> enclosure = Root_refinement<Exact_rational>().refine(rest, bits);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    result.lower[axes[i]] = enclosure.lower[i];
    result.upper[axes[i]] = enclosure.upper[i];
  }
  return result;
}

// The coordinates of the root of a region that are rational, by a proof: a solution that is found in the region is that
// root.
inline Partial_point rational_coordinates(const Constraint_system_d& system,
                                          const Certified_region<Exact_rational>& region,
                                          const Root_enclosure<Exact_rational>& enclosure)
{
  constexpr long longest = 64;   // beside some hundred bits that the enclosure fixes
  for (std::size_t j = 0; j < enclosure.lower.size(); ++j) {
    const Exact_rational width = enclosure.upper[j] - enclosure.lower[j];
    if (enclosure.lower[j] - width < region.lower[j] || region.upper[j] < enclosure.upper[j] + width)
      return Partial_point(enclosure.lower.size());
  }
  return partly_rational_solution(system, enclosure.lower, enclosure.upper, longest).values;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_RATIONAL_COORDINATES_H
