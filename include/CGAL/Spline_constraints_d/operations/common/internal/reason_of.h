// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_REASON_OF_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_REASON_OF_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// Why an answer is undecided, in words: the reason of the solver, or that its classification is.
inline std::string reason_of(const std::optional<Solution_d<double>>& solution)
{
  return solution && solution->reason() != Undecided_reason::NONE
      ? in_words(solution->reason())
      : "it is not told apart from an end or from others near it";
}

// The same, of an answer that several ones of the solver belong to.
inline std::string reason_of(const std::vector<Solution_d<double>>& solutions)
{
  const auto undecided = std::find_if(solutions.begin(), solutions.end(),
                                      [](const auto& x) { return x.kind() == Solution_kind::UNDECIDED; });
  return reason_of(undecided == solutions.end() ? std::nullopt : std::optional(*undecided));
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_REASON_OF_H
