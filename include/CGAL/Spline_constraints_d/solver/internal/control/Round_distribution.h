// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_ROUND_DISTRIBUTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_ROUND_DISTRIBUTION_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Other processes that solve the same system at the same time, in step: the tasks of one round are dealt out to them, and
each gets the results of all. What is between the rounds, each does for itself.
*/
class Round_distribution
{
public:
  virtual ~Round_distribution() = default;

  // The results of run(0), ..., run(count - 1), whoever called it. Run here, and at once, when `must_stop()` says so.
  virtual std::vector<std::string> results_of_round(std::size_t count,
                                                    const std::function<std::string(std::size_t)>& run,
                                                    const std::function<bool()>& must_stop) = 0;
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_ROUND_DISTRIBUTION_H
