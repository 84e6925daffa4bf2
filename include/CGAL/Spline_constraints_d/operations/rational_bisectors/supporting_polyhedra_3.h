// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_SUPPORTING_POLYHEDRA_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_SUPPORTING_POLYHEDRA_3_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Convex_hull_3/dual/halfspace_intersection_3.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

a convex polyhedron that has all points which are not nearer to a surface than to a point: the intersection of the
half-spaces on the side of the point of the planes in the middle between the point and samples of the surface, and of a
cube. The trimmed bisector of the point and the surface is within it, up to the cube; more samples make it smaller.

\tparam Kernel a `SplineKernel`.
\param point the point.
\param surface the surface.
\param samples the number of samples in each parameter, between its ends, which are two of them; at least 2.
\param half_width half of the width of the cube around the point.
\return the polyhedron, with exact vertices.
\throws Invalid_input when there are less than two samples, the half width is not positive, a sample is the point
itself (the message has its parameters), a weight is not proved to have one sign, or a number is not finite.

Complexity: \f$O(n \log n)\f$ for \f$n\f$ planes. Source: \cgalCite{ek-crb-99}, which trims bisectors by such
polyhedra.
*/
template <SplineKernel Kernel>
CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>
supporting_polyhedron(const CGAL::Point_3<Kernel>& point, const Bspline_surface_3<Kernel>& surface, int samples,
                      const typename Kernel::FT& half_width)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point = Exact::Point_3;
  if (samples < 2)
    throw Invalid_input("supporting_polyhedron: " + std::to_string(samples) + " samples instead of two or more");
  const auto width = internal::converted_number<Exact_rational>(half_width);
  if (!(width > 0))
    throw Invalid_input("supporting_polyhedron: the half width of the cube is not positive");
  const auto converted = [](const auto& p) { return Point(Exact::FT(p.x()), Exact::FT(p.y()), Exact::FT(p.z())); };
  const Bspline_surface_3<internal::Exact_kernel> exact(surface);
  const Point center = converted(internal::exact_object(point));
  std::vector<Exact::Plane_3> planes;
  for (const int axis : {0, 1, 2})
    for (const int side : {-1, 1}) {
      std::array<Exact::FT, 3> normal{0, 0, 0};
      normal[static_cast<std::size_t>(axis)] = side;
      const Exact::Vector_3 n(normal[0], normal[1], normal[2]);
      planes.emplace_back(center + n * Exact::FT(width), n);
    }
  const auto parameter = [&](int axis, int k) {
    const auto [begin, end] = exact.domain(axis);
    return Exact_rational(begin + (end - begin) * k / (samples - 1));
  };
  for (int i = 0; i < samples; ++i)
    for (int j = 0; j < samples; ++j) {
      const Point sample = converted(exact(parameter(0, i), parameter(1, j)));
      if (sample == center)
        throw Invalid_input("supporting_polyhedron: the point is that of the surface at the parameters " +
                            std::to_string(CGAL::to_double(parameter(0, i))) + ", " +
                            std::to_string(CGAL::to_double(parameter(1, j))));
      planes.emplace_back(CGAL::midpoint(center, sample), sample - center);
    }
  CGAL::Surface_mesh<Point> result;
  CGAL::halfspace_intersection_3(planes.begin(), planes.end(), result, center);
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_SUPPORTING_POLYHEDRA_3_H
