// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_KERNEL_NUMBERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_KERNEL_NUMBERS_H

#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Fraction_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/tags.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Lazy numbers over Exact_rational.
template <class FT>
concept Lazy_rational = std::constructible_from<FT, Exact_rational> && requires(const FT& x)
{
  {
    x.exact()
    } -> std::convertible_to<Exact_rational>;
};

// Fractions of integers, whatever their type. (Lazy numbers are fractions too, of lazy integers.)
template <class FT>
concept Integer_fraction = !Lazy_rational<FT> && CGAL::Fraction_traits<FT>::Is_fraction::value &&
    std::derived_from<typename CGAL::Algebraic_structure_traits<
                          typename CGAL::Fraction_traits<FT>::Numerator_type>::Algebraic_category,
                      CGAL::Euclidean_ring_tag>;

// Rational coordinates that say which numbers they are. Integers are none: results of divisions have to be rational
// again.
template <class FT>
concept Rational_coordinate =
    std::is_floating_point_v<FT> || std::same_as<FT, Exact_rational> || Lazy_rational<FT> || Integer_fraction<FT>;

template <class Integer>
Integer integer_of_type(const Big_integer& value)
{
  constexpr int bits = 30;
  const bool is_negative = value < 0;
  Integer result(0), weight(1);
  for (Big_integer rest = abs(value); rest != 0; rest >>= bits) {
    const Big_integer digit = rest & ((1 << bits) - 1);
    result += weight * Integer(digit.convert_to<int>());
    weight *= Integer(1 << bits);
  }
  return is_negative ? Integer(-result) : result;
}

template <Integer_fraction Fraction>
Fraction fraction_of_type(const Exact_rational& x)
{
  using Traits = CGAL::Fraction_traits<Fraction>;
  return typename Traits::Compose()(integer_of_type<typename Traits::Numerator_type>(numerator_of(x)),
                                    integer_of_type<typename Traits::Denominator_type>(denominator_of(x)));
}

template <class FT>
using Spline_number = std::conditional_t<std::is_floating_point_v<FT>, double, Exact_rational>;

// From one of double, Exact_rational and the number type of a kernel to another of them. From exact to floating point:
// to the nearest double.
template <class Target, class Source>
Target converted_number(const Source& x)
{
  if constexpr (std::same_as<Source, Target>)
    return x;
  else if constexpr (std::is_floating_point_v<Source> && std::is_floating_point_v<Target>)
    return static_cast<Target>(x);
  else if constexpr (std::is_floating_point_v<Target>)
    return static_cast<Target>(to_nearest_double(converted_number<Exact_rational>(x)));
  else if constexpr (Lazy_rational<Target>)
    return Target(converted_number<Exact_rational>(x));
  else if constexpr (!std::same_as<Target, Exact_rational>)
    return fraction_of_type<Target>(converted_number<Exact_rational>(x));
  else if constexpr (std::is_floating_point_v<Source>)
    return to_rational(static_cast<double>(x));
  else if constexpr (Lazy_rational<Source>)
    return Exact_rational(x.exact());
  else if constexpr (Integer_fraction<Source>)
    return Exact_rational(scaled_rational(numerator_of_rational(x), 0) /
                          scaled_rational(denominator_of_rational(x), 0));
  else   // an expression that has not been evaluated yet
    return Exact_rational(x);
}

// The points, vectors and maps of a kernel in d dimensions.
template <class Kernel, int d>
struct Ambient_space;

template <class Kernel>
struct Ambient_space<Kernel, 2>
{
  using Point = typename Kernel::Point_2;
  using Vector = typename Kernel::Vector_2;
  using Aff_transformation = typename Kernel::Aff_transformation_2;
  using Bbox = CGAL::Bbox_2;

  template <class Object>
  static Object object(const std::array<typename Kernel::FT, 2>& x) { return Object(x[0], x[1]); }
};

template <class Kernel>
struct Ambient_space<Kernel, 3>
{
  using Point = typename Kernel::Point_3;
  using Vector = typename Kernel::Vector_3;
  using Aff_transformation = typename Kernel::Aff_transformation_3;
  using Bbox = CGAL::Bbox_3;

  template <class Object>
  static Object object(const std::array<typename Kernel::FT, 3>& x) { return Object(x[0], x[1], x[2]); }
};

// A point or vector of a kernel from coordinates of another number type.
template <class Kernel, class Object, std::size_t d, class NT>
Object kernel_object(const std::array<NT, d>& coordinates)
{
  std::array<typename Kernel::FT, d> x;
  for (std::size_t i = 0; i < d; ++i)
    x[i] = converted_number<typename Kernel::FT>(coordinates[i]);
  return Ambient_space<Kernel, static_cast<int>(d)>::template object<Object>(x);
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link SplineKernel `SplineKernel`\endlink: a kernel of CGAL whose
coordinates are rational numbers, be they stored as floating point numbers, as exact rationals, or lazily.
*/
template <class Kernel>
concept SplineKernel = internal::Rational_coordinate<typename Kernel::FT> && requires {
  typename Kernel::Point_2;
  typename Kernel::Vector_2;
  typename Kernel::Aff_transformation_2;
  typename Kernel::Point_3;
  typename Kernel::Vector_3;
  typename Kernel::Aff_transformation_3;
};

namespace internal {

//! the kernel that constructions are made in before their result is converted to the kernel asked for.
using Exact_kernel = CGAL::Simple_cartesian<Exact_rational>;

// Points and vectors as those of the exact kernel. Throws Invalid_input for coordinates that are not finite.
template <class Kernel>
Exact_kernel::Point_2 exact_object(const CGAL::Point_2<Kernel>& p)
{
  return {converted_number<Exact_rational>(p.x()), converted_number<Exact_rational>(p.y())};
}

template <class Kernel>
Exact_kernel::Vector_2 exact_object(const CGAL::Vector_2<Kernel>& v)
{
  return {converted_number<Exact_rational>(v.x()), converted_number<Exact_rational>(v.y())};
}

template <class Kernel>
Exact_kernel::Point_3 exact_object(const CGAL::Point_3<Kernel>& p)
{
  return {converted_number<Exact_rational>(p.x()), converted_number<Exact_rational>(p.y()),
          converted_number<Exact_rational>(p.z())};
}

template <class Kernel>
Exact_kernel::Vector_3 exact_object(const CGAL::Vector_3<Kernel>& v)
{
  return {converted_number<Exact_rational>(v.x()), converted_number<Exact_rational>(v.y()),
          converted_number<Exact_rational>(v.z())};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_KERNEL_NUMBERS_H
