// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_ELLIPTICAL_ARC_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_ELLIPTICAL_ARC_H

#include <CGAL/Spline_constraints_d/IO/internal/Bezier_path.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <cmath>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A rational point of the unit circle in the direction of an angle: exactly for multiples of 90 degrees, else with the
// tangent of half the angle rounded to double.
inline Exact_kernel::Vector_2 unit_vector_of_degrees(const Exact_rational& degrees)
{
  const Big_integer rounds = numerator_of(degrees) / (denominator_of(degrees) * 360);
  const Exact_rational angle = Exact_rational(degrees - 360 * scaled_rational(rounds, 0));
  for (int quarter = -3; quarter <= 3; ++quarter)
    if (angle == 90 * quarter) {
      static constexpr int cosine[] = {1, 0, -1, 0};
      return {Exact_rational(cosine[(quarter + 4) % 4]), Exact_rational(cosine[(quarter + 7) % 4])};
    }
  const Exact_rational t = to_rational(std::tan(to_nearest_double(angle) * (3.14159265358979323846 / 360)));
  const Exact_rational squared_length = Exact_rational(1 + t * t);
  return {Exact_rational((1 - t * t) / squared_length), Exact_rational(2 * t / squared_length)};
}

// The square root of a rational number that is not negative: exactly if it is rational, else with a relative error
// below 2^-94.
inline Exact_rational near_square_root(const Exact_rational& x)
{
  if (const std::optional<Exact_rational> root = rational_square_root(x))
    return *root;
  const Big_integer denominator = denominator_of(x);
  Big_integer square = numerator_of(x) * denominator;
  shift_left(square, 192);
  const Big_integer root = sqrt(square);
  return Exact_rational(scaled_rational(root, -96) / scaled_rational(denominator, 0));
}

// The plane with the scalar product that makes an ellipse with half axes along `axis` and across it the unit circle.
struct Ellipse_metric
{
  using Vector = Exact_kernel::Vector_2;
  Vector axis;   // of length 1
  Exact_rational radius, other_radius;

  Exact_rational along(const Vector& a) const { return Exact_rational(a.x() * axis.x() + a.y() * axis.y()); }
  Exact_rational across(const Vector& a) const { return Exact_rational(a.y() * axis.x() - a.x() * axis.y()); }

  Exact_rational product(const Vector& a, const Vector& b) const
  {
    return Exact_rational(along(a) * along(b) / (radius * radius) +
                          across(a) * across(b) / (other_radius * other_radius));
  }

  // Turned by a right angle, from the first axis to the second.
  Vector turned(const Vector& a) const
  {
    const Exact_rational u = Exact_rational(-across(a) * radius / other_radius),
                         v = Exact_rational(along(a) * other_radius / radius);
    return {Exact_rational(u * axis.x() - v * axis.y()), Exact_rational(u * axis.y() + v * axis.x())};
  }
};

// The arc around a center that has the same distance from both points.
inline Bezier_path::Curve arc_around(const Ellipse_metric& metric, const Bezier_path::Point& center,
                                     const Bezier_path::Point& source, const Bezier_path::Point& target,
                                     bool is_positive)
{
  using Vector = Exact_kernel::Vector_2;
  const Vector s = source - center, t = target - center;
  const Vector side = is_positive ? metric.turned(s) : Vector(-metric.turned(s));
  const Exact_rational square = metric.product(s, s);
  const Exact_rational end = turn_parameter(Exact_rational(1 + metric.product(s, t) / square),
                                            Exact_rational(metric.product(side, t) / square));
  return ellipse<2>(center, s, side).restricted(Exact_rational(0), end);
}

/*
The next piece of a path is an arc of an ellipse as SVG describes it: by the target, the half axes and which of the four
arcs it is. Half axes that are too short are scaled.

With the half chord as unit, the center has the distance s = cot(a) from the chord, where a is half the angle of the
arc. If s is rational, the arc is exact. Its two ends may have different weights then, in a ratio of at most two; arcs
are made from either end in turn, so that weights of long paths neither grow nor vanish. If s is irrational, tan(a/4) is
rounded to a rational number. Then the two halves of the arc are conics in standard form, with rational weights, and on
one ellipse.
*/
inline void add_elliptical_arc(Bezier_path& path, const Ellipse_metric& metric, bool is_large, bool is_positive,
                               const Bezier_path::Point& target)
{
  using Vector = Exact_kernel::Vector_2;
  const Bezier_path::Point source = path.target();
  const Bezier_path::Point middle = CGAL::midpoint(source, target);
  const Vector half_chord = target - middle;
  const Vector left = is_positive ? metric.turned(half_chord) : Vector(-metric.turned(half_chord));
  const Exact_rational square = metric.product(half_chord, half_chord);   // sin(a)^2
  if (square == 0)
    return;
  const Exact_rational squared_distance = square >= 1 ? Exact_rational(0) : Exact_rational(1 / square - 1);
  if (const std::optional<Exact_rational> distance = rational_square_root(squared_distance)) {
    const Bezier_path::Point center = middle + left * (is_large ? Exact_rational(-*distance) : *distance);
    path.add(path.weight() > 1 ? arc_around(metric, center, target, source, !is_positive).reversed()
                               : arc_around(metric, center, source, target, is_positive));
    return;
  }
  const Exact_rational sine = near_square_root(square), cosine = near_square_root(Exact_rational(1 - square));
  // tan(a/2)
  const Exact_rational half = is_large ? Exact_rational((1 + cosine) / sine) : Exact_rational(sine / (1 + cosine));
  // tan(a/4)
  const Exact_rational quarter =
      round_to_dyadic(Exact_rational(half / (1 + near_square_root(Exact_rational(1 + half * half)))), 96);
  if (quarter >= 1)
    throw Invalid_input("an arc with its ends too close to each other");
  const Exact_rational squared_quarter = Exact_rational(quarter * quarter);
  // tan(a/2) for the rounded angle
  const Exact_rational height = Exact_rational(2 * quarter / (1 - squared_quarter));
  const Exact_rational weight = Exact_rational((1 - squared_quarter) / (1 + squared_quarter)),
                       reach = Exact_rational((1 + height * height) / 2);
  const Bezier_path::Point top = middle - left * height;
  path.add({top - half_chord * reach, top}, {Exact_rational(1), weight, Exact_rational(1)});
  path.add({top + half_chord * reach, target}, {Exact_rational(1), weight, Exact_rational(1)});
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_INTERNAL_ELLIPTICAL_ARC_H
