// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors, alpha-sectors and envelopes of two curves, and of one.
// What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/loci/internal/pair_loci.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/self_bisector.h>
