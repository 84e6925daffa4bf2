// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Implicit patches, and smooth surfaces that consist of them. What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_of_function.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_of_patch.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/dominant_coefficients.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/mesh_of_surface.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/places_in_surface.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_of.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/vertex_gradients.h>
