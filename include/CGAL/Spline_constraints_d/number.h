// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_H

// All of the floor of numbers: number types, their traits, enclosures, the rounding guard.
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>
#include <CGAL/Spline_constraints_d/number/Double_word.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_number.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_double.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_exact.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_fwd.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_interval.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_mpfr.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/Short_integer.h>
#include <CGAL/Spline_constraints_d/number/concepts.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/fixed_point.h>
#include <CGAL/Spline_constraints_d/number/mpq_access.h>
#include <CGAL/Spline_constraints_d/number/near_fraction.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>
#include <CGAL/Spline_constraints_d/number/two_words.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_H
