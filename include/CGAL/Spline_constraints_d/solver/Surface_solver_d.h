// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLVER_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLVER_D_H

#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#if !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED) && !defined(CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY)
#include <CGAL/Spline_constraints_d/solver/internal/curves/all_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/surfaces_after_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/all_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/united_surfaces.h>
#endif

#include <array>
#include <concepts>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Finds all solutions of a system with two equalities less than unknowns: surfaces, with their topology by proof.

The domain is cut into boxes. The curves in which surfaces meet the cutting planes are found by the solver for curves,
once for the boxes on both sides, and cut where other planes cross them. A box is dropped when it is proved to hold no
solution, and accepted when its solutions are proved to be a graph over two unknowns, and the curves on its boundary one
loop: then they are a disk. So no component and no hole is lost, however small, and nothing is joined by distance.

A surface may touch a face of the domain: at a point with rational coordinates where the contact is of second order, or
along a curve where an equality has a factor with an even exponent on the face, it is decided from which side. Corners
of the domain that surfaces pass through are decided for three unknowns, and so are edges of the domain that are
solutions, for one equality in three unknowns, beside which others may give one unknown each. Inequalities cut surfaces
as faces of the domain do, see `Surface_solution_set_d`.
Vertices where surfaces meet are told. Of one equality in three unknowns, isolated singular points inside of the domain,
and of the cells of splines, are decided with the disks that end in them: where the second derivative is regular, as at
the apex of a cone, and rational ones where weights of the unknowns exist such that the terms of least weight have no
other singular point, as where spheres touch. Faces of the domain and inequalities may cut through rational ones of the
first kind, across the cone. Repeated factors of equalities are left out. Polynomials in up to three
unknowns are factored over the rational numbers: surfaces of different factors have no common cells, and the curves
where they meet are told. The same holds for faces of the domain, and planes of breaks, on which an equality is zero.
With features this is not done. Other singular points and curves are left undecided; boxes that touch are one region.

\tparam Traits bundles number type and policies, a model of `ConstraintSolverTraits`: boxes are subdivided with its
number type and its splitter. Curves and points on planes are always decided by `Certified_solver_traits`.
\tparam Concurrency_tag as for `Subdivision_solver_d`: the answers are the same, in the same order.

Source: \cgalCite{me-tgbs-15}, of which the curves between neighbours are shared here.
*/
template <ConstraintSolverTraits Traits = Certified_solver_traits, class Concurrency_tag = CGAL::Sequential_tag>
class Surface_solver_d
{
  Solver_options m_options;

public:
  //! \param options the tolerance is the width, relative to \f$\max(1, |x|)\f$, below which an undecided box is not
  //! split any further; the limit of nodes holds for boxes and what is looked at on planes together.
  //! \throws Invalid_input when an option makes no sense.
  explicit Surface_solver_d(const Solver_options& options = {.tolerance = 1e-8}) : m_options(options)
  {
    m_options.check();
  }

  //! all surfaces of solutions.
  //! \param system the constraints; two equalities less than unknowns.
  //! \throws Invalid_input when the number of equalities is another one, the range of an unknown is one number, or a
  //! function that is not to be zero may be so somewhere.
  Surface_solution_set_d operator()(const Constraint_system_d& system) const
  {
    internal::check_definitions<Traits, internal::are_curves_compiled<Traits, Concurrency_tag>>();
    internal::Run_control control(m_options);
    return internal::surfaces_of_factors<Traits, Concurrency_tag>(system, m_options, control);
  }

  /*!
  the same, cut along curves.
  \param system the constraints; two equalities less than unknowns.
  \param features functions along whose zeros surfaces are cut into patches: the curves in which a surface of solutions
  meets the zeros of such a function are arcs, and edges of a mesh. Boxes have one more range for each of them, that of
  its values. Where zeros only touch a surface, or cross each other, it may be undecided.
  \throws Invalid_input also when a feature has an unknown that the system does not have.
  */
  Surface_solution_set_d operator()(const Constraint_system_d& system,
                                    const std::vector<Spline_function>& features) const
  {
    internal::check_definitions<Traits, internal::are_curves_compiled<Traits, Concurrency_tag>>();
    internal::Run_control control(m_options);
    return internal::all_surfaces<Traits, Concurrency_tag>(system, m_options, control, features);
  }

  //! the same, watched by this visitor and not by that of the options. Of the progress it is told only that the run
  //! goes on.
  template <SolverVisitor Visitor>
  Surface_solution_set_d operator()(const Constraint_system_d& system, Visitor& visitor) const
  {
    Solver_options options = m_options;
    options.visitor = visitor;
    return Surface_solver_d(options)(system);
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver

all solutions of a system with two equalities less than unknowns, with the default traits: surfaces, with their topology
by proof. In systems without inequalities and breaks, unknowns that equalities of degree one, or combinations of
equalities, give by others are eliminated before, as `solve_curves()` does; `Surface_solver_d` does without.
\param system the constraints; two equalities less than unknowns.
\param options as for `Surface_solver_d`.
\tparam Concurrency_tag as for `Surface_solver_d`.
\throws Invalid_input as `Surface_solver_d`.
*/
template <class Concurrency_tag = CGAL::Sequential_tag>
Surface_solution_set_d solve_surfaces(const Constraint_system_d& system,
                                      const Solver_options& options = {.tolerance = 1e-8})
{
  using Traits = Certified_solver_traits;
  internal::check_definitions<Traits, internal::are_curves_compiled<Traits, Concurrency_tag>>();
  options.check();
  internal::Run_control control(options);
  return internal::surfaces_after_elimination<Traits, Concurrency_tag>(system, options, control);
}

//! \ingroup PkgSplineConstraintsDSolver
//! the same, cut along the zeros of functions, see `Surface_solver_d`; no unknowns are eliminated.
template <class Concurrency_tag = CGAL::Sequential_tag>
Surface_solution_set_d solve_surfaces(const Constraint_system_d& system, const std::vector<Spline_function>& features,
                                      const Solver_options& options = {.tolerance = 1e-8})
{
  return Surface_solver_d<Certified_solver_traits, Concurrency_tag>(options)(system, features);
}

/*!
\ingroup PkgSplineConstraintsDSolver
all surfaces of solutions of constraints written as formulas: `solve_surfaces(x*x + y*y + z*z == 1)`.
\throws Invalid_input as `make_system()` and the function above.
*/
template <std::same_as<Constraint>... Constraints>
Surface_solution_set_d solve_surfaces(const Constraint& first, const Constraints&... others)
{
  const std::array<Constraint, 1 + sizeof...(others)> constraints{first, others...};
  return solve_surfaces(make_system(constraints));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_SOLVER_D_H
