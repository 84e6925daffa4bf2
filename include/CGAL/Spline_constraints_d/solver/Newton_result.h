// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_RESULT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_RESULT_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <ostream>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
Why `improve_point()` stopped. The step is the least-norm Newton step at the point; it is tiny when none of its entries
exceeds \f$2^{-50}\f$ times the largest coordinate.
*/
enum class Newton_status {
  /// all equalities vanish exactly; or no entry of the step exceeds a unit in the last place of its coordinate, or
  /// \f$2^{-80}\f$ times the largest coordinate; or the step is tiny and lowers the residual no further
  CONVERGED,
  /// the step is not tiny, and neither it nor any of its halves down to \f$2^{-12}\f$ lowers the residual as a linear
  /// function would by half
  STAGNATED,
  /// the Jacobian, rows scaled to largest entry 1, has smaller numerical rank than there are equalities, or the step
  /// overflows
  SINGULAR,
  /// the step is not tiny, even its \f$2^{-12}\f$-th part leads out of the domain, and no step along the faces that the
  /// point lies on lowers the residual so
  LEFT_DOMAIN,
  ITERATION_LIMIT  ///< none of these after `Newton_options::maximal_iterations` steps
};

inline std::ostream& operator<<(std::ostream& out, Newton_status status)
{
  static const char* const names[] = {"converged", "stagnated", "singular", "left the domain", "iteration limit"};
  return out << names[static_cast<int>(status)];
}

/*!
\ingroup PkgSplineConstraintsDSolver
Options of `improve_point()`, to be used with designated initialisers.
*/
struct Newton_options
{
  //! most steps that are taken.
  int maximal_iterations = 100;

  //! the Jacobian has the rank of the number of pivots of its rank-revealing QR decomposition above this multiple of
  //! the largest one.
  double rank_tolerance = 1e-13;

  //! \throws Invalid_input when a value makes no sense.
  void check() const
  {
    if (maximal_iterations < 0)
      throw Invalid_input("Newton_options: the number of iterations must not be negative");
    if (!(rank_tolerance > 0 && rank_tolerance < 1))
      throw Invalid_input("Newton_options: the rank tolerance must lie between 0 and 1");
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver
What `improve_point()` found.
*/
struct Newton_result
{
  std::vector<double> point;    ///< in the domain
  Newton_status status = Newton_status::ITERATION_LIMIT;
  /// the largest absolute value of an equality at the point, evaluated exactly and rounded
  double residual = 0;
  int iterations = 0;           ///< steps taken
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_RESULT_H
