// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_PLANE_RESTRICTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_PLANE_RESTRICTION_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Integer_spline.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_ranges = std::vector<std::pair<Exact_rational, Exact_rational>>;

// Keeps of the layers of a row-major array along one axis, which has `layers` of them with `inner` entries next to each
// other, what `merged(first entry, distance)` makes of each row.
template <class T, class Merge>
std::vector<T> without_axis(const std::vector<T>& entries, std::size_t layers, std::size_t inner, const Merge& merged)
{
  std::vector<T> result;
  for (std::size_t begin = 0; begin < entries.size(); begin += layers * inner)
    for (std::size_t i = begin; i < begin + inner; ++i)
      result.push_back(merged(entries.data() + i, inner));
  return result;
}

// A term with the parameter of one of its axes fixed.
inline Spline_term with_fixed(const Spline_term& term, std::size_t axis, const Exact_rational& value)
{
  std::size_t inner_cells = 1, inner_size = 1;
  for (std::size_t j = axis + 1; j < term.variables.size(); ++j) {
    inner_cells *= term.cells(j);
    inner_size *= static_cast<std::size_t>(term.degrees[j]) + 1;
  }
  const std::size_t cell = cell_at(term.breaks[axis], value);
  const int degree = term.degrees[axis];
  Spline_term result;
  result.pieces = without_axis(
      term.pieces, term.cells(axis), inner_cells, [&](const std::vector<Exact_rational>* piece, std::size_t step) {
        return without_axis(piece[cell * step], static_cast<std::size_t>(degree) + 1, inner_size,
                            [&](const Exact_rational* coefficient, std::size_t distance) {
                              Exact_rational sum = coefficient[degree * distance];
                              for (int k = degree - 1; k >= 0; --k) { // many coefficients are zero
                                if (!CGAL::is_zero(sum))
                                  sum *= value;
                                if (!CGAL::is_zero(coefficient[k * distance]))
                                  sum += coefficient[k * distance];
                              }
                              return sum;
                            });
      });
  for (std::size_t j = 0; j < term.variables.size(); ++j)
    if (j != axis) {
      result.variables.push_back(term.variables[j]);
      result.degrees.push_back(term.degrees[j]);
      result.breaks.push_back(term.breaks[j]);
    }
  return result;
}

// A function with the value of an unknown fixed; the unknowns behind it are numbered one less.
inline Spline_function with_fixed(const Spline_function& function, int unknown, const Exact_rational& value)
{
  Spline_function result;
  for (const Spline_term& term : function.terms()) {
    const auto place = std::find(term.variables.begin(), term.variables.end(), unknown);
    Spline_term rest = place == term.variables.end()
        ? term
        : with_fixed(term, static_cast<std::size_t>(place - term.variables.begin()), value);
    for (int& v : rest.variables)
      v -= v > unknown;
    result += Spline_function(std::move(rest));
  }
  return result;
}

// A system on another box, with change(function) in the place of each function.
template <class Change>
Constraint_system_d changed(const Constraint_system_d& system, Exact_ranges box, const Change& change)
{
  Constraint_system_d result(std::move(box));
  for (const Spline_function& function : system.equalities())
    result.add(change(function), Relation::EQUAL);
  for (const auto& [function, relation] : system.inequalities())
    result.add(change(function), relation);
  return result;
}

// A system on the part of a plane, where an unknown has a fixed value, that lies in a box.
inline Constraint_system_d on_plane(const Constraint_system_d& system, Exact_ranges box, int unknown,
                                    const Exact_rational& value)
{
  box.erase(box.begin() + unknown);
  return changed(system, std::move(box),
                 [&](const Spline_function& function) { return with_fixed(function, unknown, value); });
}

// A system on a box within one cell, as polynomials.
inline Constraint_system_d on_cell(const Constraint_system_d& system, const Exact_ranges& box)
{
  return changed(system, box, [&](const Spline_function& function) {
    Spline_function polynomial;
    for (const Spline_term& term : function.terms()) {
      std::size_t piece = 0;
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        piece = piece * term.cells(j) + cell_at(term.breaks[j], box[term.variables[j]].first);
      polynomial += Spline_function(Spline_term{term.variables,
                                                term.degrees,
                                                std::vector<std::vector<Exact_rational>>(term.variables.size()),
                                                {term.pieces[piece]}});
    }
    return polynomial;
  });
}

// The equalities alone, on a box.
inline Constraint_system_d equalities_on(const Constraint_system_d& system, const Exact_ranges& box)
{
  Constraint_system_d result(box);
  for (const Spline_function& function : system.equalities())
    result.add(function, Relation::EQUAL);
  return result;
}

inline Exact_ranges domain_of(const Constraint_system_d& system)
{
  Exact_ranges domain;
  for (int v = 0; v < system.dimension(); ++v)
    domain.push_back(system.domain(v));
  return domain;
}

inline Constraint_system_d equalities_of(const Constraint_system_d& system)
{
  return equalities_on(system, domain_of(system));
}

// The closure of what a system allows, where no inequation f != 0 has its zeros along a whole curve.
inline Constraint_system_d without_inequations(const Constraint_system_d& system)
{
  Constraint_system_d result = equalities_of(system);
  for (const auto& [function, relation] : system.inequalities())
    if (relation != Relation::NOT_EQUAL)
      result.add(function, relation);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_NODE_PLANE_RESTRICTION_H
