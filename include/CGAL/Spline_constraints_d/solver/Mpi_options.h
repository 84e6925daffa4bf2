// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_MPI_OPTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_MPI_OPTIONS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Options of what is dealt out to the ranks of MPI, to be used with designated initialisers. All ranks give the same ones.
*/
struct Mpi_options
{
  //! of each system; limits count for each alone. The visitor is that of rank 0 and watches all of the work: it is told
  //! the share of the systems that are done, and when it says so, all ranks stop.
  Solver_options solver = {};

  //! seconds without a sign of life after which the tasks of a rank are dealt out again. A rank gives one whenever its
  //! solver asks the visitor; one that was only busy goes on, and the first result of a task counts.
  double silence = 10;

  //! a file of rank 0 to which results are appended as they come; empty: none. When it is there, what it holds is not
  //! computed again, so that a run that was ended goes on where it was.
  std::string journal = {};

  //! \throws Invalid_input when a value makes no sense.
  void check() const
  {
    solver.check();
    if (!(silence > 0))
      throw Invalid_input("Mpi_options: the seconds of silence must be positive");
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver

How the work was shared by the ranks of MPI. Rank 0 knows all of it, the others what they did themselves, and `lost`.
*/
struct Mpi_report
{
  std::vector<std::size_t> tasks = {};   ///< done by each rank
  std::vector<double> busy_seconds = {}; ///< processor time of each rank for its tasks, and between them
  double seconds = 0;                    ///< on the wall, for all of it
  std::size_t repeated = 0;              ///< tasks that were dealt out again
  std::size_t from_journal = 0;          ///< results that were there before
  std::vector<int> lost = {};            ///< the ranks that did not answer at the end
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_MPI_OPTIONS_H
