// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_OPERAND_MAP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_OPERAND_MAP_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_surface.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <concepts>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

template <int d>
class Spline_patch;

template <int d>
auto patch_of(const Exact_map<d>& map)
{
  return Spline_patch<d>(map);
}

template <class Curve>
concept Parametric_curve = ParametricCurve_2<Curve> || ParametricCurve_3<Curve>;

// How an operation takes a spline or a point: as a map in exact numbers, or as a patch.
template <class Object>
struct Spline_operand;

template <class Object, int number_of_parameters_, int dimension_>
struct Parametric_operand
{
  using Kernel = typename Object::Kernel;
  static constexpr int number_of_parameters = number_of_parameters_, dimension = dimension_;
  static Exact_map<dimension> map(const Object& object) { return exact_map<dimension>(object); }
  static auto patch(const Object& object) { return patch_of(map(object)); }
};

template <ParametricCurve_2 Curve>
struct Spline_operand<Curve> : Parametric_operand<Curve, 1, 2>
{};

template <ParametricCurve_3 Curve>
struct Spline_operand<Curve> : Parametric_operand<Curve, 1, 3>
{};

template <ParametricSurface_3 Surface>
struct Spline_operand<Surface> : Parametric_operand<Surface, 2, 3>
{};

template <SplineKernel K>
struct Spline_operand<CGAL::Point_2<K>>
{
  using Kernel = K;
  static constexpr int number_of_parameters = 0, dimension = 2;

  static Exact_map<2> map(const CGAL::Point_2<K>& p)
  {
    const auto exact = exact_object(p);
    return exact_map<2>(std::array<Exact_rational, 2>{exact.x(), exact.y()});
  }
  static auto patch(const CGAL::Point_2<K>& p) { return patch_of(map(p)); }
};

template <SplineKernel K>
struct Spline_operand<CGAL::Point_3<K>>
{
  using Kernel = K;
  static constexpr int number_of_parameters = 0, dimension = 3;

  static Exact_map<3> map(const CGAL::Point_3<K>& p)
  {
    const auto exact = exact_object(p);
    return exact_map<3>(std::array<Exact_rational, 3>{exact.x(), exact.y(), exact.z()});
  }
  static auto patch(const CGAL::Point_3<K>& p) { return patch_of(map(p)); }
};

// Two operands in the same space, with the same kernel.
template <class A, class B>
concept Spline_operands = Spline_operand<A>::dimension ==
    Spline_operand<B>::dimension&& std::same_as<typename Spline_operand<A>::Kernel, typename Spline_operand<B>::Kernel>;

// An object of CGAL that is converted to a surface, or to a curve.
template <class Object>
requires requires(const Object& object) { to_bspline_surface(object); }
auto to_bspline(const Object& object) { return to_bspline_surface(object); }

template <class Object>
requires(!requires(const Object& object) { to_bspline_surface(object); }) && requires(const Object& object)
{
  to_bspline_curve(object);
}
auto to_bspline(const Object& object) { return to_bspline_curve(object); }

// How an operation takes an object: as a spline, or as what is converted to one. Unbounded ones have a conversion of
// their own, to the part of them in a box.
template <class Object>
struct Intersection_operand;

template <class Object>
requires requires { Spline_operand<Object>::dimension; }
struct Intersection_operand<Object> : Spline_operand<Object>
{
  static constexpr bool is_bounded = true;
};

template <class Object>
requires(!requires { Spline_operand<Object>::dimension; }) && requires(const Object& object) { to_bspline(object); }
struct Intersection_operand<Object> : Spline_operand<decltype(to_bspline(std::declval<const Object&>()))>
{
private:
  using Spline = Spline_operand<decltype(to_bspline(std::declval<const Object&>()))>;

public:
  static constexpr bool is_bounded = true;
  static auto map(const Object& object) { return Spline::map(to_bspline(object)); }
  static auto patch(const Object& object) { return Spline::patch(to_bspline(object)); }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_OPERAND_MAP_H
