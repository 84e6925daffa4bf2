// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_EXACT_RATIONAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_EXACT_RATIONAL_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Fraction_traits.h>

namespace CGAL {
namespace Spline_constraints {

//! the exact number type of the package: whichever type `CGAL::Exact_rational` is under the build flags in use.
using Exact_rational = CGAL::Exact_rational;

//! the type of the numerators and denominators of `Exact_rational`.
using Exact_integer = CGAL::Fraction_traits<Exact_rational>::Numerator_type;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_EXACT_RATIONAL_H
