// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is seen from a point, and from where all is seen, for all kernels.
// The solvers, and what other sources of the library have, are declared alone.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/visibility/internal/kernel_of_region.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/sight_of_curves.h>
