// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Approximate polygons. What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/cells_of_signatures.h>
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/internal/polygons_of_bands.h>
