// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operand_map.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Plane_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Sphere_3.h>

#include <array>
#include <concepts>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {

template <int d>
class Implicit_hypersurface;

namespace internal {
namespace Intersections {

// A surface in exact numbers, complete in Surface_shape.h.
struct Surface_shape;
using Shape = std::shared_ptr<const Surface_shape>;

// Defined in Surface_shape.h. \throws Invalid_input when a weight is not proved to have one sign, or a surface is
// degenerate.
Shape shape_of_map(const Common::Exact_map<3>& surface);
Shape shape_of_plane(const std::array<Exact_rational, 4>& coefficients);
Shape shape_of_sphere(const std::array<Exact_rational, 3>& center, const Exact_rational& squared_radius);
Shape shape_of_implicit_surface(const Implicit_hypersurface<3>& surface);

template <std::same_as<Implicit_hypersurface<3>> Surface>
Shape surface_shape(const Surface& surface)
{
  return shape_of_implicit_surface(surface);
}

template <SplineKernel K>
Shape surface_shape(const CGAL::Sphere_3<K>& sphere)
{
  const auto center = exact_object(sphere.center());
  return shape_of_sphere({center.x(), center.y(), center.z()},
                         converted_number<Exact_rational>(sphere.squared_radius()));
}

//! \throws Invalid_input when the plane is degenerate, or a number is not finite.
template <SplineKernel K>
Shape surface_shape(const CGAL::Plane_3<K>& plane)
{
  const auto number = [](const auto& x) { return converted_number<Exact_rational>(x); };
  return shape_of_plane({number(plane.a()), number(plane.b()), number(plane.c()), number(plane.d())});
}

template <class Surface>
requires(Intersection_operand<Surface>::number_of_parameters == 2 &&
         Intersection_operand<Surface>::dimension == 3) Shape surface_shape(const Surface& surface)
{
  return shape_of_map(Intersection_operand<Surface>::map(surface));
}

// The kernel of a surface; implicit ones leave it to the other operand.
template <class Surface>
struct Surface_kernel
{
  using type = typename Intersection_operand<Surface>::Kernel;
};

template <>
struct Surface_kernel<Implicit_hypersurface<3>>
{
  using type = void;
};

template <SplineKernel K>
struct Surface_kernel<CGAL::Plane_3<K>>
{
  using type = K;
};

template <class A, class B, class Kernel_a = typename Surface_kernel<A>::type,
          class Kernel_b = typename Surface_kernel<B>::type>
using Common_surface_kernel =
    std::conditional_t<!std::same_as<Kernel_a, void>, Kernel_a,
                       std::conditional_t<!std::same_as<Kernel_b, void>, Kernel_b, CGAL::Simple_cartesian<double>>>;

template <class Surface>
inline constexpr bool is_unbounded_surface = false;

template <class K>
inline constexpr bool is_unbounded_surface<CGAL::Plane_3<K>> = true;

// Two surfaces, not both unbounded, without different kernels.
template <class A, class B>
concept Surface_pair = requires(const A& a, const B& b)
{
  surface_shape(a);
  surface_shape(b);
}
&&!(is_unbounded_surface<A> &&
    is_unbounded_surface<B>)&&std::same_as<Common_surface_kernel<A, B>, Common_surface_kernel<B, A>>;

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPES_H
