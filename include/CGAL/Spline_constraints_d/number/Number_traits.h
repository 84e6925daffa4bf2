// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_H

// All specialisations in one place: whether a type has one must not depend on what else a program includes.
#include <CGAL/Spline_constraints_d/number/Number_traits_double.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_exact.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_fwd.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_interval.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_mpfr.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_H
