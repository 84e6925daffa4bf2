// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_OPERAND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_OPERAND_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <concepts>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

template <class Curve>
concept Parametric_curve = ParametricCurve_2<Curve> || ParametricCurve_3<Curve>;

// A point, curve or surface: how many parameters it has, in which space and kernel, and itself in exact numbers.
template <class Object>
struct Spline_operand;

template <class Object, int number_of_parameters_, int dimension_>
struct Parametric_operand
{
  using Kernel = typename Object::Kernel;
  static constexpr int number_of_parameters = number_of_parameters_, dimension = dimension_;
  static Spline_patch<dimension> patch(const Object& object) { return Spline_patch<dimension>(object); }
};

template <ParametricCurve_2 Curve>
struct Spline_operand<Curve> : Parametric_operand<Curve, 1, 2> {};

template <ParametricCurve_3 Curve>
struct Spline_operand<Curve> : Parametric_operand<Curve, 1, 3> {};

template <ParametricSurface_3 Surface>
struct Spline_operand<Surface> : Parametric_operand<Surface, 2, 3> {};

template <SplineKernel K>
struct Spline_operand<CGAL::Point_2<K>>
{
  using Kernel = K;
  static constexpr int number_of_parameters = 0, dimension = 2;

  static Spline_patch<2> patch(const CGAL::Point_2<K>& p)
  {
    const auto exact = exact_object(p);
    return Spline_patch<2>(std::array<Exact_rational, 2>{exact.x(), exact.y()});
  }
};

template <SplineKernel K>
struct Spline_operand<CGAL::Point_3<K>>
{
  using Kernel = K;
  static constexpr int number_of_parameters = 0, dimension = 3;

  static Spline_patch<3> patch(const CGAL::Point_3<K>& p)
  {
    const auto exact = exact_object(p);
    return Spline_patch<3>(std::array<Exact_rational, 3>{exact.x(), exact.y(), exact.z()});
  }
};

// Two of them in the same space and kernel.
template <class A, class B>
concept Spline_operands = Spline_operand<A>::dimension ==
    Spline_operand<B>::dimension&& std::same_as<typename Spline_operand<A>::Kernel, typename Spline_operand<B>::Kernel>;

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_SPLINE_OPERAND_H
