// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_CONCEPTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_CONCEPTS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/tags.h>

#include <concepts>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <typename NT>
concept Has_ring_operators = std::semiregular<NT> && requires(NT a, const NT b, const NT c) {
  { b + c } -> std::convertible_to<NT>;
  { b - c } -> std::convertible_to<NT>;
  { b * c } -> std::convertible_to<NT>;
  { -b } -> std::convertible_to<NT>;
  { a += b } -> std::convertible_to<NT>;
  { a -= b } -> std::convertible_to<NT>;
  { a *= b } -> std::convertible_to<NT>;
};

// The tag a type has in CGAL, `Null_tag` if it is none of CGAL's.
template <typename NT>
using Algebraic_category_of = typename CGAL::Algebraic_structure_traits<NT>::Algebraic_category;

// A `/` alone does not make a field: that of `int` cuts off. So a type that CGAL knows has to be a field to CGAL too.
template <typename NT>
concept Has_field_division =
  requires(const NT b, const NT c) { { b / c } -> std::convertible_to<NT>; } &&
  (std::same_as<Algebraic_category_of<NT>, CGAL::Null_tag> ||
   std::derived_from<Algebraic_category_of<NT>, CGAL::Field_tag>) &&
  !std::integral<NT>;

template <typename NT>
concept Has_number_traits_types = requires {
  typename Number_traits<NT>::Coordinate;
  typename Number_traits<NT>::Rounding_guard;
  requires std::semiregular<typename Number_traits<NT>::Coordinate>;
  requires std::default_initializable<typename Number_traits<NT>::Rounding_guard>;
};

template <typename NT>
concept Has_number_traits_constants = requires {
  typename std::bool_constant<Number_traits<NT>::is_exact>;
  typename std::bool_constant<Number_traits<NT>::is_enclosure>;
  requires !(Number_traits<NT>::is_exact && Number_traits<NT>::is_enclosure);
  { Number_traits<NT>::name } -> std::convertible_to<std::string_view>;
  requires Number_traits<NT>::unit_roundoff >= 0;
};

template <typename NT>
concept Has_number_traits_functions = requires(NT a, const NT b, double d, const Exact_rational q) {
  { Number_traits<NT>::from_double(d) } -> std::convertible_to<NT>;
  { Number_traits<NT>::from_rational(q) } -> std::convertible_to<NT>;
  { Number_traits<NT>::enclosure(b) } -> std::convertible_to<CGAL::Interval_nt<false>>;
  { Number_traits<NT>::sign(b) } -> std::convertible_to<CGAL::Uncertain<CGAL::Sign>>;
  { Number_traits<NT>::scale_by_power_of_two(a, 1) };
  { Number_traits<NT>::half_sum(b, b) } -> std::convertible_to<NT>;
};

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDNumbers

The language concept that stands for the documented concept `SplineNumberType`. Where a template is *used* with a type
that is not one, call
`assert_spline_number_type()`: it says what is missing in one sentence.
*/
template <typename NT>
concept SplineNumberType =
  internal::Has_ring_operators<NT> && internal::Has_field_division<NT> && internal::Has_number_traits_types<NT> &&
  internal::Has_number_traits_constants<NT> && internal::Has_number_traits_functions<NT>;

/*!
\ingroup PkgSplineConstraintsDNumbers

stops the compilation with a message that names the first thing `NT` lacks to be a `SplineNumberType`; returns `true`
otherwise, so that
it can stand in a `static_assert` at class scope.
*/
template <typename NT>
consteval bool assert_spline_number_type()
{
  // One message, not one per requirement: what comes after the first would only follow from it.
  if constexpr (!internal::Has_ring_operators<NT>) {
    static_assert(internal::Has_ring_operators<NT>,
                  "this type is not a SplineNumberType: it must be default constructible and copyable and have the "
                  "operators + - * (binary), - (unary), +=, -= and *=");
  } else if constexpr (!internal::Has_field_division<NT>) {
    static_assert(internal::Has_field_division<NT>,
                  "this type is not a SplineNumberType: division / Field_tag is missing. int and CGAL::Mpzf are rings, "
                  "not fields; use CGAL::Exact_rational for exact computations, or double, CGAL::Interval_nt<false>, "
                  "Mpfr_interval");
  } else if constexpr (!internal::Has_number_traits_types<NT>) {
    static_assert(internal::Has_number_traits_types<NT>,
                  "this type is not a SplineNumberType: there is no specialisation of "
                  "CGAL::Spline_constraints::Number_traits for it with the types Coordinate and Rounding_guard (float "
                  "and CGAL::Interval_nt<true> have none on purpose: use double and CGAL::Interval_nt<false>)");
  } else if constexpr (!internal::Has_number_traits_constants<NT>) {
    static_assert(internal::Has_number_traits_constants<NT>,
                  "this type is not a SplineNumberType: its Number_traits lacks one of the constants is_exact, "
                  "is_enclosure (not both true), name, unit_roundoff (not negative)");
  } else {
    static_assert(internal::Has_number_traits_functions<NT>,
                  "this type is not a SplineNumberType: its Number_traits lacks one of the functions from_double, "
                  "from_rational, enclosure, sign, scale_by_power_of_two, half_sum");
  }
  return true;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_CONCEPTS_H
