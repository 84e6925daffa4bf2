// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/proof_by_parts.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/Elementary_proof.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/proof_of_answer.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/surface_proof.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace verification {

// Nothing where it is infinite or empty or has a wrong number of ranges.
template <class Coordinate>
std::optional<std::vector<std::pair<Exact_rational, Exact_rational>>> box_of(const Solution_d<Coordinate>& solution,
                                                                             int dimension)
{
  if constexpr (std::is_floating_point_v<Coordinate>)
    for (const auto& [lower, upper] : solution.box())
      if (!std::isfinite(lower) || !std::isfinite(upper))
        return std::nullopt;
  std::vector<std::pair<Exact_rational, Exact_rational>> box;
  for (const auto& [lower, upper] : solution.exact_box()) {
    if (upper < lower)
      return std::nullopt;
    box.push_back({lower, upper});
  }
  return static_cast<int>(box.size()) == dimension ? std::optional(std::move(box)) : std::nullopt;
}

// Defined in verification/Elementary_proof.h.
bool is_proved(const std::vector<std::pair<Exact_rational, Exact_rational>>& domain,
               const std::vector<std::pair<Power_polynomial, Relation>>& constraints, const Elementary_values& values,
               Solution_kind kind, const std::vector<std::pair<Exact_rational, Exact_rational>>& box);

} // namespace verification
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

proves one answer of the solver once more, from the system and the box of the answer alone, in exact rational arithmetic
and sharing no code with the subdivision. `true` only when the proof succeeds; `false` says nothing about the system,
but no certified answer of the solver is expected to give it.

A *certified* answer with the box \f$B\f$: let \f$y\f$ be the middle and \f$r\f$ the radius of \f$B\f$, \f$J\f$ a set of
matrices whose convex hull holds the derivatives on
\f$B\f$ of all pieces of the equalities \f$F\f$, and \f$C\f$ any matrix, here the inverse of a matrix amid \f$J\f$ in
rationals of 128 bits. \f$I - C J\f$ is bounded by the coefficients of
\f$C F\f$ in Taylor's formula at the middle of each part of \f$B\f$ between breaks; equations that nearly coincide
cancel in them. Neighbouring pieces are checked to agree where they meet, so \f$F\f$ is continuous on \f$B\f$, the mean
of its derivatives along a segment lies in \f$J\f$, and \f$x \mapsto x - C F(x)\f$ maps \f$B\f$ into
\f[ K = y - C F(y) + (I - C J)(B - y). \f]
If \f$K\f$ lies in the interior of \f$B\f$ (Krawczyk, Newton-Algorithmen zur Bestimmung von Nullstellen mit
Fehlerschranken, Computing 4, 1969; Moore, A test for existence of solutions to nonlinear systems, SIAM J. Numer. Anal.
14, 1977), then \f$|I - C J|\, r < r\f$ in every coordinate: the map is a contraction of
\f$B\f$ in the maximum norm weighted by \f$1/r\f$, all matrices in \f$C J\f$ are regular, and so \f$B\f$ holds exactly
one zero of \f$C F\f$, which is regular; for as many equalities as unknowns \f$C\f$ is regular and this is exactly one
zero of \f$F\f$.

The shape of \f$B\f$ may forbid this: it is very thin on some axes, or its solution lies on a face. Then it is tried on
a slightly larger box (the inflation of Rump, Solving algebraic problems with high accuracy, 1983), and the solution has
to be proved to lie in \f$B\f$.

At last the operator shrinks \f$K\f$ until all of it lies in \f$B\f$ and in the domain and satisfies the inequalities.
When the solution lies on the boundary of one of them, or there are more equalities than unknowns, only exact
coordinates decide: the simplest rational point of \f$K\f$ is tried; then, some coordinates that look rational are
fixed, and the operator has to prove a zero of the other coordinates and of the equalities that this leaves. Last, the
signs of the other equalities, of the inequalities and of the distances to the boundary of the domain are decided at the
root of \f$n\f$ equalities, in intervals of some thousand bits, with a bound below which they are zero.

A *cluster*: proves that the box holds a solution, which is its simplest rational point in the domain, or has some
coordinates that look rational and others by the operator, as above; or is a double root by exact signs. How many there
are is not proved.

Where this fails for a certified answer or a cluster, the same is proved of each part of the system as
`Decomposing_solver_d` decomposes it, and that the box holds the values which these give to the eliminated unknowns.

