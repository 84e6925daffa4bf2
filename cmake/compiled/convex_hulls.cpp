// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Convex hulls, for all kernels.
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/hull_of_curves.h>
