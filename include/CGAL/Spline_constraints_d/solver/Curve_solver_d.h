// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_SOLVER_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_SOLVER_D_H

#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#if !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED) && !defined(CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY)
#include <CGAL/Spline_constraints_d/solver/internal/curves/all_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/curves_after_elimination.h>
#endif

#include <array>
#include <concepts>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline Curve_solution_set_d all_curves(const Constraint_system_d& system, const Solver_options& options,
                                       const Curve_search& search)
{
  options.check();
  Run_control control(options);
  return all_curves<Certified_solver_traits, CGAL::Sequential_tag>(system, options, control, search);
}

// For domains whose faces are seams or cuts, where each point is on several faces: curves in them are undecided.
inline Curve_solution_set_d curves_within(const Constraint_system_d& system, const Solver_options& options)
{
  return all_curves(system, options, {.are_faces_undecided = true});
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

Finds all solutions of a system with one equality less than unknowns: curves, with their topology by proof.

The domain is cut into boxes. The points where curves cross the cutting planes are solutions of systems with one unknown
less, which `Subdivision_solver_d` finds with their proofs, once for the boxes on both sides. A box is dropped when it
is proved to hold no solution, and accepted when its solutions are proved to be a graph over one unknown: then there is
no closed curve inside, and the order of the points on its boundary tells how they are joined. So no curve is lost,
however small, nothing is joined by distance, and a curve is closed when its pieces are.

Singular points with rational coordinates are proved with the number of branches that end there, whatever their order:
cusps, points where curves touch, multiple points, isolated solutions; also on the boundary of the domain, on breaks,
and where inequalities are zero. At other places inside the domain this is done where two curves cross transversally,
and for isolated solutions with a definite quadratic part. Both need at most four unknowns. Where nothing succeeds,
boxes are left undecided; those that touch are one region.

Inequalities cut the curves where they are zero, at certified points. An end where a strict inequality is zero does not
belong to the curve: where \f$g > 0\f$ or \f$g \neq 0\f$ excludes one point, a curve ends there and another one begins,
which
\f$g \ge 0\f$ leaves together. Curves along which an inequality is zero are left undecided, and so is a regular point
where two are zero.

A curve that an equality counts several times, by a repeated factor in each of its cells, is found once, with its
`Solution_curve::multiplicity()`; so are many curves along which two polynomials in three unknowns have parallel
gradients (see the manual). Curves that lie in a face of the domain, or in a plane of breaks, are found, and where
others meet them, if an equality is zero on the whole face or plane; otherwise they are undecided.

\tparam Traits bundles number type and policies, a model of `ConstraintSolverTraits`: boxes are subdivided with its
number type and its splitter. Points on the cutting planes are always decided by `Certified_solver_traits`.
\tparam Concurrency_tag as for `Subdivision_solver_d`: the answers are the same, in the same order.

Source: \cgalCite{kes-gcps-05}, section 2 (the curves); the graph test in the place of a tracing by steps.
*/
template <ConstraintSolverTraits Traits = Certified_solver_traits, class Concurrency_tag = CGAL::Sequential_tag>
class Curve_solver_d
{
  Solver_options m_options;

public:
  //! \param options the tolerance is the width, relative to \f$\max(1, |x|)\f$, below which an undecided box is not
  //! split any further. The limits hold for the boxes of the subdivision; the number of nodes is that for the curves in
  //! a face or a plane of breaks, and for all others, each.
  //! \throws Invalid_input when an option makes no sense.
  explicit Curve_solver_d(const Solver_options& options = {.tolerance = 1e-8}) : m_options(options)
  {
    m_options.check();
  }

  //! all curves of solutions.
  //! \param system the constraints; one equality less than unknowns.
  //! \throws Invalid_input when the number of equalities is another one, or the range of an unknown is one number.
  Curve_solution_set_d operator()(const Constraint_system_d& system) const
  {
    internal::check_definitions<Traits, internal::are_curves_compiled<Traits, Concurrency_tag>>();
    internal::Run_control control(m_options);
    return internal::all_curves<Traits, Concurrency_tag>(system, m_options, control, {});
  }

  //! the same, watched by this visitor and not by that of the options. Of the progress it is told only that the run
  //! goes on.
  template <SolverVisitor Visitor>
  Curve_solution_set_d operator()(const Constraint_system_d& system, Visitor& visitor) const
  {
    Solver_options options = m_options;
    options.visitor = visitor;
    return Curve_solver_d(options)(system);
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver

all solutions of a system with one equality less than unknowns, with the default traits: curves, with their topology by
proof. Unknowns that equalities of degree one, or combinations of equalities, give by others are eliminated before, as
`Decomposing_solver_d` does, unless answers reach the bounds of such an unknown; `Curve_solver_d` does without.
\param system the constraints; one equality less than unknowns.
\param options as for `Curve_solver_d`.
\tparam Concurrency_tag as for `Curve_solver_d`.
\throws Invalid_input as `Curve_solver_d`.
*/
template <class Concurrency_tag = CGAL::Sequential_tag>
Curve_solution_set_d solve_curves(const Constraint_system_d& system,
                                  const Solver_options& options = {.tolerance = 1e-8})
{
  using Traits = Certified_solver_traits;
  internal::check_definitions<Traits, internal::are_curves_compiled<Traits, Concurrency_tag>>();
  options.check();
  internal::Run_control control(options);
  return internal::curves_after_elimination<Traits, Concurrency_tag>(system, options, control);
}

/*!
\ingroup PkgSplineConstraintsDSolver
all curves of solutions of constraints written as formulas: `solve_curves(x*x + y*y + z*z == 4, square(x - 1) + y*y ==
1)`.
\throws Invalid_input as `make_system()` and the function above.
*/
template <std::same_as<Constraint>... Constraints>
Curve_solution_set_d solve_curves(const Constraint& first, const Constraints&... others)
{
  const std::array<Constraint, 1 + sizeof...(others)> constraints{first, others...};
  return solve_curves(make_system(constraints));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CURVE_SOLVER_D_H