A *continuum* that is a segment: every equality is zero at so many points of it, between breaks, that it is zero on all
of it; and the inequalities hold, up to their boundary, on the boxes around
16 parts of it.

With *one unknown*, what these do not prove is left to Sturm's theorem: the number of roots of the greatest common
divisor of the equalities in the box, piece by piece, and the signs of the inequalities there; for a *continuum*, that
all points of the box are solutions, up to a rounding error at its ends.

Undecided answers, and other continua, carry no proof: `false`. So do boxes with a wrong number of ranges, or empty or
infinite ones.

Cost: \f$O(n^3)\f$ rational operations, and per equality \f$O(N \sum_j d_j)\f$ for pieces of \f$N\f$ coefficients, a few
times over. Independent of the rounding mode.

\param system the system that was solved.
\param solution the answer; of it, `kind()` and `exact_box()`, or `ends()`, are used.
*/
template <class Coordinate>
bool verify(const Constraint_system_d& system, const Solution_d<Coordinate>& solution)
{
  const auto box = internal::verification::box_of(solution, system.dimension());
  return box &&
      (internal::verification::is_proved(system, solution.kind(), *box, solution.ends()) ||
       (solution.kind() < Solution_kind::CONTINUUM && system.dimension() > 1 &&
        internal::is_solution_proved_by_parts(system, solution.kind(), *box)));
}

/*!
\ingroup PkgSplineConstraintsDSolver

proves one answer of `Propagation_solver_d` once more, in intervals of 256 bits by MPFR and sharing no code with the
search: `true` only when the proof succeeds.

A *certified* answer: the operator of Krawczyk, with \f$J\f$ the derivatives on a box that is wider by an eighth and a
margin, maps this into its inside; then it is shrunk until its root is proved to lie in the box of the answer and in the
domain and to satisfy the inequalities; or a rational point, where all values are rational by the laws of the functions,
is that root. All values have to be defined and differentiable on the wider box. A *cluster*: proves that the box holds
a solution, its simplest rational point or as above.

Cost: \f$O(n^3)\f$ operations on numbers of 256 bits, a few times over, and those for values and derivatives.
\param domain a range for each unknown.
\param constraints the polynomials that were solved, and how they compare with zero.
\param values what the values of elementary functions are; none where there are polynomials only.
\param solution the answer; of it, `kind()` and `exact_box()` are used.
*/
template <class Coordinate>
bool verify(const std::vector<Constraint_system_d::Domain>& domain,
            const std::vector<std::pair<Power_polynomial, Relation>>& constraints, const Elementary_values& values,
            const Solution_d<Coordinate>& solution)
{
  const auto box = internal::verification::box_of(solution, static_cast<int>(domain.size()));
  return box && internal::verification::is_proved(domain, constraints, values, solution.kind(), *box);
}

/*!
\ingroup PkgSplineConstraintsDSolver
proves an answer of `solve()` to constraints written as formulas once more, in the one or the other way.
\param constraints the formulas that were solved.
\param solution the answer.
\throws Invalid_input as `make_system()` or `elementary_constraints()`.
*/
template <class Coordinate>
bool verify(std::span<const Constraint> constraints, const Solution_d<Coordinate>& solution)
{
  if (!std::ranges::any_of(constraints, &Constraint::has_elementary_functions))
    return verify(make_system(constraints), solution);
  const Elementary_constraints all = elementary_constraints(constraints);
  return verify(all.domain, all.constraints, all.values, solution);
}

/*!
\ingroup PkgSplineConstraintsDSolver

proves the cells of surfaces of solutions once more, from their boxes alone, in exact rational arithmetic and apart from
the solver: that solutions in the box of each patch are a graph over its parameters and have its orientation, those in
the box of each arc, on its plane, a graph over its parameter, that the box of each vertex holds one solution on its
planes, and that boundaries are loops. `true` only when all of these proofs succeed. That there are no other solutions
is not proved again, nor are patches with an apex, and cells where surfaces meet a face at no angle, as at a saddle, or
begin within an edge, for which the answer is `false`; `false` says nothing else either, as bounds are other ones than
those of the solver.

Cost: an exact expansion of the equalities for each cell, of a patch several ones; much more than solving takes.
*/
inline bool verify(const Surface_solution_set_d& set)
{
  return internal::verification::are_surfaces_proved(set);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H
