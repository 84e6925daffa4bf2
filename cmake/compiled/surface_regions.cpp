// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions on surfaces, meshes, and pictures of meshes. What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/IO/internal/scene/Scene_painter.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/trimmed_sphere_bisector.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Cell_triangulation.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Overlap_finder.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Ray_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Shared_edges_of_cells.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_by_zeros.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/mesh_of_solutions.h>
