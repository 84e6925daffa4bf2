// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_PRECISION_SCOPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_PRECISION_SCOPE_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

Sets `Mpfr_interval::default_precision()` of the calling thread for its own lifetime and puts back the former one,
also when an exception
leaves the scope. Scopes nest. A task that is handed to another thread makes its own scope.
*/
class Mpfr_precision_scope
{
public:
  /*!
  \param bits the precision that default-constructed and converted `Mpfr_interval`s of this thread get from now on.

  \throws Invalid_input as `Mpfr_interval::set_default_precision()` does; the precision is then unchanged.
  */
  explicit Mpfr_precision_scope(mpfr_prec_t bits) : m_former(Mpfr_interval::default_precision())
  {
    Mpfr_interval::set_default_precision(bits);
  }

  Mpfr_precision_scope(const Mpfr_precision_scope&) = delete;
  Mpfr_precision_scope& operator=(const Mpfr_precision_scope&) = delete;

  ~Mpfr_precision_scope() { Mpfr_interval::set_default_precision(m_former); }

private:
  mpfr_prec_t m_former;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPFR_PRECISION_SCOPE_H
