// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_ROUNDING_GUARD_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_ROUNDING_GUARD_H

#include <CGAL/FPU.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

Sets the rounding mode of the calling thread to upward for its own lifetime and puts back whatever mode it found, also
when an
exception leaves the scope. Guards nest. `CGAL::Interval_nt<false>` encloses only while one of these is alive.

Setting the mode costs some ten cycles, so there is one guard per API call and task, never one per operation. The mode
belongs to the
thread: a task that is handed to another thread makes its own guard.
*/
class Upward_rounding_guard
{
public:
  //! saves the mode of the calling thread and sets it to upward.
  Upward_rounding_guard() : m_protection(CGAL_FE_UPWARD) {}

  Upward_rounding_guard(const Upward_rounding_guard&) = delete;
  Upward_rounding_guard& operator=(const Upward_rounding_guard&) = delete;

private:
  CGAL::Protect_FPU_rounding<true> m_protection;
};

/*!
\ingroup PkgSplineConstraintsDNumbers

The guard of the number types whose operations do not depend on the rounding mode of the thread, or whose error bound
holds in every mode.
*/
class Empty_rounding_guard
{
public:
  // Written out, so that a guard that is declared and not mentioned again is no "unused variable" to a compiler.
  Empty_rounding_guard() {}

  Empty_rounding_guard(const Empty_rounding_guard&) = delete;
  Empty_rounding_guard& operator=(const Empty_rounding_guard&) = delete;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_ROUNDING_GUARD_H
