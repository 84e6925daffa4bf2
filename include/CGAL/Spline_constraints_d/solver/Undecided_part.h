// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_UNDECIDED_PART_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_UNDECIDED_PART_H

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

A part of an answer that is not decided, in all results of the package: where it is, and why.
*/
struct Undecided_part
{
  //! a closed range of numbers; one number where both ends are equal.
  using Range = std::pair<double, double>;

  //! A part of an operand.
  struct Parameters
  {
    std::size_t operand;         ///< its index in the order of the input
    std::vector<Range> ranges;   ///< a range for each of its parameters
  };

  //! a box in the space of the answer that holds what is not decided, with a range for each coordinate; of a system,
  //! in the space of its unknowns. Empty where no box is known.
  std::vector<Range> place;

  //! the parts of the operands that it comes from; empty where they are not known, and of systems.
  std::vector<Parameters> parameters;

  //! why it is not decided, in words.
  std::string reason;
};

namespace internal {

inline void write_ranges(std::ostream& out, const std::vector<Undecided_part::Range>& ranges)
{
  for (std::size_t j = 0; j < ranges.size(); ++j)
    out << (j == 0 ? "" : " x ") << '[' << ranges[j].first << ',' << ranges[j].second << ']';
}

} // namespace internal

//! \ingroup PkgSplineConstraintsDSolver
//! writes one line.
inline std::ostream& operator<<(std::ostream& out, const Undecided_part& part)
{
  out << "undecided (" << part.reason << ')';
  if (!part.place.empty())
    internal::write_ranges(out << " in ", part.place);
  for (const Undecided_part::Parameters& operand : part.parameters)
    internal::write_ranges(out << ", operand " << operand.operand << (operand.ranges.empty() ? "" : " at "),
                           operand.ranges);
  return out;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_UNDECIDED_PART_H
