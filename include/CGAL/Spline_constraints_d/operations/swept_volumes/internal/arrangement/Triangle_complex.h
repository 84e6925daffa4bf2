// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_TRIANGLE_COMPLEX_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_TRIANGLE_COMPLEX_H

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

using Double_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

using Corners = std::array<std::size_t, 3>;

// Triangles that may cross each other. Those that share a vertex have its index in common.
struct Triangle_soup
{
  std::vector<Double_kernel::Point_3> points;
  std::vector<Corners> triangles;
};

// Triangles that only share vertices and edges. A triangle that lies in several ones of a soup is there once.
struct Triangle_complex
{
  std::vector<Exact_kernel::Point_3> points; // those of the soup come first
  std::vector<Corners> triangles;
  std::vector<int> multiplicity;   // how many of the soup it is a part of
  std::vector<std::size_t> planes; // the same for triangles that are known to lie in one plane
};

inline Double_kernel::Point_3 rounded(const Exact_kernel::Point_3& point)
{
  return {CGAL::to_double(point.x()), CGAL::to_double(point.y()), CGAL::to_double(point.z())};
}

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_TRIANGLE_COMPLEX_H
