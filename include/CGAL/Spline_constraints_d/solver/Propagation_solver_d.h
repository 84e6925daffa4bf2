// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PROPAGATION_SOLVER_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PROPAGATION_SOLVER_D_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/internal/compiled_tags.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/propagation/solutions_by_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/solutions_of_polynomials.h>
#endif

#include <CGAL/tags.h>

#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

// Defined in propagation/solutions_by_propagation.h.
template <class Concurrency_tag>
Solution_set_d<double>
solution_set_by_propagation(const std::vector<Constraint_system_d::Domain>& domain,
                            const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                            const Solver_options& options, const Elementary_values& values);

// Defined in propagation/solutions_of_polynomials.h.
template <class Concurrency_tag>
Solution_set_d<double>
solution_set_of_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                            const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                            const Solver_options& options);

#define CGAL_SPLINE_CONSTRAINTS_PROPAGATION(EXTERN, TAG)                                                               \
  EXTERN template Solution_set_d<double> solution_set_by_propagation<TAG>(                                             \
      const std::vector<Constraint_system_d::Domain>&, const std::vector<std::pair<Power_polynomial, Relation>>&,      \
      const Solver_options&, const Elementary_values&);                                                                \
  EXTERN template Solution_set_d<double> solution_set_of_polynomials<TAG>(                                             \
      const std::vector<Constraint_system_d::Domain>&, const std::vector<std::pair<Power_polynomial, Relation>>&,      \
      const Solver_options&);
CGAL_SPLINE_CONSTRAINTS_DECLARE_COMPILED(CGAL_SPLINE_CONSTRAINTS_PROPAGATION)

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

Finds all solutions of as many polynomial equations as unknowns, with inequalities, on a box. Polynomials stay sums of
monomials and are never made tensors: a product of thirty unknowns is one number here, and \f$2^{30}\f$ coefficients
there; a thousand equations in a few unknowns each take time in proportion to their terms.

Boxes are narrowed by one constraint and one unknown after the other, the others being in their ranges (constraint
propagation), and by affine enclosures of linear combinations of the equalities, whose multipliers come from a sparse
elimination that leaves out what bounds nothing yet; where a trial shows that it pays, also by slices of the range of
each unknown that propagation leaves nothing of. Long chains, whose constraints can be put into an order in which at
most four unknowns connect what is before and after each place, are cut into windows, which have boxes of their own: the
work is then a sum over these windows. A box is dropped only on a proof that it holds no solution, and a solution
is certified by the test of Krawczyk. What is left at the tolerance, multiple roots and roots on the boundary, is given
to `Subdivision_solver_d` on a small box, if its tensors have at most \f$2^{18}\f$ coefficients; otherwise it is
undecided. \ref Spline_constraints_d_propagation_proofs "Proofs"

Exactness: doubles with directed rounding; coefficients that are no doubles are enclosed. Certified solutions are
refined as far as that goes.

Complexity: per box, in the terms of the constraints for each pass, and for the elimination between \f$O(n)\f$ and
\f$O(n^3)\f$, as the equalities are sparse; the number of boxes may grow exponentially with \f$n\f$.

Sources: F. Benhamou, F. Goualard, L. Granvilliers, J.-F. Puget, *Revising hull and box consistency*, ICLP 1999; R.
Krawczyk, *Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken*, Computing 4 (1969); O. Lhomme,
*Consistency techniques for numeric CSPs*, IJCAI 1993; G. Trombettoni, G. Chabert, *Constructive interval disjunction*,
CP 2007.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to use all
cores through TBB. The answers are the same, in the same order, except where a time limit or the visitor ends the run.
*/
template <class Concurrency_tag = CGAL::Sequential_tag>
class Propagation_solver_d
{
  Solver_options m_options;

public:
  //! \throws Invalid_input when an option makes no sense.
  explicit Propagation_solver_d(const Solver_options& options = {}) : m_options(options) { m_options.check(); }

  /*!
  all solutions.
  \param domain a range for each unknown.
  \param constraints polynomials, and how they compare with zero; as many equalities as unknowns.
  \throws Invalid_input when a range is empty or missing, or the numbers of equalities and unknowns differ.
  */
  Solution_set_d<double> operator()(const std::vector<Constraint_system_d::Domain>& domain,
                                    const std::vector<std::pair<Power_polynomial, Relation>>& constraints) const
  {
    return internal::solution_set_by_propagation<Concurrency_tag>(domain, constraints, m_options, Elementary_values());
  }

  /*!
  all solutions of constraints with values of elementary functions. A point where one of the values is not defined is no
  solution.

  Exactness: functions and their derivatives are enclosed, by series with bounds of their rests or by MPFR with directed
  rounding, so solutions are certified as those of polynomials are. There are no exact signs. Regular roots on the
  boundary of the domain or of an inequality are decided, in up to 128 unknowns, where intervals of 256 bits tell on
  which side they are, or where what is not rational there cancels: coordinates may be rational, and angles may have
  rational sines and cosines. Others, and roots where a function is not differentiable, stay undecided with a box; so do
  multiple ones, unless they are rational and all values there are rational by the laws of the functions, as
  \f$e^0 = 1\f$.
  \param domain a range for each unknown.
  \param constraints polynomials in unknowns and values, and how they compare with zero; as many equalities as unknowns.
  \param values what the values are.
  \throws Invalid_input when a range is empty or missing, a value is missing, or the numbers of equalities and unknowns
  differ.
  */
  Solution_set_d<double> operator()(const std::vector<Constraint_system_d::Domain>& domain,
                                    const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                                    const Elementary_values& values) const
  {
    return internal::solution_set_by_propagation<Concurrency_tag>(domain, constraints, m_options, values);
  }

  //! the same of formulas in the unknowns of one call of `unknowns()`.
  //! \param constraints as many equalities as unknowns.
  //! \throws Invalid_input as `elementary_constraints()` and the functions above.
  Solution_set_d<double> operator()(std::span<const Constraint> constraints) const
  {
    const Elementary_constraints all = elementary_constraints(constraints);
    return (*this)(all.domain, all.constraints, all.values);
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver
all solutions of polynomials compared with zero, by `Decomposing_solver_d` or `Propagation_solver_d`: where tensors are
not too large, both are tried in turns, of more and more work, and go on where they were. Which one ends first depends
on counted work only, not on the clock.
\param domain a range for each unknown.
\param constraints polynomials, and how they compare with zero.
\tparam Concurrency_tag as for these solvers.
\param options limits and the rest, for all of it.
\throws Invalid_input as these solvers.
*/
template <class Concurrency_tag = CGAL::Sequential_tag>
Solution_set_d<double> solve_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                                         const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                                         const Solver_options& options = {})
{
  options.check();
  internal::check_definitions<Certified_solver_traits,
                              internal::are_points_compiled<Certified_solver_traits, Concurrency_tag>>();
  return internal::solution_set_of_polynomials<Concurrency_tag>(domain, constraints, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_PROPAGATION_SOLVER_D_H
