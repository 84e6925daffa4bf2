// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions between curves, for all kernels.
// The solvers, and what other sources of the library have, are declared alone.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/regions/internal/region_boundaries.h>
