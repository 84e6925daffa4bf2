// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves on surfaces, where surfaces meet themselves, and umbilics.
// What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Access_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Umbilic_finder.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/self_intersections_of_surface.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/silhouettes_of_sweep.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/zeros_on_surface.h>
