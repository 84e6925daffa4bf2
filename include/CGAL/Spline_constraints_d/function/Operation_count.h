// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_OPERATION_COUNT_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_OPERATION_COUNT_H

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

How many operations an `Expression_graph` needs, or an evaluation has done. Constants and unknowns cost nothing.
*/
struct Operation_count
{
  //! sums, differences and changes of sign.
  std::size_t additions = 0;

  //! products and quotients, those with constants, too: \f$\mu\f$.
  std::size_t multiplications = 0;

  //! square roots, sines and other functions.
  std::size_t functions = 0;

  //! all of them: \f$T\f$.
  std::size_t total() const { return additions + multiplications + functions; }

  bool operator==(const Operation_count&) const = default;

  Operation_count& operator+=(const Operation_count& other)
  {
    additions += other.additions;
    multiplications += other.multiplications;
    functions += other.functions;
    return *this;
  }

  //! writes `12 operations, 5 multiplications`.
  friend std::ostream& operator<<(std::ostream& out, const Operation_count& count)
  {
    return out << count.total() << " operations, " << count.multiplications << " multiplications";
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_OPERATION_COUNT_H
