// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/System_decomposition.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/proof_by_parts.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/proof_of_answer.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/surface_proof.h>
#endif

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

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
  if constexpr (std::is_floating_point_v<Coordinate>)
    for (const auto& [lower, upper] : solution.box())
      if (!std::isfinite(lower) || !std::isfinite(upper))
        return false;
  std::vector<std::pair<Exact_rational, Exact_rational>> box;
  for (const auto& [lower, upper] : solution.exact_box()) {
    if (upper < lower)
      return false;
    box.push_back({lower, upper});
  }
  if (box.size() != static_cast<std::size_t>(system.dimension()))
    return false;
  return internal::verification::is_proved(system, solution.kind(), box, solution.ends()) ||
      (solution.kind() < Solution_kind::CONTINUUM && system.dimension() > 1 &&
       internal::is_solution_proved_by_parts(system, solution.kind(), box));
}

/*!
\ingroup PkgSplineConstraintsDSolver

proves the cells of surfaces of solutions once more, from their boxes alone, in exact rational arithmetic and apart from
the solver: that solutions in the box of each patch are a graph over its parameters and have its orientation, those in
the box of each arc, on its plane, a graph over its parameter, that the box of each vertex holds one solution on its
planes, and that boundaries are loops. `true` only when all of these proofs succeed. That there are no other solutions
is not proved again, nor are patches with an apex, for which the answer is `false`; `false` says nothing else either, as
bounds are other ones than those of the solver.

Cost: an exact expansion of the equalities for each cell, of a patch several ones; much more than solving takes.
*/
inline bool verify(const Surface_solution_set_d& set)
{
  return internal::verification::are_surfaces_proved(set);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VERIFY_H
