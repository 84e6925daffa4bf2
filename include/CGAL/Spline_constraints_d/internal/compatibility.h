// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_COMPATIBILITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_COMPATIBILITY_H

// What the package needs of the compiler and of CGAL, and the one place for the differences between CGAL 5.5 and CGAL
// 6.

#include <CGAL/version.h>

#include <cfloat>
#include <limits>

// Every error bound and every directed rounding is void when the compiler may reorder or simplify floating-point
// arithmetic.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(_M_FP_FAST)
#error "Spline_constraints_d proves its answers and cannot be compiled with fast-math (-ffast-math, -Ofast, /fp:fast)."
#endif

#if FLT_EVAL_METHOD != 0
#error "Spline_constraints_d needs double arithmetic without excess precision: on x87, -msse2 -mfpmath=sse."
#endif

// Functions that the compiled library has are inline, where it is not used; in its own sources they are emitted.
#ifdef CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY
#define CGAL_SPLINE_CONSTRAINTS_INLINE [[gnu::used]] inline
#else
#define CGAL_SPLINE_CONSTRAINTS_INLINE inline
#endif

// Bodies out of line in the headers of operations are in one source of the library.
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#define CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
#endif

#if CGAL_VERSION_NR < 1050511000
#error "Spline_constraints_d needs CGAL 5.5.1 or newer."
#endif

static_assert(std::numeric_limits<double>::is_iec559 && std::numeric_limits<double>::digits == 53,
              "Spline_constraints_d needs IEEE 754 double precision.");

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_COMPATIBILITY_H
