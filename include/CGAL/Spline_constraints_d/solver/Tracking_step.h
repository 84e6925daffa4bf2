// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TRACKING_STEP_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TRACKING_STEP_H

#include <CGAL/Spline_constraints_d/function/Operation_count.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
What a `Constraint_tracker` has done at one time.
*/
enum class Tracking_status
{
  HELD,       ///< the last point satisfies the constraints at this time, too
  REPAIRED,   ///< relaxation from the last point has led to one that does
  FOUND,      ///< `Feasibility_solver_d` has found one that does, which may be far from the last one
  INFEASIBLE, ///< no point of the domain does at this time, by proof
  NOT_FOUND   ///< no such point was found; nothing is proved
};

inline std::ostream& operator<<(std::ostream& out, Tracking_status status)
{
  static const char* const names[] = {"held", "repaired", "found", "infeasible", "not found"};
  return out << names[static_cast<int>(status)];
}

/*!
\ingroup PkgSplineConstraintsDSolver
The answer of a `Constraint_tracker` at one time, and what it has cost.
*/
struct Tracking_step
{
  Tracking_status status = Tracking_status::NOT_FOUND;

  //! the time.
  Exact_rational time;

  //! a point that satisfies all constraints at this time, checked by exact signs, with a coordinate for each unknown
  //! that was made together with the time, the time among them; empty where there is none.
  std::vector<Exact_rational> point;

  //! the points of the relaxation in doubles, from the last point on.
  std::vector<std::vector<double>> path;

  //! operations in doubles on the path: of all values (\f$V\f$ in all), and of the gradients of violated constraints
  //! beyond these (\f$U\f$).
  Operation_count values, gradients;

  //! what the violated constraints would take by themselves, summed over the path: \f$\sum c_i\f$ over those for which
  //! a gradient was computed. \f$U\f$ has at most twice as many products and quotients, and less than four times as
  //! many operations.
  Operation_count violated;

  //! how many constraints were looked at in intervals, and how many of them in exact numbers, too.
  std::size_t enclosures = 0, exact_signs = 0;

  //! where nothing was found: the boxes that are undecided, each with the reason.
  std::vector<Undecided_part> undecided_parts;

  //! the work: nodes are those of `Feasibility_solver_d`.
  Summary work;

  //! whether there is a point.
  bool has_point() const { return !point.empty(); }

  //! whether there is a point, or a proof that there is none.
  bool is_complete() const { return status != Tracking_status::NOT_FOUND; }
  const std::vector<Undecided_part>& undecided() const { return undecided_parts; }
  const Summary& summary() const { return work; }

  //! writes `time 1/2: repaired; 3 steps, 120 operations, 0 exact signs; complete: yes`.
  friend std::ostream& operator<<(std::ostream& out, const Tracking_step& step)
  {
    return out << "time " << step.time << ": " << step.status << "; " << (step.path.empty() ? 0 : step.path.size() - 1)
               << " steps, " << step.values.total() + step.gradients.total() << " operations, " << step.exact_signs
               << " exact signs; complete: " << (step.is_complete() ? "yes" : "no");
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TRACKING_STEP_H
