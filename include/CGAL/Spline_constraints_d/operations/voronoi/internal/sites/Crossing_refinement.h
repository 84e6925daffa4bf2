// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CROSSING_REFINEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CROSSING_REFINEMENT_H

#include <CGAL/Spline_constraints_d/number/power_of_two.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The parameters in which two pieces of curves cross, by ranges that are proved to hold one crossing: made so narrow by
Newton's method, in exact numbers, that arcs which end there are known as well as others in all precisions, also if they
are short.

With homogeneous coordinates, X_a w_b = X_b w_a. As there is a crossing, it is within the image of Newton's operator, m
- C F(m) + (I - C J) (x - m), for the Jacobians J of the ranges.
*/
class Crossing_refinement
{
  using Ranges = std::array<Parameter_range, 2>;
  using Values = std::array<Rational_interval, 3>;   // of homogeneous coordinates

  static constexpr int relative_width = -120;   // as a power of 2, of the distance from the ends of the pieces
  static constexpr int most_steps = 8;

  const Homogeneous_piece &m_first, &m_second;

public:
  Crossing_refinement(const Homogeneous_piece& first, const Homogeneous_piece& second)
    : m_first(first), m_second(second)
  {}

  // \pre the ranges are inside of those of the pieces
  Ranges operator()(Ranges ranges) const
  {
    for (int step = 0; step < most_steps && !(is_narrow(m_first, ranges[0]) && is_narrow(m_second, ranges[1]));
         ++step) {
      const std::optional<Ranges> narrower = narrowed(ranges);
      if (!narrower)
        break;
      ranges = *narrower;
    }
    return ranges;
  }

private:
  static Exact_rational width(const Parameter_range& range) { return Exact_rational(range.second - range.first); }

  static Exact_rational most_width(const Homogeneous_piece& piece, const Parameter_range& range)
  {
    return power_of_two(relative_width) *
        (std::min)(Exact_rational(range.first - piece.domain.first),
                   Exact_rational(piece.domain.second - range.second));
  }

  static bool is_narrow(const Homogeneous_piece& piece, const Parameter_range& range)
  {
    return width(range) <= most_width(piece, range);
  }

  // By one step, if a range becomes half as long, or shorter.
  std::optional<Ranges> narrowed(const Ranges& ranges) const
  {
    const Homogeneous_piece a = m_first.within(ranges[0]), b = m_second.within(ranges[1]);
    const std::array<Exact_rational, 1> middle{Exact_rational(1) / 2};
    const auto values = [&](const Homogeneous_piece& piece, bool is_slope, bool is_in_middle) {
      Values result;
      for (std::size_t k = 0; k < 3; ++k) {
        const Bernstein_tensor<Exact_rational> f = is_slope ? piece.coordinates[k].derivative(0) : piece.coordinates[k];
        result[k] = is_in_middle ? Rational_interval(f(middle)) : Rational_interval(f.bounds());
      }
      return result;
    };
    const auto differences = [](const Values& x, const Values& y) {
      return Vector_bounds<2>{x[0] * y[2] - y[0] * x[2], x[1] * y[2] - y[1] * x[2]};
    };
    const auto jacobian = [&](bool is_in_middle) {
      // by columns
      return std::array{differences(values(a, true, is_in_middle), values(b, false, is_in_middle)),
                        differences(values(a, false, is_in_middle), values(b, true, is_in_middle))};
    };
    const Vector_bounds<2> f = differences(values(a, false, true), values(b, false, true));
    const auto at_middle = jacobian(true), over_ranges = jacobian(false);
    const auto cross = [](const Vector_bounds<2>& x, const Vector_bounds<2>& y) { return x[0] * y[1] - x[1] * y[0]; };
    const Exact_rational determinant = cross(at_middle[0], at_middle[1]).lower;
    if (determinant == 0)
      return std::nullopt;
    const Rational_interval inverse(Exact_rational(1 / determinant)),
        from_middle(Exact_rational(-middle[0]), middle[0]);
    const auto solved = [&](const Vector_bounds<2>& v) {
      return Vector_bounds<2>{inverse * cross(v, at_middle[1]), inverse * cross(at_middle[0], v)};
    };
    const Vector_bounds<2> step = solved(f), first = solved(over_ranges[0]), second = solved(over_ranges[1]),
                           unit{Rational_interval(Exact_rational(1)), Rational_interval(Exact_rational(0))};
    Ranges result;
    for (std::size_t j = 0; j < 2; ++j) {
      const Rational_interval image = Rational_interval(middle[0]) - step[j] + (unit[j] - first[j]) * from_middle +
          (unit[1 - j] - second[j]) * from_middle;
      result[j] = part_of(j == 0 ? m_first : m_second, ranges[j], image);
    }
    const auto is_half = [&](std::size_t j) { return 2 * width(result[j]) <= width(ranges[j]); };
    return is_half(0) || is_half(1) ? std::optional(result) : std::nullopt;
  }

  // That between two numbers of [0,1], rounded outwards to numbers that are no longer than need be.
  static Parameter_range part_of(const Homogeneous_piece& piece, const Parameter_range& range,
                                 const Rational_interval& part)
  {
    constexpr int digits = 4;   // of the width
    const auto at = [&](const Exact_rational& t) { return Exact_rational(range.first + t * width(range)); };
    const Exact_rational begin = at(part.lower), end = at(part.upper);
    const double most = CGAL::to_double(most_width(piece, range)), least = 0x1p-900;
    const Exact_rational unit = power_of_two(
                             std::ilogb((std::max)({CGAL::to_double(Exact_rational(end - begin)), most, least})) -
                             digits),
                         lower(floor_of(Exact_rational(begin / unit)) * unit),
                         upper(floor_of(Exact_rational(end / unit)) * unit + unit);
    return {(std::max)(range.first, lower), (std::min)(range.second, upper)};
  }

  static Exact_rational floor_of(const Exact_rational& x)
  {
    const Big_integer quotient = numerator_of(x) / denominator_of(x);   // toward zero
    const Exact_rational result = scaled_rational(quotient, 0);
    return result > x ? Exact_rational(result - 1) : result;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CROSSING_REFINEMENT_H
