// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTERSECTION_OPERAND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTERSECTION_OPERAND_H

#include <CGAL/Spline_constraints_d/geometry/curves/clipped_lines.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_operand.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <concepts>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The corners of a box that has all points of another one inside.
template <int d>
auto larger_box(const Vector_bounds<d>& box)
{
  Exact_rational margin(1);
  for (const Rational_interval& range : box)
    margin += Exact_rational(range.upper - range.lower);
  std::array<Exact_rational, d> low, high;
  for (int i = 0; i < d; ++i) {
    low[i] = Exact_rational(box[i].lower - margin);
    high[i] = Exact_rational(box[i].upper + margin);
  }
  using Point = typename Ambient_space<Exact_kernel, d>::Point;
  return std::array<Point, 2>{kernel_object<Exact_kernel, Point>(low), kernel_object<Exact_kernel, Point>(high)};
}

template <int d>
std::optional<Spline_patch<d>> line_patch(const auto& line, const Vector_bounds<d>& box)
{
  const auto [low, high] = larger_box<d>(box);
  const auto range = range_in_box(line, low, high);
  if (!range || range->first == range->second)
    return std::nullopt;
  const auto& [begin, end] = *range;
  return Spline_patch<d>(Bspline_curve<Exact_kernel, d>(
      1, {begin, begin, end, end}, {line.origin + line.direction * begin, line.origin + line.direction * end}));
}

template <SplineKernel K, int number_of_parameters_, int dimension_>
struct Unbounded_operand
{
  using Kernel = K;
  static constexpr int number_of_parameters = number_of_parameters_, dimension = dimension_;
  static constexpr bool is_bounded = false;
};

template <SplineKernel K>
struct Intersection_operand<CGAL::Line_2<K>> : Unbounded_operand<K, 1, 2>
{
  static auto patch(const CGAL::Line_2<K>& line, const Vector_bounds<2>& box)
  {
    return line_patch<2>(exact_line(line), box);
  }
};

template <SplineKernel K>
struct Intersection_operand<CGAL::Line_3<K>> : Unbounded_operand<K, 1, 3>
{
  static auto patch(const CGAL::Line_3<K>& line, const Vector_bounds<3>& box)
  {
    return line_patch<3>(exact_line(line), box);
  }
};

template <SplineKernel K>
struct Intersection_operand<CGAL::Ray_2<K>> : Unbounded_operand<K, 1, 2>
{
  static auto patch(const CGAL::Ray_2<K>& ray, const Vector_bounds<2>& box)
  {
    return line_patch<2>(exact_ray(ray), box);
  }
};

template <SplineKernel K>
struct Intersection_operand<CGAL::Ray_3<K>> : Unbounded_operand<K, 1, 3>
{
  static auto patch(const CGAL::Ray_3<K>& ray, const Vector_bounds<3>& box)
  {
    return line_patch<3>(exact_ray(ray), box);
  }
};

template <SplineKernel K>
struct Intersection_operand<CGAL::Plane_3<K>> : Unbounded_operand<K, 2, 3>
{
  static std::optional<Spline_patch<3>> patch(const CGAL::Plane_3<K>& plane, const Vector_bounds<3>& box)
  {
    const auto number = [](const auto& x) { return converted_number<Exact_rational>(x); };
    const auto [low, high] = larger_box<3>(box);
    const CGAL::Plane_3<Exact_kernel> exact(number(plane.a()), number(plane.b()), number(plane.c()), number(plane.d()));
    return Spline_patch<3>(to_bspline_surface(exact, CGAL::Iso_cuboid_3<Exact_kernel>(low, high)));
  }
};

// Two of them in the same space and kernel, not both unbounded.
template <class A, class B>
concept Operand_pair = Intersection_operand<A>::dimension ==
        Intersection_operand<B>::dimension&&
            std::same_as<typename Intersection_operand<A>::Kernel, typename Intersection_operand<B>::Kernel> &&
    (Intersection_operand<A>::is_bounded || Intersection_operand<B>::is_bounded);

template <class A, class B>
concept Surface_operands = Operand_pair<A, B> && Intersection_operand<A>::number_of_parameters == 2 &&
    Intersection_operand<B>::number_of_parameters == 2;

// With few enough parameters for points to be isolated.
template <class A, class B>
concept Intersection_operands = Operand_pair<A, B> && Intersection_operand<A>::number_of_parameters +
        Intersection_operand<B>::number_of_parameters <=
    Intersection_operand<A>::dimension;

// Both as patches; none if an unbounded one is nowhere near the other one.
template <class A, class B>
std::optional<Patch_pair<Intersection_operand<A>::dimension>> patch_pair(const A& a, const B& b)
{
  using Pair = Patch_pair<Intersection_operand<A>::dimension>;
  if constexpr (!Intersection_operand<A>::is_bounded) {
    const auto second = Intersection_operand<B>::patch(b);
    const auto first = Intersection_operand<A>::patch(a, second.values());
    return first ? std::optional(Pair(*first, second)) : std::nullopt;
  } else if constexpr (!Intersection_operand<B>::is_bounded) {
    const auto first = Intersection_operand<A>::patch(a);
    const auto second = Intersection_operand<B>::patch(b, first.values());
    return second ? std::optional(Pair(first, *second)) : std::nullopt;
  } else
    return Pair(Intersection_operand<A>::patch(a), Intersection_operand<B>::patch(b));
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTERSECTION_OPERAND_H
