// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPQ_ACCESS_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPQ_ACCESS_H

#include <gmp.h>

#include <concepts>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Which type `Exact_rational` is depends on the build flags, so nothing may name it. What can be asked is whether a
// rational shows the GMP
// number it is made of: then GMP and MPFR do in one call what the interface of `Fraction_traits` does in a loop.

template <typename Rational>
concept Mpq_class_like = requires(const Rational& x) { { x.get_mpq_t() } -> std::convertible_to<mpq_srcptr>; };

template <typename Rational>
concept Gmpq_like = requires(const Rational& x) { { x.mpq() } -> std::convertible_to<mpq_srcptr>; };

template <typename Rational>
concept Boost_mpq_like = requires(const Rational& x) { { x.backend().data() } -> std::convertible_to<mpq_srcptr>; };

// Rationals that show their GMP number.
template <typename Rational>
concept Readable_as_mpq = Mpq_class_like<Rational> || Gmpq_like<Rational> || Boost_mpq_like<Rational>;

// Rationals whose GMP number may be written through. Not so for reference-counted ones: their copies would change
// along.
template <typename Rational>
concept Writable_as_mpq = Mpq_class_like<Rational> || Boost_mpq_like<Rational>;

template <Readable_as_mpq Rational>
mpq_srcptr mpq_of(const Rational& x)
{
  if constexpr (Mpq_class_like<Rational>)
    return x.get_mpq_t();
  else if constexpr (Gmpq_like<Rational>)
    return x.mpq();
  else
    return x.backend().data();
}

template <Writable_as_mpq Rational>
mpq_ptr writable_mpq_of(Rational& x)
{
  if constexpr (Mpq_class_like<Rational>)
    return x.get_mpq_t();
  else
    return x.backend().data();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_MPQ_ACCESS_H
