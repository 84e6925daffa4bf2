// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_ACCESS_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_ACCESS_REGIONS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Access.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/exact_triples.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_regions {

struct Exact_sphere
{
  Exact_triple center;
  Exact_rational squared_radius;
};

using Exact_triangle = std::array<Exact_triple, 3>;

// What may be in the way.
struct Exact_obstacles
{
  std::vector<Exact_sphere> spheres;
  std::vector<Exact_triangle> triangles = {};
  std::vector<Exact_map<3>> surfaces = {};
};

// Rays from the points of a surface: along the axis of a tool, or towards an eye, where they end.
struct Sight
{
  Exact_tool_axis axis;
  std::optional<Exact_triple> eye = {};
  bool is_own_shadow_seen = false; // whether the surface itself is in the way
};

// \throws Invalid_input when one is degenerate.
template <class Spheres>
std::vector<Exact_sphere> exact_spheres(const Spheres& spheres, const std::string& operation)
{
  std::vector<Exact_sphere> result;
  for (const auto& sphere : spheres) {
    if (!(sphere.squared_radius() > 0))
      throw Invalid_input(operation + ": sphere " + std::to_string(result.size()) + " is degenerate");
    result.push_back(
        {exact_triple(sphere.center()), internal::converted_number<Exact_rational>(sphere.squared_radius())});
  }
  return result;
}

// \throws Invalid_input when one is degenerate.
template <class Triangles>
std::vector<Exact_triangle> exact_triangles(const Triangles& triangles, const std::string& operation)
{
  std::vector<Exact_triangle> result;
  for (const auto& triangle : triangles) {
    result.push_back({exact_triple(triangle[0]), exact_triple(triangle[1]), exact_triple(triangle[2])});
    const auto& [p, q, r] = result.back();
    const Exact_triple normal = cross(difference(q, p), difference(r, p));
    if (dot(normal, normal) == 0)
      throw Invalid_input(operation + ": triangle " + std::to_string(result.size() - 1) + " is degenerate");
  }
  return result;
}

template <class Surfaces>
std::vector<Exact_map<3>> exact_surfaces(const Surfaces& surfaces)
{
  std::vector<Exact_map<3>> result;
  for (const auto& surface : surfaces)
    result.push_back(exact_map<3>(surface));
  return result;
}

// Defined in Ray_regions.h.
Trimmed_surface_3 ray_regions(const Exact_map<3>& surface, const Exact_obstacles& obstacles, const Sight& sight,
                              const Solver_options& options);

} // namespace Surface_regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_INTERNAL_ACCESS_REGIONS_H
