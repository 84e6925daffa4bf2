// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_RATIONAL_FRAME_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_RATIONAL_FRAME_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

// What is measured on rounded data is in this kernel; nothing that is proved is.
using Rounded_kernel = CGAL::Simple_cartesian<double>;
using Rounded_point = Rounded_kernel::Point_3;
using Rounded_vector = Rounded_kernel::Vector_3;
using Exact_axes = std::array<Exact_kernel::Vector_3, 3>;   // of length one, at right angles, right-handed

inline Rounded_vector normalised(const Rounded_vector& v) { return v / std::sqrt(v.squared_length()); }

inline Exact_rational simplest_near(double x, double distance)
{
  return simplest_rational_between(Exact_rational(to_rational(x) - to_rational(distance)),
                                   Exact_rational(to_rational(x) + to_rational(distance)));
}

// The length of a rational number when it is written down: 0 for 0, 1 for 1.
inline double bits_of(const Exact_rational& x)
{
  return static_cast<double>(bit_length(numerator_of(x)) + bit_length(denominator_of(x)) - 1);
}

template <std::size_t n>
double bits_of(const std::array<Exact_rational, n>& numbers)
{
  double result = 0;
  for (const Exact_rational& x : numbers)
    result += bits_of(x);
  return result;
}

// A vector (cos, sin) of half an angle up to its length, the longer coordinate 1 or -1.
inline std::array<Exact_rational, 2> simple_half_direction(double half_angle, double distance)
{
  const double c = std::cos(half_angle), s = std::sin(half_angle);
  if (std::abs(c) >= std::abs(s)) {
    const Exact_rational t = simplest_near(s / std::abs(c), distance);
    return {Exact_rational(c < 0 ? -1 : 1), t};
  }
  const Exact_rational t = simplest_near(c / std::abs(s), distance);
  return {t, Exact_rational(s < 0 ? -1 : 1)};
}

// A direction whose coordinates are rational at length one: by its stereographic projection, from the pole that is
// farther away.
class Simple_direction
{
  std::array<Exact_rational, 2> m_projection;
  bool m_is_below;

public:
  // \pre n has length one, up to rounding.
  Simple_direction(const Rounded_vector& n, double distance) : m_is_below(n.z() < 0)
  {
    const Rounded_vector above = m_is_below ? -n : n;
    m_projection = {simplest_near(above.x() / (1 + above.z()), distance),
                    simplest_near(above.y() / (1 + above.z()), distance)};
  }

  const std::array<Exact_rational, 2>& projection() const { return m_projection; }
  double bits() const { return bits_of(m_projection); }

  // Axes of which the last one has the direction.
  Exact_axes axes() const
  {
    const auto& [a, b] = m_projection;
    const Exact_rational f = 2 / Exact_rational(1 + a * a + b * b), none(0);
    const Exact_kernel::Vector_3 p(a, b, Exact_rational(1)), x(Exact_rational(1), none, none),
        y(none, Exact_rational(1), none), z(none, none, Exact_rational(1));
    // the least rotation from the direction of z
    const Exact_kernel::Vector_3 first = x - p * Exact_rational(f * a), second = y - p * Exact_rational(f * b),
                                 last = p * f - z;
    return m_is_below ? Exact_axes{first, -second, -last} : Exact_axes{first, second, last};
  }
};

// The axes turned about the last one by an angle, given as twice that of a vector.
inline Exact_axes turned(const Exact_axes& axes, const std::array<Exact_rational, 2>& half)
{
  const auto& [sigma, tau] = half;
  const Exact_rational square = sigma * sigma + tau * tau, cosine = Exact_rational(sigma * sigma - tau * tau) / square,
                       sine = Exact_rational(2 * sigma * tau) / square;
  return {axes[0] * cosine + axes[1] * sine, axes[1] * cosine - axes[0] * sine, axes[2]};
}

// A system of coordinates with rational axes at right angles, and what it is in doubles.
class Rational_frame
{
  Exact_axes m_axes;
  Exact_kernel::Point_3 m_origin;
  std::array<Rounded_vector, 3> m_rounded_axes;
  Rounded_point m_rounded_origin;

public:
  Rational_frame(Exact_axes axes, Exact_kernel::Point_3 origin) : m_axes(std::move(axes)), m_origin(std::move(origin))
  {
    for (int i = 0; i < 3; ++i)
      m_rounded_axes[i] = Rounded_vector(to_nearest_double(m_axes[i].x()), to_nearest_double(m_axes[i].y()),
                                         to_nearest_double(m_axes[i].z()));
    m_rounded_origin = Rounded_point(to_nearest_double(m_origin.x()), to_nearest_double(m_origin.y()),
                                     to_nearest_double(m_origin.z()));
  }

  static Rational_frame identity()
  {
    const Exact_rational none(0), one(1);
    using Vector = Exact_kernel::Vector_3;
    return Rational_frame({Vector(one, none, none), Vector(none, one, none), Vector(none, none, one)},
                          Exact_kernel::Point_3(none, none, none));
  }

  const Exact_axes& axes() const { return m_axes; }
  const Exact_kernel::Point_3& origin() const { return m_origin; }
  const Rounded_point& rounded_origin() const { return m_rounded_origin; }

  Rounded_vector coordinates(const Rounded_vector& v) const
  {
    return {v * m_rounded_axes[0], v * m_rounded_axes[1], v * m_rounded_axes[2]};
  }
  Rounded_vector coordinates(const Rounded_point& p) const { return coordinates(p - m_rounded_origin); }

  Exact_kernel::Vector_3 vector(const std::array<Exact_rational, 3>& x) const
  {
    return m_axes[0] * x[0] + m_axes[1] * x[1] + m_axes[2] * x[2];
  }
  Exact_kernel::Vector_3 vector(const Exact_kernel::Vector_3& v) const
  {
    return vector(std::array<Exact_rational, 3>{v.x(), v.y(), v.z()});
  }
  Exact_kernel::Point_3 point(const std::array<Exact_rational, 3>& x) const { return m_origin + vector(x); }
};

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_RATIONAL_FRAME_H
