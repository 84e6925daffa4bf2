// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONSTRAINT_TRACKER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONSTRAINT_TRACKER_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Operation_count.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/solver/Tracker_options.h>
#include <CGAL/Spline_constraints_d/solver/Tracking_step.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/tracking/tracking_steps.h>
#endif

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

class Tracking;

// Defined in tracking/tracking_steps.h.
std::shared_ptr<Tracking> tracking_from(const Unknown& time, std::vector<Exact_rational> start,
                                        const Tracker_options& options);
void add_link(Tracking& tracking, std::span<const Unknown> unknowns, std::vector<Expression> formulas);
std::size_t add_constraint(Tracking& tracking, const Constraint& constraint);
void remove_constraint(Tracking& tracking, std::size_t index);
Tracking_step advanced(Tracking& tracking, const Exact_rational& time);
const std::vector<Exact_rational>& point_of(const Tracking& tracking);
Operation_count operations_of_check(Tracking& tracking);

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

Follows points that satisfy inequalities which change with time: Pai's Least Constraint. A motion is described as weakly
as one likes, by regions that move, shrink or stay; where in them the point is does not matter.

\code
const auto [x, y, t] = unknowns({-2, 2}, {-2, 2}, {0, 1});
Constraint_tracker tracker(t, {1, 0, 0});
tracker.add(square(x - 1 + 2 * t) + square(y) <= 1);
for (int k = 0; k <= 10; ++k)
  std::cout << tracker.advance(0.1 * k) << '\n';
\endcode

Constraints may be in unknowns of another domain, for example in the position of a hand, that formulas in the joints
give: see `link()`. Then \f$f(y,t) \le 0\f$ becomes \f$f(l(x),t) \le 0\f$ in one `Expression_graph`, in which
constraints share what they have in common, and the gradient \f$Dl^T \nabla f\f$ comes by reverse differentiation.
Nothing is inverted, so that a singular \f$Dl\f$ is no obstacle.

At each time, the last point is tried; then relaxation starts from it, in doubles; then `Feasibility_solver_d` searches
boxes around it that grow up to the domain, in which it finds a point, or proves that there is none. A point is returned
only if exact signs, or signs that intervals make certain, prove that it satisfies all constraints. Nothing is said of
the times in between, nor that another point at an earlier time would not have led farther.

Complexity: a step of the relaxation takes the operations of all constraints, once where they share them, and at most
four times those of each violated one: `Tracking_step` has counted them.

Source: D. K. Pai, Least Constraint: A Framework for the Control of Complex Mechanical Systems, ACC 1991.
*/
class Constraint_tracker
{
  std::shared_ptr<internal::Tracking> m_tracking;

public:
  /*!
  without constraints.
  \param time one of the unknowns of the basic domain: those that were made together.
  \param start where the first relaxation starts, a coordinate for each unknown of the basic domain, the time among
  them; it need not satisfy anything, and is moved into their ranges.
  \param options how to go on.
  \throws Invalid_input when the start has a wrong number of coordinates, no other unknown was made together with the
  time, or an option makes no sense.
  */
  explicit Constraint_tracker(const Unknown& time, std::vector<Exact_rational> start,
                              const Tracker_options& options = {})
    : m_tracking(internal::tracking_from(time, std::move(start), options))
  {}

  Constraint_tracker(const Constraint_tracker&) = delete;
  Constraint_tracker& operator=(const Constraint_tracker&) = delete;
  Constraint_tracker(Constraint_tracker&&) = default;
  Constraint_tracker& operator=(Constraint_tracker&&) = default;

  /*!
  defines unknowns of another domain by formulas in those of the basic one, or of one that was linked before.

  The ranges of the unknowns become constraints. A formula that is the time itself makes an unknown of the domain the
  time, too, on which splines may depend.
  \param unknowns all unknowns of one call of `unknowns()`.
  \param formulas one for each of them.
  \throws Invalid_input when these are not all, they are linked already, the numbers differ, the unknowns of a formula
  are not linked, or one that is the time has a smaller range than it.
  */
  void link(std::span<const Unknown> unknowns, std::vector<Expression> formulas)
  {
    internal::add_link(*m_tracking, unknowns, std::move(formulas));
  }

  /*!
  adds a constraint in the unknowns of one domain. Where one of its divisors is zero, it does not hold.
  \return a number for `remove()`.
  \throws Invalid_input when its unknowns are not linked, or it is an equality: a toleranced one has a width.
  */
  std::size_t add(const Constraint& constraint) { return internal::add_constraint(*m_tracking, constraint); }

  //! adds several. \return their numbers.
  std::vector<std::size_t> add(std::span<const Constraint> constraints)
  {
    std::vector<std::size_t> result;
    for (const Constraint& constraint : constraints)
      result.push_back(add(constraint));
    return result;
  }

  //! takes a constraint away. \throws Invalid_input when there is none of this number.
  void remove(std::size_t number) { internal::remove_constraint(*m_tracking, number); }

  /*!
  a point that satisfies the constraints at this time, sought from the last one. Time may go in any direction.
  \throws Invalid_input when there are no constraints, the time is out of its range, or a spline depends on other
  unknowns than the time.
  */
  Tracking_step advance(const Bound& time) { return internal::advanced(*m_tracking, time.value()); }

  //! the last point that was found; before, the start.
  const std::vector<Exact_rational>& point() const { return internal::point_of(*m_tracking); }

  //! the operations that it takes to evaluate all constraints at a point, shared ones once.
  //! \throws Invalid_input as `advance()`.
  Operation_count operations_of_check() const { return internal::operations_of_check(*m_tracking); }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONSTRAINT_TRACKER_H
