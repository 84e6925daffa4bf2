// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPE_H

#include <CGAL/Spline_constraints_d/function/internal/Values_at_point.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// A surface, parametric or implicit, in exact numbers.
struct Surface_shape
{
  std::optional<Spline_patch<3>> patch;   // the parametric one
  std::array<Bspline_function<double>, 4> rounded = {};   // its numerators and weight

  Power_polynomial polynomial = {};               // the implicit one
  std::optional<Vector_bounds<3>> box = {};       // has all of it; none: it is unbounded
  bool ends_at_box = false;                       // or it may go on beyond the box

  explicit Surface_shape(Spline_patch<3> surface) : patch(std::move(surface))
  {
    const auto to_double = [](const Exact_function& f) {
      return f.converted<double>([](const Exact_rational& x) { return to_nearest_double(x); });
    };
    for (int i = 0; i < 3; ++i)
      rounded[i] = to_double(patch->numerators()[i]);
    rounded[3] = to_double(patch->weight());
  }

  explicit Surface_shape(Power_polynomial f) : polynomial(std::move(f)) {}

  Surface_shape(const Implicit_surface_3& surface, bool ends)
    : polynomial(surface.polynomial()), box(Vector_bounds<3>()), ends_at_box(ends)
  {
    for (int i = 0; i < 3; ++i)
      (*box)[i] = Rational_interval(surface.box()[i]);
  }

  // A box that has all points; none of an unbounded surface.
  std::optional<Vector_bounds<3>> bounds() const
  {
    return !patch ? box : is_in_hull() ? hull_of_control_points() : patch->values();
  }

  // Whether its zeros in other bounds are not all points of the surface.
  bool ends_within(const Vector_bounds<3>& other) const
  {
    for (int i = 0; ends_at_box && i < 3; ++i)
      if (other[i].lower < (*box)[i].lower || (*box)[i].upper < other[i].upper)
        return true;
    return false;
  }

  // \pre It is parametric.
  std::array<Exact_rational, 3> point(const std::vector<Exact_rational>& parameters) const
  {
    return (*patch)(parameters);
  }

  std::array<double, 3> point(std::vector<double> parameters) const
  {
    for (int axis = 0; axis < 2; ++axis) {   // rounding may lead out of the domain
      const auto [begin, end] = rounded[0].domain(axis);
      parameters[axis] = (std::min)((std::max)(parameters[axis], begin), end);
    }
    const Values_at_point<double> value(rounded[0], parameters);
    const double weight = patch->is_rational() ? value(rounded[3]) : 1;
    return {value(rounded[0]) / weight, value(rounded[1]) / weight, value(rounded[2]) / weight};
  }

private:
  // Whether all control weights are positive.
  bool is_in_hull() const { return patch->is_rational() && patch->weight().bounds().first > 0; }

  Vector_bounds<3> hull_of_control_points() const
  {
    const std::vector<Exact_rational>& weights = patch->weight().coefficients();
    Vector_bounds<3> result;
    for (int i = 0; i < 3; ++i) {
      std::vector<Exact_rational> coordinates;
      for (std::size_t k = 0; k < weights.size(); ++k)
        coordinates.emplace_back(patch->numerators()[i].coefficients()[k] / weights[k]);
      result[i] = Rational_interval(least_and_greatest(coordinates));
    }
    return result;
  }
};

inline Surface_shape surface_shape(const Implicit_surface_3& surface) { return Surface_shape(surface, true); }

template <SplineKernel K>
Surface_shape surface_shape(const CGAL::Sphere_3<K>& sphere)
{
  return Surface_shape(to_implicit(sphere), false);
}

//! \throws Invalid_input when the plane is degenerate, or a number is not finite.
template <SplineKernel K>
Surface_shape surface_shape(const CGAL::Plane_3<K>& plane)
{
  const auto number = [](const auto& x) { return converted_number<Exact_rational>(x); };
  Power_polynomial f =
      linear_polynomial<4>({number(plane.a()), number(plane.b()), number(plane.c()), number(plane.d())});
  if (f.is_constant())
    throw Invalid_input("intersection_curves: the plane is degenerate");
  return Surface_shape(std::move(f));
}

template <class Surface>
  requires (Intersection_operand<Surface>::number_of_parameters == 2 && Intersection_operand<Surface>::dimension == 3)
Surface_shape surface_shape(const Surface& surface)
{
  return Surface_shape(Intersection_operand<Surface>::patch(surface));
}

// The kernel of a surface; implicit ones leave it to the other operand.
template <class Surface>
struct Surface_kernel
{
  using type = typename Intersection_operand<Surface>::Kernel;
};

template <>
struct Surface_kernel<Implicit_surface_3>
{
  using type = void;
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
concept Surface_pair = requires(const A& a, const B& b) {
  surface_shape(a);
  surface_shape(b);
}
&&!(is_unbounded_surface<A> &&
    is_unbounded_surface<B>)&&std::same_as<Common_surface_kernel<A, B>, Common_surface_kernel<B, A>>;

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_SHAPE_H
