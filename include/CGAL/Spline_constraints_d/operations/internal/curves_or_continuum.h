// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVES_OR_CONTINUUM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVES_OR_CONTINUUM_H

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline bool is_zero(const Spline_function& function)
{
  const auto is_zero_piece = [](const std::vector<Exact_rational>& piece) { return std::all_of(piece.begin(), piece.end(), [](const Exact_rational& coefficient) { return CGAL::is_zero(coefficient); }); };
  return std::all_of(function.terms().begin(), function.terms().end(), [&](const Spline_term& term) { return std::all_of(term.pieces.begin(), term.pieces.end(), is_zero_piece); });
}

// A box where nothing is proved.
inline Curve_solution_set_d undecided_curves(Curve_vertex::Exact_box box, Undecided_reason reason)
{
  Summary summary;
  summary.is_complete = false;
  return Curve_solution_set_d({}, {}, {}, {}, {{{std::move(box)}, {}, reason}}, summary);
}

// The curves of solutions of a system; everything is undecided where an equation is always satisfied.
inline Curve_solution_set_d curves_or_continuum(const Constraint_system_d& system, const Solver_options& options)
{
  if (std::none_of(system.equalities().begin(), system.equalities().end(), [](const auto& equality) { return is_zero(equality); }))
    return solve_curves(system, options);
  Curve_vertex::Exact_box domain;
  for (int j = 0; j < system.dimension(); ++j)
    domain.push_back(system.domain(j));
  return undecided_curves(std::move(domain), Undecided_reason::CONTINUUM);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CURVES_OR_CONTINUUM_H
