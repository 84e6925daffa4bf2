// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_TWO_WORDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_TWO_WORDS_H

#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <bit>
#include <cstdint>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Integers of two machine words.
__extension__ typedef __int128 Two_words;
__extension__ typedef unsigned __int128 Unsigned_two_words;

constexpr Unsigned_two_words magnitude(Two_words value)
{
  return value < 0 ? -static_cast<Unsigned_two_words>(value) : static_cast<Unsigned_two_words>(value);
}

constexpr int bit_length(Unsigned_two_words value)
{
  const std::uint64_t upper = static_cast<std::uint64_t>(value >> 64);
  return upper != 0 ? 64 + static_cast<int>(std::bit_width(upper))
                    : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

// Fills in the product unless it may be too long: it has at most as many bits as the factors together. (Not by the
// builtin function, for which clang needs a library of its own.)
constexpr bool multiply(Two_words a, Two_words b, Two_words& product)
{
  if (bit_length(magnitude(a)) + bit_length(magnitude(b)) > 127)
    return false;
  product = a * b;
  return true;
}

// With a relative error below 2^-52, whatever the rounding mode: the leading 64 bits are converted, which are all that
// they fill.
inline double approximate(Unsigned_two_words value)
{
  const int bits = bit_length(value), shift = bits > 64 ? bits - 64 : 0;
  return times_power_of_two(static_cast<double>(static_cast<std::uint64_t>(value >> shift)), shift);
}

inline double approximate(Two_words value)
{
  return value < 0 ? -approximate(magnitude(value)) : approximate(magnitude(value));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_TWO_WORDS_H
