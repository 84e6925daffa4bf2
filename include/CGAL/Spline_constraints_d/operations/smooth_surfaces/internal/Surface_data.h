// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SURFACE_DATA_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SURFACE_DATA_H

#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Patch_certificate.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Neighborhood.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Oriented_mesh.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Patch_coefficients.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/separated_simplices.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

using Interval_point = std::array<Interval, 3>;

// What a smooth surface consists of. Forms and certificates are in the order of the tetrahedra.
struct Surface_data
{
  Oriented_mesh mesh;
  Neighborhood neighborhood;
  std::vector<Interval_point> places; // of its nodes
  std::vector<Form> forms;
  std::vector<Patch_certificate> certificates;
  std::size_t coefficient_count = 0;
  std::vector<Undecided_part> undecided;
  Summary summary;

  Simplex_vertices<3> vertices(std::size_t patch) const
  {
    const auto& nodes = neighborhood.patches[patch].nodes;
    const auto& points = neighborhood.points;
    return coordinates_of({&points[nodes[0]], &points[nodes[1]], &points[nodes[2]], &points[nodes[3]]});
  }
};

inline Interval_point enclosure_of(const Exact_kernel::Point_3& p)
{
  using Traits = Number_traits<Interval>;
  return {Traits::from_rational(p.x()), Traits::from_rational(p.y()), Traits::from_rational(p.z())};
}

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_SURFACE_DATA_H
