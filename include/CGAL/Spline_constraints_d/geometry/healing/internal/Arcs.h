// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_ARCS_H

#include <CGAL/Spline_constraints_d/geometry/healing/internal/Rational_frame.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

/*
How a rational quadratic spline runs along a circle: the point at an angle is where a vector (sigma, tau) of half the
angle runs along straight lines between the breaks, so that its angles and lengths there say all, the lengths up to a
factor.
*/
struct Arcs
{
  // Up to the root of two: between the weights 1, cos, 1 of a quarter of a circle, and the weights 1, 1, 2.
  static constexpr double most_change = 1.4143;

  std::vector<double> half_angles;
  std::vector<double> lengths;

  double turn() const { return 2 * (half_angles.back() - half_angles.front()); }

  /*
  From the angle of a point at each parameter, up to whole turns; none where pieces do not run as a quadratic could.
  Whether they do, what is made of the result tells.
  */
  template <class Angle>
  static std::optional<Arcs> measured(const std::vector<double>& breaks, const Angle& angle)
  {
    constexpr int steps = 8;   // no piece turns by more than once around: by less than a half between samples
    double last = angle(breaks[0]);
    Arcs result{{last / 2}, {1}};
    for (std::size_t c = 0; c + 1 < breaks.size(); ++c) {
      std::array<double, steps + 1> half;
      half[0] = last / 2;
      for (int i = 1; i <= steps; ++i) {
        const double u = i == steps ? breaks[c + 1] : breaks[c] + (breaks[c + 1] - breaks[c]) * i / steps;
        last += std::remainder(angle(u) - last, 2 * CGAL_PI);
        half[i] = last / 2;
      }
      // In the middle it is the sum of the two vectors.
      const double ratio = std::sin(half[steps / 2] - half[0]) / std::sin(half[steps] - half[steps / 2]);
      if (!(ratio > 0 && std::isfinite(ratio) && std::abs(half[steps] - half[0]) < CGAL_PI))
        return std::nullopt;
      result.half_angles.push_back(half[steps]);
      result.lengths.push_back(result.lengths.back() * ratio);
    }
    return result;
  }

  /*
  From the angle zero on, with simple rational numbers in the place of those that were measured, for an error of angles.
  Lengths that are as
  near as that keep the parameters; those that are not make numbers short: the same arcs between the same breaks, with
  a change of the parameter within each piece that is a projective map.
  */
  Direction_path path(const std::vector<Exact_rational>& breaks, double distance, bool has_kept_parameters) const
  {
    std::vector<std::array<Exact_rational, 2>> vectors;
    for (std::size_t c = 0; c < breaks.size(); ++c) {
      const auto vector = simple_half_direction(half_angles[c] - half_angles[0], distance);
      const double x = to_nearest_double(vector[0]), y = to_nearest_double(vector[1]),
                   factor = lengths[c] / std::sqrt(x * x + y * y);
      const Exact_rational simple = has_kept_parameters
          ? simplest_near(factor, distance * factor)
          : simplest_rational_between(to_rational(factor / most_change), to_rational(factor * most_change));
      vectors.push_back({Exact_rational(vector[0] * simple), Exact_rational(vector[1] * simple)});
    }
    const auto spline = [&](int i, int j) {
      std::vector<Exact_rational> knots(1, breaks.front()),
          coefficients(1, Exact_rational(vectors[0][i] * vectors[0][j]));
      for (const Exact_rational& t : breaks)
        knots.insert(knots.end(), 2, t);
      knots.push_back(breaks.back());
      for (std::size_t c = 0; c + 1 < vectors.size(); ++c) {
        const auto &a = vectors[c], &b = vectors[c + 1];
        coefficients.emplace_back(Exact_rational(a[i] * b[j] + b[i] * a[j]) / 2);
        coefficients.emplace_back(b[i] * b[j]);
      }
      return Scalar_function(Exact_function({2}, {std::move(knots)}, std::move(coefficients)));
    };
    return {spline(0, 0), spline(0, 1), spline(1, 1)};
  }
};

// A circle in the plane in homogeneous coordinates, from a path: cos and sin of its angle times the weight, and that.
struct Circle_functions
{
  Scalar_function cosine, sine, weight;

  explicit Circle_functions(const Direction_path& path)
    : cosine(path.squared_sigma - path.squared_tau), sine(path.sigma_tau * Exact_rational(2)),
      weight(path.squared_sigma + path.squared_tau)
  {}
};

struct Measured_circle
{
  Rounded_point center;
  Rounded_vector normal;   // of length one
  double radius;
};

// The circle through three points; none where they are nearly on a line.
inline std::optional<Measured_circle> circle_through(const Rounded_point& p, const Rounded_point& q,
                                                     const Rounded_point& r)
{
  const Rounded_vector u = q - p, v = r - p, n = CGAL::cross_product(u, v);
  const double uu = u.squared_length(), vv = v.squared_length(), nn = n.squared_length();
  if (!(nn > 1e-14 * uu * vv))
    return std::nullopt;
  const Rounded_vector to_center = CGAL::cross_product(v * uu - u * vv, n) / (2 * nn);
  return Measured_circle{p + to_center, normalised(n), std::sqrt(to_center.squared_length())};
}

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_ARCS_H
