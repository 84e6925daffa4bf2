// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SMOOTH_SURFACE_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SMOOTH_SURFACE_FINDERS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_hit.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Surface_data.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

// Defined in smooth_surface_of.h, places_in_surface.h and mesh_of_surface.h; the compiled library has them.
std::shared_ptr<const Surface_data> smooth_surface_of(Oriented_mesh mesh, const Smooth_surface_shape& shape,
                                                      const Solver_options& options);

std::vector<Exact_kernel::Vector_3> balanced_gradients(Oriented_mesh mesh);
std::vector<Exact_kernel::Vector_3> estimated_normals(Oriented_mesh mesh);

// The first patch with the point, if there is one.
std::optional<std::size_t> patch_at(const Surface_data& data, const Exact_kernel::Point_3& point);

// Whether a point of no patch is beyond the inner side of the neighbourhood.
bool is_inside(const Surface_data& data, const Exact_kernel::Point_3& point);

// The zeros of the function on the line through two points with parameters in a range, see Smooth_surface_hit; without
// an end the range goes on.
std::vector<Smooth_surface_hit> hits_on_line(const Surface_data& data, const Exact_kernel::Point_3& source,
                                             const Exact_kernel::Point_3& target, bool is_ray);

Smooth_surface_mesh_3 mesh_of_surface(const Surface_data& data, const Smooth_surface_fineness& fineness,
                                      const Solver_options& options);

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SMOOTH_SURFACE_FINDERS_H
