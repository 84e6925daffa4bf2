// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_BSPLINE_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_BSPLINE_SURFACE_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <class FT>
Exact_kernel::Vector_3 vector_of_squared_length_3(const FT& squared_length, const std::string& who)
{
  check_positive(squared_length, who + ": the squared radius");
  if constexpr (std::is_floating_point_v<FT>)
    return {Exact_rational(0), Exact_rational(0), to_rational(std::sqrt(static_cast<double>(squared_length)))};
  else {
    const auto sum = sum_of_three_squares(converted_number<Exact_rational>(squared_length));
    if (!sum.roots)
      throw_without_rational_point(who, sum.is_complete);
    return {(*sum.roots)[0], (*sum.roots)[1], (*sum.roots)[2]};
  }
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the triangle \f$(1-u) p_0 + u\,((1-v) p_1 + v p_2)\f$ over \f$[0,1]^2\f$: a patch whose side \f$u = 0\f$ is the first
vertex, where the parametrisation is singular. Exact in every kernel.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> to_bspline_surface(const CGAL::Triangle_3<Kernel>& triangle)
{
  return bilinear_surface<Kernel>(triangle.vertex(0), triangle.vertex(0), triangle.vertex(1), triangle.vertex(2));
}

/*!
the sphere, with normals outwards where its orientation is counterclockwise, inwards otherwise; see `sphere_surface()`.
A sphere with rational center and squared radius is a rational surface over the rational numbers exactly if it has a
rational point. One is looked for, to be a pole; kernels of doubles round the radius instead.
\throws Invalid_input when the squared radius is not positive, or there is no rational point, or none is found: the
message says which.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> to_bspline_surface(const CGAL::Sphere_3<Kernel>& sphere)
{
  const auto pole = internal::vector_of_squared_length_3(sphere.squared_radius(), "to_bspline_surface: the sphere");
  const Bspline_surface_3<Kernel> surface(internal::sphere(internal::exact_object(sphere.center()), pole));
  return internal::orientation_of(sphere) == CGAL::CLOCKWISE ? surface.reversed(0) : surface;
}

/*!
the part of the plane above and below a face of the cuboid, which holds all points that the plane has in the cuboid: a
parallelogram over the ranges of two coordinates. They are the ones, in cyclic order, that follow the coordinate in
which the normal of the plane is longest; where it points to the negative side they change places, so that the normals
of the patch point the same way. Exact where the kernel is.
\throws Invalid_input when the plane is degenerate, or a number is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> to_bspline_surface(const CGAL::Plane_3<Kernel>& plane,
                                             const CGAL::Iso_cuboid_3<Kernel>& cuboid)
{
  using internal::converted_number;
  const std::array<Exact_rational, 4> h{
      converted_number<Exact_rational>(plane.a()), converted_number<Exact_rational>(plane.b()),
      converted_number<Exact_rational>(plane.c()), converted_number<Exact_rational>(plane.d())};
  int k = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (CGAL::abs(h[k]) < CGAL::abs(h[axis]))
      k = axis;
  if (h[k] == 0)
    throw Invalid_input("to_bspline_surface: the plane is degenerate");
  const int i = (k + 1) % 3, j = (k + 2) % 3;
  const auto low = internal::exact_object((cuboid.min)()), high = internal::exact_object((cuboid.max)());
  const auto corner = [&](bool second_i, bool second_j) {
    std::array<Exact_rational, 3> x;
    x[i] = second_i ? high.cartesian(i) : low.cartesian(i);
    x[j] = second_j ? high.cartesian(j) : low.cartesian(j);
    x[k] = -(h[3] + h[i] * x[i] + h[j] * x[j]) / h[k];
    return internal::Exact_kernel::Point_3(x[0], x[1], x[2]);
  };
  const auto patch =
      bilinear_surface(corner(false, false), corner(false, true), corner(true, false), corner(true, true));
  return Bspline_surface_3<Kernel>(h[k] < 0 ? patch.transposed() : patch);
}

//! the B-spline form of another model of the concept, in its kernel. Exact where the kernel is.
template <ParametricSurface_3 Surface>
Bspline_surface_3<typename Surface::Kernel> to_bspline_surface(const Surface& surface)
{
  return Bspline_surface_3<typename Surface::Kernel>(
      internal::Exact_surface::from_homogeneous_coordinates(surface.homogeneous_coordinates(), surface.weight()));
}

/*!
the six faces of the cuboid, as rectangles over \f$[0,1]^2\f$ with normals outwards: those with the least and the
greatest \f$x\f$, then \f$y\f$, then \f$z\f$. Exact in every kernel.
*/
template <SplineKernel Kernel>
std::array<Bspline_surface_3<Kernel>, 6> to_bspline_surfaces(const CGAL::Iso_cuboid_3<Kernel>& cuboid)
{
  const std::array<typename Kernel::FT, 3> low{cuboid.xmin(), cuboid.ymin(), cuboid.zmin()},
      high{cuboid.xmax(), cuboid.ymax(), cuboid.zmax()};
  const auto face = [&](int axis, bool is_greatest) {
    // The corner with these choices along the two axes that follow.
    const auto corner = [&](bool second, bool third) {
      std::array<typename Kernel::FT, 3> x = low;
      x[axis] = is_greatest ? high[axis] : low[axis];
      x[(axis + 1) % 3] = second ? high[(axis + 1) % 3] : low[(axis + 1) % 3];
      x[(axis + 2) % 3] = third ? high[(axis + 2) % 3] : low[(axis + 2) % 3];
      return CGAL::Point_3<Kernel>(x[0], x[1], x[2]);
    };
    return is_greatest
        ? bilinear_surface<Kernel>(corner(false, false), corner(false, true), corner(true, false), corner(true, true))
        : bilinear_surface<Kernel>(corner(false, false), corner(true, false), corner(false, true), corner(true, true));
  };
  return {face(0, false), face(0, true), face(1, false), face(1, true), face(2, false), face(2, true)};
}

//! the four faces of the tetrahedron, face \f$i\f$ opposite to vertex \f$i\f$, with normals outwards; see the
//! conversion of triangles. Exact in every kernel.
//! \throws Invalid_input when the tetrahedron is flat.
template <SplineKernel Kernel>
std::array<Bspline_surface_3<Kernel>, 4> to_bspline_surfaces(const CGAL::Tetrahedron_3<Kernel>& tetrahedron)
{
  if (tetrahedron.is_degenerate())
    throw Invalid_input("to_bspline_surfaces: the tetrahedron is flat");
  const auto face = [&](int i) {
    std::array<int, 3> others{(i + 1) % 4, (i + 2) % 4, (i + 3) % 4};
    if ((i % 2 == 0) != (tetrahedron.orientation() == CGAL::POSITIVE))
      std::swap(others[1], others[2]);
    return to_bspline_surface(CGAL::Triangle_3<Kernel>(tetrahedron.vertex(others[0]), tetrahedron.vertex(others[1]),
                                                       tetrahedron.vertex(others[2])));
  };
  return {face(0), face(1), face(2), face(3)};
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_BSPLINE_SURFACE_H
